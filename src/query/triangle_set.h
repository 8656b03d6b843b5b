// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A mesh or a height field as a set of numbered triangles in its own frame, for distance queries: all of
// them, and those whose boxes overlap a box. Cell (i, j) of a field has the triangles 2 (i + j nx) and the
// next one; in an endless field the numbers are those of the period. If a field has holes, the walls at the
// holes follow after its triangles, four walls of two triangles for each cell; a wall that is absent has no
// area.
#pragma once

#include <algorithm>

#include "collide/surfaces/heightfield.h"
#include "collide/surfaces/trimesh.h"

namespace epode {

inline Aabb box_around(const Triangle& t)
{
    return {min(t.v[0], min(t.v[1], t.v[2])), max(t.v[0], max(t.v[1], t.v[2]))};
}

// The box of a solid includes its radius.
inline Aabb box_around(const ConvexView& v)
{
    const Vec3 r{v.radius, v.radius, v.radius};
    const Vec3 hi = {v.support({1, 0, 0}).x, v.support({0, 1, 0}).y, v.support({0, 0, 1}).z};
    const Vec3 lo = {v.support({-1, 0, 0}).x, v.support({0, -1, 0}).y, v.support({0, 0, -1}).z};
    return {lo - r, hi + r};
}

inline Aabb grown(const Aabb& box, Real by)
{
    const Vec3 r{by, by, by};
    return {box.lo - r, box.hi + r};
}

// Between boxes; 0 when they overlap.
inline Real gap_between(const Aabb& a, const Aabb& b)
{
    return length(max(max(a.lo - b.hi, b.lo - a.hi), Vec3{}));
}

class TriangleSet {
  public:
    explicit TriangleSet(const TrimeshData& mesh);
    explicit TriangleSet(const HeightfieldData& field);

    bool endless() const { return field_ && field_->wrap; }
    const Aabb& box() const { return box_; }
    const Aabb& period() const { return period_; }  // the box; for an endless field, that of one period
    int count() const { return count_; }            // for an endless field: those of one period

    // False for one without area.
    bool triangle(int t, Triangle& out) const;

    // Calls visit(triangle, number) for all triangles with area whose boxes overlap `box`.
    template <typename Visit>
    void query(const Aabb& box, Visit&& visit) const
    {
        if (!overlap(box, box_)) return;
        if (mesh_) {
            mesh_->tree.query(mesh_->mesh, box, [&](int t) {
                Triangle triangle;
                if (this->triangle(t, triangle)) visit(triangle, t);
                return true;
            });
            return;
        }
        int first[2], last[2];
        cells_under(box, first, last);
        const Terrain terrain(*field_);
        for (int j = first[1]; j <= last[1]; ++j)
            for (int i = first[0]; i <= last[0]; ++i)
                for (const bool upper : {false, true}) {
                    if (terrain.hole(i, j)) continue;
                    const Facet f = terrain.facet(i, j, upper);
                    if (overlap(box_around(f), box)) visit(f, number(i, j, upper));
                    if (terrain.holed()) visit_walls(terrain, f, box, visit);
                }
    }

  private:
    template <typename Visit>
    void visit_walls(const Terrain& terrain, const Facet& f, const Aabb& box, Visit&& visit) const
    {
        for (const int k : {0, 2}) {
            Triangle wall[2];
            if (!terrain.hole_beyond(f, k) || !terrain.wall_below(f, k, wall)) continue;
            const int first = 4 * number(f.i, f.j, f.upper) + k;
            for (int n = 0; n < 2; ++n)
                if (overlap(box_around(wall[n]), box)) visit(wall[n], facets() + first + n);
        }
    }
    int facets() const { return 2 * (field_->nx - 1) * (field_->nz - 1); }
    void cells_under(const Aabb& box, int* first, int* last) const;
    int number(int i, int j, bool upper) const;
    bool facet_or_wall(int t, Triangle& out) const;

    const TrimeshData* mesh_ = nullptr;
    const HeightfieldData* field_ = nullptr;
    Aabb box_, period_;
    int count_ = 0;
};

}  // namespace epode
