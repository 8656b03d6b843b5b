// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Capsule against capsule: balls at the closest points of the two axes; when the axes are nearly parallel,
// balls at both ends of the stretch where the capsules lie side by side, so that one rests on the other
// without rocking.
#include "collide/pairs/at_once.h"
#include "collide/pairs/round/ball_contact.h"
#include "geometry/closest.h"

namespace epode {

namespace {

constexpr Real kParallel = Real(1e-5);  // of the squared sine between the axes; ODE's

struct Axis {
    Vec3 middle, along;
    Real half;
    Vec3 at(Real t) const { return middle + t * along; }
    bool within(Vec3 p) const { return std::fabs(dot(along, p - middle)) < Real(0.999) * half; }
    Real nearest(Vec3 p) const
    {
        const Real t = dot(along, p - middle);
        return t > half ? half : t < -half ? -half : t;
    }
};

// Normal when the axes meet: across both.
Vec3 way_out(Vec3 u, Vec3 v)
{
    Vec3 n = cross(u, v);
    if (length2(n) > Real(1e-12) && normalize(n)) return n.x < 0 ? -n : n;
    n = Vec3{1, 0, 0} - u.x * u;
    if (length2(n) > Real(1e-6) && normalize(n)) return n;
    plane_space(u, n, v);
    return n;
}

// Axes that cross between their ends: the normal is perpendicular to both. The vector between the closest
// points has the same direction only while it is long compared with its rounding, and over a capsule's length
// a small lean has a large effect.
bool crossed(Vec3 p, Real rp, Vec3 q, Real rq, Vec3 across, ContactPoint& out)
{
    const Real apart = dot(across, p - q), distance = std::fabs(apart);
    if (distance > rp + rq) return false;
    out.normal = apart < 0 ? -across : across;
    out.depth = rp + rq - distance;
    out.position = p + Real(0.5) * (rq - rp - distance) * out.normal;
    return true;
}

}  // namespace

void capsule_capsule(const Capsule& a, const Pose& A, const Capsule& b, const Pose& B, ContactSink& sink)
{
    const Axis u = {A.p, A.R.column(2), a.half_length}, v = {B.p, B.R.column(2), b.half_length};
    Vec3 p, q;
    closest_segment_points(u.at(-u.half), u.at(u.half), v.at(-v.half), v.at(v.half), p, q);
    const Real c = dot(u.along, v.along);
    const bool parallel = !(1 - c * c > kParallel), crossing = !parallel && u.within(p) && v.within(q);
    const auto across = [&] { return way_out(u.along, v.along); };
    ContactPoint deepest;
    if (!(crossing ? crossed(p, a.radius, q, b.radius, across(), deepest)
                   : ball_contact(p, a.radius, q, b.radius, across, deepest)))
        return;
    if (!parallel) {
        sink.add(deepest);
        return;
    }
    const Real middle = dot(u.along, v.middle - u.middle), reach = v.half * std::fabs(c);
    const Real lo = middle - reach > -u.half ? middle - reach : -u.half;
    const Real hi = middle + reach < u.half ? middle + reach : u.half;
    ContactPoint ends[2];
    int count = 0;
    Real largest = -1;
    if (hi - lo > Real(1e-6) * (u.half + v.half))
        for (const Real t : {lo, hi}) {  // one normal for both, so that a turn by rounding cannot part them
            const Vec3 x = u.at(t), n = deepest.normal;
            const Real gap = dot(n, x - v.at(v.nearest(x))), depth = a.radius + b.radius - gap;
            if (depth < 0) continue;
            if (depth > largest) largest = depth;
            ends[count++] = {x + Real(0.5) * (b.radius - a.radius - gap) * n, n, depth};
        }
    // One point when the axes cross instead of running side by side.
    if (count < 2 || largest < deepest.depth - Real(1e-5) * (a.radius + b.radius))
        sink.add(deepest);
    else
        sink.add_manifold({ends, 2});
}

EPODE_AT_ONCE(Capsule, Capsule, capsule_capsule)

}  // namespace epode
