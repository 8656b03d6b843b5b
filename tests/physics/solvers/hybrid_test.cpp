// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Hybrid steps: which island is solved how, and substeps whose joints are solved together - heavy loads on
// light chains, alone and in a pile; motors, stops and loops; momentum; friction; the same bits on any number
// of threads.
#include <algorithm>
#include <memory>

#include "scenes.h"

namespace epode::physics {
namespace {

constexpr double kH = 1.0 / 60;

// A world that is stepped in the hybrid way, with contacts of its own or of ODE's way.
class Hybrid : public Sim {
  public:
    explicit Hybrid(int way = dStepperHybrid, bool world_contacts = true)
    {
        gravity(0, 0, -9.81);
        if (world_contacts) dWorldSetContactSpace(world, space);
        dWorldSetHybridStepper(world, way);
        dWorldSetStepReportMode(world, 1);
    }

    void run(int count, double h = kH)
    {
        for (int i = 0; i < count; ++i) {
            if (!dWorldGetContactSpace(world)) collide();
            ASSERT_EQ(dWorldStepHybrid(world, real(h)), 1);
        }
    }

    // Of the island of this body in the last step.
    int method_of(dBodyID body) const
    {
        dIslandStepReport island{};
        island.struct_size = sizeof island;
        for (int i = 0; i < report().islands; ++i) {
            EXPECT_EQ(dWorldGetIslandStepReport(world, i, &island), 1);
            if (island.body == body) return island.method;
        }
        return -1;
    }
};

// How far a ball joint's anchors are apart.
double gap(dJointID ball)
{
    dVector3 a, b;
    dJointGetBallAnchor(ball, a);
    dJointGetBallAnchor2(ball, b);
    return length(vec(a) - vec(b));
}

struct Chain {
    std::vector<dBodyID> links;
    std::vector<dJointID> joints;
    double worst = 0;

