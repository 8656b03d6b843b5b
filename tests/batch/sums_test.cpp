// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Couplings, tendons that are sums of coordinates, and filters between controls and forces: against dWorldStep, and in closed form.
#include "golden/golden.h"
#include "models.h"

#include <ode/ext.h>

#include <algorithm>

namespace epode::tests {
namespace {

// An arm with a gripper: fingers of two chains that a coupling holds alike, a tendon over three joints with a spring, a damper, a servo
// whose force is limited and a motor; a tendon with a motor alone; filters of each kind, one early.
const char* const kGripper = R"(<mujoco model="gripper"><compiler angle="radian"/><worldbody>
<body name="arm" pos="0 0 1"><joint name="lift" axis="0 1 0" damping="0.2"/><inertial pos="0.2 0 0" mass="1" diaginertia="0.01 0.02 0.02"/>
<body name="hand" pos="0.4 0 0"><joint name="turn" axis="1 0 0" armature="0.01"/><inertial pos="0 0 0" mass="0.4" diaginertia="0.002 0.001 0.002"/>
<body name="one" pos="0.1 0.02 0"><joint name="open" type="slide" axis="0 1 0"/><inertial pos="0 0 0.01" mass="0.1" diaginertia="1e-4 1e-4 1e-4"/></body>
<body name="two" pos="0.1 -0.02 0"><joint name="shut" type="slide" axis="0 -1 0"/><inertial pos="0 0 0" mass="0.12" diaginertia="1e-4 1e-4 1e-4"/></body>
</body></body>
<body name="wheel" pos="0 1 1"><joint name="spin" axis="0 1 0"/><inertial pos="0.1 0 0" mass="0.5" diaginertia="0.01 0.01 0.01"/></body></worldbody>
<equality><joint name="alike" joint1="open" joint2="shut"/></equality>
<tendon><fixed name="pull" stiffness="40" damping="0.5" range="-0.4 0.5" limited="true"><joint joint="open" coef="0.5"/><joint joint="lift" coef="0.3"/><joint joint="spin" coef="-0.2"/></fixed>
<fixed name="push"><joint joint="turn" coef="1.5"/><joint joint="spin" coef="0.5"/></fixed></tendon>
<actuator><position name="grip" tendon="pull" kp="200" kv="3" forcerange="-9 9"/><motor name="strain" tendon="pull" gear="2" ctrlrange="-1 1"/>
<motor name="roll" tendon="push" gear="0.6"/>
<general name="slow" joint="lift" dyntype="filter" dynprm="0.03" gainprm="3" gear="2" actrange="-0.6 0.6" actlimited="true"/>
<general name="exact" joint="turn" dyntype="filterexact" dynprm="0.02" gainprm="0.5" actearly="true"/>
<general name="sum" joint="spin" dyntype="integrator" gainprm="2" biastype="affine" biasprm="0.1 -5 -0.2"/></actuator></mujoco>)";
constexpr int kActs = 3, kControls = 6, kMoves = 5;

struct State {
    std::vector<double> q, v, control, act;
};

// On the coupling, in place and in speed.
State any_state(Dice& dice, double speed)
{
    State out{dice.many(kMoves, -0.5, 0.5), dice.many(kMoves, -speed, speed), dice.many(kControls, -1, 1),
              dice.many(kActs, -0.5, 0.5)};
    out.q[3] = out.q[2], out.v[3] = out.v[2];
    return out;
}

std::vector<double> step_of_world(dRobotModelID model, const State& state, dReal h)
{
    const dWorldID world = dWorldCreate();
    const dSpaceID space = dSimpleSpaceCreate(nullptr);
    dWorldSetGravity(world, 0, 0, dReal(-9.81));
    dWorldSetERP(world, dReal(0.2)), dWorldSetCFM(world, 0);
    const dRobotID robot = dRobotCreate(world, space, model, nullptr, nullptr);
    const auto q = reals_of(state.q), v = reals_of(state.v);
    dRobotSetPositions(robot, q.data(), kMoves), dRobotSetVelocities(robot, v.data(), kMoves);
    for (int i = 0; i < kControls; ++i) dRobotSetControl(robot, i, dReal(state.control[size_t(i)]));
    for (int i = 0; i < kActs; ++i) dRobotSetActivation(robot, 3 + i, dReal(state.act[size_t(i)]));
    dRobotAddForces(robot, h);
    dWorldStep(world, h);
    std::vector<dReal> out(kMoves);
    dRobotGetVelocities(robot, out.data(), kMoves);
    std::vector<double> all(out.begin(), out.end());
    for (int i = 0; i < kActs; ++i) all.push_back(double(dRobotGetActivation(robot, 3 + i)));
    dRobotDestroy(robot), dSpaceDestroy(space), dWorldDestroy(world);
    return all;
}

void put(Copies<double>& copies, int copy, const State& state)
{
    copies.write_one(dBatchPositions, copy, state.q), copies.write_one(dBatchVelocities, copy, state.v);
    copies.write_one(dBatchControls, copy, state.control),
        copies.write_one(dBatchActivations, copy, state.act);
}

class BatchSums : public testing::Test {
  protected:
    BatchSums()
    {
        dInitODE2(0);
        model = model_of(kGripper);
    }
    ~BatchSums() override
    {
        dRobotModelDestroy(model);
        dCloseODE();
    }
    dRobotModelID model;
};

TEST_F(BatchSums, step_as_the_worlds_do)
{
    if (sizeof(dReal) == 4) GTEST_SKIP() << "differences of this size are rounding in floats";
    constexpr int kStates = 400;
    const dReal h = dReal(1e-4);  // as in worlds_test.cpp
    // Stops of a world's joints take back without a bound.
    Copies<double> copies(model, kStates, h, dReal(1e-12), 1, 20000, dReal(1e6));
    ASSERT_EQ(copies.size(dBatchActivations), kActs);
    Dice dice(7);
    std::vector<State> states;
    for (int i = 0; i < kStates; ++i) states.push_back(any_state(dice, 0)), put(copies, i, states.back());
    dBatchStep(copies.id, 1);
    const auto v = copies.read(dBatchVelocities), act = copies.read(dBatchActivations);
    for (int i = 0; i < kStates; ++i) {
        const auto want = step_of_world(model, states[size_t(i)], h);
        double fast = 0;
        for (int k = 0; k < kMoves; ++k) fast = std::max(fast, std::fabs(want[size_t(k)]));
        // Joint velocities of a world are read where bodies have moved to.
        const double bound = 1e-9 + 30 * double(h * h) * fast * fast * fast;
        for (int k = 0; k < kMoves; ++k) EXPECT_NEAR(v[size_t(i * kMoves + k)], want[size_t(k)], bound) << i;
        for (int k = 0; k < kActs; ++k)
            EXPECT_NEAR(act[size_t(i * kActs + k)], want[size_t(kMoves + k)], 1e-15) << i;
    }
}

TEST_F(BatchSums, couplings_hold_and_limits_stop)
{
    Copies<double> copies(model, 8, dReal(0.002), dReal(1e-10), 1, 2000);
    Dice dice(9);
    for (int i = 0; i < 8; ++i) put(copies, i, any_state(dice, 1));
    const double factors[] = {0.5, 0.3, -0.2};
    for (int k = 0; k < 100; ++k) {
        dBatchStep(copies.id, 20);
        const auto q = copies.read(dBatchPositions), v = copies.read(dBatchVelocities);
        for (size_t i = 0; i < 8; ++i) {
            EXPECT_NEAR(v[5 * i + 2], v[5 * i + 3], 1e-8);
            EXPECT_NEAR(q[5 * i + 2], q[5 * i + 3], 1e-8);
            const double length =
                factors[0] * q[5 * i + 2] + factors[1] * q[5 * i] + factors[2] * q[5 * i + 4];
            EXPECT_TRUE(k <= 10 || std::fabs(length - 0.05) < 0.45 + 1e-4) << length;
        }
    }
    EXPECT_EQ(dBatchCountBad(copies.id), 0);
}

std::string without(std::string text, const std::string& from, const std::string& to)
{
    const size_t first = text.find(from), end = text.find(to, first) + to.size();
    return text.replace(first, end - first, "");
}

// Velocities after one step of a model without them, under applied forces in their place.
std::vector<double> step_without(const std::string& text, const State& state,
                                 const std::vector<double>& applied, dReal h)
{
    const dRobotModelID bare = model_of(text.c_str());
    Copies<double> copies(bare, 1, h, dReal(1e-12), 1, 20000);
    copies.write(dBatchPositions, state.q), copies.write(dBatchVelocities, state.v),
        copies.write(dBatchAppliedForces, applied);
    if (copies.size(dBatchControls) > 0)
        copies.write(dBatchControls, state.control), copies.write(dBatchActivations, state.act);
    dBatchStep(copies.id, 1);
    dRobotModelDestroy(bare);
    return copies.read(dBatchVelocities);
}

// Short steps: what depends on velocities acts at a step's end.
TEST_F(BatchSums, actuators_give_what_is_observed)
{
    const dReal h = dReal(1e-7);
    const std::string bare = without(kGripper, "<actuator>", "</actuator>");
    Dice dice(12);
    int held = 0;
    for (int i = 0; i < 60; ++i) {
        const State state = any_state(dice, i % 2 ? 4 : 0.1);
        Copies<double> copies(model, 1, h, dReal(1e-12), 1, 20000);
        put(copies, 0, state);
        const auto forces = copies.read(dBatchActuatorForces);
        dBatchStep(copies.id, 1);
        const auto v = copies.read(dBatchVelocities), want = step_without(bare, state, forces, h);
        double largest = 0;
        for (const double force : forces) largest = std::max(largest, std::fabs(force));
        for (size_t k = 0; k < kMoves; ++k)
            EXPECT_NEAR((v[k] - want[k]) / h, 0, 1e-3 * (1 + largest)) << i << ' ' << k;
        const double length = 0.5 * state.q[2] + 0.3 * state.q[0] - 0.2 * state.q[4];
        held += std::fabs(200 * (state.control[0] - length)) > 60;
    }
    EXPECT_GT(held, 20);
}

TEST_F(BatchSums, rows_give_what_is_observed)
{
    const dReal h = dReal(0.002);
    const std::string bare =
        without(without(kGripper, "<equality>", "</equality>"), " range=", "limited=\"true\"");
    Dice dice(13);
    int stopped = 0;
    for (int i = 0; i < 60; ++i) {
        State state = any_state(dice, 2);
        if (i % 3 != 0) state.q[0] += i % 3 == 1 ? 1.2 : -1.2;
        Copies<double> copies(model, 1, h, dReal(1e-12), 1, 20000);
        put(copies, 0, state);
        dBatchStep(copies.id, 1);
        const auto v = copies.read(dBatchVelocities), forces = copies.read(dBatchVelocityConstraintForces),
                   want = step_without(bare, state, forces, h);
        for (size_t k = 0; k < kMoves; ++k) EXPECT_NEAR(v[k], want[k], 1e-9) << i << ' ' << k;
        EXPECT_NE(forces[2], 0);
        EXPECT_EQ(forces[1], 0);
        stopped += forces[0] != 0;
    }
    EXPECT_GT(stopped, 10);
    EXPECT_LT(stopped, 60);
}

TEST(BatchFilters, approach_as_their_closed_forms_do)
{
    const char* text = R"(<mujoco><option gravity="0 0 0"/><worldbody><body><joint name="j" type="slide"/>
<inertial pos="0 0 0" mass="1" diaginertia="1 1 1"/></body></worldbody><actuator><general name="a" joint="j" dyntype="filterexact" dynprm="0.1"/>
<general name="b" joint="j" dyntype="integrator" actrange="-0.2 0.2" actlimited="true"/></actuator></mujoco>)";
    const dRobotModelID model = model_of(text);
    Copies<double> copies(model, 2, dReal(0.002));
    copies.write(dBatchControls, {1, 0, 0, -1});
    dBatchStep(copies.id, 50);
    const auto act = copies.read(dBatchActivations);
    EXPECT_NEAR(act[0], 1 - std::exp(-1.0), 1e-12);
    EXPECT_EQ(act[1], 0);
    EXPECT_NEAR(act[3], -0.1, 1e-12);
    const auto v = copies.read(dBatchVelocities);
    EXPECT_NEAR(v[0], 0.1 - 0.1 * (1 - std::exp(-1.0)), 0.002);
    dBatchStep(copies.id, 100);
    EXPECT_EQ(copies.read(dBatchActivations)[3], -0.2);
    dBatchReset(copies.id, nullptr);
    EXPECT_EQ(copies.read(dBatchActivations)[3], 0);
    copies.write_one(dBatchActivations, 1, {0.3, 0.1});
    EXPECT_EQ(copies.read(dBatchActivations), (std::vector<double>{0, 0, 0.3, 0.1}));
    dRobotModelDestroy(model);
}

