// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Couplings against closed forms in every way to step: gears, a differential, a fixed tendon with limits, a
// spring; momentum, energy, the members' feedback; what happens to members, sleep, breaking and states.
#include "drive_ways.h"

namespace epode::physics {
namespace {

constexpr double kStep = 0.005;

// Rotors on hinges along x to the world, each with its inertia.
struct Rotors {
    Sim sim;
    std::vector<dBodyID> body;
    std::vector<dJointID> hinge;
    dJointID coupling;

    explicit Rotors(const std::vector<double>& inertias)
    {
        dWorldSetCFM(sim.world, 0);
        dWorldSetQuickStepW(sim.world, 1);
        for (double inertia : inertias) {
            body.push_back(sim.body({0, 3.0 * double(body.size()), 0}, 1, inertia));
            hinge.push_back(dJointCreateHinge(sim.world, nullptr));
            dJointAttach(hinge.back(), body.back(), nullptr);
            const V3 at = position(body.back());
            dJointSetHingeAnchor(hinge.back(), real(at.x), real(at.y), real(at.z));
            dJointSetHingeAxis(hinge.back(), 1, 0, 0);
        }
        coupling = dJointCreateCoupling(sim.world, nullptr);
    }
    void couple(const std::vector<double>& factors)
    {
        for (std::size_t i = 0; i < factors.size(); ++i)
            ASSERT_EQ(dJointSetCouplingAxis(coupling, int(i), hinge[i], 0, real(factors[i])), 1);
    }
    double angle(int i) const { return double(dJointGetAxisPosition(hinge[std::size_t(i)], 0)); }
    double rate(int i) const { return double(dJointGetAxisRate(hinge[std::size_t(i)], 0)); }
    double sum() const { return double(dJointGetAxisPosition(coupling, 0)); }
};

struct Couplings : testing::TestWithParam<Way> {};
INSTANTIATE_TEST_SUITE_P(Ways, Couplings, testing::ValuesIn(kWays), way_name);

// Two rotors with q_0 = 3 q_1: a torque T on the first accelerates it as I_0 + I_1/9 would.
TEST_P(Couplings, gear_accelerates_as_the_reduced_inertia)
{
    Rotors r({2, 9});
    r.couple({1, -3});
    const double torque = 6, inertia = 2 + 9.0 / 9;
    for (int i = 0; i < 200; ++i) {
        dBodyAddTorque(r.body[0], real(torque), 0, 0);
        step(r.sim, GetParam(), kStep);
    }
    EXPECT_NEAR(r.rate(0), torque / inertia * 200 * kStep, tol(2e-3, 5e-3));
    EXPECT_NEAR(r.rate(0), 3 * r.rate(1), tol(1e-3, 2e-3));
    EXPECT_NEAR(r.sum(), 0, tol(1e-3, 2e-3));
    // The coupling turns the second rotor, whose factor is -3.
    EXPECT_NEAR(double(dJointGetCouplingForce(r.coupling)), -torque / inertia / 3 * 9 / 3, tol(0.02, 0.02));
}

TEST(Coupling, exact_mimic_error_is_below_1e_9)
{
    if (kSingle) GTEST_SKIP() << "floats have seven digits";
    Rotors r({2, 1});
    r.couple({1, -1});
    double worst = 0;
    for (int i = 0; i < 1000; ++i) {
        dBodyAddTorque(r.body[0], real(5 * std::sin(0.02 * i)), 0, 0);
        dWorldStep(r.sim.world, real(kStep));
        worst = std::max(worst, std::fabs(r.sum()));
    }
    EXPECT_LT(worst, 1e-9);
}

// Turns are counted: a motor turns ten times, its gear five.
TEST_P(Couplings, gears_turn_without_end)
{
    Rotors r({1, 1});
    r.couple({1, -2});
    dDrive drive = no_drive();
    drive.damping = 1000, drive.target_velocity = 10;
    dJointSetDrive(r.hinge[0], 0, &drive);
    step(r.sim, GetParam(), kStep, 1300);
    EXPECT_GT(r.angle(0), 60);
    EXPECT_NEAR(r.angle(1), r.angle(0) / 2, 2e-3);
}

// Wheel 0 and 1 and the carrier 2 of a differential: q_0 + q_1 = 2 q_2. A torque on the carrier, one wheel
// held: the other turns twice as fast.
TEST_P(Couplings, make_a_differential)
{
    Rotors r({1, 1, 2});
    r.couple({1, 1, -2});
    dDrive brake = no_drive();
    brake.friction = 1e6;
    dJointSetDrive(r.hinge[0], 0, &brake);
    for (int i = 0; i < 200; ++i) {
        dBodyAddTorque(r.body[2], 3, 0, 0);
        step(r.sim, GetParam(), kStep);
    }
    EXPECT_NEAR(r.rate(0), 0, 1e-3);
    EXPECT_NEAR(r.rate(1), 2 * r.rate(2), 5e-3);
    EXPECT_NEAR(r.rate(2), 3.0 / (2 + 4) * 200 * kStep, 5e-3);
}

// A tendon over two sliders may be 1 m long at most: they move freely, then as one.
TEST_P(Couplings, tendon_has_limits)
{
    Sim sim;
    dWorldSetCFM(sim.world, 0);
    dWorldSetQuickStepW(sim.world, 1);
    dBodyID b[2];
    dJointID slider[2], tendon = dJointCreateCoupling(sim.world, nullptr);
    for (int i = 0; i < 2; ++i) {
        b[i] = sim.body({0, 3.0 * i, 0}, 1 + i);
        slider[i] = dJointCreateSlider(sim.world, nullptr);
        dJointAttach(slider[i], b[i], nullptr);
        dJointSetSliderAxis(slider[i], 1, 0, 0);
        ASSERT_EQ(dJointSetCouplingAxis(tendon, i, slider[i], 0, 1), 1);
    }
    dJointSetCouplingParam(tendon, dParamLoStop, -dInfinity);
    dJointSetCouplingParam(tendon, dParamHiStop, 1);
    dJointSetCouplingParam(tendon, dParamStopERP, 0);  // what is beyond the stop is not thrown back
    velocity(b[0], {1, 0, 0});
    step(sim, GetParam(), 0.01, 50);
    EXPECT_NEAR(velocity(b[0]).x, 1, 1e-6);
    EXPECT_NEAR(double(dJointGetCouplingForce(tendon)), 0, 1e-9);
    step(sim, GetParam(), 0.01, 150);
    // Plastic: the rate of the sum vanishes, v_0 = 1 - p/1, v_1 = -p/2, so p = 2/3.
    EXPECT_NEAR(velocity(b[0]).x, 1.0 / 3, 2e-2);
    EXPECT_NEAR(velocity(b[1]).x, -1.0 / 3, 2e-2);
    EXPECT_NEAR(double(dJointGetAxisPosition(tendon, 0)), 1, tol(1e-2, 2e-2));  // floats meet a step later
}

// A spring on the coupling of two rotors with factors 1 and -2: w^2 = k (1/I_0 + 4/I_1).
TEST_P(Couplings, spring_has_its_period)
{
    Rotors r({1, 2});
    r.couple({1, -2});
    const double k = 12, w = std::sqrt(k * (1 + 4.0 / 2));
    ASSERT_EQ(dJointSetStopSpring(r.coupling, 0, real(k), 0), 1);
    dBodySetAngularVel(r.body[0], real(0.3), 0, 0);
    const double h = 2e-4, quarter = kPi / 2 / w;
    step(r.sim, GetParam(), h, int(quarter / h));
    EXPECT_NEAR(double(dJointGetAxisRate(r.coupling, 0)), 0, 5e-3);
    EXPECT_NEAR(r.sum(), 0.3 / w, 1e-3);
    // Momentum: factor 0 : factor 1 = 1 : -2.
    EXPECT_NEAR(1 * (r.rate(0) - 0.3) * -2, 2 * r.rate(1), 1e-3);
}

// Two fingers on a palm that floats freely, mimicked: what happens inside changes no momentum.
TEST_P(Couplings, gripper_keeps_momentum)
{
    Sim sim;
    dBodyID palm = sim.box({0, 0, 0}, {1, 1, 1}, 5);
    dJointID mimic = dJointCreateCoupling(sim.world, nullptr), hinge[2];
    for (int i = 0; i < 2; ++i) {
        const double side = i ? -1 : 1;
        dBodyID finger = sim.box({0, 0.7 * side, 1}, {0.1, 0.1, 1}, 1);
        hinge[i] = dJointCreateHinge(sim.world, nullptr);
        dJointAttach(hinge[i], finger, palm);
        dJointSetHingeAnchor(hinge[i], 0, real(0.7 * side), real(0.5));
        dJointSetHingeAxis(hinge[i], 1, 0, 0);
        ASSERT_EQ(dJointSetCouplingAxis(mimic, i, hinge[i], 0, 1), 1);
    }
    dDrive drive = no_drive();
    drive.stiffness = 50, drive.damping = 5, drive.target = real(0.3);
    dJointSetDrive(hinge[0], 0, &drive);
    step(sim, GetParam(), kStep, 600);
    EXPECT_LT(length(momentum(sim)), tol(1e-9, 1e-3));
    EXPECT_LT(length(angular_momentum(sim)), tol(2e-3, 2e-3));
    const double error = GetParam() == Way::kQuick || GetParam() == Way::kSubsteps ? 2e-2 : 1e-4;
    EXPECT_NEAR(double(dJointGetAxisPosition(hinge[0], 0)), 0.3, error);
    EXPECT_NEAR(double(dJointGetAxisPosition(hinge[1], 0)), -0.3, error);
}

// What all joints exert on a body is what moves it: the coupling's share is in the feedback of its members.
TEST(Coupling, feedback_of_members_sums_up)
{
    Rotors r({2, 9});
    r.couple({1, -3});
    dJointFeedback feedback{};
    dJointSetFeedback(r.hinge[1], &feedback);
    for (int i = 0; i < 10; ++i) {
        dBodyAddTorque(r.body[0], 6, 0, 0);
        const double before = spin(r.body[1]).x;
        dWorldStep(r.sim.world, real(kStep));
        EXPECT_NEAR(double(feedback.t1[0]), 9 * (spin(r.body[1]).x - before) / kStep, tol(1e-8, 1e-2));
    }
}

TEST(Coupling, does_not_lose_energy_in_the_exact_stepper)
{
    Rotors r({1, 2, 3});
    r.couple({1, -1, 0.5});
    dBodySetAngularVel(r.body[0], 1, 0, 0), dBodySetAngularVel(r.body[1], 1, 0, 0);
    dWorldStep(r.sim.world, real(kStep));
    const double before = energy(r.sim);
    for (int i = 0; i < 1000; ++i) dWorldStep(r.sim.world, real(kStep));
    EXPECT_NEAR(energy(r.sim), before, tol(1e-4, 1e-3) * before);
}

// Shafts that turn by w h = 0.2 a step. A body turns by 2 atan(w h/2) unless its rotation is finite, so angles
// whose factors differ drift apart by (w h)^3/12 a step, and where velocities correct positions the rates find
// a ratio that makes up for it. That costs or gives a share of the energy once, in the first steps. Afterwards,
// in substeps and with finite rotation, nothing is lost.
TEST_P(Couplings, keep_the_energy_whatever_their_factors)
{
    constexpr double kShare = 0.2, kRate = kShare / kStep;
    const std::vector<double> all[] = {{1, -1, 0.5}, {1, 2, -3}, {1, -1, 1}};
    for (const std::vector<double>& factors : all)
        for (const bool finite : {false, true}) {
            Rotors r({1, 2, 3});
            r.couple(factors);
            for (dBodyID b : r.body) dBodySetFiniteRotationMode(b, finite);
            velocity(r.body[0], {}, {kRate, 0, 0});
            velocity(r.body[1], {}, {-(factors[0] + 0.7 * factors[2]) / factors[1] * kRate, 0, 0});
            velocity(r.body[2], {}, {0.7 * kRate, 0, 0});
            const double start = energy(r.sim);
            step(r.sim, GetParam(), kStep, 200);
            const double settled = energy(r.sim);
            const bool corrects = !finite && GetParam() != Way::kSubsteps && GetParam() != Way::kJointsExact;
            EXPECT_NEAR(settled, start, (corrects ? 2e-5 : tol(1e-12, 1e-4)) * start) << factors[1] << finite;
            step(r.sim, GetParam(), kStep, 200);
            EXPECT_NEAR(energy(r.sim), settled, tol(1e-12, 1e-4) * start) << factors[1] << finite;
        }
}

TEST(Coupling, loses_its_member_and_is_disabled)
{
    Rotors r({1, 1});
    r.couple({1, -1});
    dJointDestroy(r.hinge[1]);
    EXPECT_FALSE(dJointIsEnabled(r.coupling));
    EXPECT_EQ(dJointGetCouplingJoint(r.coupling, 1), nullptr);
    EXPECT_EQ(dJointGetCouplingJoint(r.coupling, 0), r.hinge[0]);
    dBodyAddTorque(r.body[0], 1, 0, 0);
    dWorldStep(r.sim.world, real(kStep));
    EXPECT_GT(r.rate(0), 0);
    dJointDestroy(r.coupling);
    dJointDestroy(r.hinge[0]);
}

TEST(Coupling, rests_while_a_member_is_loose)
{
    Rotors r({1, 1});
    r.couple({1, -1});
    dJointAttach(r.hinge[1], nullptr, nullptr);
    dBodyAddTorque(r.body[0], 1, 0, 0);
    dWorldStep(r.sim.world, real(kStep));
    EXPECT_NEAR(r.rate(0), kStep, 1e-6);
    EXPECT_NEAR(spin(r.body[1]).x, 0, 1e-12);
}

TEST(Coupling, wakes_and_sleeps_as_one_island)
{
    Rotors r({1, 1});
    r.couple({1, -1});
    for (dBodyID b : r.body) dBodySetAutoDisableFlag(b, 1);
    for (int i = 0; i < 400; ++i) dWorldStep(r.sim.world, real(0.01));
    EXPECT_FALSE(dBodyIsEnabled(r.body[0]) || dBodyIsEnabled(r.body[1]));
    dBodyEnable(r.body[0]);
    dBodyAddTorque(r.body[0], 1, 0, 0);
    dWorldStep(r.sim.world, real(0.01));
    EXPECT_TRUE(dBodyIsEnabled(r.body[1]));
    EXPECT_GT(r.rate(1), 1e-3);
}

TEST(Coupling, breaks_at_its_limit)
{
    Rotors r({1, 1});
    r.couple({1, -1});
    dJointSetBreakLimits(r.coupling, 2, 0);
    dBodyAddTorque(r.body[0], 3, 0, 0);
    dWorldStep(r.sim.world, real(kStep));
    EXPECT_FALSE(dJointIsBroken(r.coupling));
    dBodyAddTorque(r.body[0], 5, 0, 0);
    dWorldStep(r.sim.world, real(kStep));
    EXPECT_TRUE(dJointIsBroken(r.coupling));
}

TEST(Coupling, is_in_the_state)
{
    Rotors a({1, 2}), b({1, 2});
    for (Rotors* r : {&a, &b}) r->couple({1, -2}), dJointSetCouplingParam(r->coupling, dParamBounce, 0);
    for (int i = 0; i < 50; ++i) {
        dBodyAddTorque(a.body[0], 3, 0, 0);
        dWorldStep(a.sim.world, real(kStep));
    }
    const std::size_t size = dWorldGetStateSize(a.sim.world);
    std::vector<unsigned char> state(size);
    ASSERT_EQ(dWorldGetState(a.sim.world, state.data(), size), 1);
    ASSERT_EQ(dWorldSetState(b.sim.world, state.data(), size), 1);
    for (int i = 0; i < 50; ++i)
        for (Rotors* r : {&a, &b}) dWorldStep(r->sim.world, real(kStep));
    EXPECT_EQ(hash_state(a.sim), hash_state(b.sim));
    dJointSetCouplingAxis(b.coupling, 1, b.hinge[1], 0, -3);
    Messages messages;
    EXPECT_EQ(dWorldSetState(b.sim.world, state.data(), size), 0);
}

// What rounding leaves in the residual: half an epsilon of sum |J_k v_k| of a row, whose terms, of some m/s, are up to 200
// times the scale, the h g of a step.
constexpr double kPromise = tol(1e-9, 100 * kEpsilon);

// Contacts and bounded rows together with a rigid coupling: the exact solver keeps its promise.
TEST(Coupling, exact_residual_with_contacts)
{
    Sim sim;
    sim.gravity(0, 0, -9.81);
    sim.surface.mu = real(0.7);
    sim.ground();
    dBodyID cart = sim.box({0, 0, 0.5}, {2, 2, 0.2}, 10);
    dJointID hinge[4], couplings[2];
    for (int i = 0; i < 4; ++i) {
        const double x = i % 2 ? -0.8 : 0.8, y = i / 2 ? -1.3 : 1.3;
        dBodyID wheel = sim.sphere({x, y, 0.4}, 0.4, 2);
        hinge[i] = dJointCreateHinge(sim.world, nullptr);
        dJointAttach(hinge[i], wheel, cart);
        dJointSetHingeAnchor(hinge[i], real(x), real(y), real(0.4));
        dJointSetHingeAxis(hinge[i], 0, 1, 0);
    }
    for (int k = 0; k < 2; ++k) {
        couplings[k] = dJointCreateCoupling(sim.world, nullptr);
        dJointSetCouplingAxis(couplings[k], 0, hinge[2 * k], 0, 1);
        dJointSetCouplingAxis(couplings[k], 1, hinge[2 * k + 1], 0, -1);
    }
    dWorldSetStepReportMode(sim.world, 1);
    double worst = 0;
    for (int i = 0; i < 200; ++i) {
        dJointAddHingeTorque(hinge[0], 3), dJointAddHingeTorque(hinge[2], 2);
        sim.step(0.01);
        worst = std::max(worst, sim.report().residual);
    }
    EXPECT_LT(worst, kPromise);
    EXPECT_GT(std::fabs(velocity(cart).x), 0.1);
    EXPECT_LT(std::fabs(double(dJointGetAxisPosition(couplings[0], 0))), tol(1e-4, 1e-3));
}

// An arm that lies down, whose coupling is there twice and whose links touch the ground.
TEST(Coupling, redundant_couplings_keep_the_exact_promise)
{
    Sim sim;
    sim.gravity(0, 0, -9.81);
    dWorldSetContactSpace(sim.world, sim.space);
    sim.ground();
    dWorldSetStepReportMode(sim.world, 1);
    dJointID twins[2] = {dJointCreateCoupling(sim.world, nullptr), dJointCreateCoupling(sim.world, nullptr)};
    dBodyID before = nullptr;
    for (int i = 0; i < 6; ++i) {
        dBodyID link = sim.box({i + 0.5, 0, 0.4}, {0.8, 0.2, 0.2}, 1 + 10 * (i % 2));
        dJointID hinge = dJointCreateHinge(sim.world, nullptr);
        dJointAttach(hinge, link, before);
        dJointSetHingeAnchor(hinge, real(i), 0, real(0.4));
        dJointSetHingeAxis(hinge, 0, 1, 0);
        for (dJointID twin : twins) ASSERT_EQ(dJointSetCouplingAxis(twin, i, hinge, 0, real(i - 2.3)), 1);
        before = link;
    }
    for (int i = 0; i < 200; ++i) {
        ASSERT_EQ(dWorldStep(sim.world, real(0.01)), 1);
        const dWorldStepReport report = sim.report();
        ASSERT_LT(double(report.residual), kPromise) << "step " << i;
        ASSERT_EQ(report.contained_islands, 0) << "step " << i;
    }
    EXPECT_TRUE(finite_state(sim));
}

TEST(Coupling, refuses_bad_input)
{
    Rotors r({1, 1});
    Sim other;
    dJointID stranger = dJointCreateHinge(other.world, nullptr);
    dJointID ball = dJointCreateBall(r.sim.world, nullptr);
    Messages messages;
    EXPECT_EQ(dJointSetCouplingAxis(r.coupling, 8, r.hinge[0], 0, 1), 0);
    EXPECT_EQ(dJointSetCouplingAxis(r.coupling, -1, r.hinge[0], 0, 1), 0);
    EXPECT_EQ(dJointSetCouplingAxis(r.coupling, 0, r.hinge[0], 1, 1), 0);
    EXPECT_EQ(dJointSetCouplingAxis(r.coupling, 0, ball, 0, 1), 0);
    EXPECT_EQ(dJointSetCouplingAxis(r.coupling, 0, stranger, 0, 1), 0);
    EXPECT_EQ(dJointSetCouplingAxis(r.coupling, 0, r.coupling, 0, 1), 0);
    EXPECT_EQ(dJointSetCouplingAxis(r.coupling, 0, r.hinge[0], 0, 0), 0);
    EXPECT_EQ(dJointSetCouplingAxis(r.coupling, 0, r.hinge[0], 0, real(NAN)), 0);
    EXPECT_EQ(dJointSetCouplingAxis(r.hinge[0], 0, r.hinge[0], 0, 1), 0);
    dJointAttach(r.coupling, r.body[0], nullptr);
    EXPECT_EQ(dJointGetNumBodies(r.coupling), 0);
    EXPECT_EQ(dJointGetCouplingJoint(r.coupling, 0), nullptr);
}

// A factor that changes as the world moves is no other structure: states of before and after are taken back with theirs, by clones, too.
TEST(Coupling, whose_factors_change_take_states_with_other_factors)
{
    Rotors r({2, 1});
    r.couple({1, -1});
    r.couple({1, -2});  // from here on they move
    const auto state_of = [](dWorldID world) {
        std::vector<char> bytes(dWorldGetStateSize(world));
        EXPECT_EQ(dWorldGetState(world, bytes.data(), bytes.size()), 1);
        return bytes;
    };
    const auto go_on = [](dWorldID world) {
        dBodyID bodies[2];
        dWorldGetBodies(world, bodies, 2);
        dBodyAddTorque(bodies[0], 1, 0, 0);
        dWorldStep(world, real(kStep));
        return dBodyGetAngularVel(bodies[0])[0];
    };
    const std::vector<char> before = state_of(r.sim.world);
    const dReal first = go_on(r.sim.world);
    r.couple({1, -5});
    const dWorldID clone = dWorldClone(r.sim.world, nullptr, nullptr, 0);
    ASSERT_NE(clone, nullptr);
    for (const dWorldID world : {r.sim.world, clone}) {
        ASSERT_EQ(dWorldSetState(world, before.data(), before.size()), 1);
        EXPECT_EQ(go_on(world), first);
    }
    EXPECT_EQ(dJointGetCouplingFactor(r.coupling, 1), -2);
    dWorldDestroy(clone);
}

}  // namespace
}  // namespace epode::physics
