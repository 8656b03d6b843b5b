// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A leaf of the tree over a mesh: up to four triangles in floats, in the tree's frame. Four are tested at a
// time before any of them is tested exactly. Nothing is missed: coordinates are within 2^-24 of the true
// ones, and queries are widened by kMeshMargin, about 30 times as much.
//
//   ray    uses the shadows A, B, C of the corners along the ray (Woop, Benthin and Wald, JCGT 2013) and the
//          numbers U = C x B ...; with corners off by d, U is off by at most d (|B| + |C|) and as much again
//          by rounding. A triangle is skipped only if two of the three have opposite signs beyond that error,
//          or if it lies entirely beyond the ends of the ray.
#pragma once

#include "bvh/mesh_node.h"
#include "geometry/triangle_mesh.h"

namespace epode {

// A ray in the tree's frame, prepared for triangles: along the largest axis of its direction.
struct PacketRay {
    PacketRay(Vec3 origin, Vec3 direction);
    float origin[3];
    int x, y, z;     // axes; z the largest of the direction
    float shear[2];  // x and y gone per length of z
    float per_z;     // length of the ray per length of z
};

struct alignas(16) MeshPacket {
    static constexpr int kNone = -1;

    float at[3][3][4];       // corner, axis, lane
    int lanes[4];            // the triangle; -2 - triangle if it is degenerate; kNone
    MeshCorners corners[4];  // of each lane, so that the vertices need not be looked up first

    bool used(int k) const { return lanes[k] != kNone; }
    int triangle(int k) const { return lanes[k] >= 0 ? lanes[k] : -2 - lanes[k]; }

    // Bits of the triangles met, degenerate ones left out.
    unsigned met_by(const FloatBox& box) const;
    unsigned met_by(const PacketRay& ray, float reach) const;
    unsigned whole() const;
};

inline unsigned MeshPacket::whole() const
{
    using namespace mesh_lanes;
    Ints there;
    __builtin_memcpy(&there, lanes, sizeof(there));
    return bits(Ints(there >= Ints{}));
}

namespace mesh_lanes {

inline Floats four_at(const float* p)
{
    Floats x;
    __builtin_memcpy(&x, p, sizeof(x));
    return x;
}
inline Floats magnitude(Floats x) { return larger(x, -x); }

}  // namespace mesh_lanes

inline unsigned MeshPacket::met_by(const FloatBox& box) const
{
    using namespace mesh_lanes;
    Ints apart{};
    for (int i = 0; i < 3; ++i) {
        const Floats a = four_at(at[0][i]), b = four_at(at[1][i]), c = four_at(at[2][i]);
        apart |= smaller(a, smaller(b, c)) > floats(box.hi[i] + kMeshMargin);
        apart |= larger(a, larger(b, c)) < floats(box.lo[i] - kMeshMargin);
    }
    return ~bits(apart) & whole();
}

inline unsigned MeshPacket::met_by(const PacketRay& ray, float reach) const
{
    using namespace mesh_lanes;
    Floats x[3], y[3], z[3], size[3];
    for (int k = 0; k < 3; ++k) {
        z[k] = four_at(at[k][ray.z]) - floats(ray.origin[ray.z]);
        x[k] = four_at(at[k][ray.x]) - floats(ray.origin[ray.x]) - floats(ray.shear[0]) * z[k];
        y[k] = four_at(at[k][ray.y]) - floats(ray.origin[ray.y]) - floats(ray.shear[1]) * z[k];
        size[k] = magnitude(x[k]) + magnitude(y[k]);
    }
    Ints left{}, right{};
    for (int k = 0; k < 3; ++k) {
        const int p = (k + 1) % 3, q = (k + 2) % 3;
        const Floats turn = x[q] * y[p] - y[q] * x[p];
        const Floats blur = floats(2 * kMeshMargin) * (size[p] + size[q]);
        left |= turn > blur;
        right |= turn < -blur;
    }
    const Floats per = floats(ray.per_z);
    const Floats a = z[0] * per, b = z[1] * per, c = z[2] * per;
    const Ints beyond = smaller(a, smaller(b, c)) > floats(reach + 4 * kMeshMargin);
    const Ints before = larger(a, larger(b, c)) < floats(-4 * kMeshMargin);
    return ~bits((left & right) | beyond | before) & whole();
}

}  // namespace epode
