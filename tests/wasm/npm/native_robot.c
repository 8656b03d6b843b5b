/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * The native side of robots_test.mjs: native_robot FILE HEIGHT STEPS STATES reads the robot FILE with what it names in its folder, puts it
 * HEIGHT m above a floor, moves its actuators (or, where it has none, its hinges and sliders) by waves, and writes the world's state after
 * STEPS steps of 2 ms to STATES. */
#include <epode/robots.h>
#include <math.h>
#include <ode/ext.h>
#include <ode/ode.h>
#include <stdio.h>
#include <stdlib.h>

static const dReal kStep = 0.002;

/* Steps of a triangle wave: no sine, whose last bit is the C library's affair. */
static dReal wave(int step, int i)
{
    const int at = (step + 37 * i) % 400;
    return (at < 200 ? at - 100 : 300 - at) / (dReal)128;
}

static void drive(dRobotID robot, dRobotModelID model, int step)
{
    const int actuators = dRobotModelGetNumActuators(model), count = dRobotModelGetJoints(model, 0, 0);
    dRobotJoint* joints = malloc(sizeof *joints * (size_t)(count + 1));
    int i;
    dRobotModelGetJoints(model, joints, count);
    for (i = 0; i < actuators; ++i) dRobotSetControl(robot, i, wave(step, i));
    for (i = 0; actuators == 0 && i < count; ++i)
        if (joints[i].kind == dRobotHinge || joints[i].kind == dRobotSlide) dRobotSetTarget(robot, i, wave(step, i) / 4, 64, 4);
    free(joints);
}

static int write_state(dWorldID world, const char* path)
{
    const size_t size = dWorldGetStateSize(world);
    void* state = malloc(size);
    FILE* file = fopen(path, "wb");
    const int good = state && file && dWorldGetState(world, state, size) && fwrite(state, 1, size, file) == size;
    free(state);
    return file && !fclose(file) && good;
}

int main(int count, char** arguments)
{
    dWorldID world;
    dSpaceID space;
    dRobotModelID model;
    dRobotID robot;
    dReal place[3] = {0, 0, 0};
    int i, steps;
    if (count != 5 || !dInitODE2(0)) return 2;
    world = dWorldCreate();
    dWorldUseDefaults(world, dDefaultsRobot);
    space = dHashSpaceCreate(0);
    dWorldSetContactSpace(world, space);
    dWorldSetGravity(world, 0, 0, -9.81);
    dCreatePlane(space, 0, 0, 1, 0);
    model = dRobotModelLoad(arguments[1], NULL);
    place[2] = atof(arguments[2]);
    robot = dRobotCreate(world, space, model, place, NULL);
    if (!robot) return 1;
    steps = atoi(arguments[3]);
    for (i = 0; i < steps; ++i) {
        drive(robot, model, i);
        dRobotAddForces(robot, kStep);
        if (!dWorldStepHybrid(world, kStep)) return 1;
    }
    return !write_state(world, arguments[4]);
}
