// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The pairs of geoms in which one is a mesh (except rays and planes), and the calls of the program's
// functions: with spheres, boxes, capsules and cylinders the array callback receives all near triangles once,
// and the triangle callback is called for each of them. Triangles that it refuses are left out.
#include <algorithm>

#include "collide/pairs/solid_pairs.h"
#include "collide/pairs/surfaces/mesh_contacts.h"
#include "collide/pairs/surfaces/mesh_mesh.h"
#include "collide/surfaces/closed_mesh.h"
#include "collide/surfaces/mesh_functions.h"

namespace epode {

namespace {

void consult(const Trimesh& mesh, const Surface& surface, const Aabb& box, NearTriangles& near,
             TriangleList& refused, const ContactSink& sink)
{
    const MeshFunctions functions(mesh, sink, false);
    near.gather(surface, box);
    near.put_in_order();
    functions.report({near.near().begin(), std::size_t(near.near().count())});
    near.filter([&](int t) { return functions.wants(t); }, refused);
}

// Of a mesh that is solid, a shape whose middle is inside goes out by the nearest way, as from a plane there.
template <typename Shape>
bool pushed_out(const Shape& a, const Pose& A, const TrimeshData& mesh, const Pose& B, ContactSink& sink)
{
    WayOut way;
    if (!way_out_of(mesh.mesh, mesh.tree, view_of(a, A).pose.p, way)) return false;
    const int before = sink.count();
    on_plane(a, A, {way.normal, dot(way.normal, way.nearest)}, sink);
    for (int k = before; k < sink.count(); ++k) sink.at(k)->side2 = way.triangle;
    to_world(B, sink, before);
    return true;
}

template <typename Shape>
void collide_mesh(const Shape& a, const Pose& A, const Trimesh& b, const Pose& B, ContactSink& sink)
{
    const TrimeshData* data = b.mesh();
    if (!data) return;
    const Surface surface{data->mesh, data->tree};
    const Pose local = inverse_times(B, A);
    if (b.is_solid() && pushed_out(a, local, *data, B, sink)) return;
    const Real slack = slack_of(view_of(a, local));
    NearTriangles near;
    TriangleList refused;
    const Aabb box = box_around(a, local, slack);
    near.find(surface, box, probe_of(a, local, slack), sink.kept());
    if (b.has_callbacks()) consult(b, surface, box, near, refused, sink);
    sink.number_merged(nullptr, b.merged);
    const int before = sink.count();
    mesh_contacts(a, local, surface, near, sink);
    to_world(B, sink, before);
}

// The mean normal of a ball's contacts, each as much as it is deep.
bool mean_normal(const ContactSink& sink, int before, Vec3& mean)
{
    mean = {};
    for (int k = before; k < sink.count(); ++k) mean += sink.at(k)->depth * load(sink.at(k)->normal);
    return normalize(mean);
}

// All of a ball's contacts become one: in their middle, as deep as the deepest along the new normal.
void make_one(ContactSink& sink, int before, Vec3 normal)
{
    dContactGeom& one = *sink.at(before);
    Vec3 middle = {};
    Real depth = 0, deepest = one.depth;
    int triangle = one.side2;
    for (int k = before; k < sink.count(); ++k) {
        const dContactGeom& c = *sink.at(k);
        const Real cosine = dot(load(c.normal), normal), along = c.depth / std::max(Real(0.5), cosine);
        middle += load(c.pos), depth = std::max(depth, along);
        triangle = sink.merged(1, triangle, c.side2, c.depth > deepest ? c.side2 : triangle);
        deepest = std::max(deepest, c.depth);
    }
    store(one.pos, (1 / Real(sink.count() - before)) * middle);
    store(one.normal, normal);
    one.depth = depth, one.side2 = triangle;
    sink.keep_first(before + 1);
}

// As the program has requested by dGeomLowLevelControl.
void merge(const Trimesh& mesh, int before, ContactSink& sink)
{
    Vec3 normal;
    const bool any = mesh.merging != dGeomColliderMergeContactsValue_None && !sink.unimportant();
    if (!any || sink.count() - before < 2 || !mean_normal(sink, before, normal)) return;
    if (mesh.merging == dGeomColliderMergeContactsValue_Full) return make_one(sink, before, normal);
    for (int k = before; k < sink.count(); ++k) store(sink.at(k)->normal, normal);
}

}  // namespace

void sphere_trimesh(const Sphere& a, const Pose& A, const Trimesh& b, const Pose& B, ContactSink& sink)
{
    const int before = sink.count();
    collide_mesh(a, A, b, B, sink);
    if (sink.to_program()) merge(b, before, sink);
}
void box_trimesh(const Box& a, const Pose& A, const Trimesh& b, const Pose& B, ContactSink& sink)
{
    collide_mesh(a, A, b, B, sink);
}
void capsule_trimesh(const Capsule& a, const Pose& A, const Trimesh& b, const Pose& B, ContactSink& sink)
{
    collide_mesh(a, A, b, B, sink);
}
void cylinder_trimesh(const Cylinder& a, const Pose& A, const Trimesh& b, const Pose& B, ContactSink& sink)
{
    collide_mesh(a, A, b, B, sink);
}
void convex_trimesh(const Convex& a, const Pose& A, const Trimesh& b, const Pose& B, ContactSink& sink)
{
    if (a.solid) collide_mesh(a, A, b, B, sink);
}

void solid_trimesh(const Geom& a, const Pose& A, const Geom& mesh, const Pose& M, ContactSink& sink)
{
    collide_mesh(AnySolid(a), A, static_cast<const ShapeGeom<Trimesh>&>(mesh).shape, M, sink);
}

void trimesh_trimesh(const Trimesh& a, const Pose& A, const Trimesh& b, const Pose& B, ContactSink& sink)
{
    const TrimeshData *first = a.mesh(), *second = b.mesh();
    if (!first || !second) return;
    sink.number_merged(a.merged, b.merged);
    mesh_mesh_contacts({first->mesh, first->tree}, A, {second->mesh, second->tree}, B, sink);
}

void trimesh_heightfield(const Trimesh& a, const Pose& A, const Heightfield& b, const Pose& B,
                         ContactSink& sink)
{
    const TrimeshData* mesh = a.mesh();
    const HeightfieldData* field = b.field();
    sink.number_merged(a.merged, nullptr);
    if (mesh && field) mesh_terrain_contacts({mesh->mesh, mesh->tree}, A, *field, B, sink);
}

}  // namespace epode
