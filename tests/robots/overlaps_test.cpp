// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Links of an MJCF robot that overlap: those that can never part do not touch, with a message; others do.
#include <ode/ext.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "robot_in_world.h"

namespace {

std::string said;
int messages;
void note(int, const char* text, va_list arguments)
{
    char line[512];
    std::vsnprintf(line, sizeof line, text, arguments);
    said = line, ++messages;
}

// A shoulder: the third link begins z above the joints of the first two.
std::string shoulder(const std::string& z)
{
    return "<mujoco><compiler angle='radian'/><option gravity='0 0 0'/><worldbody><body name='l1' pos='0 0 "
           ".3'>"
           "<joint axis='0 0 1'/><geom type='capsule' size='.05' fromto='0 0 0 0 0 .1' mass='3'/><body "
           "name='l2'>"
           "<joint axis='0 1 0'/><geom type='capsule' size='.05' fromto='0 0 0 0 0 .3' mass='3'/><body "
           "name='l3' "
           "pos='0 0 " +
           z +
           "'><joint axis='0 0 1'/><geom type='capsule' size='.05' fromto='0 0 0 0 0 .1' "
           "mass='3'/></body></body>"
           "</body></worldbody></mujoco>";
}

class RobotOverlaps : public RobotInWorld {
  protected:
    RobotOverlaps() { said.clear(), messages = 0, dSetMessageHandler(&note); }
    ~RobotOverlaps() override { dSetMessageHandler(nullptr); }
    bool may_touch(int one, int two) const
    {
        return !dAreConnected(dRobotGetBody(robot, one), dRobotGetBody(robot, two));
    }
};

TEST_F(RobotOverlaps, that_never_part_do_not_touch)
{
    for (const int preset : {dDefaultsOde, dDefaultsGame, dDefaultsRobot}) {
        dWorldUseDefaults(world, preset);
        messages = 0;
        load(shoulder(".05"));
        EXPECT_EQ(messages, 1);
        EXPECT_NE(said.find("links 'l1' and 'l3' overlap wherever"), std::string::npos) << said;
        EXPECT_FALSE(may_touch(1, 3));
    }
}

// From 90 degrees on they are apart.
TEST_F(RobotOverlaps, that_can_part_touch)
{
    load(shoulder(".15"));
    EXPECT_EQ(messages, 0) << said;
    EXPECT_TRUE(may_touch(1, 3));
}

TEST_F(RobotOverlaps, of_free_bodies_touch)
{
    load(
        "<mujoco><worldbody><body name='a'><freejoint/><geom size='.1'/></body><body name='b' pos='.05 0 0'>"
        "<freejoint/><geom size='.1'/></body></worldbody></mujoco>");
    EXPECT_EQ(messages, 0) << said;
    EXPECT_TRUE(may_touch(1, 2));
}

// Without a push it stays at rest: contacts threw it with 770 rad/s in the second step.
TEST_F(RobotOverlaps, do_not_throw_the_robot)
{
    for (const int preset : {dDefaultsOde, dDefaultsGame, dDefaultsRobot}) {
        dWorldID own = dWorldCreate();
        dWorldUseDefaults(own, preset);
        const dSpaceID geoms = dHashSpaceCreate(nullptr);
        dWorldSetContactSpace(own, geoms);
        load(shoulder(".05"));
        const dRobotID arm = dRobotCreate(own, geoms, model, nullptr, nullptr);
        const dReal start[] = {dReal(0.3), dReal(0.7), dReal(-0.2)};
        dRobotSetPositions(arm, start, 3);
        dReal fastest = 0, rates[3];
        for (int i = 0; i < 200; ++i) {
            dWorldStepHybrid(own, dReal(0.002));
            dRobotGetVelocities(arm, rates, 3);
            for (dReal rate : rates) fastest = std::max(fastest, std::fabs(rate));
        }
        EXPECT_LT(fastest, 1e-3) << preset;
        dRobotDestroy(arm);
        dWorldDestroy(own);
        dSpaceDestroy(geoms);
    }
}

}  // namespace
