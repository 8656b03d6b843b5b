// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Pairs of shapes whose points the library's own pair functions find: against dWorldStep, what stands, slides and is held.
#include "golden/golden.h"
#include "models.h"

#include <ode/ext.h>

#include <algorithm>

namespace epode::tests {
namespace {

constexpr double kWeight = 9.81;

// A loose shape of a kilogram over a fixed one, which is the larger.
std::string one_over_other(const std::string& upper, const std::string& lower, double height,
                           const char* friction)
{
    return std::string(
               "<mujoco><compiler angle='degree'/><asset><mesh name='wedge' vertex='-.1 -.1 -.1 .1 -.1 -.1 "
               "-.1 .1 -.1 .1 .1 -.1 "
               "-.1 -.05 .1 .1 -.05 .1 -.1 .05 .1 .1 .05 .1'/><mesh name='slab' vertex='-.4 -.4 -.1 .4 -.4 "
               "-.1 -.4 .4 -.1 .4 "
               ".4 -.1 -.4 -.4 .1 .4 -.4 .1 -.4 .4 .1 .4 .4 .1'/><hfield name='hills' nrow='3' ncol='3' "
               "size='2 2 1 .5' "
               "elevation='0 .2 0 .2 1 .2 0 .2 0'/><hfield name='flat' nrow='2' ncol='2' size='2 2 1 .5' "
               "elevation='0 0 0 "
               "0'/></asset><default><geom friction='") +
           friction + "'/></default><worldbody><geom name='lower' " + lower + "/><body name='b' pos='0 0 " +
           std::to_string(height) + "'><freejoint/><geom name='upper' mass='1' " + upper +
           "/></body></worldbody></mujoco>";
}

const char* const kUppers[] = {"type='box' size='.1 .12 .1'",
                               "type='cylinder' size='.1 .1'",
                               "type='ellipsoid' size='.12 .12 .1'",
                               "type='mesh' mesh='wedge'",
                               "type='capsule' size='.1 .1' euler='90 0 0'",
                               "type='sphere' size='.1'"};
const char* const kLowers[] = {
    "type='box' size='.4 .4 .1' pos='0 0 -.1'", "type='cylinder' size='.4 .1' pos='0 0 -.1'",
    "type='mesh' mesh='slab' pos='0 0 -.1'", "type='hfield' hfield='flat'", "type='plane' size='5 5 1'"};

class BatchShapes : public testing::Test {
  protected:
    BatchShapes() { dInitODE2(0); }
    ~BatchShapes() override { dCloseODE(); }
};

struct Touch {
    dWorldID world;
    dJointGroupID group;
    int points;  // at most, of the pair
    int found = 0;
};

// The points of the loose shape on the fixed one, in that order, as a batch asks for them.
void touch(void* data, dGeomID a, dGeomID b)
{
    auto& its = *static_cast<Touch*>(data);
    if (!dGeomGetBody(a)) std::swap(a, b);
    dContactGeom points[8];
    its.found = dCollide(a, b, its.points, points, sizeof points[0]);
    for (int k = 0; k < its.found; ++k) {
        dContact contact{};
        contact.geom = points[k];
        dJointAttach(dJointCreateContact(its.world, its.group, &contact), dGeomGetBody(contact.geom.g1),
                     dGeomGetBody(contact.geom.g2));
    }
}

constexpr double kCorrection = 0.1;
std::vector<double> step_of_world(dRobotModelID model, const std::vector<double>& state, dReal h, int points,
                                  int& found)
{
    const dWorldID world = dWorldCreate();
    const dSpaceID space = dSimpleSpaceCreate(nullptr);
    dWorldSetGravity(world, 0, 0, dReal(-kWeight));
    dWorldSetERP(world, dReal(0.2)), dWorldSetCFM(world, 0);
    dWorldSetContactMaxCorrectingVel(world, dReal(kCorrection));
    const dRobotID robot = dRobotCreate(world, space, model, nullptr, nullptr);
    const auto q = reals_of(state);
    dRobotSetPositions(robot, q.data(), 7);
    Touch its{world, dJointGroupCreate(0), points};
    dSpaceCollide(space, &its, touch);
    dWorldStep(world, h);
    std::vector<dReal> out(6);
    dRobotGetVelocities(robot, out.data(), 6);
    dRobotDestroy(robot), dJointGroupDestroy(its.group), dSpaceDestroy(space), dWorldDestroy(world);
    found = its.found;
    return {out.begin(), out.end()};
}

std::vector<double> step_of_batch(dRobotModelID model, const std::vector<double>& state, dReal h)
{
    dBatchOptions options;
    dBatchOptionsInit(&options, sizeof options);
    options.doubles = 1, options.threads = 1, options.stepsize = h, options.tolerance = dReal(1e-13);
    options.max_sweeps = 50000, options.reach = 0, options.max_correction = dReal(kCorrection);
    const dBatchID batch = dBatchCreate(model, 1, &options);
    EXPECT_TRUE(batch);
    std::vector<double> out(6);
    dBatchWrite(batch, dBatchPositions, 0, 1, state.data()), dBatchStep(batch, 1);
    dBatchRead(batch, dBatchVelocities, 0, 1, out.data());
    dBatchDestroy(batch);
    return out;
}

TEST_F(BatchShapes, push_as_in_worlds)
{
    if (sizeof(dReal) == 4) GTEST_SKIP() << "differences of this size are rounding in floats";
    Dice dice(11);
    for (const char* lower : kLowers)
        for (const char* upper : kUppers) {
            const std::string text = one_over_other(upper, lower, 1, "0");
            const dRobotModelID model = model_of(text.c_str());
            const bool is_landscape = std::string(lower).find("hfield") != std::string::npos;
            int touching = 0;
            for (int i = 0; i < 12; ++i) {
                std::vector<double> q = any_positions(model, dice);
                q[0] = dice.between(-0.1, 0.1), q[1] = dice.between(-0.1, 0.1),
                q[2] = dice.between(0.04, 0.14);
                const auto batch = step_of_batch(model, q, dReal(1e-4));
                // A world's velocities are read where the body has turned to, and an origin away from the centre moves with that.
                const double turn2 = batch[3] * batch[3] + batch[4] * batch[4] + batch[5] * batch[5],
                             bound = (is_landscape ? 1e-6 : 1e-9) + 1e-4 * 0.05 * turn2;
                int best = 0;
                double least = 1;
                // As many points as the batch has slots of this pair: 1, 2, 4 or 8.
                for (const int points : {1, 2, 4, 8}) {
                    int found = 0;
                    const auto world = step_of_world(model, q, dReal(1e-4), points, found);
                    double worst = 0;
                    for (size_t k = 0; k < 6; ++k) worst = std::max(worst, std::fabs(batch[k] - world[k]));
                    least = std::min(least, worst), best = std::max(best, found);
                }
                touching += best > 0;
                EXPECT_LT(least, bound) << upper << lower << i;
            }
            EXPECT_GT(touching, 2) << upper << lower;
            dRobotModelDestroy(model);
        }
}

// Ten seconds: no drift, no creep, at the height that the shape has.
TEST_F(BatchShapes, stand_on_one_another)
{
    for (const char* lower : kLowers)
        for (const char* upper : kUppers) {
            const std::string text = one_over_other(upper, lower, 0.12, "0.6");
            const dRobotModelID model = model_of(text.c_str());
            Copies<double> copies(model, 1, dReal(0.004));
            ASSERT_TRUE(copies.id) << text;
            dBatchStep(copies.id, 500);
            const auto before = copies.read(dBatchPositions);
            dBatchStep(copies.id, 2000);
            const auto q = copies.read(dBatchPositions), v = copies.read(dBatchVelocities);
            EXPECT_NEAR(q[2], 0.1, 2e-4) << upper << lower;
            for (size_t k = 0; k < 3; ++k) EXPECT_NEAR(q[k], before[k], 1e-4) << upper << lower;
            for (size_t k = 0; k < 3; ++k) EXPECT_NEAR(v[k], 0, 1e-4) << upper << lower;
            double carried = 0;
            const auto forces = copies.read(dBatchConstraintForces);
            for (size_t k = 0; k < forces.size(); k += 3) carried += forces[k];
            EXPECT_NEAR(carried, kWeight, 1e-2) << upper << lower;
            dRobotModelDestroy(model);
        }
}

// A box on a box slides above mu m g and holds below, in every direction.
TEST_F(BatchShapes, slip_at_their_cone)
{
    for (const char* lower : {kLowers[0], kLowers[3]}) {
        const dRobotModelID model = model_of(one_over_other(kUppers[0], lower, 0.1, "0.5").c_str());
        constexpr int kDirections = 16;
        Copies<double> copies(model, 2 * kDirections, dReal(0.002), dReal(1e-9), 1, 1000);
        dBatchStep(copies.id, 300);
        const double bound = 0.5 * kWeight;
        for (int i = 0; i < 2 * kDirections; ++i) {
            const double angle = 2 * 3.14159265358979 * i / kDirections,
                         f = bound * (i < kDirections ? 0.999 : 1.01);
            copies.write_one(dBatchAppliedForces, i, {f * std::cos(angle), f * std::sin(angle), 0, 0, 0, 0});
        }
        dBatchStep(copies.id, 250);
        const auto v = copies.read(dBatchVelocities);
        for (size_t i = 0; i < 2 * kDirections; ++i) {
            const double speed = std::hypot(v[6 * i], v[6 * i + 1]);
            if (i < kDirections) {
                EXPECT_LT(speed, 5e-5)
                    << lower << i;  // sweeps over redundant points end where they no longer gain
            } else {
                EXPECT_NEAR(speed, 0.01 * bound * 0.5, 2e-3 * 0.01 * bound + 2e-5) << lower << i;
            }
        }
        dRobotModelDestroy(model);
    }
}

// An arm of two servos holds a tray on which two boxes stand on one another, for 30 s.
TEST_F(BatchShapes, stay_on_a_tray_that_an_arm_holds)
{
    const char* text =
        R"(<mujoco><compiler angle="radian"/><default><geom friction="0.6"/></default><worldbody>
<body name="upper" pos="0 0 1"><joint name="u" axis="0 1 0" damping="1"/><geom type="capsule" fromto="0 0 0 .4 0 0" size=".03" mass="1" contype="0" conaffinity="0"/>
<body name="tray" pos=".5 0 0"><joint name="t" axis="0 1 0" damping="1"/><geom type="box" size=".15 .15 .01" mass="0.5"/></body></body>
<body name="one" pos=".5 0 1.061"><freejoint/><geom type="box" size=".05 .05 .05" mass="0.3"/></body>
<body name="two" pos=".51 .01 1.162"><freejoint/><geom type="box" size=".05 .05 .05" mass="0.2"/></body></worldbody>
<actuator><position joint="u" kp="2000" kv="80"/><position joint="t" kp="500" kv="20"/></actuator></mujoco>)";
    const dRobotModelID model = model_of(text);
    Copies<float> copies(model, 5, dReal(0.004));
    Copies<double> exact(model, 2, dReal(0.004));
    ASSERT_TRUE(copies.id);
    dBatchStep(copies.id, 500), dBatchStep(exact.id, 500);
    const auto before = copies.read(dBatchPositions, 4, 1);
    dBatchStep(copies.id, 7000), dBatchStep(exact.id, 7000);
    const auto q = copies.read(dBatchPositions, 4, 1);
    const auto other = exact.read(dBatchPositions, 1, 1);
    for (size_t k = 0; k < q.size(); ++k) EXPECT_NEAR(double(q[k]), double(before[k]), 2e-3) << k;
    for (size_t k = 0; k < q.size(); ++k) EXPECT_NEAR(double(q[k]), other[k], 5e-3) << k;
    EXPECT_NEAR(double(q[11] - q[4]), 0.1, 1e-3);
    dRobotModelDestroy(model);
}

// Two fingers on a coupling that a servo closes lift a cube and keep it.
TEST_F(BatchShapes, are_held_by_a_gripper)
{
    const char* text =
        R"(<mujoco><default><geom friction="1"/></default><worldbody><geom type="plane" size="3 3 1"/>
<body name="hand" pos="0 0 .3"><joint name="lift" type="slide" axis="0 0 1"/><geom type="box" size=".08 .03 .02" pos="0 0 .05" mass="0.5"/>
<body name="left"><joint name="l" type="slide" axis="1 0 0" range="-.04 .04" limited="true"/><geom type="box" size=".01 .02 .05" pos="-.05 0 -.03" mass="0.1"/></body>
<body name="right"><joint name="r" type="slide" axis="-1 0 0" range="-.04 .04" limited="true"/><geom type="box" size=".01 .02 .05" pos=".05 0 -.03" mass="0.1"/></body></body>
<body name="cube" pos="0 0 .025"><freejoint/><geom type="box" size=".025 .025 .025" mass="0.2"/></body></worldbody>
<equality><joint joint1="l" joint2="r"/></equality>
<tendon><fixed name="grip"><joint joint="l" coef=".5"/><joint joint="r" coef=".5"/></fixed></tendon>
<actuator><position joint="lift" kp="2000" kv="120"/><position tendon="grip" kp="1000" kv="20" forcerange="-20 20"/></actuator></mujoco>)";
    const dRobotModelID model = model_of(text);
    Copies<double> copies(model, 2, dReal(0.002));
    ASSERT_TRUE(copies.id);
    const auto control = [&](double lift, double grip) {
        copies.write(dBatchControls, {lift, grip, lift, 0});
    };
    constexpr double kDown = -0.21;
    control(kDown, 0), dBatchStep(copies.id, 1000);
    control(kDown, 0.04), dBatchStep(copies.id, 500);
    for (int i = 1; i <= 100; ++i) control(kDown * (1 - i / 100.0), 0.04), dBatchStep(copies.id, 10);
    dBatchStep(copies.id, 500);
    const double now = copies.read(dBatchPositions, 0, 1)[5];
    EXPECT_NEAR(now, 0.025 - kDown, 2e-3);
    dBatchStep(copies.id, 5000);
    EXPECT_NEAR(copies.read(dBatchPositions, 0, 1)[5], now, 1e-3);
    EXPECT_LT(copies.read(dBatchPositions, 1, 1)[5], 0.03);  // whose hand stays open
    dRobotModelDestroy(model);
}

