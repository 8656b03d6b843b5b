// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What a program may not do from inside its own functions while the library is calling them, said by example:
// near callbacks, moved callbacks, functions of user classes, height functions, functions of meshes,
// destructor functions, and those that give a step its memory. Each test makes the calls that would pull the
// library's feet away, sees them refused or harmless, and goes on working with the same world.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include <ode/ext.h>
#include <ode/ode.h>

namespace {

int g_refusals = 0;
std::string g_text;
void receive(int, const char* format, va_list arguments)
{
    char text[256];
    std::vsnprintf(text, sizeof text, format, arguments);
    g_text = text;
    ++g_refusals;
}

std::function<void()> g_act;
void act()
{
    if (!g_act) return;
    const auto once = std::move(g_act);
    g_act = nullptr;
    once();
}

void near_callback(void* count, dGeomID, dGeomID)
{
    if (count) ++*static_cast<int*>(count);
    act();
}
void moved_callback(dBodyID) { act(); }
dReal height(void*, int, int)
{
    act();
    return 0;
}
int collide_user(dGeomID, dGeomID, int, dContactGeom*, int)
{
    act();
    return 0;
}
dColliderFn* collider_for(int) { return collide_user; }
void user_box(dGeomID, dReal box[6])
{
    for (int i = 0; i < 6; ++i) box[i] = i % 2 ? dReal(1) : dReal(-1);
    act();
}
void user_end(dGeomID) { act(); }

class Callbacks : public ::testing::Test {
  protected:
    Callbacks()
    {
        dInitODE2(0);
        dSetDebugHandler(receive);
        g_refusals = 0;
        g_act = nullptr;
        world = dWorldCreate();
        space = dHashSpaceCreate(nullptr);
        body = dBodyCreate(world);
        for (dGeomID& g : sphere) g = dCreateSphere(space, 1);
        dGeomSetBody(sphere[0], body);
        lone = dCreateSphere(nullptr, 1);
        const dGeomClass description = {8, collider_for, user_box, nullptr, user_end};
        user_class = dCreateGeomClass(&description);
    }
    ~Callbacks() override
    {
        g_act = nullptr;
        dSpaceDestroy(space);
        dWorldDestroy(world);
        dGeomDestroy(lone);
        dSetDebugHandler(nullptr);
        dCloseODE();
    }

    // That many calls have been refused since the last time.
    void expect_refused(int count)
    {
        EXPECT_EQ(g_refusals, count) << g_text;
        g_refusals = 0;
    }
    int pairs()
    {
        int count = 0;
        dSpaceCollide(space, &count, near_callback);
        return count;
    }

