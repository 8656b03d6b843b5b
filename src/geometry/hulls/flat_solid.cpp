// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The faces, corners and edges of a box, and the views of solids: see flat_solid.h. Corner i has the signs of
// the bits of i (0: negative); side 2 k looks along axis k, side 2 k + 1 against it.
#include "geometry/hulls/flat_solid.h"

#include <array>

namespace epode {

namespace {

constexpr Real kSqrtHalf = Real(0.70710678118654752440);

// Edge along axis k between the sides on the axes k + 1 and k + 2.
constexpr std::array<PolyhedronEdge, 12> box_edges()
{
    std::array<PolyhedronEdge, 12> out = {};
    for (int i = 0; i < 12; ++i) {
        const int k = i / 4, k1 = (k + 1) % 3, k2 = (k + 2) % 3;
        const int up1 = i & 1, up2 = i >> 1 & 1;
        const int from = up1 << k1 | up2 << k2;
        const int side1 = 2 * k1 + 1 - up1, side2 = 2 * k2 + 1 - up2;
        const bool along = up1 == up2;  // the product of the two normals points along the axis
        out[std::size_t(i)] = {from, from | 1 << k, along ? side1 : side2, along ? side2 : side1, kSqrtHalf};
    }
    return out;
}

constexpr std::array<PolyhedronEdge, 12> kBoxEdges = box_edges();

}  // namespace

FlatSolid::FlatSolid(const ConvexView& v)
{
    if (v.kind == SolidKind::kPolyhedron) {
        polyhedron_ = static_cast<const Polyhedron*>(v.shape);
        vertices = polyhedron_->vertices(), faces = polyhedron_->faces(), edges = polyhedron_->seams();
        inner = polyhedron_->inner(), inner_radius = polyhedron_->inner_radius();
        return;
    }
    half_ = static_cast<const Box*>(v.shape)->half;
    for (int i = 0; i < 8; ++i)
        corner_[i] = {i & 1 ? half_.x : -half_.x, i & 2 ? half_.y : -half_.y, i & 4 ? half_.z : -half_.z};
    for (int k = 0; k < 3; ++k) {
        Vec3 n;
        n.set(k, 1);
        side_[2 * k] = {n, half_[k], 0, 4};
        side_[2 * k + 1] = {-n, half_[k], 0, 4};
    }
    vertices = corner_, faces = side_, edges = kBoxEdges;
    const Real least = half_.x < half_.y ? half_.x : half_.y;
    inner_radius = least < half_.z ? least : half_.z;
}

FaceGaps::FaceGaps(const FlatSolid& s, Vec3 p) : s_(s), p_(p)
{
    if (s.polyhedron() && s.faces.size() <= kCapacity) {
        compute_all();
        return;
    }
    Real largest = -kInf;
    for (std::size_t i = 0; i < s.faces.size(); ++i) {
        const Real g = compute(i);
        if (i < kCapacity) gap_[i] = g;
        if (g > largest) largest = g, widest = i;
    }
}

void FaceGaps::compute_all()
{
    const DotLanes& faces = s_.polyhedron()->face_lanes();
    const QuadVec p = quad_vec(p_);
    Quad largest = quad(-kInf);
    for (int g = 0; g < faces.groups(); ++g) {
        const Quad some = dots(faces.group(g), p) - offsets(faces.group(g));
        store_quad(gap_ + g * DotLanes::kWide, some);
        largest = larger(some, largest);
    }
    widest = std::size_t(first_as_large(gap_, faces.groups(), largest_lane(largest)));
}

RoundCore::RoundCore(const ConvexView& v)
{
    if (v.kind == SolidKind::kSegment) half_length = static_cast<const Capsule*>(v.shape)->half_length;
    if (v.kind != SolidKind::kCylinder) return;
    const Cylinder& c = *static_cast<const Cylinder*>(v.shape);
    radius = c.radius, half_length = c.half_length;
    inner_radius = radius < half_length ? radius : half_length;
}

}  // namespace epode
