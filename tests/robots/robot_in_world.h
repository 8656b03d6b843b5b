// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A world with a robot of a text, through the C API.
#pragma once

#include <epode/robots.h>
#include <gtest/gtest.h>

#include <string>

class RobotInWorld : public testing::Test {
  protected:
    RobotInWorld()
    {
        dInitODE2(0);
        world = dWorldCreate();
    }
    ~RobotInWorld() override
    {
        drop();
        dWorldDestroy(world);
        dCloseODE();
    }
    // In place of the one before.
    void load(const std::string& text)
    {
        drop();
        model = dRobotModelLoadText("robot.xml", text.data(), text.size(), nullptr);
        ASSERT_EQ(dRobotModelHasErrors(model), 0);
        robot = dRobotCreate(world, space, model, nullptr, nullptr);
        ASSERT_NE(robot, nullptr);
    }

    void drop()
    {
        if (robot) dRobotDestroy(robot);
        if (model) dRobotModelDestroy(model);
        robot = nullptr, model = nullptr;
    }

    dWorldID world;
    dSpaceID space = nullptr;  // none
    dRobotModelID model = nullptr;
    dRobotID robot = nullptr;
};
