// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Triangle meshes through the public functions: builders, refusals, lifetimes, what is kept for the program,
// and the mass of what triangles enclose.
#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "../api/message_recorder.h"
#include "../geometry/mesh_shapes.h"

#pragma GCC diagnostic ignored "-Wdeprecated-declarations"

namespace epode {
namespace {

constexpr double kNear = kSingle ? 1e-5 : 1e-12;

// The arrays of a figure, in every form that builders take, with gaps where strides allow them.
struct Arrays {
    struct FloatVertex {
        float x[3], gap[2];
    };
    struct DoubleVertex {
        double x[3], gap;
    };
    struct Triangle {
        dTriIndex at[3], gap;
    };
    explicit Arrays(const Figure& figure)
    {
        for (const Vec3 v : figure.vertices) {
            floats.push_back({{float(v.x), float(v.y), float(v.z)}, {9, 9}});
            doubles.push_back({{v.x, v.y, v.z}, 9});
            for (const Real x : {v.x, v.y, v.z, Real(0)}) simple.push_back(x);
        }
        for (const MeshCorners& c : figure.triangles) {
            triangles.push_back({{dTriIndex(c.at[0]), dTriIndex(c.at[1]), dTriIndex(c.at[2])}, 999});
            for (const int i : c.at) indices.push_back(dTriIndex(i));
        }
    }
    int vertex_count() const { return int(floats.size()); }
    int index_count() const { return int(indices.size()); }
    std::vector<FloatVertex> floats;
    std::vector<DoubleVertex> doubles;
    std::vector<Real> simple;
    std::vector<Triangle> triangles;
    std::vector<dTriIndex> indices;
};

struct TrimeshTest : testing::Test {
    TrimeshTest() { dInitODE(); }
    ~TrimeshTest() override { dCloseODE(); }

    void build(const Arrays& a, int way, const void* normals = nullptr)
    {
        const int nv = a.vertex_count(), ni = a.index_count();
        const float* f = a.floats.data()->x;
        const double* d = a.doubles.data()->x;
        const dTriIndex* t = a.triangles.data()->at;
        switch (way) {
            case 0:
                return dGeomTriMeshDataBuildSingle(data, f, sizeof(a.floats[0]), nv, t, ni,
                                                   sizeof(a.triangles[0]));
            case 1:
                return dGeomTriMeshDataBuildSingle1(data, f, sizeof(a.floats[0]), nv, t, ni,
                                                    sizeof(a.triangles[0]), normals);
            case 2:
                return dGeomTriMeshDataBuildDouble(data, d, sizeof(a.doubles[0]), nv, t, ni,
                                                   sizeof(a.triangles[0]));
            case 3:
                return dGeomTriMeshDataBuildDouble1(data, d, sizeof(a.doubles[0]), nv, t, ni,
                                                    sizeof(a.triangles[0]), normals);
            case 4:
                return dGeomTriMeshDataBuildSimple(data, a.simple.data(), nv, a.indices.data(), ni);
            default:
                return dGeomTriMeshDataBuildSimple1(data, a.simple.data(), nv, a.indices.data(), ni,
                                                    static_cast<const int*>(normals));
        }
    }
    Aabb box() const
    {
        dReal b[6];
        dGeomGetAABB(geom, b);
        return {{b[0], b[2], b[4]}, {b[1], b[3], b[5]}};
    }
    Vec3 corner(int t, int k) const
    {
        dVector3 v[3];
        dGeomTriMeshGetTriangle(geom, t, &v[0], &v[1], &v[2]);
        return load(v[k]);
    }

