// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A solid against a mesh, everything in the mesh's frame. The triangles that the solid may touch are visited
// in the order of their numbers (mesh_facet.h), and their contacts are reduced together
// (contact_collector.h). If all triangles whose boxes overlap the solid's lie in one plane that extends past
// the solid, the plane's pair function answers: a flat mesh, however finely divided, is exactly a plane.
#pragma once

#include <algorithm>

#include "bvh/mesh_tree.h"
#include "collide/pairs/surfaces/on_surface.h"

namespace epode {

struct Surface {
    const TriangleMesh& mesh;
    const MeshTree& tree;
};

// Numbers of triangles: a list without bound that rarely needs memory.
class TriangleList {
  public:
    TriangleList() = default;
    TriangleList(const TriangleList&) = delete;
    TriangleList& operator=(const TriangleList&) = delete;

    bool add(int triangle)  // false without memory
    {
        if (count_ == capacity_ && !grow()) return false;
        data_[count_++] = triangle;
        return true;
    }
    void clear() { count_ = 0; }
    void sort();

    // Keeps those for which keep(triangle) holds.
    template <typename Keep>
    void filter(Keep&& keep)
    {
        int kept = 0;
        for (int i = 0; i < count_; ++i)
            if (keep(data_[i])) data_[kept++] = data_[i];
        count_ = kept;
    }

    const int* begin() const { return data_; }
    const int* end() const { return data_ + count_; }
    int count() const { return count_; }

  private:
    static constexpr int kFew = 128;
    bool grow();

    int few_[kFew];
    Array<int> many_;
    int* data_ = few_;
    int count_ = 0, capacity_ = kFew;
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
    // order.
    template <typename Keep>
    void filter(Keep&& keep)
    {
        const int before = near_.count();
        near_.filter(keep);
        all_ = all_ && near_.count() == before;
        close_.filter([this](int t) { return std::binary_search(near_.begin(), near_.end(), t); });
    }

    const TriangleList& near() const { return near_; }
    const TriangleList& close() const { return close_; }
    bool all() const { return all_; }  // none has been left out

  private:
    TriangleList leaves_;  // 16 x the leaf of the tree + bits of its triangles
    TriangleList near_, close_;
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
