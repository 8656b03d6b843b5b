// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What stands on more contacts than it needs: each carries a share, so that driven wheels next to casters have traction. Contacts
// of one machine have one layer, whatever the sizes of its geoms.
#include "world_contacts.h"

namespace epode::physics {
namespace {

constexpr double kG = 9.81, kStep = 0.002;
const char* const kPresets[] = {"ode", "game", "robot"};

int quick(dWorldID world, dReal h) { return dWorldQuickStep(world, h); }
int (*const kWays[])(dWorldID, dReal) = {dWorldStep, dWorldStepHybrid, quick};

struct Floored : Sim {
    explicit Floored(int preset)
    {
        dWorldUseDefaults(world, preset);
        dWorldSetAutoDisableFlag(world, 0);
        gravity(0, 0, -kG);
        dWorldSetContactSpace(world, space);
        ground();
    }
    // A foot of a body: a ball about a point of its frame.
    dGeomID foot(dBodyID body, V3 at, double radius)
    {
        const dGeomID ball = dCreateSphere(space, real(radius));
        dGeomSetBody(ball, body);
        dGeomSetOffsetPosition(ball, real(at.x), real(at.y), real(at.z));
        return ball;
    }
};

// Two casters of 4 cm without friction, two driven wheels of 10 cm, all on the ground at first.
class Robot : public Floored {
  public:
    explicit Robot(int preset) : Floored(preset)
    {
        base_ = box({0, 0, 0.13}, {0.4, 0.3, 0.1}, 8);
        for (double x : {-0.17, 0.17}) set_material(foot(base_, {x, 0, -0.09}, 0.04), 0);
        for (double y : {-0.2, 0.2}) {
            const dBodyID wheel = sphere({0, y, kRadius}, kRadius, 0.5);
            set_material(geom_of(wheel), 1);
            const dJointID hinge = dJointCreateHinge(world, nullptr);
            dJointAttach(hinge, wheel, base_);
            dJointSetHingeAnchor(hinge, 0, real(y), real(kRadius));
            dJointSetHingeAxis(hinge, 0, 1, 0);
            dJointSetHingeParam(hinge, dParamFMax, 2);
            hinges_.push_back(hinge);
        }
    }

    // How far it goes in so many seconds, of what the wheels turn.
    double drive(double seconds, int (*way)(dWorldID, dReal))
    {
        constexpr double kRate = 5;
        turn(kRate);
        for (int i = 0; i < int(seconds / kStep); ++i) EXPECT_EQ(way(world, real(kStep)), 1);
        return position(base_).x / (kRate * kRadius * seconds);
    }

    // Its speed so many seconds after the wheels have stopped.
    double brake(double seconds, int (*way)(dWorldID, dReal))
    {
        turn(0);
        for (int i = 0; i < int(seconds / kStep); ++i) EXPECT_EQ(way(world, real(kStep)), 1);
        return length(velocity(base_));
    }

  private:
    void turn(double rate)
    {
        for (dJointID hinge : hinges_) dJointSetHingeParam(hinge, dParamVel, real(rate));
    }

    static constexpr double kRadius = 0.1;
    dBodyID base_;
    std::vector<dJointID> hinges_;
};

class SharedLoad : public testing::TestWithParam<int> {};

TEST_P(SharedLoad, gives_wheels_next_to_casters_traction)
{
    for (auto* way : kWays) {
        Robot robot(GetParam());
        EXPECT_GT(robot.drive(4, way), 0.9);
    }
}

// (The wheels had no load when they stopped: 0.34 m/s in the game preset, for ever.)
TEST_P(SharedLoad, lets_wheels_next_to_casters_brake)
{
    for (auto* way : kWays) {
        Robot robot(GetParam());
        robot.drive(2, way);
        EXPECT_LT(robot.brake(2, way), 1e-3);
    }
}

// Round feet of two sizes under a plate: the fourth has its share, though three are enough.
TEST_P(SharedLoad, is_carried_by_all_feet)
{
    constexpr double kMass = 8;
    Floored scene(GetParam());
    const dBodyID plate = scene.box({0, 0, 0.1}, {0.4, 0.4, 0.02}, kMass);
    for (double x : {-0.17, 0.17}) scene.foot(plate, {x, 0, -0.06}, 0.04);
    for (double y : {-0.17, 0.17}) scene.foot(plate, {0, y, -0.01}, 0.09);
    for (int i = 0; i < 500; ++i) dWorldStepHybrid(scene.world, real(kStep));
    std::vector<dWorldContact> contacts(8);
    contacts.resize(std::size_t(dWorldGetContacts(scene.world, contacts.data(), 8)));
    ASSERT_EQ(contacts.size(), 4u);
    for (const dWorldContact& c : contacts) EXPECT_NEAR(c.normal_force, kMass * kG / 4, tol(0.1, 2));
}

INSTANTIATE_TEST_SUITE_P(Presets, SharedLoad, testing::Range(0, 3),
                         [](const auto& preset) { return kPresets[preset.param]; });

}  // namespace
}  // namespace epode::physics
