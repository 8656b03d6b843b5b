// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "geometry/overlap/separating_direction.h"

#include <cmath>

namespace epode {
namespace {

constexpr int kIterations = 12;
constexpr Real kGoodEnough = Real(0.5);  // of the distance

// The point of a triangle's, edge's or corner's convex hull nearest to the origin, and what it stands on.
struct Nearest {
    Vec3 point, corners[3];
    int count = 0;
    Real distance2 = kInf;

    bool offer(Vec3 p)
    {
        const Real d = length2(p);
        if (!(d < distance2)) return false;
        distance2 = d, point = p;
        return true;
    }
    void add(Vec3 a)
    {
        if (offer(a)) count = 1, corners[0] = a;
    }
    void add(Vec3 a, Vec3 b)
    {
        const Vec3 d = b - a;
        const Real dd = length2(d), t = -dot(a, d);
        if (t > 0 && t < dd && offer(a + (t / dd) * d)) count = 2, corners[0] = a, corners[1] = b;
    }
    void add(Vec3 a, Vec3 b, Vec3 c)
    {
        const Vec3 n = cross(b - a, c - a);
        const Real nn = length2(n);
        if (!(nn > 0) || dot(n, cross(b, c)) <= 0 || dot(n, cross(c, a)) <= 0 || dot(n, cross(a, b)) <= 0)
            return;
        if (offer((dot(n, a) / nn) * n)) count = 3, corners[0] = a, corners[1] = b, corners[2] = c;
    }
};

// With the newest point, which the next nearest point cannot do without.
Nearest with_newest(const Nearest& was, Vec3 c)
{
    Nearest out;
    out.add(c);
    for (int i = 0; i < was.count; ++i) {
        out.add(was.corners[i], c);
        for (int j = 0; j < i; ++j) out.add(was.corners[j], was.corners[i], c);
    }
    return out;
}

}  // namespace

Vec3 separating_direction(const ConvexView& a, const ConvexView& b, Vec3 guess, Real hair)
{
    const auto farthest = [&](Vec3 d) { return a.support(-d) - b.support(d); };
    const Real touching = a.radius + b.radius + hair;
    Nearest nearest;
    Vec3 best;
    Real largest_gap = touching;
    nearest.add(farthest(guess));
    if (normalize(guess) && dot(guess, nearest.point) > largest_gap) return guess;
    for (int i = 0; i < kIterations; ++i) {
        const Real distance = std::sqrt(nearest.distance2);  // of the cores, or more
        if (!(distance > touching)) break;
        const Vec3 n = (1 / distance) * nearest.point, c = farthest(n);
        const Real gap = dot(n, c);
        if (gap > largest_gap) largest_gap = gap, best = n;
        if (gap - touching >= kGoodEnough * (distance - touching)) break;
        const Nearest next = with_newest(nearest, c);
        if (!(next.distance2 < nearest.distance2)) break;
        nearest = next;
    }
    return best;
}

}  // namespace epode