    dTriMeshDataID data = dGeomTriMeshDataCreate();
    dGeomID geom = dCreateTriMesh(nullptr, data, nullptr, nullptr, nullptr);
};

void expect_near(Vec3 a, Vec3 b, double tolerance = kNear) { EXPECT_LT(length(a - b), tolerance); }

TEST_F(TrimeshTest, all_builders_mean_the_same_mesh)
{
    const Figure figure = cube();
    const std::vector<Real> normals(36, Real(0.5));
    for (int way = 0; way < 6; ++way) {
        build(Arrays(figure), way, normals.data());  // the arrays are gone when this line is done
        ASSERT_EQ(dGeomTriMeshGetTriangleCount(geom), 12) << way;
        for (int t = 0; t < 12; ++t)
            for (int k = 0; k < 3; ++k)
                EXPECT_EQ(corner(t, k), figure.vertices[std::size_t(figure.triangles[std::size_t(t)].at[k])]);
        EXPECT_EQ(box().lo, (Vec3{Real(-0.5), Real(-0.5), Real(-0.5)}));
        dsizeint size = 0;
        EXPECT_EQ(dGeomTriMeshDataGet2(data, dTRIMESHDATA_FACE_NORMALS, &size) == normals.data(),
                  way % 2 == 1);
        EXPECT_EQ(size, way % 2 ? 36 * sizeof(dReal) : 0);
    }
}

TEST_F(TrimeshTest, bad_arrays_are_refused_and_change_nothing)
{
    build(Arrays(cube()), 4);
    const dReal nan = std::numeric_limits<dReal>::quiet_NaN();
    MessageRecorder said;
    const auto refused = [&](const char* text) {
        EXPECT_NE(said.take().find(text), std::string::npos) << text;
        EXPECT_EQ(dGeomTriMeshGetTriangleCount(geom), 12);
        EXPECT_EQ(corner(11, 2), (Vec3{Real(0.5), Real(-0.5), Real(0.5)}));
    };
    Arrays a(flat_grid(2, 2, 0));
    a.simple[5] = nan;
    build(a, 4);
    refused("a vertex is not a usable number in dGeomTriMeshDataBuildSimple()");
    a = Arrays(flat_grid(2, 2, 0));
    a.floats[3].x[1] = std::numeric_limits<float>::infinity();
    build(a, 0);
    refused("a vertex is not a usable number in dGeomTriMeshDataBuildSingle()");
    a.triangles[1].at[2] = 9;
    build(a, 2);
    refused("a triangle has an index beyond the vertices in dGeomTriMeshDataBuildDouble()");
    a.triangles[1].at[2] = ~dTriIndex(0);
    build(a, 3);
    refused("a triangle has an index beyond the vertices in dGeomTriMeshDataBuildDouble1()");
    a = Arrays(flat_grid(2, 2, 0));
    dGeomTriMeshDataBuildSingle(data, a.floats.data(), 8, 9, a.indices.data(), 24, 12);
    refused("the stride of the vertices is less than a vertex");
    dGeomTriMeshDataBuildSingle(data, a.floats.data(), 20, 9, a.indices.data(), 24, 8);
    refused("the stride of the triangles is less than three indices");
    for (const int bad : {-3, 0, 23}) {
        dGeomTriMeshDataBuildSimple(data, a.simple.data(), 9, a.indices.data(), bad);
        refused("Bad argument(s) in dGeomTriMeshDataBuildSimple()");
    }
    dGeomTriMeshDataBuildSimple(data, nullptr, 9, a.indices.data(), 24);
    refused("Bad argument(s)");
    dGeomTriMeshDataBuildSimple(data, a.simple.data(), 0, a.indices.data(), 24);
    refused("Bad argument(s)");
    dGeomTriMeshDataBuildSimple1(nullptr, a.simple.data(), 9, a.indices.data(), 24, nullptr);
    refused("Bad argument(s) in dGeomTriMeshDataBuildSimple1()");
}

TEST_F(TrimeshTest, update_follows_vertices_and_indices)
{
    Arrays a(flat_grid(2, 2, 0));
    dGeomTriMeshDataBuildSingle(data, a.floats.data(), 20, 9, a.triangles.data(), 24, 16);
    const dSpaceID space = dHashSpaceCreate(nullptr);
    dSpaceAdd(space, geom);
    EXPECT_EQ(box().hi.z, 0);
    a.floats[4].x[2] = 7;
    EXPECT_EQ(box().hi.z, 0);
    dGeomTriMeshDataUpdate(data);
    EXPECT_EQ(box().hi.z, 7);
    const dGeomID ray = dCreateRay(nullptr, 20);
    dGeomRaySet(ray, Real(1.01), Real(1.02), 10, 0, 0, -1);
    dContactGeom c[4];
    ASSERT_EQ(dCollide(ray, geom, 4, c, sizeof(c[0])), 1);
    EXPECT_GT(c[0].pos[2], Real(6.5));

    a.triangles[0].at[1] = 8;  // another triangle
    dGeomTriMeshDataUpdate(data);
    expect_near(corner(0, 1), {2, 2, 0});
    MessageRecorder said;
    a.triangles[0].at[1] = 77;
    dGeomTriMeshDataUpdate(data);
    EXPECT_NE(said.take().find("index beyond the vertices in dGeomTriMeshDataUpdate()"), std::string::npos);
    expect_near(corner(0, 1), {2, 2, 0});
    a.triangles[0].at[1] = 1;
    a.floats[0].x[0] = std::numeric_limits<float>::quiet_NaN();
    dGeomTriMeshDataUpdate(data);
    EXPECT_NE(said.take().find("not a usable number"), std::string::npos);
    EXPECT_EQ(box().hi.z, 7);
    const dTriMeshDataID empty = dGeomTriMeshDataCreate();
    dGeomTriMeshDataUpdate(empty);
    EXPECT_NE(said.take().find("Bad argument(s)"), std::string::npos);
    dGeomTriMeshDataDestroy(empty);
    dGeomDestroy(ray);
    dSpaceDestroy(space);
}

TEST_F(TrimeshTest, destroyed_data_leave_geoms_without_triangles)
{
    build(Arrays(cube()), 4);
    const dGeomID other = dCreateTriMesh(nullptr, data, nullptr, nullptr, nullptr);
    dGeomSetPosition(geom, 5, 0, 0);
    EXPECT_EQ(box().hi.x, Real(5.5));
    dGeomTriMeshDataDestroy(data);
    EXPECT_EQ(box().hi.x, 5);
    for (const dGeomID g : {geom, other}) {
        EXPECT_EQ(dGeomTriMeshGetData(g), nullptr);
        EXPECT_EQ(dGeomTriMeshGetTriangleCount(g), 0);
    }
    data = dGeomTriMeshDataCreate();
    build(Arrays(cube()), 4);
    dGeomTriMeshSetData(other, data);
    EXPECT_EQ(dGeomTriMeshGetTriMeshDataID(other), data);
    EXPECT_EQ(dGeomTriMeshGetTriangleCount(other), 12);
    EXPECT_EQ(dGeomTriMeshGetTriangleCount(geom), 0);
    dGeomDestroy(geom);
    dGeomDestroy(other);  // before the data, which must not remember it
    dGeomTriMeshDataDestroy(data);
    MessageRecorder said;
    dGeomTriMeshDataDestroy(data);
    EXPECT_NE(said.take().find("Bad argument(s)"), std::string::npos);
}

TEST_F(TrimeshTest, preprocessing_grants_every_edge_and_vertex_once)
{
    const auto flags = [&](const Figure& figure) {
        build(Arrays(figure), 4);
        EXPECT_EQ(dGeomTriMeshDataPreprocess(data), 1);
        unsigned char* buffer = nullptr;
        int size = 0;
        dGeomTriMeshDataGetBuffer(data, &buffer, &size);
        EXPECT_EQ(size, int(figure.triangles.size()));
        return std::vector<unsigned char>(buffer, buffer + size);
    };
    const auto count = [](const std::vector<unsigned char>& all, unsigned mask) {
        int sum = 0;
        for (const unsigned char f : all) sum += __builtin_popcount(f & mask);
        return sum;
    };
    EXPECT_EQ(flags({{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}},
                     {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}}}),
              (std::vector<unsigned char>{0x3f, 0x26, 0x3f}));
    const auto convex = flags(cube()), hollow = flags(reversed(cube()));
    EXPECT_EQ(count(convex, 7), 18);
    EXPECT_EQ(count(convex, 56), 8);
    EXPECT_EQ(count(hollow, 7), 6);  // the diagonals, which are flat
    EXPECT_EQ(count(hollow, 56), 0);
    const dintptr extra[2] = {0, 3};
    MessageRecorder said;
    EXPECT_EQ(dGeomTriMeshDataPreprocess2(data, 2, nullptr), 1);
    EXPECT_EQ(dGeomTriMeshDataPreprocess2(data, 1, extra), 1);  // not looked at
    EXPECT_EQ(said.take(), "");
    EXPECT_EQ(dGeomTriMeshDataPreprocess2(data, 2, extra), 0);
    EXPECT_NE(said.take().find("Bad argument(s)"), std::string::npos);
}

