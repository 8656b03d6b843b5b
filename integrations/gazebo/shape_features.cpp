// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See shape_features.h.
#include "integrations/gazebo/shape_features.h"

#include <algorithm>

#include "integrations/gazebo/convert.h"
#include "integrations/gazebo/links.h"
#include "integrations/gazebo/mesh_files.h"
#include "integrations/gazebo/shapes.h"

namespace epode::gazebo {

Identity Shapes::cast(const Identity& shape, ShapeKind kind) const
{
    const Shape* const found = get<Shape>(shape);
    return identity_of(found && found->kind == kind ? found : nullptr);
}

// Null, with a message, of a shape of another kind.
const Shape* Shapes::shape(const Identity& shape, ShapeKind kind) const
{
    const Shape* const found = get<Shape>(shape);
    if (!found || found->kind == kind) return found;
    EPODE_GAZEBO_ERROR << "collision '" << found->name << "' has another kind of shape\n";
    return nullptr;
}

Vec Shapes::size_of(const Identity& identity, ShapeKind kind) const
{
    const Shape* const found = shape(identity, kind);
    return found ? found->size : Vec{};
}

void Shapes::resize_to(const Identity& identity, ShapeKind kind, int which, double value)
{
    if (!shape(identity, kind)) return;
    Shape* const found = get<Shape>(identity);
    Vec size = found->size;
    size[which] = value;
    resize(*found, size);
}

Identity Shapes::attach_solid(const Identity& link, const std::string& name, ShapeKind kind, Vec size,
                              const Pose3& pose)
{
    Link* const found = get<Link>(link);
    const auto made = found ? new_shape(*found, name, kind, pose_of(pose)) : nullptr;
    if (!made) return GenerateInvalidId();
    made->size = size;
    return keep(made, make_geoms(*made));
}

Shapes::Pose3 Shapes::GetShapeRelativeTransform(const Identity& shape) const
{
    const Shape* const found = get<Shape>(shape);
    return found ? eigen_of(found->pose) : Pose3::Identity();
}

void Shapes::SetShapeRelativeTransform(const Identity& shape, const Pose3& pose)
{
    Shape* const found = get<Shape>(shape);
    if (!found || !pose.matrix().allFinite()) return;
    found->pose = pose_of(pose);
    put_geoms(*found);
}

double Shapes::GetFrictionCoefficient(const Identity& one, const Identity& two) const
{
    const Shape *first = get<Shape>(one), *second = get<Shape>(two);
    return first && second ? std::min(first->material.friction, second->material.friction) : 0;
}

double Shapes::GetRestitutionCoefficient(const Identity& one, const Identity& two) const
{
    const Shape *first = get<Shape>(one), *second = get<Shape>(two);
    return first && second ? std::max(first->material.bounce, second->material.bounce) : 0;
}

void Shapes::SetCollisionFilterMask(const Identity& shape, std::uint16_t mask)
{
    if (Shape* const found = get<Shape>(shape)) found->mask = mask, put_mask(*found);
}
std::uint16_t Shapes::GetCollisionFilterMask(const Identity& shape) const
{
    const Shape* const found = get<Shape>(shape);
    return found ? found->mask : std::uint16_t(0);
}
void Shapes::RemoveCollisionFilterMask(const Identity& shape) { SetCollisionFilterMask(shape, 0xffff); }

Identity Shapes::CastToBoxShape(const Identity& shape) const { return cast(shape, ShapeKind::kBox); }
Shapes::Vec3 Shapes::GetBoxShapeSize(const Identity& box) const
{
    return eigen_of(size_of(box, ShapeKind::kBox));
}
void Shapes::SetBoxShapeSize(const Identity& box, const Vec3& size)
{
    if (shape(box, ShapeKind::kBox)) resize(*get<Shape>(box), vec_of(size));
}
Identity Shapes::AttachBoxShape(const Identity& link, const std::string& name, const Vec3& size,
                                const Pose3& pose)
{
    return attach_solid(link, name, ShapeKind::kBox, vec_of(size), pose);
}

Identity Shapes::CastToSphereShape(const Identity& shape) const { return cast(shape, ShapeKind::kSphere); }
double Shapes::GetSphereShapeRadius(const Identity& sphere) const
{
    return size_of(sphere, ShapeKind::kSphere).x;
}
void Shapes::SetSphereShapeRadius(const Identity& sphere, double radius)
{
    resize_to(sphere, ShapeKind::kSphere, 0, radius);
}
Identity Shapes::AttachSphereShape(const Identity& link, const std::string& name, double radius,
                                   const Pose3& pose)
{
    return attach_solid(link, name, ShapeKind::kSphere, {radius, 0, 0}, pose);
}

Identity Shapes::CastToCylinderShape(const Identity& shape) const
{
    return cast(shape, ShapeKind::kCylinder);
}
double Shapes::GetCylinderShapeRadius(const Identity& cylinder) const
{
    return size_of(cylinder, ShapeKind::kCylinder).x;
}
double Shapes::GetCylinderShapeHeight(const Identity& cylinder) const
{
    return size_of(cylinder, ShapeKind::kCylinder).y;
}
void Shapes::SetCylinderShapeRadius(const Identity& cylinder, double radius)
{
    resize_to(cylinder, ShapeKind::kCylinder, 0, radius);
}
void Shapes::SetCylinderShapeHeight(const Identity& cylinder, double height)
{
    resize_to(cylinder, ShapeKind::kCylinder, 1, height);
}
Identity Shapes::AttachCylinderShape(const Identity& link, const std::string& name, double radius,
                                     double height, const Pose3& pose)
{
    return attach_solid(link, name, ShapeKind::kCylinder, {radius, height, 0}, pose);
}

Identity Shapes::CastToCapsuleShape(const Identity& shape) const { return cast(shape, ShapeKind::kCapsule); }
double Shapes::GetCapsuleShapeRadius(const Identity& capsule) const
{
    return size_of(capsule, ShapeKind::kCapsule).x;
}
double Shapes::GetCapsuleShapeLength(const Identity& capsule) const
{
    return size_of(capsule, ShapeKind::kCapsule).y;
}
void Shapes::SetCapsuleShapeRadius(const Identity& capsule, double radius)
{
    resize_to(capsule, ShapeKind::kCapsule, 0, radius);
}
void Shapes::SetCapsuleShapeLength(const Identity& capsule, double length)
{
    resize_to(capsule, ShapeKind::kCapsule, 1, length);
}
Identity Shapes::AttachCapsuleShape(const Identity& link, const std::string& name, double radius,
                                    double length, const Pose3& pose)
{
    return attach_solid(link, name, ShapeKind::kCapsule, {radius, length, 0}, pose);
}

Identity Shapes::CastToEllipsoidShape(const Identity& shape) const
{
    return cast(shape, ShapeKind::kEllipsoid);
}
Shapes::Vec3 Shapes::GetEllipsoidShapeRadii(const Identity& ellipsoid) const
{
    return eigen_of(size_of(ellipsoid, ShapeKind::kEllipsoid));
}
void Shapes::SetEllipsoidShapeRadii(const Identity& ellipsoid, Vec3 radii)
{
    if (shape(ellipsoid, ShapeKind::kEllipsoid)) resize(*get<Shape>(ellipsoid), vec_of(radii));
}
Identity Shapes::AttachEllipsoidShape(const Identity& link, const std::string& name, Vec3 radii,
                                      const Pose3& pose)
{
    return attach_solid(link, name, ShapeKind::kEllipsoid, vec_of(radii), pose);
}

Identity Shapes::CastToPlaneShape(const Identity& shape) const { return cast(shape, ShapeKind::kPlane); }
Shapes::Vec3 Shapes::GetPlaneShapeNormal(const Identity& plane) const
{
    const Shape* const found = shape(plane, ShapeKind::kPlane);
    return found ? eigen_of(rotate(found->pose.q, {0, 0, 1})) : Vec3::Zero();
}
Shapes::Vec3 Shapes::GetPlaneShapePoint(const Identity& plane) const
{
    const Shape* const found = shape(plane, ShapeKind::kPlane);
    return found ? eigen_of(found->pose.p) : Vec3::Zero();
}
void Shapes::SetPlaneShapeNormal(const Identity& plane, const Vec3& normal)
{
    if (!shape(plane, ShapeKind::kPlane) || !normal.allFinite()) return;
    Shape& its = *get<Shape>(plane);
    its.pose.q = robots::turn_of_z(vec_of(normal));
    put_geoms(its);
}
void Shapes::SetPlaneShapePoint(const Identity& plane, const Vec3& point)
{
    if (!shape(plane, ShapeKind::kPlane) || !point.allFinite()) return;
    Shape& its = *get<Shape>(plane);
    its.pose.p = vec_of(point);
    put_geoms(its);
}
Identity Shapes::AttachPlaneShape(const Identity& link, const std::string& name, const Vec3& normal,
                                  const Vec3& point)
{
    const Pose pose{vec_of(point), robots::turn_of_z(vec_of(normal))};
    return attach_solid(link, name, ShapeKind::kPlane, {}, eigen_of(pose));
}

Identity Shapes::CastToMeshShape(const Identity& shape) const { return cast(shape, ShapeKind::kMesh); }
Shapes::Vec3 Shapes::GetMeshShapeSize(const Identity& mesh) const
{
    return eigen_of(size_of(mesh, ShapeKind::kMesh));
}
Shapes::Vec3 Shapes::GetMeshShapeScale(const Identity& mesh) const
{
    const Shape* const found = shape(mesh, ShapeKind::kMesh);
    return found ? eigen_of(found->scale) : Vec3::Ones();
}
Identity Shapes::AttachMeshShape(const Identity& link, const std::string& name, const gz::common::Mesh& mesh,
                                 const Pose3& pose, const Vec3& scale)
{
    Link* const found = get<Link>(link);
    const auto made = found ? new_shape(*found, name, ShapeKind::kMesh, pose_of(pose)) : nullptr;
    return made ? keep(made, make_mesh_of(*made, mesh, vec_of(scale))) : GenerateInvalidId();
}

Identity Shapes::CastToHeightmapShape(const Identity& shape) const
{
    return cast(shape, ShapeKind::kHeightmap);
}
Shapes::Vec3 Shapes::GetHeightmapShapeSize(const Identity& heightmap) const
{
    return eigen_of(size_of(heightmap, ShapeKind::kHeightmap));
}
// Gazebo hands the heights out as const; to be read they must not be.
Identity Shapes::AttachHeightmapShape(const Identity& link, const std::string& name,
                                      const gz::common::HeightmapData& heights, const Pose3& pose,
                                      const Vec3& size, int sampling)
{
    Link* const found = get<Link>(link);
    const auto made = found ? new_shape(*found, name, ShapeKind::kHeightmap, pose_of(pose)) : nullptr;
    if (!made) return GenerateInvalidId();
    auto& data = const_cast<gz::common::HeightmapData&>(heights);
    return keep(made, make_heights_of(*made, data, vec_of(size), sampling));
}

}  // namespace epode::gazebo
