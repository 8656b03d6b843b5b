// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See face_materials.h. A contact lies within the surface by its depth, or beyond it by a gap: the box in which triangles are
// looked for grows until it has some.
#include "collide/face_materials.h"

#include <algorithm>
#include <cmath>

#include "base/memory.h"
#include "collide/surfaces/heightfield.h"
#include "collide/surfaces/trimesh.h"
#include "geometry/closest.h"

namespace epode {
namespace {

const TrimeshData* mesh_of(const Geom& geom)
{
    return geom.type->number == dTriMeshClass ? static_cast<const ShapeGeom<Trimesh>&>(geom).shape.mesh()
                                              : nullptr;
}

const HeightfieldData* field_of(const Geom& geom)
{
    return geom.type->number == dHeightfieldClass
               ? static_cast<const ShapeGeom<Heightfield>&>(geom).shape.field()
               : nullptr;
}

int remainder_of(int i, int period) { return (i % period + period) % period; }

int cell_at(const HeightfieldData& field, Vec3 at)
{
    const Terrain terrain(field);
    int i = 0, j = 0;
    if (!terrain.cell_under(at, i, j)) return -1;
    return remainder_of(i, terrain.cells_x()) + terrain.cells_x() * remainder_of(j, terrain.cells_z());
}

Real distance2(const TriangleMesh& mesh, int t, Vec3 p)
{
    const Vec3 n = mesh.normal(t);
    Vec3 v[3];
    for (int k = 0; k < 3; ++k) v[k] = mesh.corner(t, k);
    bool is_over = true;
    Real nearest2 = kInf;
    for (int k = 0; k < 3; ++k) {
        const Vec3 a = v[k], b = v[(k + 1) % 3];
        is_over = is_over && dot(cross(b - a, n), p - a) <= 0;
        nearest2 = std::min(nearest2, length2(p - a - closest_on_segment(a, b, p) * (b - a)));
    }
    const Real height = dot(n, p - v[0]);
    return is_over ? height * height : nearest2;
}

// Of the triangles in a box about the point: the nearest, those that look along n before others, the first of equals.
int nearest_triangle(const TrimeshData& data, Vec3 p, Vec3 n, Real reach)
{
    constexpr Real kAlong = Real(0.7);
    const Vec3 r{reach, reach, reach};
    int best = -1;
    bool best_looks = false;
    Real best2 = kInf;
    data.tree.query(data.mesh, {p - r, p + r}, [&](int t) {
        const bool looks = std::fabs(dot(data.mesh.normal(t), n)) >= kAlong;
        const Real here2 = distance2(data.mesh, t, p);
        const bool nearer = here2 != best2 ? here2 < best2 : t < best;
        if (best < 0 || (looks != best_looks ? looks : nearer)) best = t, best_looks = looks, best2 = here2;
        return true;
    });
    return best;
}

int triangle_at(const TrimeshData& data, Vec3 p, Vec3 n)
{
    constexpr Real kFirst = Real(1e-3), kGrowth = 8;
    constexpr int kTries = 4;
    const Vec3 side = data.tree.box().hi - data.tree.box().lo;
    Real reach = kFirst * std::max({side.x, side.y, side.z});
    for (int i = 0; i < kTries; ++i, reach *= kGrowth)
        if (const int t = nearest_triangle(data, p, n, reach); t >= 0) return t;
    return -1;
}

}  // namespace

int face_count(const Geom& geom)
{
    if (const TrimeshData* mesh = mesh_of(geom)) return mesh->mesh.triangle_count();
    const HeightfieldData* field = field_of(geom);
    return field ? (field->nx - 1) * (field->nz - 1) : 0;
}

int face_at(const Geom& geom, Vec3 at, Vec3 n)
{
    const Pose pose = load_pose(geom.position, geom.rotation);
    const Vec3 local = pose.to_local(at);
    if (const HeightfieldData* field = field_of(geom)) return cell_at(*field, local);
    const TrimeshData* mesh = mesh_of(geom);
    return mesh ? triangle_at(*mesh, local, transposed_times(pose.R, n)) : -1;
}

void drop_material(Geom& geom)
{
    GeomMaterial* const material = own_material(geom);
    if (!material) return;
    if (material->faces) {
        material->faces->~FaceMaterials();
        release(material->faces, sizeof(FaceMaterials));
    }
    release(material, sizeof(GeomMaterial));
    geom.material = nullptr;
}

}  // namespace epode
