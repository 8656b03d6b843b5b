// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Isolated bodies exchange momentum and keep its sum, whatever joint is between them and whatever the stepper
// leaves unsolved: J is opposite for the two bodies. Angular momentum about the origin is kept too where the
// two anchors are in one point: a gap d lets the force F turn the pair by d x F, so the first step of a joint
// that fits is exact and later ones are bounded by the gap. Inertia is that of a ball: of others the
// integrator without its gyroscopic term keeps w and not R I R^T w.
#include <algorithm>
#include <functional>

#include "rig.h"

namespace epode::physics {
namespace {

struct Kind {
    const char* name;
    std::function<void(Sim&, dBodyID, dBodyID)> join;
};

dJointID attach(dJointID j, dBodyID a, dBodyID b)
{
    dJointAttach(j, a, b);
    return j;
}

void join_ball(Sim& sim, dBodyID a, dBodyID b)
{
    dJointSetBallAnchor(attach(dJointCreateBall(sim.world, nullptr), a, b), real(0.4), real(0.1), real(-0.2));
}

void join_hinge(Sim& sim, dBodyID a, dBodyID b)
{
    dJointID j = attach(dJointCreateHinge(sim.world, nullptr), a, b);
    dJointSetHingeAnchor(j, real(0.4), real(0.1), real(-0.2));
    dJointSetHingeAxis(j, 1, 2, -1);
    dJointSetHingeParam(j, dParamVel, 3);
    dJointSetHingeParam(j, dParamFMax, 2);
}

void join_slider(Sim& sim, dBodyID a, dBodyID b)
{
    dJointID j = attach(dJointCreateSlider(sim.world, nullptr), a, b);
    dJointSetSliderAxis(j, 1, 2, -1);
    dJointSetSliderParam(j, dParamVel, 3);
    dJointSetSliderParam(j, dParamFMax, 2);
}

void join_universal(Sim& sim, dBodyID a, dBodyID b)
{
    dJointID j = attach(dJointCreateUniversal(sim.world, nullptr), a, b);
    dJointSetUniversalAnchor(j, real(0.4), real(0.1), real(-0.2));
    dJointSetUniversalAxis1(j, 1, 0, 0);
    dJointSetUniversalAxis2(j, 0, 1, 0);
    dJointSetUniversalParam(j, dParamVel1, 1);
    dJointSetUniversalParam(j, dParamFMax1, 2);
}

void join_hinge2(Sim& sim, dBodyID a, dBodyID b)
{
    const dVector3 axis1{0, 0, 1, 0}, axis2{0, 1, 0, 0};
    dJointID j = attach(dJointCreateHinge2(sim.world, nullptr), a, b);
    dJointSetHinge2Anchor(j, real(0.4), real(0.1), real(-0.2));
    dJointSetHinge2Axes(j, axis1, axis2);
    dJointSetHinge2Param(j, dParamVel2, 4);
    dJointSetHinge2Param(j, dParamFMax2, 2);
}

void join_fixed(Sim& sim, dBodyID a, dBodyID b)
{
    dJointSetFixed(attach(dJointCreateFixed(sim.world, nullptr), a, b));
}

void join_amotor(Sim& sim, dBodyID a, dBodyID b)
{
    dJointID j = attach(dJointCreateAMotor(sim.world, nullptr), a, b);
    dJointSetAMotorNumAxes(j, 2);
    dJointSetAMotorAxis(j, 0, 0, 1, 0, 0);
    dJointSetAMotorAxis(j, 1, 0, 0, 1, 1);
    for (int group : {0, int(dParamGroup)}) {
        dJointSetAMotorParam(j, dParamVel + group, 2);
        dJointSetAMotorParam(j, dParamFMax + group, 1);
    }
}

void join_pr(Sim& sim, dBodyID a, dBodyID b)
{
    dJointID j = attach(dJointCreatePR(sim.world, nullptr), a, b);
    dJointSetPRAnchor(j, real(0.4), real(0.1), real(-0.2));
    dJointSetPRAxis1(j, 1, 2, -1);
    dJointSetPRAxis2(j, 1, 0, 1);
    for (int group : {0, int(dParamGroup)}) {
        dJointSetPRParam(j, dParamVel + group, 3);
        dJointSetPRParam(j, dParamFMax + group, 2);
    }
}

void join_pu(Sim& sim, dBodyID a, dBodyID b)
{
    dJointID j = attach(dJointCreatePU(sim.world, nullptr), a, b);
    dJointSetPUAnchor(j, real(0.4), real(0.1), real(-0.2));
    dJointSetPUAxis1(j, 1, 0, 0);
    dJointSetPUAxis2(j, 0, 1, 0);
    dJointSetPUAxis3(j, 1, 2, -1);
    dJointSetPUParam(j, dParamVel3, 3);
    dJointSetPUParam(j, dParamFMax3, 2);
}

void join_piston(Sim& sim, dBodyID a, dBodyID b)
{
    dJointID j = attach(dJointCreatePiston(sim.world, nullptr), a, b);
    dJointSetPistonAnchor(j, real(0.4), real(0.1), real(-0.2));
    dJointSetPistonAxis(j, 1, 2, -1);
    dJointSetPistonParam(j, dParamVel, 3);
    dJointSetPistonParam(j, dParamFMax, 2);
}

void join_dball(Sim& sim, dBodyID a, dBodyID b)
{
    dJointID j = attach(dJointCreateDBall(sim.world, nullptr), a, b);
    dJointSetDBallAnchor1(j, real(0.4), real(0.1), real(-0.2));
    dJointSetDBallAnchor2(j, real(0.7), real(0.4), real(0.2));
}

void join_dhinge(Sim& sim, dBodyID a, dBodyID b)
{
    dJointID j = attach(dJointCreateDHinge(sim.world, nullptr), a, b);
    dJointSetDHingeAxis(j, 0, 0, 1);
    dJointSetDHingeAnchor1(j, real(0.4), real(0.1), real(-0.2));
    dJointSetDHingeAnchor2(j, real(0.7), real(0.4), real(-0.2));
}

void join_contact(Sim& sim, dBodyID a, dBodyID b)
{
    dContact c = make_contact({0.4, 0.1, -0.2}, {0.6, 0, 0.8}, 0.01);
    c.surface.mode |= dContactBounce | dContactRolling;
    c.surface.mu = real(0.4);
    c.surface.bounce = real(0.5);
    c.surface.rho = real(0.1);
    attach(dJointCreateContact(sim.world, nullptr, &c), a, b);
}

const Kind kKinds[] = {
    {"ball", join_ball},     {"hinge", join_hinge}, {"slider", join_slider}, {"universal", join_universal},
    {"hinge2", join_hinge2}, {"fixed", join_fixed}, {"amotor", join_amotor}, {"contact", join_contact},
    {"pr", join_pr},         {"pu", join_pu},       {"piston", join_piston}, {"dball", join_dball},
    {"dhinge", join_dhinge}};

// Two bodies moving towards each other, at random otherwise.
void fill(Sim& sim, Random& random)
{
    dBodyID a = sim.body({0, 0, 0}, random.uniform(0.5, 3), random.uniform(0.3, 2));
    dBodyID b = sim.body({1, 0.2, -0.3}, random.uniform(0.5, 3), random.uniform(0.3, 2));
    velocity(a, random.point(3), random.point(3));
    velocity(b, random.point(3), random.point(3));
}

struct Momentum : testing::TestWithParam<Stepper> {};

TEST_P(Momentum, is_kept_to_rounding_by_every_joint)
{
    for (const Kind& kind : kKinds) {
        Random random(7);
        for (int trial = 0; trial < 10; ++trial) {
            Sim sim(GetParam());
            fill(sim, random);
            kind.join(sim, sim.bodies[0], sim.bodies[1]);
            const V3 p = momentum(sim);
            // Contact bounces, motors run: a hundred steps of everything the joint can do.
            for (int i = 0; i < 100; ++i) sim.advance(0.01);
            // Two additions of impulses of size ~10 per row, sweep and step.
            EXPECT_LT(length(momentum(sim) - p), 2e5 * kEpsilon) << kind.name << " trial " << trial;
        }
    }
}

TEST_P(Momentum, of_turning_is_kept_to_rounding_while_a_joint_fits)
{
    for (const Kind& kind : kKinds) {
        Random random(11);
        for (int trial = 0; trial < 20; ++trial) {
            Sim sim(GetParam());
            sim.substeps = 1;  // the second substep starts with a gap of its own
            fill(sim, random);
            kind.join(sim, sim.bodies[0], sim.bodies[1]);
            const V3 L = angular_momentum(sim);
            sim.advance(0.01);
            // Substeps keep the arms of contacts from the beginning of the step: first order in h.
            const bool frozen_arms = GetParam() == Stepper::kFast && std::string(kind.name) == "contact";
            const double allowed = frozen_arms ? 2 * 0.01 : 2e3 * kEpsilon;
            EXPECT_LT(length(angular_momentum(sim) - L), allowed) << kind.name << " trial " << trial;
        }
    }
}

TEST_P(Momentum, of_turning_is_kept_in_a_long_run_as_far_as_joints_fit)
{
    for (const Kind& kind : kKinds) {
        if (kind.join.target<void (*)(Sim&, dBodyID, dBodyID)>() &&
            *kind.join.target<void (*)(Sim&, dBodyID, dBodyID)>() == &join_contact)
            continue;  // its point stays where it was made
        double drift[2] = {0, 0};
        for (int k = 0; k < 2; ++k) {
            const double h = k == 0 ? 0.004 : 0.001;
            Random random(13);
            Sim sim(GetParam());
            sim.substeps = 2;
            fill(sim, random);
            kind.join(sim, sim.bodies[0], sim.bodies[1]);
            const V3 L = angular_momentum(sim);
            for (int i = 0, n = int(1 / h + 0.5); i < n; ++i) sim.advance(h);
            drift[k] = length(angular_momentum(sim) - L) / length(L);
        }
        EXPECT_LT(drift[1], 5e-3) << kind.name;
        EXPECT_LT(drift[1], 0.5 * drift[0] + tol(1e-9, 1e-4)) << kind.name << ": shrinks with the step";
    }
}

// A loose crowd in empty space: spheres flying into each other, some of them jointed.
TEST_P(Momentum, of_a_colliding_crowd_is_kept_to_rounding)
{
    Sim sim(GetParam());
    Random random(17);
    for (int i = 0; i < 40; ++i) {
        dBodyID b = sim.sphere(random.point(2), 0.4, random.uniform(0.5, 2));
        velocity(b, -1.5 * position(b) + random.point(0.5), random.point(2));
    }
    for (std::size_t i = 0; i + 1 < 20; i += 2) {
        dJointID j = attach(dJointCreateBall(sim.world, nullptr), sim.bodies[i], sim.bodies[i + 1]);
        const V3 middle = 0.5 * (position(sim.bodies[i]) + position(sim.bodies[i + 1]));
        dJointSetBallAnchor(j, real(middle.x), real(middle.y), real(middle.z));
    }
    const V3 p = momentum(sim);
    int met = 0;
    for (int i = 0; i < 200; ++i) {
        sim.step(0.01);
        met = std::max(met, sim.contact_count);
    }
    EXPECT_GT(met, 15) << "or nothing was tested";
    EXPECT_TRUE(finite_state(sim));
    EXPECT_LT(length(momentum(sim) - p), 1e7 * kEpsilon) << "200 steps, up to 100 contacts, impulses to 10";
}

INSTANTIATE_TEST_SUITE_P(Steppers, Momentum, testing::ValuesIn(kSteppers), case_name);

}  // namespace
}  // namespace epode::physics
