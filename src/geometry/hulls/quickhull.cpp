// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Growing the hull: see quickhull.h. Facets are triangles that know their neighbours. Each keeps a list of
// the points above it, farthest first in mind; the facet with the farthest point of all is served next. The
// facets that this point sees, exactly, hang together; their rim is one loop, from which a fan rises to
// the point. Points of the facets that went are handed to the fan, or found to be inside.
// Heights are computed with doubles; a point closer than kThin grid steps to all facets counts as inside.
#include "geometry/hulls/quickhull.h"

#include <algorithm>

#include "geometry/hulls/hull_faces.h"

namespace epode {

namespace {

constexpr double kThin = 4;

struct Waiting {
    double height;
    int facet, age;
};

class Builder {
  public:
    Builder(std::span<const Vec3> points, HullMesh& mesh) : points_(points), mesh_(mesh) {}
    HullFault start(Real flat);
    // Adds the farthest point: 1, or 0 when none is left, -1 without memory.
    int grow();
    int vertices() const { return vertices_; }

  private:
    bool round_points();
    int farthest_from_line(int a, int b, double& distance) const;
    int farthest_from_plane(int a, int b, int c, double& distance) const;
    bool first_solid(int a, int b, int c, int d);
    int make_facet(int a, int b, int c);
    bool find_visible(int from, int eye);
    bool raise_fan(int eye);
    bool hand_over(int point);
    bool announce(int facet);
    static bool later(const Waiting& x, const Waiting& y)
    {
        return x.height != y.height ? x.height < y.height : x.facet > y.facet;
    }