TEST_F(TrimeshTest, what_the_program_sets_is_given_back)
{
    build(Arrays(cube()), 4);
    unsigned char given[12] = {};
    Real normals[36] = {};
    dsizeint size = 0;
    EXPECT_EQ(dGeomTriMeshDataGet2(data, dTRIMESHDATA_USE_FLAGS, &size), nullptr);
    EXPECT_EQ(size, 0u);
    dGeomTriMeshDataPreprocess(data);
    void* const own = dGeomTriMeshDataGet2(data, dTRIMESHDATA_USE_FLAGS, &size);
    EXPECT_EQ(size, 12u);
    dGeomTriMeshDataSetBuffer(data, given);
    EXPECT_EQ(dGeomTriMeshDataGet2(data, dTRIMESHDATA_USE_FLAGS, nullptr), given);
    dGeomTriMeshDataSet(data, dTRIMESHDATA_USE_FLAGS, nullptr);
    EXPECT_EQ(dGeomTriMeshDataGet2(data, dTRIMESHDATA_USE_FLAGS, nullptr), own);
    dGeomTriMeshDataSet(data, dTRIMESHDATA_FACE_NORMALS, normals);
    EXPECT_EQ(dGeomTriMeshDataGet2(data, dTRIMESHDATA_FACE_NORMALS, &size), normals);
    EXPECT_EQ(size, sizeof(normals));
    MessageRecorder said;
    EXPECT_EQ(dGeomTriMeshDataPreprocess(data), 0);
    EXPECT_NE(said.take().find("Mesh triangle normals must be normalized"), std::string::npos);
    dGeomTriMeshDataSet(data, 2, normals);
    EXPECT_NE(said.take().find("Bad argument(s)"), std::string::npos);

    dMatrix4 last;
    for (int i = 0; i < 16; ++i) last[i] = i;
    for (int i = 0; i < 16; ++i) EXPECT_EQ(dGeomTriMeshGetLastTransform(geom)[i], 0);
    dGeomTriMeshSetLastTransform(geom, last);
    for (int i = 0; i < 16; ++i) EXPECT_EQ(dGeomTriMeshGetLastTransform(geom)[i], i);
    for (int c = -1; c < dGeomNumClasses; ++c) {
        EXPECT_EQ(dGeomTriMeshIsTCEnabled(geom, c), 0);
        dGeomTriMeshEnableTC(geom, c, 5);
        EXPECT_EQ(dGeomTriMeshIsTCEnabled(geom, c), c >= dSphereClass && c <= dCapsuleClass);
    }
    dGeomTriMeshClearTCCache(geom);
    EXPECT_EQ(dGeomTriMeshIsTCEnabled(geom, dBoxClass), 1);
}

