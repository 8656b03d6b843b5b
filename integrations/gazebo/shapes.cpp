// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See shapes.h.
#include "integrations/gazebo/shapes.h"

#include <algorithm>

#include "integrations/gazebo/convert.h"
#include "integrations/gazebo/links.h"
#include "robots/parts/decompose.h"

namespace epode::gazebo {

namespace {

constexpr double kHalfRoot = 0.70710678118654752440;
constexpr double kMaxSize = 1e6;        // m
constexpr unsigned kMaxVertices = 256;  // of a hull
constexpr double kConvexShare = 0.999;  // of its hull's volume, from which on a mesh counts as convex

int sizes_of(ShapeKind kind)
{
    switch (kind) {
        case ShapeKind::kBox:
        case ShapeKind::kEllipsoid:
            return 3;
        case ShapeKind::kCylinder:
        case ShapeKind::kCapsule:
            return 2;
        case ShapeKind::kSphere:
            return 1;
        default:
            return 0;
    }
}

bool are_good(const Shape& shape, Vec size)
{
    for (int i = 0; i < sizes_of(shape.kind); ++i)
        if (!(size[i] > 0 && size[i] < kMaxSize)) {
            EPODE_GAZEBO_ERROR << "collision '" << shape.name << "': a size of " << size[i]
                               << " m was refused; it must be above 0 and below 1e6\n";
            return false;
        }
    return true;
}

// ODE's fields have y up.
Pose geom_pose(const Shape& shape)
{
    const Pose up{{}, {kHalfRoot, kHalfRoot, 0, 0}};
    return shape.kind == ShapeKind::kHeightmap ? shape.pose * up : shape.pose;
}

dGeomID make_one(const Shape& shape)
{
    const dSpaceID space = shape.link->model->world->space;
    const Vec s = shape.size;
    switch (shape.kind) {
        case ShapeKind::kBox:
            return dCreateBox(space, s.x, s.y, s.z);
        case ShapeKind::kSphere:
            return dCreateSphere(space, s.x);
        case ShapeKind::kCylinder:
            return dCreateCylinder(space, s.x, s.y);
        case ShapeKind::kCapsule:
            return dCreateCapsule(space, s.x, s.y);
        case ShapeKind::kEllipsoid:
            return dCreateEllipsoid(space, s.x, s.y, s.z);
        case ShapeKind::kPlane:
            return dCreatePlane(space, 0, 0, 1, 0);
        case ShapeKind::kHeightmap:
            return dCreateHeightfield(space, shape.heights, 1);
        case ShapeKind::kMesh:
            return dCreateTriMesh(space, shape.triangles, nullptr, nullptr, nullptr);
    }
    return nullptr;
}

void add_geom(Shape& shape, dGeomID geom)
{
    if (!geom) return;
    dGeomSetData(geom, &shape);
    if (shape.link->body) dGeomSetBody(geom, shape.link->body);
    shape.geoms.push_back(geom);
}

bool finish(Shape& shape)
{
    put_geoms(shape), put_material(shape), put_mask(shape);
    return !shape.geoms.empty();
}

void put_plane(dGeomID plane, const Pose& at)
{
    const Vec n = rotate(at.q, {0, 0, 1});
    dGeomPlaneSetParams(plane, n.x, n.y, n.z, dot(n, at.p));
}

void put_on_body(dGeomID geom, const Pose& at)
{
    const dReal q[4] = {at.q.w, at.q.x, at.q.y, at.q.z};
    dGeomSetOffsetPosition(geom, at.p.x, at.p.y, at.p.z);
    dGeomSetOffsetQuaternion(geom, q);
}

void put_in_world(dGeomID geom, const Pose& at)
{
    const dReal q[4] = {at.q.w, at.q.x, at.q.y, at.q.z};
    dGeomSetPosition(geom, at.p.x, at.p.y, at.p.z);
    dGeomSetQuaternion(geom, q);
}

double volume_of(const robots::Mesh& mesh)
{
    double six = 0;
    for (const auto& t : mesh.triangles)
        six += dot(mesh.vertices[t[0]], cross(mesh.vertices[t[1]], mesh.vertices[t[2]]));
    return std::abs(six) / 6;
}

// One where the mesh is convex, else several; none of a plate.
std::vector<robots::Hull> parts_of(const robots::Mesh& mesh)
{
    robots::Hull whole = robots::hull_of(mesh.vertices, kMaxVertices);
    robots::Decomposition parts;
    std::string problem;
    const bool is_convex = whole.is_empty() || volume_of(mesh) > kConvexShare * whole.volume;
    if (!is_convex && robots::decompose(mesh, {}, parts, problem)) return parts.hulls;
    if (whole.is_empty()) return {};
    return {whole};
}

// The library keeps no copies of these.
void build_triangles(Shape& shape, const robots::Mesh& mesh)
{
    for (const Vec& v : mesh.vertices) shape.corners.insert(shape.corners.end(), {v.x, v.y, v.z});
    for (const auto& t : mesh.triangles) shape.indices.insert(shape.indices.end(), t.begin(), t.end());
    shape.triangles = dGeomTriMeshDataCreate();
    dGeomTriMeshDataBuildDouble(shape.triangles, shape.corners.data(), 3 * sizeof(double),
                                int(mesh.vertices.size()), shape.indices.data(), int(shape.indices.size()),
                                3 * sizeof(dTriIndex));
}

}  // namespace

Shape::~Shape()
{
    if (triangles) dGeomTriMeshDataDestroy(triangles);
    if (heights) dGeomHeightfieldDataDestroy(heights);
}

bool make_geoms(Shape& shape)
{
    if (shape.kind == ShapeKind::kPlane && shape.link->body) {
        EPODE_GAZEBO_ERROR << "collision '" << shape.name
                           << "': a plane can only be part of a static model, link '" << shape.link->name
                           << "' can move\n";
        return false;
    }
    if (!are_good(shape, shape.size)) return false;
    add_geom(shape, make_one(shape));
    return finish(shape);
}

bool make_mesh(Shape& shape, robots::Mesh mesh)
{
    Vec low{HUGE_VAL, HUGE_VAL, HUGE_VAL}, high = -low;
    shape.low = low, shape.high = high;
    for (Vec& v : mesh.vertices) {
        if (!robots::is_finite(v)) mesh.triangles.clear();
        for (int i = 0; i < 3; ++i) low[i] = std::min(low[i], v[i]), high[i] = std::max(high[i], v[i]);
        v = robots::scaled(v, shape.scale);
        for (int i = 0; i < 3; ++i)
            shape.low[i] = std::min(shape.low[i], v[i]), shape.high[i] = std::max(shape.high[i], v[i]);
    }
    if (mesh.triangles.empty()) {
        EPODE_GAZEBO_ERROR << "collision '" << shape.name
                           << "': a mesh without triangles, or with numbers that are not finite\n";
        return false;
    }
    shape.size = high - low;
    if (shape.link->body) {
        const dSpaceID space = shape.link->model->world->space;
        for (const robots::Hull& hull : parts_of(mesh))
            add_geom(shape, dCreateConvex(space, hull.planes.data(), unsigned(hull.planes.size() / 4),
                                          hull.points.data(), unsigned(hull.points.size() / 3),
                                          hull.polygons.data()));
    } else {
        build_triangles(shape, mesh);
        add_geom(shape, make_one(shape));
    }
    return finish(shape);
}

bool make_heights(Shape& shape, const std::vector<double>& heights, int rows, int columns)
{
    if (shape.link->body) {
        EPODE_GAZEBO_ERROR << "collision '" << shape.name
                           << "': a height map can only be part of a static model\n";
        return false;
    }
    const auto [least, largest] = std::minmax_element(heights.begin(), heights.end());
    shape.low = {-shape.size.x / 2, -shape.size.y / 2, *least};
    shape.high = {shape.size.x / 2, shape.size.y / 2, *largest};
    std::vector<double> samples;  // ODE's rows run from the largest y down
    for (int row = rows; row-- > 0;)
        samples.insert(samples.end(), heights.begin() + row * columns, heights.begin() + (row + 1) * columns);
    shape.heights = dGeomHeightfieldDataCreate();
    dGeomHeightfieldDataBuildDouble(shape.heights, samples.data(), 1, shape.size.x, shape.size.y, columns,
                                    rows, 1, 0, 1, 0);
    add_geom(shape, make_one(shape));
    return finish(shape);
}

void destroy_geoms(Shape& shape)
{
    for (dGeomID geom : shape.geoms) dGeomDestroy(geom);
    shape.geoms.clear();
}

void put_geoms(Shape& shape)
{
    const Pose at = geom_pose(shape);
    for (dGeomID geom : shape.geoms) {
        if (shape.link->body)
            put_on_body(geom, {at.p - shape.link->centre, at.q});
        else if (shape.kind == ShapeKind::kPlane)
            put_plane(geom, shape.link->static_pose * at);
        else
            put_in_world(geom, shape.link->static_pose * at);
    }
    wake(*shape.link);
}

void put_material(Shape& shape)
{
    for (dGeomID geom : shape.geoms) dGeomSetMaterial(geom, &shape.material);
    wake(*shape.link);
}

void put_mask(Shape& shape)
{
    for (dGeomID geom : shape.geoms) {
        dGeomSetCategoryBits(geom, shape.mask);
        dGeomSetCollideBits(geom, shape.mask);
    }
    wake(*shape.link);
}

bool box_of(const Shape& shape, Vec& low, Vec& high)
{
    const Vec s = shape.size;
    switch (shape.kind) {
        case ShapeKind::kBox:
            high = 0.5 * s;
            break;
        case ShapeKind::kSphere:
            high = {s.x, s.x, s.x};
            break;
        case ShapeKind::kCylinder:
            high = {s.x, s.x, s.y / 2};
            break;
        case ShapeKind::kCapsule:
            high = {s.x, s.x, s.y / 2 + s.x};
            break;
        case ShapeKind::kEllipsoid:
            high = s;
            break;
        case ShapeKind::kPlane:
            return false;
        default:
            low = shape.low, high = shape.high;
            return true;
    }
    low = -high;
    return true;
}

bool resize(Shape& shape, Vec size)
{
    if (!are_good(shape, size) || shape.geoms.empty()) return false;
    const dGeomID geom = shape.geoms[0];
    shape.size = size;
    switch (shape.kind) {
        case ShapeKind::kBox:
            dGeomBoxSetLengths(geom, size.x, size.y, size.z);
            break;
        case ShapeKind::kSphere:
            dGeomSphereSetRadius(geom, size.x);
            break;
        case ShapeKind::kCylinder:
            dGeomCylinderSetParams(geom, size.x, size.y);
            break;
        case ShapeKind::kCapsule:
            dGeomCapsuleSetParams(geom, size.x, size.y);
            break;
        case ShapeKind::kEllipsoid:
            dGeomEllipsoidSetRadii(geom, size.x, size.y, size.z);
            break;
        default:
            return false;
    }
    wake(*shape.link);
    return true;
}

}  // namespace epode::gazebo
