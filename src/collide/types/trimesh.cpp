// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Triangle mesh: the geom, and the mass of what it encloses. Its bounding box is that of the data's box
// turned into the world, not that of every vertex turned: a geom that moves costs the same whatever its size.
#include <algorithm>
#include <cstring>

#include "base/float_environment.h"
#include "collide/describe.h"
#include "collide/solid_type.h"
#include "collide/surfaces/height_function.h"
#include "collide/types/registry.h"
#include "geometry/inertia.h"
#include "ode/ext.h"
#include "ode/mass.h"

namespace epode {
namespace {

Aabb aabb(Geom& geom)
{
    const Pose pose = load_pose(geom.position, geom.rotation);
    const TrimeshData* d = static_cast<const TrimeshGeom&>(geom).shape.mesh();
    if (!d) return {pose.p, pose.p};
    const Vec3 half = Real(0.5) * d->tree.box().hi - Real(0.5) * d->tree.box().lo;
    const Vec3 centre = pose.to_world(d->tree.box().lo + half);
    const Vec3 reach{dot(abs(pose.R.row0), half), dot(abs(pose.R.row1), half), dot(abs(pose.R.row2), half)};
    return {centre - reach, centre + reach};
}

Real half_thickness(const Geom& geom)
{
    const TrimeshData* d = static_cast<const TrimeshGeom&>(geom).shape.mesh();
    if (!d) return kInf;
    const Vec3 half = Real(0.5) * (d->tree.box().hi - d->tree.box().lo);
    return thickness_at_least(std::min(std::min(half.x, half.y), half.z), max_component(half));
}

void describe_trimesh(const Geom&, DifWriter& out) { out.text("type", "trimesh"); }

void fingerprint(const Geom& geom, ContentHash& hash)
{
    const Trimesh& shape = static_cast<const TrimeshGeom&>(geom).shape;
    hash.add(std::uint64_t(shape.solid));
    const TrimeshData* d = shape.mesh();
    if (!d) return;
    const TriangleMesh& mesh = d->mesh;
    for (int i = 0; i < mesh.vertex_count(); ++i) {
        const Vec3 v = mesh.vertex(i);
        hash.add({v.x, v.y, v.z});
    }
    for (int t = 0; t < mesh.triangle_count(); ++t)
        for (const int corner : mesh.corners(t).at) hash.add(std::uint64_t(corner));
}

void structure(Geom& geom, ShapeStream& stream)
{
    TrimeshGeom& mesh = static_cast<TrimeshGeom&>(geom);
    Trimesh& shape = mesh.shape;
    TrimeshData* const data =
        stream.shared<TrimeshData>(shape.data, epode::destroy,
                                   [](TrimeshData* d, StructureStream& s) { return epode::structure(d, s); });
    if (stream.loads()) mesh.use(data);
    stream.pointer(shape.wants), stream.pointer(shape.array_callback);
    stream.pointer(shape.ray_hits), stream.pointer(shape.merged);
    stream.number(shape.merging, int(dGeomColliderMergeContactsValue__Default),
                  int(dGeomColliderMergeContactsValue_Full) + 1,
                  "contacts of a mesh are merged in an unknown way");
    stream.flag(shape.solid);
    stream.reals(mesh.last_transform, 16);
    for (bool& coherent : mesh.coherent) stream.flag(coherent);
}

// The solid that the triangles enclose, where the geom is. False when they enclose nothing that can be told
// from rounding.
bool enclosed(TrimeshGeom& geom, Real density, MassProperties& out)
{
    const TrimeshData* d = geom.shape.mesh();
    if (!d) return false;
    const Pose pose = pose_of(geom);
    MeshMoments moments;
    for (int t = 0; t < d->mesh.triangle_count(); ++t)
        moments.add_triangle(pose.to_world(d->mesh.corner(t, 0)), pose.to_world(d->mesh.corner(t, 1)),
                             pose.to_world(d->mesh.corner(t, 2)));
    const Real size = max_component(d->tree.box().hi - d->tree.box().lo);
    if (!(std::fabs(moments.volume()) > 64 * kEpsilon * size * size * size)) return false;
    out = moments.properties(density);
    return true;
}

void put(dMass* m, const MassProperties& p)
{
    const Sym3& I = p.inertia;
    dMassSetParameters(m, p.mass, p.center.x, p.center.y, p.center.z, I.xx, I.yy, I.zz, I.xy, I.xz, I.yz);
}

// dGeomLowLevelControl: is there any control, and how contacts of a ball are merged.
int control_trimesh(Geom& geom, int control_class, int code, void* data, int* size)
{
    Trimesh& mesh = static_cast<TrimeshGeom&>(geom).shape;
    const bool any = control_class == dGeomColliderControlClass && code == dGeomCommonAnyControlCode;
    const bool merging = control_class == dGeomColliderControlClass &&
                         (code == dGeomColliderSetMergeSphereContactsControlCode ||
                          code == dGeomColliderGetMergeSphereContactsControlCode);
    const int wanted = merging ? int(sizeof(int)) : 0;
    const bool fits = *size == wanted && (data || !merging);
    *size = wanted;
    if (!merging || !fits) return any && fits;
    int& value = *static_cast<int*>(data);
    if (code == dGeomColliderGetMergeSphereContactsControlCode) return value = mesh.merging, 1;
    if (value < dGeomColliderMergeContactsValue__Default || value > dGeomColliderMergeContactsValue_Full)
        return 0;
    mesh.merging =
        value == dGeomColliderMergeContactsValue__Default ? int(dGeomColliderMergeContactsValue_None) : value;
    return 1;
}

}  // namespace

const GeomType kTrimeshType = {.number = dTriMeshClass,
                               .aabb = aabb,
                               .destroy = destroy_pooled<TrimeshGeom>,
                               .control = control_trimesh,
                               .describe = describe_trimesh,
                               .fingerprint = fingerprint,
                               .half_thickness = half_thickness,
                               .create = create_pooled<TrimeshGeom>,
                               .structure = structure};

}  // namespace epode

