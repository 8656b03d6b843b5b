// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See triangle_set.h. A field that reaches beyond the range of whole numbers is cut off there.
#include "query/triangle_set.h"

#include <limits>

namespace epode {
namespace {

constexpr Real kMostCells = Real(1e9);

int wrapped(int i, int period)
{
    const int rest = i % period;
    return rest < 0 ? rest + period : rest;
}

}  // namespace

TriangleSet::TriangleSet(const TrimeshData& mesh)
    : mesh_(&mesh), box_(mesh.tree.box()), period_(box_), count_(mesh.mesh.triangle_count())
{}

TriangleSet::TriangleSet(const HeightfieldData& field) : field_(&field)
{
    // Numbers of walls go beyond int for huge fields; these are asked by place only.
    const std::int64_t all = std::int64_t(field.hole_count > 0 ? 5 : 1) * 2 * (field.nx - 1) * (field.nz - 1);
    count_ = int(std::min<std::int64_t>(all, std::numeric_limits<int>::max()));
    const Vec3 half = {field.width / 2, 0, field.depth / 2};
    box_ = period_ = {Vec3{0, field.lowest, 0} - half, Vec3{0, field.highest, 0} + half};
    if (field.wrap) box_ = {{-kInf, field.lowest, -kInf}, {kInf, field.highest, kInf}};
}

bool TriangleSet::triangle(int t, Triangle& out) const
{
    if (!mesh_) return facet_or_wall(t, out);
    if (mesh_->mesh.degenerate(t)) return false;
    for (int k = 0; k < 3; ++k) out.v[k] = mesh_->mesh.corner(t, k);
    out.n = mesh_->mesh.normal(t);
    out.c = dot(out.n, out.v[0]);
    return true;
}

bool TriangleSet::facet_or_wall(int t, Triangle& out) const
{
    const Terrain terrain(*field_);
    const bool face = t < facets();
    const int facet = face ? t : int(t - facets()) / 4, columns = field_->nx - 1;
    const int i = facet / 2 % columns, j = facet / 2 / columns;
    if (terrain.hole(i, j)) return false;
    const Facet f = terrain.facet(i, j, (facet & 1) != 0);
    if (face) {
        out = f;
        return true;
    }
    const int rest = int(t - facets()) % 4, k = rest & 2;
    Triangle wall[2];
    if (!terrain.hole_beyond(f, k) || !terrain.wall_below(f, k, wall)) return false;
    out = wall[rest & 1];
    return true;
}

TriangleSet::CellRange TriangleSet::cells_under(const Aabb& box, int axis) const
{
    const Terrain terrain(*field_);
    const Real origin = terrain.low_corner()[axis], cell = terrain.cell()[axis];
    const int count = axis == 0 ? terrain.cells_x() : terrain.cells_z();
    const Real least = endless() ? -kMostCells : 0, highest = endless() ? kMostCells : Real(count - 1);
    return {int(std::clamp(std::floor((box.lo[axis] - origin) / cell), least, highest)),
            int(std::clamp(std::floor((box.hi[axis] - origin) / cell), least, highest))};
}

std::int64_t TriangleSet::number(int i, int j, bool upper) const
{
    const int columns = field_->nx - 1, rows = field_->nz - 1;
    return 2 * (wrapped(i, columns) + std::int64_t(wrapped(j, rows)) * columns) + (upper ? 1 : 0);
}

}  // namespace epode
