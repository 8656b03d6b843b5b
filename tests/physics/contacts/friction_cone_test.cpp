// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// dWorldSetFrictionCone: what slides on contact joints is braked by mu g in whatever direction it goes, where
// the pyramid brakes by up to 1.41 times that and pulls askew.
#include <algorithm>

#include "rig.h"

namespace epode::physics {
namespace {

constexpr double kG = 9.81, kMu = 0.4;

// Under gravity, with friction of 0.4 in a cone.
struct ConeSim : Sim {
    explicit ConeSim(Stepper solver, int cone = 1) : Sim(solver)
    {
        gravity(0, 0, -kG);
        surface.mu = real(kMu);
        dWorldSetFrictionCone(world, cone);
    }
};

class Cone : public testing::TestWithParam<Stepper> {};

// Of boxes that lie on the ground with a speed of 3 m/s in the direction `angle`: along it, and across.
struct Braked {
    double least = 1e9, largest = 0, askew = 0;
};

Braked brake(Sim& sim, double angle, int boxes)
{
    const double h = 0.002, v0 = 3;
    const int steps = 200;
    const V3 along{std::cos(angle), std::sin(angle), 0}, across{-along.y, along.x, 0};
    sim.ground();
    for (int i = 0; i < boxes; ++i) sim.box({4.0 * i, 0, 0.1}, {1, 1, 0.2}, 5);
    sim.steps(100, h);
    for (const dBodyID box : sim.bodies) velocity(box, v0 * along);
    sim.steps(steps, h);
    Braked out;
    for (const dBodyID box : sim.bodies) {
        const double rate = (v0 - dot(velocity(box), along)) / (steps * h);
        out.least = std::min(out.least, rate), out.largest = std::max(out.largest, rate);
        out.askew = std::max(out.askew, std::abs(dot(velocity(box), across)));
    }
    return out;
}

// 16 boxes are 64 contacts, which QuickStep takes in floats.
TEST_P(Cone, brakes_by_mu_g_in_every_direction)
{
    for (const int boxes : {1, 16})
        for (int k = 0; k < 8; ++k) {
            ConeSim sim(GetParam());
            const Braked got = brake(sim, 0.1 + k * kPi / 4.3, boxes);
            EXPECT_NEAR(got.least, kMu * kG, 0.01 * kMu * kG) << boxes << ' ' << k;
            EXPECT_NEAR(got.largest, kMu * kG, 0.01 * kMu * kG) << boxes << ' ' << k;
            EXPECT_LT(got.askew, 0.01) << boxes << ' ' << k;
        }
}

TEST_P(Cone, stays_with_rolling_friction)
{
    for (int k = 0; k < 8; ++k) {
        ConeSim sim(GetParam());
        sim.surface.mode |= dContactRolling;
        sim.surface.rho = real(1e-6);
        const Braked got = brake(sim, 0.1 + k * kPi / 4.3, 1);
        EXPECT_NEAR(got.least, kMu * kG, 0.01 * kMu * kG) << k;
        EXPECT_LT(got.askew, 0.01) << k;
    }
}

TEST_P(Cone, is_off_by_default_and_the_pyramid_brakes_more_across_its_edges)
{
    Sim sim(GetParam());
    EXPECT_EQ(dWorldGetFrictionCone(sim.world), 0);
    sim.gravity(0, 0, -kG);
    sim.surface.mu = real(kMu);
    EXPECT_NEAR(brake(sim, kPi / 4, 1).largest, std::sqrt(2.0) * kMu * kG, 0.02 * kMu * kG);
}

// With mu along one direction and 3 mu along the other, forces lie in the ellipse, on its rim while it
// slides.
TEST_P(Cone, is_an_ellipse_where_the_two_differ)
{
    ConeSim sim(GetParam());
    const dBodyID body = sim.body({0, 0, 0}, 2);
    velocity(body, {3, 2, 0});
    for (int i = 0; i < 400; ++i) {
        dJointGroupEmpty(sim.contacts);
        dContact c = make_contact(position(body), {0, 0, 1}, 0);
        c.surface.mode |= dContactFDir1 | dContactMu2;
        c.surface.mu = real(kMu), c.surface.mu2 = real(3 * kMu);
        c.fdir1[0] = 1;
        const dJointID joint = dJointCreateContact(sim.world, sim.contacts, &c);
        dJointAttach(joint, body, nullptr);
        dJointFeedback feedback{};
        dJointSetFeedback(joint, &feedback);
        const bool slid = length(velocity(body)) > 0.2;
        sim.advance(0.005);
        const double n = double(feedback.f1[2]);
        const double share =
            std::hypot(double(feedback.f1[0]) / (kMu * n), double(feedback.f1[1]) / (3 * kMu * n));
        EXPECT_LT(share, 1 + 1e-4) << i;
        if (slid && length(velocity(body)) > 0.2) { EXPECT_GT(share, 1 - 1e-4) << i; }
    }
    EXPECT_LT(length(velocity(body)), 0.01);
}

TEST_P(Cone, bears_friction_without_limit_and_none)
{
    for (const dReal mu : {dInfinity, real(0)}) {
        ConeSim sim(GetParam());
        sim.surface.mu = mu;
        sim.ground();
        for (int i = 0; i < 20; ++i) sim.box({2.0 * i, 0, 0.6}, {1, 1, 1}, 5);
        for (const dBodyID box : sim.bodies) velocity(box, {1, 1, 0});
        sim.steps(100, 0.01);
        EXPECT_TRUE(finite_state(sim));
        for (const dBodyID box : sim.bodies) {
            if (mu == 0) { EXPECT_NEAR(length(velocity(box)), std::sqrt(2.0), 0.01); }
        }
    }
}

// Boxes let go on a slope, mu = 0.5 = tan 26.57 degrees, at 1/60 s. Corners that pull against each other would
// use up a part of their limits: they must stick at 26 degrees, and slide with g (sin - mu cos) at 27.
struct Slid {
    double farthest = 0, slowest = 1e9, fastest = 0;
};

Slid slide(Stepper stepper, double degrees, double yaw, int boxes)
{
    constexpr double kStep = 1.0 / 60, kSeconds = 4;
    ConeSim sim(stepper);
    const double slope = degrees * kPi / 180, down = kG * std::sin(slope);
    sim.gravity(down * std::cos(yaw), down * std::sin(yaw), -kG * std::cos(slope));
    sim.surface.mu = real(0.5);
    if (kSingle) dWorldSetCFM(sim.world, 0);  // the default of floats, 1e-5, lets a tonne creep by 10 mm/s
    sim.ground();
    for (int i = 0; i < boxes; ++i) sim.box({5.0 * i, 0, 0.5}, {1, 1, 1}, 1000);
    sim.steps(int(kSeconds / kStep), kStep);
    Slid out;
    for (int i = 0; i < boxes; ++i) {
        const dBodyID box = sim.bodies[std::size_t(i)];
        out.farthest = std::max(out.farthest, length(position(box) - V3{5.0 * i, 0, 0.5}));
        out.slowest = std::min(out.slowest, length(velocity(box)));
        out.fastest = std::max(out.fastest, length(velocity(box)));
    }
    return out;
}

TEST_P(Cone, sticks_and_slides_at_the_angle_of_friction)
{
    const bool sweeps = GetParam() == Stepper::kQuick;
    const double slope = 27 * kPi / 180, speed = 4 * kG * (std::sin(slope) - 0.5 * std::cos(slope));
    for (const int boxes : {1, 16})
        for (const double yaw : {0.0, 0.6}) {
            EXPECT_LT(slide(GetParam(), 26, yaw, boxes).farthest, sweeps ? tol(1e-4, 5e-3) : 5e-3)
                << boxes << ' ' << yaw;
            const Slid at27 = slide(GetParam(), 27, yaw, boxes);
            EXPECT_NEAR(at27.slowest, speed, 0.02 * speed) << boxes << ' ' << yaw;
            EXPECT_NEAR(at27.fastest, speed, 0.02 * speed) << boxes << ' ' << yaw;
        }
}

INSTANTIATE_TEST_SUITE_P(Steppers, Cone, testing::ValuesIn(kSteppers), case_name);

// What stands and slides must not depend on the compliance that a world has by default: without any, corners
// whose contacts come and go with the last digit of their depth would fall and slide by a millimetre each
// time. The exact stepper's pyramid is aligned with the slope. CFM acts per force, so light boxes have none
// to speak of either.
struct FirmCase {
    Stepper stepper;
    bool world_contacts;
};

std::string firm_name(const testing::TestParamInfo<FirmCase>& info)
{
    return name_of(info.param.stepper) +
           std::string(info.param.world_contacts ? "_world_contacts" : "_joints");
}

class FirmContacts : public testing::TestWithParam<FirmCase> {};

Slid slide_firmly(const FirmCase& way, double degrees, double cfm, double mass, double h, int boxes)
{
    constexpr double kSeconds = 2;
    ConeSim sim(way.stepper);
    const double slope = degrees * kPi / 180;
    sim.gravity(kG * std::sin(slope), 0, -kG * std::cos(slope));
    sim.surface.mu = real(0.5);
    dWorldSetCFM(sim.world, real(cfm));
    if (way.world_contacts) dWorldSetContactSpace(sim.world, sim.space);
    dMaterial material;
    dMaterialInit(&material, sizeof material);
    material.friction = real(0.5);
    dGeomSetMaterial(sim.ground(), &material);
    for (int i = 0; i < boxes; ++i)
        dGeomSetMaterial(dBodyGetFirstGeom(sim.box({5.0 * i, 0, 0.5}, {1, 1, 1}, mass)), &material);
    for (int i = 0; i < int(kSeconds / h); ++i) way.world_contacts ? sim.advance(h) : sim.step(h);
    Slid out;
    for (int i = 0; i < boxes; ++i) {
        const dBodyID box = sim.bodies[std::size_t(i)];
        out.farthest = std::max(out.farthest, length(position(box) - V3{5.0 * i, 0, 0.5}));
        out.slowest = std::min(out.slowest, length(velocity(box)));
        out.fastest = std::max(out.fastest, length(velocity(box)));
    }
    return out;
}

TEST_P(FirmContacts, stand_and_slide_without_compliance_as_with_it)
{
    const double slope = 27 * kPi / 180, speed = 2 * kG * (std::sin(slope) - 0.5 * std::cos(slope));
    const bool soft = GetParam().stepper == Stepper::kFast;
    const double stands =
        GetParam().world_contacts || GetParam().stepper == Stepper::kFast ? 2e-3 : tol(1e-5, 1e-4);
    for (const double h : {1.0 / 60, 1.0 / 240})
        for (const double mass : {1000.0, 1e-3})
            for (const double cfm : {0.0, 1e-13, 1e-10})
                for (const int boxes : {1, 16}) {
                    EXPECT_LT(slide_firmly(GetParam(), 26, cfm, mass, h, boxes).farthest, stands)
                        << h << ' ' << mass << ' ' << cfm << ' ' << boxes;
                    const Slid at27 = slide_firmly(GetParam(), 27, cfm, mass, h, boxes);
                    // The first step of substeps finds friction late.
                    const double off = 0.01 * speed + (soft ? 0.25 * kG * h : 0);
                    EXPECT_NEAR(at27.slowest, speed, off) << h << ' ' << mass << ' ' << cfm << ' ' << boxes;
                    EXPECT_NEAR(at27.fastest, speed, off) << h << ' ' << mass << ' ' << cfm << ' ' << boxes;
                }
}

INSTANTIATE_TEST_SUITE_P(Ways, FirmContacts,
                         testing::Values(FirmCase{Stepper::kExact, false}, FirmCase{Stepper::kQuick, false},
                                         FirmCase{Stepper::kFast, false}, FirmCase{Stepper::kExact, true},
                                         FirmCase{Stepper::kQuick, true}, FirmCase{Stepper::kFast, true}),
                         firm_name);

// What is reported is measured against the cone: swept for long, nothing is left.
TEST(ConeReport, is_zero_after_many_sweeps)
{
    ConeSim sim(Stepper::kQuick);
    sim.gravity(1, 2, -kG);
    dWorldSetQuickStepNumIterations(sim.world, 2000);
    dWorldSetStepReportMode(sim.world, 1);
    sim.ground();
    velocity(sim.box({0, 0, 0.1}, {1, 1, 0.2}, 5), {1, 2, 0});
    sim.steps(10, 0.01);
    EXPECT_LT(sim.report().residual, tol(1e-6, 1e-3));
    EXPECT_GT(length(velocity(sim.bodies[0])), 1.5);  // it slides
}

TEST(ConeSetter, refuses_other_modes)
{
    Sim sim;
    Messages messages;
    dWorldSetFrictionCone(sim.world, 2);
    dWorldSetFrictionCone(sim.world, -1);
    EXPECT_EQ(dWorldGetFrictionCone(sim.world), 0);
    EXPECT_EQ(messages.count(), 2);
}

}  // namespace
}  // namespace epode::physics