    std::span<const Vec3> points_;
    HullMesh& mesh_;
    Array<Waiting> queue_;
    Array<int> next_;    // of a point: the next one above the same facet
    Array<int> starts_;  // of a point on the rim: the new facet whose edge begins there
    Array<int> visible_, rim_, fan_, orphans_, free_;
    int vertices_ = 0;
};

// Equal points become one, which has the lowest index.
bool Builder::round_points()
{
    Vec3 lo = points_[0], hi = lo;
    for (const Vec3 p : points_) lo = min(lo, p), hi = max(hi, p);
    const Vec3 side = hi - lo;
    const double extent = double(max_component(side));
    mesh_.extent = extent;
    if (!(extent > 1e-280)) return mesh_.points.push({});
    const double scale = double(kHullGrid) / extent;
    Array<GridPoint> all;
    if (!all.resize(int(points_.size()))) return false;
    for (int i = 0; i < all.size(); ++i)
        for (int k = 0; k < 3; ++k) {
            const double x = (double(points_[std::size_t(i)][k]) - double(lo[k])) * scale;
            all[i].x[k] = std::int64_t(x + 0.5);
            all[i].source = i;
        }
    std::sort(all.begin(), all.end(), [](const GridPoint& a, const GridPoint& b) {
        for (int k = 0; k < 3; ++k)
            if (a.x[k] != b.x[k]) return a.x[k] < b.x[k];
        return a.source < b.source;
    });
    for (const GridPoint& p : all)
        if (mesh_.points.empty() || !same_place(mesh_.points.back(), p))
            if (!mesh_.points.push(p)) return false;
    return next_.resize(mesh_.points.size()) && starts_.resize(mesh_.points.size());
}

int Builder::farthest_from_line(int a, int b, double& distance) const
{
    const Vec3d origin = between(mesh_.points[a], mesh_.points[b]);
    int best = -1;
    distance = 0;
    for (int i = 0; i < mesh_.points.size(); ++i) {
        const double d = origin.cross(between(mesh_.points[a], mesh_.points[i])).length() / origin.length();
        if (d > distance) distance = d, best = i;
    }
    return best;
}

int Builder::farthest_from_plane(int a, int b, int c, double& distance) const
{
    const HullFacet plane = plane_through(mesh_.points, a, b, c);
    int best = -1;
    distance = 0;
    for (int i = 0; i < mesh_.points.size(); ++i) {
        const double d = std::fabs(plane.n.dot(between(mesh_.points[a], mesh_.points[i])));
        if (d > distance) distance = d, best = i;
    }
    return best;
}

HullFault Builder::start(Real flat)
{
    if (!round_points()) return HullFault::kMemory;
    const int count = mesh_.points.size();
    if (count < 2) return HullFault::kPoint;
    // The farthest from the first and the farthest from that, so that a needle is seen as one.
    const auto farthest = [&](int from) {
        int best = from;
        double highest = 0;
        for (int i = 0; i < count; ++i) {
            const double d = between(mesh_.points[from], mesh_.points[i]).length();
            if (d > highest) highest = d, best = i;
        }
        return best;
    };
    const double thin = std::max(double(flat) * double(kHullGrid), 4 * kThin);
    double distance = 0;
    const int a = farthest(0), b = farthest(a), c = farthest_from_line(a, b, distance);
    if (!(distance > thin)) return HullFault::kLine;
    const int d = farthest_from_plane(a, b, c, distance);
    if (!(distance > thin)) return HullFault::kPlane;
    return first_solid(a, b, c, d) ? HullFault::kNone : HullFault::kMemory;
}

bool Builder::first_solid(int a, int b, int c, int d)
{
    if (side_of(mesh_.points, a, b, c, d) > 0) std::swap(b, c);
    const int corners[4][3] = {{a, b, c}, {a, d, b}, {b, d, c}, {c, d, a}};
    for (const auto& f : corners) {
        const int made = make_facet(f[0], f[1], f[2]);
        if (made < 0 || !fan_.push(made)) return false;
    }
    const int neighbours[4][3] = {{1, 2, 3}, {3, 2, 0}, {1, 3, 0}, {2, 1, 0}};
    for (int i = 0; i < 4; ++i)
        for (int k = 0; k < 3; ++k) mesh_.facets[i].neighbour[k] = neighbours[i][k];
    vertices_ = 4;
    for (int i = 0; i < mesh_.points.size(); ++i)
        if (i != a && i != b && i != c && i != d && !hand_over(i)) return false;
    for (const int f : fan_)
        if (!announce(f)) return false;
    return true;
}

int Builder::make_facet(int a, int b, int c)
{
    int i = mesh_.facets.size();
    int age = 0;
    if (free_.empty()) {
        if (!mesh_.facets.push(HullFacet{})) return -1;
    } else {
        i = free_.back();
        free_.pop();
        age = mesh_.facets[i].age;
    }
    mesh_.facets[i] = plane_through(mesh_.points, a, b, c);
    mesh_.facets[i].age = age;
    return i;
}

// To the new facet above which it is highest. Just under all of them it may still be above a facet that
// stays and sees the same point: those hang together with the facet found here.
bool Builder::hand_over(int point)
{
    int best = -1;
    double highest = 0;
    for (const int f : fan_) {
        const double h = mesh_.height(f, point);
        if (h > highest) highest = h, best = f;
    }
    if (best < 0) return true;
    for (bool rising = highest <= kThin; rising;) {
        rising = false;
        for (const int f : mesh_.facets[best].neighbour)
            if (f >= 0 && mesh_.height(f, point) > highest)
                highest = mesh_.height(f, point), best = f, rising = true;
    }
    if (highest <= kThin) return true;
    HullFacet& f = mesh_.facets[best];
    next_[point] = f.above;
    f.above = point;
    if (highest <= f.height) return true;
    f.height = highest, f.farthest = point;
    return f.fresh || announce(best);
}

bool Builder::announce(int facet)
{
    HullFacet& f = mesh_.facets[facet];
    f.fresh = false;
    if (f.farthest < 0) return true;
    if (!queue_.push({f.height, facet, f.age})) return false;
    std::push_heap(queue_.begin(), queue_.end(), later);
    return true;
}

bool Builder::find_visible(int from, int eye)
{
    visible_.clear(), rim_.clear();
    mesh_.facets[from].seen = true;
    if (!visible_.push(from)) return false;
    for (int done = 0; done < visible_.size(); ++done) {
        const int f = visible_[done];
        for (int k = 0; k < 3; ++k) {
            const int g = mesh_.facets[f].neighbour[k];
            HullFacet& other = mesh_.facets[g];
            if (other.seen) continue;
            if (side_of(mesh_.points, other.v[0], other.v[1], other.v[2], eye) > 0) {
                other.seen = true;
                if (!visible_.push(g)) return false;
            } else if (!rim_.push(3 * f + k)) {
                return false;
            }
        }
    }
    return true;
}

bool Builder::raise_fan(int eye)
{
    fan_.clear();
    for (int i = 0; i < rim_.size(); ++i) {
        const int f = rim_[i] / 3, k = rim_[i] % 3;
        const int a = mesh_.facets[f].v[k], b = mesh_.facets[f].v[(k + 1) % 3];
        const int beyond = mesh_.facets[f].neighbour[k];
        const int made = make_facet(a, b, eye);
        if (made < 0 || !fan_.push(made)) return false;
        mesh_.facets[made].neighbour[0] = beyond;
        for (int j = 0; j < 3; ++j)
            if (mesh_.facets[beyond].v[j] == b) mesh_.facets[beyond].neighbour[j] = made;
        starts_[a] = made;
    }
    for (const int f : fan_) {
        const int next = starts_[mesh_.facets[f].v[1]];
        mesh_.facets[f].neighbour[1] = next;
        mesh_.facets[next].neighbour[2] = f;
    }
    return true;
}

int Builder::grow()
{
    for (;;) {
        if (queue_.empty()) return 0;
        const Waiting first = queue_[0];
        std::pop_heap(queue_.begin(), queue_.end(), later);
        queue_.pop();
        const HullFacet& f = mesh_.facets[first.facet];
        if (f.gone || f.age != first.age || f.height != first.height) continue;
        const int eye = f.farthest;
        if (!find_visible(first.facet, eye)) return -1;
        if (!raise_fan(eye)) return -1;
        orphans_.clear();
        for (const int g : visible_) {
            HullFacet& old = mesh_.facets[g];
            for (int p = old.above; p >= 0; p = next_[p])
                if (p != eye && !orphans_.push(p)) return -1;
            old.gone = true, ++old.age;
        }
        for (const int p : orphans_)
            if (!hand_over(p)) return -1;
        for (const int g : fan_)
            if (!announce(g)) return -1;
        for (const int g : visible_)
            if (!free_.push(g)) return -1;
        ++vertices_;
        return 1;
    }
}

}  // namespace

HullFault convex_hull(std::span<const Vec3> points, Real flat, int max_vertices, Hull& out)
{
    HullMesh mesh;
    Builder builder(points, mesh);
    const HullFault fault = builder.start(flat);
    if (fault != HullFault::kNone) return fault;
    int grown = 1;
    while (builder.vertices() < max_vertices && grown == 1) grown = builder.grow();
    return grown < 0 || !gather_faces(mesh, double(flat) * double(kHullGrid), out) ? HullFault::kMemory
                                                                                   : HullFault::kNone;
}

}  // namespace epode
