// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Structures that cannot be: a body joined to itself, objects of two worlds, spaces and transforms inside
// themselves, poses for what has none; sizes beyond all measure; and what is said of a refusal.
#include <gtest/gtest.h>

#include <chrono>
#include <climits>
#include <cmath>
#include <cstdio>
#include <limits>
#include <vector>

#include <ode/ext.h>
#include <ode/ode.h>

namespace {

int g_refusals = 0;
void receive(int, const char*, va_list) { ++g_refusals; }
void count_pair(void* count, dGeomID, dGeomID) { ++*static_cast<int*>(count); }
dReal flat(void*, int, int) { return 0; }

class Structure : public ::testing::Test {
  protected:
    Structure()
    {
        dInitODE2(0);
        dSetDebugHandler(receive);
        g_refusals = 0;
    }
    ~Structure() override
    {
        dSetDebugHandler(nullptr);
        dCloseODE();
    }
    void expect_refused(int count)
    {
        EXPECT_EQ(g_refusals, count);
        g_refusals = 0;
    }
};

TEST_F(Structure, a_joint_joins_two_bodies_of_its_world)
{
    const dWorldID world = dWorldCreate(), other = dWorldCreate();
    const dBodyID a = dBodyCreate(world), b = dBodyCreate(world), stranger = dBodyCreate(other);
    const dJointID joint = dJointCreateBall(world, nullptr);
    dJointAttach(joint, a, a);
    dJointAttach(joint, a, stranger);
    dJointAttach(joint, stranger, nullptr);
    expect_refused(3);
    EXPECT_EQ(dJointGetNumBodies(joint), 0);
    dJointAttach(joint, a, b);
    EXPECT_EQ(dAreConnected(a, b), 1);
    EXPECT_EQ(dAreConnected(a, stranger), 0);
    const dGeomID geom = dCreateSphere(nullptr, 1);
    dGeomSetBody(geom, a);
    dBodySetPosition(stranger, 7, 0, 0);
    dGeomSetBody(geom, stranger);  // geoms belong to no world
    EXPECT_EQ(dGeomGetPosition(geom)[0], 7);
    dWorldDestroy(other);
    EXPECT_EQ(dGeomGetBody(geom), nullptr);
    EXPECT_EQ(dGeomGetPosition(geom)[0], 7);
    EXPECT_EQ(dWorldStep(world, dReal(0.01)), 1);
    dGeomDestroy(geom);
    dWorldDestroy(world);
    expect_refused(0);
}

TEST_F(Structure, a_loose_joint_refuses_bad_numbers_and_takes_good_ones_in_silence)
{
    const dWorldID world = dWorldCreate();
    const dReal bad = std::numeric_limits<dReal>::quiet_NaN();
    const auto call_all = [world](dReal x) {
        const dJointID hinge = dJointCreateHinge(world, nullptr), slider = dJointCreateSlider(world, nullptr),
                       universal = dJointCreateUniversal(world, nullptr), pu = dJointCreatePU(world, nullptr),
                       piston = dJointCreatePiston(world, nullptr);
        dJointSetHingeAnchorDelta(hinge, 0, 0, 0, 0, 0, x);
        dJointSetHingeAxisOffset(hinge, 1, 0, 0, x);
        dJointSetSliderAxisDelta(slider, 1, 0, 0, x, 0, 0);
        dJointSetUniversalAxis1Offset(universal, 1, 0, 0, 0, x);
        dJointSetUniversalAxis2Offset(universal, 1, 0, 0, x, 0);
        dJointSetPUAnchorDelta(pu, 0, 0, 0, x, 0, 0);
        dJointSetPUAnchorOffset(pu, 0, 0, 0, 0, x, 0);
        dJointSetPistonAnchorOffset(piston, 0, 0, 0, 0, 0, x);
        dJointSetPistonAxisDelta(piston, 1, 0, 0, x, 0, 0);
    };
    call_all(1);
    expect_refused(0);
    call_all(bad);
    expect_refused(9);
    dWorldDestroy(world);
}

TEST_F(Structure, what_has_no_pose_gets_no_body)
{
    const dWorldID world = dWorldCreate();
    const dBodyID body = dBodyCreate(world);
    const dSpaceID space = dSimpleSpaceCreate(nullptr);
    const dHeightfieldDataID data = dGeomHeightfieldDataCreate();
    const dGeomID fixed[] = {dCreatePlane(space, 0, 0, 1, 0), dCreateHeightfield(space, data, 0),
                             reinterpret_cast<dGeomID>(space)};
    for (dGeomID g : fixed) {
        dGeomSetBody(g, body);
        dGeomSetPosition(g, 1, 2, 3);
        dGeomSetOffsetPosition(g, 1, 2, 3);
        EXPECT_EQ(dGeomGetPosition(g), nullptr);
        expect_refused(4);
        dGeomSetBody(g, nullptr);
        expect_refused(0);
    }
    EXPECT_EQ(dBodyGetFirstGeom(body), nullptr);
    dGeomSetBody(dCreateRay(space, 1), body);
    dGeomSetBody(dCreateHeightfield(space, data, 1), body);
    expect_refused(0);
    dSpaceDestroy(space);
    EXPECT_EQ(dBodyGetFirstGeom(body), nullptr);
    dGeomHeightfieldDataDestroy(data);
    dWorldDestroy(world);
}

TEST_F(Structure, spaces_hold_neither_themselves_nor_their_holders)
{
    const dSpaceID a = dSimpleSpaceCreate(nullptr), b = dHashSpaceCreate(a), c = dHashSpaceCreate(b);
    const auto geom = [](dSpaceID s) { return reinterpret_cast<dGeomID>(s); };
    dSpaceAdd(a, geom(a));
    dSpaceAdd(c, geom(a));
    dSpaceAdd(b, geom(c));
    expect_refused(3);
    dSpaceRemove(a, geom(b));
    dSpaceAdd(c, geom(b));
    expect_refused(1);
    dSpaceAdd(c, geom(a));
    EXPECT_EQ(dSpaceQuery(c, geom(a)), 1);
    expect_refused(0);
    dSpaceDestroy(b);
    EXPECT_EQ(dGeomIsSpace(geom(a)), 0) << "it went with the one around it";
}

TEST_F(Structure, nesting_ends_before_the_stack_does)
{
    const dSpaceID outermost = dSimpleSpaceCreate(nullptr);
    dSpaceID s = outermost;
    int depth = 1;
    for (dSpaceID next; depth < 1000 && (next = dSimpleSpaceCreate(s)) != nullptr; ++depth) s = next;
    EXPECT_EQ(depth, 100);
    expect_refused(1);
    const dSpaceID tall = dSimpleSpaceCreate(nullptr);
    dSimpleSpaceCreate(tall);
    dSpaceAdd(tall, reinterpret_cast<dGeomID>(outermost));
    expect_refused(1);
    dCreateSphere(s, 1);
    int count = 0;
    dSpaceCollide(outermost, &count, count_pair);
    dSpaceDestroy(outermost);
    dSpaceDestroy(tall);

    std::vector<dGeomID> line = {dCreateGeomTransform(nullptr)};
    dGeomTransformSetGeom(line[0], line[0]);
    expect_refused(1);
    while (g_refusals == 0 && line.size() < 1000) {
        const dGeomID outer = dCreateGeomTransform(nullptr);
        dGeomTransformSetGeom(outer, line.back());
        line.push_back(outer);
    }
    EXPECT_EQ(line.size(), 101u);
    g_refusals = 0;
    dGeomTransformSetGeom(line[0], line[50]);
    expect_refused(1);
    dReal box[6];
    dGeomGetAABB(line[99], box);
    for (dGeomID g : line) dGeomDestroy(g);
    expect_refused(0);
}

TEST_F(Structure, absurd_sizes_are_refused_or_bearable)
{
    const auto start = std::chrono::steady_clock::now();
    const dWorldID world = dWorldCreate();
    const dSpaceID space = dHashSpaceCreate(nullptr);
    const dVector3 big = {dReal(1e15), dReal(1e15), dReal(1e15), 0}, zero = {};
    dHashSpaceSetLevels(space, INT_MIN, INT_MAX);
    dSpaceDestroy(dQuadTreeSpaceCreate(space, zero, big, INT_MAX));
    EXPECT_EQ(dRandInt(-1), 0);
    EXPECT_EQ(dRandInt(INT_MIN), 0);
    expect_refused(0);
    dReal one = 1;
    EXPECT_EQ(dFactorCholesky(&one, -1), 0);
    EXPECT_EQ(dWorldStep(world, dReal(1e30) * dReal(1e8) * dReal(1e80)), 0);
    EXPECT_EQ(dWorldStepFast1(world, dReal(0.01), INT_MAX), 0);
    dWorldSetQuickStepNumIterations(world, INT_MAX);
    dWorldSetAutoDisableAverageSamplesCount(world, UINT_MAX);
    dWorldSetExactSubsteps(world, INT_MAX);
    dWorldSetStepThreads(world, INT_MAX);
    expect_refused(7);
    const dReal corners[12] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}, plane[4] = {1, 0, 0, 0};
    const unsigned polygon[4] = {UINT_MAX, 0, 1, 2};
    EXPECT_EQ(dCreateConvex(nullptr, plane, 1, corners, UINT_MAX, polygon), nullptr);
    EXPECT_EQ(dCreateConvex(nullptr, plane, UINT_MAX, corners, 4, polygon), nullptr);
    EXPECT_EQ(dCreateConvexHull(nullptr, corners, UINT_MAX, 0), nullptr);
    expect_refused(3);