using namespace epode;

#define EPODE_TRIMESH_GEOM(geom, id, ...)                \
    auto* geom = ::epode::geom_as<::epode::Trimesh>(id); \
    EPODE_USER_SAY(geom, "The argument is not a trimesh" __VA_OPT__(, ) __VA_ARGS__)

// The two C functions of a function of the program that the geom keeps.
#define EPODE_TRIMESH_FUNCTION(set, get, Function, field) \
    void set(dGeomID g, Function* f)                      \
    {                                                     \
        EPODE_TRIMESH_GEOM(geom, g);                      \
        geom->shape.field = f;                            \
    }                                                     \
    Function* get(dGeomID g)                              \
    {                                                     \
        EPODE_TRIMESH_GEOM(geom, g, nullptr);             \
        return geom->shape.field;                         \
    }

extern "C" {

dGeomID dCreateTriMesh(dSpaceID space, dTriMeshDataID Data, dTriCallback* Callback,
                       dTriArrayCallback* ArrayCallback, dTriRayCallback* RayCallback)
{
    TrimeshData* data = from_handle<TrimeshData>(Data);
    EPODE_USER(data || !Data, nullptr);
    EPODE_PARENT_SPACE(space, nullptr);
    TrimeshGeom* geom = create_geom<Trimesh>(space);
    if (!geom) return nullptr;
    geom->use(data);
    geom->shape.wants = Callback;
    geom->shape.array_callback = ArrayCallback;
    geom->shape.ray_hits = RayCallback;
    mark_changed(*geom);
    return to_handle<Geom>(geom);
}

void dGeomTriMeshSetData(dGeomID g, dTriMeshDataID Data)
{
    EPODE_TRIMESH_GEOM(geom, g);
    TrimeshData* data = from_handle<TrimeshData>(Data);
    EPODE_USER(data || !Data);
    EPODE_OUTSIDE_HEIGHT_FUNCTION();
    EPODE_UNLOCKED(geom);
    EPODE_USER_SAY(!is_held(*geom), "Invalid operation during a collision");
    geom->use(data);
    mark_changed(*geom);
}

dTriMeshDataID dGeomTriMeshGetData(dGeomID g)
{
    EPODE_TRIMESH_GEOM(geom, g, nullptr);
    return to_handle(geom->shape.data);
}

dTriMeshDataID dGeomTriMeshGetTriMeshDataID(dGeomID g)
{
    EPODE_TRIMESH_GEOM(geom, g, nullptr);
    return to_handle(geom->shape.data);
}

// ---- functions of the program ----

EPODE_TRIMESH_FUNCTION(dGeomTriMeshSetCallback, dGeomTriMeshGetCallback, dTriCallback, wants)
EPODE_TRIMESH_FUNCTION(dGeomTriMeshSetArrayCallback, dGeomTriMeshGetArrayCallback, dTriArrayCallback,
                       array_callback)
EPODE_TRIMESH_FUNCTION(dGeomTriMeshSetRayCallback, dGeomTriMeshGetRayCallback, dTriRayCallback, ray_hits)
EPODE_TRIMESH_FUNCTION(dGeomTriMeshSetTriMergeCallback, dGeomTriMeshGetTriMergeCallback, dTriTriMergeCallback,
                       merged)

// ---- solid ----

void dGeomTriMeshSetSolid(dGeomID g, int solid)
{
    EPODE_TRIMESH_GEOM(geom, g);
    EPODE_USER(solid == 0 || solid == 1);
    EPODE_USER_SAY(!solid || geom->shape.mesh(), "the geom has no triangles");
    EPODE_USER_SAY(!solid || geom->shape.data->closed, "the mesh is not closed or looks inward");
    geom->shape.solid = solid != 0;
}

int dGeomTriMeshGetSolid(dGeomID g)
{
    EPODE_TRIMESH_GEOM(geom, g, 0);
    return geom->shape.is_solid();
}

// ---- triangles ----

int dGeomTriMeshGetTriangleCount(dGeomID g)
{
    EPODE_TRIMESH_GEOM(geom, g, 0);
    const TrimeshData* data = geom->shape.mesh();
    return data ? data->mesh.triangle_count() : 0;
}

void dGeomTriMeshGetTriangle(dGeomID g, int Index, dVector3* v0, dVector3* v1, dVector3* v2)
{
    EPODE_TRIMESH_GEOM(geom, g);
    EPODE_USER_SAY(v0 || v1 || v2, "A meaningless call");
    const TrimeshData* data = geom->shape.mesh();
    EPODE_USER(data && Index >= 0 && Index < data->mesh.triangle_count());
    const Pose pose = pose_of(*geom);
    dVector3* const out[3] = {v0, v1, v2};
    for (int k = 0; k < 3; ++k) {
        if (!out[k]) continue;
        store(*out[k], pose.to_world(data->mesh.corner(Index, k)));
        (*out[k])[3] = 0;
    }
}

void dGeomTriMeshGetPoint(dGeomID g, int Index, dReal u, dReal v, dVector3 Out)
{
    EPODE_TRIMESH_GEOM(geom, g);
    const TrimeshData* data = geom->shape.mesh();
    EPODE_USER(data && Out && Index >= 0 && Index < data->mesh.triangle_count() && usable(u) && usable(v));
    const TriangleMesh& mesh = data->mesh;
    const Vec3 p =
        (1 - u - v) * mesh.corner(Index, 0) + u * mesh.corner(Index, 1) + v * mesh.corner(Index, 2);
    store(Out, pose_of(*geom).to_world(p));
    Out[3] = 0;
}

// ---- kept for the program ----

void dGeomTriMeshSetLastTransform(dGeomID g, const dMatrix4 last_trans)
{
    EPODE_TRIMESH_GEOM(geom, g);
    EPODE_USER(last_trans && usable(last_trans, 16));
    std::memcpy(geom->last_transform, last_trans, sizeof(geom->last_transform));
}

const dReal* dGeomTriMeshGetLastTransform(dGeomID g)
{
    EPODE_TRIMESH_GEOM(geom, g, nullptr);
    return geom->last_transform;
}

void dGeomTriMeshEnableTC(dGeomID g, int geomClass, int enable)
{
    EPODE_TRIMESH_GEOM(geom, g);
    if (geomClass >= dSphereClass && geomClass <= dCapsuleClass) geom->coherent[geomClass] = enable != 0;
}

int dGeomTriMeshIsTCEnabled(dGeomID g, int geomClass)
{
    EPODE_TRIMESH_GEOM(geom, g, 0);
    return geomClass >= dSphereClass && geomClass <= dCapsuleClass && geom->coherent[geomClass];
}

void dGeomTriMeshClearTCCache(dGeomID g) { EPODE_TRIMESH_GEOM(geom, g); }

// ---- mass ----

void dMassSetTrimesh(dMass* m, dReal density, dGeomID g)
{
    const FloatEnvironment floats;
    EPODE_GEOM_AS(Trimesh, geom, g);
    MassProperties p;
    EPODE_USER(m && usable(density));
    EPODE_USER_SAY(enclosed(*geom, density, p), "the mesh encloses no volume");
    EPODE_USER(usable(p));
    put(m, p);
}

void dMassSetTrimeshTotal(dMass* m, dReal total_mass, dGeomID g)
{
    const FloatEnvironment floats;
    EPODE_GEOM_AS(Trimesh, geom, g);
    MassProperties p;
    EPODE_USER(m && usable(total_mass));
    EPODE_USER_SAY(enclosed(*geom, 1, p), "the mesh encloses no volume");
    p = with_mass(p, total_mass);
    EPODE_USER(usable(p));
    put(m, p);
}

}  // extern "C"
