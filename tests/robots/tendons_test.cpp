// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Spatial tendons and filters of actuators: lengths of strings with closed forms, moments by differences, and motions of
// what hangs on them. scripts/robots-corpus compares lengths and moments with MuJoCo's.
#include <epode/robots.h>
#include <gtest/gtest.h>
#include <ode/ext.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "robot_in_world.h"
#include "robots/load.h"
#include "robots/write/write.h"
#include "same_model.h"

namespace {

using namespace epode::robots;

constexpr bool kSingle = sizeof(dReal) == 4;

std::string file_of(const std::string& bodies, const std::string& actions)
{
    return "<mujoco><compiler angle='radian'/><worldbody>" + bodies + "</worldbody>" + actions + "</mujoco>";
}

std::string string_over(const std::string& parts, const std::string& attributes = "")
{
    return "<tendon><spatial name='string' " + attributes + ">" + parts + "</spatial></tendon>";
}

const std::string kSlider =
    "<body name='load'><joint name='down' type='slide' axis='0 0 -1'/><geom size='0.05' mass='2'/>"
    "<site name='hook'/></body>";

class Tendons : public RobotInWorld {
  protected:
    Tendons() { dWorldSetGravity(world, 0, 0, dReal(-10)); }
    void step(double h, int count = 1)
    {
        for (int i = 0; i < count; ++i) {
            EXPECT_GT(dRobotAddForces(robot, dReal(h)), 0);
            dWorldStep(world, dReal(h));
        }
    }
    std::vector<dReal> positions() const
    {
        std::vector<dReal> out(size_t(dRobotModelGetNumPositions(model)));
        dRobotGetPositions(robot, out.data(), int(out.size()));
        return out;
    }
    double length_at(const std::vector<dReal>& at, int tendon = 0) const
    {
        std::vector<dReal> lengths(size_t(tendon) + 1);
        dRobotModelGetTendons(model, at.data(), lengths.data(), nullptr, int(lengths.size()));
        return double(lengths.back());
    }
    double length() const { return length_at(positions()); }
    double height() const { return double(dBodyGetPosition(dRobotGetBody(robot, 1))[2]); }
};

double length_of(const std::string& bodies, const std::string& parts)
{
    const std::string text = file_of(bodies + kSlider, string_over(parts));
    const dRobotModelID model = dRobotModelLoadText("robot.xml", text.data(), text.size(), nullptr);
    EXPECT_EQ(dRobotModelHasErrors(model), 0);
    const dReal at = 0;
    dReal length = -1;
    EXPECT_EQ(dRobotModelGetTendons(model, &at, &length, nullptr, 1), 1);
    dRobotModelDestroy(model);
    return double(length);
}

std::string site(const std::string& name, const std::string& at)
{
    return "<site name='" + name + "' pos='" + at + "'/>";
}

constexpr double kLengthError = kSingle ? 1e-6 : 1e-13;

// Two tangents of sqrt(D^2 - r^2), and the arc that is left of half a turn.
TEST_F(Tendons, go_round_a_sphere_by_tangents_and_an_arc)
{
    const std::string bodies = site("a", "-0.5 0 0") + site("b", "0.4 0.3 0") +
                               "<geom name='ball' size='0.2'/><geom name='far' size='0.2' pos='0 0 9'/>";
    const std::string ends[] = {"<site site='a'/>", "<site site='b'/>"};
    const double turn = std::acos(-0.8), r = 0.2, d = 0.5;
    const double wrapped = 2 * std::sqrt(d * d - r * r) + r * (turn - 2 * std::acos(r / d));
    EXPECT_NEAR(length_of(bodies, ends[0] + "<geom geom='ball'/>" + ends[1]), wrapped, kLengthError);
    EXPECT_NEAR(length_of(bodies, ends[0] + "<geom geom='far'/>" + ends[1]), std::sqrt(0.81 + 0.09),
                kLengthError);
    EXPECT_NEAR(length_of(bodies, ends[0] + ends[1]), std::sqrt(0.81 + 0.09), kLengthError);
}

// Unrolled, the way round a cylinder is straight: it climbs by the same share everywhere.
TEST_F(Tendons, climb_round_a_cylinder)
{
    const std::string bodies = site("a", "-0.5 0 -0.3") + site("b", "0.5 0 0.6") + site("side", "0 -9 0") +
                               "<geom name='post' type='cylinder' size='0.2 0.1'/>";
    const double flat = 2 * std::sqrt(0.25 - 0.04) + 0.2 * (std::acos(-1.0) - 2 * std::acos(0.4));
    for (const char* side : {"", " sidesite='side'"})
        EXPECT_NEAR(
            length_of(bodies, std::string("<site site='a'/><geom geom='post'") + side + "/><site site='b'/>"),
            std::sqrt(flat * flat + 0.81), kLengthError);
}

// A string that would pass at 0.3 of the side y > 0 goes round a post of 0.2 by the side y < 0.
TEST_F(Tendons, go_round_by_the_side_that_a_site_says)
{
    const std::string bodies = site("a", "-0.4 0.3 0") + site("b", "0.4 0.3 0") + site("below", "0 -1 0") +
                               site("above", "0 1 0") + "<geom name='post' type='cylinder' size='0.2 1'/>";
    const auto with = [&](const std::string& side) {
        return length_of(bodies,
                         "<site site='a'/><geom geom='post' sidesite='" + side + "'/><site site='b'/>");
    };
    const double turn = 2 * std::acos(-1.0) - 2 * std::atan2(0.4, 0.3);
    EXPECT_NEAR(with("below"), 2 * std::sqrt(0.25 - 0.04) + 0.2 * (turn - 2 * std::acos(0.4)), kLengthError);
    EXPECT_NEAR(with("above"), 0.8, kLengthError);
}

// Within a ring it bends where both parts meet the ring at the same angle: by symmetry at its lowest point.
TEST_F(Tendons, stay_within_a_ring_whose_side_is_inside)
{
    const std::string bodies = site("a", "-0.4 0.3 0") + site("b", "0.4 0.3 0") + site("centre", "0 0 0") +
                               "<geom name='ring' type='cylinder' size='0.2 1'/>";
    EXPECT_NEAR(length_of(bodies, "<site site='a'/><geom geom='ring' sidesite='centre'/><site site='b'/>"),
                2 * std::sqrt(0.16 + 0.01), kLengthError);
}

TEST_F(Tendons, count_by_divisors_after_pulleys)
{
    const std::string bodies = site("a", "0 0 1") + site("b", "0 0 3");
    EXPECT_NEAR(length_of(bodies,
                          "<site site='a'/><site site='b'/><pulley divisor='4'/><site site='b'/>"
                          "<site site='hook'/>"),
                2 + 3.0 / 4, kLengthError);
}

// Limbs of hinges, a ball and a slider, with surfaces that move: moments against differences of lengths.
TEST_F(Tendons, have_the_moments_that_differences_of_lengths_show)
{
    if (kSingle) GTEST_SKIP() << "differences of floats are too rough";
    load(file_of(
        "<site name='a' pos='0.3 0 0.2'/><body pos='0 0 0'><joint name='j1' axis='0 1 0'/><geom name='ball' "
        "size='0.1' pos='0.2 0 0.1'/><site name='b' pos='0.3 0.1 0'/><body pos='0.4 0 0'><joint name='j2' "
        "axis='0 0 1'/><joint name='j3' type='slide' axis='1 0 0'/><geom name='post' type='cylinder' "
        "size='0.05 0.2' pos='0.1 0 0' euler='1 0 0'/><site name='c' pos='0.3 0 0.1'/><site name='s' "
        "pos='0.1 "
        "0.3 0'/></body></body>",
        "<tendon><spatial><site site='a'/><geom geom='ball'/><site site='b'/><geom geom='post' sidesite='s'/>"
        "<site site='c'/><pulley divisor='2'/><site site='a'/><site site='c'/></spatial><fixed><joint "
        "joint='j1' coef='2'/><joint joint='j3' coef='-3'/></fixed></tendon>"));
    std::mt19937 random(7);
    std::uniform_real_distribution<double> any(-1.5, 1.5);
    for (int pose = 0; pose < 200; ++pose) {
        std::vector<dReal> at{dReal(any(random)), dReal(any(random)), dReal(0.1 * any(random))};
        std::vector<dReal> moments(6);
        ASSERT_EQ(dRobotModelGetTendons(model, at.data(), nullptr, moments.data(), 2), 2);
        for (int tendon = 0; tendon < 2; ++tendon)
            for (size_t i = 0; i < 3; ++i) {
                constexpr double kStep = 1e-6;
                std::vector<dReal> low = at, high = at;
                low[i] -= kStep, high[i] += kStep;
                const double wanted = (length_at(high, tendon) - length_at(low, tendon)) / (2 * kStep);
                EXPECT_NEAR(moments[size_t(tendon) * 3 + i], wanted, 1e-6)
                    << pose << ' ' << tendon << ' ' << i;
            }
    }
    EXPECT_EQ(dRobotModelFindTendon(model, "string"), -1);
}

// m z'' = -k (z - z0): 2 kg on 200 N/m swings in 0.6283 s about 0.1 m below the length of rest.
TEST_F(Tendons, swing_as_springs)
{
    load(file_of(site("top", "0 0 1") + kSlider,
                 string_over("<site site='top'/><site site='hook'/>", "stiffness='200' springlength='1'")));
    const double h = 1e-3, omega = 10;
    for (int i = 1; i <= 2000; ++i) {
        step(h);
        EXPECT_NEAR(height(), -0.1 * (1 - std::cos(omega * h * i)), 1.1e-3) << i;
    }
}

// Of damping alone the string lets its load down at m g / d.
TEST_F(Tendons, let_down_as_dampers)
{
    load(file_of(site("top", "0 0 1") + kSlider,
                 string_over("<site site='top'/><site site='hook'/>", "damping='40'")));
    step(0.005, 400);
    EXPECT_NEAR(dBodyGetLinearVel(dRobotGetBody(robot, 1))[2], -0.5, 1e-6);
}

// A string that cannot be longer than 1.2 m catches what falls, and holds it; by h^2 g it gives way.
TEST_F(Tendons, catch_what_their_range_ends)
{
    for (double h : {0.01, 0.002}) {
        load(file_of(site("top", "0 0 1") + kSlider,
                     string_over("<site site='top'/><site site='hook'/>", "range='0 1.2'")));
        for (int i = 0; i < int(2 / h); ++i) {
            step(h);
            EXPECT_LT(length(), 1.2 + 10 * h * h + 1e-6) << h << ' ' << i;
        }
        EXPECT_NEAR(length(), 1.2, 10 * h * h + 1e-6) << h;
    }
}

// A block and tackle of two strands: half the weight holds it.
TEST_F(Tendons, lift_by_two_strands_with_half_the_force)
{
    load(
        file_of(site("left", "-0.1 0 1") + site("right", "0.1 0 1") +
                    "<body name='load'><joint type='slide' axis='0 0 -1'/><geom size='0.05' mass='2'/><site "
                    "name='one' pos='-0.1 0 0'/><site name='two' pos='0.1 0 0'/></body>",
                "<tendon><spatial name='string'><site site='left'/><site site='one'/><site site='two'/><site "
                "site='right'/></spatial></tendon><actuator><motor name='winch' tendon='string' "
                "gear='-1'/></actuator>"));
    ASSERT_EQ(dRobotSetControl(robot, 0, 10), 1);
    step(0.01, 300);
    EXPECT_NEAR(height(), 0, 1e-5);
    ASSERT_EQ(dRobotSetControl(robot, 0, 12), 1);
    step(0.01, 100);
    EXPECT_NEAR(height(), 1.0, 0.02) << "2 strands of 12 N against 20 N: 2 m/s^2";
}

// A position servo of a string's length winds its load up.
TEST_F(Tendons, are_as_long_as_their_servos_say)
{
    load(file_of(site("top", "0 0 1") + kSlider,
                 string_over("<site site='top'/><site site='hook'/>") +
                     "<actuator><position tendon='string' kp='4000' kv='400'/></actuator>"));
    ASSERT_EQ(dRobotSetControl(robot, 0, dReal(0.6)), 1);
    step(0.002, 2000);
    EXPECT_NEAR(length(), 0.6 + 20.0 / 4000, 1e-5);
}

// What no step can follow is as stiff as it can.
TEST_F(Tendons, too_stiff_for_a_step_stay_quiet)
{
    load(file_of(site("top", "0 0 1") + kSlider,
                 string_over("<site site='top'/><site site='hook'/>",
                             "stiffness='1e12' damping='1e9' springlength='1'")));
    for (int i = 0; i < 1000; ++i) {
        step(0.01);
        ASSERT_NEAR(length(), 1, 0.01) << i;
    }
}

// Forces along a string are inner ones: no momentum comes from them, whichever surfaces it goes round.
TEST_F(Tendons, keep_momentum)
{
    dWorldSetGravity(world, 0, 0, 0);
    load(file_of(
        "<body pos='-0.5 0 0'><freejoint/><geom size='0.1' mass='1'/><site name='a' pos='0 0.05 0'/></body>"
        "<body pos='0 0.02 0.01'><freejoint/><geom name='ball' size='0.2' mass='3'/></body>"
        "<body pos='0.5 0.1 0'><freejoint/><geom size='0.1' mass='2'/><site name='b'/></body>",
        string_over("<site site='a'/><geom geom='ball'/><site site='b'/>",
                    "stiffness='300' springlength='0.6'")));
    for (int i = 0; i < 300; ++i) step(0.002);
    dVector3 linear{}, angular{};
    double largest = 0;
    for (int link = 1; link <= 3; ++link) {
        const dBodyID body = dRobotGetBody(robot, link);
        dMass mass;
        dBodyGetMass(body, &mass);
        const dReal *v = dBodyGetLinearVel(body), *w = dBodyGetAngularVel(body), *x = dBodyGetPosition(body);
        for (int i = 0; i < 3; ++i) {
            const int j = (i + 1) % 3, k = (i + 2) % 3;
            linear[i] += mass.mass * v[i];
            angular[i] += mass.I[0] * w[i] + mass.mass * (x[j] * v[k] - x[k] * v[j]);
            largest = std::max(largest, std::fabs(double(mass.mass * v[i])));
        }
    }
    EXPECT_GT(largest, 1);
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(linear[i], 0, kSingle ? 1e-5 : 1e-12) << i;
        EXPECT_NEAR(angular[i], 0, kSingle ? 1e-2 : 2e-3) << i << ": of first order in the step";
    }
}

