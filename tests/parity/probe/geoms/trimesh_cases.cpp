// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Triangle meshes: what is read back of data and geoms, bounding boxes, rays with their flags and the
// program's functions, vertices under a plane, mass. The original keeps vertices as floats, hence the
// tolerance. Contacts of solids with triangles differ on purpose (docs/compat.md) and are judged elsewhere.
#include "case_list.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace parity {
namespace {

// A bumpy closed surface about the origin, made of rings; coordinates are floats.
struct Mesh {
    static constexpr int kAround = 9, kRings = 5;
    std::vector<float> singles;
    std::vector<dReal> reals;
    std::vector<double> doubles;
    std::vector<dTriIndex> indices;
    std::vector<dReal> normals;  // not unit; handed back only

    explicit Mesh(Random& random, double bump)
    {
        put({0, 0, 1.5});
        put({0, 0, -1.25});
        for (int ring = 0; ring < kRings; ++ring)
            for (int i = 0; i < kAround; ++i) {
                const double turn = 2 * M_PI * i / kAround, height = 1 - 0.5 * ring;
                const double r = 1.5 - 0.5 * height * height + random.range(-bump, bump);
                put({r * std::cos(turn), r * std::sin(turn), height});
            }
        for (int i = 0; i < kAround; ++i) {
            const int next = (i + 1) % kAround, last = 2 + (kRings - 1) * kAround;
            add(0, 2 + i, 2 + next);
            add(1, last + next, last + i);
            for (int ring = 0; ring + 1 < kRings; ++ring) {
                const int a = 2 + ring * kAround + i, b = 2 + ring * kAround + next;
                add(a, a + kAround, b + kAround);
                add(a, b + kAround, b);
            }
        }
        normals.assign(indices.size(), 1);
    }
    void put(const Vec3& v)
    {
        for (const double x : {v.x, v.y, v.z}) {
            singles.push_back(static_cast<float>(x));
            doubles.push_back(singles.back());
            reals.push_back(singles.back());
        }
        reals.push_back(0);
    }
    void add(int a, int b, int c)
    {
        for (const int i : {a, b, c}) indices.push_back(static_cast<dTriIndex>(i));
    }
    int vertices() const { return static_cast<int>(singles.size() / 3); }
    int corners() const { return static_cast<int>(indices.size()); }

