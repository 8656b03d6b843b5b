// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A ray against any convex solid, by support points alone. From a start o outside, the plane through the
// solid's support point along n, n being the direction from the nearest point to o, keeps the solid behind
// it; the ray reaches the plane at t = (h(n) - n . o) / (n . d), which is no later than the hit. From there
// on the same again: Newton's method, quadratic where the surface is smooth. (Van den Bergen 2004 mixes this
// with the simplex of GJK; apart, both stay what they are.) A ray that starts inside leaves where the
// reversed ray, from beyond the solid, enters. The normal at the hit x is the fixed point of looking at x + g
// n from outside, as in geometry/overlap/curved_overlap.h.
#include "collide/pairs/pairs.h"
#include "collide/pairs/solid_pairs.h"
#include "collide/solid_type.h"
#include "geometry/overlap/gjk.h"

namespace epode {
namespace {

constexpr int kSteps = 64, kTurns = 8;
constexpr Real kOn = 64 * kEpsilon;                        // of the size: this near counts as on the surface
constexpr Real kLook = kSingle ? Real(1e-2) : Real(1e-3);  // of the size: from how far the normal is seen
constexpr Sphere kPoint{0};

struct WorldLine {
    Vec3 o, d;
    Vec3 at(Real t) const { return o + t * d; }
};

// From the solid to x; zero when x is inside, or so near that no direction can be told.
Real gap_at(const ConvexView& solid, Vec3 x, Vec3& outward)
{
    Pose here;
    here.p = x;
    const Distance to = gjk_distance(view_of(kPoint, here), solid);
    outward = to.on_a - to.on_b;
    if (!(to.distance > 0) || !normalize(outward)) return 0;
    const Real gap = to.distance - solid.radius;
    return gap > 0 ? gap : Real(0);
}

Real height(const ConvexView& solid, Vec3 n) { return dot(n, solid.support(n)) + solid.radius; }

struct Entry {
    Real t = 0;
    Vec3 normal;  // of the last plane
};

// Where the line, which begins outside, comes in; false when it passes.
bool enters(const ConvexView& solid, const WorldLine& line, Real on, Entry& out)
{
    Vec3 n;
    for (int i = 0; i < kSteps; ++i) {
        const Vec3 x = line.at(out.t);
        if (gap_at(solid, x, n) <= on) return true;
        const Real closing = -dot(n, line.d);
        if (!(closing > 0)) return false;
        out.normal = n;
        const Real way = (dot(n, x) - height(solid, n)) / closing;
        if (!(way > 0)) return true;
        out.t += way;
    }
    return true;  // so grazing that it hardly matters
}

Vec3 normal_at(const ConvexView& solid, Vec3 x, Vec3 n)
{
    const Real look = kLook * (solid.size + solid.radius);
    for (int i = 0; i < kTurns; ++i) {
        Vec3 m;
        if (!(gap_at(solid, x + look * n, m) > 0)) return n;
        const Real turned2 = length2(m - n);
        n = m;
        if (turned2 <= 16 * kEpsilon * kEpsilon) break;
    }
    return n;
}

}  // namespace

void ray_solid(const Geom& ray, const Pose& R, const Geom& b, const Pose& B, ContactSink& sink)
{
    const Real reach = static_cast<const ShapeGeom<Ray>&>(ray).shape.length;
    if (!(reach >= 0)) return;
    const ConvexView solid = solid_view(b, B);
    const WorldLine line = {R.p, R.R.column(2)};
    const Real size = solid.size + solid.radius, middle = dot(solid.pose.p - line.o, line.d);
    if (length2(line.at(middle) - solid.pose.p) > Real(1.01) * size * size) return;
    if (middle - Real(1.01) * size > reach || middle + Real(1.01) * size < 0) return;
    // From near enough that distances keep their digits.
    const Real before = middle - 2 * size, behind = middle + 2 * size, skin = kOn * size;
    Entry in, out;
    if (!enters(solid, {line.at(before), line.d}, skin, in)) return;
    if (before + in.t >= -skin) {
        const Real t = before + in.t > 0 ? before + in.t : Real(0);
        if (t <= reach) sink.add({line.at(t), normal_at(solid, line.at(t), in.normal), t});
        return;
    }
    if (!enters(solid, {line.at(behind), -line.d}, skin, out)) return;
    const Real t = behind - out.t;
    if (t < -skin || t > reach) return;
    const Vec3 x = line.at(t > 0 ? t : Real(0)), outward = normal_at(solid, x, out.normal);
    sink.add({x, t > skin ? -outward : outward, t > 0 ? t : Real(0)});
}

}  // namespace epode
