// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Friction of contacts against turning: torsion about the normal, rolling about the tangents, each bounded by a length times the normal
// force. Closed forms of a ball of radius r: w' = -5/2 mu_t g / r^2 of spinning, v' = -5/7 mu_r g / r of rolling; a slope holds it up to
// tan a = mu_r / r.
#include "golden/golden.h"
#include "models.h"

#include <ode/ext.h>

#include <algorithm>

namespace epode::tests {
namespace {

constexpr double kGravity = 9.81, kRadius = 0.1, kTorsion = 0.004, kRolling = 0.002;

std::string ball(const std::string& friction, int condim, const std::string& gravity = "0 0 -9.81")
{
    return "<mujoco><option gravity='" + gravity +
           "'/><worldbody><geom type='plane' size='9 9 1' friction='0 0 0'/><body pos='0 0 0.1'><freejoint/>"
           "<geom size='0.1' mass='2' condim='" +
           std::to_string(condim) + "' friction='" + friction + "'/></body></worldbody></mujoco>";
}

struct Model {
    explicit Model(const std::string& text) : id(model_of(text.c_str())) {}
    ~Model() { dRobotModelDestroy(id); }
    Model(const Model&) = delete;
    Model& operator=(const Model&) = delete;
    dRobotModelID id;
};

class BatchTurning : public testing::Test {
  protected:
    BatchTurning() { dInitODE2(0); }
    ~BatchTurning() override { dCloseODE(); }
};

TEST_F(BatchTurning, spinning_ball_slows_by_its_closed_form)
{
    const Model model(ball("1 0.004 0.002", 4));
    Copies<double> copies(model.id, 1, dReal(0.002), dReal(1e-12));
    copies.write(dBatchVelocities, {0, 0, 0, 0, 0, 3});
    const double slows = 2.5 * kTorsion * kGravity / (kRadius * kRadius);
    dBatchStep(copies.id, 100);
    const auto v = copies.read(dBatchVelocities);
    EXPECT_NEAR(v[5], 3 - slows * 0.2, 1e-6);
    for (int k = 0; k < 5; ++k) EXPECT_NEAR(v[size_t(k)], 0, 1e-9);
    EXPECT_NEAR(copies.read(dBatchConstraintForces)[3], -kTorsion * 2 * kGravity, 1e-6);
    dBatchStep(copies.id, 100);
    EXPECT_NEAR(copies.read(dBatchVelocities)[5], 0, 1e-9);
}

// Whose sliding friction is 0: four points of its rim bear it.
TEST_F(BatchTurning, spinning_disc_slows_by_its_closed_form)
{
    const Model model(
        "<mujoco><worldbody><geom type='plane' size='9 9 1' friction='0 0 0'/><body pos='0 0 "
        "0.05'><freejoint/>"
        "<geom type='cylinder' size='0.2 0.05' mass='3' condim='4' friction='0 0.01 "
        "0'/></body></worldbody></mujoco>");
    Copies<double> copies(model.id, 1, dReal(0.002), dReal(1e-12), 1, 2000);
    copies.write(dBatchVelocities, {0, 0, 0, 0, 0, 3});
    dBatchStep(copies.id, 100);
    EXPECT_NEAR(copies.read(dBatchVelocities)[5], 3 - 0.2 * 2 * 0.01 * kGravity / (0.2 * 0.2), 1e-4);
}

TEST_F(BatchTurning, without_condim_nothing_stops_spinning_and_rolling)
{
    const Model three(ball("1 0.004 0.002", 3)), four(ball("1 0 0.002", 4));
    for (const dRobotModelID model : {three.id, four.id}) {
        Copies<double> copies(model, 1, dReal(0.002), dReal(1e-12));
        copies.write(dBatchVelocities, {0.5, 0, 0, 0, 5, 3});
        dBatchStep(copies.id, 200);
        const auto v = copies.read(dBatchVelocities), turn = copies.read(dBatchLinkVelocities);
        EXPECT_NEAR(v[0], 0.5, 1e-6);
        EXPECT_NEAR(turn[6 + 2], 3, 1e-6);
    }
}

TEST_F(BatchTurning, rolling_ball_slows_and_stops)
{
    const Model model(ball("1 0 0.002", 6));
    constexpr int kWays = 8;
    Copies<double> copies(model.id, kWays, dReal(0.002), dReal(1e-12));
    for (int i = 0; i < kWays; ++i) {
        const double way = 2 * M_PI * i / kWays, x = std::cos(way), y = std::sin(way);
        copies.write_one(dBatchVelocities, i, {0.3 * x, 0.3 * y, 0, -3 * y, 3 * x, 0});
    }
    const double slows = 5.0 / 7 * kRolling * kGravity / kRadius;
    dBatchStep(copies.id, 500);
    const auto v = copies.read(dBatchVelocities);
    for (size_t i = 0; i < kWays; ++i)
        EXPECT_NEAR(std::hypot(v[6 * i], v[6 * i + 1]), 0.3 - slows, 1e-5) << i;
    dBatchStep(copies.id, 1200);
    for (const double x : copies.read(dBatchVelocities)) EXPECT_NEAR(x, 0, 1e-8);
}

// Up to tan a = mu_r / r = 0.02 it stays, in every direction; beyond, it rolls off with the difference.
TEST_F(BatchTurning, slope_holds_up_to_the_rolling_friction)
{
    for (int i = 0; i < 8; ++i) {
        const double way = 2 * M_PI * i / 8 + 0.1;
        for (const double tangent : {0.0199, 0.0201, 0.05}) {
            const double fall = kGravity * tangent;
            const Model model(ball("1 0 0.002", 6,
                                   std::to_string(fall * std::cos(way)) + " " +
                                       std::to_string(fall * std::sin(way)) + " -9.81"));
            Copies<double> copies(model.id, 1, dReal(0.002), dReal(1e-13), 1, 2000);
            dBatchStep(copies.id, 250);
            const auto v = copies.read(dBatchVelocities);
            const double want = 5.0 / 7 * kGravity * std::max(0.0, tangent - kRolling / kRadius) * 0.5;
            EXPECT_NEAR(std::hypot(v[0], v[1]), want, 2e-6) << i << ' ' << tangent;
        }
    }
}

// Of a pair the larger lengths count, and the larger condim, as in MuJoCo.
TEST_F(BatchTurning, pairs_take_the_larger_numbers)
{
    std::string text = ball("1 0.001 0", 4);
    text.replace(text.find("friction='0 0 0'"), 16, "friction='1'");  // its torsion is 0.005, by default
    const Model model(text);
    Copies<double> copies(model.id, 1, dReal(0.002));
    double friction = 0;
    EXPECT_EQ(dBatchReadParameter(copies.id, dBatchTorsionalFrictions, 0, 1, &friction), 1);
    EXPECT_EQ(friction, 0.005);
    EXPECT_EQ(dBatchReadParameter(copies.id, dBatchRollingFrictions, 0, 1, &friction), 1);
    EXPECT_EQ(friction, 0);
    friction = 0.01;
    EXPECT_EQ(dBatchWriteParameter(copies.id, dBatchRollingFrictions, 0, 1, &friction), 0);
    EXPECT_EQ(dBatchReadParameter(copies.id, dBatchRollingFrictions, 0, 1, &friction), 1);
    EXPECT_EQ(friction, 0);
}

TEST_F(BatchTurning, copies_have_frictions_of_their_own)
{
    const Model model(ball("1 0.004 0.002", 6));
    Copies<double> copies(model.id, 3, dReal(0.002), dReal(1e-12));
    const double torsions[] = {0, 0.002, 0.004}, rollings[] = {0.002, 0.001, 0};
    ASSERT_EQ(dBatchGetParameterSize(copies.id, dBatchTorsionalFrictions), 1);
    EXPECT_EQ(dBatchWriteParameter(copies.id, dBatchTorsionalFrictions, 0, 3, torsions), 1);
    EXPECT_EQ(dBatchWriteParameter(copies.id, dBatchRollingFrictions, 0, 3, rollings), 1);
    const double negative = -0.1;
    EXPECT_EQ(dBatchWriteParameter(copies.id, dBatchTorsionalFrictions, 0, 1, &negative), 0);
    for (int i = 0; i < 3; ++i) copies.write_one(dBatchVelocities, i, {0.3, 0, 0, 0, 3, 3});
    dBatchStep(copies.id, 50);
    const auto v = copies.read(dBatchVelocities), turn = copies.read(dBatchLinkVelocities);
    for (size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(v[6 * i], 0.3 - 5.0 / 7 * rollings[i] * kGravity / kRadius * 0.1, 1e-5);
        EXPECT_NEAR(turn[12 * i + 8], 3 - 2.5 * torsions[i] * kGravity / (kRadius * kRadius) * 0.1, 1e-5);
    }
}

// dWorldStep bounds the two axes of rolling each by itself: the ball rolls along one of them.
void touch_with_turning(void* data, dGeomID a, dGeomID b)
{
    auto& contacts = *static_cast<std::pair<dWorldID, dJointGroupID>*>(data);
    if (dGeomGetClass(a) == dPlaneClass) std::swap(a, b);
    dContact contact{};
    if (dCollide(a, b, 1, &contact.geom, sizeof contact.geom) == 0) return;
    for (int k = 0; k < 3; ++k) contact.geom.pos[k] += contact.geom.normal[k] * contact.geom.depth / 2;
    contact.surface.mode = dContactApprox1 | dContactRolling | dContactAxisDep | dContactFDir1;
    contact.surface.mu = contact.surface.mu2 = 1;
    contact.fdir1[0] = 1;
    contact.surface.rho = contact.surface.rho2 = dReal(kRolling), contact.surface.rhoN = dReal(kTorsion);
    dJointAttach(dJointCreateContact(contacts.first, contacts.second, &contact),
                 dGeomGetBody(contact.geom.g1), dGeomGetBody(contact.geom.g2));
}

TEST_F(BatchTurning, step_as_worlds_do)
{
    if (sizeof(dReal) == 4) GTEST_SKIP() << "differences of this size are rounding in floats";
    const Model model(ball("1 0.004 0.002", 6));
    const dReal h = dReal(0.001);
    Dice dice(5);
    for (int i = 0; i < 100; ++i) {
        const double speed = i % 3 == 0 ? 1e-3 : 0.5;
        const std::vector<double> q{0, 0, dice.between(0.0999, 0.1), 1, 0, 0, 0},
            v{dice.between(-speed, speed), 0, 0, 0, dice.between(-5, 5) * speed, dice.between(-5, 5) * speed};
        Copies<double> copies(model.id, 1, h, dReal(1e-13), 1, 20000, dReal(1e6));
        copies.write(dBatchPositions, q), copies.write(dBatchVelocities, v);
        dBatchStep(copies.id, 1);
        const dWorldID world = dWorldCreate();
        const dSpaceID space = dSimpleSpaceCreate(nullptr);
        const dJointGroupID group = dJointGroupCreate(0);
        dWorldSetGravity(world, 0, 0, dReal(-kGravity)), dWorldSetERP(world, dReal(0.2)),
            dWorldSetCFM(world, 0), dWorldSetFrictionCone(world, 1);
        const dRobotID robot = dRobotCreate(world, space, model.id, nullptr, nullptr);
        const auto positions = reals_of(q), velocities = reals_of(v);
        dRobotSetPositions(robot, positions.data(), 7), dRobotSetVelocities(robot, velocities.data(), 6);
        std::pair<dWorldID, dJointGroupID> contacts{world, group};
        dSpaceCollide(space, &contacts, touch_with_turning);
        dWorldStep(world, h);
        const dBodyID body = dRobotGetBody(robot, 1);
        const auto moved = copies.read(dBatchVelocities), turned = copies.read(dBatchLinkVelocities);
        for (int k = 0; k < 3; ++k) {
            EXPECT_NEAR(moved[size_t(k)], dBodyGetLinearVel(body)[k], 1e-9) << i;
            EXPECT_NEAR(turned[size_t(6 + k)], dBodyGetAngularVel(body)[k], 1e-8) << i;
        }
        dRobotDestroy(robot), dJointGroupDestroy(group), dSpaceDestroy(space), dWorldDestroy(world);
    }
}

std::string turning_walker()
{
    std::string text = kWalker;
    const std::string from = "friction=\"0.7\"/></default>";
    return text.replace(text.find(from), from.size(), "friction=\"0.7 0.02 0.01\" condim=\"6\"/></default>");
}

template <typename T>
void disturb_turning(Copies<T>& copies, dRobotModelID model, int copy, unsigned seed)
{
    Dice dice(seed);
    auto q = any_positions(model, dice), v = dice.many(14, -1, 1), c = dice.many(5, -1, 1);
    q[2] = dice.between(0.4, 0.6);
    copies.write_one(dBatchPositions, copy, {q.begin(), q.end()}),
        copies.write_one(dBatchVelocities, copy, {v.begin(), v.end()});
    copies.write_one(dBatchControls, copy, {c.begin(), c.end()});
}

// Of whatever touches: torques stay within their bounds, and act on dofs as observed.
TEST_F(BatchTurning, torques_stay_within_their_bounds)
{
    const Model model(turning_walker());
    std::string text = turning_walker();
    text.replace(text.find("conaffinity=\"1\""), 15, "conaffinity=\"0\"");
    const Model bare(text);
    const dReal h = dReal(0.004);
    Copies<double> copies(model.id, 16, h, dReal(1e-11), 1, 5000), free(bare.id, 16, h, dReal(1e-11));
    for (int i = 0; i < 16; ++i) disturb_turning(copies, model.id, i, unsigned(i));
    const auto slots = size_t(copies.size(dBatchConstraintForces));
    int torques = 0, at_bounds = 0;
    for (int step = 0; step < 60; ++step) {
        free.write(dBatchPositions, copies.read(dBatchPositions)),
            free.write(dBatchVelocities, copies.read(dBatchVelocities)),
            free.write(dBatchControls, copies.read(dBatchControls));
        dBatchStep(copies.id, 1);
        free.write(dBatchAppliedForces, copies.read(dBatchVelocityConstraintForces));
        dBatchStep(free.id, 1);
        const auto f = copies.read(dBatchConstraintForces), v = copies.read(dBatchVelocities),
                   want = free.read(dBatchVelocities);
        for (size_t i = 0; i < v.size(); ++i) EXPECT_NEAR(v[i], want[i], 1e-8);
        const size_t contacts = (slots - 8) / 6;  // 8 limits stand between
        for (size_t i = 0; i < 16; ++i)
            for (size_t k = 0; k < contacts; ++k) {
                const double *its = &f[slots * i + 3 * k], *turn = &f[slots * i + 3 * contacts + 8 + 3 * k];
                const double rolling = std::hypot(turn[1], turn[2]);
                EXPECT_LE(std::fabs(turn[0]), 0.02 * its[0] + 1e-6);
                EXPECT_LE(rolling, 0.01 * its[0] + 1e-6);
                torques += rolling > 1e-6, at_bounds += rolling > 0.00999 * its[0] && its[0] > 1;
            }
    }
    EXPECT_GT(torques, 200);
    EXPECT_GT(at_bounds, 100);
}

template <typename T>
std::uint64_t hash_of_turning(int copies_at_once)
{
    const Model model(turning_walker());
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (int first = 0; first < 24; first += copies_at_once) {
        Copies<T> copies(model.id, copies_at_once, dReal(0.004));
        for (int i = 0; i < copies_at_once; ++i)
            disturb_turning(copies, model.id, i, unsigned(500 + first + i));
        dBatchStep(copies.id, 400);
        for (int i = 0; i < copies_at_once; ++i)
            for (const int quantity : {dBatchPositions, dBatchVelocities})
                for (const T x : copies.read(quantity, i, 1)) hash = hashed(hash, x);
    }
    return hash;
}

TEST(BatchBits, of_turning_contacts_are_golden)
{
    if (sizeof(dReal) == 4) GTEST_SKIP() << "step sizes and states pass through dReal";
    EXPECT_TRUE(golden::is_golden("batch/turning/double", hash_of_turning<double>(24)));
    EXPECT_TRUE(golden::is_golden("batch/turning/float", hash_of_turning<float>(24)));
    EXPECT_EQ(hash_of_turning<double>(1), hash_of_turning<double>(24));
    EXPECT_EQ(hash_of_turning<float>(1), hash_of_turning<float>(24));
}

}  // namespace
}  // namespace epode::tests