    // Numbers that are usable themselves and make others that are not.
    const dReal huge = sizeof(dReal) == 4 ? dReal(1e17) : dReal(1e99),
                tiny = std::numeric_limits<dReal>::min();
    const dGeomID plane_geom = dCreatePlane(space, 0, 0, 1, 0), sphere = dCreateSphere(space, 1);
    dGeomPlaneSetParams(plane_geom, 0, 0, tiny, huge);
    expect_refused(1);
    const dGeomID held = dCreateSphere(space, 1);
    dGeomSetBody(held, dBodyCreate(world));
    const dQuaternion long_one = {huge, huge, huge, huge}, none = {};
    for (const dReal* q : {long_one, none}) {
        dGeomSetQuaternion(sphere, q);
        dGeomSetOffsetQuaternion(held, q);
        dGeomSetOffsetWorldQuaternion(held, q);
        expect_refused(q == none ? 3 : 0);
        for (const dGeomID geom : {sphere, held}) {
            dQuaternion unit;
            dGeomGetQuaternion(geom, unit);
            for (const dReal x : unit) EXPECT_NEAR(x, 0.5, 1e-6) << "normalised, and then kept";
        }
    }
    dGeomDestroy(held);
    dGeomDestroy(plane_geom);
    dGeomDestroy(sphere);

