// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Vertices are welded by sorting positions, edges are found by gathering half-edges at their lower vertex. At
// an edge with direction e, let a = n x e point into the triangle that asks; a sheet in the direction w, unit
// and across e, stands at the angle theta with cos = a.w, sin = n.w. A convex edge has theta > pi. Angles are
// compared by a function that grows with them: 1 - cos up to pi, 3 + cos beyond. A sheet that lies on the
// triangle that asks (theta = 0) is taken to lie behind it (2 pi).
#include "geometry/triangle_mesh.h"

#include <algorithm>

#include "geometry/mesh_edges.h"

namespace epode {

struct FanEdge {
    int far;  // the end that is not the lower vertex
    int half_edge;
};

namespace {

constexpr int kLongestChain = 8;  // of degenerate triangles to look beyond
constexpr int kCrowd = 32;        // most triangles at an edge that are neighbours

struct Site {
    Vec3 at;
    int vertex;
};

bool before(const Site& a, const Site& b)
{
    if (a.at.x != b.at.x) return a.at.x < b.at.x;
    if (a.at.y != b.at.y) return a.at.y < b.at.y;
    if (a.at.z != b.at.z) return a.at.z < b.at.z;
    return a.vertex < b.vertex;
}

bool before(const FanEdge& a, const FanEdge& b)
{
    return a.far != b.far ? a.far < b.far : a.half_edge < b.half_edge;
}

}  // namespace

bool TriangleMesh::weld()
{
    Array<Site> sites;
    const int count = vertices_.size();
    if (!weld_.resize(count) || !sites.resize(count)) return false;
    for (int i = 0; i < count; ++i) sites[i] = {vertices_[i], i};
    std::sort(sites.begin(), sites.end(), [](const Site& a, const Site& b) { return before(a, b); });
    int first = 0;
    for (int i = 0; i < count; ++i) {
        if (!(sites[i].at == sites[first].at)) first = i;
        weld_[sites[i].vertex] = sites[first].vertex;
    }
    return true;
}

// The half-edges from or to one vertex that is the lower end of all of them.
void TriangleMesh::link_fan(const FanEdge* first, int count)
{
    for (int i = 0, end = 0; i < count; i = end) {
        while (end < count && first[end].far == first[i].far) ++end;
        if (end - i > kCrowd) continue;
        for (int j = i; j < end; ++j) next_[first[j].half_edge] = first[j + 1 < end ? j + 1 : i].half_edge;
    }
}

bool TriangleMesh::link_edges()
{
    const int half_edges = 3 * triangles_.size();
    Array<int> starts;  // where the fan of each vertex begins
    Array<FanEdge> fans;
    if (!next_.resize(half_edges) || !starts.resize(vertices_.size() + 2) || !fans.resize(half_edges))
        return false;
    const auto linked = [this](int h) {  // a triangle that has one vertex twice has no edges
        const int t = 3 * (h / 3);
        return start(t) != start(t + 1) && start(t + 1) != start(t + 2) && start(t + 2) != start(t);
    };
    for (int h = 0; h < half_edges; ++h) {
        next_[h] = h;
        if (linked(h)) ++starts[std::min(start(h), end(h)) + 2];
    }
    for (int v = 2; v < starts.size(); ++v) starts[v] += starts[v - 1];
    for (int h = 0; h < half_edges; ++h)
        if (linked(h)) fans[starts[std::min(start(h), end(h)) + 1]++] = {std::max(start(h), end(h)), h};
    for (int v = 0; v < vertices_.size(); ++v) {
        FanEdge* first = fans.data() + starts[v];
        const int count = starts[v + 1] - starts[v];
        std::sort(first, first + count, [](const FanEdge& a, const FanEdge& b) { return before(a, b); });
        link_fan(first, count);
    }
    return true;
}

bool TriangleMesh::build(Array<Vec3>& vertices, Array<MeshCorners>& triangles, Real grain)
{
    TriangleMesh made;
    made.grain_ = grain;
    made.vertices_.swap(vertices);
    made.triangles_.swap(triangles);
    const int count = made.triangles_.size();
    const bool complete = made.weld() && made.link_edges() && made.across_.resize(3 * count) &&
                          made.first_.resize(made.vertices_.size()) && made.normals_.resize(count) &&
                          made.tilt_.resize(count) && made.crests_.resize(count) &&
                          made.rims_.resize(count) && made.sharp_.resize(made.vertices_.size());
    if (!complete) {
        made.vertices_.swap(vertices);
        made.triangles_.swap(triangles);
        return false;
    }
    made.refresh();
    *this = static_cast<TriangleMesh&&>(made);
    return true;
}

void TriangleMesh::measure(int t)
{
    const TriangleLie lie = lie_of({corner(t, 0), corner(t, 1), corner(t, 2)}, grain_);
    normals_[t] = lie.n;
    tilt_[t] = lie.tilt;
}

// Through the degenerate triangle at half-edge h, and through others behind it.
TriangleMesh::Over TriangleMesh::beyond_degenerate(int h) const
{
    const int asker = h / 3;
    Over at{next_.data()[h], start(h) == start(next_.data()[h])};
    for (int hops = 0; hops < kLongestChain; ++hops) {
        const int t = at.half_edge / 3, k = at.half_edge % 3;
        const int a = 3 * t + (k + 1) % 3, b = 3 * t + (k + 2) % 3;
        const int out = length2(along(a)) >= length2(along(b)) ? a : b;
        int found = -1;
        for (int g = next_.data()[out]; g != out; g = next_.data()[g]) {
            if (g / 3 == asker) continue;
            if (found < 0) found = g;
            if (degenerate(g / 3)) continue;
            found = g;
            break;
        }
        if (found < 0) return {};
        at = {found, at.turned != (start(found) == start(out))};
        if (!degenerate(found / 3)) return at;
    }
    return {};
}

TriangleMesh::Over TriangleMesh::over(int h) const
{
    const int t = h / 3;
    const Vec3 n = normal(t), edge = normalized_or(along(h), {});
    Over best;
    Real least = kInf;
    bool any = false;
    for (int g = next_.data()[h]; g != h; g = next_.data()[g]) {
        any = true;
        if (degenerate(g / 3)) continue;
        const bool turned = start(g) == start(h);
        const Real turn = sheet_turn(apex(g), from(h), edge, n).growing(kFlatSine);
        if (turn < least || (turn == least && best.turned && !turned)) {
            least = turn;
            best = {g, turned};
        }
    }
    return best.half_edge >= 0 || !any ? best : beyond_degenerate(h);
}

// +1 for a convex edge or a border, -1 for a concave one.
int TriangleMesh::bend(int h, const Over& found) const
{
    if (found.half_edge < 0) return 1;
    const int t = h / 3;
    const Real flat = flat_sine(tilt_.data()[t], tilt_.data()[found.half_edge / 3]);
    const SheetTurn turn = sheet_turn(apex(found.half_edge), from(h), normalized_or(along(h), {}), normal(t));
    return turn.convex(flat) ? 1 : turn.sine > flat ? -1 : 0;
}

bool TriangleMesh::hollow(int t, int k) const { return bend(3 * t + k, over(3 * t + k)) < 0; }

bool TriangleMesh::leads(int t, int k) const
{
    const int h = 3 * t + k;
    for (int g = next_.data()[h]; g != h; g = next_.data()[g])
        if (g < h && !degenerate(g / 3)) return false;
    return true;
}

void TriangleMesh::look_over(int h)
{
    const int t = h / 3;
    const Over found = over(h);
    across_[h] = found.half_edge < 0 ? -1 : 2 * (found.half_edge / 3) + (found.turned ? 1 : 0);
    if (bend(h, found) <= 0) return;
    crests_[t] = std::uint8_t(crests_[t] | 1 << h % 3);
    sharp_[start(h)] = sharp_[end(h)] = 1;
}

void TriangleMesh::refresh()
{
    const int count = triangles_.size();
    for (int t = 0; t < count; ++t) measure(t);
    std::fill(first_.begin(), first_.end(), -1);
    for (int h = 3 * count - 1; h >= 0; --h)
        if (!degenerate(h / 3)) first_[start(h)] = h;
    std::fill(crests_.begin(), crests_.end(), std::uint8_t(0));
    std::fill(sharp_.begin(), sharp_.end(), std::uint8_t(0));
    for (int h = 0; h < 3 * count; ++h) {
        if (degenerate(h / 3))
            across_[h] = -1;
        else
            look_over(h);
    }
    for (int h = 0; h < 3 * count; ++h)
        if (!degenerate(h / 3) && sharp_[start(h)])
            crests_[h / 3] = std::uint8_t(crests_[h / 3] | 8 << h % 3);
    for (int t = 0; t < count; ++t) rims_[t] = degenerate(t) ? MeshRims{} : rims_of(t);
}

MeshRims TriangleMesh::rims_of(int t) const
{
    MeshRims out;
    for (int k = 0; k < 3; ++k) {
        const Vec3 over = beyond(t, k);
        const bool border = neighbour(t, k) < 0 || over == -normal(t), crest = crests(t) >> k & 1;
        out.rim[k] = border ? Rim::kBorder : rim_of(normal(t), along(3 * t + k), over, crest);
        out.sharp[k] = (crests(t) >> (3 + k) & 1) != 0;
    }
    return out;
}

MeshTriangle TriangleMesh::triangle(int t) const
{
    MeshTriangle out{{corner(t, 0), corner(t, 1), corner(t, 2)}, normal(t), {}, crests(t)};
    for (int k = 0; k < 3; ++k) out.beyond[k] = beyond(t, k);
    return out;
}

Aabb TriangleMesh::box(int t) const
{
    const Vec3 a = corner(t, 0), b = corner(t, 1), c = corner(t, 2);
    return {min(a, min(b, c)), max(a, max(b, c))};
}

Aabb TriangleMesh::box() const
{
    if (triangles_.empty()) return {};
    Aabb all = box(0);
    for (int t = 1; t < triangle_count(); ++t) {
        const Aabb one = box(t);
        all = {min(all.lo, one.lo), max(all.hi, one.hi)};
    }
    return all;
}

}  // namespace epode