std::string with_actuator(const std::string& attributes)
{
    return file_of(kSlider, "<actuator><general joint='down' " + attributes + "/></actuator>");
}

// u (1 - exp(-t/T)) of the exact filter, u (1 - (1 - h/T)^n) of the other, u t of the integrator.
TEST_F(Tendons, filters_follow_their_controls)
{
    struct Case {
        const char* attributes;
        double (*wanted)(int steps, double h);
    };
    const Case cases[] = {
        {"dyntype='filterexact' dynprm='0.2'",
         [](int n, double h) { return 3 * (1 - std::exp(-n * h / 0.2)); }},
        {"dyntype='filter' dynprm='0.2'", [](int n, double h) { return 3 * (1 - std::pow(1 - h / 0.2, n)); }},
        {"dyntype='integrator'", [](int n, double h) { return 3 * n * h; }},
        {"dyntype='integrator' actlimited='true' actrange='-1 0.5'",
         [](int n, double h) { return std::min(0.5, 3 * n * h); }}};
    for (const Case& one : cases) {
        load(with_actuator(one.attributes));
        EXPECT_EQ(dRobotGetActivation(robot, 0), 0);
        ASSERT_EQ(dRobotSetControl(robot, 0, 3), 1);
        for (int n = 1; n <= 100; ++n) {
            step(0.005);
            EXPECT_NEAR(dRobotGetActivation(robot, 0), one.wanted(n, 0.005), kSingle ? 1e-5 : 1e-12)
                << one.attributes << ' ' << n;
        }
    }
}

