// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Sensors of distances between geoms and bodies, of their directions and points, of places within a site, and cutoffs, against MuJoCo 4.0's
// numbers; looks that touch nothing are measured too.
#include "robot_in_contact.h"

#include "robots/load.h"
#include "robots/write/write.h"
#include "same_model.h"

namespace {

using namespace epode::robots;

const char* const kMeasured =
    "<mujoco><compiler angle='radian'/><worldbody><geom name='floor' type='plane' size='3 3 1'/><body "
    "name='a' pos='0 0 "
    ".5'><joint name='s' type='slide' axis='0 0 1'/><geom name='ball' size='.1'/><geom name='cap' "
    "type='capsule' fromto='0.3 "
    "0 0 0.5 0 0.1' size='.05'/></body><body name='b' pos='.1 .2 .9' euler='.3 .4 .5'><joint name='h' "
    "axis='0 .6 .8'/>"
    "<geom name='box' type='box' size='.1 .2 .05'/><geom name='look' pos='.3 0 0' size='.07' contype='0' "
    "conaffinity='0'/>"
    "<body name='fixed' pos='0 .5 0'><geom name='far' size='.04'/></body>"
    "<site name='room' type='box' pos='-.2 -.2 -.5' size='.3 .3 .2'/></body></worldbody><sensor>"
    "<distance geom1='ball' geom2='floor' cutoff='2'/><normal geom1='ball' geom2='floor' cutoff='2'/>"
    "<fromto geom1='ball' geom2='floor' cutoff='2'/><distance geom1='cap' geom2='box' cutoff='2'/>"
    "<normal geom1='cap' geom2='box' cutoff='2'/><fromto geom1='cap' geom2='box' cutoff='2'/>"
    "<distance body1='a' body2='b' cutoff='2'/><normal body1='a' geom2='look' cutoff='2'/>"
    "<fromto body1='fixed' body2='a' cutoff='2'/><distance geom1='ball' geom2='box'/><fromto geom1='ball' "
    "geom2='box'/>"
    "<distance geom1='ball' geom2='box' cutoff='.1'/><insidesite objtype='xbody' objname='a' site='room'/>"
    "<insidesite objtype='body' objname='fixed' site='room'/><framepos objtype='xbody' objname='b' "
    "cutoff='.15'/>"
    "<clock/><jointpos joint='h' cutoff='.2'/></sensor></mujoco>";

class SensedDistances : public RobotInContact {
  protected:
    void put(double slide)
    {
        load(kMeasured);
        const dReal q[2] = {dReal(slide), dReal(0.3)};
        dRobotSetPositions(robot, q, 2);
    }
    void expect(int number, const std::vector<double>& wanted)
    {
        const std::vector<double> its = sensor(number);
        ASSERT_EQ(its.size(), wanted.size()) << number;
        for (size_t k = 0; k < its.size(); ++k)
            EXPECT_NEAR(its[k], wanted[k], fine(1e-9, 1e-4)) << number << " " << k;
    }
};

// mujoco 4.0.0: sensordata after mj_forward at qpos 0.05 0.3.
TEST_F(SensedDistances, read_what_mujocos_read)
{
    put(0.05);
    const std::vector<std::vector<double>> recorded{
        {0.45},
        {0, 0, -1},
        {0, 0, 0.45, 0, 0, 0},
        {0.1931390418203},
        {-0.3807864336817, 0.5244124899541, 0.7615728673634},
        {0.3047347720797, 0.02622062449771, 0.5999656902501, 0.2311900451402, 0.127505150326, 0.747055144129},
        {0.1703777681162},
        {-0.2317508309129, 0.8552530396648, 0.4635016618259},
        {-0.1956913749855, 0.4861709184937, 1.114556809078, -0.02540414732232, 0.06311344911423,
         0.6232893023553},
        {0},
        {0, 0, 0, 0, 0, 0},
        {0.1},
        {1},
        {0},
        {0.1, 0.15, 0.15},
        {0},
        {0.2}};
    for (size_t i = 0; i < recorded.size(); ++i) expect(int(i), recorded[i]);
}

// mujoco 4.0.0: the same at qpos -0.45 0.3, where the ball is half in the floor.
TEST_F(SensedDistances, of_what_overlaps_are_below_0)
{
    put(-0.45);
    expect(0, {-0.05});
    expect(1, {0, 0, 1});
    expect(2, {0, 0, -0.05, 0, 0, 0});
}

TEST(SensedDistanceFiles, are_written_and_read_again_and_name_what_is_not_there)
{
    const RobotModel model = load_robot_text("robot.xml", kMeasured);
    ASSERT_FALSE(model.has_errors());
    RobotModel of_links = model;  // a body that has become part of another one cannot be written
    std::erase_if(of_links.sensors, [](const Sensor& its) {
        return its.object == "fixed" || its.object == "b" || its.reference == "b";
    });
    EXPECT_EQ(differences(of_links, load_robot_text("robot.xml", write_mjcf(of_links, ".").text)),
              std::vector<std::string>{});
    EXPECT_FALSE(write_mjcf(model, ".").lost.empty());
    const RobotModel broken = load_robot_text(
        "robot.xml",
        "<mujoco><worldbody><body><joint/><geom name='g' size='.1'/></body></worldbody><sensor>\n<distance "
        "geom1='g' geom2='no'/></sensor></mujoco>");
    ASSERT_TRUE(broken.has_errors());
    EXPECT_EQ(broken.report.back().line, 2);
    EXPECT_EQ(broken.report.back().text, "<distance> of 'g' and 'no', of which one is not there");
}

}  // namespace
