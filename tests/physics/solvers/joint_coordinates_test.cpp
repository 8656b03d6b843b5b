// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// dWorldSetJointCoordinates: a step of robots in the coordinates of their joints is that in the coordinates of their bodies, in
// velocities, impulses and forces of joints; joints stay closed; a passive tree keeps its energy, a free one its momentum; what stands
// weighs what it weighs; other islands are solved as before, and states carry on with the same bits.
#include "random_tree.h"

namespace epode::physics {
namespace {

// From rest, in a step so short that what is of second order in it is nothing.
TEST(JointCoordinates, step_is_that_of_bodies)
{
    const double h = kShortStep;
    for (std::uint32_t seed = 1; seed <= 40; ++seed)
        for (const bool free : {false, true}) {
            RandomTree joints(seed, true, free), bodies(seed, false, free);
            for (RandomTree* tree : {&joints, &bodies}) {
                dWorldSetCFM(tree->sim_.world, 0), tree->watch_forces();
                dBodyAddForce(tree->bodies_.back(), 1, 1, 1),
                    dBodyAddTorque(tree->bodies_[2], real(0.1), real(0.2), 0);
                ASSERT_TRUE(dWorldStep(tree->sim_.world, real(h)));
            }
            EXPECT_EQ(method_of(joints.sim_.world), dIslandMethodJointCoordinates) << seed << free;
            EXPECT_LT(worst_difference(joints, bodies), tol(1e-9, kGapVelocity)) << seed << free;
            for (std::size_t i = 0; i < joints.joints_.size(); ++i) {
                const dJointFeedback &a = joints.feedbacks_[i], &b = bodies.feedbacks_[i];
                const double scale = 1 + length(vec(b.f1)) + length(vec(b.t1));
                EXPECT_LT(length(vec(a.f1) - vec(b.f1)), tol(1e-5, 1e-2) * scale) << seed << free << i;
                EXPECT_LT(length(vec(a.t1) - vec(b.t1)), tol(1e-5, 1e-2) * scale) << seed << free << i;
                EXPECT_LT(length(vec(a.t2) - vec(b.t2)), tol(1e-5, 1e-2) * scale) << seed << free << i;
            }
        }
}

TEST(JointCoordinates, joints_stay_closed)
{
    for (std::uint32_t seed = 1; seed <= 10; ++seed) {
        RandomTree tree(seed, true, seed % 2 == 0);
        for (int i = 0; i < 500; ++i) dWorldStep(tree.sim_.world, real(0.005));
        EXPECT_EQ(method_of(tree.sim_.world), dIslandMethodJointCoordinates) << seed;
        EXPECT_LT(joint_error(tree.sim_.world), tol(1e-12, 1e-4)) << seed;
    }
}

TEST(JointCoordinates, passive_trees_keep_their_energy)
{
    for (std::uint32_t seed = 1; seed <= 10; ++seed) {
        double swing[2], drift[2];  // of an energy of some 10 J
        for (const int fine : {0, 1}) {
            RandomTree tree(seed, true, false, false);
            const double first = tree.kinetic_and_weight();
            double worst = 0;
            for (int i = 0; i < (fine ? 2000 : 500); ++i) {
                dWorldStep(tree.sim_.world, real(fine ? 0.0005 : 0.002));
                worst = std::max(worst, std::fabs(tree.kinetic_and_weight() - first));
            }
            swing[fine] = worst, drift[fine] = tree.kinetic_and_weight() - first;
        }
        EXPECT_LT(swing[1], 0.5 * swing[0] + tol(1e-9, 1e-2)) << seed;
        EXPECT_LT(std::fabs(drift[1]), 0.5 * std::fabs(swing[0]) + tol(1e-9, 1e-2)) << seed;
        EXPECT_LT(swing[0], 2) << seed;
    }
}

TEST(JointCoordinates, free_trees_keep_their_momentum)
{
    for (std::uint32_t seed = 1; seed <= 10; ++seed) {
        RandomTree tree(seed, true, true);
        dWorldSetGravity(tree.sim_.world, 0, 0, 0);
        dBodySetAngularVel(tree.bodies_[0], 1, 2, 3);
        double mass = 0;
        const auto momenta = [&](V3& linear, V3& angular) {
            linear = angular = {}, mass = 0;
            for (const dBodyID b : tree.bodies_) {
                dMass m;
                dBodyGetMass(b, &m);
                const V3 v = vec(dBodyGetLinearVel(b)), w = vec(dBodyGetAngularVel(b)),
                         x = vec(dBodyGetPosition(b));
                const dReal* const R = dBodyGetRotation(b);
                double local[3], turned[3];
                for (int k = 0; k < 3; ++k)
                    local[k] = double(R[k]) * w.x + double(R[4 + k]) * w.y + double(R[8 + k]) * w.z;
                for (int k = 0; k < 3; ++k) {
                    turned[k] = 0;
                    for (int l = 0; l < 3; ++l) turned[k] += double(m.I[4 * k + l]) * local[l];
                }
                const auto row = [&](int k) {
                    return double(R[4 * k]) * turned[0] + double(R[4 * k + 1]) * turned[1] +
                           double(R[4 * k + 2]) * turned[2];
                };
                linear = linear + double(m.mass) * v, mass += double(m.mass);
                angular = angular + cross(x, double(m.mass) * v) + V3{row(0), row(1), row(2)};
            }
        };
        V3 p0, l0, p1, l1;
        momenta(p0, l0);
        for (int i = 0; i < 500; ++i) dWorldStep(tree.sim_.world, real(0.002));
        momenta(p1, l1);
        EXPECT_EQ(method_of(tree.sim_.world), dIslandMethodJointCoordinates);
        EXPECT_LT(length(p1 - p0), tol(1e-9, 1e-3) * mass) << seed;
        EXPECT_LT(length(l1 - l0), tol(1e-4, 0.05) * (1 + length(l0))) << seed;
    }
}

// Moments A, A, C, spin 100 rad/s, so up to 1.7 rad in a step. What is kept is E - (h/2) m g v_z, since weight acts at the beginning of a step.
TEST(JointCoordinates, heavy_tops_keep_their_energy)
{
    constexpr double kArm = 0.5, kSpin = 100, kTilt = 1;
    for (const double h : {1 / 60., 1 / 240., 1e-3}) {
        Sim sim;
        dWorldUseDefaults(sim.world, dDefaultsRobot);
        dWorldSetGravity(sim.world, 0, 0, real(-kGravity));
        const V3 axis{std::sin(kTilt), 0, std::cos(kTilt)};
        const dBodyID top = dBodyCreate(sim.world);
        dMass mass;
        dMassSetParameters(&mass, 1, 0, 0, 0, real(0.05), real(0.05), real(0.02), 0, 0, 0);
        dBodySetMass(top, &mass);
        dMatrix3 R;
        dRFromAxisAndAngle(R, 0, 1, 0, real(kTilt));
        dBodySetRotation(top, R);
        dBodySetPosition(top, real(kArm * axis.x), 0, real(kArm * axis.z));
        const dJointID ball = dJointCreateBall(sim.world, nullptr);
        dJointAttach(ball, top, nullptr), dJointSetBallAnchor(ball, 0, 0, 0);
        const V3 w = kSpin * axis;
        dBodySetAngularVel(top, real(w.x), real(w.y), real(w.z));
        const auto energy = [&] {
            const V3 v = vec(dBodyGetLinearVel(top)), spin = vec(dBodyGetAngularVel(top));
            const dReal* const r = dBodyGetRotation(top);
            const double along = dot(spin, {double(r[2]), double(r[6]), double(r[10])});
            return 0.5 * (dot(v, v) + 0.05 * dot(spin, spin) - 0.03 * along * along) +
                   kGravity * (double(dBodyGetPosition(top)[2]) - h / 2 * v.z);
        };
        const double first = energy();
        double worst = 0;
        for (int i = 0; i < int(3 / h); ++i) {
            dWorldStep(sim.world, real(h));
            worst = std::max(worst, std::fabs(energy() - first));
        }
        EXPECT_LT(worst, (h > 0.01 ? 0.12 : 0.02 + tol(0, 0.1)) * h * first) << h;
    }
}

// Five light links swing a load from level. As with bodies, or better, whatever the load is.
TEST(JointCoordinates, chains_with_loads_keep_what_they_keep_with_bodies)
{
    constexpr double kLink = 0.2, kSeconds = 6;
    for (const double h : {1 / 60., 1 / 240.})
        for (const double load : {10., 100., 1000.}) {
            double kept[2];
            for (const int in_joints : {0, 1}) {
                Sim sim;
                dWorldUseDefaults(sim.world, dDefaultsRobot);
                dWorldSetJointCoordinates(sim.world, in_joints);
                dWorldSetGravity(sim.world, 0, 0, real(-kGravity));
                std::vector<dBodyID> bodies;
                double scale = 0;
                for (int i = 0; i < 6; ++i) {
                    const double side = i < 5 ? 0.05 : 0.3, length = i < 5 ? kLink : 0.3;
                    const double x = kLink * i + length / 2, m = i < 5 ? 1 : load;
                    const dBodyID body = dBodyCreate(sim.world);
                    dMass mass;
                    dMassSetBoxTotal(&mass, real(m), real(length), real(side), real(side));
                    dBodySetMass(body, &mass), dBodySetPosition(body, real(x), 0, 0);
                    const dJointID hinge = dJointCreateHinge(sim.world, nullptr);
                    dJointAttach(hinge, body, i > 0 ? bodies.back() : nullptr);
                    dJointSetHingeAnchor(hinge, real(kLink * i), 0, 0), dJointSetHingeAxis(hinge, 0, 1, 0);
                    bodies.push_back(body), scale += m * kGravity * x;
                }
                const auto energy = [&] {
                    double sum = 0;
                    for (const dBodyID b : bodies) {
                        dMass mass;
                        dBodyGetMass(b, &mass);
                        const V3 v = vec(dBodyGetLinearVel(b)), w = vec(dBodyGetAngularVel(b));
                        sum += 0.5 * double(mass.mass) * dot(v, v) + 0.5 * double(mass.I[5]) * dot(w, w) +
                               double(mass.mass) * kGravity * double(dBodyGetPosition(b)[2]);
                    }
                    return sum;
                };
                double sum = 0;
                const int steps = int(kSeconds / h);
                for (int i = 0; i < steps; ++i) {
                    dWorldStep(sim.world, real(h));
                    if (i >= steps * 3 / 4) sum += energy() / (steps - steps * 3 / 4);
                }
                kept[in_joints] = 1 + sum / scale;
            }
            EXPECT_GT(kept[1], kept[0] - 0.02) << h << ' ' << load;
            EXPECT_LT(kept[1], 1.02) << h << ' ' << load;
        }
}

// A table on four legs with hinges on stops: the ground bears its weight, and nothing moves.
TEST(JointCoordinates, what_stands_weighs_what_it_weighs)
{
    Sim sim;
    dWorldUseDefaults(sim.world, dDefaultsRobot);
    dWorldSetJointCoordinates(sim.world, 1);
    dWorldSetGravity(sim.world, 0, 0, real(-kGravity));
    dWorldSetStepReportMode(sim.world, 1);
    dWorldSetContactSpace(sim.world, sim.space);
    sim.ground();
    const dBodyID plate = sim.box({0, 0, 0.55}, {1, 1, 0.1}, 4);
    double mass = 4;
    std::vector<dJointFeedback> feedbacks(4);
    for (int i = 0; i < 4; ++i) {
        const V3 at{i % 2 == 0 ? 0.4 : -0.4, i / 2 == 0 ? 0.4 : -0.4, 0.25};
        const dBodyID leg = sim.sphere(at - V3{0, 0, 0.2}, 0.05, 0.5);
        mass += 0.5;
        const dJointID hinge = dJointCreateHinge(sim.world, nullptr);
        dJointAttach(hinge, leg, plate);
        dJointSetHingeAnchor(hinge, real(at.x), real(at.y), real(0.5)), dJointSetHingeAxis(hinge, 1, 0, 0);
        dJointSetHingeParam(hinge, dParamLoStop, 0), dJointSetHingeParam(hinge, dParamHiStop, 0);
        dJointSetHingeParam(hinge, dParamHiStop, real(1e-9));
        dJointSetFeedback(hinge, &feedbacks[std::size_t(i)]);
    }
    for (int i = 0; i < 400; ++i) dWorldStep(sim.world, real(0.005));
    EXPECT_EQ(method_of(sim.world), dIslandMethodJointCoordinates);
    double carried = 0;
    for (const dJointFeedback& f : feedbacks) carried -= double(f.f2[2]);
    EXPECT_NEAR(carried, 4 * -kGravity, tol(1e-6, 1e-3) * mass * kGravity);
    EXPECT_LT(length(vec(dBodyGetLinearVel(plate))),
              tol(1e-7, 1.1e-5 * mass * kGravity / 4));  // the default CFM
    EXPECT_NEAR(double(dBodyGetPosition(plate)[2]), 0.55, 1e-3);
}

TEST(JointCoordinates, states_carry_on_with_the_same_bits)
{
    RandomTree tree(5, true, true);
    for (int i = 0; i < 50; ++i) dWorldStep(tree.sim_.world, real(0.002));
    const dsizeint size = dWorldGetStateSize(tree.sim_.world);
    std::vector<char> state(size);
    ASSERT_TRUE(dWorldGetState(tree.sim_.world, state.data(), size));
    std::vector<double> seen[2];
    for (std::vector<double>& to : seen) {
        ASSERT_TRUE(dWorldSetState(tree.sim_.world, state.data(), size));
        for (int i = 0; i < 100; ++i) dWorldStep(tree.sim_.world, real(0.002));
        for (const dBodyID b : tree.bodies_)
            for (int k = 0; k < 3; ++k)
                to.push_back(double(dBodyGetPosition(b)[k])), to.push_back(double(dBodyGetAngularVel(b)[k]));
    }
    EXPECT_EQ(seen[0], seen[1]);
}

TEST(JointCoordinates, mode_is_off_at_first_on_in_presets_and_refuses_others)
{
    Sim sim;
    EXPECT_EQ(dWorldGetJointCoordinates(sim.world), 0);
    dWorldSetJointCoordinates(sim.world, 1);
    EXPECT_EQ(dWorldGetJointCoordinates(sim.world), 1);
    dWorldSetJointCoordinates(sim.world, 2);
    EXPECT_EQ(dWorldGetJointCoordinates(sim.world), 1);
    dWorldUseDefaults(sim.world, dDefaultsOde);
    EXPECT_EQ(dWorldGetJointCoordinates(sim.world), 0);
    dWorldUseDefaults(sim.world, dDefaultsGame);
    EXPECT_EQ(dWorldGetJointCoordinates(sim.world), 1);
    dWorldUseDefaults(sim.world, dDefaultsRobot);
    EXPECT_EQ(dWorldGetJointCoordinates(sim.world), 1);
}

}  // namespace
}  // namespace epode::physics
