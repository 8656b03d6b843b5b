// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Convex polyhedra against the convex solids: the general answer (convex_convex.cpp), with the polyhedron's
// own face normals where a face is what touches (geometry/overlap/flat_overlap.h). Against a ball: its centre's
// nearest point; the contact is the ball's deepest point under a face, as for any manifold of a face, and
// halfway between the two surfaces at an edge or corner. Against a plane: the vertices below it, each with
// its own depth, of which the best four are kept; also when all are below.
#include "collide/pairs/pairs.h"
#include "geometry/hulls/nearest_on_hull.h"

namespace epode {

void sphere_convex(const Sphere& a, const Pose& A, const Convex& b, const Pose& B, ContactSink& sink)
{
    const Vec3 middle = B.to_world(b.solid->centre());
    NearestOnHull nearest;
    if (!nearest_on_hull(*b.solid, transposed_times(B.R, A.p - middle), a.radius, nearest)) return;
    const Vec3 n = B.R * nearest.normal, lowest = A.p - a.radius * n;
    const Vec3 at = nearest.on_face ? lowest : Real(0.5) * (lowest + middle + B.R * nearest.point);
    const ContactPoint contact = {at, n, a.radius - nearest.distance};
    sink.add_manifold({&contact, 1});
}

void box_convex(const Box& a, const Pose& A, const Convex& b, const Pose& B, ContactSink& sink)
{
    convex_convex(view_of(a, A), view_of(b, B), sink);
}

void capsule_convex(const Capsule& a, const Pose& A, const Convex& b, const Pose& B, ContactSink& sink)
{
    convex_convex(view_of(a, A), view_of(b, B), sink);
}

void cylinder_convex(const Cylinder& a, const Pose& A, const Convex& b, const Pose& B, ContactSink& sink)
{
    convex_convex(view_of(a, A), view_of(b, B), sink);
}

void convex_with_convex(const Convex& a, const Pose& A, const Convex& b, const Pose& B, ContactSink& sink)
{
    convex_convex(view_of(a, A), view_of(b, B), sink);
}

void convex_plane(const Convex& a, const Pose& A, const Plane& b, const Pose&, ContactSink& sink)
{
    const Vec3 n = transposed_times(A.R, b.normal), middle = A.to_world(a.solid->centre());
    const Real clearance = dot(b.normal, middle) - b.d;
    if (clearance > a.solid->size()) return;
    constexpr int kCapacity = 64;
    union Below {
        ContactPoint points[kCapacity];  // in a union: left unwritten until found
        Below() {}
    } found;
    ContactPoint* const below = found.points;
    int count = 0, shallowest = 0;
    for (const Vec3 v : a.solid->vertices()) {
        const Real depth = -(clearance + dot(n, v));
        if (!(depth >= -sink.margin()) || (count == kCapacity && depth <= below[shallowest].depth)) continue;
        below[count < kCapacity ? count++ : shallowest] = {middle + A.R * v, b.normal, depth};
        if (count < kCapacity) continue;
        for (int i = 0; i < kCapacity; ++i)
            if (below[i].depth < below[shallowest].depth) shallowest = i;
    }
    sink.add_manifold({below, std::size_t(count)});
}

}  // namespace epode
