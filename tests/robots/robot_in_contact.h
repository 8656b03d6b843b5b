// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A robot of a text in a world that manages its contacts, stepped with all that acts from step to step.
#pragma once

#include <epode/robot_sensors.h>
#include <ode/ext.h>

#include <vector>

#include "robot_in_world.h"

// A tolerance, in floats a wider one.
inline double fine(double in_doubles, double in_floats = 1e-2)
{
    return sizeof(dReal) == 8 ? in_doubles : in_floats;
}

class RobotInContact : public RobotInWorld {
  protected:
    RobotInContact()
    {
        space = dHashSpaceCreate(nullptr);
        dWorldSetContactSpace(world, space);
    }
    ~RobotInContact() override
    {
        drop();
        dSpaceDestroy(space);
    }
    void step(int count, double h = 0.002)
    {
        for (int i = 0; i < count; ++i) {
            dRobotAddForces(robot, dReal(h));
            dWorldStep(world, dReal(h));
            dRobotUpdateSensors(robot, dReal(h));
        }
    }
    std::vector<double> sensor(int number)
    {
        dReal values[8];
        const int count = dRobotReadSensor(robot, number, space, values, 8);
        return {values, values + count};
    }
    std::vector<double> velocities()
    {
        std::vector<dReal> out(size_t(dRobotModelGetNumVelocities(model)));
        dRobotGetVelocities(robot, out.data(), int(out.size()));
        return {out.begin(), out.end()};
    }
};
