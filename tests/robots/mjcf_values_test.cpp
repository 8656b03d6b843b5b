// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What MuJoCo would not take of an MJCF file is refused where it stands: names that nothing has, words that are none, attributes that
// are missing, numbers of the user's, joints and ranges that do not fit. And what it takes is not.
#include <gtest/gtest.h>

#include "robots/load.h"

namespace {

using namespace epode::robots;

// Two bodies with all that can be named, then what is given.
RobotModel read(const std::string& world, const std::string& sections)
{
    return load_robot_text("robot.xml",
                           "<mujoco><asset><material name='red' rgba='1 0 0 1'/><texture name='wood' "
                           "builtin='flat' type='2d' width='9' height='9'/></asset>"
                           "<worldbody><body name='b'><joint name='elbow'/><geom name='g' size='.1'/><site "
                           "name='tip'/><camera name='eye'/></body>"
                           "<body name='c' pos='1 0 0'><joint name='knee'/><geom name='h' size='.1'/><site "
                           "name='foot'/></body>\n" +
                               world + "</worldbody>" + sections + "</mujoco>");
}

std::string first_error(const RobotModel& model)
{
    for (const ReportLine& line : model.report)
        if (line.note == Note::kError) return line.text;
    return "";
}

void expect_refused(const std::string& world, const std::string& sections, const std::string& why)
{
    const RobotModel model = read(world, sections);
    EXPECT_NE(first_error(model).find(why), std::string::npos)
        << world << sections << "\n  says: " << first_error(model) << "\n  not: " << why;
    for (const ReportLine& line : model.report)
        EXPECT_TRUE(line.note != Note::kError || line.line == 2) << line.text;
}

TEST(MjcfReferences, to_what_is_not_there_are_refused_with_the_nearest_name)
{
    const char* const sections[][2] = {
        {"<sensor><jointpos joint='elbo'/></sensor>",
         "<jointpos> joint is 'elbo', and no joint is called so; did you mean 'elbow'?"},
        {"<sensor><gyro site='tipp'/></sensor>", "no site is called so; did you mean 'tip'?"},
        {"<sensor><framepos objtype='body' objname='nobody'/></sensor>", "no body is called so"},
        {"<sensor><framepos objtype='site' objname='tip' reftype='camera' refname='ear'/></sensor>",
         "no camera is called so"},
        {"<sensor><user dim='1' objtype='body' objname='z'/></sensor>", "no body is called so"},
        {"<actuator><motor tendon='no'/></actuator>", "no tendon is called so"},
        {"<actuator><motor joint='kne'/></actuator>", "there is no joint 'kne'"},
        {"<tendon><spatial material='rad'><site site='tip'/><site site='foot'/></spatial></tendon>",
         "did you mean 'red'?"},
        {"<asset><material name='m' texture='wod'/></asset>", "did you mean 'wood'?"},
        {"<custom><tuple name='t'><element objtype='body' objname='x'/></tuple></custom>",
         "no body is called so"},
        {"<equality><tendon tendon1='t'/></equality>", "no tendon is called so"}};
    for (const auto& [section, why] : sections) expect_refused("", section, why);
    expect_refused("<geom size='.1' material='redd'/>", "",
                   "<geom> material is 'redd', and no material is called so; did you mean 'red'?");
    expect_refused("<camera mode='targetbody' target='bb'/>", "", "<camera> target is 'bb'");
    expect_refused("<light mode='targetbody' target='q'/>", "", "no body is called so");
}

TEST(MjcfReferences, to_copies_to_what_stands_behind_and_to_attached_names_are_good)
{
    const RobotModel copied = read(
        "<replicate count='3' offset='0 1 0'><body name='r' pos='0 0 1'><joint name='hinge'/><geom name='s' "
        "size='.1'/></body></replicate>",
        "<sensor><jointpos joint='hinge'/><jointvel joint='hinge1'/></sensor><actuator><motor "
        "joint='hinge2'/></actuator>");
    EXPECT_EQ(first_error(copied), "");
    EXPECT_EQ(copied.sensors.size(), 4u);
    EXPECT_EQ(first_error(load_robot_text(
                  "robot.xml",
                  "<mujoco><sensor><jointpos joint='late'/></sensor><worldbody><camera mode='targetbody' "
                  "target='far'/><body name='far'><joint name='late'/><geom "
                  "size='.1'/></body></worldbody></mujoco>")),
              "");
    EXPECT_EQ(first_error(read("", "<equality><weld body1='b' body2='world'/></equality>")), "");
}

TEST(MjcfValues, that_are_no_keywords_are_refused)
{
    expect_refused("", "<option integrator='Eular'/>",
                   "and there are Euler RK4 implicit implicitfast; did you mean 'Euler'?");
    expect_refused("", "<actuator><general joint='elbow' dyntype='filtr'/></actuator>",
                   "did you mean 'filter'?");
    expect_refused("", "<sensor><framepos objtype='link' objname='b'/></sensor>",
                   "<framepos> objtype is 'link'");
    expect_refused("<camera mode='follow'/>", "", "<camera> mode is 'follow'");
    EXPECT_EQ(first_error(read(
                  "", "<custom><tuple name='t'><element objtype='joint' objname='elbow'/></tuple></custom>")),
              "");
}

TEST(MjcfValues, that_an_element_needs_are_missed)
{
    expect_refused("", "<sensor><jointpos/></sensor>", "<jointpos> has no 'joint', and needs one");
    expect_refused("", "<sensor><framepos objtype='body' objname='b' refname='c'/></sensor>",
                   "only one of 'reftype' and 'refname'");
    expect_refused("", "<tendon><fixed><joint joint='elbow'/></fixed></tendon>", "<joint> has no 'coef'");
    expect_refused("", "<tendon><fixed name='t'/></tendon>", "names no joint");
    expect_refused("", "<equality><connect body1='b'/></equality>",
                   "wants site1 and site2, or body1 and anchor");
    expect_refused("", "<equality><joint joint1='elbow' joint2='elbow'/></equality>",
                   "of 'elbow' and itself");
    expect_refused("", "<actuator><motor/></actuator>", "names nothing to act on");
    expect_refused("<body><joint/><inertial mass='1' diaginertia='1 1 1'/></body>", "",
                   "<inertial> has no 'pos'");
}

TEST(MjcfValues, of_orientations_stand_once_and_are_not_zero)
{
    expect_refused("<geom size='.1' quat='0 0 0 0'/>", "", "which is no orientation");
    expect_refused("<geom size='.1' quat='1 0 0 0' euler='0 0 0'/>", "",
                   "has 'quat' and 'euler': one of them");
}

TEST(MjcfValues, of_what_nothing_here_uses_are_numbers_all_the_same)
{
    expect_refused("", "<visual><map znear='near'/></visual>", "map znear = 'near', wanted finite numbers");
    expect_refused("", "<statistic extent='1 x'/>", "wanted 1 finite number");
    expect_refused("", "<custom><numeric name='n' data='1 x'/></custom>", "data = '1 x'");
    expect_refused("", "<custom><numeric name='n' size='2' data='1 2 3'/></custom>",
                   "numeric data = '1 2 3', wanted 0 to 2");
    expect_refused("", "<custom><numeric name='n'/></custom>", "has no numbers");
    expect_refused("", "<custom><text name='t'/></custom>", "has no data");
    expect_refused("", "<custom><tuple name='t'/></custom>", "has no element");
    for (const char* good : {"<custom><numeric name='n' size='3' data='1'/></custom>",
                             "<custom><numeric name='n' size='3'/></custom>",
                             "<custom><numeric name='n' data='1 2'/><text name='t' data='x'/></custom>"})
        EXPECT_EQ(first_error(read("", good)), "") << good;
}

TEST(MjcfValues, of_the_user_are_as_many_as_sizes_say)
{
    const std::string motor = "<actuator><motor joint='elbow' user='1 2 3'/></actuator>";
    expect_refused("", "<size nuser_actuator='2'/>" + motor,
                   "<motor> user has 3 numbers, and <size> nuser_actuator is 2");
    expect_refused("", motor + "<size nuser_actuator='2'/>", "nuser_actuator is 2");
    expect_refused("", "<size nuser_jnt='1'/><default><joint user='1 2'/></default>", "nuser_jnt is 1");
    expect_refused("", "<size nuser_body='-2'/>", "nuser_body is below -1");
    expect_refused("", "<sensor><jointpos joint='elbow' user='a'/></sensor>", "user = 'a'");
    for (const char* size : {"", "<size nuser_actuator='3'/>", "<size nuser_actuator='-1'/>"})
        EXPECT_EQ(first_error(read("", size + motor)), "") << size;
}

TEST(MjcfValues, of_keys_are_as_many_as_there_are_coordinates_and_filters)
{
    expect_refused("", "<keyframe><key act='1'/></keyframe>", "key act = '1', wanted 0");
    expect_refused("", "<keyframe><key qpos='1 2 3'/></keyframe>", "key qpos");
    const RobotModel short_key =
        read("", "<keyframe><key qpos='0.5'/></keyframe>");  // the rest is at its reference
    ASSERT_EQ(first_error(short_key), "");
    EXPECT_EQ(short_key.starts.at(0).positions, (std::vector<double>{0.5, 0}));
    const RobotModel moving = read("", "<keyframe><key qpos='0 0' qvel='1 0'/></keyframe>");
    EXPECT_EQ(moving.report.back().note, Note::kApproximated);
    EXPECT_EQ(first_error(read("",
                               "<actuator><general joint='elbow' dyntype='filter' dynprm='.1'/></actuator>"
                               "<keyframe><key act='1'/></keyframe>")),
              "");
}

TEST(MjcfValues, of_joints_fit_each_other)
{
    const auto body = [](const std::string& joints) {
        return "<body>" + joints + "<geom size='.1'/></body>";
    };
    expect_refused(body("<joint type='free'/><joint/>"), "", "more than six freedoms");
    expect_refused(body("<joint type='ball'/><joint/>"), "", "behind a ball");
    expect_refused(body("<joint type='ball' range='-20 20'/>"), "", "begins at 0");
    expect_refused(body("<joint limited='true'/>"), "", "<joint> limited is true, and no range says");
    expect_refused("<joint/>", "", "<joint> in the world");
    expect_refused("<inertial pos='0 0 0' mass='1'/>", "", "<inertial> in the world");
    expect_refused("<geom type='sphere' size='.1' fromto='0 0 0 0 0 1'/>", "", "a sphere has no fromto");
    expect_refused("<geom size='.1' condim='2'/>", "", "condim is 2, and there are 1 3 4 6");
    expect_refused("<site type='plane'/>", "", "a site of type plane");
    expect_refused("", "<actuator><position joint='elbow' kv='1' dampratio='1'/></actuator>", "one of them");
    expect_refused("", "<actuator><motor joint='elbow' forcelimited='true'/></actuator>",
                   "no forcerange says");
    expect_refused("", "<sensor><touch site='tip' cutoff='-1'/></sensor>", "cutoff is below 0");
    EXPECT_EQ(first_error(read(
                  body("<joint type='slide'/><joint type='ball'/><joint type='slide' axis='1 0 0'/>"), "")),
              "");
}

// A range of equal ends is none, where nothing says that it is one: MuJoCo has no limit there.
TEST(MjcfValues, of_ranges_of_no_length_are_no_limits)
{
    const RobotModel model = read("<body><joint name='j' range='0 0'/><geom size='.1'/></body>",
                                  "<actuator><motor joint='j' ctrlrange='0 0'/></actuator>");
    ASSERT_EQ(first_error(model), "");
    EXPECT_FALSE(model.joints.back().limited);
    EXPECT_EQ(model.actuators.back().high, kInfinity);
}

}  // namespace
