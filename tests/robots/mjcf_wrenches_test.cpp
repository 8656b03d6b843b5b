// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Actuators of sites and adhesive ones: Newton's law, momentum, MuJoCo 4.0's numbers (of the model below, at the positions and velocities
// that stand there), thresholds of friction and of gravity.
#include "robot_in_contact.h"

#include <cmath>

#include "robots/load.h"
#include "robots/write/write.h"
#include "same_model.h"

namespace {

using namespace epode::robots;

constexpr double kG = 9.81;

std::string arm(const std::string& actuator, const std::string& base = "<joint name='j0' axis='0 0.6 0.8'/>")
{
    return "<mujoco><compiler angle='radian'/><worldbody><site name='w' pos='0.1 0.2 0.3' euler='0.3 0.2 "
           "0.1'/>"
           "<body name='base' pos='0 0 1'>" +
           base +
           "<geom size='0.1'/>"
           "<body name='a' pos='0.1 0 0'><joint name='j1' axis='0 1 0'/><geom size='0.05'/>"
           "<site name='sa' pos='0.1 0 0.05' euler='0.4 0 0.2'/>"
           "<body name='b' pos='0.3 0 0'><joint name='j2' axis='0 0 1'/><geom size='0.05'/>"
           "<site name='sb' pos='0.1 0.02 0' euler='0.1 0.5 0'/></body></body>"
           "<body name='c' pos='-0.1 0 0'><joint name='j3' axis='0.8 0 0.6'/><geom size='0.05'/>"
           "<site name='sc' pos='-0.1 0.1 0.05' euler='0.1 0 0.9'/></body>"
           "</body></worldbody><actuator>" +
           actuator +
           "</actuator><sensor><actuatorpos actuator='m'/>"
           "<actuatorvel actuator='m'/><actuatorfrc actuator='m'/><jointactuatorfrc joint='j0'/>"
           "<jointactuatorfrc joint='j1'/><jointactuatorfrc joint='j2'/><jointactuatorfrc "
           "joint='j3'/></sensor></mujoco>";
}

struct Recorded {
    const char* actuator;
    double values[7];  // length, rate, force, forces of the joints
};

// mujoco 4.0.0: mj_forward at qpos 0.3 -0.4 0.5 0.7, qvel 1 -2 0.5 1.5, ctrl 2.
const Recorded kRecorded[] = {
    {"<motor name='m' site='sb' gear='1 2 3 0.1 0.2 0.3'/>",
     {0, 2.0492697353247, 2, 1.2572945781244, -1.2379177299253, 0.7308188653486, 0}},
    {"<general name='m' site='sb' refsite='w' gear='1 2 3 0.1 0.2 0.3'/>",
     {3.1140472552866, 1.8056763983491, 2, -0.50549980623, -1.9576961389855, 0.4029206499145, 0}},
    {"<general name='m' site='sb' refsite='sc' gear='1 2 3 0.1 0.2 0.3'/>",
     {-0.7872935546474, 2.675072285635, 2, 0, -2.9115804700705, 0.5877654751075, -0.5112660709499}},
    {"<position name='m' site='sb' refsite='sc' gear='0 0 0 1 0 0.5' kp='3' kv='0.5'/>",
     {-0.9773064984559, -1.9049561226981, 9.8843975567167, 0, 4.9572045422177, 7.1591890424489,
      -8.3296860544257}},
    // Slider-cranks: the second one's rod does not reach.
    {"<motor name='m' cranksite='sb' slidersite='w' cranklength='0.9' gear='3'/>",
     {-0.193345492469, 0.9368929460239, 2, -1.878186046336, -1.948901603125, -0.2916625357324, 0}},
    {"<motor name='m' cranksite='sb' slidersite='sc' cranklength='0.05' gear='2'/>",
     {0.2425772834246, 1.207953514415, 2, 0, -1.017092061666, -0.3016112600596, 0.3550190236851}},
    {"<position name='m' cranksite='sb' slidersite='sc' cranklength='0.8' kp='4' kv='0.5'/>",
     {-0.3202410476823, 0.08795502284533, 9.236986679306, 0, -0.1008334946776, -1.301380040121,
      0.8409749367371}}};

class MjcfWrenches : public RobotInContact {};

TEST_F(MjcfWrenches, have_lengths_rates_and_forces_along_joints_as_mujocos)
{
    for (const Recorded& its : kRecorded) {
        load(arm(its.actuator));
        const dReal q[4] = {dReal(0.3), dReal(-0.4), dReal(0.5), dReal(0.7)},
                    v[4] = {1, -2, dReal(0.5), dReal(1.5)};
        dRobotSetPositions(robot, q, 4), dRobotSetVelocities(robot, v, 4), dRobotSetControl(robot, 0, 2);
        for (int i = 0; i < 7; ++i)
            EXPECT_NEAR(sensor(i).at(0), its.values[i], fine(1e-9, 1e-3)) << its.actuator << " " << i;
    }
}

// A step exerts what they read: from rest, without gravity, the joints get h M^-1 of it.
TEST_F(MjcfWrenches, accelerate_as_their_forces_along_joints_do)
{
    const double h = 1e-5;
    for (const size_t k : {0, 1, 2, 4, 5}) {
        load(arm(kRecorded[k].actuator));
        const dReal q[4] = {dReal(0.3), dReal(-0.4), dReal(0.5), dReal(0.7)};
        dRobotSetPositions(robot, q, 4), dRobotSetControl(robot, 0, 2);
        dReal mass[16];
        dRobotModelGetMassMatrix(model, q, mass, 16);
        step(1, h);
        const std::vector<double> v = velocities();
        for (int i = 0; i < 4; ++i) {
            double force = 0;
            for (int j = 0; j < 4; ++j) force += double(mass[4 * i + j]) * v[size_t(j)] / h;
            EXPECT_NEAR(force, kRecorded[k].values[3 + i], fine(1e-4, 1)) << k << " " << i;
        }
    }
}

TEST_F(MjcfWrenches, push_a_free_body_along_the_axes_of_its_site)
{
    load(
        "<mujoco><worldbody><body><freejoint/><geom size='0.1' mass='2'/><site name='s' euler='0 0 "
        "90'/></body>"
        "</worldbody><actuator><motor site='s' gear='1 0 0 0 0 0'/><motor site='s' gear='0 0 0 0 0 1'/>"
        "</actuator></mujoco>");
    dRobotSetControl(robot, 0, 3), dRobotSetControl(robot, 1, dReal(0.016));
    step(100, 0.001);
    const std::vector<double> v = velocities();
    EXPECT_NEAR(v[0] * v[0] + v[1] * v[1], 0.15 * 0.15, fine(2e-3));  // its site turns with it
    EXPECT_NEAR(v[5], 0.016 / (0.4 * 2 * 0.01) * 0.1, fine(1e-6));
}

// What acts between two sites of a free robot changes neither momentum.
TEST_F(MjcfWrenches, between_two_links_of_a_free_robot_leave_its_momenta)
{
    load(
        arm("<general name='m' site='sb' refsite='sc' gear='1 2 3 0.1 0.2 0.3'/>", "<freejoint name='j0'/>"));
    dRobotSetControl(robot, 0, 2);
    step(50, 0.001);
    double p[3] = {}, l[3] = {}, speed = 0;
    for (int link = 1; link < 5; ++link) {
        const dBodyID body = dRobotGetBody(robot, link);
        dMass mass;
        dBodyGetMass(body, &mass);
        const dReal *x = dBodyGetPosition(body), *v = dBodyGetLinearVel(body), *w = dBodyGetAngularVel(body);
        for (int i = 0; i < 3; ++i) {
            const int j = (i + 1) % 3, k = (i + 2) % 3;
            p[i] += double(mass.mass * v[i]);
            l[i] += double(mass.mass * (x[j] * v[k] - x[k] * v[j]) + mass.I[0] * w[i]);  // balls
        }
        speed += std::fabs(double(w[0])) + std::fabs(double(w[1]));
    }
    EXPECT_GT(speed, 1);
    for (double sum : {p[0], p[1], p[2], l[0], l[1], l[2]}) EXPECT_NEAR(sum, 0, fine(1e-5));
}

TEST(MjcfWrenchFiles, are_written_and_read_again_and_name_what_is_not_there)
{
    for (const Recorded& its : kRecorded) {
        const RobotModel model = load_robot_text("robot.xml", arm(its.actuator));
        const RobotModel again = load_robot_text("robot.xml", write_mjcf(model, ".").text);
        EXPECT_EQ(differences(model, again), std::vector<std::string>{}) << its.actuator;
    }
    const RobotModel broken = load_robot_text("robot.xml", arm("\n<motor name='m' site='sb' refsite='sd'/>"));
    ASSERT_TRUE(broken.has_errors());
    EXPECT_EQ(broken.report.back().line, 2);
    EXPECT_EQ(broken.report.back().text, "there is no site 'sd'");
    for (const char* wrong : {"\n<motor name='m' cranksite='sb' slidersite='sd' cranklength='1'/>",
                              "\n<motor name='m' cranksite='sb' cranklength='1'/>",
                              "\n<motor name='m' cranksite='sb' slidersite='sc'/>"}) {
        const RobotModel crank = load_robot_text("robot.xml", arm(wrong));
        ASSERT_TRUE(crank.has_errors()) << wrong;
        EXPECT_EQ(crank.report.back().line, 2);
    }
}

// A box of 1 kg at a wall, or under a ceiling.
std::string stuck(const std::string& zaxis, const std::string& pos, const std::string& more = "")
{
    return "<mujoco><worldbody><geom type='plane' size='9 9 1' zaxis='" + zaxis +
           "' friction='0.5'/><body name='pad' pos='" + pos +
           "'><freejoint/><geom type='box' size='0.1 0.1 0.1' mass='1' friction='0.5'/></body></worldbody>"
           "<actuator><adhesion name='glue' body='pad' ctrlrange='0 1' gain='40'/>" +
           more + "</actuator></mujoco>";
}

class MjcfAdhesion : public RobotInContact {
  protected:
    // Its speed downwards a tenth of a second after gravity began, with that pull.
    double speed(const std::string& text, double pull)
    {
        load(text);
        dWorldSetGravity(world, 0, 0, 0);
        dRobotSetControl(robot, 0, dReal(pull / 40));
        step(50);
        dWorldSetGravity(world, 0, 0, dReal(-kG));
        step(50);
        return -velocities()[2];
    }
};

TEST_F(MjcfAdhesion, holds_under_a_ceiling_what_is_lighter_than_its_force)
{
    const std::string text = stuck("0 0 -1", "0 0 -0.1");
    EXPECT_NEAR(speed(text, 12), 0, fine(1e-4));
    dRobotTouch touch;
    touch.struct_size = sizeof touch;
    ASSERT_EQ(dRobotGetTouch(robot, 1, &touch), 1);
    EXPECT_NEAR(double(touch.normal_force), 12 - kG, fine(1e-3));
    EXPECT_GT(speed(text, 8), 0.7);  // lets go after a step or two: without contact there is no pull
}

TEST_F(MjcfAdhesion, at_a_wall_gives_friction_a_normal_force)
{
    const std::string text = stuck("1 0 0", "0.1 0 0");
    EXPECT_NEAR(speed(text, 25), 0, fine(1e-4));  // 0.5 * 25 > 9.81
    EXPECT_NEAR(speed(text, 15), (kG - 7.5) * 0.1, 0.02);
}

TEST(MjcfAdhesionFiles, are_written_and_read_again_and_refuse_what_repels)
{
    const RobotModel model = load_robot_text("robot.xml", stuck("0 0 1", "0 0 0.1"));
    ASSERT_EQ(model.actuators.size(), 1u);
    const RobotModel again = load_robot_text("robot.xml", write_mjcf(model, ".").text);
    EXPECT_EQ(differences(model, again), std::vector<std::string>{});
    for (const char* wrong : {"\n<adhesion body='pad' ctrlrange='-1 1'/>",
                              "\n<adhesion body='pad' gain='-1' ctrlrange='0 1'/>"}) {
        const RobotModel broken = load_robot_text("robot.xml", stuck("0 0 1", "0 0 0.1", wrong));
        ASSERT_TRUE(broken.has_errors());
        EXPECT_EQ(broken.report.back().line, 2);
    }
}

}  // namespace
