// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See closed_mesh.h. The nearest point is sought in boxes about the point that grow until it is nearer than
// what lies outside; of triangles that are equally near the lowest counts.
#include "collide/surfaces/closed_mesh.h"

#include <algorithm>

#include "math/trig.h"

namespace epode {
namespace {

// Where on a triangle: inside, on edge k, at corner k.
enum class Part : unsigned char { kFace, kEdge, kCorner };

struct Foot {
    Real distance2 = kInf;
    Vec3 at;
    int triangle = -1;
    Part part = Part::kFace;
    int k = 0;
};

// The nearest point of a triangle to p.
Foot foot_on(const Vec3* v, Vec3 n, Vec3 p)
{
    Foot best;
    bool inside = true;
    for (int k = 0; k < 3; ++k) {
        const Vec3 a = v[k], e = v[(k + 1) % 3] - a;
        inside = inside && dot(cross(n, e), p - a) >= 0;
        const Real t = std::clamp(dot(p - a, e) / length2(e), Real(0), Real(1));
        const Vec3 q = a + t * e;
        const Real d2 = length2(p - q);
        if (d2 >= best.distance2) continue;
        best.distance2 = d2, best.at = q;
        best.part = t > 0 && t < 1 ? Part::kEdge : Part::kCorner;
        best.k = t < 1 ? k : (k + 1) % 3;
    }
    if (!inside) return best;
    const Real height = dot(n, p - v[0]);
    best.distance2 = height * height, best.at = p - height * n, best.part = Part::kFace;
    return best;
}

Foot nearest(const TriangleMesh& mesh, const MeshTree& tree, Vec3 p)
{
    Foot best;
    const Aabb& all = tree.box();
    const Real size = max_component(all.hi - all.lo);
    for (Real reach = size / 64;; reach *= 2) {
        const Vec3 r{reach, reach, reach};
        tree.query(mesh, {p - r, p + r}, [&](int t) {
            const Vec3 v[3] = {mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)};
            Foot foot = foot_on(v, mesh.normal(t), p);
            foot.triangle = t;
            const bool equal = foot.distance2 == best.distance2;
            if (foot.distance2 < best.distance2 || (equal && t < best.triangle)) best = foot;
            return true;
        });
        if (best.distance2 <= reach * reach || reach > 2 * size) return best;
    }
}

Real angle_at(const TriangleMesh& mesh, int t, int k)
{
    const Vec3 v = mesh.corner(t, k);
    const Vec3 a = mesh.corner(t, (k + 1) % 3) - v, b = mesh.corner(t, (k + 2) % 3) - v;
    return epode::atan2(length(cross(a, b)), dot(a, b));
}

// Which corner of a triangle is at a place; -1: none.
int corner_at(const TriangleMesh& mesh, int t, Vec3 place)
{
    for (int k = 0; k < 3; ++k)
        if (mesh.corner(t, k) == place) return k;
    return -1;
}

// The triangles about a corner, one after the other over the edges that they share.
Vec3 normal_at_corner(const TriangleMesh& mesh, int first, int corner)
{
    const Vec3 place = mesh.corner(first, corner);
    Vec3 sum;
    int t = first, k = corner;
    for (int i = 0; i < mesh.triangle_count() && k >= 0; ++i) {
        sum += angle_at(mesh, t, k) * mesh.normal(t);
        t = mesh.neighbour(t, k);
        if (t < 0 || t == first) break;
        k = corner_at(mesh, t, place);
    }
    return sum;
}

Vec3 pseudo_normal(const TriangleMesh& mesh, const Foot& foot)
{
    switch (foot.part) {
        case Part::kEdge:
            return mesh.normal(foot.triangle) + mesh.beyond(foot.triangle, foot.k);
        case Part::kCorner:
            return normal_at_corner(mesh, foot.triangle, foot.k);
        default:
            return mesh.normal(foot.triangle);
    }
}

}  // namespace

bool is_closed(const TriangleMesh& mesh)
{
    const Aabb box = mesh.box();
    const Vec3 middle = Real(0.5) * box.lo + Real(0.5) * box.hi;
    const Real size = max_component(box.hi - box.lo);
    Real volume = 0;
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        if (mesh.degenerate(t)) continue;
        for (int k = 0; k < 3; ++k) {
            const int over = mesh.neighbour(t, k);
            if (over < 0 || !(mesh.beyond(t, k) == mesh.normal(over))) return false;
        }
        // In parts of the size, so that it does not overflow.
        const Vec3 a = (mesh.corner(t, 0) - middle) / size, b = (mesh.corner(t, 1) - middle) / size,
                   c = (mesh.corner(t, 2) - middle) / size;
        volume += dot(a, cross(b, c)) / 6;
    }
    return volume > 64 * kEpsilon;
}

bool way_out_of(const TriangleMesh& mesh, const MeshTree& tree, Vec3 point, WayOut& out)
{
    const Aabb& all = tree.box();
    if (!overlap({point, point}, all)) return false;
    const Foot foot = nearest(mesh, tree, point);
    if (foot.triangle < 0) return false;
    Vec3 way = foot.at - point;
    if (!(dot(way, pseudo_normal(mesh, foot)) > 0)) return false;
    out.nearest = foot.at;
    out.normal = normalized_or(way, mesh.normal(foot.triangle));
    out.triangle = foot.triangle;
    return true;
}

}  // namespace epode
