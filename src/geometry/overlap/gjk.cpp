// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// GJK: see gjk.h. At most four vertices are kept with the points of a and b they come from; weights of the
// nearest point give the closest points. Iterations are bounded; each must shorten the vector to the origin.
// The simplex is computed in doubles: from the corners of a long wall floats cannot tell a gap of 1 cm, nor its direction.
#include "geometry/overlap/gjk.h"

#include <initializer_list>
#include <type_traits>

#include "geometry/overlap/rim_distance.h"
#include "simd/pack_algebra.h"

namespace epode {

namespace {

using Point = std::conditional_t<kSingle, Vec3Of<double>, Vec3>;

Point exact(Vec3 v) { return {v.x, v.y, v.z}; }
Vec3 rounded(Point p) { return {Real(p.x), Real(p.y), Real(p.z)}; }
double norm2(Point p) { return dot(p, p); }

struct Vertex {
    Point c;
    Vec3 on_a, on_b;
};

struct Simplex {
    Vertex v[4];
    double weight[4] = {1, 0, 0, 0};
    int count = 0;
    Point nearest() const
    {
        Point p{};
        for (int i = 0; i < count; ++i) p = p + weight[i] * v[i].c;
        return p;
    }
};

// One face of the tetrahedron or the whole simplex: indices and weights of the nearest point.
struct Part {
    int index[3];
    double weight[3];
    int count = 0;
    double distance2 = double(kInf);
};

void consider(const Simplex& s, std::initializer_list<int> index, std::initializer_list<double> weight,
              Part& best)
{
    Point p{};
    int k = 0;
    for (const double w : weight) p = p + w * s.v[index.begin()[k++]].c;
    const double d = norm2(p);
    if (!(d < best.distance2)) return;
    best.distance2 = d;
    best.count = 0;
    for (const int i : index)
        best.weight[best.count] = weight.begin()[best.count], best.index[best.count++] = i;
}

void consider_edge(const Simplex& s, int i, int j, Part& best)
{
    const Point d = s.v[j].c - s.v[i].c;
    const double dd = norm2(d), t = -dot(s.v[i].c, d);
    if (t > 0 && t < dd) consider(s, {i, j}, {1 - t / dd, t / dd}, best);
}

// Inside the triangle when all three weights are positive; its edges are tried separately.
void consider_triangle(const Simplex& s, int i, int j, int k, Part& best)
{
    const Point a = s.v[i].c, b = s.v[j].c, c = s.v[k].c;
    const Point n = cross(b - a, c - a);
    const double nn = norm2(n);
    const double wa = dot(n, cross(b, c)), wb = dot(n, cross(c, a)), wc = dot(n, cross(a, b));
    if (wa > 0 && wb > 0 && wc > 0 && nn > 0) {
        const double sum = wa + wb + wc;
        consider(s, {i, j, k}, {wa / sum, wb / sum, wc / sum}, best);
    }
}

// Of a flat tetrahedron rounding alone would tell the sides.
bool encloses(const Simplex& s)
{
    if (s.count < 4) return false;
    constexpr double kFlat = 1024 * kEpsilon * kEpsilon;
    constexpr int kFaces[4][4] = {{0, 1, 2, 3}, {0, 2, 3, 1}, {0, 3, 1, 2}, {1, 3, 2, 0}};
    for (const auto& f : kFaces) {
        const Point a = s.v[f[0]].c, n = cross(s.v[f[1]].c - a, s.v[f[2]].c - a);
        const Point edge = s.v[f[3]].c - a;
        const double apex = dot(n, edge), origin = -dot(n, a);
        if (!(apex * apex > kFlat * norm2(n) * norm2(edge)) || apex * origin < 0) return false;
    }
    return true;
}

// Reduces the simplex to the smallest part that holds its point nearest to the origin. The newest vertex is of it: what
// the others make has been looked at before.
void reduce(Simplex& s)
{
    Part best;
    const int newest = s.count - 1;
    consider(s, {newest}, {1.0}, best);
    for (int i = 0; i < newest; ++i) consider_edge(s, i, newest, best);
    for (int i = 0; i < newest; ++i)
        for (int j = i + 1; j < newest; ++j) consider_triangle(s, i, j, newest, best);
    Vertex kept[3];
    for (int i = 0; i < best.count; ++i) kept[i] = s.v[best.index[i]];
    for (int i = 0; i < best.count; ++i) s.v[i] = kept[i], s.weight[i] = best.weight[i];
    s.count = best.count;
}

Vertex support(const ConvexView& a, const ConvexView& b, Vec3 d)
{
    const Vec3 x = a.support(d), y = b.support(-d);
    return {exact(x) - exact(y), x, y};
}

// Tries to end the search early, when it has come near, and again when it has come much nearer.
class RimFinish {
  public:
    RimFinish(const ConvexView& a, const ConvexView& b, Real tolerance, LastDigits last)
        : a_(a),
          b_(b),
          tolerance_(tolerance),
          near_(last == LastDigits::kByNewton && has_rim_distance(a, b) ? kNear : 0)
    {}
    // `gap`: by what part of the distance the simplex may be too far.
    bool ends(const Simplex& s, Point nearest, double gap, Distance& out)
    {
        if (!(gap < near_)) return false;
        near_ = kNearer * gap;
        NearPoints points[4];
        for (int i = 0; i < s.count; ++i) points[i] = {s.v[i].on_a, s.v[i].on_b};
        const Vec3 n = rounded(1 / std::sqrt(norm2(nearest)) * nearest);
        return rim_distance(a_, b_, n, {points, std::size_t(s.count)}, tolerance_, out);
    }

