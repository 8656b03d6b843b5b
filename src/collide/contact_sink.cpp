// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Writing contacts into the client's array, and thinning a manifold to four points. The choice follows the
// usual reasoning about support polygons: the deepest point carries the load, the farthest from it gives the
// longest lever, the next two span the largest area on either side of that line. Sorting by depth alone was
// rejected: it keeps four neighbours and the body tips.
// A later point must beat an earlier one by a small margin, so that rounding in a symmetric manifold does not
// swap the chosen points from one step to the next.
#include "collide/contact_sink.h"

#include "base/check.h"

namespace epode {

namespace {

constexpr int kKept = 4;
constexpr Real kTie = Real(1e-3);       // of a distance or an area
constexpr Real kDepthTie = Real(1e-5);  // of the manifold's span, for depths

Real span_of(std::span<const ContactPoint> points)
{
    Real largest = 0;
    for (const ContactPoint& p : points) {
        const Real d = length2(p.position - points[0].position);
        if (d > largest) largest = d;
    }
    return std::sqrt(largest);
}

int deepest(std::span<const ContactPoint> points, Real slack)
{
    Real most = points[0].depth;
    for (const ContactPoint& p : points)
        if (p.depth > most) most = p.depth;
    int i = 0;
    while (points[std::size_t(i)].depth < most - slack) ++i;
    return i;
}

// The index with the largest score among the points; the first one within the tie margin of the best.
template <class Score>
int best(int count, const Score& score)
{
    Real most = 0;
    for (int i = 0; i < count; ++i) {
        const Real s = score(i);
        if (s > most) most = s;
    }
    if (!(most > 0)) return -1;
    int i = 0;
    while (score(i) < most * (1 - kTie)) ++i;
    return i;
}

}  // namespace

void ContactSink::add_manifold(std::span<const ContactPoint> points)
{
    const int count = int(points.size());
    const int left = room_ - count_;
    const int wanted = left < kKept ? left : kKept;
    if (count <= wanted) {
        for (const ContactPoint& p : points) add(p);
        return;
    }
    if (wanted <= 0) return;
    const auto at_index = [&](int i) -> const ContactPoint& { return points[std::size_t(i)]; };
    const Vec3 n = points[0].normal;
    const ContactPoint& first = at_index(deepest(points, kDepthTie * span_of(points)));
    add(first);
    if (wanted < 2) return;
    const int far = best(count, [&](int i) { return length2(at_index(i).position - first.position); });
    if (far < 0) return;
    const Vec3 line = at_index(far).position - first.position;
    add(at_index(far));
    const auto side = [&](int i) { return dot(n, cross(line, at_index(i).position - first.position)); };
    const Real thin = Real(1e-6) * length2(line);  // a point on the line adds nothing
    for (int sign : {1, -1}) {
        const int k = best(count, [&](int i) {
            const Real s = sign * side(i);
            return s > thin ? s : Real(0);
        });
        if (k >= 0 && !add(at_index(k))) return;
    }
}

}  // namespace epode
