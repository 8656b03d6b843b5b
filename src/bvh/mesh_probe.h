// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A convex solid as the leaves of a mesh's tree turn it away, four triangles at a time in floats: the sum of
// a centre, up to three arms (segments from -u to u) and a ball or a disc of radius r across the axis d.
// Without the ball it reaches  sum |n . u| + r sqrt(n^2 - (n . d)^2)  along n. Directions tried: the arms,
// the triangle's normal n and those across each edge, o = e x n; what is H off in the one and W in the other
// is away by more than a ball r if H^2 + W^2 > r^2, with lengths H^2 e^2 + W^2 > r^2 n^2 e^2. A triangle is
// left out only if one of them parts the two by more than rounding can feign: with edges of length E (sum of
// components) and everything within D of the first corner, n is off by some 2^-22 E, what is across an edge
// by 2^-22 E^2; kMeshMargin is eight times that.
#pragma once

#include "bvh/mesh_packet.h"

namespace epode {

// In the frame of the mesh.
struct SolidProbe {
    Vec3 centre;
    int arms = 0;
    Vec3 arm[3];
    Real round = 0;
    Vec3 axis;       // unit, of a disc; zero for a ball
    Real slack = 0;  // what is apart by less is met
};

// The same in floats, in the tree's frame.
struct MeshProbe {
    MeshProbe(const SolidProbe& solid, Vec3 centre_in_frame, Real scale);
    // Bits of the lanes that may be met.
    unsigned meets(const MeshPacket& packet) const;

    float centre[3];
    int arms;
    float arm[3][3], limit[3];  // how far along its arm a corner may be
    float ball, disc, axis[3], slack, size;
};

namespace mesh_lanes {

struct Floats3 {
    Floats x, y, z;
};
inline Floats3 operator-(const Floats3& a, const Floats3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Floats3 cross(const Floats3& a, const Floats3& b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Floats dot(const Floats3& a, const Floats3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Floats dot(const Floats3& a, const float* b)
{
    return a.x * floats(b[0]) + a.y * floats(b[1]) + a.z * floats(b[2]);
}
inline Floats sum(const Floats3& a) { return magnitude(a.x) + magnitude(a.y) + magnitude(a.z); }

inline Floats root(Floats x)
{
#if defined(__SSE2__)
    return __builtin_ia32_sqrtps(x);
#else
    return Floats{std::sqrt(x[0]), std::sqrt(x[1]), std::sqrt(x[2]), std::sqrt(x[3])};
#endif
}

inline Floats reach(const MeshProbe& p, const Floats3& n)
{
    Floats far = Floats{};
    for (int i = 0; i < p.arms; ++i) far += magnitude(dot(n, p.arm[i]));
    if (!(p.disc > 0)) return far;
    const Floats along = dot(n, p.axis), across2 = dot(n, n) - along * along;
    return far + floats(p.disc) * root(larger(across2, Floats{}));
}

}  // namespace mesh_lanes

inline unsigned MeshProbe::meets(const MeshPacket& packet) const
{
    using namespace mesh_lanes;
    Floats3 v[3];  // from the centre
    for (int k = 0; k < 3; ++k)
        v[k] = {four_at(packet.at[k][0]) - floats(centre[0]), four_at(packet.at[k][1]) - floats(centre[1]),
                four_at(packet.at[k][2]) - floats(centre[2])};
    Ints apart{};
    for (int i = 0; i < arms; ++i) {
        const Floats a = dot(v[0], arm[i]), b = dot(v[1], arm[i]), c = dot(v[2], arm[i]);
        apart |= smaller(a, smaller(b, c)) > floats(limit[i]);
        apart |= larger(a, larger(b, c)) < floats(-limit[i]);
    }
    const Floats3 edge[3] = {v[1] - v[0], v[2] - v[1], v[0] - v[2]};
    const Floats3 n = cross(edge[0], edge[1]);
    const Floats length = sum(edge[0]) + sum(edge[1]);
    const Floats blur =
        length * (floats(kMeshMargin) * (length + sum(v[0]) + floats(size)) + floats(slack) * length);
    const Floats nothing = Floats{};
    const Floats over = larger(magnitude(dot(n, v[0])) - reach(*this, n) - blur, nothing);
    const Floats over2 = over * over, ball2 = floats(ball * ball) * dot(n, n);
    for (int k = 0; k < 3; ++k) {
        const Floats3 out = cross(edge[k], n);
        const Floats aside = larger(-dot(out, v[k]) - reach(*this, out) - floats(2) * length * blur, nothing);
        apart |= aside * aside > (ball2 - over2) * dot(edge[k], edge[k]);
    }
    return ~bits(apart) & 15u;
}

}  // namespace epode
