// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What every stepper (a line of steppers.inc) promises: free fall, rest on contact joints and on world-managed contacts, joints that
// hold and report their force, momentum that nobody outside changes, sleep, a report, and the same bits on one thread and on three.
// Bounds are those of the first order in the step, which all of them have.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include "ode/ext.h"
#include "ode/ode.h"
#include "step/step.h"
#include "step/steppers/stepper.h"

namespace epode {
namespace {

struct Line {
    std::string name;
    const Stepper* stepper;
};
void PrintTo(const Line& line, std::ostream* out) { *out << line.name; }

std::vector<Line> all_steppers()
{
    std::vector<Line> all;
#define STEPPER(name, number) all.push_back({#name, &k##name});
#include "step/steppers/steppers.inc"
#undef STEPPER
    return all;
}

constexpr double kGravity = 9.81;
constexpr dReal kTimeStep = dReal(0.005);
constexpr double kTrembling =
    kGravity * double(kTimeStep);  // what gravity adds in a step, and sweeps have to remove

class StepperContract : public testing::TestWithParam<Line> {
  protected:
    StepperContract() { begin(); }
    ~StepperContract() override { end(); }

    void begin()
    {
        world = dWorldCreate();
        space = dSimpleSpaceCreate(nullptr);
        group = dJointGroupCreate(0);
        dWorldSetGravity(world, 0, 0, dReal(-kGravity));
    }
    void end()
    {
        dJointGroupDestroy(group);
        dWorldDestroy(world);
        dSpaceDestroy(space);
    }
    void begin_again() { end(), begin(); }

    dBodyID box(dReal x, dReal y, dReal z, dReal mass = 2)
    {
        const dBodyID body = dBodyCreate(world);
        dMass m;
        dMassSetBoxTotal(&m, mass, 1, 1, 1);
        dBodySetMass(body, &m);
        dBodySetPosition(body, x, y, z);
        dGeomSetBody(dCreateBox(space, 1, 1, 1), body);
        return body;
    }

    void step(int count, dReal h = kTimeStep)
    {
        const Stepper& stepper = *GetParam().stepper;
        World& w = *from_handle<World>(world);
        for (int i = 0; i < count; ++i)
            ASSERT_TRUE(step_world(w, stepper, h, stepper.has_substeps ? 4 : w.quick_iterations));
    }

    static void collide(void* self, dGeomID a, dGeomID b)
    {
        auto& test = *static_cast<StepperContract*>(self);
        dContact contacts[8] = {};
        const int count = dCollide(a, b, 8, &contacts[0].geom, sizeof(dContact));
        for (int i = 0; i < count; ++i) {
            contacts[i].surface.mu = 1;
            const dJointID joint = dJointCreateContact(test.world, test.group, &contacts[i]);
            dJointAttach(joint, dGeomGetBody(a), dGeomGetBody(b));
        }
    }

    double height(dBodyID body) const { return double(dBodyGetPosition(body)[2]); }
    static double speed(dBodyID body)
    {
        const dReal* v = dBodyGetLinearVel(body);
        return std::sqrt(double(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]));
    }

