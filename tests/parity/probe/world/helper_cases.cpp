// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The collision helpers a client may call directly: closest points of two segments, the separating axis test
// of two boxes, and dBoxBox with its normal, depth, code and contact points.
#include "case_list.h"

#include <algorithm>
#include <cmath>

namespace parity {
namespace {

void fill(dVector3 out, const Vec3& v)
{
    out[0] = v.x;
    out[1] = v.y;
    out[2] = v.z;
    out[3] = 0;
}

double distance(const dVector3 a, const dVector3 b)
{
    return std::sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) +
                     (a[2] - b[2]) * (a[2] - b[2]));
}

PARITY_CASE(geom_closest_segments)
{
    for (int i = 0; i < 300; ++i) {
        dVector3 a1, a2, b1, b2, p = {0, 0, 0, 0}, q = {0, 0, 0, 0};
        fill(a1, rng.in_cube(1));
        fill(a2, rng.in_cube(1));
        fill(b1, rng.in_cube(1));
        fill(b2, rng.in_cube(1));
        dClosestLineSegmentPoints(a1, a2, b1, b2, p, q);
        out.put("p" + std::to_string(i), p, 3);
        out.put("q" + std::to_string(i), q, 3);
    }
}

// Parallel segments have many closest pairs; their distance is one.
PARITY_CASE(geom_closest_parallel_segments)
{
    for (int i = 0; i < 100; ++i) {
        out.open_block("t" + std::to_string(i));
        const Vec3 d = rng.direction(), at = rng.in_cube(1), other = rng.in_cube(1);
        const double length = rng.range(0.1, 2), b_length = rng.sign() * rng.range(0.1, 2);
        dVector3 a1, a2, b1, b2, p = {0, 0, 0, 0}, q = {0, 0, 0, 0};
        fill(a1, at);
        fill(a2, {at.x + length * d.x, at.y + length * d.y, at.z + length * d.z});
        fill(b1, other);
        fill(b2, {other.x + b_length * d.x, other.y + b_length * d.y, other.z + b_length * d.z});
        dClosestLineSegmentPoints(a1, a2, b1, b2, p, q);
        out.put("distance", {distance(p, q)});
    }
}

struct BoxPose {
    dVector3 p = {0, 0, 0, 0}, side = {0, 0, 0, 0};
    dMatrix3 R = {0};
};

BoxPose random_box(Random& random, double spread)
{
    BoxPose box;
    const Quat r = random.rotation(3.1);
    const dQuaternion q = {r.w, r.x, r.y, r.z};
    fill(box.p, random.in_cube(spread));
    fill(box.side, {random.range(0.3, 2), random.range(0.3, 2), random.range(0.3, 2)});
    dRfromQ(box.R, q);
    return box;
}

PARITY_CASE(geom_box_touches_box)
{
    for (int i = 0; i < 500; ++i) {
        const BoxPose a = random_box(rng, 0.7), b = random_box(rng, 0.7);
        out.put("t" + std::to_string(i),
                {static_cast<double>(dBoxTouchesBox(a.p, a.R, a.side, b.p, b.R, b.side))});
    }
}

PARITY_CASE(geom_box_box)
{
    for (int i = 0; i < 300; ++i) {
        out.open_block("t" + std::to_string(i));
        const BoxPose a = random_box(rng, 0.5), b = random_box(rng, 0.5);
        dContactGeom contacts[8] = {};
        dVector3 normal = {0, 0, 0, 0};
        dReal depth = 0;
        int code = 0;
        const int count = dBoxBox(a.p, a.R, a.side, b.p, b.R, b.side, normal, &depth, &code, 8, contacts,
                                  sizeof(dContactGeom));
        out.put("hit", {count > 0 ? 1.0 : 0.0});
        if (count > 0) {
            out.put("normal", normal, 3);
            out.put("depth", {depth});
            out.put("code", {static_cast<double>(code)});
            double deepest = 0;
            for (int k = 0; k < count; ++k) { deepest = std::max(deepest, contacts[k].depth); }
            out.put("deepest", {deepest});
        }
    }
}

}  // namespace
}  // namespace parity
