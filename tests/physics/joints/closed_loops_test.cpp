// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Closed loops and redundant joints as ordinary cases of dWorldStep: four-bar windows that pass the flat
// position, where their freedom rises from 1 to N + 1; Bricard's loop, which has one freedom where counting
// rows gives none; a door on three hinges; a table whose four legs share one load, in whatever order it was
// built; a slider-crank through its dead centres. In every step the natural residual is at most 1e-9, in
// every case the loops stay closed and the energy is what it was.
#include <algorithm>

#include "rig.h"

namespace epode::physics {
namespace {

constexpr double kResidual = tol(1e-9, 1e-4);

struct Loops : testing::Test {
    Sim sim{Stepper::kExact};
    Messages messages;
    double worst = 0;

    Loops()
    {
        sim.gravity(0, 0, -9.81);
        dWorldSetStepReportMode(sim.world, 1);
    }
    void advance(double h)
    {
        ASSERT_EQ(sim.advance(h), 1);
        const dWorldStepReport r = sim.report();
        ASSERT_EQ(r.contained_islands, 0);
        worst = std::max(worst, r.residual);
    }
    void judge()
    {
        EXPECT_LE(worst, kResidual);
        EXPECT_TRUE(finite_state(sim));
        EXPECT_EQ(messages.count(), 0) << messages.last();
    }
    // A thin rod from a to b; its own axis is x of the body.
    dBodyID rod(V3 a, V3 b, double mass = 1)
    {
        const V3 along = b - a;
        const double L = length(along), across = mass * L * L / 12;
        dBodyID body = sim.body(0.5 * (a + b), mass, across);
        dMass m;
        dMassSetParameters(&m, real(mass), 0, 0, 0, real(across / 100), real(across), real(across), 0, 0, 0);
        dBodySetMass(body, &m);
        dMatrix3 R;
        const V3 other = std::fabs(along.y) > 0.9 * L ? V3{1, 0, 0} : V3{0, 1, 0};
        const V3 q = cross(along, other);
        dRFrom2Axes(R, real(along.x), real(along.y), real(along.z), real(q.x), real(q.y), real(q.z));
        dBodySetRotation(body, R);
        return body;
    }
    dJointID hinge(dBodyID a, dBodyID b, V3 at, V3 axis)
    {
        dJointID j = dJointCreateHinge(sim.world, nullptr);
        dJointAttach(j, a, b);
        dJointSetHingeAnchor(j, real(at.x), real(at.y), real(at.z));
        dJointSetHingeAxis(j, real(axis.x), real(axis.y), real(axis.z));
        hinges.push_back(j);
        return j;
    }
    double gap() const
    {
        double largest = 0;
        for (dJointID j : hinges) {
            dVector3 a, b;
            dJointGetHingeAnchor(j, a);
            dJointGetHingeAnchor2(j, b);
            largest = std::max(largest, length(vec(a) - vec(b)));
        }
        return largest;
    }
    std::vector<dJointID> hinges;
};

V3 end_of(dBodyID rod, double x)
{
    dVector3 p;
    dBodyGetRelPointPos(rod, real(x), 0, 0, p);
    return vec(p);
}

// N windows of links of 1 m and 1 kg in the plane y = 0, upright, the tops moving at 1 m/s.
struct FourBars : Loops {
    std::vector<dBodyID> cranks;