TEST_F(TrimeshTest, triangles_and_points_are_returned_in_world_coordinates)
{
    build(Arrays(cube()), 4);
    dMatrix3 R;
    dRFromAxisAndAngle(R, 1, 2, 3, Real(0.7));
    dGeomSetRotation(geom, R);
    dGeomSetPosition(geom, 1, 2, 3);
    const Pose pose{{1, 2, 3}, load_mat(R)};
    const Figure figure = cube();
    Vec3 v[3];
    for (int k = 0; k < 3; ++k) v[k] = figure.vertices[std::size_t(figure.triangles[4].at[k])];
    dVector3 a = {9, 9, 9, 9}, out = {9, 9, 9, 9};
    dGeomTriMeshGetTriangle(geom, 4, nullptr, &a, nullptr);
    expect_near(load(a), pose.to_world(v[1]));
    EXPECT_EQ(a[3], 0);
    dGeomTriMeshGetPoint(geom, 4, Real(0.25), Real(0.5), out);
    expect_near(load(out), pose.to_world(Real(0.25) * (v[0] + v[1]) + Real(0.5) * v[2]));
    MessageRecorder said;
    dGeomTriMeshGetTriangle(geom, 4, nullptr, nullptr, nullptr);
    EXPECT_NE(said.take().find("A meaningless call"), std::string::npos);
    for (const int bad : {-1, 12}) {
        dGeomTriMeshGetTriangle(geom, bad, &a, nullptr, nullptr);
        EXPECT_NE(said.take().find("Bad argument(s) in dGeomTriMeshGetTriangle()"), std::string::npos);
        dGeomTriMeshGetPoint(geom, bad, 0, 0, out);
        EXPECT_NE(said.take().find("Bad argument(s) in dGeomTriMeshGetPoint()"), std::string::npos);
    }
    const dGeomID sphere = dCreateSphere(nullptr, 1);
    EXPECT_EQ(dGeomTriMeshGetTriangleCount(sphere), 0);
    EXPECT_NE(said.take().find("The argument is not a trimesh"), std::string::npos);
    dGeomDestroy(sphere);
}

