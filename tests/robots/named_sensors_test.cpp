// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Sensors of MJCF: energies, limits, tendons, momenta and magnetometers against MuJoCo 4.0's numbers; the zone of a touch sensor;
// accelerations in the world's axes.
#include "robot_in_contact.h"

#include <cmath>

#include "robots/load.h"
#include "robots/write/write.h"
#include "same_model.h"

namespace {

using namespace epode::robots;

constexpr double kG = 9.81;

class NamedSensors : public RobotInContact {};

const char* const kModel =
    "<mujoco><compiler angle='radian'/><option magnetic='0.3 -0.4 0.5'/><worldbody><site name='top' pos='0.1 "
    "0.2 0.9'/>"
    "<body name='a' pos='0 0 0.5'><joint name='j' axis='0 0.6 0.8' stiffness='2' springref='0.4' range='-0.2 "
    "0.2'/>"
    "<geom type='box' size='0.1 0.2 0.05' mass='2' pos='0.1 0 0'/><body name='b' pos='0.3 0 0.1'>"
    "<joint name='k' type='ball' stiffness='0.7'/><geom type='box' size='0.05 0.1 0.2' mass='0.5'/>"
    "<site name='eye' pos='0.1 0 0.1' euler='0.3 0.4 0.5'/></body></body></worldbody><tendon>"
    "<spatial name='t' stiffness='11' springlength='0.2 0.25' range='0 0.35'><site site='top'/><site "
    "site='eye'/></spatial>"
    "<fixed name='f' range='0.4 1'><joint joint='j' coef='2'/></fixed></tendon><actuator><motor tendon='t' "
    "gear='2'/>"
    "<position tendon='t' kp='3'/></actuator><sensor><e_potential/><e_kinetic/><subtreeangmom body='a'/>"
    "<magnetometer site='eye'/><tendonpos tendon='t'/><tendonvel tendon='t'/><tendonactuatorfrc tendon='t'/>"
    "<jointlimitpos joint='j'/><jointlimitvel joint='j'/><tendonlimitpos tendon='t'/><tendonlimitvel "
    "tendon='t'/>"
    "<tendonlimitpos tendon='f'/><tendonlimitvel tendon='f'/></sensor></mujoco>";

// mujoco 4.0.0: mj_forward at the positions, velocities and controls below.
TEST_F(NamedSensors, read_what_mujocos_read)
{
    load(kModel);
    dWorldSetGravity(world, 0, 0, dReal(-kG));
    const double n = std::sqrt(1 + 0.04 + 0.16 + 0.09);
    const dReal q[5] = {dReal(0.3), dReal(1 / n), dReal(0.2 / n), dReal(-0.4 / n), dReal(0.3 / n)},
                v[4] = {1, -2, dReal(0.5), dReal(1.5)};
    dRobotSetPositions(robot, q, 5), dRobotSetVelocities(robot, v, 4);
    dRobotSetControl(robot, 0, dReal(0.5)), dRobotSetControl(robot, 1, dReal(0.3));
    const std::vector<std::vector<double>> recorded{{12.5463307145591},
                                                    {0.0591409237726},
                                                    {-0.0161118077437, 0.0135493257508, 0.0388472272631},
                                                    {-0.0598696003575, -0.1699284972225, 0.6837689206046},
                                                    {0.35303605735},
                                                    {-0.2386496974058},
                                                    {0.3408918279499},
                                                    {-0.1},
                                                    {-1},
                                                    {-0.00303605735},
                                                    {0.2386496974058},
                                                    {0},
                                                    {0}};
    for (size_t i = 0; i < recorded.size(); ++i) {
        const std::vector<double> its = sensor(int(i));
        ASSERT_EQ(its.size(), recorded[i].size()) << i;
        for (size_t k = 0; k < its.size(); ++k)
            EXPECT_NEAR(its[k], recorded[i][k], fine(1e-9, 1e-3)) << i << " " << k;
    }
}

TEST(NamedSensorFiles, are_written_and_read_again)
{
    const RobotModel model = load_robot_text("robot.xml", kModel);
    ASSERT_EQ(model.sensors.size(), 13u);
    EXPECT_EQ(differences(model, load_robot_text("robot.xml", write_mjcf(model, ".").text)),
              std::vector<std::string>{});
}

// A box of 2 kg on the floor carries a quarter of its weight at each corner.
TEST_F(NamedSensors, of_touch_feel_what_a_ray_out_of_the_link_into_their_zone_comes_from)
{
    const char* const zones[] = {"pos='0.2 0.2 -0.2' size='0.03'",
                                 "pos='0.2 0.2 -0.35' size='0.03'",
                                 "pos='0.2 0.2 0' size='0.03'",
                                 "type='box' pos='0.2 0 -0.2' size='0.01 0.3 0.01'",
                                 "type='ellipsoid' pos='0 0 -0.3' size='0.3 0.5 0.01'",
                                 "type='cylinder' pos='0.2 0.2 -0.2' size='0.02 0.01'",
                                 "type='capsule' pos='0.2 0 -0.2' euler='90 0 0' size='0.01 0.25'"};
    const double corners[] = {1, 1, 0, 2, 4, 1, 2};
    std::string sites, sensors;
    for (int i = 0; i < 7; ++i) {
        const std::string name = "s" + std::to_string(i);
        sites += "<site name='" + name + "' " + zones[i] + "/>", sensors += "<touch site='" + name + "'/>";
    }
    const std::string text =
        "<mujoco><worldbody><geom type='plane' size='2 2 .1'/><body name='box' pos='0 0 0.2'><freejoint/>"
        "<geom type='box' size='0.2 0.2 0.2' mass='2'/>" +
        sites + "</body></worldbody><sensor>" + sensors + "</sensor></mujoco>";
    load(text);
    dWorldSetGravity(world, 0, 0, dReal(-kG));
    step(300);
    for (int i = 0; i < 7; ++i) EXPECT_NEAR(sensor(i).at(0), corners[i] * 2 * kG / 4, 0.05) << i;
    const RobotModel read = load_robot_text("robot.xml", text);
    EXPECT_EQ(differences(read, load_robot_text("robot.xml", write_mjcf(read, ".").text)),
              std::vector<std::string>{});
}

// Gravity counts, as in MuJoCo: what rests reads 9.81 upwards, what falls 0.
TEST_F(NamedSensors, of_acceleration_read_in_the_axes_of_the_world)
{
    load(
        "<mujoco><worldbody><body pos='0 0 1'><freejoint/><geom size='0.1'/><site name='s' euler='30 40 "
        "50'/></body></worldbody>"
        "<sensor><framelinacc objtype='site' objname='s'/><frameangacc objtype='site' "
        "objname='s'/></sensor></mujoco>");
    const dBodyID body = dRobotGetBody(robot, 1);
    dWorldSetGravity(world, 0, 0, dReal(-kG));
    dBodySetGravityMode(body, 0);
    step(2);
    EXPECT_NEAR(sensor(0).at(2), kG, fine(1e-9));
    dMass mass;
    dBodyGetMass(body, &mass);
    dBodySetGravityMode(body, 1);
    dBodyAddTorque(body, 0, 0, dReal(0.5 * double(mass.I[0])));
    step(1);
    EXPECT_NEAR(sensor(0).at(2), 0, fine(1e-9));
    EXPECT_NEAR(sensor(1).at(2), 0.5, fine(1e-9));
}

}  // namespace
