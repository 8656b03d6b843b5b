// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Loops: closed forms of a four-bar linkage, its energy, one step as dWorldStep makes it, contacts and limits of links within a loop,
// what is observed of its forces. Bent couplings: a polynomial of another joint held over time.
#include "golden/golden.h"
#include "models.h"

#include <ode/ext.h>

#include <algorithm>

namespace epode::tests {
namespace {

// Bars of `crank`, 0.5 and 0.3 m on pivots 0.5 m apart. Of 0.3 m it is a parallelogram, whose crank and rocker turn alike; a shorter crank
// goes round and never stands in line with the coupler and the ground.
std::string four_bar(double crank = 0.3, const std::string& inside = "", const std::string& axis = "0 1 0")
{
    const std::string hinge = "axis='" + axis + "'/>", top = "0 0 " + std::to_string(crank),
                      end = "0.5 0 " + std::to_string(0.3 - crank);
    return "<mujoco model='fourbar'><compiler angle='radian'/><default><geom contype='0' "
           "conaffinity='0'/></default><worldbody>" +
           inside + "<body name='crank' pos='0 0 1'><joint name='crank' " + hinge +
           "<geom type='capsule' fromto='0 0 0 " + top + "' size='0.02'/><body name='coupler' pos='" + top +
           "'><joint name='coupler' " + hinge + "<geom name='coupler' type='capsule' fromto='0 0 0 " + end +
           "' size='0.02'/><body name='rocker' pos='" + end + "'><joint name='rocker' " + hinge +
           "<geom type='capsule' fromto='0 0 0 0 0 -0.3' size='0.02'/></body></body></body></worldbody>"
           "<equality><connect name='ground' body1='rocker' anchor='0 0 -0.3'/></equality></mujoco>";
}

// A closed chain in space: a platform on two legs of a ball, a slider and a ball each, with an arm that is welded to the world by its end.
const char* const kSpatial = R"(<mujoco model="spatial"><compiler angle="radian"/><worldbody>
<body name="base" pos="0 0 1"><freejoint/><inertial pos="0.02 0 0.01" mass="2" diaginertia="0.03 0.02 0.04"/>
<body name="one" pos="0.3 0 0"><joint name="o" type="ball"/><inertial pos="0 0 -0.2" mass="0.4" diaginertia="0.01 0.01 0.002"/>
<body name="foot" pos="0 0 -0.4"><joint name="s" type="slide" axis="0 0 1" damping="0.5"/><inertial pos="0 0 0" mass="0.2" diaginertia="0.001 0.001 0.001"/></body></body>
<body name="two" pos="-0.3 0 0"><joint name="p" axis="0 1 0"/><inertial pos="0 0 -0.2" mass="0.4" diaginertia="0.01 0.01 0.002"/>
<body name="shin" pos="0 0 -0.4"><joint name="k" axis="1 0 0" frictionloss="0.05"/><joint name="l" axis="0 1 0" limited="true" range="-0.02 0.5"/><inertial pos="0 0 -0.1" mass="0.3" diaginertia="0.004 0.004 0.001"/></body></body></body>
<body name="post" pos="-0.3 0.1 0.4"><joint name="q" type="ball"/><inertial pos="0 0 0.1" mass="0.6" diaginertia="0.004 0.005 0.003"/></body></worldbody>
<equality><connect name="ground" body1="foot" anchor="0 0 -0.05"/><weld name="tied" body1="shin" body2="post"/></equality></mujoco>)";

class BatchLoops : public testing::Test {
  protected:
    BatchLoops() { dInitODE2(0); }
    ~BatchLoops() override
    {
        for (const dRobotModelID model : models_) dRobotModelDestroy(model);
        dCloseODE();
    }
    dRobotModelID load(const std::string& text)
    {
        models_.push_back(model_of(text.c_str()));
        return models_.back();
    }
    // How far its loops are open, of a copy's positions.
    static double gap(dRobotModelID model, const std::vector<double>& positions)
    {
        const auto q = reals_of(positions);
        std::vector<dReal> errors(size_t(dRobotModelGetConstraints(model, q.data(), nullptr, nullptr, 0)));
        dRobotModelGetConstraints(model, q.data(), errors.data(), nullptr, int(errors.size()));
        double worst = 0;
        for (const dReal x : errors) worst = std::max(worst, std::fabs(double(x)));
        return worst;
    }

