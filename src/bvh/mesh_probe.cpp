// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See mesh_probe.h.
#include "bvh/mesh_probe.h"

namespace epode {

namespace {

using namespace mesh_lanes;

struct Floats3 {
    Floats x, y, z;
};
Floats3 operator+(const Floats3& a, const Floats3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Floats3 operator-(const Floats3& a, const Floats3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Floats3 operator-(const Floats3& a) { return {-a.x, -a.y, -a.z}; }
Floats3 cross(const Floats3& a, const Floats3& b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Floats dot(const Floats3& a, const Floats3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Floats dot(const Floats3& a, const float* b)
{
    return a.x * floats(b[0]) + a.y * floats(b[1]) + a.z * floats(b[2]);
}
Floats sum(const Floats3& a) { return magnitude(a.x) + magnitude(a.y) + magnitude(a.z); }
Floats3 turned(const Floats3& a, const float (&rows)[3][3])
{
    return {dot(a, rows[0]), dot(a, rows[1]), dot(a, rows[2])};
}
Floats smallest(Floats a, Floats b, Floats c) { return smaller(a, smaller(b, c)); }
Floats largest(Floats a, Floats b, Floats c) { return larger(a, larger(b, c)); }

Floats root(Floats x)
{
#if defined(__SSE2__)
    return __builtin_ia32_sqrtps(x);
#else
    return Floats{std::sqrt(x[0]), std::sqrt(x[1]), std::sqrt(x[2]), std::sqrt(x[3])};
#endif
}

// Corners relative to the centre of the solid, and edges: edge k goes from corner k to the next.
struct Corners {
    Floats3 v[3], e[3];
    Floats3 n;
    Floats length, blur;

    void finish(float slack, float size)
    {
        v[1] = v[0] + e[0], v[2] = v[0] - e[2];
        n = cross(e[0], e[1]);
        length = sum(e[0]) + sum(e[1]);
        blur = length * (floats(kMeshMargin) * (length + sum(v[0]) + floats(size)) + floats(slack) * length);
    }
};

Floats3 corner_of(const MeshPacket& packet, int k)
{
    return {four_at(packet.at[k][0]), four_at(packet.at[k][1]), four_at(packet.at[k][2])};
}
Floats3 from(const Floats3& a, const float (&centre)[3])
{
    return {a.x - floats(centre[0]), a.y - floats(centre[1]), a.z - floats(centre[2])};
}

// In the solid's own frame.
[[gnu::always_inline]] inline Corners in_frame(const MeshPacket& packet, const float (&centre)[3],
                                               const float (&axis)[3][3], float slack, float size)
{
    const Floats3 a = corner_of(packet, 0), b = corner_of(packet, 1), c = corner_of(packet, 2);
    Corners t;
    t.v[0] = turned(from(a, centre), axis);
    t.e[0] = turned(b - a, axis), t.e[1] = turned(c - b, axis);
    t.e[2] = -(t.e[0] + t.e[1]);
    t.finish(slack, size);
    return t;
}

}  // namespace

MeshProbe::MeshProbe(const SolidProbe& solid, Vec3 centre_in_frame, Real scale) : kind_(solid.kind)
{
    constexpr Real kMore = Real(1.00001);
    const Real margin = scale * solid.slack + 2 * Real(kMeshMargin);
    for (int i = 0; i < 3; ++i) {
        centre_[i] = float(centre_in_frame[i]);
        const Vec3 axis = solid.R.column(i);
        for (int k = 0; k < 3; ++k) axis_[i][k] = float(axis[k]);
        half_[i] = float(kMore * scale * solid.half[i] + margin);
    }
    round_ = float(kMore * scale * solid.round + margin);
    slack_ = float(scale * solid.slack);
    size_ = float(scale * (solid.half.x + solid.half.y + solid.half.z + solid.round));
}

// By the height above the plane and by how far the centre lies beyond an edge, which is out . v_k for out =
// e_k x n; all three follow from m = n x v_0. The distance in the plane of n and out together is the root of
// the sum of squares. Near a corner the true distance is larger, which is not considered.
unsigned MeshProbe::ball_meets(const MeshPacket& packet, unsigned candidates) const
{
    const Floats3 a = corner_of(packet, 0), b = corner_of(packet, 1), c = corner_of(packet, 2);
    const Floats3 v = from(a, centre_), e[3] = {b - a, c - b, a - c};
    const Floats3 n = cross(e[0], e[1]), m = cross(n, v);
    const Floats zero = Floats{}, n2 = dot(n, n);
    const Floats length = sum(e[0]) + sum(e[1]);
    const Floats blur =
        length * (floats(kMeshMargin) * (length + sum(v) + floats(size_)) + floats(slack_) * length);
    const Floats height = larger(magnitude(dot(n, v)) - blur, zero);
    const Floats reach2 = floats(round_ * round_) * n2 - height * height;  // over the square of n
    const Floats more = floats(2) * length * blur;
    Ints apart = reach2 < zero;
    for (int k = 0; k < 3; ++k) {
        const Floats on = dot(m, e[k]), inward = k == 1 ? on + n2 : on;
        const Floats beyond = larger(-inward - more, zero);
        apart |= beyond * beyond > larger(reach2, zero) * dot(e[k], e[k]);
    }
    return candidates & ~bits(apart);
}

unsigned MeshProbe::box_meets(const MeshPacket& packet, unsigned candidates) const
{
    const Corners t = in_frame(packet, centre_, axis_, slack_, size_);
    const Floats hx = floats(half_[0]), hy = floats(half_[1]), hz = floats(half_[2]);
    Ints apart =
        (smallest(t.v[0].x, t.v[1].x, t.v[2].x) > hx) | (largest(t.v[0].x, t.v[1].x, t.v[2].x) < -hx);
    apart |= (smallest(t.v[0].y, t.v[1].y, t.v[2].y) > hy) | (largest(t.v[0].y, t.v[1].y, t.v[2].y) < -hy);
    apart |= (smallest(t.v[0].z, t.v[1].z, t.v[2].z) > hz) | (largest(t.v[0].z, t.v[1].z, t.v[2].z) < -hz);
    const Floats reach = hx * magnitude(t.n.x) + hy * magnitude(t.n.y) + hz * magnitude(t.n.z);
    apart |= magnitude(dot(t.n, t.v[0])) - t.blur > reach;
    if (!(candidates & ~bits(apart))) return 0;
    for (int k = 0; k < 3; ++k) {
        const Floats3 &p = t.v[k], &e = t.e[k], &q = t.v[(k + 2) % 3];
        const Floats x = magnitude(e.x), y = magnitude(e.y), z = magnitude(e.z);
        const auto across = [&apart](Floats on, Floats off, Floats r) {
            apart |= (smaller(on, off) > r) | (larger(on, off) < -r);
        };
        across(e.y * p.z - e.z * p.y, e.y * q.z - e.z * q.y, hy * z + hz * y);
        across(e.z * p.x - e.x * p.z, e.z * q.x - e.x * q.z, hz * x + hx * z);
        across(e.x * p.y - e.y * p.x, e.x * q.y - e.y * q.x, hx * y + hy * x);
    }
    return candidates & ~bits(apart);
}

unsigned MeshProbe::rod_meets(const MeshPacket& packet, unsigned candidates) const
{
    const Corners t = in_frame(packet, centre_, axis_, slack_, size_);
    const bool flat = kind_ == ProbeKind::kCylinder;
    const Floats zero = Floats{}, half = floats(half_[2]), radius = floats(round_);
    const Floats end = flat ? half : half + radius, radius2 = radius * radius;
    Ints apart =
        (smallest(t.v[0].z, t.v[1].z, t.v[2].z) > end) | (largest(t.v[0].z, t.v[1].z, t.v[2].z) < -end);
    const auto reach = [&](const Floats3& n) {
        const Floats across2 = n.x * n.x + n.y * n.y;
        return half * magnitude(n.z) + radius * root(flat ? across2 : across2 + n.z * n.z);
    };
    apart |= magnitude(dot(t.n, t.v[0])) - t.blur > reach(t.n);
    if (!(candidates & ~bits(apart))) return 0;
    for (int k = 0; k < 3; ++k) {
        const Floats3 &p = t.v[k], &e = t.e[k], &back = t.e[(k + 2) % 3], &q = t.v[(k + 2) % 3];
        const Floats3 out = cross(e, t.n);
        apart |= -dot(out, p) - floats(2) * t.length * t.blur > reach(out);
        // Seen along the axis.
        apart |= (p.x * p.x + p.y * p.y > radius2) & (p.x * e.x + p.y * e.y >= zero) &
                 (p.x * back.x + p.y * back.y <= zero);
        const Floats on = e.x * p.y - e.y * p.x, off = e.x * q.y - e.y * q.x;
        apart |= (on * on > radius2 * (e.x * e.x + e.y * e.y)) & ((off - on) * on >= zero);
    }
    return candidates & ~bits(apart);
}

}  // namespace epode