// The force of a step is that of the activation at its beginning, with actearly at its end.
TEST_F(Tendons, filters_act_late_unless_they_are_early)
{
    dWorldSetGravity(world, 0, 0, 0);
    for (const bool early : {false, true}) {
        load(with_actuator(std::string("dyntype='integrator' gainprm='2' actearly='") +
                           (early ? "true'" : "false'")));
        ASSERT_EQ(dRobotSetControl(robot, 0, 4), 1);
        step(0.01);
        const double speed = -double(dBodyGetLinearVel(dRobotGetBody(robot, 1))[2]);
        EXPECT_NEAR(speed, early ? 0.01 * 2 * 0.04 / 2 : 0, 1e-9);
        ASSERT_EQ(dRobotSetActivation(robot, 0, 5), 1);
        EXPECT_EQ(dRobotGetActivation(robot, 0), 5);
        step(0.01);
        EXPECT_NEAR(-double(dBodyGetLinearVel(dRobotGetBody(robot, 1))[2]) - speed,
                    0.01 * 2 * (early ? 5.04 : 5) / 2, kSingle ? 1e-6 : 1e-9);
    }
}

// An intvelocity's control is the speed of its servo's target.
TEST_F(Tendons, intvelocity_moves_its_target)
{
    dWorldSetGravity(world, 0, 0, 0);
    load(file_of(kSlider,
                 "<actuator><intvelocity joint='down' kp='4000' kv='400' actrange='0 0.3'/></actuator>"));
    ASSERT_EQ(dRobotSetControl(robot, 0, dReal(0.5)), 1);
    step(0.002, 200);
    EXPECT_NEAR(height(), -0.5 * 0.4, 0.06) << "behind by kv/kp times the speed";
    step(0.002, 1000);
    EXPECT_NEAR(height(), -0.3, 1e-4) << "the end of its range";
}