    void build(dTriMeshDataID data, int way) const
    {
        const int triangle = 3 * sizeof(dTriIndex), single = 3 * sizeof(float), twice = 3 * sizeof(double);
        const dTriIndex* t = indices.data();
        switch (way) {
            case 0:
                return dGeomTriMeshDataBuildSingle(data, singles.data(), single, vertices(), t, corners(),
                                                   triangle);
            case 1:
                return dGeomTriMeshDataBuildSingle1(data, singles.data(), single, vertices(), t, corners(),
                                                    triangle, normals.data());
            case 2:
                return dGeomTriMeshDataBuildDouble(data, doubles.data(), twice, vertices(), t, corners(),
                                                   triangle);
            case 3:
                return dGeomTriMeshDataBuildDouble1(data, doubles.data(), twice, vertices(), t, corners(),
                                                    triangle, normals.data());
            case 4:
                return dGeomTriMeshDataBuildSimple(data, reals.data(), vertices(), t, corners());
            default:
                return dGeomTriMeshDataBuildSimple1(data, reals.data(), vertices(), t, corners(),
                                                    reinterpret_cast<const int*>(normals.data()));
        }
    }
};

void place(Random& random, dGeomID g)
{
    const Vec3 p = random.in_cube(3);
    const Quat q = random.rotation(3);
    const dQuaternion turn = {q.w, q.x, q.y, q.z};
    dGeomSetPosition(g, p.x, p.y, p.z);
    dGeomSetQuaternion(g, turn);
}

void put_box(Output& out, const std::string& key, dGeomID g)
{
    dReal box[6] = {0};
    dGeomGetAABB(g, box);
    out.put(key, box, 6);
}

int g_calls = 0, g_triangles = 0;
double g_weight = 0;

int count_ray(dGeomID, dGeomID, int triangle, dReal u, dReal v)
{
    ++g_calls;
    g_triangles += triangle;
    g_weight += u + 3 * v;
    return triangle % 3 != 0;
}

int count_triangle(dGeomID mesh, dGeomID ray, int triangle)
{
    g_calls += dGeomGetClass(mesh) == dTriMeshClass && dGeomGetClass(ray) == dRayClass ? 100 : 0;
    return triangle % 5 != 0;
}

void take_array(dGeomID, dGeomID, const int*, int) {}
int merge(dGeomID, int first, int) { return first; }

// Hits in the order of their depths: the original's order is that of its tree.
void put_hits(Output& out, const std::string& key, dGeomID ray, dGeomID mesh)
{
    dContactGeom hits[32] = {};
    const int count = dCollide(ray, mesh, 32, hits, sizeof(dContactGeom));
    std::sort(hits, hits + count,
              [](const dContactGeom& a, const dContactGeom& b) { return a.depth < b.depth; });
    out.put(key + "/count", {static_cast<double>(count)});
    for (int i = 0; i < count; ++i) {
        const dContactGeom& c = hits[i];
        out.put(key + "/hit" + std::to_string(i),
                {c.depth, c.pos[0], c.pos[1], c.pos[2], c.normal[0], c.normal[1], c.normal[2],
                 static_cast<double>(c.side1), static_cast<double>(c.side2)});
    }
}

void aim(Random& random, dGeomID ray, dGeomID mesh)
{
    const dReal* p = dGeomGetPosition(mesh);
    const Vec3 from = random.in_cube(5), to = random.in_cube(1.2);
    dGeomRaySetLength(ray, 20);
    dGeomRaySet(ray, p[0] + from.x, p[1] + from.y, p[2] + from.z, to.x - from.x, to.y - from.y,
                to.z - from.z);
}

struct Scene {
    explicit Scene(Random& random, double bump = 0.3, int way = 4) : mesh(random, bump)
    {
        mesh.build(data, way);
        geom = dCreateTriMesh(nullptr, data, nullptr, nullptr, nullptr);
        place(random, geom);
    }
    ~Scene()
    {
        dGeomDestroy(geom);
        dGeomTriMeshDataDestroy(data);
    }
    Scene(const Scene&) = delete;
    Scene& operator=(const Scene&) = delete;
    Mesh mesh;
    dTriMeshDataID data = dGeomTriMeshDataCreate();
    dGeomID geom = nullptr;
};

PARITY_CASE(trimesh_geom)
{
    for (int way = 0; way < 6; ++way) {
        out.open_block("way" + std::to_string(way));
        const Scene s(rng, 0.3, way);
        put_box(out, "box", s.geom);
        out.put("count", {static_cast<double>(dGeomTriMeshGetTriangleCount(s.geom)),
                          static_cast<double>(dGeomGetClass(s.geom))});
        out.put("data", {dGeomTriMeshGetData(s.geom) == s.data ? 1.0 : 0.0,
                         dGeomTriMeshGetTriMeshDataID(s.geom) == s.data ? 1.0 : 0.0});
        for (int i = 0; i < 10; ++i) {
            dVector3 a, b, c, p;
            const int t = rng.below(s.mesh.corners() / 3);
            dGeomTriMeshGetTriangle(s.geom, t, &a, &b, &c);
            dGeomTriMeshGetPoint(s.geom, t, rng.unit(), rng.unit(), p);
            for (const dReal* v : {a, b, c, p}) out.put("corner", v, 3);
        }
        dsizeint size = 0;
        const void* normals = dGeomTriMeshDataGet2(s.data, dTRIMESHDATA_FACE_NORMALS, &size);
        out.put("normals",
                {normals == s.mesh.normals.data() ? 1.0 : 0.0, normals ? static_cast<double>(size) : 0.0});
        const dTriMeshDataID other = dGeomTriMeshDataCreate();
        Mesh(rng, 0.1).build(other, 4);
        dGeomTriMeshSetData(s.geom, other);
        out.put("other", {dGeomTriMeshGetData(s.geom) == other ? 1.0 : 0.0});
        dGeomTriMeshSetData(s.geom, s.data);
        dGeomTriMeshDataDestroy(other);
    }
}

PARITY_CASE(trimesh_settings)
{
    const Scene s(rng);
    dMatrix4 last;
    for (int i = 0; i < 16; ++i) last[i] = i * 0.5;
    out.put("last0", dGeomTriMeshGetLastTransform(s.geom), 16);
    dGeomTriMeshSetLastTransform(s.geom, last);
    out.put("last", dGeomTriMeshGetLastTransform(s.geom), 12);  // the original drops the last row
    for (int c = 0; c <= dHeightfieldClass; ++c) {
        const int before = dGeomTriMeshIsTCEnabled(s.geom, c);
        dGeomTriMeshEnableTC(s.geom, c, 1);
        out.put("tc", {static_cast<double>(before), static_cast<double>(dGeomTriMeshIsTCEnabled(s.geom, c))});
    }
    dGeomTriMeshClearTCCache(s.geom);
    out.put("none", {dGeomTriMeshGetCallback(s.geom) == nullptr ? 1.0 : 0.0,
                     dGeomTriMeshGetArrayCallback(s.geom) == nullptr ? 1.0 : 0.0,
                     dGeomTriMeshGetRayCallback(s.geom) == nullptr ? 1.0 : 0.0,
                     dGeomTriMeshGetTriMergeCallback(s.geom) == nullptr ? 1.0 : 0.0});
    dGeomTriMeshSetCallback(s.geom, count_triangle);
    dGeomTriMeshSetArrayCallback(s.geom, take_array);
    dGeomTriMeshSetRayCallback(s.geom, count_ray);
    dGeomTriMeshSetTriMergeCallback(s.geom, merge);
    out.put("set", {dGeomTriMeshGetCallback(s.geom) == count_triangle ? 1.0 : 0.0,
                    dGeomTriMeshGetArrayCallback(s.geom) == take_array ? 1.0 : 0.0,
                    dGeomTriMeshGetRayCallback(s.geom) == count_ray ? 1.0 : 0.0,
                    dGeomTriMeshGetTriMergeCallback(s.geom) == merge ? 1.0 : 0.0});
    const dGeomID made = dCreateTriMesh(nullptr, s.data, count_triangle, take_array, count_ray);
    out.put("made", {dGeomTriMeshGetCallback(made) == count_triangle ? 1.0 : 0.0,
                     dGeomTriMeshGetArrayCallback(made) == take_array ? 1.0 : 0.0,
                     dGeomTriMeshGetRayCallback(made) == count_ray ? 1.0 : 0.0});
    dGeomDestroy(made);
}

// How many edges and vertices are granted, not to which of their triangles: that is the original's own order.
PARITY_CASE(trimesh_use_flags)
{
    for (int trial = 0; trial < 10; ++trial) {
        out.open_block("t" + std::to_string(trial));
        const Scene s(rng, 0.3);
        unsigned char given[200] = {};
        unsigned char* flags = given;
        int size = 7;
        dGeomTriMeshDataGetBuffer(s.data, &flags, &size);
        out.put("none", {flags == nullptr ? 1.0 : 0.0});
        out.put("answer", {static_cast<double>(trial % 2 ? dGeomTriMeshDataPreprocess(s.data)
                                                         : dGeomTriMeshDataPreprocess2(s.data, 3, nullptr))});
        dGeomTriMeshDataGetBuffer(s.data, &flags, &size);
        int edges = 0, vertices = 0;
        for (int i = 0; flags && i < size; ++i) {
            edges += __builtin_popcount(flags[i] & 7u);
            vertices += __builtin_popcount(flags[i] & 56u);
        }
        out.put("granted",
                {static_cast<double>(size), static_cast<double>(edges), static_cast<double>(vertices)});
        dGeomTriMeshDataSetBuffer(s.data, given);
        out.put("given",
                {dGeomTriMeshDataGet2(s.data, dTRIMESHDATA_USE_FLAGS, nullptr) == given ? 1.0 : 0.0});
        dGeomTriMeshDataSet(s.data, dTRIMESHDATA_USE_FLAGS, nullptr);
        out.put("own", {dGeomTriMeshDataGet2(s.data, dTRIMESHDATA_USE_FLAGS, nullptr) == flags ? 1.0 : 0.0});
    }
}

PARITY_CASE(trimesh_rays)
{
    for (int trial = 0; trial < 40; ++trial) {
        out.open_block("t" + std::to_string(trial));
        const Scene s(rng, 0.3, trial % 6);
        const dGeomID ray = dCreateRay(nullptr, 1);
        for (int i = 0; i < 10; ++i) {
            aim(rng, ray, s.geom);
            const std::string key = "ray" + std::to_string(i);
            put_hits(out, key, ray, s.geom);
            dGeomRaySetBackfaceCull(ray, 1);
            put_hits(out, key + "/culled", ray, s.geom);
            dGeomRaySetClosestHit(ray, 1);
            put_hits(out, key + "/closest", ray, s.geom);
            dGeomRaySetBackfaceCull(ray, 0);
            dGeomRaySetClosestHit(ray, 0);
        }
        dGeomDestroy(ray);
    }
}

PARITY_CASE(trimesh_functions)
{
    for (int trial = 0; trial < 40; ++trial) {
        out.open_block("t" + std::to_string(trial));
        const Scene s(rng);
        const dGeomID ray = dCreateRay(nullptr, 1);
        aim(rng, ray, s.geom);
        g_calls = g_triangles = 0;
        g_weight = 0;
        if (trial % 3) { dGeomTriMeshSetRayCallback(s.geom, count_ray); }
        if (trial % 4) { dGeomTriMeshSetCallback(s.geom, count_triangle); }
        put_hits(out, "hits", ray, s.geom);
        out.put("calls", {static_cast<double>(g_calls), static_cast<double>(g_triangles)});
        out.put("weight", {g_weight});
        dGeomDestroy(ray);
    }
}

// Vertices moved by their amount along z, so that the update is seen by rays.
PARITY_CASE(trimesh_update)
{
    Scene s(rng, 0.2, 2);
    const dGeomID ray = dCreateRay(nullptr, 1);
    for (int trial = 0; trial < 10; ++trial) {
        out.open_block("t" + std::to_string(trial));
        for (std::size_t i = 2; i < s.mesh.doubles.size(); i += 3)
            s.mesh.doubles[i] = static_cast<float>(s.mesh.doubles[i] * 1.02);
        dGeomTriMeshDataUpdate(s.data);
        aim(rng, ray, s.geom);
        put_hits(out, "hits", ray, s.geom);
    }
    dGeomDestroy(ray);
}

PARITY_CASE(trimesh_plane)
{
    for (int trial = 0; trial < 40; ++trial) {
        out.open_block("t" + std::to_string(trial));
        const Scene s(rng);
        const dReal* p = dGeomGetPosition(s.geom);
        const Vec3 n = rng.direction();
        const dGeomID plane =
            dCreatePlane(nullptr, n.x, n.y, n.z, n.x * p[0] + n.y * p[1] + n.z * p[2] + rng.range(-1.5, 1.5));
        dContactGeom c[64] = {};
        const int count = trial % 2 ? dCollide(plane, s.geom, 64, c, sizeof(dContactGeom))
                                    : dCollide(s.geom, plane, 64, c, sizeof(dContactGeom));
        out.put("count", {static_cast<double>(count)});
        for (int i = 0; i < count; ++i)
            out.put("contact",
                    {c[i].depth, c[i].pos[0], c[i].pos[1], c[i].pos[2], c[i].normal[0], c[i].normal[1],
                     c[i].normal[2], static_cast<double>(c[i].side1), static_cast<double>(c[i].side2)});
        dGeomDestroy(plane);
    }
}

// Centred and not turned: elsewhere the original's inertia is counted twice (differences.tsv, C28).
PARITY_CASE(trimesh_mass)
{
    for (int trial = 0; trial < 20; ++trial) {
        out.open_block("t" + std::to_string(trial));
        const Scene s(rng, 0.2);
        dMass m;
        dGeomSetPosition(s.geom, 0, 0, 0);
        dMassSetTrimesh(&m, 1, s.geom);
        dGeomSetPosition(s.geom, -m.c[0], -m.c[1], -m.c[2]);
        if (trial % 2) {
            dMassSetTrimesh(&m, 3, s.geom);
        } else {
            dMassSetTrimeshTotal(&m, 3, s.geom);
        }
        out.put("mass", {m.mass});
        out.put("centre", m.c, 3);
        out.put_matrix3("inertia", m.I);
    }
}

// A flat sheet of four squares, each cut along a diagonal, and its middle: coordinates are exact.
dGeomID exact_sheet(dTriMeshDataID data)
{
    static const float corners[9][3] = {{-2, -2, 0}, {0, -2, 0}, {2, -2, 0}, {-2, 0, 0}, {0, 0, 0},
                                        {2, 0, 0},   {-2, 2, 0}, {0, 2, 0},  {2, 2, 0}};
    static const dTriIndex faces[8][3] = {{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4},
                                          {3, 4, 7}, {3, 7, 6}, {4, 5, 8}, {4, 8, 7}};
    dGeomTriMeshDataBuildSingle(data, corners, sizeof corners[0], 9, faces, 24, sizeof faces[0]);
    return dCreateTriMesh(nullptr, data, nullptr, nullptr, nullptr);
}

// A ball whose foot is on an edge or a corner of triangles in one plane has a contact with each of them; the
// places are on the mesh. Balls touch exactly, or sink in so little that no other triangle is in reach.
PARITY_CASE(trimesh_sphere_feet)
{
    const dTriMeshDataID data = dGeomTriMeshDataCreate();
    const dGeomID sheet = exact_sheet(data), ball = dCreateSphere(nullptr, 0.5);
    const double feet[][2] = {{1, 1}, {-1, -1}, {0.5, 0.5}, {0, 1}, {1, 0},   {-1, 0},   {0, -1},
                              {2, 1}, {-1, 2},  {2, 2},     {0, 0}, {-2, -2}, {1, 0.25}, {-1.5, 0.75}};
    for (const auto& foot : feet)
        for (const double depth : {0.0, 0.00390625, 0.03125}) {
            out.open_block(std::to_string(foot[0]) + "," + std::to_string(foot[1]) + "/" +
                           std::to_string(depth));
            dGeomSetPosition(ball, foot[0], foot[1], 0.5 - depth);
            dContactGeom found[16] = {};
            const int count = dCollide(ball, sheet, 16, found, sizeof(dContactGeom));
            std::sort(found, found + count,
                      [](const dContactGeom& a, const dContactGeom& b) { return a.side2 < b.side2; });
            out.put("count", {static_cast<double>(count)});
            for (int i = 0; i < count; ++i) {
                const dContactGeom& c = found[i];
                out.put("contact" + std::to_string(i), {c.depth, c.pos[0], c.pos[1], c.pos[2], c.normal[0],
                                                        c.normal[1], c.normal[2], double(c.side2)});
            }
        }
    dGeomDestroy(ball);
    dGeomDestroy(sheet);
    dGeomTriMeshDataDestroy(data);
}

}  // namespace
}  // namespace parity
