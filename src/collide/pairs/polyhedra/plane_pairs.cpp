// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Box, capsule and cylinder against a plane: the half-space n . x <= d is never passed through, so the
// contacts are simply the lowest points of the solid, each with its own depth d - n . x. Cylinder: the lower
// end's rim carries the contacts. Four rim points at fixed directions of the body are used, and as the
// cylinder tilts, the one nearest to the true lowest point is turned towards it, fully by a tilt of
// kFullTilt; so the points move continuously, and from there on the deepest point is exact. Lying on its
// side, the lowest points of both rims.
#include "collide/pairs/at_once.h"

namespace epode {

namespace {

constexpr Real kFullTilt = Real(1e-3);

class Below {
  public:
    explicit Below(const Plane& plane) : plane_(plane) {}
    void offer(Vec3 p)
    {
        const Real depth = plane_.d - dot(plane_.normal, p);
        if (depth >= 0) points_[count_] = p, depths_[count_++] = depth;
    }
    void deliver(ContactSink& sink) const
    {
        if (count_ > sink.capacity() - sink.count()) return deliver_best(sink);
        for (int i = 0; i < count_; ++i) sink.add({points_[i], plane_.normal, depths_[i]});
    }

  private:
    [[gnu::noinline]] void deliver_best(ContactSink& sink) const
    {
        ContactPoint points[4];
        for (int i = 0; i < count_; ++i) points[i] = {points_[i], plane_.normal, depths_[i]};
        sink.add_manifold({points, std::size_t(count_)});
    }

    const Plane& plane_;
    union {
        Vec3 points_[4];  // in a union: left unwritten until offered
    };
    Real depths_[4];
    int count_ = 0;
};

// Four rim directions about the axis (unit, local xy), the one nearest to `low` turned towards it by
// `weight`.
void rim_directions(Real low_x, Real low_y, Real weight, Real (&out)[4][2])
{
    constexpr Real kX[4] = {-1, 1, 0, 0}, kY[4] = {0, 0, -1, 1};
    int nearest = 0;
    for (int i = 0; i < 4; ++i) {
        out[i][0] = kX[i], out[i][1] = kY[i];
        if (kX[i] * low_x + kY[i] * low_y > kX[nearest] * low_x + kY[nearest] * low_y) nearest = i;
    }
    const Real x = kX[nearest] + weight * (low_x - kX[nearest]),
               y = kY[nearest] + weight * (low_y - kY[nearest]);
    const Real k = std::sqrt(x * x + y * y);
    out[nearest][0] = x / k, out[nearest][1] = y / k;
}

// The four deepest corners of a rod that comes down on one end are those of this end; it lands on the side that looks down most.
[[gnu::cold]] void add_lowest_side(Vec3 middle, const Vec3 (&sides)[3][2], Vec3 n, const Plane& plane,
                                   ContactSink& sink)
{
    const Vec3 slant = abs(n);
    const int k = slant.x >= slant.y && slant.x >= slant.z ? 0 : slant.y >= slant.z ? 1 : 2;
    const Vec3 side = middle + sides[k][n[k] > 0];
    for (const Vec3& one : sides[(k + 1) % 3])
        for (const Vec3& other : sides[(k + 2) % 3]) {
            const Vec3 corner = side + (one + other);
            const Real depth = plane.d - dot(plane.normal, corner);
            if (depth >= -sink.margin()) sink.add({corner, plane.normal, depth});
        }
}

}  // namespace

void box_plane(const Box& a, const Pose& A, const Plane& b, const Pose&, ContactSink& sink)
{
    const Vec3 n = transposed_times(A.R, b.normal);
    const Real clearance = dot(b.normal, A.p) - b.d;
    const Vec3 lean = scale(n, a.half), size = abs(lean);
    const Real reach = size.x + size.y + size.z;
    if (clearance > reach) return;
    // n . v of the vertices v with x > 0; those of the others are the same, turned round.
    const Real sums[4] = {lean.x + lean.y + lean.z, lean.x + lean.y - lean.z, lean.x - lean.y + lean.z,
                          lean.x - lean.y - lean.z};
    const Real tie = 16 * kEpsilon * (reach + std::fabs(clearance));
    Real depths[4];  // deepest first, ties by vertex number
    int vertices[4], count = 0, near = 0;
    for (int i = 0; i < 8; ++i) {
        const Real depth = -(clearance + (i & 4 ? -sums[7 - i] : sums[i]));
        if (!(depth >= -sink.margin())) continue;
        ++near;
        if (count == 4 && depth <= depths[3] + tie) continue;
        int k = count < 4 ? count++ : 3;
        for (; k > 0 && depth > depths[k - 1] + tie; --k)
            depths[k] = depths[k - 1], vertices[k] = vertices[k - 1];
        depths[k] = depth, vertices[k] = i;
    }
    const Vec3 x = a.half.x * A.R.column(0), y = a.half.y * A.R.column(1), z = a.half.z * A.R.column(2);
    const Vec3 sides[3][2] = {{x, -x}, {y, -y}, {z, -z}};
    if (near > 4 && depths[3] < 0) return add_lowest_side(A.p, sides, n, b, sink);
    for (int k = 0; k < count; ++k) {
        const int i = vertices[k];
        sink.add({A.p + (sides[0][i >> 2] + sides[1][i >> 1 & 1] + sides[2][i & 1]), b.normal, depths[k]});
    }
}

void capsule_plane(const Capsule& a, const Pose& A, const Plane& b, const Pose&, ContactSink& sink)
{
    const Vec3 half = a.half_length * A.R.column(2);
    Below ends(b);
    ends.offer(A.p - half - a.radius * b.normal);
    ends.offer(A.p + half - a.radius * b.normal);
    ends.deliver(sink);
}

void cylinder_plane(const Cylinder& a, const Pose& A, const Plane& b, const Pose&, ContactSink& sink)
{
    const Vec3 n = transposed_times(A.R, b.normal);
    const Real tilt = std::sqrt(n.x * n.x + n.y * n.y);
    const Real end = n.z > 0 ? -a.half_length : a.half_length;
    const Real low_x = tilt > 0 ? -n.x / tilt : Real(-1), low_y = tilt > 0 ? -n.y / tilt : Real(0);
    Below found(b);
    if (tilt > std::fabs(n.z)) {  // lying
        found.offer(A.to_world({a.radius * low_x, a.radius * low_y, end}));
        found.offer(A.to_world({a.radius * low_x, a.radius * low_y, -end}));
    } else {
        const Real weight = tilt < kFullTilt ? tilt / kFullTilt : Real(1);
        Real rim[4][2];
        rim_directions(low_x, low_y, weight, rim);
        for (const auto& d : rim) found.offer(A.to_world({a.radius * d[0], a.radius * d[1], end}));
    }
    found.deliver(sink);
}

EPODE_AT_ONCE(Box, Plane, box_plane)
EPODE_AT_ONCE(Capsule, Plane, capsule_plane)
EPODE_AT_ONCE(Cylinder, Plane, cylinder_plane)

}  // namespace epode
