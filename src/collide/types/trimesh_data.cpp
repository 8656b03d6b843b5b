// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Triangle mesh: building the data object. Everything is read and checked before anything is changed: a
// coordinate that is no usable number, an index beyond the vertices, a stride that makes vertices overlap.
// The program's arrays are read here and by dGeomTriMeshDataUpdate, never during a collision.
#include <cstring>

#include "base/float_environment.h"
#include "collide/surfaces/closed_mesh.h"
#include "collide/surfaces/height_function.h"
#include "collide/types/registry.h"

namespace epode {
namespace {

constexpr const char* kBad = "Bad argument(s)";

template <typename Number>
void read_vertex(const void* at, Vec3& out)
{
    Number x[3];
    std::memcpy(x, at, sizeof(x));
    out = {Real(x[0]), Real(x[1]), Real(x[2])};
}

// In both precisions beyond the range of Real is infinite, which is not usable.
Vec3 vertex(const MeshSource& s, int i)
{
    const char* at = static_cast<const char*>(s.vertices) + std::ptrdiff_t(i) * s.vertex_stride;
    Vec3 v;
    if (s.doubles)
        read_vertex<double>(at, v);
    else
        read_vertex<float>(at, v);
    return v;
}

bool triangle(const MeshSource& s, int t, MeshCorners& out)
{
    dTriIndex index[3];
    std::memcpy(index, static_cast<const char*>(s.indices) + std::ptrdiff_t(t) * s.triangle_stride,
                sizeof(index));
    for (int k = 0; k < 3; ++k) {
        if (std::uint64_t(index[k]) >= std::uint64_t(s.vertex_count)) return false;
        out.at[k] = int(index[k]);
    }
    return true;
}

// The reason of a refusal, or null.
const char* fault(const MeshSource& s)
{
    const int number = s.doubles ? int(sizeof(double)) : int(sizeof(float));
    if (!s.vertices || !s.indices || s.vertex_count < 1 || s.triangle_count < 1) return kBad;
    if (s.vertex_stride < 3 * number) return "the stride of the vertices is less than a vertex";
    if (s.triangle_stride < 3 * int(sizeof(dTriIndex)))
        return "the stride of the triangles is less than three indices";
    if (s.triangle_count > TriangleMesh::kMostTriangles) return "too many triangles";
    MeshCorners corners;
    for (int t = 0; t < s.triangle_count; ++t)
        if (!triangle(s, t, corners)) return "a triangle has an index beyond the vertices";
    for (int i = 0; i < s.vertex_count; ++i) {
        const Vec3 v = vertex(s, i);
        if (!usable(v.x) || !usable(v.y) || !usable(v.z)) return "a vertex is not a usable number";
    }
    return nullptr;
}

// Of a source without fault; false when memory is exhausted, and nothing has changed.
bool take(const MeshSource& s, TrimeshData& d)
{
    Array<Vec3> vertices;
    Array<MeshCorners> triangles;
    TriangleMesh mesh;
    MeshTree tree;
    if (!vertices.resize(s.vertex_count) || !triangles.resize(s.triangle_count)) return false;
    for (int i = 0; i < s.vertex_count; ++i) vertices[i] = vertex(s, i);
    for (int t = 0; t < s.triangle_count; ++t) (void)triangle(s, t, triangles[t]);
    const Real grain = s.doubles ? kEpsilon : Real(std::numeric_limits<float>::epsilon());
    if (!mesh.build(vertices, triangles, grain) || !tree.build(mesh)) return false;
    d.mesh = static_cast<TriangleMesh&&>(mesh);
    d.tree = static_cast<MeshTree&&>(tree);
    d.source = s;
    d.built = true;
    d.closed = is_closed(d.mesh);
    d.notify_geoms();
    return true;
}

const char* build(dTriMeshDataID id, const MeshSource& source, int index_count, const void* normals)
{
    const FloatEnvironment floats;
    TrimeshData* d = from_handle<TrimeshData>(id);
    if (!d || index_count % 3 != 0) return kBad;
    if (InHeightFunction::now()) return EPODE_HEIGHT_FUNCTION_TEXT;
    if (d->in_use()) return "Invalid operation during a collision";
    if (const char* reason = fault(source)) return reason;
    if (!take(source, *d)) return kOutOfMemory;
    d->face_normals = normals;
    d->given_flags = nullptr;
    d->use_flags.reset();
    return nullptr;
}

bool same_triangles(const TrimeshData& d)
{
    MeshCorners corners;
    for (int t = 0; t < d.source.triangle_count; ++t) {
        if (!triangle(d.source, t, corners)) return false;
        const MeshCorners& ours = d.mesh.corners(t);
        for (int k = 0; k < 3; ++k)
            if (ours.at[k] != corners.at[k]) return false;
    }
    return true;
}

// The triangle that uses each edge and vertex (dMESHDATAUSE_*). Concave edges are used by no triangle, nor are the
// vertices at their ends.
void make_use_flags(const TriangleMesh& mesh, unsigned char* flags)
{
    const int count = mesh.triangle_count();
    for (int t = 0; t < count; ++t) {
        unsigned bits = 0;
        for (int k = 0; k < 3 && !mesh.degenerate(t); ++k) {
            if (mesh.leads(t, k) && !mesh.hollow(t, k)) bits |= dMESHDATAUSE_EDGE1 << k;
            if (mesh.first_corner(t, k) == 3 * t + k) bits |= dMESHDATAUSE_VERTEX1 << k;
        }
        flags[t] = static_cast<unsigned char>(bits);
    }
    for (int t = 0; t < count; ++t)
        for (int k = 0; k < 3 && !mesh.degenerate(t); ++k) {
            if (!mesh.hollow(t, k)) continue;
            for (const int end : {k, (k + 1) % 3}) {
                const int owner = mesh.first_corner(t, end);
                flags[owner / 3] &= static_cast<unsigned char>(~(dMESHDATAUSE_VERTEX1 << owner % 3));
            }
        }
}

const char* update(dTriMeshDataID id)
{
    const FloatEnvironment floats;
    TrimeshData* d = from_handle<TrimeshData>(id);
    if (!d || !d->built) return kBad;
    if (InHeightFunction::now()) return EPODE_HEIGHT_FUNCTION_TEXT;
    if (d->in_use()) return "Invalid operation during a collision";
    if (const char* reason = fault(d->source)) return reason;
    if (same_triangles(*d)) {
        for (int i = 0; i < d->source.vertex_count; ++i) d->mesh.vertices()[i] = vertex(d->source, i);
        d->mesh.refresh();
        d->tree.refit(d->mesh);
        d->closed = is_closed(d->mesh);
        d->notify_geoms();
    } else if (!take(d->source, *d)) {
        return kOutOfMemory;
    }
    if (!d->use_flags.empty()) make_use_flags(d->mesh, d->use_flags.data());
    return nullptr;
}

bool all_unit(const void* normals, int count)
{
    const Real* n = static_cast<const Real*>(normals);
    constexpr Real kNear = kSingle ? Real(1e-4) : Real(1e-5);
    for (int t = 0; t < count; ++t)
        if (!(std::fabs(length2(load(n + 3 * std::ptrdiff_t(t))) - 1) < kNear)) return false;
    return true;
}

void* flags_of(TrimeshData& d)
{
    return d.given_flags ? d.given_flags : d.use_flags.empty() ? nullptr : d.use_flags.data();
}

// Vertices that have been moved by dGeomTriMeshDataUpdate lie in a tree of the old ones; here in a new one.
void load(TrimeshData& d, StructureStream& stream)
{
    bool flagged = false;
    Real grain = 0;
    Array<Vec3> vertices;
    Array<MeshCorners> triangles;
    stream.flag(flagged), stream.real(grain);
    const int vertex_count = stream.count(0, sizeof(Vec3), "vertices of a mesh");
    const int count = stream.count(0, sizeof(MeshCorners), "triangles of a mesh");
    if (!stream.demand(vertices.resize(vertex_count) && triangles.resize(count), kOutOfMemory)) return;
    for (Vec3& v : vertices) stream.vector(v);
    for (MeshCorners& corners : triangles) stream.numbers(corners.at, 3);
    bool good = vertex_count > 0 && count > 0 && count <= TriangleMesh::kMostTriangles && grain > 0 &&
                grain < Real(1e-3);
    for (const Vec3 v : vertices) good = good && usable(v.x) && usable(v.y) && usable(v.z);
    for (const MeshCorners& t : triangles)
        for (const int corner : t.at) good = good && corner >= 0 && corner < vertex_count;
    if (stream.failed() || !stream.demand(good, "a mesh in it has a corner that is no vertex")) return;
    const bool built = d.mesh.build(vertices, triangles, grain) && d.tree.build(d.mesh) &&
                       (!flagged || d.use_flags.resize(count));
    if (!stream.demand(built, kOutOfMemory)) return;
    d.built = true;
    d.closed = is_closed(d.mesh);
    if (flagged) make_use_flags(d.mesh, d.use_flags.data());
}

void save(const TrimeshData& d, StructureStream& stream)
{
    bool flagged = !d.use_flags.empty();
    Real grain = d.mesh.grain();
    stream.flag(flagged), stream.real(grain);
    (void)stream.count(d.mesh.vertex_count(), sizeof(Vec3), "");
    (void)stream.count(d.mesh.triangle_count(), sizeof(MeshCorners), "");
    for (int i = 0; i < d.mesh.vertex_count(); ++i) {
        Vec3 v = d.mesh.vertex(i);
        stream.vector(v);
    }
    for (int t = 0; t < d.mesh.triangle_count(); ++t) {
        MeshCorners corners = d.mesh.corners(t);
        stream.numbers(corners.at, 3);
    }
}

int preprocess(TrimeshData& d, unsigned requests)
{
    if (!d.built || !(requests & 1u << dTRIDATAPREPROCESS_BUILD_CONCAVE_EDGES)) return 1;
    if (!d.use_flags.resize(d.mesh.triangle_count())) return 0;
    make_use_flags(d.mesh, d.use_flags.data());
    return 1;
}

}  // namespace

TrimeshData* structure(TrimeshData* data, StructureStream& stream)
{
    TrimeshData* const d = data ? data : Pool<TrimeshData>::create();
    if (!stream.demand(d, kOutOfMemory)) return nullptr;
    bool built = d->built;
    stream.flag(built);
    if (built) stream.saves() ? save(*d, stream) : load(*d, stream);
    if (stream.saves() || !stream.failed()) return d;
    destroy(d);
    return nullptr;
}

void destroy(TrimeshData* data) { Pool<TrimeshData>::destroy(data); }

}  // namespace epode