// A box with corner at the origin: m = rho a b c, I about the origin m/3 (b^2 + c^2), products -m/4 a b.
TEST_F(TrimeshTest, the_mass_is_that_of_the_solid)
{
    Figure figure = cube();
    for (Vec3& v : figure.vertices) v = scale(v + Vec3{Real(0.5), Real(0.5), Real(0.5)}, {1, 2, 3});
    build(Arrays(figure), 4);
    dMass m;
    dMassSetTrimesh(&m, 2, geom);
    EXPECT_NEAR(m.mass, 12, 12 * kNear);
    expect_near(load(m.c), {Real(0.5), 1, Real(1.5)});
    EXPECT_NEAR(m.I[0], 4 * 13, 60 * kNear);
    EXPECT_NEAR(m.I[10], 4 * 5, 60 * kNear);
    EXPECT_NEAR(m.I[1], -3 * 2, 60 * kNear);
    EXPECT_NEAR(m.I[6], -3 * 6, 60 * kNear);
    dGeomSetPosition(geom, Real(-0.5), -1, Real(-1.5));
    m.setTrimeshTotal(6, geom);
    EXPECT_NEAR(m.mass, 6, 6 * kNear);
    expect_near(load(m.c), {});
    EXPECT_NEAR(m.I[0], 6.0 / 12 * 13, 60 * kNear);
    MessageRecorder said;
    build(Arrays(reversed(figure)), 4);
    m.setTrimesh(2, geom);
    EXPECT_NEAR(m.mass, -12, 12 * kNear);
    EXPECT_NE(said.take().find("mass must be > 0"), std::string::npos);
    dMassSetTrimeshTotal(&m, 6, geom);
    EXPECT_NEAR(m.mass, 6, 6 * kNear);
    EXPECT_NEAR(m.I[0], 6.0 / 12 * 13, 60 * kNear);
    build(Arrays(flat_grid(3, 3, Real(0.3))), 4);
    dMassSetTrimesh(&m, 1, geom);
    EXPECT_NE(said.take().find("the mesh encloses no volume in dMassSetTrimesh()"), std::string::npos);
    EXPECT_NEAR(m.mass, 6, 6 * kNear);
    const dGeomID sphere = dCreateSphere(nullptr, 1);
    dMassSetTrimeshTotal(&m, 1, sphere);
    EXPECT_NE(said.take().find("argument not a trimesh in dMassSetTrimeshTotal()"), std::string::npos);
    dGeomDestroy(sphere);
}

// Vertices that no triangle uses make the mesh one of many vertices, of which only those near are looked at.
TEST_F(TrimeshTest, a_plane_meets_small_and_large_meshes_alike)
{
    Figure figure = flat_grid(8, 8, 0);
    const dGeomID plane = dCreatePlane(nullptr, Real(0.28), 0, Real(0.96), Real(0.05));
    std::vector<dContactGeom> found[2];
    for (std::vector<dContactGeom>& contacts : found) {
        build(Arrays(figure), 4);
        for (const int capacity : {1, 4, 8, 20, 100}) {
            const std::size_t before = contacts.size();
            contacts.resize(before + std::size_t(capacity));
            const int count = dCollide(geom, plane, capacity, &contacts[before], sizeof(dContactGeom));
            EXPECT_GT(count, 0);
            contacts.resize(before + std::size_t(count));
        }
        for (int i = 0; i < 100; ++i) figure.vertices.push_back({Real(9 + i), 9, -9});
    }
    dGeomDestroy(plane);
    ASSERT_EQ(found[0].size(), found[1].size());
    for (std::size_t i = 0; i < found[0].size(); ++i) {
        for (int k = 0; k < 3; ++k) EXPECT_EQ(found[0][i].pos[k], found[1][i].pos[k]);
        EXPECT_EQ(found[0][i].depth, found[1][i].depth);
        EXPECT_EQ(found[0][i].side1, found[1][i].side1);
    }
}

TEST_F(TrimeshTest, memory_that_runs_out_changes_nothing)
{
    static int left;
    const auto allocate = [](dsizeint size) -> void* { return left-- > 0 ? std::malloc(size) : nullptr; };
    build(Arrays(cube()), 4);
    const Arrays grid(flat_grid(8, 8, 0));
    MessageRecorder said;
    dSetAllocHandler(allocate);
    int tries = 0;
    for (; tries < 60; ++tries) {
        left = tries;
        build(grid, 4);
        if (dGeomTriMeshGetTriangleCount(geom) != 12) break;
        EXPECT_NE(said.take().find("out of memory in dGeomTriMeshDataBuildSimple()"), std::string::npos);
        EXPECT_EQ(corner(11, 2), (Vec3{Real(0.5), Real(-0.5), Real(0.5)}));
    }
    dSetAllocHandler(nullptr);
    EXPECT_GT(tries, 5);
    EXPECT_EQ(dGeomTriMeshGetTriangleCount(geom), 128);
}

}  // namespace
}  // namespace epode