    dWorldID world;
    dSpaceID space;
    dBodyID body;
    dGeomID sphere[3], lone;
    int user_class;
};

TEST_F(Callbacks, near_a_locked_space_keeps_its_members)
{
    g_act = [this] {
        dGeomDestroy(sphere[1]);
        dSpaceRemove(space, sphere[1]);
        dSpaceAdd(space, lone);
        dSpaceDestroy(space);
        dGeomSetPosition(sphere[1], 9, 9, 9);
        EXPECT_EQ(dCreateSphere(space, 1), nullptr);
        EXPECT_EQ(dSimpleSpaceCreate(space), nullptr);
        expect_refused(7);
    };
    EXPECT_EQ(pairs(), 3);
    EXPECT_EQ(pairs(), 3);
    expect_refused(0);
}

TEST_F(Callbacks, near_everything_outside_the_space_may_go)
{
    g_act = [this] {
        dBodyDestroy(body);
        dGeomDestroy(lone);
        dWorldDestroy(world);
        world = dWorldCreate();
        lone = dCreateSphere(nullptr, 1);
        int inner = 0;
        dSpaceCollide(space, &inner, near_callback);
        EXPECT_EQ(inner, 3) << "a walk inside a walk";
        dCloseODE();
        dInitODE2(0);
        expect_refused(0);
    };
    EXPECT_EQ(pairs(), 3);
    EXPECT_EQ(dGeomGetBody(sphere[0]), nullptr);
}

// The walk goes over a list of pairs that a step would replace.
TEST_F(Callbacks, near_no_step_moves_what_is_collided)
{
    const dWorldID second = dWorldCreate();
    dBodyCreate(second);
    const auto every_step = [](dWorldID w) {
        return dWorldStep(w, dReal(0.01)) + dWorldQuickStep(w, dReal(0.01)) +
               dWorldStepFast1(w, dReal(0.01), 4) + dWorldStepHybrid(w, dReal(0.01)) +
               dWorldsStep(&w, 1, dReal(0.01), 0, 1, 1, 1, nullptr);
    };
    g_act = [&, this] {
        EXPECT_EQ(every_step(world), 0) << "a body of it has a geom in the space";
        expect_refused(5);
        EXPECT_NE(g_text.find("locked space: the step would move"), std::string::npos) << g_text;
        EXPECT_EQ(every_step(second), 5);
        expect_refused(0);
    };
    EXPECT_EQ(pairs(), 3);
    dGeomSetBody(sphere[0], nullptr);
    const dSpaceID around = dSimpleSpaceCreate(nullptr);
    dSpaceAdd(around, reinterpret_cast<dGeomID>(space));
    for (dSpaceID contacts : {space, around}) {
        dWorldSetContactSpace(second, contacts);
        g_act = [&, this] {
            EXPECT_EQ(every_step(second), 0) << "it looks for contacts in the space";
            expect_refused(5);
        };
        EXPECT_EQ(pairs(), 3);
        EXPECT_EQ(every_step(second), 5);
    }
    dSpaceRemove(around, reinterpret_cast<dGeomID>(space));
    dSpaceDestroy(around);
    // What lies in a space in it is not walked over, and free to move.
    const dSpaceID part = dSimpleSpaceCreate(space);
    dGeomSetBody(dCreateSphere(part, 1), dBodyCreate(second));
    dWorldSetContactSpace(second, part);
    g_act = [&] { EXPECT_EQ(every_step(second), 5); };
    EXPECT_EQ(pairs(), 6);
    dWorldDestroy(second);
    expect_refused(0);
}

dWorldID g_dying = nullptr;
int g_notes = 0;
void destroy_again(int, const char*, va_list)
{
    ++g_notes;
    dWorldDestroy(g_dying);
}

TEST_F(Callbacks, message_handlers_may_destroy_what_the_message_is_about)
{
    g_dying = dWorldCreate();
    const dJointGroupID group = dJointGroupCreate(0);
    for (int i = 0; i < 3; ++i) dJointAttach(dJointCreateBall(g_dying, group), dBodyCreate(g_dying), nullptr);
    dSetMessageHandler(destroy_again);
    dWorldDestroy(g_dying);
    dSetMessageHandler(nullptr);
    EXPECT_EQ(g_notes, 3) << "one for each joint of a group";
    expect_refused(3);
    dJointGroupDestroy(group);
    expect_refused(0);
}

TEST_F(Callbacks, near_a_geom_outside_stays_while_it_is_collided_with_a_space)
{
    int count = 0;
    g_act = [this] {
        dGeomDestroy(lone);
        expect_refused(1);
    };
    dSpaceCollide2(lone, reinterpret_cast<dGeomID>(space), &count, near_callback);
    EXPECT_EQ(count, 3);
}

TEST_F(Callbacks, near_what_would_die_with_a_transform_stays)
{
    const dGeomID transform = dCreateGeomTransform(nullptr);
    dGeomTransformSetGeom(transform, lone);
    dGeomTransformSetCleanup(transform, 1);
    int count = 0;
    g_act = [this, transform] {
        dGeomDestroy(transform);
        dGeomTransformSetGeom(transform, nullptr);
        expect_refused(2);
    };
    dSpaceCollide2(lone, reinterpret_cast<dGeomID>(space), &count, near_callback);
    EXPECT_EQ(count, 3);
    dGeomDestroy(transform);
    lone = dCreateSphere(nullptr, 1);
    expect_refused(0);
}

TEST_F(Callbacks, moved_the_step_keeps_its_world)
{
    const dBodyID other = dBodyCreate(world);
    const dJointGroupID group = dJointGroupCreate(0);
    const dJointID ball = dJointCreateBall(world, nullptr), grouped = dJointCreateHinge(world, group);
    dJointAttach(ball, body, other);
    dJointAttach(grouped, body, nullptr);
    dBodySetMovedCallback(body, moved_callback);
    g_act = [=, this] {
        EXPECT_EQ(dWorldStep(world, dReal(0.01)), 0);
        EXPECT_EQ(dWorldQuickStep(world, dReal(0.01)), 0);
        EXPECT_EQ(dWorldStepFast1(world, dReal(0.01), 5), 0);
        dBodyDestroy(body);
        dBodyDestroy(other);
        dJointDestroy(ball);
        dJointAttach(ball, other, nullptr);
        dJointGroupEmpty(group);
        dJointGroupDestroy(group);
        dWorldDestroy(world);
        expect_refused(10);
    };
    EXPECT_EQ(dWorldStep(world, dReal(0.01)), 1);
    EXPECT_FALSE(g_act) << "the callback came";
    for (int i = 0; i < 3; ++i) EXPECT_EQ(dWorldQuickStep(world, dReal(0.01)), 1);
    dJointGroupDestroy(group);
    expect_refused(0);
}

// Saving, copying and restoring the world from inside its step.
void expect_no_copies(dWorldID world, const std::vector<char>& state)
{
    const dVector3 aside = {1, 0, 0};
    std::vector<char> out(state.size());
    dSpaceID its = nullptr;
    EXPECT_EQ(dWorldGetState(world, out.data(), out.size()), 0);
    EXPECT_EQ(dWorldGetStateDelta(world, state.data(), state.size(), out.data(), out.size()), 0u);
    EXPECT_EQ(dWorldSetState(world, state.data(), state.size()), 0);
    EXPECT_EQ(dWorldSetHistory(world, 4), 0);
    EXPECT_EQ(dWorldRollBack(world, 0), 0);
    EXPECT_EQ(dWorldSaveToBuffer(world, nullptr, nullptr, 0), 0u);
    EXPECT_EQ(dWorldSave(world, nullptr, "never_written.epw"), 0);
    EXPECT_EQ(dWorldClone(world, &its, nullptr, 0), nullptr);
    EXPECT_EQ(dWorldShiftOrigin(world, nullptr, aside), 0);
}

TEST_F(Callbacks, moved_the_step_lets_nobody_copy_its_world)
{
    std::vector<char> state(dWorldGetStateSize(world));
    ASSERT_EQ(dWorldGetState(world, state.data(), state.size()), 1);
    dBodySetMovedCallback(body, moved_callback);
    g_act = [&, this] {
        expect_no_copies(world, state);
        expect_refused(9);
    };
    EXPECT_EQ(dWorldStep(world, dReal(0.01)), 1);
    EXPECT_FALSE(g_act) << "the callback came";
    EXPECT_EQ(dWorldSetState(world, state.data(), state.size()), 1);
    expect_refused(0);
}

TEST_F(Callbacks, moved_what_the_step_does_not_hold_may_change)
{
    dBodySetMovedCallback(body, moved_callback);
    const dWorldID second = dWorldCreate();
    dBodyCreate(second);
    g_act = [=, this] {
        dGeomDestroy(sphere[0]);
        dBodySetPosition(body, 5, 5, 5);
        dBodySetMovedCallback(body, nullptr);
        EXPECT_EQ(dWorldStep(second, dReal(0.01)), 1) << "another world";
        EXPECT_NE(dBodyCreate(world), nullptr);
        EXPECT_NE(dJointCreateBall(world, nullptr), nullptr);
        dWorldDestroy(second);
        expect_refused(0);
    };
    EXPECT_EQ(dWorldStep(world, dReal(0.01)), 1);
    EXPECT_EQ(dBodyGetPosition(body)[0], 5);
    EXPECT_EQ(dWorldStep(world, dReal(0.01)), 1);
}

void* block_for_step(dsizeint size)
{
    act();
    return std::malloc(size);
}
void free_block(void* block, dsizeint) { std::free(block); }

TEST_F(Callbacks, memory_the_step_keeps_its_world)
{
    const dBodyID other = dBodyCreate(world);
    const dJointID ball = dJointCreateBall(world, nullptr);
    dJointAttach(ball, body, other);
    const dWorldStepMemoryFunctionsInfo functions = {sizeof functions, block_for_step, nullptr, free_block};
    ASSERT_EQ(dWorldSetStepMemoryManager(world, &functions), 1);
    dBodyID late[50];
    g_act = [=, this, &late] {
        EXPECT_EQ(dWorldStep(world, dReal(0.01)), 0);
        dBodyDestroy(body);
        dJointDestroy(ball);
        dJointAttach(ball, other, nullptr);
        dWorldDestroy(world);
        expect_refused(5);
        for (dBodyID& b : late) {
            b = dBodyCreate(world);
            dBodySetLinearVel(b, 1, 0, 0);
        }
        expect_refused(0);
    };
    dBodySetLinearVel(body, 0, 1, 0);
    EXPECT_EQ(dWorldStep(world, dReal(0.01)), 1);
    EXPECT_FALSE(g_act) << "memory was asked for";
    EXPECT_GT(dBodyGetPosition(body)[1], 0);
    for (dBodyID b : late) EXPECT_EQ(dBodyGetPosition(b)[0], 0) << "of the next step";
    EXPECT_EQ(dWorldStep(world, dReal(0.01)), 1);
    EXPECT_GT(dBodyGetPosition(late[49])[0], 0);
}

void* counted_alloc(dsizeint size)
{
    act();
    return std::malloc(size);
}

// Of the library as a whole, which a step asks where the world has none of its own.
TEST_F(Callbacks, memory_of_the_library_keeps_the_world_of_a_step)
{
    const dBodyID other = dBodyCreate(world);
    const dJointID ball = dJointCreateBall(world, nullptr);
    dJointAttach(ball, body, other);
    dSetAllocHandler(counted_alloc);
    g_act = [=, this] {
        EXPECT_EQ(dWorldStep(world, dReal(0.01)), 0);
        dBodyDestroy(body);
        dJointDestroy(ball);
        dJointAttach(ball, other, nullptr);
        dWorldDestroy(world);
        expect_refused(5);
    };
    EXPECT_EQ(dWorldStep(world, dReal(0.01)), 1);
    dSetAllocHandler(nullptr);
    EXPECT_FALSE(g_act) << "memory was asked for";
    EXPECT_EQ(dWorldStep(world, dReal(0.01)), 1);
    expect_refused(0);
}

TEST_F(Callbacks, moved_feedback_may_be_taken_away)
{
    dJointFeedback feedback{};
    const dJointID ball = dJointCreateBall(world, nullptr);
    dJointAttach(ball, body, nullptr);
    dJointSetFeedback(ball, &feedback);
    dWorldSetGravity(world, 0, 0, -10);
    dBodySetMovedCallback(body, moved_callback);
    g_act = [ball] { dJointSetFeedback(ball, nullptr); };
    dWorldStep(world, dReal(0.01));
    EXPECT_NEAR(feedback.f1[2], 10, 0.01) << "written before the callback";
    feedback = {};
    dWorldStep(world, dReal(0.01));
    EXPECT_EQ(feedback.f1[2], 0);
}

TEST_F(Callbacks, box_function_keeps_the_geoms)
{
    const dGeomID user = dCreateGeom(user_class);
    g_act = [=, this] {
        dGeomDestroy(user);
        expect_refused(1);
        dGeomDestroy(sphere[1]);
        expect_refused(0);
    };
    dReal box[6];
    dGeomGetAABB(user, box);
    EXPECT_EQ(box[1], 1);
    dSpaceAdd(space, user);
    g_act = [=, this] {
        dSpaceRemove(space, user);
        dGeomDestroy(user);
        expect_refused(2);
    };
    dSpaceClean(space);
    EXPECT_EQ(pairs(), 3) << "of the two spheres that are left and the user's geom";
}

TEST_F(Callbacks, collider_function_keeps_the_geoms)
{
    const dGeomID user = dCreateGeom(user_class);
    dContactGeom contact;
    g_act = [=, this] {
        dGeomDestroy(user);
        dGeomDestroy(lone);
        expect_refused(2);
    };
    EXPECT_EQ(dCollide(user, lone, 1, &contact, sizeof contact), 0);
    EXPECT_FALSE(g_act) << "the collider came";
    dGeomDestroy(user);
    expect_refused(0);
}

int offered_for = -1;  // the last class that a collider was chosen for
dColliderFn* choose_collider(int other)
{
    offered_for = other;
    act();
    return collide_user;
}

void silent_box(dGeomID, dReal box[6])
{
    for (int i = 0; i < 6; ++i) box[i] = i % 2 ? dReal(1) : dReal(-1);
}

// A class is asked once for each other class; each test here needs one that was not.
TEST_F(Callbacks, collider_chooser_keeps_the_geoms)
{
    const dGeomClass description = {8, choose_collider, silent_box, nullptr, nullptr};
    const dGeomID user = dCreateGeom(dCreateGeomClass(&description)),
                  transform = dCreateGeomTransform(nullptr);
    const dGeomID box = dCreateBox(nullptr, 1, 1, 1), capsule = dCreateCapsule(nullptr, 1, 1);
    dGeomTransformSetGeom(transform, capsule);
    dGeomTransformSetCleanup(transform, 1);
    dContactGeom contact;
    const auto refuse = [&](dGeomID first, dGeomID second) {
        g_act = [=, this] {
            dGeomDestroy(first), dGeomDestroy(second);
            expect_refused(2);
        };
    };
    refuse(user, lone);
    EXPECT_EQ(dCollide(user, lone, 1, &contact, sizeof contact), 0);
    EXPECT_EQ(offered_for, dSphereClass);
    refuse(user, box);
    EXPECT_EQ(dCollide(box, user, 1, &contact, sizeof contact), 0);
    EXPECT_EQ(offered_for, dBoxClass);
    g_act = [&] {
        dGeomDestroy(transform);
        dGeomTransformSetGeom(transform, nullptr);
        expect_refused(2);
    };
    dCollide(transform, user, 1, &contact, sizeof contact);
    EXPECT_FALSE(g_act) << "the chooser came";
    expect_refused(0);
    for (const dGeomID geom : {user, transform, box}) dGeomDestroy(geom);
    expect_refused(0);
}

TEST_F(Callbacks, collider_chooser_keeps_what_is_sought_and_what_is_stepped)
{
    const dGeomClass description = {8, choose_collider, silent_box, nullptr, nullptr};
    for (const bool step : {false, true}) {
        const dGeomID user = dCreateGeom(dCreateGeomClass(&description));
        if (step) {
            dSpaceAdd(space, user);
            dGeomSetContinuous(sphere[0], 1);
            dBodySetLinearVel(body, 100, 0, 0);
            dWorldSetContactSpace(world, space);
        }
        g_act = [=, this] {
            dGeomDestroy(user), dGeomDestroy(sphere[0]);
            expect_refused(2);
        };
        dGeomID found[4];
        step ? dWorldStepFast1(world, dReal(0.01), 4) : dSpaceOverlap(space, user, nullptr, found, 4);
        EXPECT_FALSE(g_act) << "the chooser came";
        dGeomDestroy(user);
        expect_refused(0);
    }
}

void readiness(void*) { act(); }

TEST_F(Callbacks, readiness_function_keeps_the_threads_it_is_of)
{
    const dThreadingImplementationID impl = dThreadingAllocateMultiThreadedImplementation();
    g_act = [=, this] {
        dThreadingFreeImplementation(impl);
        expect_refused(1);
        dWorldStep(world, dReal(0.01));
        dThreadingImplementationShutdownProcessing(impl);
        expect_refused(0);
    };
    dExternalThreadingServeMultiThreadedImplementation(impl, readiness, nullptr);
    EXPECT_FALSE(g_act) << "the function came";
    dThreadingFreeImplementation(impl);
    expect_refused(0);
}

TEST_F(Callbacks, height_function_keeps_geoms_and_heights)
{
    const dHeightfieldDataID data = dGeomHeightfieldDataCreate();
    dGeomHeightfieldDataBuildCallback(data, nullptr, height, 4, 4, 3, 3, 1, 0, 1, 0);
    const dGeomID field = dCreateHeightfield(nullptr, data, 1);
    const float flat[4] = {};
    const dGeomID transform = dCreateGeomTransform(nullptr);
    dContactGeom contact;
    g_act = [=, this] {
        dGeomHeightfieldDataDestroy(data);
        dGeomHeightfieldDataBuildSingle(data, flat, 1, 4, 4, 2, 2, 1, 0, 1, 0);
        dGeomDestroy(field);
        dGeomDestroy(lone);
        dGeomDestroy(sphere[2]);
        dSpaceDestroy(space);
        dGeomTransformSetGeom(transform, sphere[2]);
        expect_refused(7);
    };
    EXPECT_GT(dCollide(field, lone, 1, &contact, sizeof contact), 0);
    EXPECT_FALSE(g_act) << "the function came";
    dGeomHeightfieldDataDestroy(data);
    EXPECT_EQ(dCollide(field, lone, 1, &contact, sizeof contact), 0);
    for (dGeomID geom : {field, transform}) dGeomDestroy(geom);
    expect_refused(0);
}

TEST_F(Callbacks, height_function_binds_its_own_thread_only)
{
    const dHeightfieldDataID data = dGeomHeightfieldDataCreate();
    dGeomHeightfieldDataBuildCallback(data, nullptr, height, 4, 4, 3, 3, 1, 0, 1, 0);
    const dGeomID field = dCreateHeightfield(nullptr, data, 1), here = dCreateSphere(nullptr, 1),
                  there = dCreateSphere(nullptr, 1);
    dContactGeom contact;
    g_act = [=, this] {
        std::thread([there] { dGeomDestroy(there); }).join();
        expect_refused(0);
        dGeomDestroy(here);
        expect_refused(1);
    };
    // On a thread that the program has made, as on its first one.
    std::thread([&] { dCollide(field, lone, 1, &contact, sizeof contact); }).join();
    EXPECT_FALSE(g_act) << "the function came";
    EXPECT_EQ(dGeomGetClass(there), -1);
    g_refusals = 0;
    for (dGeomID g : {field, here}) dGeomDestroy(g);
    dGeomHeightfieldDataDestroy(data);
    expect_refused(0);
}

int triangle(dGeomID, dGeomID, int)
{
    act();
    return 1;
}

TEST_F(Callbacks, triangle_function_keeps_geoms_and_triangles)
{
    const double vertices[12] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
    const unsigned corners[12] = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
    const auto build = [&](dTriMeshDataID data, int count) {
        dGeomTriMeshDataBuildDouble(data, vertices, 3 * sizeof(double), 4, corners, count,
                                    3 * sizeof(unsigned));
    };
    const dTriMeshDataID data = dGeomTriMeshDataCreate(), other = dGeomTriMeshDataCreate();
    build(data, 12);
    build(other, 3);
    const dGeomID mesh = dCreateTriMesh(nullptr, data, triangle, nullptr, nullptr);
    dContactGeom contact;
    g_act = [=, this] {
        dGeomTriMeshDataDestroy(data);
        build(data, 3);
        dGeomTriMeshDataUpdate(data);
        dGeomTriMeshSetData(mesh, other);
        dGeomDestroy(mesh);
        dGeomDestroy(lone);
        expect_refused(6);
        dGeomTriMeshDataDestroy(other);
        expect_refused(0);
    };
    EXPECT_EQ(dCollide(mesh, lone, 1, &contact, sizeof contact), 1);
    EXPECT_FALSE(g_act) << "the function came";
    EXPECT_EQ(dGeomTriMeshGetTriangleCount(mesh), 4);
    dGeomTriMeshDataDestroy(data);
    EXPECT_EQ(dCollide(mesh, lone, 1, &contact, sizeof contact), 0);
    dGeomDestroy(mesh);
    expect_refused(0);
}

int filter(void*, dGeomID, dGeomID)
{
    act();
    return 1;
}
int keeps(void*, dGeomID)
{
    act();
    return 1;
}

TEST_F(Callbacks, contact_filter_keeps_world_and_space)
{
    dWorldSetContactSpace(world, space);
    dWorldSetContactFilter(world, filter, nullptr);
    g_act = [this] {
        EXPECT_EQ(dWorldStep(world, dReal(0.01)) + dWorldStepHybrid(world, dReal(0.01)), 0);
        dWorldSetContactFilter(world, nullptr, nullptr);
        dWorldDestroy(world);
        dBodyDestroy(body);
        dGeomDestroy(sphere[1]);
        dSpaceAdd(space, lone);
        dBodySetPosition(body, 5, 5, 5);
        expect_refused(8);
        dBodySetKinematic(body), dBodySetDynamic(body);  // its contacts have been chosen
        expect_refused(2);
        EXPECT_NE(dBodyCreate(world), nullptr);
        expect_refused(0);
    };
    EXPECT_EQ(dWorldStep(world, dReal(0.01)), 1);
    EXPECT_FALSE(g_act) << "the filter came";
    EXPECT_FALSE(dBodyIsKinematic(body));
    EXPECT_EQ(dWorldStep(world, dReal(0.01)), 1);
    expect_refused(0);
}

TEST_F(Callbacks, query_filter_keeps_the_members)
{
    const dVector3 from = {0, 0, 5}, down = {0, 0, -1}, motion = {0, 0, -9};
    const dReal length = 10;
    dQueryFilter asked;
    dQueryFilterInit(&asked, sizeof asked);
    asked.callback = keeps;
    dQueryHit hits[4];
    dGeomID found[4];
    dGeomSetPosition(lone, 0, 0, 5);
    const std::function<void()> queries[] = {
        [&] { dSpaceRayClosest(space, from, down, 10, &asked, hits); },
        [&] { dSpaceRayAll(space, from, down, 10, &asked, hits, 4); },
        [&] { dSpaceRayBatch(space, 1, from, down, &length, &asked, hits, 1); },
        [&] { dSpaceCast(space, lone, motion, &asked, hits); },
        [&] { dGeomSetPosition(lone, 0, 0, 0), dSpaceOverlap(space, lone, &asked, found, 4); },
    };
    for (const auto& query : queries) {
        g_act = [this] {
            dGeomDestroy(sphere[1]);
            dSpaceRemove(space, sphere[1]);
            dSpaceDestroy(space);
            dBodySetPosition(body, 5, 5, 5);
            EXPECT_EQ(dWorldStep(world, dReal(0.01)), 0);
            expect_refused(5);
        };
        query();
        EXPECT_FALSE(g_act) << "the callback came";
    }
    EXPECT_EQ(pairs(), 3);
    expect_refused(0);
}

dReal surface(void*, const dVector3, dReal)
{
    act();
    return 0;
}
void current(void*, const dVector3, dReal, dVector3 velocity)
{
    for (int i = 0; i < 3; ++i) velocity[i] = 0;
    act();
}

TEST_F(Callbacks, fluid_functions_keep_world_fluids_and_geoms)
{
    const dFluidID fluid = dFluidCreate(world);
    for (const bool by_current : {false, true}) {
        dFluidSetSurface(fluid, by_current ? nullptr : surface, nullptr);
        dFluidSetCurrentFunction(fluid, by_current ? current : nullptr, nullptr);
        g_act = [this, fluid] {
            EXPECT_EQ(dWorldStep(world, dReal(0.01)), 0);
            dWorldDestroy(world);
            dFluidDestroy(fluid);
            dFluidSetPlane(fluid, 0, 0, 1, 2);
            dFluidSetSurface(fluid, nullptr, nullptr);
            dBodyDestroy(body);
            dGeomDestroy(sphere[0]);
            expect_refused(7);
            EXPECT_EQ(dFluidCreate(world), nullptr);
            expect_refused(1);
            EXPECT_NE(dBodyCreate(world), nullptr);
            expect_refused(0);
        };
        EXPECT_EQ(dWorldStep(world, dReal(0.01)), 1);
        EXPECT_FALSE(g_act) << "the function came";
    }
    expect_refused(0);
}

TEST_F(Callbacks, fluid_functions_keep_what_is_asked_for_outside_steps)
{
    const dFluidID fluid = dFluidCreate(world);
    dFluidSetSurface(fluid, surface, nullptr);
    dReal volume;
    g_act = [this, fluid] {
        dWorldDestroy(world);
        dFluidDestroy(fluid);
        dFluidSetSurface(fluid, nullptr, nullptr);
        dGeomDestroy(sphere[0]);
        expect_refused(4);
    };
    EXPECT_EQ(dFluidGetSubmerged(fluid, sphere[0], &volume, nullptr), 1);
    EXPECT_FALSE(g_act) << "the function came";
    g_act = [this, fluid] {
        dFluidDestroy(fluid);
        dBodyDestroy(body);
        dGeomDestroy(sphere[0]);
        expect_refused(3);
    };
    EXPECT_EQ(dFluidGetSubmergedBody(fluid, body, &volume, nullptr), 1);
    EXPECT_FALSE(g_act) << "the function came";
    EXPECT_NEAR(volume, 2 * M_PI / 3, 1e-6);
    expect_refused(0);
}

void see(void*, dManifold*) { act(); }

TEST_F(Callbacks, manifold_function_keeps_world_and_space)
{
    dWorldSetContactSpace(world, space);
    dWorldSetManifoldFunction(world, see, nullptr, 0);
    dGeomSetBody(sphere[1], dBodyCreate(world));
    dBodySetPosition(dGeomGetBody(sphere[1]), 0, 0, dReal(1.9));
    g_act = [this] {
        EXPECT_EQ(dWorldStep(world, dReal(0.01)) + dWorldStepHybrid(world, dReal(0.01)), 0);
        dWorldSetManifoldFunction(world, nullptr, nullptr, 0);
        dWorldSetContactSpace(world, nullptr);
        dWorldDestroy(world);
        dBodyDestroy(body);
        dGeomDestroy(sphere[1]);
        dSpaceAdd(space, lone);
        dBodySetPosition(body, 5, 5, 5);
        dBodySetKinematic(body), dBodySetDynamic(body);
        expect_refused(11);
        EXPECT_NE(dBodyCreate(world), nullptr);
        expect_refused(0);
    };
    EXPECT_EQ(dWorldStep(world, dReal(0.01)), 1);
    EXPECT_FALSE(g_act) << "the function came";
    EXPECT_EQ(dWorldStep(world, dReal(0.01)), 1);
    expect_refused(0);
}

int lets_pass(void*, dGeomID, dGeomID, const dVector3)
{
    act();
    return 1;
}

TEST_F(Callbacks, character_filter_keeps_character_and_space)
{
    dCharacterSettings settings;
    dCharacterSettingsInit(&settings, sizeof settings);
    settings.filter = lets_pass;
    const dGeomID character = dCharacterCreate(space, &settings);
    dCharacterSetPosition(character, dReal(1.1), 0, 0);
    const dVector3 velocity = {-1, 0, 0};
    g_act = [this, character, &velocity] {
        dGeomDestroy(character);
        dGeomDestroy(sphere[1]);
        dSpaceRemove(space, sphere[1]);
        dSpaceAdd(space, lone);
        dSpaceDestroy(space);
        dBodySetPosition(body, 5, 5, 5);
        EXPECT_EQ(dWorldStep(world, dReal(0.01)), 0);
        EXPECT_EQ(dCharacterWalk(character, velocity, 0, dReal(0.01)), 0);
        expect_refused(8);
    };
    dCharacterWalk(character, velocity, 0, dReal(0.01));
    EXPECT_FALSE(g_act) << "the filter came";
    expect_refused(0);
    dGeomDestroy(character);
    expect_refused(0);
}

int may_meet(dGeomID, dGeomID, dReal*)
{
    act();
    return 1;
}

TEST_F(Callbacks, box_test_function_keeps_the_geoms)
{
    const dGeomClass description = {8, collider_for, user_box, may_meet, nullptr};
    const dGeomID user = dCreateGeom(dCreateGeomClass(&description));
    g_act = [=, this] {
        dGeomDestroy(user);
        dGeomDestroy(lone);
        expect_refused(2);
    };
    dSpaceCollide2(user, lone, nullptr, near_callback);
    EXPECT_FALSE(g_act) << "the test came";
    dGeomDestroy(user);
    expect_refused(0);
}

TEST_F(Callbacks, collider_function_in_place_of_ours_keeps_the_geoms)
{
    dSetColliderOverride(dSphereClass, dSphereClass, collide_user);
    dContactGeom contact;
    g_act = [this] {
        dGeomDestroy(sphere[1]);
        dGeomDestroy(lone);
        expect_refused(2);
    };
    EXPECT_EQ(dCollide(sphere[1], lone, 1, &contact, sizeof contact), 0);
    EXPECT_FALSE(g_act) << "the collider came";
    dSetColliderOverride(dSphereClass, dSphereClass, nullptr);
}

dThreadingFunctionsInfo g_functions;
unsigned threads_of(dThreadingImplementationID impl)
{
    act();
    return g_functions.retrieve_thread_count(impl);
}

TEST_F(Callbacks, threading_functions_leave_the_world_alone)
{
    const dThreadingImplementationID impl = dThreadingAllocateSelfThreadedImplementation();
    g_functions = *dThreadingImplementationGetFunctions(impl);
    dThreadingFunctionsInfo functions = g_functions;
    functions.retrieve_thread_count = threads_of;
    dWorldSetStepThreadingImplementation(world, &functions, impl);
    g_act = [this] {
        EXPECT_EQ(dWorldStep(world, dReal(0.01)), 0);
        dWorldSetStepThreadingImplementation(world, nullptr, nullptr);
        dBodyDestroy(body);
        dWorldDestroy(world);
        expect_refused(4);
    };
    EXPECT_EQ(dWorldStep(world, dReal(0.01)), 1);
    EXPECT_FALSE(g_act) << "the function came";
    dWorldSetStepThreadingImplementation(world, nullptr, nullptr);
    dThreadingFreeImplementation(impl);
    expect_refused(0);
}

TEST_F(Callbacks, end_function_cannot_save_or_kill_twice)
{
    const dGeomID user = dCreateGeom(user_class), transform = dCreateGeomTransform(nullptr);
    g_act = [=, this] {
        dGeomDestroy(user);
        expect_refused(1);
        dSpaceAdd(space, user);
        dGeomSetBody(user, body);
        EXPECT_NE(dGeomGetClassData(user), nullptr);
        expect_refused(0);
    };
    dGeomDestroy(user);
    EXPECT_EQ(dSpaceGetNumGeoms(space), 3);
    EXPECT_EQ(dBodyGetFirstGeom(body), sphere[0]);
    EXPECT_EQ(pairs(), 3);
    const dGeomID inner = dCreateGeom(user_class);
    dGeomTransformSetGeom(transform, inner);
    dGeomTransformSetCleanup(transform, 1);
    g_act = [=, this] {
        dGeomDestroy(transform);
        expect_refused(1);
        dGeomTransformSetGeom(transform, lone);
    };
    dGeomDestroy(transform);
    EXPECT_EQ(dGeomGetClass(lone), -1) << "the last that the transform held went with it";
    lone = dCreateSphere(nullptr, 1);
    g_refusals = 0;
}

TEST_F(Callbacks, end_function_of_a_member_may_take_other_members_along)
{
    const dSpaceID crowd = dSimpleSpaceCreate(nullptr);
    const dGeomID first = dCreateSphere(crowd, 1), user = dCreateGeom(user_class),
                  last = dCreateSphere(crowd, 1);
    dSpaceAdd(crowd, user);
    g_act = [=, this] {
        dGeomDestroy(first);
        dGeomDestroy(last);
        expect_refused(0);
        EXPECT_EQ(dCreateSphere(crowd, 1), nullptr);
        dSpaceDestroy(crowd);
        expect_refused(2);
    };
    dSpaceDestroy(crowd);
    EXPECT_EQ(dGeomGetClass(first), -1);
    const dSpaceID around = dSimpleSpaceCreate(nullptr);
    const dGeomID again = dCreateGeom(user_class);
    dSpaceAdd(around, again);
    g_refusals = 0;
    g_act = [=, this] {
        dSpaceDestroy(around);
        expect_refused(1);
    };
    dGeomDestroy(again);
    dSpaceDestroy(around);
    expect_refused(0);
}

}  // namespace