    void look()
    {
        for (dJointID j : joints) worst = std::max(worst, gap(j));
    }
};

constexpr double kLink = 0.25;

// Links of 1 kg from `top` down, the last one heavier by `ratio`.
Chain hang_chain(Sim& sim, V3 top, int count, double ratio)
{
    Chain chain;
    for (int i = 0; i < count; ++i) {
        const V3 at = top - V3{0, 0, (i + 0.5) * kLink};
        const dBodyID link = sim.box(at, {0.08, 0.08, kLink}, i == count - 1 ? ratio : 1);
        const dJointID j = dJointCreateBall(sim.world, nullptr);
        dJointAttach(j, link, i ? chain.links.back() : nullptr);
        dJointSetBallAnchor(j, real(top.x), real(top.y), real(top.z - i * kLink));
        chain.links.push_back(link);
        chain.joints.push_back(j);
    }
    return chain;
}

double worst_gap_of_swing(int stepper)
{
    Hybrid sim(stepper);
    Chain chain = hang_chain(sim, {0, 0, 5}, 12, 100);
    velocity(chain.links.back(), {0.5, 0.3, 0});
    for (int i = 0; i < 600; ++i) {
        sim.run(1);
        chain.look();
    }
    return chain.worst / kLink;
}

TEST(Hybrid, a_load_of_a_hundred_hangs_within_a_hundredth_of_a_link)
{
    EXPECT_LT(worst_gap_of_swing(dStepperSubstepsExactJoints), 0.01);
    EXPECT_LT(worst_gap_of_swing(dStepperHybrid), 0.01);
    EXPECT_GT(worst_gap_of_swing(dStepperSubsteps), 0.05);  // what it is good for
}

TEST(Hybrid, a_load_of_a_hundred_hangs_within_a_hundredth_of_a_link_in_a_pile)
{
    Hybrid sim(dStepperSubstepsExactJoints);
    sim.ground();
    Chain chain = hang_chain(sim, {0, 0, 3.3}, 12, 100);
    for (int i = 0; i < 120; ++i)
        sim.box({0.45 * (i % 5 - 2) + 0.02, 0.45 * (i / 5 % 5 - 2) + 0.01, 0.3 + 0.5 * (i / 25)},
                {0.3, 0.35, 0.4}, 2);
    velocity(chain.links.back(), {1, 0.5, 0});
    bool touched = false;
    for (int i = 0; i < 300; ++i) {
        sim.run(1);
        chain.look();
        std::vector<dWorldContact> contacts(std::size_t(dWorldGetContacts(sim.world, nullptr, 0)));
        dWorldGetContacts(sim.world, contacts.data(), int(contacts.size()));
        for (const dWorldContact& c : contacts)
            for (dBodyID link : chain.links)
                touched = touched || (dGeomGetBody(c.g1) == link && c.normal_force > 0) ||
                          (c.g2 && dGeomGetBody(c.g2) == link && c.normal_force > 0);
    }
    EXPECT_TRUE(touched);
    EXPECT_LT(chain.worst / kLink, 0.01);
    EXPECT_TRUE(finite_state(sim));
    EXPECT_LT(sim.report().penetration, 0.05);
}

// ---- what the joints' block must get right

TEST(Hybrid, joints_carry_what_hangs_on_them)
{
    Hybrid sim(dStepperSubstepsExactJoints);
    Chain chain = hang_chain(sim, {0, 0, 5}, 6, 50);
    dJointFeedback force[6];
    for (std::size_t i = 0; i < 6; ++i) dJointSetFeedback(chain.joints[i], &force[i]);
    sim.run(240);
    for (std::size_t i = 0; i < 6; ++i)
        EXPECT_NEAR(double(force[i].f1[2]), 9.81 * (50 + 5.0 - double(i)), tol(0.01, 0.5)) << i;
}

// A hinge with a motor of so much torque, an arm of 1 kg on it, held against its weight.
dJointID motor_arm(Sim& sim, double torque)
{
    const dBodyID arm = sim.body({0.5, 0, 1}, 1, 0.05);
    const dJointID hinge = dJointCreateHinge(sim.world, nullptr);
    dJointAttach(hinge, arm, nullptr);
    dJointSetHingeAnchor(hinge, 0, 0, 1);
    dJointSetHingeAxis(hinge, 0, 1, 0);
    dJointSetHingeParam(hinge, dParamFMax, real(torque));
    dJointSetHingeParam(hinge, dParamVel, 0);
    return hinge;
}

TEST(Hybrid, motors_hold_up_to_their_torque_and_stops_stop)
{
    Hybrid sim(dStepperSubstepsExactJoints);
    const dJointID strong = motor_arm(sim, 6), weak = motor_arm(sim, 2), stopped = motor_arm(sim, 0);
    dJointSetHingeParam(stopped, dParamLoStop, real(-0.5));
    dJointSetHingeParam(stopped, dParamHiStop, real(0.5));
    // The weight's torque is 4.905 Nm. With 2 Nm against it the arm starts with (4.905 - 2)/(0.25 + 0.05).
    sim.run(1);
    EXPECT_NEAR(std::fabs(double(dJointGetHingeAngleRate(weak))), 2.905 / 0.3 * kH, 0.01 * 2.905 / 0.3 * kH);
    sim.run(299);
    EXPECT_NEAR(double(dJointGetHingeAngle(strong)), 0, tol(1e-6, 1e-3));
    EXPECT_NEAR(std::fabs(double(dJointGetHingeAngle(stopped))), 0.5, 0.01);
    EXPECT_GT(std::fabs(double(dJointGetHingeAngle(weak))), 0.5);
}

TEST(Hybrid, closed_loops_that_repeat_their_rows_stay_closed)
{
    for (const double cfm : {0.0, 1e-10}) {
        Hybrid sim(dStepperSubstepsExactJoints);
        dWorldSetCFM(sim.world, real(cfm));
        // A four-bar of hinges with parallel axes: 20 rows, of which some say the same.
        const V3 corner[4] = {{0, 0, 1}, {0, 0, 2}, {1, 0, 2}, {1, 0, 1}};
        std::vector<dBodyID> bars;
        for (int i = 0; i < 3; ++i)
            bars.push_back(sim.body(0.5 * (corner[i] + corner[i + 1]), 1 + 9.0 * i, 0.1));
        std::vector<dJointID> hinges;
        for (std::size_t i = 0; i < 4; ++i) {
            const dJointID h = dJointCreateHinge(sim.world, nullptr);
            dJointAttach(h, i < 3 ? bars[i] : bars[2], i > 0 && i < 3 ? bars[i - 1] : nullptr);
            dJointSetHingeAnchor(h, real(corner[i].x), 0, real(corner[i].z));
            dJointSetHingeAxis(h, 0, 1, 0);
            hinges.push_back(h);
        }
        velocity(bars[1], {1, 0, 0});
        double worst = 0;
        for (int i = 0; i < 300; ++i) {
            sim.run(1);
            for (dJointID h : hinges) {
                dVector3 a, b;
                dJointGetHingeAnchor(h, a);
                dJointGetHingeAnchor2(h, b);
                worst = std::max(worst, length(vec(a) - vec(b)));
            }
        }
        EXPECT_TRUE(finite_state(sim)) << cfm;
        EXPECT_LT(worst, 0.01) << cfm;
    }
}

// A tree of balls: a trunk and four arms of three.
std::vector<dBodyID> spider(Sim& sim, V3 at, double size)
{
    std::vector<dBodyID> bodies{sim.sphere(at, 0.4 * size, 10)};
    for (int arm = 0; arm < 4; ++arm) {
        dBodyID previous = bodies[0];
        const V3 along{arm == 0 ? 1.0 : arm == 1 ? -1.0 : 0, arm == 2 ? 1.0 : arm == 3 ? -1.0 : 0, 0};
        for (int k = 0; k < 3; ++k) {
            const V3 from = at + (0.5 + 0.5 * k) * size * along;
            const dBodyID link = sim.sphere(from + 0.25 * size * along, 0.15 * size, 0.3);
            const dJointID j = dJointCreateBall(sim.world, nullptr);
            dJointAttach(j, previous, link);
            dJointSetBallAnchor(j, real(from.x), real(from.y), real(from.z));
            bodies.push_back(link);
            previous = link;
        }
    }
    return bodies;
}

// What of the angular momentum, as a share, is lost until two machines meet in flight, and in all.
struct MomentumLoss {
    double before = 0, in_all = 0;
    double linear = 0;  // kg m/s
};

MomentumLoss collide_machines(int per_step, double aside)
{
    Hybrid sim(dStepperSubstepsExactJoints);
    sim.gravity(0, 0, 0);
    const auto one = spider(sim, {0, 0, 0}, 1), two = spider(sim, {3.2, 0.3 + aside, 0.1}, 1);
    velocity(one[0], {2, 0.1, 0}, {0.5, 1, 0.3});
    velocity(two[3], {-2, 0, 0.4}, {0, 1, 2});
    const V3 p = momentum(sim), l = angular_momentum(sim);
    const auto lost = [&] { return length(angular_momentum(sim) - l) / length(l); };
    MomentumLoss loss;
    bool met = false;
    for (int i = 0; i < 150 * per_step; ++i) {
        sim.run(1, kH / per_step);
        met = met || dWorldGetContacts(sim.world, nullptr, 0) > 0;
        if (!met) loss.before = std::max(loss.before, lost());
    }
    EXPECT_TRUE(met);
    EXPECT_LT(sim.report().joint_error, 2e-3);
    loss.in_all = lost(), loss.linear = length(momentum(sim) - p);
    return loss;
}

// A manifold keeps the arms of the step's beginning while its bodies slide past each other in the
// substeps: what that costs is of first order in the step. Each step size has collisions of its own, so it shows
// in the mean of several encounters.
TEST(Hybrid, keeps_momentum_of_what_is_tied_and_of_what_collides)
{
    MomentumLoss loss, fine;
    constexpr int kEncounters = 6;
    const auto add = [](MomentumLoss& mean, const MomentumLoss& one) {
        mean.before += one.before / kEncounters;
        mean.in_all += one.in_all / kEncounters;
        mean.linear += one.linear / kEncounters;
    };
    for (int i = 0; i < kEncounters; ++i) {
        add(loss, collide_machines(1, 0.05 * i));
        add(fine, collide_machines(8, 0.05 * i));
    }
    EXPECT_LT(loss.before, 1e-3);
    EXPECT_LT(loss.in_all, 0.04);
    // Manifolds are solved in floats: a rounding of 1e-7 of 20 kg m/s in some of the steps. Of 60 encounters the mean
    // is 5e-6 and 1.2e-5, the worst 2.5e-5 and 3.8e-5.
    EXPECT_LT(loss.linear, tol(2e-5, 1e-3));
    EXPECT_LT(fine.linear, tol(2e-5, 8e-3));
    EXPECT_LT(fine.before, loss.before / 4);
    EXPECT_LT(fine.in_all, loss.in_all / 4);
}

// Two boxes tied by a joint slide as one.
TEST(Hybrid, tied_boxes_slide_as_far_as_friction_lets_them)
{
    for (const bool world_contacts : {true, false}) {
        Hybrid sim(dStepperSubstepsExactJoints, world_contacts);
        sim.surface.mu = real(0.6);
        sim.surface.mode = dContactApprox1;
        sim.ground();
        const dBodyID a = sim.box({0, 0, 0.25}, {0.5, 0.5, 0.5}, 1),
                      b = sim.box({0.6, 0, 0.25}, {0.5, 0.5, 0.5}, 20);
        const dJointID j = dJointCreateFixed(sim.world, nullptr);
        dJointAttach(j, a, b);
        dJointSetFixed(j);
        sim.run(30);
        const double x = position(b).x, v = 3;
        velocity(a, {v, 0, 0});
        velocity(b, {v, 0, 0});
        sim.run(120);
        EXPECT_LT(length(velocity(b)), 1e-2) << world_contacts;
        EXPECT_NEAR(position(b).x - x, v * v / (2 * 0.6 * 9.81), 0.03 * v * v / (2 * 0.6 * 9.81))
            << world_contacts;
        EXPECT_EQ(sim.method_of(b), dIslandMethodSubstepsExactJoints);
    }
}

// ---- which island is solved how

dJointID join_by_ball(Hybrid& sim, dBodyID a, dBodyID b, V3 at)
{
    const dJointID joint = dJointCreateBall(sim.world, nullptr);
    dJointAttach(joint, a, b);
    dJointSetBallAnchor(joint, real(at.x), real(at.y), real(at.z));
    return joint;
}

TEST(Hybrid, chooses_by_structure)
{
    Hybrid sim;
    sim.ground();
    const Chain chain = hang_chain(sim, {0, 0, 5}, 8, 10);
    const dBodyID box = sim.box({10, 0, 0.5}, {1, 1, 1}, 1), free = sim.sphere({20, 0, 50}, 1, 1);
    const dBodyID low = sim.box({30, 0, 0.5}, {1, 1, 1}, 1), high = sim.box({30, 0, 1.5}, {1, 1, 1}, 1000);
    const dBodyID under = sim.box({40, 0, 0.5}, {1, 1, 1}, 2), over = sim.box({40, 0, 1.5}, {1, 1, 1}, 1);
    const Chain loaded = hang_chain(sim, {60, 0, 5}, 8, 100);
    // A machine in a pile: too many contacts for the exact solver.
    std::vector<dBodyID> pile = spider(sim, {50, 0, 1}, 1);
    for (int i = 0; i < 150; ++i)
        pile.push_back(sim.box({49 + 0.5 * (i % 6), 0.5 * (i / 6 % 5) - 1, 1.6 + 0.5 * (i / 30)},
                               {0.45, 0.45, 0.45}, 1));
    // Bodies with many joints: a star is a tree, and a wheel has more pairs of joints on its hub than a sparse factor can hold.
    const auto many_joints = [&](double x, bool wheel) {
        const dBodyID hub = sim.sphere({x, 0, 20}, 1, 100);
        dBodyID last = nullptr;
        for (int i = 0; i < 60; ++i) {
            const dBodyID leaf = sim.body({x + 0.1 * i, 0, 22}, 1, 0.1);
            join_by_ball(sim, hub, leaf, {x + 0.1 * i, 0, 21});
            if (wheel && last) join_by_ball(sim, last, leaf, {x + 0.1 * i - 0.05, 0, 22});
            last = leaf;
        }
    };
    many_joints(80, false), many_joints(120, true);
    sim.run(60);
    const auto is_exact = [](int m) { return m >= dIslandMethodDense && m <= dIslandMethodInteriorPoint; };
    EXPECT_TRUE(is_exact(sim.method_of(chain.links.back())));
    EXPECT_EQ(sim.method_of(loaded.links.back()), dIslandMethodSubstepsExactJoints);
    EXPECT_EQ(sim.method_of(box), dIslandMethodSubsteps);
    EXPECT_EQ(sim.method_of(free), dIslandMethodSubsteps);
    EXPECT_TRUE(is_exact(std::max(sim.method_of(low), sim.method_of(high))));
    int pile_method = -1;
    for (dBodyID b : pile) pile_method = std::max(pile_method, sim.method_of(b));
    EXPECT_EQ(pile_method, dIslandMethodSubstepsExactJoints);

    // The world's word, and over it the most exact of the bodies'.
    dWorldSetHybridStepper(sim.world, dStepperQuick);
    sim.run(1);
    EXPECT_EQ(sim.method_of(box), dIslandMethodSweeps);
    dBodySetHybridStepper(under, dStepperSubsteps);
    sim.run(1);
    EXPECT_EQ(std::max(sim.method_of(under), sim.method_of(over)), dIslandMethodSubsteps);
    dBodySetHybridStepper(over, dStepperExact);
    sim.run(1);
    EXPECT_TRUE(is_exact(std::max(sim.method_of(under), sim.method_of(over))));
    EXPECT_EQ(sim.method_of(box), dIslandMethodSweeps);
    dWorldSetHybridStepper(sim.world, dStepperSubstepsExactJoints);
    sim.run(1);
    const auto method_between = [&](double from, double to) {
        int method = -1;
        for (dBodyID b : sim.bodies)
            if (position(b).x > from && position(b).x < to) method = std::max(method, sim.method_of(b));
        return method;
    };
    EXPECT_EQ(method_between(79, 110), dIslandMethodSubstepsExactJoints);
    EXPECT_EQ(method_between(110, 150), dIslandMethodSubsteps);
}

// A trunk of 100 kg on four legs with feet of 1 kg, its hinges held by motors.
TEST(Hybrid, a_heavy_machine_stands_still_on_light_feet)
{
    Hybrid sim;
    sim.ground();
    const dBodyID trunk = sim.body({0, 0, 0.95}, 100, 4);
    const auto hinge = [&](dBodyID a, dBodyID b, V3 at) {
        const dJointID h = dJointCreateHinge(sim.world, nullptr);
        dJointAttach(h, a, b);
        dJointSetHingeAnchor(h, real(at.x), real(at.y), real(at.z));
        dJointSetHingeAxis(h, 0, 1, 0);
        dJointSetHingeParam(h, dParamFMax, 200);
    };
    std::vector<dBodyID> feet;
    for (int k = 0; k < 4; ++k) {
        const double x = k % 2 ? 0.2 : -0.2, y = k / 2 ? 0.2 : -0.2;
        const dBodyID leg = sim.body({x, y, 0.4}, 2, 0.06);
        feet.push_back(sim.box({x, y, 0.05}, {0.15, 0.1, 0.1}, 1));
        hinge(trunk, leg, {x, y, 0.7});
        hinge(leg, feet.back(), {x, y, 0.1});
    }
    for (int i = 0; i < 240; ++i) {
        sim.run(1);
        for (dBodyID foot : feet) ASSERT_NEAR(position(foot).z, 0.05, 1e-3);
    }
    EXPECT_NEAR(position(trunk).z, 0.95, 1e-3);
    EXPECT_LT(length(velocity(trunk)), tol(1e-6, 1e-3));
}

TEST(Hybrid, settings_are_kept_and_bad_ones_refused)
{
    Hybrid sim;
    const dBodyID body = sim.body({0, 0, 0});
    dWorldSetHybridSubsteps(sim.world, 7);
    dBodySetHybridStepper(body, dStepperSubstepsExactJoints);
    dWorldSetHybridStepper(sim.world, dStepperSubsteps);
    const Messages messages;
    dWorldSetHybridSubsteps(sim.world, 0);
    dWorldSetHybridSubsteps(sim.world, 10001);
    dBodySetHybridStepper(body, 5);
    dBodySetHybridStepper(body, -1);
    dWorldSetHybridStepper(sim.world, 5);
    EXPECT_EQ(dWorldStepHybrid(sim.world, 0), 0);
    EXPECT_EQ(dWorldStepHybrid(nullptr, real(0.01)), 0);
    EXPECT_EQ(messages.count(), 7);
    EXPECT_EQ(dWorldGetHybridSubsteps(sim.world), 7);
    EXPECT_EQ(dBodyGetHybridStepper(body), dStepperSubstepsExactJoints);
    EXPECT_EQ(dWorldGetHybridStepper(sim.world), dStepperSubsteps);
}

// ---- determinism

void build_mixed(Hybrid& sim)
{
    sim.ground();
    hang_chain(sim, {0, 0, 2.5}, 9, 100);
    for (int k = 0; k < 3; ++k) spider(sim, {4.0 * k, 3, 1 + 0.3 * k}, 1);
    Random random(3);
    for (int i = 0; i < 40; ++i) {
        const V3 at = V3{2, 1.5, 3} + random.point(2.5);
        velocity(i % 2 ? sim.box(at, {0.4, 0.5, 0.3}, 1 + i) : sim.sphere(at, 0.25, 1), random.point(2));
    }
}

TEST(Hybrid, gives_the_same_bits_on_any_number_of_threads_and_in_a_batch)
{
    for (const int stepper : {int(dStepperHybrid), int(dStepperSubstepsExactJoints)})
        for (const bool world_contacts : {true, false}) {
            const auto hash = [&](int threads, bool batch) {
                Hybrid sim(stepper, world_contacts);
                dWorldSetStepThreads(sim.world, threads);
                build_mixed(sim);
                for (int i = 0; i < 60; ++i) {
                    if (!batch) {
                        sim.run(1);
                        continue;
                    }
                    if (!world_contacts) sim.collide();
                    EXPECT_EQ(dWorldsStep(&sim.world, 1, real(kH), dStepperHybrid, 0, 1, threads, nullptr),
                              1);
                }
                EXPECT_TRUE(finite_state(sim));
                return hash_state(sim);
            };
            const std::uint64_t alone = hash(1, false);
            for (const int threads : {2, 3, 8})
                EXPECT_EQ(hash(threads, false), alone) << threads << world_contacts;
            EXPECT_EQ(hash(2, true), alone) << world_contacts;
        }
}

// A world whose islands all take one stepper is stepped as by that stepper's own function.
TEST(Hybrid, agrees_with_the_steppers_to_the_bit)
{
    const auto hash = [](int stepper, bool hybrid) {
        Hybrid sim(stepper);
        build_mixed(sim);
        for (int i = 0; i < 40; ++i) {
            if (hybrid)
                sim.run(1);
            else if (stepper == dStepperExact)
                EXPECT_EQ(dWorldStep(sim.world, real(kH)), 1);
            else if (stepper == dStepperQuick)
                EXPECT_EQ(dWorldQuickStep(sim.world, real(kH)), 1);
            else
                EXPECT_EQ(dWorldStepFast1(sim.world, real(kH), 4), 1);
        }
        return hash_state(sim);
    };
    for (const int stepper : {int(dStepperExact), int(dStepperQuick), int(dStepperSubsteps)})
        EXPECT_EQ(hash(stepper, true), hash(stepper, false)) << stepper;
}

}  // namespace
}  // namespace epode::physics
