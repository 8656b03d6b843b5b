// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Mechanisms with loops, and joints that are no branches, in joint coordinates: the step is that in the coordinates of bodies, loops stay
// closed, passive ones keep their energy and free ones their momentum; loops that hold each other twice, axes that do not fit and dead
// centres throw nothing.
#include "random_tree.h"

namespace epode::physics {
namespace {

enum class Closing { kBall, kHinge, kUniversal, kSlider, kFixed, kDoubleBall, kPiston };

constexpr Closing kClosings[] = {Closing::kBall,  Closing::kHinge,      Closing::kUniversal, Closing::kSlider,
                                 Closing::kFixed, Closing::kDoubleBall, Closing::kPiston};

dJointID close_loop(RandomTree& tree, dBodyID a, dBodyID b, Closing kind)
{
    const dWorldID world = tree.sim_.world;
    const V3 at = 0.5 * (vec(dBodyGetPosition(a)) + vec(dBodyGetPosition(b)));
    dJointID joint = nullptr;
    switch (kind) {
        case Closing::kBall:
            dJointAttach(joint = dJointCreateBall(world, nullptr), a, b);
            dJointSetBallAnchor(joint, real(at.x), real(at.y), real(at.z));
            break;
        case Closing::kHinge:
            dJointAttach(joint = dJointCreateHinge(world, nullptr), a, b);
            dJointSetHingeAnchor(joint, real(at.x), real(at.y), real(at.z));
            dJointSetHingeAxis(joint, 1, 2, 3);
            break;
        case Closing::kUniversal:
            dJointAttach(joint = dJointCreateUniversal(world, nullptr), a, b);
            dJointSetUniversalAnchor(joint, real(at.x), real(at.y), real(at.z));
            dJointSetUniversalAxis1(joint, 1, 0, 0), dJointSetUniversalAxis2(joint, 0, 1, 0);
            break;
        case Closing::kSlider:
            dJointAttach(joint = dJointCreateSlider(world, nullptr), a, b);
            dJointSetSliderAxis(joint, 3, 2, 1);
            break;
        case Closing::kFixed:
            dJointAttach(joint = dJointCreateFixed(world, nullptr), a, b);
            dJointSetFixed(joint);
            break;
        case Closing::kDoubleBall: {
            dJointAttach(joint = dJointCreateDBall(world, nullptr), a, b);
            const V3 x = vec(dBodyGetPosition(a)), y = vec(dBodyGetPosition(b));
            dJointSetDBallAnchor1(joint, real(x.x), real(x.y), real(x.z));
            dJointSetDBallAnchor2(joint, real(y.x), real(y.y), real(y.z));
            break;
        }
        case Closing::kPiston:
            dJointAttach(joint = dJointCreatePiston(world, nullptr), a, b);
            dJointSetPistonAnchor(joint, real(at.x), real(at.y), real(at.z));
            dJointSetPistonAxis(joint, 2, 1, 3);
    }
    tree.joints_.push_back(joint);
    tree.feedbacks_.emplace_back();
    return joint;
}

// Bodies 1 and 8 of nine are seldom neighbours.
struct LoopedTree : RandomTree {
    LoopedTree(std::uint32_t seed, bool in_joints, bool free, Closing kind, bool active = true)
        : RandomTree(seed, in_joints, free, active)
    {
        close_loop(*this, bodies_[1], bodies_.back(), kind);
    }
};

TEST(JointLoops, step_is_that_of_bodies)
{
    const double h = kShortStep;
    for (const Closing kind : kClosings)
        for (std::uint32_t seed = 1; seed <= 12; ++seed) {
            const bool free = seed % 2 == 0;
            LoopedTree joints(seed, true, free, kind), bodies(seed, false, free, kind);
            for (LoopedTree* tree : {&joints, &bodies}) {
                dWorldSetCFM(tree->sim_.world, 0), tree->watch_forces();
                dBodyAddForce(tree->bodies_.back(), 1, 1, 1);
                dBodyAddTorque(tree->bodies_[2], real(0.1), real(0.2), 0);
                ASSERT_TRUE(dWorldStep(tree->sim_.world, real(h)));
            }
            EXPECT_EQ(method_of(joints.sim_.world), dIslandMethodJointCoordinates) << seed << int(kind);
            EXPECT_LT(worst_difference(joints, bodies), tol(1e-6, 1e-3)) << seed << int(kind);
            if (kind != Closing::kDoubleBall)
                continue;  // others may hold a loop twice, by forces of any size
            for (std::size_t i = 0; i < joints.joints_.size(); ++i) {
                const dJointFeedback &a = joints.feedbacks_[i], &b = bodies.feedbacks_[i];
                const double scale = 1 + length(vec(b.f1)) + length(vec(b.t1));
                EXPECT_LT(length(vec(a.f1) - vec(b.f1)), tol(1e-4, 1e-1) * scale) << seed << int(kind) << i;
                EXPECT_LT(length(vec(a.t1) - vec(b.t1)), tol(1e-4, 1e-1) * scale) << seed << int(kind) << i;
            }
        }
}

TEST(JointLoops, loops_stay_closed)
{
    for (const Closing kind : kClosings)
        for (std::uint32_t seed = 1; seed <= 6; ++seed) {
            LoopedTree tree(seed, true, seed % 2 == 0, kind);
            int in_joints = 0;
            for (int i = 0; i < 400; ++i) {
                dWorldStep(tree.sim_.world, real(0.0025));
                in_joints += method_of(tree.sim_.world) == dIslandMethodJointCoordinates;
                EXPECT_LT(joint_error(tree.sim_.world), tol(1e-4, 1e-3)) << seed << int(kind) << ' ' << i;
            }
            EXPECT_GT(in_joints, 360) << seed << int(kind);
        }
}

TEST(JointLoops, passive_loops_keep_their_energy)
{
    for (const Closing kind : kClosings)
        for (std::uint32_t seed = 1; seed <= 4; ++seed) {
            double swing[2], drift[2];  // of an energy of some 10 J
            for (const int fine : {0, 1}) {
                LoopedTree tree(seed, true, false, kind, false);
                const double first = tree.kinetic_and_weight();
                double worst = 0;
                for (int i = 0; i < (fine ? 2000 : 500); ++i) {
                    dWorldStep(tree.sim_.world, real(fine ? 0.0005 : 0.002));
                    worst = std::max(worst, std::fabs(tree.kinetic_and_weight() - first));
                }
                swing[fine] = worst, drift[fine] = tree.kinetic_and_weight() - first;
            }
            EXPECT_LT(swing[1], 0.5 * swing[0] + tol(1e-7, 1e-2)) << seed << int(kind);
            EXPECT_LT(std::fabs(drift[1]), 0.5 * std::fabs(swing[0]) + tol(1e-7, 1e-2)) << seed << int(kind);
            EXPECT_LT(swing[0], 3) << seed << int(kind);
        }
}

TEST(JointLoops, free_loops_keep_their_momentum)
{
    for (const Closing kind : kClosings)
        for (std::uint32_t seed = 1; seed <= 4; ++seed) {
            LoopedTree tree(seed, true, true, kind);
            dWorldSetGravity(tree.sim_.world, 0, 0, 0);
            dBodySetAngularVel(tree.bodies_[0], 1, 2, 3);
            const V3 p0 = momentum(tree.sim_), l0 = angular_momentum(tree.sim_);
            for (int i = 0; i < 500; ++i) dWorldStep(tree.sim_.world, real(0.002));
            EXPECT_LT(length(momentum(tree.sim_) - p0), tol(1e-8, 1e-2)) << seed << int(kind);
            EXPECT_LT(length(angular_momentum(tree.sim_) - l0), tol(1e-4, 0.05) * (1 + length(l0)))
                << seed << int(kind);
        }
}

// Bars of 1, 2, 1 m between ground hinges 2 m apart; the crank turns all the way if it is shorter. Three rows of the loop are redundant.
class FourBar {
  public:
    FourBar(double h, double crank, double misfit) : h_(h)
    {
        dWorldUseDefaults(sim_.world, dDefaultsRobot);
        dWorldSetGravity(sim_.world, 0, 0, real(-kGravity));
        dWorldSetStepReportMode(sim_.world, 1);
        // The triangle of the coupler (2 m) and the rocker (1.5 m) over the line from the crank's end to the second ground hinge.
        const V3 a{0, 0, 0}, d{2, 0, 0}, b{0, 0, crank};
        const double base = length(d - b), x = (base * base + 4 - 2.25) / (2 * base),
                     y = std::sqrt(4 - x * x);
        const V3 along = (1 / base) * (d - b), up{-along.z, 0, along.x};
        const V3 c = b + x * along + y * up;
        bars_ = {bar(a, b), bar(b, c), bar(c, d)};
        const V3 at[4] = {a, b, c, d};
        const dBodyID pairs[4][2] = {
            {bars_[0], nullptr}, {bars_[0], bars_[1]}, {bars_[1], bars_[2]}, {bars_[2], nullptr}};
        for (int i = 0; i < 4; ++i) {
            joints_[i] = dJointCreateHinge(sim_.world, nullptr);
            dJointAttach(joints_[i], pairs[i][0], pairs[i][1]);
            dJointSetHingeAnchor(joints_[i], real(at[i].x), 0, real(at[i].z));
            dJointSetHingeAxis(joints_[i], i == 3 ? real(misfit) : 0, 1, 0);
        }
    }

