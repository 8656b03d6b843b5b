// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The solids of bench/collide: see pair_shapes.h. A ring at height z has the radius of the ellipsoid there;
// the quadrangles between two rings are planar by symmetry.
#include "bench/collision/pair_shapes.h"

namespace epode::bench {

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr int kCells = 64;  // to a side of a ground

int rings_of(const std::string& kind) { return kind == "cube" ? 2 : kind == "hull20" ? 4 : 10; }
int sides_of(const std::string& kind) { return kind == "cube" ? 4 : kind == "hull20" ? 5 : 10; }

}  // namespace

// Two rings make a prism.
RingHull::RingHull(int rings, int sides, double radius, double height)
{
    top = height;
    for (int i = 0; i < rings; ++i) {
        const double z = height * (2.0 * i / (rings - 1) - 1), up = 0.9 * z / height;
        const double r = rings == 2 ? radius : radius * std::sqrt(1 - up * up);
        reach = std::max(reach, std::hypot(r, z));
        for (int k = 0; k < sides; ++k) {
            const double angle = 2 * kPi * (k + 0.5) / sides;
            for (const double v : {r * std::cos(angle), r * std::sin(angle), z}) points.push_back(dReal(v));
        }
    }
    std::vector<int> bottom, lid;
    for (int k = 0; k < sides; ++k) bottom.push_back(sides - 1 - k), lid.push_back((rings - 1) * sides + k);
    add_face(bottom);
    add_face(lid);
    for (int i = 0; i + 1 < rings; ++i)
        for (int k = 0; k < sides; ++k) {
            const int a = i * sides + k, b = i * sides + (k + 1) % sides;
            add_face({a, b, b + sides, a + sides});
        }
}

// Counter-clockwise seen from outside; the plane by the diagonals' product.
void RingHull::add_face(const std::vector<int>& corners)
{
    polygons.push_back(unsigned(corners.size()));
    for (const int c : corners) polygons.push_back(unsigned(c));
    const auto at = [&](std::size_t i, int axis) {
        return double(points[std::size_t(3 * corners[i % corners.size()] + axis)]);
    };
    double d[2][3], n[3];
    for (int axis = 0; axis < 3; ++axis)
        d[0][axis] = at(2, axis) - at(0, axis), d[1][axis] = at(3, axis) - at(1, axis);
    for (int axis = 0; axis < 3; ++axis)
        n[axis] = d[0][(axis + 1) % 3] * d[1][(axis + 2) % 3] - d[0][(axis + 2) % 3] * d[1][(axis + 1) % 3];
    const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    double offset = 0;
    for (int axis = 0; axis < 3; ++axis) {
        planes.push_back(dReal(n[axis] / length));
        offset += n[axis] / length * at(0, axis);
    }
    planes.push_back(dReal(offset));
}

PairShape::PairShape(const std::string& kind)
    : kind_(kind), hull_(rings_of(kind), sides_of(kind), kind == "cube" ? 0.25 * std::sqrt(2.0) : 0.3, 0.25)
{
    top_ = 0.25;
    if (kind == "sphere") {
        geom_ = dCreateSphere(nullptr, dReal(0.25));
        reach_ = 0.25;
    } else if (kind == "box") {
        geom_ = dCreateBox(nullptr, dReal(0.5), dReal(0.5), dReal(0.5));
        reach_ = 0.25 * std::sqrt(3.0);
    } else if (kind == "capsule") {
        geom_ = dCreateCapsule(nullptr, dReal(0.15), dReal(0.3));
        reach_ = top_ = 0.3;
    } else if (kind == "cylinder") {
        geom_ = dCreateCylinder(nullptr, dReal(0.25), dReal(0.5));
        reach_ = std::hypot(0.25, 0.25);
    } else if (kind == "plane") {
        geom_ = dCreatePlane(nullptr, 0, 0, 1, 0);
        top_ = 0;
    } else if (is_ray()) {
        make_ray();
    } else if (kind == "ground") {
        ground_ = std::make_unique<MeshGround>(kCells), geom_ = ground_->geom();
    } else if (kind == "field") {
        field_ = std::make_unique<FieldGround>(kCells), geom_ = field_->geom();
    } else if (kind == "mesh") {
        make_mesh();
        reach_ = hull_.reach;
    } else {
        geom_ = dCreateConvex(nullptr, hull_.planes.data(), unsigned(hull_.planes.size() / 4),
                              hull_.points.data(), unsigned(hull_.points.size() / 3), hull_.polygons.data());
        reach_ = hull_.reach;
    }
}

PairShape::~PairShape()
{
    if (!is_ground()) dGeomDestroy(geom_);
    if (data_) dGeomTriMeshDataDestroy(data_);
}

void PairShape::make_ray()
{
    geom_ = dCreateRay(nullptr, 2);
    dGeomRaySetFirstContact(geom_, kind_ == "ray-first");
    dGeomRaySetClosestHit(geom_, kind_ == "ray-closest");
    dGeomRaySetBackfaceCull(geom_, kind_ == "ray-cull");
    top_ = 0, reach_ = 1;
}

void PairShape::make_mesh()
{
    const std::vector<unsigned>& p = hull_.polygons;
    for (std::size_t at = 0; at < p.size(); at += p[at] + 1)
        for (std::size_t k = 2; k < p[at]; ++k)
            for (const std::size_t corner : {std::size_t(1), k, k + 1})
                triangles_.push_back(dTriIndex(p[at + corner]));
    data_ = dGeomTriMeshDataCreate();
    const auto build =
        sizeof(dReal) == sizeof(double) ? dGeomTriMeshDataBuildDouble : dGeomTriMeshDataBuildSingle;
    build(data_, hull_.points.data(), 3 * sizeof(dReal), int(hull_.points.size() / 3), triangles_.data(),
          int(triangles_.size()), 3 * sizeof(dTriIndex));
    // Debian's library ends the program on a polyhedron against a mesh without these.
    dGeomTriMeshDataPreprocess2(data_, 1u << dTRIDATAPREPROCESS_BUILD_FACE_ANGLES, nullptr);
    geom_ = dCreateTriMesh(nullptr, data_, nullptr, nullptr, nullptr);
}

}  // namespace epode::bench