// MuJoCo 4.0 with Euler's step of 1e-4 s gives -1.03415, -0.90103 and 0.03902 rad; both are of first order.
TEST_F(Tendons, bend_a_finger_as_in_mujoco)
{
    if (kSingle) GTEST_SKIP() << "links of some grams at steps of 1e-4 s";
    std::ifstream file(EPODE_MODELS "/hand.xml");
    std::string text{std::istreambuf_iterator<char>(file), {}};
    const std::string limits = "limited=\"true\" range=\"0 1.6\"";
    ASSERT_NE(text.find(limits), std::string::npos);
    load(text.replace(text.find(limits), limits.size(), "limited=\"false\""));
    dWorldSetGravity(world, 0, 0, dReal(-9.81));
    const double controls[] = {0.05, 0.05, 0.5};
    for (int i = 0; i < 3; ++i) ASSERT_EQ(dRobotSetControl(robot, i, dReal(controls[i])), 1);
    step(1e-4, 1000);
    const double wanted[] = {-1.03415, -0.90103, 0.03902};
    for (size_t i = 0; i < 3; ++i) EXPECT_NEAR(positions()[i], wanted[i], 5e-4) << i;
}

TEST_F(Tendons, without_calls_filters_act_at_once)
{
    dWorldSetGravity(world, 0, 0, 0);
    load(with_actuator("dyntype='filter' dynprm='1'"));
    ASSERT_EQ(dRobotSetControl(robot, 0, 2), 1);
    dWorldStep(world, dReal(0.01));
    EXPECT_NEAR(dBodyGetLinearVel(dRobotGetBody(robot, 1))[2], -0.01, 1e-9);
}

