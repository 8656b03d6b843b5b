// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A solid against a mesh, everything in the mesh's frame: triangles whose boxes meet the solid's are gone
// through in the order of their numbers (mesh_facet.h), their contacts gathered and thinned together
// (harvest.h). Where all of them lie in one plane that goes on past the solid, the plane's own pair function
// answers: a flat mesh, however finely cut, is a plane exactly.
#pragma once

#include "bvh/mesh_tree.h"
#include "collide/pairs/on_surface.h"

namespace epode {

struct Surface {
    const TriangleMesh& mesh;
    const MeshTree& tree;
};

// The triangles near a solid: a list without bound that rarely needs memory.
class NearTriangles {
  public:
    NearTriangles() = default;
    NearTriangles(const NearTriangles&) = delete;
    NearTriangles& operator=(const NearTriangles&) = delete;

    // All whose boxes meet `box`, in order. Without memory those that fit.
    void find(const Surface& surface, const Aabb& box);

    // Keeps those for which keep(triangle) holds.
    template <typename Keep>
    void filter(Keep&& keep)
    {
        int kept = 0;
        for (int i = 0; i < count_; ++i)
            if (keep(data_[i])) data_[kept++] = data_[i];
        all_ = all_ && kept == count_;
        count_ = kept;
    }

    const int* begin() const { return data_; }
    const int* end() const { return data_ + count_; }
    int count() const { return count_; }
    bool all() const { return all_; }  // none has been left out

  private:
    static constexpr int kFew = 256;
    void add(int triangle);

    int few_[kFew];
    Array<int> many_;
    int* data_ = few_;
    int count_ = 0;
    bool all_ = true;
};

// What counts as nothing where the solid is: rounding of coordinates, and of what rests.
Real slack_of(const ConvexView& solid);

// Contacts go from the mesh into the solid; side2 is the triangle. Of every shape that has a volume.
template <typename Shape>
void mesh_contacts(const Shape& a, const Pose& A, const Surface& surface, const NearTriangles& near,
                   ContactSink& sink);

}  // namespace epode