    void build(int windows)
    {
        dBodyID before = nullptr;
        for (int i = 0; i <= windows; ++i) {
            const V3 foot{double(i), 0, 0}, top{double(i), 0, 1}, axis{0, 1, 0};
            dBodyID crank = rod(foot, top);
            velocity(crank, {0.5, 0, 0}, {0, 1, 0});
            hinge(crank, nullptr, foot, axis);
            cranks.push_back(crank);
            if (before) hinge(before, crank, top, axis);
            if (i == windows) break;
            dBodyID coupler = rod(top, {i + 1.0, 0, 1});
            velocity(coupler, {1, 0, 0});
            hinge(crank, coupler, top, axis);
            before = coupler;
        }
    }
    // How far the cranks are from parallel.
    double skew() const
    {
        double largest = 0;
        const V3 first = end_of(cranks[0], 0.5) - end_of(cranks[0], -0.5);
        for (dBodyID c : cranks)
            largest = std::max(largest, length(end_of(c, 0.5) - end_of(c, -0.5) - first));
        return largest;
    }
};

TEST_F(FourBars, pass_the_flat_position_again_and_again)
{
    for (int windows : {2, 10}) {
        build(windows);
        const double E0 = energy(sim);
        const double h = windows == 2 ? 0.001 : 0.002;
        int passed = 0;
        double before = 1, drift = 0, apart = 0, askew = 0;
        for (int i = 0, n = int((windows == 2 ? 10 : 4) / h); i < n; ++i) {
            advance(h);
            const double height = end_of(cranks[0], 0.5).z;
            passed += (height > 0) != (before > 0);
            before = height;
            drift = std::max(drift, std::fabs(energy(sim) - E0));
            apart = std::max(apart, gap());
            askew = std::max(askew, skew());
        }
        EXPECT_GE(passed, windows == 2 ? 8 : 3);
        EXPECT_LT(drift / E0, tol(0.01, 0.05)) << windows;
        EXPECT_LT(apart, tol(5e-4, 5e-3)) << windows;
        EXPECT_LT(askew, tol(1e-5, 1e-2)) << "left the branch of parallelograms, " << windows;
        hinges.clear(), cranks.clear();
        for (dBodyID b : sim.bodies) dBodyDestroy(b);
        sim.bodies.clear();
    }
    judge();
}

// Bricard's trihedral loop: six edges of a cube, x y z -x -y -z, with hinges along the edge that is missing
// at each corner; the first edge is the ground. It can only move where it is exactly closed: a gap of 1e-5 is
// resisted by the thirtieth row, so that rows as hard as ODE's default, CFM = 1e-10, brake the motion (51 of
// its joules in these 10 s). A softness of 1e-6 lets the gap be.
TEST_F(Loops, bricard_moves_although_counting_rows_forbids_it)
{
    dWorldSetCFM(sim.world, real(1e-6));
    const V3 corner[6] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {0, 1, 1}, {0, 0, 1}};
    const V3 axis[6] = {{0, 1, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 0}};
    dBodyID link[6] = {};
    for (int k = 1; k < 6; ++k) link[k] = rod(corner[k], corner[(k + 1) % 6]);
    for (int k = 0; k < 6; ++k) {
        dBodyID a = link[k], b = link[(k + 5) % 6];
        a ? hinge(a, b, corner[k], axis[k]) : hinge(b, a, corner[k], axis[k]);
    }
    const double E0 = energy(sim), h = 0.001;
    double drift = 0, apart = 0, fastest = 0;
    for (int i = 0; i < 10000; ++i) {
        advance(h);
        drift = std::max(drift, std::fabs(energy(sim) - E0));
        apart = std::max(apart, gap());
        fastest = std::max(fastest, length(velocity(link[3])));
    }
    EXPECT_GT(fastest, 5) << "it falls and swings";
    EXPECT_LT(drift, tol(1, 10)) << "of kinetic energies of up to 50 J";
    EXPECT_LT(apart, tol(2e-4, 2e-3));
    judge();
}

struct Wrench {
    V3 force, torque;
};

// Force and torque of all hinges on the door, about its centre.
Wrench sum(const std::vector<dJointFeedback>& feedback)
{
    Wrench w;
    for (const dJointFeedback& f : feedback) {
        w.force = w.force + vec(f.f1);
        w.torque = w.torque + vec(f.t1);
    }
    return w;
}

TEST_F(Loops, a_door_on_three_hinges_moves_as_on_one)
{
    Sim one{Stepper::kExact};
    one.gravity(0, 0, -9.81);
    std::vector<dJointFeedback> three(3), single(1);
    const auto hang = [&](Sim& s, std::vector<double> heights, std::vector<dJointFeedback>& feedback) {
        dBodyID door = s.body({0.5, 0, 1}, 20, 3);
        velocity(door, {0, 0.5, 0}, {0, 0, 1});
        for (std::size_t k = 0; k < heights.size(); ++k) {
            dJointID j = dJointCreateHinge(s.world, nullptr);
            dJointAttach(j, door, nullptr);
            dJointSetHingeAnchor(j, 0, 0, real(heights[k]));
            dJointSetHingeAxis(j, 0, 0, 1);
            dJointSetFeedback(j, &feedback[k]);
            if (&s == &sim) hinges.push_back(j);
        }
        return door;
    };
    dBodyID a = hang(sim, {0.2, 1.0, 1.8}, three), b = hang(one, {1.0}, single);
    const double h = 0.002;
    double force = 0, torque = 0, way = 0, apart = 0;  // the first two as shares of the force
    for (int i = 0; i < 2000; ++i) {
        advance(h);
        ASSERT_EQ(one.advance(h), 1);
        const Wrench x = sum(three), y = sum(single);
        force = std::max(force, length(x.force - y.force) / length(y.force));
        torque = std::max(torque, length(x.torque - y.torque) / length(y.force));
        way = std::max(way, length(position(a) - position(b)));
        apart = std::max(apart, gap());
    }
    // A float's rounding of an anchor, corrected in a step of 2 ms, is a force of some newtons.
    EXPECT_LT(force, tol(1e-5, 0.2));
    EXPECT_LT(torque, tol(1e-5, 0.2));
    EXPECT_LT(way, tol(1e-8, 1e-3));
    EXPECT_LT(apart, tol(1e-5, 1e-3));
    EXPECT_NEAR(spin(a).z, 1, tol(1e-4, 1e-2)) << "nothing brakes it";
    EXPECT_NEAR(sum(three).force.z, 20 * 9.81, tol(1e-3, 1)) << "they carry its weight";
    judge();
}

// A top on four legs; leg k stands on one contact. Built in the order given.
std::vector<double> leg_forces(const std::vector<int>& order, bool legs_first, double cfm)
{
    Sim s{Stepper::kExact};
    s.gravity(0, 0, -9.81);
    dWorldSetCFM(s.world, real(cfm));
    const V3 foot[4] = {{0.5, 0.4, 0}, {-0.5, 0.4, 0}, {-0.5, -0.4, 0}, {0.5, -0.4, 0}};
    dBodyID top = nullptr, leg[4] = {};
    const auto make_top = [&] { top = s.body({0.05, 0.03, 0.8}, 10, 1.5); };
    if (!legs_first) make_top();
    for (int k : order) leg[k] = s.body(foot[k] + V3{0, 0, 0.4}, 0.5, 0.03);
    if (legs_first) make_top();
    for (int k : order) {
        dJointID j = dJointCreateFixed(s.world, nullptr);
        dJointAttach(j, leg[k], top);
        dJointSetFixed(j);
    }
    std::vector<dJointFeedback> feedback(4);
    std::vector<double> force(4);
    for (int i = 0; i < 20; ++i) {
        dJointGroupEmpty(s.contacts);
        for (int k : order) {
            dContact c = make_contact(foot[k], {0, 0, 1}, 0);
            c.surface.mu = real(0.5);
            dJointID j = dJointCreateContact(s.world, s.contacts, &c);
            dJointAttach(j, leg[k], nullptr);
            dJointSetFeedback(j, &feedback[std::size_t(k)]);
        }
        EXPECT_EQ(s.advance(0.01), 1);
        for (std::size_t k = 0; k < 4; ++k) force[k] = double(feedback[k].f1[2]);
    }
    return force;
}

// Rounding of the load moves the split by eps d/C, d being 3/kg here and C = CFM/h.
TEST_F(Loops, the_legs_of_a_table_share_the_load_in_one_way)
{
    for (double cfm : {1e-10, 1e-6}) {
        const std::vector<double> first = leg_forces({0, 1, 2, 3}, false, cfm);
        double worst_difference = 0;
        for (const std::vector<int>& order :
             {std::vector<int>{3, 2, 1, 0}, {2, 0, 3, 1}, {1, 3, 0, 2}, {0, 2, 1, 3}})
            for (bool legs_first : {false, true}) {
                const std::vector<double> other = leg_forces(order, legs_first, cfm);
                for (std::size_t k = 0; k < 4; ++k)
                    worst_difference = std::max(worst_difference, std::fabs(other[k] - first[k]));
            }
        EXPECT_LT(worst_difference / first[0], cfm > 1e-8 ? tol(1e-10, 1e-2) : tol(1e-6, 1)) << cfm;
        EXPECT_NEAR(first[0] + first[1] + first[2] + first[3], 12 * 9.81, tol(1e-3, 0.1));
        EXPECT_GT(first[0] - first[2], 5) << "the nearest leg carries most";
    }
}

// Crank r, rod l, piston on a slider along x. Nothing drives it: it turns past both dead centres by its
// momentum.
TEST_F(Loops, a_slider_crank_passes_its_dead_centres)
{
    sim.gravity(0, 0, 0);
    const double r = 0.3, l = 1, h = 0.001;
    dBodyID crank = rod({0, 0, 0}, {r, 0, 0}, 2), coupler = rod({r, 0, 0}, {r + l, 0, 0});
    dBodyID piston = sim.body({r + l, 0, 0}, 0.5, 0.01);
    const V3 axis{0, 1, 0};
    dJointID drive = hinge(crank, nullptr, {0, 0, 0}, axis);
    hinge(crank, coupler, {r, 0, 0}, axis);
    hinge(coupler, piston, {r + l, 0, 0}, axis);
    dJointID slider = dJointCreateSlider(sim.world, nullptr);
    dJointAttach(slider, piston, nullptr);
    dJointSetSliderAxis(slider, 1, 0, 0);
    // At the dead centre the piston rests and the rod turns the other way.
    const double w = 5;
    velocity(crank, {0, 0, -w * r / 2}, {0, w, 0});
    velocity(coupler, {0, 0, -w * r / 2}, {0, -w * r / l, 0});
    const double E0 = energy(sim);
    double drift = 0, apart = 0, off = 0, angle = 0, turns = 0;
    for (int i = 0; i < 10000; ++i) {
        advance(h);
        const double now = double(dJointGetHingeAngle(drive));
        turns += std::fabs(std::remainder(now - angle, 2 * kPi)) / (2 * kPi);
        angle = now;
        const double z = r * std::sin(now);
        off = std::max(off, std::fabs(position(piston).x - (r * std::cos(now) + std::sqrt(l * l - z * z))));
        drift = std::max(drift, std::fabs(energy(sim) - E0) / E0);
        apart = std::max(apart, gap());
    }
    EXPECT_GT(turns, 6);
    EXPECT_LT(drift, tol(1e-3, 1e-2));
    EXPECT_LT(apart, tol(3e-5, 1e-3));
    EXPECT_LT(off, tol(5e-5, 2e-3));
    judge();
}

}  // namespace
}  // namespace epode::physics