TEST_F(Tendons, refuse_what_makes_no_sense)
{
    load(file_of(site("top", "0 0 1") + kSlider, string_over("<site site='top'/><site site='hook'/>")));
    EXPECT_EQ(dRobotModelFindTendon(model, "string"), 0);
    dSetMessageHandler([](int, const char*, va_list) {});
    for (dReal h : {dReal(0), dReal(-1), dReal(NAN)}) EXPECT_EQ(dRobotAddForces(robot, h), 0);
    EXPECT_EQ(dRobotAddForces(nullptr, dReal(0.01)), 0);
    EXPECT_EQ(dRobotSetActivation(robot, 0, 1), 0) << "there is no actuator";
    EXPECT_EQ(dRobotGetActivation(robot, -1), 0);
    dReal length = 7;
    EXPECT_EQ(dRobotModelGetTendons(model, nullptr, &length, nullptr, 1), 0);
    EXPECT_EQ(length, 7);
    dSetMessageHandler(nullptr);
}

// Each with its line and reason, and no robot.
TEST_F(Tendons, broken_paths_are_errors)
{
    const std::string bodies = site("a", "0 0 1") +
                               "<geom name='box' type='box' size='1 1 1'/><geom name='ball' size='1'/>" +
                               kSlider;
    const auto error_of = [&](const std::string& parts) {
        const RobotModel its = load_robot_text("robot.xml", file_of(bodies, string_over(parts)));
        for (const ReportLine& line : its.report)
            if (line.note == Note::kError) return line.text;
        return std::string();
    };
    const auto has = [&](const std::string& parts, const std::string& wanted) {
        EXPECT_NE(error_of(parts).find(wanted), std::string::npos) << wanted << ": " << error_of(parts);
    };
    has("<site site='a'/><site site='b'/>", "no site 'b'");
    has("<site site='a'/><geom geom='box'/><site site='hook'/>", "'box' is no sphere or cylinder");
    has("<site site='a'/><geom geom='ball' sidesite='x'/><site site='hook'/>", "no site 'x'");
    has("<site site='a'/><pulley divisor='0'/><site site='hook'/>", "a pulley's divisor is above 0");
    has("<site site='a'/>", "less than two sites");
    has("<site site='a'/><site site='hook'/><geom geom='ball'/>", "a geom that is not between two sites");
    has("<site site='a'/><pulley divisor='2'/><site site='hook'/>", "less than two sites");
}

TEST_F(Tendons, are_written_again)
{
    const RobotModel its = load_robot_text(
        "robot.xml",
        file_of(site("a", "-0.5 0 1") + site("s", "0 1 0") +
                    "<geom name='ball' size='0.1'/><body pos='0 0 1'><freejoint/><geom type='cylinder' "
                    "name='post' size='0.1 "
                    "0.2'/></body>" +
                    kSlider,
                string_over(
                    "<site site='a'/><geom geom='ball' sidesite='s'/><site site='hook'/><pulley divisor='2'/>"
                    "<site site='a'/><geom geom='post'/><site site='hook'/>",
                    "range='0.1 2' stiffness='3' damping='4' springlength='0.5 0.6'") +
                    "<actuator><position tendon='string' kp='2'/></actuator>"));
    ASSERT_FALSE(its.has_errors());
    const WrittenRobot written = write_mjcf(its, ".");
    EXPECT_TRUE(written.lost.empty()) << written.lost[0];
    const auto found = differences(its, load_robot_text("robot.xml", written.text));
    EXPECT_TRUE(found.empty()) << found[0] << written.text;
}

}  // namespace