  private:
    static constexpr double kNear = 0.2, kNearer = 0.1;
    const ConvexView &a_, &b_;
    const Real tolerance_;
    double near_;
};

}  // namespace

Distance gjk_distance(const ConvexView& a, const ConvexView& b, Real limit, Real tolerance, LastDigits last)
{
    constexpr int kIterations = 64;
    Simplex s;
    s.v[0] = support(a, b, b.pose.p - a.pose.p);
    s.count = 1;
    Point nearest = s.v[0].c;
    const Real size = a.size + b.size + length(b.pose.p - a.pose.p);
    Distance out;
    RimFinish finish(a, b, tolerance, last);
    for (int i = 0; i < kIterations; ++i) {
        const double d2 = norm2(nearest);
        if (!(d2 > 64 * kEpsilon * kEpsilon * size * size)) return out;  // touching
        const Vertex next = support(a, b, -rounded(nearest));
        const double bound = dot(nearest, next.c);  // |nearest| times a lower bound of the distance
        if (bound > 0 && bound * bound > limit * limit * d2) {
            out.distance = Real(bound / std::sqrt(d2));
            return out;
        }
        if (d2 - bound <= tolerance * d2) break;
        if (finish.ends(s, nearest, (d2 - bound) / d2, out)) return out;
        const Simplex before = s;
        s.v[s.count++] = next;
        if (bound <= 0 && encloses(s)) return out;  // else a plane keeps the origin out
        reduce(s);
        const Point shorter = s.nearest();
        if (!(norm2(shorter) < d2)) {  // no progress: rounding has the last word
            s = before;
            break;
        }
        nearest = shorter;
    }
    const double distance = std::sqrt(norm2(nearest));
    out.distance = Real(distance);
    out.normal = rounded(1 / distance * nearest);
    Point on_a{}, on_b{};
    for (int i = 0; i < s.count; ++i) {
        on_a = on_a + s.weight[i] * exact(s.v[i].on_a);
        on_b = on_b + s.weight[i] * exact(s.v[i].on_b);
    }
    out.on_a = rounded(on_a), out.on_b = rounded(on_b);
    return out;
}

}  // namespace epode
