// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// States of worlds with robots: they load whatever has been controlled before and after, and with a robot's own numbers
// controls, activations and targets come back.
#include <ode/ext.h>
#include <climits>

#include <string>
#include <vector>

#include "robot_in_world.h"

namespace {

constexpr const char* kJoints[] = {"axis='0 1 0'", "type='slide' axis='1 0 0'",
                                   "type='slide' axis='1 0 0' range='-1 1'"};

std::string arm(const std::string& joint, const std::string& actuator = "<motor joint='j'/>")
{
    return "<mujoco><compiler angle='radian'/><worldbody><body><joint name='j' " + joint +
           "/><geom type='capsule' fromto='0 0 0 0 0 1' size='.02'/><body pos='0 0 1'><joint name='k' "
           "axis='0 1 "
           "0'/><geom size='.1'/></body></body></worldbody><actuator>" +
           actuator + "</actuator></mujoco>";
}

using Bytes = std::vector<char>;
using Numbers = std::vector<dReal>;

class RobotStates : public RobotInWorld {
  protected:
    Bytes state_of_world()
    {
        Bytes out(dWorldGetStateSize(world));
        EXPECT_EQ(dWorldGetState(world, out.data(), out.size()), 1);
        return out;
    }
    Numbers numbers() const
    {
        Numbers out(size_t(dRobotGetState(robot, nullptr, 0)));
        dRobotGetState(robot, out.data(), int(out.size()));
        return out;
    }
    bool load_state(const Bytes& bytes) { return dWorldSetState(world, bytes.data(), bytes.size()); }
    Numbers velocities() const
    {
        Numbers out(size_t(dRobotGetVelocities(robot, nullptr, 0)));
        dRobotGetVelocities(robot, out.data(), int(out.size()));
        return out;
    }
    void steps(int count)
    {
        for (int i = 0; i < count; ++i) dRobotAddForces(robot, dReal(0.01)), dWorldStep(world, dReal(0.01));
    }
};

// A control used to switch a drive on, and the state then belonged to another structure.
TEST_F(RobotStates, load_whatever_is_controlled_before_and_after)
{
    for (const char* joint : kJoints)
        for (const int preset : {dDefaultsOde, dDefaultsGame, dDefaultsRobot}) {
            dWorldUseDefaults(world, preset);
            for (const dReal before : {dReal(0), dReal(1)}) {
                load(arm(joint));
                dRobotSetControl(robot, 0, before);
                const Bytes saved = state_of_world();
                dRobotSetControl(robot, 0, 2);
                dRobotSetTarget(robot, 1, 1, 10, 1);
                steps(1);
                EXPECT_TRUE(load_state(saved)) << joint << ' ' << preset << ' ' << before;
            }
        }
}

TEST_F(RobotStates, bring_controls_and_targets_back_with_the_same_bits)
{
    for (const char* joint : kJoints) {
        load(arm(joint));
        dRobotSetControl(robot, 0, dReal(0.75));
        dRobotSetTarget(robot, 1, dReal(0.5), 10, 1);
        steps(3);
        const Bytes saved = state_of_world();
        const Numbers its = numbers();
        steps(20);
        const Numbers first = velocities();
        dRobotSetControl(robot, 0, -3);
        dRobotSetTarget(robot, 1, 0, 0, 0);
        steps(5);
        ASSERT_TRUE(load_state(saved));
        ASSERT_EQ(dRobotSetState(robot, its.data(), int(its.size())), 1);
        EXPECT_EQ(dRobotGetControl(robot, 0), dReal(0.75));
        EXPECT_EQ(numbers(), its);
        steps(20);
        EXPECT_EQ(velocities(), first) << joint;
    }
}

TEST_F(RobotStates, bring_filters_back)
{
    load(arm("axis='0 1 0'", "<general joint='j' dyntype='filter' dynprm='0.1' gainprm='2'/>"));
    dRobotSetControl(robot, 0, 1);
    steps(5);
    const Bytes saved = state_of_world();
    const Numbers its = numbers();
    const dReal activation = dRobotGetActivation(robot, 0);
    steps(10);
    const Numbers first = velocities();
    dRobotSetActivation(robot, 0, 7);
    ASSERT_TRUE(load_state(saved));
    ASSERT_EQ(dRobotSetState(robot, its.data(), int(its.size())), 1);
    EXPECT_EQ(dRobotGetActivation(robot, 0), activation);
    steps(10);
    EXPECT_EQ(velocities(), first);
}

int messages;
void count(int, const char*, va_list) { ++messages; }

TEST_F(RobotStates, refuse_numbers_of_no_robot)
{
    load(arm("axis='0 1 0'", "<motor joint='j' ctrllimited='true' ctrlrange='-1 1'/>"));
    const Numbers good = numbers();
    messages = 0;
    dSetMessageHandler(&count);
    int calls = 0;
    const auto refused = [&](size_t place, dReal value) {
        Numbers bad = good;
        bad[place] = value;
        EXPECT_EQ(dRobotSetState(robot, bad.data(), int(bad.size())), 0) << place << ' ' << value;
        EXPECT_EQ(messages, ++calls);
        EXPECT_EQ(numbers(), good);
    };
    refused(0, 3);  // outside of the control's range
    refused(0, dReal(NAN));
    refused(3, 2);   // whether filters act
    refused(4, -1);  // stiffness of a servo
    EXPECT_EQ(dRobotSetState(robot, good.data(), int(good.size()) - 1), 0);
    EXPECT_EQ(dRobotSetState(robot, good.data(), INT_MAX), 0) << "reads no more than there are";
    EXPECT_EQ(dRobotSetState(nullptr, good.data(), int(good.size())), 0);
    EXPECT_EQ(dRobotGetState(robot, nullptr, -1), 0);
    EXPECT_EQ(dRobotGetControl(robot, 5), 0);
    EXPECT_EQ(messages, calls + 5);
    dSetMessageHandler(nullptr);
}

}  // namespace