    dWorldID world = nullptr;
    dSpaceID space = nullptr;
    dJointGroupID group = nullptr;
};

TEST_P(StepperContract, lets_a_body_fall)
{
    const dBodyID body = box(0, 0, 0);
    dBodySetLinearVel(body, 3, 0, 0);
    step(200);
    constexpr double kTime = 1, kFirstOrder = kGravity * kTime * 0.5 * double(kTimeStep);
    EXPECT_NEAR(double(dBodyGetLinearVel(body)[2]), -kGravity * kTime, 1e-3);
    EXPECT_NEAR(height(body), -kGravity * kTime * kTime / 2, 1.01 * kFirstOrder + 1e-4);
    EXPECT_NEAR(double(dBodyGetPosition(body)[0]), 3 * kTime, 1e-4);
}

TEST_P(StepperContract, rests_a_pile_on_contact_joints)
{
    dCreatePlane(space, 0, 0, 1, 0);
    const dBodyID below = box(0, 0, dReal(0.5)), above = box(dReal(0.1), 0, dReal(1.5));
    for (int i = 0; i < 200; ++i) {
        dSpaceCollide(space, this, collide);
        step(1);
        dJointGroupEmpty(group);
    }
    EXPECT_NEAR(height(below), 0.5, 5e-3);
    EXPECT_NEAR(height(above), 1.5, 1e-2);
    EXPECT_LT(speed(below) + speed(above), kTrembling);
}

TEST_P(StepperContract, rests_a_pile_on_contacts_of_the_world)
{
    dCreatePlane(space, 0, 0, 1, 0);
    dWorldSetContactSpace(world, space);
    const dBodyID below = box(0, 0, dReal(0.5)), above = box(dReal(0.1), 0, dReal(1.5));
    step(200);
    EXPECT_NEAR(height(below), 0.5, 5e-3);
    EXPECT_NEAR(height(above), 1.5, 1e-2);
    EXPECT_LT(speed(below) + speed(above), kTrembling);
}

TEST_P(StepperContract, holds_a_pendulum_and_reports_its_force)
{
    const dBodyID bob = box(1, 0, 0);
    const dJointID joint = dJointCreateBall(world, nullptr);
    dJointAttach(joint, bob, nullptr);
    dJointSetBallAnchor(joint, 0, 0, 0);
    dJointFeedback feedback = {};
    dJointSetFeedback(joint, &feedback);
    double lowest = 0, largest = 0;
    for (int i = 0; i < 400; ++i) {
        step(1);
        const dReal* x = dBodyGetPosition(bob);
        ASSERT_NEAR(std::sqrt(double(x[0] * x[0] + x[1] * x[1] + x[2] * x[2])), 1, 5e-3) << i;
        lowest = std::min(lowest, height(bob));
        largest = std::max(largest, double(feedback.f1[2]));
    }
    EXPECT_NEAR(lowest, -1, 5e-3);
    // Let go at the height of the joint, a rod with I about its end carries m g (1 + 2 m r^2/I) at the bottom.
    EXPECT_NEAR(largest, 2 * kGravity * (1 + 2 / (1 + 1.0 / 6)), 0.05 * 2 * kGravity * 3);
}

TEST_P(StepperContract, keeps_the_momentum_of_an_assembly)
{
    dWorldSetGravity(world, 0, 0, 0);
    const dBodyID a = box(0, 0, 0, 1), b = box(2, 0, 0, 5);
    const dJointID joint = dJointCreateHinge(world, nullptr);
    dJointAttach(joint, a, b);
    dJointSetHingeAnchor(joint, 1, 0, 0);
    dJointSetHingeAxis(joint, 0, 1, 0);
    dBodySetLinearVel(a, 0, 0, 6);
    dBodySetAngularVel(a, 0, 3, 0);
    step(100);
    const dReal *va = dBodyGetLinearVel(a), *vb = dBodyGetLinearVel(b);
    const double tolerance = sizeof(dReal) == 8 ? 1e-10 : 1e-4, momentum[3] = {0, 0, 6};
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(double(va[k] + 5 * vb[k]), momentum[k], tolerance) << k;
}

TEST_P(StepperContract, lets_what_rests_fall_asleep)
{
    dCreatePlane(space, 0, 0, 1, 0);
    dWorldSetContactSpace(world, space);
    const dBodyID body = box(0, 0, dReal(0.5));
    dBodySetAutoDisableFlag(body, 1);
    dBodySetAutoDisableTime(body, dReal(0.2));
    step(400);
    EXPECT_EQ(dBodyIsEnabled(body), 0);
    EXPECT_EQ(speed(body), 0);
}

TEST_P(StepperContract, reports_what_it_did)
{
    dWorldSetStepReportMode(world, 1);
    dWorldSetContactSpace(world, space);
    dCreatePlane(space, 0, 0, 1, 0);
    box(0, 0, dReal(0.5)), box(5, 0, 9);
    step(3);
    const auto reports = island_reports(*from_handle<World>(world));
    ASSERT_EQ(reports.size(), 2u);
    for (const dIslandStepReport& report : reports) {
        EXPECT_EQ(report.contained, 0);
        EXPECT_LT(report.residual, 0.1);
    }
}

TEST_P(StepperContract, has_the_same_bits_on_three_threads)
{
    std::vector<dReal> states[2];
    for (std::vector<dReal>& state : states) {
        begin_again();
        dWorldSetContactSpace(world, space);
        dCreatePlane(space, 0, 0, 1, 0);
        dWorldSetStepThreads(world, &state == states ? 1 : 3);
        dRandSetSeed(7);  // of a stepper that draws
        std::vector<dBodyID> bodies;
        for (int i = 0; i < 24; ++i)
            bodies.push_back(box(dReal(0.9) * dReal(i % 5), dReal(1.7) * dReal(i % 3),
                                 dReal(0.6) + dReal(0.7) * dReal(i)));
        step(60);
        for (const dBodyID body : bodies)
            for (const dReal* from :
                 {dBodyGetPosition(body), dBodyGetLinearVel(body), dBodyGetAngularVel(body)})
                state.insert(state.end(), from, from + 3);
    }
    EXPECT_EQ(std::memcmp(states[0].data(), states[1].data(), states[0].size() * sizeof(dReal)), 0);
}

INSTANTIATE_TEST_SUITE_P(Steppers, StepperContract, testing::ValuesIn(all_steppers()),
                         [](const testing::TestParamInfo<Line>& line) { return line.param.name; });

}  // namespace
}  // namespace epode
