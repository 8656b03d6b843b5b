// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What demos of robots share: a robot from a file of demos/robots in the stage's world, and its coordinates by name.
#pragma once

#include <epode/robot_sensors.h>

#include <string>
#include <vector>

#include "stage.h"

namespace demo {

constexpr bool kIsDouble = sizeof(dReal) == 8;  // the library's precision, which decides what can be claimed

struct Robot {
    dRobotModelID model = nullptr;
    dRobotID robot = nullptr;

    // Links in turn get light and dark paint.
    void load(const std::string& file);
    void destroy();  // before the world

    std::vector<dReal> positions() const;
    std::vector<dReal> velocities() const;
    dRobotJoint joint(const char* name) const;
    int actuator(const char* name) const { return dRobotModelFindActuator(model, name); }
    // A target of inverse kinematics for a frame's origin, any way it is turned.
    dRobotTarget target(const char* frame) const;
    // Where a frame's origin is, of a body.
    void place(const char* frame, dVector3 out) const;
};

// A figure of the verdict, for those who read it.
void print(const char* what, double value, const char* unit);

}  // namespace demo