    // A field of 4 x 10^18 samples, and a solid over most of them.
    const dHeightfieldDataID data = dGeomHeightfieldDataCreate();
    dGeomHeightfieldDataBuildCallback(data, nullptr, flat, 1000, 1000, INT_MAX, INT_MAX, 1, 0, 1, 0);
    const dGeomID field = dCreateHeightfield(space, data, 1), box = dCreateBox(space, 400, 2, 400),
                  ray = dCreateRay(space, 5000);
    dGeomRaySet(ray, -600, 1, 0, 1, dReal(-0.001), 0);
    dContactGeom contact[4];
    dCollide(field, box, 4, contact, sizeof contact[0]);
    dCollide(field, ray, 4, contact, sizeof contact[0]);
    const dGeomID far = dCreateBox(space, big[0], big[0], big[0]);
    dGeomSetPosition(far, -big[0], big[0], 0);
    int count = 0;
    dSpaceCollide(space, &count, count_pair);
    EXPECT_GT(count, 0);
    const dBodyID body = dBodyCreate(world);
    dGeomSetBody(box, body);
    dBodySetLinearVel(body, big[0], 0, 0);
    for (int i = 0; i < 10; ++i) EXPECT_EQ(dWorldStep(world, dReal(1e15)), 1);
    EXPECT_TRUE(std::isfinite(dBodyGetPosition(body)[0]));
    dSpaceDestroy(space);
    dGeomHeightfieldDataDestroy(data);
    dWorldDestroy(world);
    EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), 60);
}

void refuse_here() { dBodySetPosition(nullptr, 0, 0, 0); }

TEST_F(Structure, without_a_handler_each_place_speaks_once)
{
    dSetDebugHandler(nullptr);
    testing::internal::CaptureStderr();
    for (int i = 0; i < 3; ++i) {
        refuse_here();
        dJointSetHingeAnchor(nullptr, 0, 0, 0);
    }
    const std::string said = testing::internal::GetCapturedStderr();
    const auto count = [&](const std::string& part) {
        int n = 0;
        for (std::size_t at = said.find(part); at != std::string::npos; at = said.find(part, at + 1)) ++n;
        return n;
    };
    EXPECT_EQ(count("Bad argument(s) in dBodySetPosition()"), 1) << said;
    EXPECT_EQ(count("Bad argument(s) in dJointSetHingeAnchor()"), 1) << said;
    dSetDebugHandler(receive);
    for (int i = 0; i < 3; ++i) refuse_here();
    expect_refused(3);
}

TEST_F(Structure, stale_handles_are_known_while_their_slot_is_in_use_again)
{
    const dWorldID world = dWorldCreate();
    const dBodyID old = dBodyCreate(world);
    dBodyDestroy(old);
    std::vector<dBodyID> young;
    for (int i = 0; i < 60; ++i) young.push_back(dBodyCreate(world));
    dBodySetPosition(old, 1, 2, 3);
    dBodyDestroy(old);
    expect_refused(2);
    for (dBodyID b : young) EXPECT_EQ(dBodyGetPosition(b)[0], 0);
    dWorldDestroy(world);
    dBodySetPosition(young[3], 1, 2, 3);
    dWorldStep(world, dReal(0.01));
    expect_refused(2);
}

}  // namespace
