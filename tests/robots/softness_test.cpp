// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// MJCF's soft contacts and limits (robots/softness.h). With a constant impedance d a weight rests g (1 - d) (T z)^2 deep,
// whatever its mass, and gets there as on a damped spring.
#include <epode/robots.h>
#include <gtest/gtest.h>
#include <ode/ext.h>

#include <cmath>
#include <string>
#include <vector>

namespace {

constexpr bool kSingle = sizeof(dReal) == 4;
constexpr double kG = 9.81, kRadius = 0.1, kLength = 0.5;
constexpr double kLayer =
    1e-3 * kRadius;  // that world-managed contacts leave to themselves, however small it is set

class Softness : public testing::Test {
  protected:
    Softness()
    {
        dInitODE2(0);
        world = dWorldCreate();
        space = dHashSpaceCreate(nullptr);
        dWorldSetGravity(world, 0, 0, -dReal(kG));
        dWorldSetContactSurfaceLayer(world, 0);
        dWorldSetContactSpace(world, space);
    }
    ~Softness() override
    {
        clear();
        dSpaceDestroy(space);
        dWorldDestroy(world);
        dCloseODE();
    }
    void clear()
    {
        if (robot) dRobotDestroy(robot);
        if (model) dRobotModelDestroy(model);
        robot = nullptr, model = nullptr;
    }
    void load(const std::string& inside)
    {
        clear();
        const std::string text = "<mujoco><worldbody>" + inside + "</worldbody></mujoco>";
        model = dRobotModelLoadText("robot.xml", text.data(), text.size(), nullptr);
        ASSERT_EQ(dRobotModelHasErrors(model), 0);
        robot = dRobotCreate(world, space, model, nullptr, nullptr);
        ASSERT_NE(robot, nullptr);
    }
    // A ball of `mass` on a plane, as deep as it may be without a force.
    void load_ball(double mass, const std::string& softness)
    {
        load(
            "<geom type='plane' size='1 1 1'/><body pos='0 0 0.0999'><freejoint/><geom type='sphere' "
            "size='0.1' "
            "mass='" +
            std::to_string(mass) + "' " + softness + "/></body>");
    }
    // A rod whose hinge is at its limit while it is level.
    void load_rod(const std::string& softness)
    {
        load("<body><joint name='hinge' axis='0 1 0' range='-60 0' " + softness +
             "/><inertial pos='0.5 0 0' mass='2' diaginertia='0.1 0.1 0.1'/></body>");
    }
    double depth() const { return kRadius - kLayer - double(dBodyGetPosition(dRobotGetBody(robot, 1))[2]); }
    double angle() const
    {
        dReal q;
        dRobotGetPositions(robot, &q, 1);
        return double(q);
    }
    void steps(int count, double h)
    {
        for (int i = 0; i < count; ++i) dWorldStep(world, dReal(h));
    }

    dWorldID world;
    dSpaceID space;
    dRobotModelID model = nullptr;
    dRobotID robot = nullptr;
};

double resting(double d, double time, double ratio) { return kG * (1 - d) * time * time * ratio * ratio; }

TEST_F(Softness, of_a_contact_lets_a_ball_of_any_mass_rest_as_deep)
{
    for (const double mass : {0.2, 1.0, 30.0}) {
        load_ball(mass, "solref='0.05 1' solimp='0.8 0.8 0.001'");
        steps(1000, 0.002);
        EXPECT_NEAR(depth(), resting(0.8, 0.05, 1), kSingle ? 1e-5 : 1e-8) << mass;
    }
}

// x'' = g - K/m x - c/m x' with K/m = 1/((1 - d) (T z)^2) and c/m = 2/((1 - d) T): MuJoCo adds an inertia.
TEST_F(Softness, of_a_contact_sinks_in_as_a_damped_spring_does)
{
    load_ball(3, "solref='0.05 1' solimp='0.6 0.6 0.001'");
    const double h = 1e-4, d = 0.6, time = 0.05, deep = resting(d, time, 1);
    const double k = 1 / ((1 - d) * time * time), c = 2 / ((1 - d) * time), root = std::sqrt(c * c / 4 - k);
    const double s1 = -c / 2 + root, s2 = -c / 2 - root;
    for (int i = 1; i <= 2000; ++i) {
        steps(1, h);
        const double t = i * h, left = (s2 * std::exp(s1 * t) - s1 * std::exp(s2 * t)) / (s2 - s1);
        ASSERT_NEAR(depth(), deep * (1 - left), kLayer) << t;
    }
}

TEST_F(Softness, may_be_given_as_stiffness_and_damping)
{
    load_ball(1, "solref='-500 -40' solimp='0.9 0.9 0.001'");  // k = 500/d, b = 40/d
    steps(2000, 0.002);
    EXPECT_NEAR(depth(), kG * (1 - 0.9) / 500, kSingle ? 1e-5 : 1e-8);
}

TEST_F(Softness, of_a_limit_is_a_spring_on_the_joint)
{
    load_rod("solreflimit='0.04 1' solimplimit='0.7 0.7 0.001'");
    steps(2000, 0.001);
    const double inertia = 0.1 + 2 * kLength * kLength, torque = 2 * kG * kLength;
    const double small = torque / inertia * (1 - 0.7) * 0.04 * 0.04;
    EXPECT_NEAR(angle(), small, 2e-4 * small + (kSingle ? 1e-5 : 0));
}

TEST_F(Softness, that_grows_with_the_depth_is_taken_at_half_the_weight)
{
    load_ball(1, "solref='0.02 1' solimp='0 0.8 0.01'");
    steps(2000, 0.002);
    // At r: k r d/(1 - d) = g/2 with d = 0.8 * 2 (r / 10 mm)^2, k = d/(0.8 * 0.02)^2; the weight goes twice as deep.
    const double r = depth() / 2, d = 0.8 * 2 * std::pow(r / 0.01, 2), k = d / std::pow(0.8 * 0.02, 2);
    ASSERT_LT(r, 0.005) << "the lower half of the sigmoid";
    EXPECT_NEAR(k * r * d / (1 - d), kG / 2, kSingle ? 2e-2 : 1e-5);
}

TEST_F(Softness, that_no_file_states_is_none)
{
    load_ball(1, "");
    steps(500, 0.002);
    EXPECT_NEAR(depth(), 0, kSingle ? 1e-5 : 1e-8);
}

TEST_F(Softness, beyond_reason_changes_nothing)
{
    for (const char* softness : {"solref='0 0'", "solref='1e300 1'", "solimp='2 3 -1 5 0'",
                                 "solref='-1e300 0'", "solimp='nan 0 0'", "solref='0.02 0'"}) {
        clear();
        const std::string text =
            std::string(
                "<mujoco><worldbody><geom type='plane' size='1 1 1'/><body pos='0 0 0.1'>"
                "<freejoint/><geom type='sphere' size='0.1' ") +
            softness + "/></body></worldbody></mujoco>";
        model = dRobotModelLoadText("robot.xml", text.data(), text.size(), nullptr);
        if (dRobotModelHasErrors(model)) continue;
        robot = dRobotCreate(world, space, model, nullptr, nullptr);
        ASSERT_NE(robot, nullptr);
        steps(20, 0.002);
        EXPECT_TRUE(std::isfinite(depth())) << softness;
    }
}

}  // namespace
