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
#include "query/effort.h"

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

    // Calls visit(triangle, number) for all triangles with area whose boxes overlap `box`, as far as the effort goes.
    template <typename Visit>
    void query(const Aabb& box, Effort& effort, Visit&& visit) const
    {
        if (!overlap(box, box_)) return;
        if (!mesh_) return query_cells(box, effort, visit);
        mesh_->tree.query(mesh_->mesh, box, [&](int t) {
            Triangle triangle;
            if (this->triangle(t, triangle)) visit(triangle, t);
            return effort.spend(1);
        });
    }

  private:
    // Of the grid, along one axis.
    struct CellRange {
        int first, last;
        int middle() const { return first + (last - first) / 2; }
        bool has(int i) const { return i >= first && i <= last; }
        int from(int reach) const { return std::max(middle() - reach, first); }
        int to(int reach) const { return std::min(middle() + reach, last); }
    };

    // From the middle outwards, in square rings of cells.
    template <typename Visit>
    void query_cells(const Aabb& box, Effort& effort, Visit& visit) const
    {
        const CellRange x = cells_under(box, 0), z = cells_under(box, 2);
        const Terrain terrain(*field_);
        const auto look = [&](int i, int j) {
            if (!effort.spend(1)) return false;
            if (!terrain.hole(i, j)) visit_cell(terrain, i, j, box, visit);
            return true;
        };
        const int reach = std::max(x.last - x.middle(), z.last - z.middle());
        for (int r = 0; r <= reach; ++r)
            if (!each_in_ring(x, z, r, look)) return;
    }

    template <typename Look>
    static bool each_in_ring(const CellRange& x, const CellRange& z, int r, const Look& look)
    {
        const auto row = [&](int j) {
            for (int i = x.from(r); z.has(j) && i <= x.to(r); ++i)
                if (!look(i, j)) return false;
            return true;
        };
        const auto column = [&](int i) {
            for (int j = z.from(r - 1); x.has(i) && j <= z.to(r - 1); ++j)
                if (!look(i, j)) return false;
            return true;
        };
        if (r == 0) return row(z.middle());
        return row(z.middle() - r) && row(z.middle() + r) && column(x.middle() - r) && column(x.middle() + r);
    }

    template <typename Visit>
    void visit_cell(const Terrain& terrain, int i, int j, const Aabb& box, Visit& visit) const
    {
        Terrain::BareCell cell = terrain.bare_cell(i, j);
        const Real below = terrain.holed() ? terrain.thickness() : Real(0);
        if (cell.lowest - below > box.hi.y || cell.highest < box.lo.y) return;
        for (const bool upper : {false, true}) {
            Facet& f = cell.facets[upper];
            finish(f);
            if (overlap(box_around(f), box)) visit(f, int(number(i, j, upper)));
            if (terrain.holed()) visit_walls(terrain, f, box, visit);
        }
    }

    template <typename Visit>
    void visit_walls(const Terrain& terrain, const Facet& f, const Aabb& box, Visit&& visit) const
    {
        for (const int k : {0, 2}) {
            Triangle wall[2];
            if (!terrain.hole_beyond(f, k) || !terrain.wall_below(f, k, wall)) continue;
            const std::int64_t first = facets() + 4 * number(f.i, f.j, f.upper) + k;
            for (int n = 0; n < 2; ++n)
                if (overlap(box_around(wall[n]), box)) visit(wall[n], int(first + n));
        }
    }
    std::int64_t facets() const { return std::int64_t(2) * (field_->nx - 1) * (field_->nz - 1); }
    CellRange cells_under(const Aabb& box, int axis) const;
    // Of huge fields beyond int: then numbers differ no more, and nobody is given them.
    std::int64_t number(int i, int j, bool upper) const;
    bool facet_or_wall(int t, Triangle& out) const;

    const TrimeshData* mesh_ = nullptr;
    const HeightfieldData* field_ = nullptr;
    Aabb box_, period_;
    int count_ = 0;
};

}  // namespace epode
