// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Shapes by kind: attached to links, their sizes, poses, surfaces and bits.
#pragma once

#include "integrations/gazebo/construct.h"

namespace epode::gazebo {

struct ShapeFeatures
    : gz::physics::FeatureList<
          gz::physics::GetShapeKinematicProperties, gz::physics::SetShapeKinematicProperties,
          gz::physics::GetShapeCollisionProperties, gz::physics::CollisionFilterMaskFeature,
          gz::physics::BoxShapeCast, gz::physics::GetBoxShapeProperties, gz::physics::SetBoxShapeProperties,
          gz::physics::AttachBoxShapeFeature, gz::physics::SphereShapeCast,
          gz::physics::GetSphereShapeProperties, gz::physics::SetSphereShapeProperties,
          gz::physics::AttachSphereShapeFeature, gz::physics::CylinderShapeCast,
          gz::physics::GetCylinderShapeProperties, gz::physics::SetCylinderShapeProperties,
          gz::physics::AttachCylinderShapeFeature, gz::physics::CapsuleShapeCast,
          gz::physics::GetCapsuleShapeProperties, gz::physics::SetCapsuleShapeProperties,
          gz::physics::AttachCapsuleShapeFeature, gz::physics::EllipsoidShapeCast,
          gz::physics::GetEllipsoidShapeProperties, gz::physics::SetEllipsoidShapeProperties,
          gz::physics::AttachEllipsoidShapeFeature, gz::physics::PlaneShapeCast,
          gz::physics::GetPlaneShapeProperties, gz::physics::SetPlaneShapeProperties,
          gz::physics::AttachPlaneShapeFeature, gz::physics::mesh::MeshShapeCast,
          gz::physics::mesh::GetMeshShapeProperties, gz::physics::mesh::AttachMeshShapeFeature,
          gz::physics::heightmap::HeightmapShapeCast, gz::physics::heightmap::GetHeightmapShapeProperties,
          gz::physics::heightmap::AttachHeightmapShapeFeature> {};

class Shapes : public virtual Construct, public virtual gz::physics::Implements3d<ShapeFeatures> {
  public:
    using Pose3 = gz::physics::Pose3d;
    using Vec3 = Eigen::Vector3d;

    Pose3 GetShapeRelativeTransform(const Identity& shape) const override;
    void SetShapeRelativeTransform(const Identity& shape, const Pose3& pose) override;
    // The smaller coefficient of the two, and the larger restitution.
    double GetFrictionCoefficient(const Identity& one, const Identity& two) const override;
    double GetRestitutionCoefficient(const Identity& one, const Identity& two) const override;
    void SetCollisionFilterMask(const Identity& shape, std::uint16_t mask) override;
    std::uint16_t GetCollisionFilterMask(const Identity& shape) const override;
    void RemoveCollisionFilterMask(const Identity& shape) override;

    Identity CastToBoxShape(const Identity& shape) const override;
    Vec3 GetBoxShapeSize(const Identity& box) const override;
    void SetBoxShapeSize(const Identity& box, const Vec3& size) override;
    Identity AttachBoxShape(const Identity& link, const std::string& name, const Vec3& size,
                            const Pose3& pose) override;

    Identity CastToSphereShape(const Identity& shape) const override;
    double GetSphereShapeRadius(const Identity& sphere) const override;
    void SetSphereShapeRadius(const Identity& sphere, double radius) override;
    Identity AttachSphereShape(const Identity& link, const std::string& name, double radius,
                               const Pose3& pose) override;

    Identity CastToCylinderShape(const Identity& shape) const override;
    double GetCylinderShapeRadius(const Identity& cylinder) const override;
    double GetCylinderShapeHeight(const Identity& cylinder) const override;
    void SetCylinderShapeRadius(const Identity& cylinder, double radius) override;
    void SetCylinderShapeHeight(const Identity& cylinder, double height) override;
    Identity AttachCylinderShape(const Identity& link, const std::string& name, double radius, double height,
                                 const Pose3& pose) override;

    Identity CastToCapsuleShape(const Identity& shape) const override;
    double GetCapsuleShapeRadius(const Identity& capsule) const override;
    double GetCapsuleShapeLength(const Identity& capsule) const override;
    void SetCapsuleShapeRadius(const Identity& capsule, double radius) override;
    void SetCapsuleShapeLength(const Identity& capsule, double length) override;
    Identity AttachCapsuleShape(const Identity& link, const std::string& name, double radius, double length,
                                const Pose3& pose) override;

    Identity CastToEllipsoidShape(const Identity& shape) const override;
    Vec3 GetEllipsoidShapeRadii(const Identity& ellipsoid) const override;
    void SetEllipsoidShapeRadii(const Identity& ellipsoid, Vec3 radii) override;
    Identity AttachEllipsoidShape(const Identity& link, const std::string& name, Vec3 radii,
                                  const Pose3& pose) override;

    // Normal and point in the world.
    Identity CastToPlaneShape(const Identity& shape) const override;
    Vec3 GetPlaneShapeNormal(const Identity& plane) const override;
    Vec3 GetPlaneShapePoint(const Identity& plane) const override;
    void SetPlaneShapeNormal(const Identity& plane, const Vec3& normal) override;
    void SetPlaneShapePoint(const Identity& plane, const Vec3& point) override;
    Identity AttachPlaneShape(const Identity& link, const std::string& name, const Vec3& normal,
                              const Vec3& point) override;

    Identity CastToMeshShape(const Identity& shape) const override;
    Vec3 GetMeshShapeSize(const Identity& mesh) const override;
    Vec3 GetMeshShapeScale(const Identity& mesh) const override;
    Identity AttachMeshShape(const Identity& link, const std::string& name, const gz::common::Mesh& mesh,
                             const Pose3& pose, const Vec3& scale) override;

    Identity CastToHeightmapShape(const Identity& shape) const override;
    Vec3 GetHeightmapShapeSize(const Identity& heightmap) const override;
    Identity AttachHeightmapShape(const Identity& link, const std::string& name,
                                  const gz::common::HeightmapData& heights, const Pose3& pose,
                                  const Vec3& size, int sampling) override;

  private:
    Identity cast(const Identity& shape, ShapeKind kind) const;
    const Shape* shape(const Identity& shape, ShapeKind kind) const;
    Vec size_of(const Identity& shape, ShapeKind kind) const;
    void resize_to(const Identity& shape, ShapeKind kind, int which, double value);
    Identity attach_solid(const Identity& link, const std::string& name, ShapeKind kind, Vec size,
                          const Pose3& pose);
};

}  // namespace epode::gazebo
