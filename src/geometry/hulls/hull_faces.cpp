// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// From facets to faces. The largest facets come first, since their planes are known best: each takes in its
// neighbours, and theirs, as long as all corners lie within `flat` of its own plane; no plane drifts. A
// corner of the solid is where three faces meet; other points of an outline are left out. Where that leaves
// less than a triangle, or an outline that is not one loop (rounded edges as thin as `flat` do it), the face
// is given back as the facets that it was made of, corners and all.
#include "geometry/hulls/hull_faces.h"

#include <algorithm>

#include "geometry/hulls/wide_integer.h"

namespace epode {

namespace {

class Gatherer {
  public:
    Gatherer(const HullMesh& mesh, double flat) : mesh_(mesh), flat_(flat) {}
    bool run(Hull& out);

  private:
    bool group_by_planes();
    bool flood(int seed, int group);
    void find_corners();
    bool trace(int seed, bool& one_loop);
    bool dissolve(int group);
    bool write(Hull& out);
    bool is_corner(int point) const { return corners_[point].forced || corners_[point].count > 2; }

    struct Corner {
        int group[2];
        int count;
        bool forced;
    };

    const HullMesh& mesh_;
    double flat_;
    Array<int> group_;   // of each facet; -1: not yet, or no facet
    Array<int> member_;  // of each facet: the next one of its group
    Array<int> seeds_;   // of each group: its first facet, -1 when dissolved
    Array<Corner> corners_;
    Array<int> stack_, loop_, order_;
};

bool Gatherer::flood(int seed, int group)
{
    const HullFacet& plane = mesh_.facets[seed];
    stack_.clear();
    group_[seed] = group;
    if (!stack_.push(seed)) return false;
    while (!stack_.empty()) {
        const HullFacet& f = mesh_.facets[stack_.back()];
        stack_.pop();
        for (const int g : f.neighbour) {
            const HullFacet& other = mesh_.facets[g];
            if (group_[g] >= 0 || !(plane.n.dot(other.n) > 0)) continue;
            bool near = true;
            for (const int v : other.v) near = near && std::fabs(mesh_.height(seed, v)) <= flat_;
            if (!near) continue;
            group_[g] = group;
            member_[g] = member_[seed], member_[seed] = g;
            if (!stack_.push(g)) return false;
        }
    }
    return true;
}

bool Gatherer::group_by_planes()
{
    const int count = mesh_.facets.size();
    if (!group_.resize(count) || !member_.resize(count) || !corners_.resize(mesh_.points.size()))
        return false;
    for (int i = 0; i < count; ++i) {
        group_[i] = member_[i] = -1;
        if (!mesh_.facets[i].gone && !order_.push(i)) return false;
    }
    std::sort(order_.begin(), order_.end(), [this](int i, int j) {
        const double a = mesh_.facets[i].area, b = mesh_.facets[j].area;
        return a != b ? a > b : i < j;
    });
    for (const int i : order_)
        if (group_[i] < 0 && (!flood(i, seeds_.size()) || !seeds_.push(i))) return false;
    return true;
}

// How many groups meet at each point, as far as two can be told from more.
void Gatherer::find_corners()
{
    for (Corner& c : corners_) c.count = 0;
    for (const int i : order_)
        for (const int v : mesh_.facets[i].v) {
            Corner& c = corners_[v];
            const int g = group_[i];
            if (c.count > 2 || (c.count > 0 && c.group[0] == g) || (c.count > 1 && c.group[1] == g)) continue;
            if (c.count < 2) c.group[c.count] = g;
            ++c.count;
        }
}

// The outline of the seed's group into `loop_`, corners only.
bool Gatherer::trace(int seed, bool& one_loop)
{
    const int group = group_[seed];
    int edges = 0, first = -1;
    for (int i = seed; i >= 0; i = member_[i])
        for (int k = 0; k < 3; ++k)
            if (group_[mesh_.facets[i].neighbour[k]] != group) {
                ++edges;
                if (first < 0) first = 3 * i + k;
            }
    loop_.clear();
    one_loop = false;
    if (first < 0) return true;
    int at = first, walked = 0;
    do {
        const int v = mesh_.facets[at / 3].v[at % 3];
        if (is_corner(v) && !loop_.push(v)) return false;
        int f = at / 3, k = (at % 3 + 1) % 3;
        while (group_[mesh_.facets[f].neighbour[k]] == group) {  // turn about the edge's end
            const int next = mesh_.facets[f].neighbour[k], pivot = mesh_.facets[f].v[k];
            for (int j = 0; j < 3; ++j)
                if (mesh_.facets[next].v[j] == pivot) k = j;
            f = next;
        }
        at = 3 * f + k;
        ++walked;
    } while (at != first && walked <= edges);
    one_loop = walked == edges && loop_.size() > 2;
    return true;
}

// Back into facets.
bool Gatherer::dissolve(int group)
{
    for (int i = seeds_[group]; i >= 0;) {
        const int next = member_[i];
        group_[i] = seeds_.size();
        member_[i] = -1;
        if (!seeds_.push(i)) return false;
        for (const int v : mesh_.facets[i].v) corners_[v].forced = true;
        i = next;
    }
    seeds_[group] = -1;
    return true;
}

bool Gatherer::run(Hull& out)
{
    if (!group_by_planes()) return false;
    for (bool changed = true; changed;) {
        changed = false;
        find_corners();
        for (int g = 0, count = seeds_.size(); g < count; ++g) {
            if (seeds_[g] < 0) continue;
            bool one_loop = false;
            if (!trace(seeds_[g], one_loop)) return false;
            if (one_loop) continue;
            if (!dissolve(g)) return false;
            changed = true;
        }
    }
    return write(out);
}

bool Gatherer::write(Hull& out)
{
    out.vertices.clear(), out.faces.clear(), out.normals.clear();
    for (int i = 0; i < mesh_.points.size(); ++i)
        if (is_corner(i) && !out.vertices.push(mesh_.points[i].source)) return false;
    std::sort(out.vertices.begin(), out.vertices.end());
    const auto place = [&](int point) {
        const int source = mesh_.points[point].source;
        return int(std::lower_bound(out.vertices.begin(), out.vertices.end(), source) - out.vertices.begin());
    };
    for (const int seed : seeds_) {
        if (seed < 0) continue;
        bool one_loop = false;
        if (!trace(seed, one_loop) || !out.faces.push(loop_.size())) return false;
        for (const int v : loop_)
            if (!out.faces.push(place(v))) return false;
        const Vec3d& n = mesh_.facets[seed].n;
        if (!out.normals.push({Real(n.x), Real(n.y), Real(n.z)})) return false;
    }
    return true;
}

}  // namespace

int side_of(const Array<GridPoint>& points, int a, int b, int c, int d)
{
    std::int64_t u[3], v[3], w[3];
    for (int k = 0; k < 3; ++k) {
        u[k] = points[b].x[k] - points[a].x[k];
        v[k] = points[c].x[k] - points[a].x[k];
        w[k] = points[d].x[k] - points[a].x[k];
    }
    // Of up to 126 bits.
    const Int128 det = (Int128(u[1]) * v[2] - Int128(u[2]) * v[1]) * w[0] +
                       (Int128(u[2]) * v[0] - Int128(u[0]) * v[2]) * w[1] +
                       (Int128(u[0]) * v[1] - Int128(u[1]) * v[0]) * w[2];
    return sign(det);
}

HullFacet plane_through(const Array<GridPoint>& points, int a, int b, int c)
{
    std::int64_t u[3], v[3];
    for (int k = 0; k < 3; ++k) {
        u[k] = points[b].x[k] - points[a].x[k];
        v[k] = points[c].x[k] - points[a].x[k];
    }
    HullFacet f = {};
    f.v[0] = a, f.v[1] = b, f.v[2] = c;
    f.neighbour[0] = f.neighbour[1] = f.neighbour[2] = -1;
    f.n = {double(Int128(u[1]) * v[2] - Int128(u[2]) * v[1]),
           double(Int128(u[2]) * v[0] - Int128(u[0]) * v[2]),
           double(Int128(u[0]) * v[1] - Int128(u[1]) * v[0])};
    f.area = f.n.length();
    if (f.area > 0) f.n = {f.n.x / f.area, f.n.y / f.area, f.n.z / f.area};
    f.farthest = f.above = -1;
    f.fresh = true;
    return f;
}

bool gather_faces(const HullMesh& mesh, double flat, Hull& out) { return Gatherer(mesh, flat).run(out); }

}  // namespace epode