    void step() { dWorldStep(sim_.world, real(h_)); }

    // E - (h/2) m g v_z, since weight acts at the beginning of a step.
    double energy() const
    {
        double sum = 0;
        for (const dBodyID b : bars_) {
            const V3 v = velocity(b), w = spin(b);
            dMass mass;
            dBodyGetMass(b, &mass);
            sum += 0.5 * double(mass.mass) * dot(v, v) + 0.5 * dot(w, spin_momentum(b)) +
                   double(mass.mass) * kGravity * (position(b).z - h_ / 2 * v.z);
        }
        return sum;
    }

    Sim sim_;
    double h_;
    std::vector<dBodyID> bars_;
    dJointID joints_[4];

  private:
    dBodyID bar(V3 from, V3 to)
    {
        const dBodyID body = dBodyCreate(sim_.world);
        const V3 way = to - from, at = 0.5 * (from + to);
        dMass mass;
        dMassSetBoxTotal(&mass, 1, real(length(way)), real(0.05), real(0.05));
        dBodySetMass(body, &mass), dBodySetPosition(body, real(at.x), real(at.y), real(at.z));
        dMatrix3 R;
        dRFromAxisAndAngle(R, 0, 1, 0, real(-std::atan2(way.z, way.x)));
        dBodySetRotation(body, R);
        return body;
    }
};

TEST(JointLoops, four_bars_keep_their_energy_and_turn_over)
{
    for (const double h : {1 / 60., 1 / 240., 1e-3}) {
        FourBar bars(h, 0.7, 0);
        dBodySetAngularVel(bars.bars_[0], 0, 6, 0);
        bars.step();
        const double first = bars.energy();
        double worst = 0;
        int in_joints = 0;
        const int steps = int(20 / h);
        for (int i = 0; i < steps; ++i) {
            bars.step();
            worst = std::max(worst, std::fabs(bars.energy() - first));
            in_joints += method_of(bars.sim_.world) == dIslandMethodJointCoordinates;
            ASSERT_LT(joint_error(bars.sim_.world), tol(1e-6, 1e-3)) << h << ' ' << i;
        }
        EXPECT_GT(in_joints, steps * 99 / 100) << h;
        EXPECT_LT(worst, (0.006 * 3600 * h * h + tol(0, 0.01)) * first) << h;  // of second order
    }
}

// Anchors have the digits of their places there, 6e-5 m in floats, and no step asks for more.
TEST(JointLoops, far_from_the_origin_every_step_is_in_joint_coordinates)
{
    FourBar bars(1 / 240., 0.7, 0);
    const dVector3 origin = {1000, 1000, 0};
    ASSERT_TRUE(dWorldShiftOrigin(bars.sim_.world, bars.sim_.space, origin));
    dBodySetAngularVel(bars.bars_[0], 0, 6, 0);
    for (int i = 0; i < 1200; ++i) {
        bars.step();
        ASSERT_EQ(method_of(bars.sim_.world), dIslandMethodJointCoordinates) << i;
        ASSERT_LT(joint_error(bars.sim_.world), tol(1e-6, 8 * kEpsilon * 1400)) << i;
    }
}

// A crank on a motor that is strong enough: where a step ends its rate is the one that is asked for.
TEST(JointLoops, motors_have_their_rate_where_the_step_ends)
{
    for (const double h : {1 / 60., 1 / 240., 1e-3}) {
        FourBar bars(h, 0.7, 0);
        dJointSetHingeParam(bars.joints_[0], dParamVel, 3),
            dJointSetHingeParam(bars.joints_[0], dParamFMax, 1e4);
        for (int i = 0; i < int(2 / h); ++i) {
            bars.step();
            ASSERT_NEAR(double(dJointGetHingeAngleRate(bars.joints_[0])), 3, tol(1e-8, 1e-3))
                << h << ' ' << i;
        }
        EXPECT_EQ(method_of(bars.sim_.world), dIslandMethodJointCoordinates) << h;
    }
}

// The last hinge leans by 1e-5: the loop cannot close. It is strained and jams, as with bodies. (Newton's steps on the poses, far
// longer than what the hinge is off by, made 2 J of 21.)
TEST(JointLoops, axes_that_do_not_fit_throw_nothing)
{
    for (const double h : {1 / 60., 1 / 240., 1e-3}) {
        FourBar bars(h, 0.7, 1e-5);
        dBodySetAngularVel(bars.bars_[0], 0, 6, 0);
        bars.step();
        const double first = bars.energy();
        for (int i = 0; i < int(5 / h); ++i) bars.step();
        EXPECT_LT(bars.energy(), first) << h;
        EXPECT_LT(joint_error(bars.sim_.world), 1e-3) << h;
    }
}

}  // namespace
}  // namespace epode::physics