  private:
    std::vector<dRobotModelID> models_;
};

// Of a parallelogram that hangs freely: one degree of freedom, with the inertia of both cranks and the coupler that moves with them.
TEST_F(BatchLoops, parallelogram_swings_as_its_closed_form)
{
    const dRobotModelID model = load(four_bar());
    std::vector<double> masses(4);
    Copies<double> copies(model, 1, dReal(0.0005));
    dBatchReadParameter(copies.id, dBatchMasses, 0, 1, masses.data());
    double angle = 2.3, rate = 0;
    copies.write(dBatchPositions, {angle, -angle, angle});
    const double r = 0.3, g = 9.81;
    // Of each crank about its pivot, from the capsule: cylinder and two half balls.
    const double length = 0.3, radius = 0.02, density = 1000;
    const double cylinder = M_PI * radius * radius * length * density,
                 ball = 4.0 / 3 * M_PI * radius * radius * radius * density;
    ASSERT_NEAR(masses[1], cylinder + ball, 1e-9);
    const double across = cylinder * (length * length / 12 + radius * radius / 4) +
                          ball * (2 * radius * radius / 5 + length * length / 4 + 3 * length * radius / 8);
    const double crank = across + masses[1] * r * r / 4;
    const double inertia = 2 * crank + masses[2] * r * r,
                 pull = (masses[1] + masses[3]) * g * r / 2 + masses[2] * g * r;
    const double h = 1e-6;
    for (int i = 0; i < 1000000; ++i) rate += h * pull * std::sin(angle) / inertia, angle += h * rate;
    dBatchStep(copies.id, 2000);
    const auto q = copies.read(dBatchPositions), v = copies.read(dBatchVelocities);
    EXPECT_NEAR(q[0], angle, 0.02);
    EXPECT_NEAR(v[0], rate, 0.05);
    EXPECT_NEAR(q[1], -q[0], 1e-5);
    EXPECT_NEAR(q[2], q[0], 1e-5);
    EXPECT_NEAR(v[0] + v[1], 0, 1e-3);
}

TEST_F(BatchLoops, stay_closed_without_drift)
{
    const dRobotModelID bars = load(four_bar(0.15)), spatial = load(kSpatial);
    for (const dRobotModelID model : {bars, spatial}) {
        Copies<double> copies(model, 4, dReal(0.002));
        Copies<float> floats(model, 4, dReal(0.002));
        const auto size = size_t(copies.size(dBatchPositions));
        for (int i = 0; i < 4; ++i) {
            std::vector<double> v(size_t(copies.size(dBatchVelocities)), 0);
            v[model == bars ? 0 : 6] = 1 + i;
            copies.write_one(dBatchVelocities, i, v),
                floats.write_one(dBatchVelocities, i, {v.begin(), v.end()});
        }
        for (int k = 0; k < 100; ++k) {
            dBatchStep(copies.id, 50), dBatchStep(floats.id, 50);
            for (int i = 0; i < 4; ++i) {
                const auto q = copies.read(dBatchPositions, i, 1);
                const auto f = floats.read(dBatchPositions, i, 1);
                ASSERT_EQ(q.size(), size);
                EXPECT_LT(gap(model, q), 1e-4) << k << ' ' << i;
                EXPECT_LT(gap(model, {f.begin(), f.end()}), 1e-4) << k << ' ' << i;
            }
        }
        EXPECT_EQ(dBatchCountBad(copies.id) + dBatchCountBad(floats.id), 0);
    }
}

// An open one closes at the speed that corrections may have, and stays closed.
TEST_F(BatchLoops, open_ones_close)
{
    const dRobotModelID model = load(four_bar(0.15));
    Copies<double> copies(model, 1, dReal(0.002));
    copies.write(dBatchPositions, {0.2, 0.1, -0.3});
    EXPECT_GT(gap(model, copies.read(dBatchPositions)), 0.05);
    dBatchStep(copies.id, 100);
    EXPECT_LT(gap(model, copies.read(dBatchPositions)), 1e-5);
}

double energy(Copies<double>& copies)
{
    const auto v = copies.read(dBatchLinkVelocities), inertia = copies.read(dBatchLinkInertias),
               com = copies.read(dBatchCentreOfMass);
    double sum = 0, mass = 0;
    for (size_t i = 1; i < v.size() / 6; ++i) {
        const double *w = &v[6 * i], *u = w + 3, *j = &inertia[10 * i], *h = j + 6;
        const double m = j[9];
        sum += 0.5 * m * (u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
        sum += 0.5 * (j[0] * w[0] * w[0] + j[1] * w[1] * w[1] + j[2] * w[2] * w[2]) + j[3] * w[0] * w[1] +
               j[4] * w[0] * w[2] + j[5] * w[1] * w[2];
        sum += u[0] * (w[1] * h[2] - w[2] * h[1]) + u[1] * (w[2] * h[0] - w[0] * h[2]) +
               u[2] * (w[0] * h[1] - w[1] * h[0]);
        mass += m;
    }
    return sum + 9.81 * mass * com[2];
}

TEST_F(BatchLoops, energy_of_a_passive_four_bar_is_bounded)
{
    const dRobotModelID model = load(four_bar());
    double swing[2];
    for (const int fine : {0, 1}) {
        Copies<double> copies(model, 1, dReal(fine ? 0.0005 : 0.002));
        copies.write(dBatchPositions, {2, -2, 2});  // it hangs and swings
        const double first = energy(copies);
        double low = first, high = first;
        for (int i = 0; i < 500; ++i) {
            dBatchStep(copies.id, fine ? 40 : 10);
            low = std::min(low, energy(copies)), high = std::max(high, energy(copies));
        }
        swing[fine] = std::max(high - first, first - low);
    }
    EXPECT_LT(swing[0], 0.15);  // J, of some 10 that change between heights and speeds
    EXPECT_LT(swing[1], 0.5 * swing[0]);
}

std::vector<double> step_of_world(dRobotModelID model, const std::vector<double>& q,
                                  const std::vector<double>& v, dReal h)
{
    const dWorldID world = dWorldCreate();
    const dSpaceID space = dSimpleSpaceCreate(nullptr);
    dWorldSetGravity(world, 0, 0, dReal(-9.81)), dWorldSetERP(world, dReal(0.2)), dWorldSetCFM(world, 0);
    const dRobotID robot = dRobotCreate(world, space, model, nullptr, nullptr);
    const auto at = reals_of(q), rates = reals_of(v);
    dRobotSetPositions(robot, at.data(), int(at.size())),
        dRobotSetVelocities(robot, rates.data(), int(rates.size()));
    dWorldStep(world, h);
    std::vector<dReal> out(v.size());
    dRobotGetVelocities(robot, out.data(), int(out.size()));
    dRobotDestroy(robot), dSpaceDestroy(space), dWorldDestroy(world);
    return {out.begin(), out.end()};
}

TEST_F(BatchLoops, step_as_worlds_do)
{
    if (sizeof(dReal) == 4) GTEST_SKIP() << "differences of this size are rounding in floats";
    const dReal h = dReal(1e-4);
    std::string rigid = kSpatial;
    for (const char* part : {"<joint name=\"l\" axis=\"0 1 0\" limited=\"true\" range=\"-0.02 0.5\"/>",
                             " frictionloss=\"0.05\""})
        rigid.replace(rigid.find(part), std::strlen(part), "");
    for (const dRobotModelID model : {load(four_bar()), load(four_bar(0.15, "", "0 1 0.001")), load(rigid)}) {
        // Closed states: those that a motion passes, once short steps at rest have closed what it left open.
        Copies<double> moving(model, 1, dReal(0.002), dReal(1e-12)),
            closing(model, 1, dReal(1e-6), dReal(1e-12), 1, 200, dReal(1e6)),
            copies(model, 1, h, dReal(1e-13), 1, 20000);
        std::vector<double> v(size_t(moving.size(dBatchVelocities)), 0);
        const std::vector<double> rest(v);
        v[0] = 2, v.back() = 1;
        moving.write(dBatchVelocities, v);
        for (int i = 0; i < 30; ++i) {
            dBatchStep(moving.id, 10);
            closing.write(dBatchPositions, moving.read(dBatchPositions));
            for (int k = 0; k < 10; ++k) closing.write(dBatchVelocities, rest), dBatchStep(closing.id, 1);
            const auto q = closing.read(dBatchPositions);
            EXPECT_LT(gap(model, q), 1e-13);
            copies.write(dBatchPositions, q), copies.write(dBatchVelocities, rest);
            dBatchStep(copies.id, 1);
            const auto want = step_of_world(model, q, rest, h), its = copies.read(dBatchVelocities);
            for (size_t k = 0; k < v.size(); ++k) EXPECT_NEAR(its[k], want[k], 1e-9) << i << ' ' << k;
        }
    }
}

// What is observed of the loops' forces is what moves a model without them.
TEST_F(BatchLoops, forces_are_what_is_observed)
{
    std::string bare = kSpatial;
    const size_t first = bare.find("<equality>"), end = bare.find("</equality>") + 11;
    bare.replace(first, end - first, "");
    const dRobotModelID model = load(kSpatial), open = load(bare);
    Copies<double> copies(model, 1, dReal(0.002), dReal(1e-12), 1, 5000),
        other(open, 1, dReal(0.002), dReal(1e-12), 1, 5000);
    std::vector<double> v(size_t(copies.size(dBatchVelocities)), 0);
    v[6] = 2;
    copies.write(dBatchVelocities, v);
    int stopped = 0;
    for (int i = 0; i < 200; ++i) {
        other.write(dBatchPositions, copies.read(dBatchPositions)),
            other.write(dBatchVelocities, copies.read(dBatchVelocities));
        dBatchStep(copies.id, 1);
        const auto all = copies.read(dBatchVelocityConstraintForces),
                   rows = copies.read(dBatchConstraintForces);
        // Its own limits and dry friction are among them: what is left is the loops'.
        std::vector<double> loops = all;
        const size_t k = 11, l = 12;  // velocities of k, with dry friction, and l, with a limit
        const double at = other.read(dBatchPositions)[14];
        loops[k] -= rows[1], loops[l] -= (at - -0.02 < 0.5 - at ? 1 : -1) * rows[0];
        stopped += rows[0] > 0;
        other.write(dBatchAppliedForces, loops);
        dBatchStep(other.id, 1);
        const auto want = other.read(dBatchVelocities), its = copies.read(dBatchVelocities);
        // The base's angular velocity is read in its axes, which the loops have moved a little to close.
        for (size_t n = 0; n < want.size(); ++n)
            EXPECT_TRUE((n >= 3 && n < 6) || std::fabs(its[n] - want[n]) < 1e-9) << i << ' ' << n;
        EXPECT_NEAR(std::hypot(its[3], its[4], its[5]), std::hypot(want[3], want[4], want[5]), 1e-9);
    }
    EXPECT_GT(stopped, 0);
}

// The coupler lies on a ball: the rod's weight is borne there, and the loop stays closed.
TEST_F(BatchLoops, contacts_within_a_loop_hold)
{
    const std::string floor = "<geom type='plane' size='9 9 1' pos='0 0 1.1' contype='1' conaffinity='1'/>";
    std::string text = four_bar(0.3, floor);
    const std::string from = "<geom name='coupler' ";
    text.replace(text.find(from), from.size(), from + "contype='1' conaffinity='1' ");
    const dRobotModelID model = load(text);
    Copies<double> copies(model, 1, dReal(0.002), dReal(1e-10), 1, 2000);
    copies.write(dBatchVelocities, {1, -1, 1});
    dBatchStep(copies.id, 1500);
    const auto q = copies.read(dBatchPositions), v = copies.read(dBatchVelocities);
    EXPECT_NEAR(0.3 * std::cos(q[0]), 0.12, 2e-3);  // the coupler's axis stands its radius above the floor
    for (const double x : v) EXPECT_NEAR(x, 0, 1e-6);
    EXPECT_LT(gap(model, q), 1e-5);
    EXPECT_LT(copies.read(dBatchResidual)[0], 1e-8);
    // Virtual work about the pivots: what presses at the coupler times r sin a is what the weights pull.
    std::vector<double> masses(4);
    dBatchReadParameter(copies.id, dBatchMasses, 0, 1, masses.data());
    const auto f = copies.read(dBatchConstraintForces);
    const double normal = f[0] + f[3];
    const double friction = std::fabs(f[1] + f[4]) + std::fabs(f[2] + f[5]);
    const double weight = 9.81 * (masses[2] + (masses[1] + masses[3]) / 2);
    EXPECT_NEAR(normal, weight, friction / std::tan(std::fabs(q[0])) + 1e-4);
}

TEST_F(BatchLoops, bent_couplings_hold_over_time)
{
    const dRobotModelID model = load(
        "<mujoco><compiler angle='radian'/><worldbody><body><joint name='a' axis='0 1 0' "
        "ref='0.1'/><inertial pos='0.2 0 0' mass='1' diaginertia='0.01 0.02 0.02'/>"
        "<body pos='0.4 0 0'><joint name='b' axis='1 0 0' ref='-0.2'/><inertial pos='0 0.1 0' mass='0.5' "
        "diaginertia='0.01 0.01 0.01'/></body></body>"
        "<body pos='1 0 0'><joint name='c' axis='0 1 0'/><inertial pos='0.1 0 0' mass='0.5' "
        "diaginertia='0.01 0.01 0.01'/></body></worldbody>"
        "<equality><joint joint1='b' joint2='a' polycoef='0.1 0.5 0.3 -0.4 0.2'/><joint joint1='c' "
        "joint2='b' polycoef='0 0 1'/></equality></mujoco>");
    Copies<double> copies(model, 1, dReal(0.002), dReal(1e-12), 1, 5000);
    copies.write(dBatchPositions, {0.1, -0.1, 0.01});
    double worst = 0, far = 0;
    for (int i = 0; i < 2000; ++i) {
        dBatchStep(copies.id, 1);
        const auto q = copies.read(dBatchPositions), v = copies.read(dBatchVelocities);
        const double x = q[0] - 0.1, y = q[1] + 0.2;
        const double b = 0.1 + x * (0.5 + x * (0.3 + x * (-0.4 + x * 0.2)));
        worst = std::max({worst, std::fabs(y - b), std::fabs(q[2] - y * y)});
        far = std::max(far, std::fabs(x));
    }
    EXPECT_LT(worst, 5e-3);
    EXPECT_GT(far, 0.5);
}

template <typename T>
std::uint64_t hash_of_loops(dRobotModelID model, int copies_at_once)
{
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (int first = 0; first < 12; first += copies_at_once) {
        Copies<T> copies(model, copies_at_once, dReal(0.002));
        for (int i = 0; i < copies_at_once; ++i) {
            Dice dice(unsigned(70 + first + i));
            const auto v = dice.many(copies.size(dBatchVelocities), -1, 1);
            copies.write_one(dBatchVelocities, i, {v.begin(), v.end()});
        }
        dBatchStep(copies.id, 200);
        for (int i = 0; i < copies_at_once; ++i)
            for (const int quantity : {dBatchPositions, dBatchVelocities, dBatchConstraintForces})
                for (const T x : copies.read(quantity, i, 1)) hash = hashed(hash, x);
    }
    return hash;
}

TEST(BatchBits, of_loops_are_golden)
{
    if (sizeof(dReal) == 4) GTEST_SKIP() << "step sizes and states pass through dReal";
    const dRobotModelID model = model_of(kSpatial);
    EXPECT_TRUE(golden::is_golden("batch/loops/double", hash_of_loops<double>(model, 12)));
    EXPECT_TRUE(golden::is_golden("batch/loops/float", hash_of_loops<float>(model, 12)));
    EXPECT_EQ(hash_of_loops<double>(model, 1), hash_of_loops<double>(model, 12));
    EXPECT_EQ(hash_of_loops<float>(model, 1), hash_of_loops<float>(model, 12));
    dRobotModelDestroy(model);
}

}  // namespace
}  // namespace epode::tests
