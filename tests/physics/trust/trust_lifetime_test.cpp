// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Handles of things that are gone are refused with a message (as long as nothing new has taken their memory:
// then a handle, being an address, names the new thing); everything may be destroyed in any order, twice too,
// and a new world works afterwards.
#include <algorithm>
#include <functional>

#include "scenes.h"

namespace epode::physics {
namespace {

struct TrustLifetime : testing::Test {
    Messages messages;
    void refused(const std::function<void()>& call, const char* name)
    {
        messages.clear();
        call();
        EXPECT_EQ(messages.count(), 1) << name << " said " << messages.last();
    }
};

TEST_F(TrustLifetime, handles_of_the_dead_are_refused)
{
    Sim sim;
    dBodyID b = dBodyCreate(sim.world);
    dJointID j = dJointCreateHinge(sim.world, nullptr);
    dGeomID g = dCreateSphere(sim.space, 1);
    dWorldID w = dWorldCreate();
    dSpaceID s = dSimpleSpaceCreate(nullptr);
    dJointGroupID group = dJointGroupCreate(0);
    dBodyDestroy(b), dJointDestroy(j), dGeomDestroy(g), dWorldDestroy(w), dSpaceDestroy(s);
    dJointGroupDestroy(group);
    refused([&] { dBodySetPosition(b, 1, 2, 3); }, "body");
    refused([&] { dBodyDestroy(b); }, "body destroyed twice");
    refused([&] { dBodyAddForce(b, 1, 0, 0); }, "force");
    refused([&] { dJointSetHingeParam(j, dParamVel, 1); }, "joint");
    refused([&] { dJointDestroy(j); }, "joint destroyed twice");
    refused([&] { dGeomSphereSetRadius(g, 2); }, "geom");
    refused([&] { dGeomDestroy(g); }, "geom destroyed twice");
    refused([&] { dWorldSetGravity(w, 0, 0, 0); }, "world");
    refused([&] { EXPECT_EQ(dWorldStep(w, real(0.01)), 0); }, "world stepped");
    refused([&] { EXPECT_EQ(dBodyCreate(w), nullptr); }, "body in a dead world");
    refused([&] { dSpaceDestroy(s); }, "space destroyed twice");
    refused([&] { dJointGroupEmpty(group); }, "group");
}

TEST_F(TrustLifetime, nothing_and_the_wrong_kind_are_refused)
{
    Sim sim;
    refused([&] { dBodySetPosition(nullptr, 1, 2, 3); }, "no body");
    refused([&] { dWorldStep(nullptr, real(0.01)); }, "no world");
    refused([&] { dWorldQuickStep(nullptr, real(0.01)); }, "no world");
    refused([&] { dSpaceCollide(nullptr, nullptr, nullptr); }, "no space");
    dJointID ball = dJointCreateBall(sim.world, nullptr);
    refused([&] { dJointSetHingeAxis(ball, 1, 0, 0); }, "a ball is no hinge");
    dGeomID sphere = dCreateSphere(sim.space, 1);
    refused([&] { dGeomBoxSetLengths(sphere, 1, 1, 1); }, "a sphere is no box");
    refused([&] { EXPECT_EQ(dJointCreateContact(sim.world, nullptr, nullptr), nullptr); }, "no contact");
}

TEST_F(TrustLifetime, a_body_that_goes_takes_its_joints_out_of_the_world_and_leaves_its_geoms)
{
    Sim sim;
    sim.gravity(0, 0, -10);
    dBodyID a = sim.box({0, 0, 0}, {1, 1, 1}, 1), b = sim.box({1, 0, 0}, {1, 1, 1}, 1);
    dGeomID geom = dBodyGetFirstGeom(a);
    dJointID j = dJointCreateBall(sim.world, nullptr);
    dJointAttach(j, a, b);
    dBodyDestroy(a);
    sim.bodies.erase(sim.bodies.begin());
    EXPECT_EQ(dGeomGetBody(geom), nullptr);
    EXPECT_EQ(dBodyGetNumJoints(b), 0);
    ASSERT_EQ(sim.advance(0.1), 1);
    EXPECT_NEAR(velocity(b).z, -1, 1e-6) << "it falls freely";
    dJointDestroy(j);
    EXPECT_EQ(messages.count(), 0) << messages.last();
}

// Everything of a scene in a random order, each thing destroyed once or, by chance, twice.
void destroy_in_any_order(std::uint32_t seed)
{
    Random random(seed);
    dWorldID world = dWorldCreate();
    dSpaceID outer = dHashSpaceCreate(nullptr), inner = dSimpleSpaceCreate(outer);
    dJointGroupID group = dJointGroupCreate(0);
    dWorldSetGravity(world, 0, 0, -10);
    std::vector<dBodyID> bodies;
    std::vector<dGeomID> geoms;
    std::vector<dJointID> joints;
    for (int i = 0; i < 6; ++i) {
        dBodyID b = dBodyCreate(world);
        dGeomID g = i % 2 ? dCreateSphere(inner, 1) : dCreateBox(outer, 1, 1, 1);
        dGeomSetBody(g, b);
        dJointID j =
            i % 3 ? dJointCreateHinge(world, i % 2 ? group : nullptr) : dJointCreateBall(world, nullptr);
        dJointAttach(j, b, bodies.empty() ? nullptr : bodies.back());
        bodies.push_back(b), geoms.push_back(g), joints.push_back(j);
    }
    std::vector<std::function<void()>> ends{[=] { dWorldDestroy(world); }, [=] { dSpaceDestroy(outer); },
                                            [=] { dSpaceDestroy(inner); },
                                            [=] { dJointGroupDestroy(group); }};
    for (dBodyID b : bodies) ends.push_back([=] { dBodyDestroy(b); });
    for (dGeomID g : geoms) ends.push_back([=] { dGeomDestroy(g); });
    for (dJointID j : joints) ends.push_back([=] { dJointDestroy(j); });
    for (std::size_t i = ends.size(); i > 1; --i)
        std::swap(ends[i - 1], ends[std::size_t(random.uniform(0, double(i) - 1e-6))]);
    dWorldStep(world, real(0.01));
    for (const auto& end : ends) {
        end();
        dWorldQuickStep(world, real(0.01));  // refused when the world has gone
        if (random.uniform(0, 1) < 0.2) end();
    }
    for (const auto& end : ends) end();  // whatever is left, and all others once more
}

TEST_F(TrustLifetime, everything_goes_in_any_order)
{
    for (std::uint32_t seed = 1; seed <= 200; ++seed) destroy_in_any_order(seed);
    messages.clear();
    Sim sim;
    build(sim, Scene::kPile);
    sim.steps(30, 0.01);
    EXPECT_TRUE(finite_state(sim));
    EXPECT_EQ(messages.count(), 0) << messages.last();
}

}  // namespace
}  // namespace epode::physics
