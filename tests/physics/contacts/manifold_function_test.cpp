// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A function of the program sees and changes the manifolds of every step: what it rejects passes, its coefficients act for one step.
#include <gtest/gtest.h>
#include <ode/ext.h>
#include <ode/ode.h>

#include <cmath>
#include <vector>

namespace epode::physics {
namespace {

constexpr double kFall = 9.81;

struct Shown {
    dGeomID geom;
    double friction, bounce, belt;
    int accept, calls;
};

void set_all(void* data, dManifold* manifold)
{
    Shown& shown = *static_cast<Shown*>(data);
    ++shown.calls;
    manifold->accept = shown.accept;
    manifold->friction = dReal(shown.friction);
    manifold->bounce = dReal(shown.bounce);
    manifold->surface_velocity[0] = dReal(shown.belt);
}

// Passes from below; stands on it from above.
void one_way_up(void* data, dManifold* manifold)
{
    const Shown& shown = *static_cast<const Shown*>(data);
    if (manifold->g2 != shown.geom && manifold->g1 != shown.geom) return;
    const double up = manifold->normal[2] * (manifold->g2 == shown.geom ? 1 : -1);
    const double rise = manifold->velocity[2] * (manifold->g2 == shown.geom ? 1 : -1);
    if (!manifold->touched) manifold->accept = up > 0.5 && rise <= 0;
}

struct Arena {
    explicit Arena(int threads = 1)
    {
        dInitODE(), world = dWorldCreate(), space = dHashSpaceCreate(nullptr);
        dWorldSetGravity(world, 0, 0, dReal(-kFall));
        dWorldSetContactSpace(world, space);
        dWorldSetStepThreads(world, threads);
    }
    ~Arena() { dSpaceDestroy(space), dWorldDestroy(world), dCloseODE(); }
    Arena(const Arena&) = delete;
    Arena& operator=(const Arena&) = delete;
    dBodyID box(double x, double z, double size = 1) const
    {
        const dBodyID body = dBodyCreate(world);
        dMass m;
        dMassSetBox(&m, 1000, dReal(size), dReal(size), dReal(size));
        dBodySetMass(body, &m);
        dGeomSetBody(dCreateBox(space, dReal(size), dReal(size), dReal(size)), body);
        dBodySetPosition(body, dReal(x), 0, dReal(z));
        return body;
    }
    dWorldID world;
    dSpaceID space;
};

class EachStepper : public testing::TestWithParam<int> {
  protected:
    void run(const Arena& arena, int steps) const
    {
        const dReal h = dReal(1.0 / 120);
        for (int i = 0; i < steps; ++i)
            ASSERT_EQ(GetParam() == 0   ? dWorldStep(arena.world, h)
                      : GetParam() == 1 ? dWorldQuickStep(arena.world, h)
                                        : dWorldStepFast1(arena.world, h, 8),
                      1);
    }
};

// v' = v - mu g t, the material's 0.6 notwithstanding.
TEST_P(EachStepper, slides_by_the_friction_that_the_function_says)
{
    Arena arena;
    dCreatePlane(arena.space, 0, 0, 1, 0);
    const dBodyID box = arena.box(0, 0.5);
    Shown shown = {nullptr, 0.2, 0, 0, 1, 0};
    dWorldSetManifoldFunction(arena.world, set_all, &shown, 0);
    run(arena, 20);
    dBodySetLinearVel(box, 3, 0, 0);
    run(arena, 60);
    EXPECT_NEAR(dBodyGetLinearVel(box)[0], 3 - 0.2 * kFall * 0.5, 0.05);
    EXPECT_GE(shown.calls, 80);
}

TEST_P(EachStepper, passes_what_the_function_rejects)
{
    Arena arena;
    dCreatePlane(arena.space, 0, 0, 1, 0);
    const dBodyID box = arena.box(0, 0.5);
    Shown shown = {nullptr, 1, 0, 0, 0, 0};
    dWorldSetManifoldFunction(arena.world, set_all, &shown, 0);
    run(arena, 120);
    EXPECT_NEAR(dBodyGetPosition(box)[2], 0.5 - kFall / 2, 0.1);
    EXPECT_EQ(dWorldGetContacts(arena.world, nullptr, 0), 0);
    EXPECT_EQ(dWorldGetContactEvents(arena.world, nullptr, 0), 0);
}

TEST_P(EachStepper, carries_along_on_a_belt_of_the_function)
{
    Arena arena;
    dCreatePlane(arena.space, 0, 0, 1, 0);
    const dBodyID box = arena.box(0, 0.5);
    Shown shown = {nullptr, 0.5, 0, 0.7, 1, 0};
    dWorldSetManifoldFunction(arena.world, set_all, &shown, 0);
    run(arena, 240);
    EXPECT_NEAR(dBodyGetLinearVel(box)[0], 0.7, 0.01);
}

TEST_P(EachStepper, rebounds_as_the_function_says)
{
    Arena arena;
    dCreatePlane(arena.space, 0, 0, 1, 0);
    const dBodyID ball = dBodyCreate(arena.world);
    dGeomSetBody(dCreateSphere(arena.space, dReal(0.5)), ball);
    dBodySetPosition(ball, 0, 0, 2.5);
    Shown shown = {nullptr, 0, 0.5, 0, 1, 0};
    dWorldSetManifoldFunction(arena.world, set_all, &shown, 0);
    double highest = 0, lowest = 9;
    for (int i = 0; i < 150; ++i) {
        run(arena, 1);
        const double z = double(dBodyGetPosition(ball)[2]);
        lowest = std::fmin(lowest, z);
        if (lowest < 0.6) highest = std::fmax(highest, z);
    }
    EXPECT_NEAR(highest, 0.5 + 2 * 0.25, 0.06);  // a quarter of the height
}

TEST_P(EachStepper, one_way_platform_is_passed_from_below_and_carries_from_above)
{
    Arena arena;
    const dGeomID platform = dCreateBox(arena.space, 6, 6, dReal(0.2));
    dGeomSetPosition(platform, 0, 0, 1);
    const dBodyID box = arena.box(0, 0.2, 0.4);
    dBodySetLinearVel(box, 0, 0, 7);
    Shown shown = {platform, 0, 0, 0, 1, 0};
    dWorldSetManifoldFunction(arena.world, one_way_up, &shown, 0);
    run(arena, 360);
    EXPECT_NEAR(dBodyGetPosition(box)[2], 1.3, 0.005);
}

INSTANTIATE_TEST_SUITE_P(manifold_function, EachStepper, testing::Values(0, 1, 2), [](const auto& one) {
    return one.param == 0 ? "exact" : one.param == 1 ? "quick" : "substeps";
});

// By place and normal alone, so that any thread may ask.
void slippery_places(void*, dManifold* manifold)
{
    manifold->friction = manifold->pos[0][0] > 0 ? dReal(0.1) : dReal(0.8);
    manifold->accept = std::fabs(manifold->normal[2]) > dReal(0.2);
}

TEST(ManifoldFunction, gives_the_same_bits_on_any_number_of_threads)
{
    std::vector<unsigned char> first;
    for (const int threads : {1, 2, 3})
        for (const int on_threads : {0, 1}) {
            Arena arena(threads);
            dCreatePlane(arena.space, 0, 0, 1, 0);
            for (int i = 0; i < 200; ++i) arena.box(0.6 * (i % 12) - 3.5, 0.5 + 0.55 * (i / 12), 0.5);
            dWorldSetManifoldFunction(arena.world, slippery_places, nullptr, on_threads);
            for (int i = 0; i < 60; ++i) ASSERT_EQ(dWorldStepFast1(arena.world, dReal(1.0 / 60), 4), 1);
            std::vector<unsigned char> state(dWorldGetStateSize(arena.world));
            ASSERT_EQ(dWorldGetState(arena.world, state.data(), state.size()), 1);
            if (first.empty()) first = state;
            EXPECT_EQ(state, first) << threads << ' ' << on_threads;
        }
}

}  // namespace
}  // namespace epode::physics
