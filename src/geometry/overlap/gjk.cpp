// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// GJK: see gjk.h. At most four vertices are kept with the points of a and b they come from; weights of the
// nearest point give the closest points. Iterations are bounded; each must shorten the vector to the origin.
#include "geometry/overlap/gjk.h"

#include <initializer_list>

namespace epode {

namespace {

struct Vertex {
    Vec3 c, on_a, on_b;
};

struct Simplex {
    Vertex v[4];
    Real weight[4] = {1, 0, 0, 0};
    int count = 0;
    Vec3 nearest() const
    {
        Vec3 p;
        for (int i = 0; i < count; ++i) p += weight[i] * v[i].c;
        return p;
    }
};

// One face of the tetrahedron or the whole simplex: indices and weights of the nearest point.
struct Part {
    int index[3];
    Real weight[3];
    int count = 0;
    Real distance2 = kInf;
};

void consider(const Simplex& s, std::initializer_list<int> index, std::initializer_list<Real> weight,
              Part& best)
{
    Vec3 p;
    int k = 0;
    for (const Real w : weight) p += w * s.v[index.begin()[k++]].c;
    const Real d = length2(p);
    if (!(d < best.distance2)) return;
    best.distance2 = d;
    best.count = 0;
    for (const int i : index)
        best.weight[best.count] = weight.begin()[best.count], best.index[best.count++] = i;
}

void consider_edge(const Simplex& s, int i, int j, Part& best)
{
    const Vec3 d = s.v[j].c - s.v[i].c;
    const Real dd = length2(d), t = -dot(s.v[i].c, d);
    if (t > 0 && t < dd) consider(s, {i, j}, {1 - t / dd, t / dd}, best);
}

// Inside the triangle when all three weights are positive; its edges are tried separately.
void consider_triangle(const Simplex& s, int i, int j, int k, Part& best)
{
    const Vec3 a = s.v[i].c, b = s.v[j].c, c = s.v[k].c;
    const Vec3 n = cross(b - a, c - a);
    const Real nn = length2(n);
    const Real wa = dot(n, cross(b, c)), wb = dot(n, cross(c, a)), wc = dot(n, cross(a, b));
    if (wa > 0 && wb > 0 && wc > 0 && nn > 0) {
        const Real sum = wa + wb + wc;
        consider(s, {i, j, k}, {wa / sum, wb / sum, wc / sum}, best);
    }
}

// Of a flat tetrahedron rounding alone would tell the sides.
bool encloses(const Simplex& s)
{
    if (s.count < 4) return false;
    constexpr Real kFlat = 1024 * kEpsilon * kEpsilon;
    constexpr int kFaces[4][4] = {{0, 1, 2, 3}, {0, 2, 3, 1}, {0, 3, 1, 2}, {1, 3, 2, 0}};
    for (const auto& f : kFaces) {
        const Vec3 a = s.v[f[0]].c, n = cross(s.v[f[1]].c - a, s.v[f[2]].c - a);
        const Vec3 edge = s.v[f[3]].c - a;
        const Real apex = dot(n, edge), origin = -dot(n, a);
        if (!(apex * apex > kFlat * length2(n) * length2(edge)) || apex * origin < 0) return false;
    }
    return true;
}

// Reduces the simplex to the smallest part that holds its point nearest to the origin.
void reduce(Simplex& s)
{
    Part best;
    for (int i = 0; i < s.count; ++i) consider(s, {i}, {Real(1)}, best);
    for (int i = 0; i < s.count; ++i)
        for (int j = i + 1; j < s.count; ++j) consider_edge(s, i, j, best);
    for (int i = 0; i < s.count; ++i)
        for (int j = i + 1; j < s.count; ++j)
            for (int k = j + 1; k < s.count; ++k) consider_triangle(s, i, j, k, best);
    Vertex kept[3];
    for (int i = 0; i < best.count; ++i) kept[i] = s.v[best.index[i]];
    for (int i = 0; i < best.count; ++i) s.v[i] = kept[i], s.weight[i] = best.weight[i];
    s.count = best.count;
}

Vertex support(const ConvexView& a, const ConvexView& b, Vec3 d)
{
    const Vec3 x = a.support(d), y = b.support(-d);
    return {x - y, x, y};
}

}  // namespace

Distance gjk_distance(const ConvexView& a, const ConvexView& b, Real limit, Real tolerance)
{
    constexpr int kIterations = 64;
    Simplex s;
    s.v[0] = support(a, b, b.pose.p - a.pose.p);
    s.count = 1;
    Vec3 nearest = s.v[0].c;
    const Real size = a.size + b.size + length(b.pose.p - a.pose.p);
    Distance out;
    for (int i = 0; i < kIterations; ++i) {
        const Real d2 = length2(nearest);
        if (!(d2 > 64 * kEpsilon * kEpsilon * size * size)) return out;  // touching
        const Vertex next = support(a, b, -nearest);
        const Real bound = dot(nearest, next.c);  // |nearest| times a lower bound of the distance
        if (bound > 0 && bound * bound > limit * limit * d2) {
            out.distance = bound / std::sqrt(d2);
            return out;
        }
        if (d2 - bound <= tolerance * d2) break;
        const Simplex before = s;
        s.v[s.count++] = next;
        if (bound <= 0 && encloses(s)) return out;  // else a plane keeps the origin out
        reduce(s);
        const Vec3 shorter = s.nearest();
        if (!(length2(shorter) < d2)) {  // no progress: rounding has the last word
            s = before;
            break;
        }
        nearest = shorter;
    }
    out.distance = length(nearest);
    for (int i = 0; i < s.count; ++i) {
        out.on_a += s.weight[i] * s.v[i].on_a;
        out.on_b += s.weight[i] * s.v[i].on_b;
    }
    return out;
}

}  // namespace epode
