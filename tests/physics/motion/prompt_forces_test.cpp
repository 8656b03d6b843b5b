// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Forces of the program on what touches or is joined, in every way to divide a step: springs keep their energy, as semi-implicit
// Euler does, and loads stay loads.
#include <algorithm>
#include <string>
#include <tuple>

#include "world_contacts.h"

namespace epode::physics {
namespace {

enum class Divided { kFast2, kFast4, kFast16, kExactSubsteps, kGame, kNetwork };

const char* name_of(Divided way)
{
    constexpr const char* kNames[] = {"fast_2", "fast_4", "fast_16", "exact_substeps", "game", "network"};
    return kNames[int(way)];
}

class PromptForces : public testing::TestWithParam<std::tuple<Divided, double>> {
  protected:
    PromptForces() : sim(Stepper::kFast)
    {
        switch (way()) {
            case Divided::kFast2:
                sim.substeps = 2;
                break;
            case Divided::kFast4:
                sim.substeps = 4;
                break;
            case Divided::kFast16:
                sim.substeps = 16;
                break;
            case Divided::kExactSubsteps:
                dWorldSetExactSubsteps(sim.world, 4);
                break;
            case Divided::kGame:
                dWorldUseDefaults(sim.world, dDefaultsGame);
                break;
            case Divided::kNetwork:
                dWorldSetHybridStepper(sim.world, dStepperSubstepsExactJoints);
        }
        dWorldSetAutoDisableFlag(sim.world, 0);
        dWorldSetStepThreads(sim.world, 1);
        sim.gravity(0, 0, -9.81);
    }

    Divided way() const { return std::get<0>(GetParam()); }
    double h() const { return std::get<1>(GetParam()); }

    void manage_contacts() { dWorldSetContactSpace(sim.world, sim.space); }

    void step()
    {
        switch (way()) {
            case Divided::kExactSubsteps:
                ASSERT_EQ(dWorldStep(sim.world, real(h())), 1);
                break;
            case Divided::kGame:
            case Divided::kNetwork:
                ASSERT_EQ(dWorldStepHybrid(sim.world, real(h())), 1);
                break;
            default:
                ASSERT_EQ(dWorldStepFast1(sim.world, real(h()), sim.substeps), 1);
        }
    }

    // Steps for `seconds` with f(step) before each; returns the largest E(x, v) of the last fifth over that of the first.
    template <typename Force, typename Energy>
    double growth(double seconds, const Force& force, const Energy& energy)
    {
        const int n = int(seconds / h() + 0.5);
        double first = 0, last = 0;
        for (int i = 0; i < n; ++i) {
            force();
            step();
            if (i < n / 5) first = std::max(first, energy());
            if (i >= n - n / 5) last = std::max(last, energy());
        }
        return last / first;
    }

    double change_along_floor()
    {
        set_material(sim.ground(), 0);
        const dBodyID box = sim.box({0.1, 0, 0.1}, {0.2, 0.2, 0.2}, 1);
        set_material(geom_of(box), 0);
        sim.surface.mu = 0;
        constexpr double k = 400;
        return growth(
            3,
            [&] {
                dJointGroupEmpty(sim.contacts), sim.collide();
                dBodyAddForce(box, real(-k * position(box).x), 0, 0);
            },
            [&] { return 0.5 * k * std::pow(position(box).x, 2) + 0.5 * std::pow(velocity(box).x, 2); });
    }