using namespace epode;

#define EPODE_MESH_DATA(data, id, ...)                                           \
    ::epode::TrimeshData* data = ::epode::from_handle<::epode::TrimeshData>(id); \
    EPODE_USER(data __VA_OPT__(, ) __VA_ARGS__)

// One of the build functions. The arrays are its arguments, under the names of the interface.
#define EPODE_BUILD_MESH(is_double, vertex_stride, triangle_stride, normals)     \
    const MeshSource source{Vertices, vertex_stride,   VertexCount,   is_double, \
                            Indices,  triangle_stride, IndexCount / 3};          \
    const char* const refusal = build(g, source, IndexCount, normals);           \
    EPODE_USER_SAY(!refusal, refusal)

extern "C" {

dTriMeshDataID dGeomTriMeshDataCreate(void)
{
    const TrimeshData* data = Pool<TrimeshData>::create();
    EPODE_USER_SAY(data, kOutOfMemory, nullptr);
    return to_handle(data);
}

void dGeomTriMeshDataDestroy(dTriMeshDataID g)
{
    EPODE_MESH_DATA(data, g);
    EPODE_OUTSIDE_HEIGHT_FUNCTION();
    EPODE_USER_SAY(!data->in_use(), "Invalid operation during a collision");
    Pool<TrimeshData>::destroy(data);
}

void dGeomTriMeshDataBuildSingle(dTriMeshDataID g, const void* Vertices, int VertexStride, int VertexCount,
                                 const void* Indices, int IndexCount, int TriStride)
{
    EPODE_BUILD_MESH(false, VertexStride, TriStride, nullptr);
}

void dGeomTriMeshDataBuildSingle1(dTriMeshDataID g, const void* Vertices, int VertexStride, int VertexCount,
                                  const void* Indices, int IndexCount, int TriStride, const void* Normals)
{
    EPODE_BUILD_MESH(false, VertexStride, TriStride, Normals);
}

void dGeomTriMeshDataBuildDouble(dTriMeshDataID g, const void* Vertices, int VertexStride, int VertexCount,
                                 const void* Indices, int IndexCount, int TriStride)
{
    EPODE_BUILD_MESH(true, VertexStride, TriStride, nullptr);
}

void dGeomTriMeshDataBuildDouble1(dTriMeshDataID g, const void* Vertices, int VertexStride, int VertexCount,
                                  const void* Indices, int IndexCount, int TriStride, const void* Normals)
{
    EPODE_BUILD_MESH(true, VertexStride, TriStride, Normals);
}

void dGeomTriMeshDataBuildSimple(dTriMeshDataID g, const dReal* Vertices, int VertexCount,
                                 const dTriIndex* Indices, int IndexCount)
{
    EPODE_BUILD_MESH(!kSingle, int(4 * sizeof(dReal)), int(3 * sizeof(dTriIndex)), nullptr);
}

void dGeomTriMeshDataBuildSimple1(dTriMeshDataID g, const dReal* Vertices, int VertexCount,
                                  const dTriIndex* Indices, int IndexCount, const int* Normals)
{
    EPODE_BUILD_MESH(!kSingle, int(4 * sizeof(dReal)), int(3 * sizeof(dTriIndex)), Normals);
}

void dGeomTriMeshDataUpdate(dTriMeshDataID g)
{
    const char* const refusal = update(g);
    EPODE_USER_SAY(!refusal, refusal);
}

int dGeomTriMeshDataPreprocess2(dTriMeshDataID g, unsigned int buildRequestFlags,
                                const dintptr* requestExtraData)
{
    EPODE_MESH_DATA(data, g, 0);
    const bool angles = buildRequestFlags & 1u << dTRIDATAPREPROCESS_BUILD_FACE_ANGLES;
    if (angles && requestExtraData) {
        const dintptr extra = requestExtraData[dTRIDATAPREPROCESS_BUILD_FACE_ANGLES];
        EPODE_USER(extra >= dTRIDATAPREPROCESS_FACE_ANGLES_EXTRA__MIN &&
                       extra < dTRIDATAPREPROCESS_FACE_ANGLES_EXTRA__MAX,
                   0);
    }
    EPODE_USER_SAY(!buildRequestFlags || !data->built || !data->face_normals ||
                       all_unit(data->face_normals, data->mesh.triangle_count()),
                   "Mesh triangle normals must be normalized", 0);
    return preprocess(*data, buildRequestFlags);
}

int dGeomTriMeshDataPreprocess(dTriMeshDataID g)
{
    EPODE_MESH_DATA(data, g, 0);
    EPODE_USER_SAY(
        !data->built || !data->face_normals || all_unit(data->face_normals, data->mesh.triangle_count()),
        "Mesh triangle normals must be normalized", 0);
    return preprocess(*data, 1u << dTRIDATAPREPROCESS_BUILD_CONCAVE_EDGES);
}

void dGeomTriMeshDataSet(dTriMeshDataID g, int data_id, void* in_data)
{
    EPODE_MESH_DATA(data, g);
    EPODE_USER(data_id >= dTRIMESHDATA__MIN && data_id < dTRIMESHDATA__MAX);
    if (data_id == dTRIMESHDATA_FACE_NORMALS)
        data->face_normals = in_data;
    else
        data->given_flags = in_data;
}

void* dGeomTriMeshDataGet2(dTriMeshDataID g, int data_id, dsizeint* pout_size)
{
    EPODE_MESH_DATA(data, g, nullptr);
    EPODE_USER(data_id >= dTRIMESHDATA__MIN && data_id < dTRIMESHDATA__MAX, nullptr);
    const bool normals = data_id == dTRIMESHDATA_FACE_NORMALS;
    void* const found = normals ? const_cast<void*>(data->face_normals) : flags_of(*data);
    const dsizeint each = normals ? 3 * sizeof(dReal) : 1;
    if (pout_size) *pout_size = found ? each * dsizeint(data->mesh.triangle_count()) : 0;
    return found;
}

void dGeomTriMeshDataGetBuffer(dTriMeshDataID g, unsigned char** buf, int* bufLen)
{
    EPODE_MESH_DATA(data, g);
    void* const flags = flags_of(*data);
    if (buf) *buf = static_cast<unsigned char*>(flags);
    if (bufLen) *bufLen = flags ? data->mesh.triangle_count() : 0;
}

void dGeomTriMeshDataSetBuffer(dTriMeshDataID g, unsigned char* buf)
{
    EPODE_MESH_DATA(data, g);
    data->given_flags = buf;
}

}  // extern "C"
