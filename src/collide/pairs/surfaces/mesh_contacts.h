// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A solid against a mesh, everything in the mesh's frame. The triangles that the solid may touch are visited
// in the order of their numbers (mesh_facet.h), and their contacts are reduced together
// (contact_collector.h). If all triangles whose boxes overlap the solid's lie in one plane that extends past
// the solid, the plane's pair function answers: a flat mesh, however finely divided, is exactly a plane.
#pragma once

#include "bvh/mesh_tree.h"
#include "collide/pairs/surfaces/on_surface.h"
#include "collide/surfaces/triangle_list.h"

namespace epode {

struct Surface {
    const TriangleMesh& mesh;
    const MeshTree& tree;
};

// The triangles near a solid: those that it may touch, in order, and on request all whose boxes overlap its
// own.
class NearTriangles {
  public:
    // Without memory those that fit.
    void find(const Surface& surface, const Aabb& box);  // all that are near, in order
    // Those that it may touch.
    void find(const Surface& surface, const Aabb& box, const SolidProbe& solid, NearLeaves* kept = nullptr);

    // After find() with the same box: all that are near.
    void gather(const Surface& surface, const Aabb& box);
    void put_in_order() { near_.sort(); }

    // Keeps those for which keep(triangle) holds; it is called once for each. They must be gathered and in
    // order. `refused` gets the others.
    template <typename Keep>
    void filter(Keep&& keep, TriangleList& refused)
    {
        near_.filter([&](int t) {
            const bool kept = keep(t);
            if (!kept) all_ = refused.add(t) && all_;
            return kept;
        });
        close_.filter([&](int t) { return near_.has(t); });
        refused_ = refused.count() > 0 ? &refused : nullptr;
    }

    const TriangleList& near() const { return near_; }
    const TriangleList& close() const { return close_; }
    bool all() const { return all_; }                         // memory has sufficed
    const TriangleList* refused() const { return refused_; }  // in order; null: none

  private:
    TriangleList leaves_;  // 16 x the leaf of the tree + bits of its triangles
    TriangleList near_, close_;
    const TriangleList* refused_ = nullptr;
    bool all_ = true, gathered_ = false;
};

// The solid as the mesh's tree turns it away.
inline SolidProbe probe_of(const Sphere& a, const Pose& A, Real slack)
{
    return {ProbeKind::kBall, A.p, A.R, {}, a.radius, slack};
}
inline SolidProbe probe_of(const Capsule& a, const Pose& A, Real slack)
{
    return {ProbeKind::kCapsule, A.p, A.R, {0, 0, a.half_length}, a.radius, slack};
}
inline SolidProbe probe_of(const Box& a, const Pose& A, Real slack)
{
    return {ProbeKind::kBox, A.p, A.R, a.half, 0, slack};
}
inline SolidProbe probe_of(const Cylinder& a, const Pose& A, Real slack)
{
    return {ProbeKind::kCylinder, A.p, A.R, {0, 0, a.half_length}, a.radius, slack};
}
inline SolidProbe probe_of(const Convex& a, const Pose& A, Real slack)
{
    const ConvexView view = view_of(a, A);
    return {ProbeKind::kBall, view.pose.p, A.R, {}, view.size, slack};
}

// By the box about it in its own frame.
inline SolidProbe probe_of(const AnySolid& a, const Pose& A, Real slack)
{
    const Aabb box = box_around(a, {}, 0);
    const Vec3 half = Real(0.5) * (box.hi - box.lo);
    return {ProbeKind::kBox, A.to_world(box.lo + half), A.R, half, 0, slack};
}

// Contacts within this part of the size count as touching. Some points of a solid that rests on many
// triangles hover by the solver's residual error, and their contacts must persist.
inline constexpr Real kMeshTouch = Real(1e-7);

// What counts as nothing where the solid is: rounding of coordinates, and of what rests.
Real slack_of(const ConvexView& solid);

// Contacts go from the mesh into the solid; side2 is the triangle. Of every shape that has a volume.
template <typename Shape>
void mesh_contacts(const Shape& a, const Pose& A, const Surface& surface, NearTriangles& near,
                   ContactSink& sink);

}  // namespace epode
