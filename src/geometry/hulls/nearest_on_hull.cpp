// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The nearest point of a polyhedron: see nearest_on_hull.h.
#include "geometry/hulls/nearest_on_hull.h"

#include "geometry/closest.h"

namespace epode {

namespace {

bool projects_into(const Polyhedron& solid, const PolyhedronFace& f, Vec3 p)
{
    const std::span<const int> corners = solid.corners().subspan(std::size_t(f.first), std::size_t(f.count));
    const std::span<const Vec3> vertices = solid.vertices();
    Vec3 from = vertices[std::size_t(corners.back())];
    for (const int c : corners) {
        const Vec3 to = vertices[std::size_t(c)];
        if (dot(cross(to - from, f.normal), p - from) > 0) return false;
        from = to;
    }
    return true;
}

}  // namespace

bool nearest_on_hull(const Polyhedron& solid, Vec3 p, Real limit, NearestOnHull& out)
{
    const std::span<const PolyhedronFace> faces = solid.faces();
    const auto gap = [&](const PolyhedronFace& f) { return dot(f.normal, p) - f.offset; };
    const PolyhedronFace* widest = nullptr;
    Real largest_gap = -kInf;
    for (const PolyhedronFace& f : faces) {
        const Real g = gap(f);
        if (g > largest_gap) largest_gap = g, widest = &f;
        if (g > limit) return false;
    }
    out = {p - largest_gap * widest->normal, widest->normal, largest_gap, true};
    if (!(largest_gap > 0) || projects_into(solid, *widest, p)) return true;
    Real least = kInf;
    Vec3 nearest;
    for (const PolyhedronEdge& e : solid.seams()) {
        if (gap(faces[std::size_t(e.left)]) <= 0 && gap(faces[std::size_t(e.right)]) <= 0) continue;
        const Vec3 a = solid.vertices()[std::size_t(e.from)], b = solid.vertices()[std::size_t(e.to)];
        const Vec3 q = a + closest_on_segment(a, b, p) * (b - a);
        const Real d2 = length2(p - q);
        if (d2 < least) least = d2, nearest = q;
    }
    const Real distance = std::sqrt(least);
    if (distance > limit) return false;
    const Real hair = 16 * kEpsilon * (solid.size() + length(p));
    Vec3 n = p - nearest;
    if (distance <= largest_gap + hair || !normalize(n)) return true;  // at the rim of the face
    out = {nearest, n, distance, false};
    return true;
}

}  // namespace epode