    Sim sim;
};

std::string case_of(const testing::TestParamInfo<std::tuple<Divided, double>>& info)
{
    return std::string(name_of(std::get<0>(info.param))) + "_" +
           std::to_string(int(1 / std::get<1>(info.param) + 0.5));
}

// 3.2 Hz along a floor without friction.
TEST_P(PromptForces, a_spring_along_a_floor_keeps_its_energy)
{
    manage_contacts();
    EXPECT_NEAR(change_along_floor(), 1, 0.02);
}

TEST_P(PromptForces, a_spring_along_a_floor_of_contact_joints_keeps_its_energy)
{
    EXPECT_NEAR(change_along_floor(), 1, 0.02);
}

// A controller's torque on an arm, about its hinge, with its bearing: w = 20 rad/s.
TEST_P(PromptForces, a_torque_on_a_hinged_arm_keeps_its_energy)
{
    sim.gravity(0, 0, 0);
    const dBodyID arm = sim.box({0.5, 0, 0}, {1, 0.1, 0.1}, 1);
    const dJointID hinge = dJointCreateHinge(sim.world, nullptr);
    dJointAttach(hinge, arm, nullptr);
    dJointSetHingeAnchor(hinge, 0, 0, 0);
    dJointSetHingeAxis(hinge, 0, 0, 1);
    const double I = 1.0 / 12 * (1 + 0.01) + 0.25, k = 400 * I;
    velocity(arm, {0, 0.5, 0}, {0, 0, 1});
    const auto angle = [&] { return double(dJointGetHingeAngle(hinge)); };
    const double change = growth(
        3, [&] { dBodyAddTorque(arm, 0, 0, real(-k * angle())); },
        [&] {
            return 0.5 * k * std::pow(angle(), 2) +
                   0.5 * I * std::pow(double(dJointGetHingeAngleRate(hinge)), 2);
        });
    EXPECT_LT(change, 1.02);
    EXPECT_GT(change, 0.9);
}

// Two bodies on a slider, a spring of the program between them: its force is the joint's only motion.
TEST_P(PromptForces, a_spring_between_joined_bodies_keeps_its_energy)
{
    sim.gravity(0, 0, 0);
    const dBodyID a = sim.body({0, 0, 0}, 1, 0.1), b = sim.body({1.1, 0, 0}, 3, 0.1);
    const dJointID slider = dJointCreateSlider(sim.world, nullptr);
    dJointAttach(slider, a, b);
    dJointSetSliderAxis(slider, 1, 0, 0);
    const double k = 300;
    const auto way = [&] { return position(b).x - position(a).x - 1; };
    const double change = growth(
        3,
        [&] {
            const dReal f = real(k * way());
            dBodyAddForce(a, f, 0, 0), dBodyAddForce(b, -f, 0, 0);
        },
        [&] { return 0.5 * k * way() * way() + kinetic_energy(a) + kinetic_energy(b); });
    EXPECT_NEAR(change, 1, 0.02);
    EXPECT_NEAR(momentum(sim).x, 0, tol(1e-10, 1e-4));
}

// The program's own gravity: what lies on a floor must neither hop nor sink.
TEST_P(PromptForces, a_pile_under_the_programs_gravity_rests)
{
    sim.gravity(0, 0, 0);
    manage_contacts();
    sim.ground();
    for (int i = 0; i < 5; ++i) sim.box({0, 0, 0.25 + 0.5 * i}, {0.5, 0.5, 0.5}, 2);
    double fastest = 0;
    for (int i = 0, n = int(3 / h()); i < n; ++i) {
        for (dBodyID b : sim.bodies) dBodyAddForce(b, 0, 0, real(-2 * 9.81));
        step();
        for (dBodyID b : sim.bodies)
            if (i > n / 2) fastest = std::max(fastest, length(velocity(b)));
    }
    EXPECT_LT(fastest, 2e-3);
    EXPECT_NEAR(position(sim.bodies.back()).z, 2.25, way() == Divided::kFast2 ? 0.03 : 0.02);
}

// Half of its weight is taken off a box: it stays on the floor, and slides when what is left of friction allows.
TEST_P(PromptForces, a_lift_below_the_weight_lifts_nothing)
{
    manage_contacts();
    sim.ground();
    const dBodyID box = sim.box({0, 0, 0.25}, {0.5, 0.5, 0.5}, 2);
    double highest = 0, fastest = 0;
    for (int i = 0, n = int(2 / h()); i < n; ++i) {
        dBodyAddForce(box, 0, 0, real(0.5 * 2 * 9.81));
        step();
        if (i < n / 2) continue;
        highest = std::max(highest, position(box).z);
        fastest = std::max(fastest, length(velocity(box)));
    }
    EXPECT_LT(highest, 0.25 + 1e-5);
    EXPECT_LT(fastest, 1e-3);
}

// Below the limit of friction a push moves nothing; above it the box moves as Coulomb says.
TEST_P(PromptForces, a_push_meets_friction)
{
    manage_contacts();
    set_material(sim.ground(), 0.5);
    const dBodyID held = sim.box({0, 0, 0.2}, {0.4, 0.4, 0.4}, 1),
                  slides = sim.box({0, 5, 0.2}, {0.4, 0.4, 0.4}, 1);
    for (dBodyID b : {held, slides}) set_material(geom_of(b), 0.5);
    const int rest = int(1 / h()), n = int(2 / h());
    for (int i = 0; i < rest; ++i) step();
    const V3 a = position(held), b = position(slides);
    for (int i = 0; i < n; ++i) {
        dBodyAddForce(held, real(4.6), 0, 0), dBodyAddForce(slides, real(6), 0, 0);
        step();
    }
    const double slid = 0.5 * (6 - 0.5 * 9.81) * 4;
    EXPECT_NEAR(position(held).x, a.x, way() == Divided::kFast2 ? 3e-3 : 1e-3);
    EXPECT_NEAR(position(slides).x, b.x + slid, 0.03 * slid);
}

INSTANTIATE_TEST_SUITE_P(Divided, PromptForces,
                         testing::Combine(testing::Values(Divided::kFast2, Divided::kFast4, Divided::kFast16,
                                                          Divided::kExactSubsteps, Divided::kGame,
                                                          Divided::kNetwork),
                                          testing::Values(1.0 / 60, 1.0 / 240, 0.001)),
                         case_of);

}  // namespace
}  // namespace epode::physics
