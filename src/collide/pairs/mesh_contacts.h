// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A solid against a mesh, everything in the mesh's frame: triangles whose boxes meet the solid's are gone
// through in the order of their numbers (mesh_facet.h), their contacts gathered and thinned together
// (harvest.h). Where all of them lie in one plane that goes on past the solid, the plane's own pair function
// answers: a flat mesh, however finely cut, is a plane exactly.
#pragma once

#include <algorithm>

#include "bvh/mesh_tree.h"
#include "collide/pairs/on_surface.h"

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
        if (count_ == room_ && !grow()) return false;
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
    int count_ = 0, room_ = kFew;
};

// The triangles near a solid: all whose boxes meet its own, and of these, in order, the ones that it may
// touch.
class NearTriangles {
  public:
    // Without memory those that fit.
    void find(const Surface& surface, const Aabb& box);  // all of them are close
    void find(const Surface& surface, const Aabb& box, const SolidProbe& solid);

    void put_in_order() { near_.sort(); }

    // Keeps those for which keep(triangle) holds, which is asked once for each. They are in order.
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
    TriangleList near_, close_;
    bool all_ = true;
};

// The solid as the mesh's tree turns it away.
inline SolidProbe probe_of(const Sphere& a, const Pose& A, Real slack)
{
    return {.centre = A.p, .arm = {}, .round = a.radius, .axis = {}, .slack = slack};
}
inline SolidProbe probe_of(const Capsule& a, const Pose& A, Real slack)
{
    const Vec3 half = a.half_length * A.R.column(2);
    return {.centre = A.p, .arms = 1, .arm = {half}, .round = a.radius, .axis = {}, .slack = slack};
}
inline SolidProbe probe_of(const Box& a, const Pose& A, Real slack)
{
    const Mat3& R = A.R;
    return {.centre = A.p,
            .arms = 3,
            .arm = {a.half.x * R.column(0), a.half.y * R.column(1), a.half.z * R.column(2)},
            .round = 0,
            .axis = {},
            .slack = slack};
}
inline SolidProbe probe_of(const Cylinder& a, const Pose& A, Real slack)
{
    const Vec3 axis = A.R.column(2);
    return {.centre = A.p,
            .arms = 1,
            .arm = {a.half_length * axis},
            .round = a.radius,
            .axis = axis,
            .slack = slack};
}
inline SolidProbe probe_of(const Convex& a, const Pose& A, Real slack)
{
    return {.centre = A.p, .arm = {}, .round = view_of(a, A).size, .axis = {}, .slack = slack};
}

// Contacts within this part of the size count as touching: of a solid that rests on many triangles some
// points hover by what the solver leaves over, and must not come and go.
inline constexpr Real kMeshTouch = Real(1e-7);

// What counts as nothing where the solid is: rounding of coordinates, and of what rests.
Real slack_of(const ConvexView& solid);

// Contacts go from the mesh into the solid; side2 is the triangle. Of every shape that has a volume.
template <typename Shape>
void mesh_contacts(const Shape& a, const Pose& A, const Surface& surface, NearTriangles& near,
                   ContactSink& sink);

}  // namespace epode
