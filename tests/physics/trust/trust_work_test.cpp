// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Sizes that the setters accept must not make a step or a query go on for ever: a ball of 1e6 m over a field of cells of a
// centimetre covers 1e16 of them. Work is counted, as calls of the height function, and never timed; the program
// learns that only a part was looked at.
#include <ode/ext.h>

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "rig.h"

namespace epode::physics {
namespace {

// A pair costs at most this many cells (src/query/effort.h), each four heights; contacts look at 256 by 256 cells.
constexpr long kCells = 1 << 22, kPerTriangle = 1 << 12, kHeights = 4, kContacts = 2'000'000;

long g_heights;
dReal hilly(void*, int i, int j) { return ++g_heights, dReal(0.02) * dReal((i * 7 + j * 3) % 5); }
dReal rare_hills(void*, int i, int j)
{
    return ++g_heights, i % 11 == 0 && j % 11 == 0 ? dReal(0.05) : dReal(0);
}
dReal flat(void*, int, int) { return ++g_heights, 0; }

std::string g_said;
int g_messages;
void keep_message(int, const char* text, va_list arguments)
{
    char line[512];
    std::vsnprintf(line, sizeof line, text, arguments);
    g_said = line, ++g_messages;
}

struct TrustWork : testing::Test {
    TrustWork()
    {
        dSetMessageHandler(&keep_message);
        dWorldSetContactSpace(world, space);
        g_heights = g_messages = 0;
        g_said.clear();
    }
    ~TrustWork() override
    {
        dSetMessageHandler(nullptr);
        dWorldDestroy(world), dSpaceDestroy(space);
        dGeomHeightfieldDataDestroy(heights);
        if (mesh) dGeomTriMeshDataDestroy(mesh);
    }
    // A field that repeats every 11 cells; its height axis is the world's z.
    dGeomID field(dHeightfieldGetHeight* height, dReal cell)
    {
        dGeomHeightfieldDataBuildCallback(heights, nullptr, height, 11 * cell, 11 * cell, 12, 12, 1, 0, 1, 1);
        dGeomHeightfieldDataSetBounds(heights, 0, dReal(0.08));
        const dGeomID geom = dCreateHeightfield(space, heights, 1);
        dMatrix3 up;
        dRFromAxisAndAngle(up, 1, 0, 0, dReal(M_PI / 2));
        dGeomSetRotation(geom, up);
        return geom;
    }
    // A bumpy sheet of 2 n^2 triangles of a metre.
    dGeomID sheet(int n)
    {
        std::vector<double> v;
        std::vector<dTriIndex> t;
        for (int i = 0; i <= n; ++i)
            for (int j = 0; j <= n; ++j)
                for (const double x : {i - n / 2.0, j - n / 2.0, 0.06 * ((i * 7 + j * 13) % 5)})
                    v.push_back(x);
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j)
                for (const int corner : {0, n + 1, 1, 1, n + 1, n + 2})
                    t.push_back(dTriIndex(i * (n + 1) + j + corner));
        corners = v, triangles = t;
        mesh = dGeomTriMeshDataCreate();
        dGeomTriMeshDataBuildDouble(mesh, corners.data(), 3 * sizeof(double), int(v.size() / 3),
                                    triangles.data(), int(t.size()), 3 * sizeof(dTriIndex));
        return dCreateTriMesh(space, mesh, nullptr, nullptr, nullptr);
    }
    // At most once for a world, or once for a query.
    static void expect_reported(const char* what)
    {
        EXPECT_EQ(g_messages, 1) << g_said;
        EXPECT_NE(g_said.find(what), std::string::npos) << g_said;
    }
    dWorldID world = dWorldCreate();
    dSpaceID space = dHashSpaceCreate(nullptr);
    dHeightfieldDataID heights = dGeomHeightfieldDataCreate();
    dTriMeshDataID mesh = nullptr;
    std::vector<double> corners;
    std::vector<dTriIndex> triangles;
};

// 128 triangles of a metre that fall onto cells of nine millimetres cost 40 s a step.
TEST_F(TrustWork, of_a_continuous_mesh_over_a_field_of_tiny_cells)
{
    constexpr int n = 8;
    const dGeomID geom = sheet(n);
    field(hilly, dReal(0.1) / 11);
    const dBodyID body = dBodyCreate(world);
    dGeomSetBody(geom, body);
    dGeomSetContinuous(geom, dContinuousOn);
    for (int step = 0; step < 2; ++step) {
        dBodySetPosition(body, 0, 0, dReal(0.8));  // above the hills: contacts have nothing to do yet
        dBodySetLinearVel(body, 0, 0, -100);
        g_heights = 0;
        ASSERT_EQ(dWorldStepHybrid(world, dReal(0.01)), 1);
        EXPECT_GT(g_heights, 1000);
        EXPECT_LT(g_heights, kHeights * (kCells + kPerTriangle * 2 * n * n) + kContacts);
    }
    expect_reported("continuous collision");
}

// It stands on a corner between two hills, which it does not touch, and its box has all hills in it.
TEST_F(TrustWork, of_a_huge_sensor_over_a_field_of_tiny_cells)
{
    const dReal side = dReal(tol(1e6, 1e3));
    const dBodyID body = dBodyCreate(world);
    const dGeomID sensor = dCreateBox(space, side, side, side);
    dGeomSetBody(sensor, body);
    dGeomSetSensor(sensor, 1);
    dBodySetGravityMode(body, 0);
    dMatrix3 on_corner;
    dRFromAxisAndAngle(on_corner, 1, -1, 0, std::acos(1 / std::sqrt(dReal(3))));
    dBodySetRotation(body, on_corner);
    dBodySetPosition(body, 0, 0, side * std::sqrt(dReal(3)) / 2 + dReal(0.03));
    field(rare_hills, dReal(0.01));
    dEventSettings settings;
    dEventSettingsInit(&settings, sizeof settings);
    settings.kinds = 1 << dEventSensorBegin | 1 << dEventSensorEnd;
    ASSERT_EQ(dWorldSetEventSettings(world, &settings), 1);
    for (int step = 0; step < 2; ++step) {
        dBodySetLinearVel(body, dReal(0.1), 0, 0);
        g_heights = 0;
        ASSERT_EQ(dWorldStepHybrid(world, dReal(0.01)), 1);
        EXPECT_GT(g_heights, 1000);
        EXPECT_LT(g_heights, kHeights * kCells + kContacts);
        EXPECT_EQ(dWorldGetEvents(world, nullptr, 0), 0) << "they do not touch";
    }
    expect_reported("a sensor");
    g_heights = g_messages = 0;
    dGeomID found[4];
    EXPECT_EQ(dSpaceOverlap(space, sensor, nullptr, found, 4), 0);
    EXPECT_LT(g_heights, kHeights * kCells + kContacts);
    expect_reported("dSpaceOverlap");
}

TEST_F(TrustWork, of_queries_is_bounded_and_the_answer_is_of_the_middle)
{
    const dReal radius = dReal(tol(1e6, 1e3)), above = dReal(0.25);
    const dGeomID ball = dCreateSphere(space, radius), ground = field(flat, dReal(0.01));
    dGeomSetPosition(ball, 0, 0, radius + above);
    dQueryDistance gap{};
    ASSERT_EQ(dGeomGetDistance(ball, ground, dInfinity, &gap), 1);
    EXPECT_NEAR(gap.distance, above, tol(1e-6, 2e-4));  // two units in the last place of the radius
    EXPECT_LT(g_heights, kHeights * kCells + kContacts);
    expect_reported("dGeomGetDistance");

    g_heights = g_messages = 0;
    const dVector3 down = {0, 0, -1, 0};
    dQueryHit hit{};
    ASSERT_EQ(dGeomCast(ball, down, ground, &hit), 1);
    EXPECT_NEAR(hit.distance, above, tol(0.011, 0.11))
        << "solids touch within 1e-8 (floats: 1e-4) of their size";
    EXPECT_LT(g_heights, kHeights * kCells + kContacts);
    expect_reported("dGeomCast");
}

// So far up, more cells lie in the ball's box than are looked at, and the nearest are those in the middle.
TEST_F(TrustWork, far_above_a_fine_field_distances_are_exact)
{
    const dGeomID ball = dCreateSphere(space, dReal(0.5)), ground = field(flat, dReal(0.05));
    dGeomSetPosition(ball, dReal(0.013), dReal(0.017), 100);
    dQueryDistance gap{};
    ASSERT_EQ(dGeomGetDistance(ball, ground, dInfinity, &gap), 1);
    EXPECT_NEAR(gap.distance, 99.5, tol(1e-9, 1e-4));
    // What lies x aside is further away by x^2/200: not by one unit in the last place of a float up to x^2 = 200 * 100 epsilon.
    EXPECT_NEAR(gap.pos2[0], 0.013, tol(1e-9, 100 * std::sqrt(2 * kEpsilon)));
    EXPECT_LT(g_heights, kHeights * kCells + kContacts);
}

// A field of a function may have any number of cells, although it does not repeat.
TEST_F(TrustWork, of_a_plane_and_a_field_of_a_million_million_cells)
{
    dGeomHeightfieldDataBuildCallback(heights, nullptr, flat, 1000, 1000, 1 << 20, 1 << 20, 1, 0, 1, 0);
    dGeomHeightfieldDataSetBounds(heights, 0, 0);
    const dGeomID ground = dCreateHeightfield(space, heights, 1), plane = dCreatePlane(space, 0, 1, 0, -3);
    dQueryDistance gap{};
    ASSERT_EQ(dGeomGetDistance(ground, plane, dInfinity, &gap), 1);
    EXPECT_NEAR(gap.distance, 3, tol(1e-9, 1e-4));
    EXPECT_LT(g_heights, kHeights * kCells + kContacts);
    expect_reported("dGeomGetDistance");
}

// What is looked at as a whole is reported of by nobody.
TEST_F(TrustWork, of_usual_sizes_is_not_reported)
{
    const dGeomID ball = dCreateSphere(space, dReal(0.5)), ground = field(hilly, dReal(0.1));
    dGeomSetPosition(ball, 0, 0, 2);
    dQueryDistance gap{};
    ASSERT_EQ(dGeomGetDistance(ball, ground, dInfinity, &gap), 1);
    const dBodyID body = dBodyCreate(world);
    dGeomSetBody(ball, body);
    dGeomSetContinuous(ball, dContinuousOn);
    dBodySetPosition(body, 0, 0, 2);
    dBodySetLinearVel(body, 0, 0, -400);
    ASSERT_EQ(dWorldStepHybrid(world, dReal(0.01)), 1);
    EXPECT_GT(dBodyGetPosition(body)[2], 0.3) << "stopped";
    EXPECT_EQ(g_messages, 0) << g_said;
}

}  // namespace
}  // namespace epode::physics