template <typename T>
std::uint64_t hash_of_stacks(int copies_at_once, int threads = 1)
{
    const std::string text = one_over_other(kUppers[3], "type='hfield' hfield='hills'", 1.2, "0.5");
    std::string more = text;
    more.insert(more.find("</worldbody>"),
                "<body pos='.1 0 1.6'><freejoint/><geom type='box' size='.1 .1 .1'/></body><body pos='0 .1 "
                "2'><freejoint/><geom type='cylinder' size='.1 .1'/></body>");
    const dRobotModelID model = model_of(more.c_str());
    std::uint64_t hash = 0xcbf29ce484222325u;
    constexpr int kAll = 6;
    for (int first = 0; first < kAll; first += copies_at_once) {
        Copies<T> copies(model, copies_at_once, dReal(0.004), 0, threads);
        for (int i = 0; i < copies_at_once; ++i) {
            Dice dice(unsigned(400 + first + i));
            const auto v = dice.many(18, -1, 1);
            copies.write_one(dBatchVelocities, i, {v.begin(), v.end()});
        }
        dBatchStep(copies.id, 250);
        EXPECT_EQ(dBatchCountBad(copies.id), 0);
        for (int i = 0; i < copies_at_once; ++i)
            for (const int quantity : {dBatchPositions, dBatchVelocities, dBatchConstraintForces})
                for (const T x : copies.read(quantity, i, 1)) hash = hashed(hash, x);
    }
    dRobotModelDestroy(model);
    return hash;
}

TEST(BatchBits, of_asked_pairs_are_golden)
{
    if (sizeof(dReal) == 4) GTEST_SKIP() << "step sizes and states pass through dReal";
    const std::uint64_t doubles = hash_of_stacks<double>(6), floats = hash_of_stacks<float>(6);
    EXPECT_TRUE(golden::is_golden("batch/stacks/double", doubles));
    EXPECT_TRUE(golden::is_golden("batch/stacks/float", floats));
    EXPECT_EQ(hash_of_stacks<double>(1), doubles);
    EXPECT_EQ(hash_of_stacks<float>(3, 2), floats);
}

}  // namespace
}  // namespace epode::tests
