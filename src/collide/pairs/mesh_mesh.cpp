// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See mesh_mesh.h. Everything in the second mesh's frame.
#include "collide/pairs/mesh_mesh.h"

#include <algorithm>

#include "collide/pairs/triangle_triangle.h"

namespace epode {

namespace {

// The box of a box that has been turned.
Aabb box_in(const Pose& pose, const Aabb& box)
{
    const Vec3 half = Real(0.5) * (box.hi - box.lo), centre = pose.to_world(box.lo + half);
    const Vec3 reach{dot(abs(pose.R.row0), half), dot(abs(pose.R.row1), half), dot(abs(pose.R.row2), half)};
    return {centre - reach, centre + reach};
}

Aabb box_of(const Triangle& t)
{
    return {min(t.v[0], min(t.v[1], t.v[2])), max(t.v[0], max(t.v[1], t.v[2]))};
}

Real reach_of(const Aabb& box) { return max_component(max(abs(box.lo), abs(box.hi))); }

constexpr Real kOtherWay = Real(0.99);  // cosine between normals of different contacts
constexpr Real kCovers = Real(1.05);

// Are two triangles the same or neighbours?
bool adjoin(const TriangleMesh& mesh, int t, int u)
{
    return t == u || mesh.neighbour(t, 0) == u || mesh.neighbour(t, 1) == u || mesh.neighbour(t, 2) == u;
}

// Where two solids meet edge to edge, pairs of triangles beside those edges cross, too, and see only longer
// ways out. A push is needless when a shorter one nearby, in another direction, parts its triangles as well.
bool needless(const TrianglePush& push, const Array<TrianglePush>& shorter, int count, const Surface& a,
              const Surface& b)
{
    for (int i = 0; i < count; ++i) {
        const TrianglePush& s = shorter[i];
        if (s.allowed && dot(s.normal, push.normal) < kOtherWay && adjoin(a.mesh, s.a, push.a) &&
            adjoin(b.mesh, s.b, push.b) && push.overlap_along(s.normal) <= kCovers * s.depth)
            return true;
    }
    return false;
}

void reap(Array<TrianglePush>& pushes, const Surface& a, const Surface& b, Harvest& harvest)
{
    std::sort(pushes.begin(), pushes.end(), [](const TrianglePush& x, const TrianglePush& y) {
        if (x.depth != y.depth) return x.depth < y.depth;
        return x.a != y.a ? x.a < y.a : x.b < y.b;
    });
    for (int i = 0; i < pushes.size(); ++i) {
        const TrianglePush& p = pushes[i];
        if (!p.allowed || needless(p, pushes, i, a, b)) continue;
        for (int k = 0; k < p.count; ++k) harvest.add({p.points[k], p.normal, p.depths[k], p.a, p.b});
    }
    if (!harvest.empty()) return;
    for (const TrianglePush& p : pushes)  // the least that nobody allows
        if (!p.allowed) return harvest.add({p.points[0], p.normal, p.depths[0], p.a, p.b});
}

// `a` at the pose P in b's frame; contacts in b's frame.
void meet(const Surface& a, const Pose& P, const Surface& b, bool ground, ContactSink& sink)
{
    const Pose back = inverse_times(P, Pose{});
    NearTriangles near_a, near_b;
    near_a.find(a, box_in(back, b.tree.box()));
    if (near_a.near().count() == 0) return;
    const Aabb whole = box_in(P, a.tree.box());
    const Real slack = 64 * kEpsilon * std::max(reach_of(whole), reach_of(a.tree.box()));
    const Tolerance tolerance{slack, std::max(slack, kMeshTouch * length(whole.hi - whole.lo))};
    const Pose here;
    Array<TrianglePush> pushes;
    for (const int t : near_a.near()) {
        const PlacedFacet fa = placed(a.mesh, t, P, false);
        near_b.find(b, box_of(fa.f));
        for (const int u : near_b.near()) {
            TrianglePush push;
            if (triangle_triangle(fa, placed(b.mesh, u, here, ground), tolerance, push) && !pushes.push(push))
                break;
        }
    }
    Harvest harvest(Real(1e-6) * length(whole.hi - whole.lo), sink);
    reap(pushes, a, b, harvest);
    harvest.deliver(sink);
}

// A range of samples, ends included.
struct Samples {
    int from, to;
    int count() const { return to - from + 1; }
};

// Those under [lo, hi] and one more to each side; at most kMost. Empty when there are none.
Samples samples_under(Real lo, Real hi, Real origin, Real cell, int cells, bool endless)
{
    constexpr Real kMost = 256, kFar = 1e9;
    Real from = std::floor((lo - origin) / cell) - 1, to = std::floor((hi - origin) / cell) + 2;
    if (!(from > -kFar && to < kFar) || (!endless && (to < 0 || from > Real(cells)))) return {0, -1};
    if (to - from > kMost) {
        const Real middle = std::floor(Real(0.5) * (from + to));
        from = middle - kMost / 2, to = middle + kMost / 2;
    }
    if (!endless) from = std::max(from, Real(0)), to = std::min(to, Real(cells));
    return {int(from), int(to)};
}

// The facets near a box as a mesh; false when there are none, or no memory.
bool cut_out(const Terrain& terrain, const Aabb& box, TriangleMesh& mesh, MeshTree& tree, Real& lowest)
{
    const Vec3 o = terrain.low_corner(), cell = terrain.cell();
    const Samples x = samples_under(box.lo.x, box.hi.x, o.x, cell.x, terrain.cells_x(), terrain.endless());
    const Samples z = samples_under(box.lo.z, box.hi.z, o.z, cell.z, terrain.cells_z(), terrain.endless());
    if (x.count() < 2 || z.count() < 2) return false;
    Array<Vec3> vertices;
    Array<MeshCorners> triangles;
    if (!vertices.reserve(x.count() * z.count()) || !triangles.reserve(2 * (x.count() - 1) * (z.count() - 1)))
        return false;
    lowest = kInf;
    for (int j = z.from; j <= z.to; ++j)
        for (int i = x.from; i <= x.to; ++i) {
            const Vec3 v = terrain.vertex(i, j);
            lowest = std::min(lowest, v.y);
            if (!vertices.push(v)) return false;
        }
    for (int j = 0; j + 1 < z.count(); ++j)
        for (int i = 0; i + 1 < x.count(); ++i) {
            const int a = i + j * x.count(), b = a + 1, c = a + x.count(), d = c + 1;
            if (!triangles.push({{a, c, b}}) || !triangles.push({{d, b, c}})) return false;
        }
    return mesh.build(vertices, triangles, kEpsilon) && tree.build(mesh);
}

}  // namespace

void mesh_mesh_contacts(const Surface& a, const Pose& A, const Surface& b, const Pose& B, ContactSink& sink)
{
    const int before = sink.count();
    meet(a, inverse_times(B, A), b, false, sink);
    to_world(B, sink, before);
}

void mesh_ground_contacts(const Surface& a, const Pose& A, const HeightfieldData& ground, const Pose& B,
                          ContactSink& sink)
{
    if (a.mesh.triangle_count() == 0) return;
    const Pose P = inverse_times(B, A);
    const Aabb box = box_in(P, a.tree.box());
    TriangleMesh mesh;
    MeshTree tree;
    Real lowest = 0;
    if (!cut_out(Terrain(ground), box, mesh, tree, lowest)) return;
    const int before = sink.count();
    if (box.hi.y < lowest) {  // buried: straight up
        sink.add({{P.p.x, lowest, P.p.z}, {0, 1, 0}, lowest - box.hi.y});
    } else {
        meet(a, P, {mesh, tree}, true, sink);
        for (int k = before; k < sink.count(); ++k) sink.at(k)->side2 = -1;
    }
    to_world(B, sink, before);
}

}  // namespace epode