template <typename T>
std::uint64_t hash_of_grippers(int copies_at_once)
{
    const dRobotModelID model = model_of(kGripper);
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (int first = 0; first < 24; first += copies_at_once) {
        Copies<T> copies(model, copies_at_once, dReal(0.004));
        for (int i = 0; i < copies_at_once; ++i) {
            Dice dice(unsigned(300 + first + i));
            const State s = any_state(dice, 1);
            copies.write_one(dBatchPositions, i, {s.q.begin(), s.q.end()}),
                copies.write_one(dBatchVelocities, i, {s.v.begin(), s.v.end()});
            copies.write_one(dBatchControls, i, {s.control.begin(), s.control.end()}),
                copies.write_one(dBatchActivations, i, {s.act.begin(), s.act.end()});
        }
        dBatchStep(copies.id, 500);
        for (int i = 0; i < copies_at_once; ++i)
            for (const int quantity : {dBatchPositions, dBatchVelocities, dBatchActivations})
                for (const T x : copies.read(quantity, i, 1)) hash = hashed(hash, x);
    }
    dRobotModelDestroy(model);
    return hash;
}

TEST(BatchBits, of_sums_and_filters_are_golden)
{
    if (sizeof(dReal) == 4) GTEST_SKIP() << "step sizes and states pass through dReal";
    EXPECT_TRUE(golden::is_golden("batch/grippers/double", hash_of_grippers<double>(24)));
    EXPECT_TRUE(golden::is_golden("batch/grippers/float", hash_of_grippers<float>(24)));
    EXPECT_EQ(hash_of_grippers<double>(1), hash_of_grippers<double>(24));
    EXPECT_EQ(hash_of_grippers<float>(1), hash_of_grippers<float>(24));
}

}  // namespace
}  // namespace epode::tests
