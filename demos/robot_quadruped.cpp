// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A quadruped of 12 kg stands up and trots. Feet of a diagonal pair swing while the others push: each follows a curve under
// its hip, and inverse kinematics with the trunk locked says where its three axes must be; servos pull them there.
#include <cmath>

#include "robot_stage.h"

static constexpr double kStand = 1.5, kPeriod = 0.56, kStride = 0.18, kLift = 0.07, kHeight = 0.30, kEnd = 12;
static constexpr int kLegs = 4, kStepsAFrame = 4;
static const char* const kNames[kLegs] = {"front_left", "front_right", "hind_left", "hind_right"};

static demo::Robot robot;
static std::vector<dReal> axes;  // of the last answer: the trunk at the origin
static std::vector<dRobotTarget> feet;
static dVector3 home[kLegs];  // of the feet under the trunk
static double start_x = 0, start_y = 0, lowest = 1, tilt = 0, drift = 0;
static int airborne = 0, trotting = 0;

static void build()
{
    robot.load("quadruped.xml");
    axes.resize(static_cast<size_t>(dRobotModelGetNumPositions(robot.model)));
    dRobotModelGetStart(robot.model, 0, axes.data(), static_cast<int>(axes.size()));
    dRobotSetPositions(robot.robot, axes.data(), static_cast<int>(axes.size()));
    axes[0] = axes[1] = axes[2] = 0;
    for (int leg = 0; leg < kLegs; ++leg) {
        dRobotTarget foot = robot.target((std::string(kNames[leg]) + "_shank").c_str());
        foot.point[2] = -0.2;
        feet.push_back(foot);
        home[leg][0] = leg < 2 ? 0.2 : -0.2, home[leg][1] = leg % 2 ? -0.18 : 0.18, home[leg][2] = -kHeight;
    }
}

// Along the stride and upwards, of a phase in 0 ... 1: the first half on the ground.
static void step_of(double phase, double share, double* forward, double* up)
{
    const double half = phase < 0.5 ? 2 * phase : 2 * phase - 1;
    const double smooth = half * half * (3 - 2 * half);
    *forward = share * kStride * (phase < 0.5 ? 0.5 - half : smooth - 0.5);
    *up = phase < 0.5 ? 0 : share * kLift * std::sin(M_PI * half) * std::sin(M_PI * half);
}

static void control(double t)
{
    const double share = t < kStand ? 0 : std::fmin(1, (t - kStand) / (2 * kPeriod));
    for (int leg = 0; leg < kLegs; ++leg) {
        const double own = leg == 0 || leg == 3 ? 0 : 0.5, turns = t / kPeriod + own;
        double forward, up;
        step_of(turns - std::floor(turns), share, &forward, &up);
        dReal* place = feet[static_cast<size_t>(leg)].position;
        place[0] = home[leg][0] + forward, place[1] = home[leg][1], place[2] = home[leg][2] + up;
    }
    std::vector<dReal> weights(static_cast<size_t>(dRobotModelGetNumVelocities(robot.model)), 1);
    for (size_t i = 0; i < 6; ++i) weights[i] = 0;  // the trunk
    dRobotInverseOptions options;
    dRobotInverseOptionsInit(&options, sizeof options);
    options.weights = weights.data();
    demo::claim(dRobotModelGetInverse(robot.model, feet.data(), kLegs, &options, axes.data(), nullptr) == 1,
                "a foot's curve is out of reach at %g s", t);
    const double rise = std::fmin(1, t / 1.0);  // from the crouch
    std::vector<dReal> crouched(axes.size());
    dRobotModelGetStart(robot.model, 0, crouched.data(), static_cast<int>(crouched.size()));
    for (int i = 0; i < 3 * kLegs; ++i) {
        const size_t k = static_cast<size_t>(7 + i);
        dRobotSetControl(robot.robot, i, crouched[k] + rise * (axes[k] - crouched[k]));
    }
}

static void watch(double t)
{
    const dBodyID trunk = dRobotGetBody(robot.robot, dRobotModelFindLink(robot.model, "trunk"));
    const dReal *place = dBodyGetPosition(trunk), *turn = dBodyGetRotation(trunk);
    if (t < kStand) {
        start_x = place[0], start_y = place[1];
        return;
    }
    lowest = std::fmin(lowest, double(place[2]));
    tilt = std::fmax(tilt, std::acos(std::fmin(1.0, double(turn[10]))) * 180 / M_PI);
    drift = std::fmax(drift, std::fabs(place[1] - start_y));
    int standing = 0;
    for (const dRobotTarget& foot : feet) {
        dRobotTouch touch;
        touch.struct_size = sizeof touch;
        dRobotGetTouch(robot.robot, foot.link, &touch);
        standing += touch.points > 0;
    }
    ++trotting, airborne += standing < 2;
}

static void every_step(double t)
{
    control(t);
    watch(t);
}

static void judge()
{
    const dReal* place =
        dBodyGetPosition(dRobotGetBody(robot.robot, dRobotModelFindLink(robot.model, "trunk")));
    const double walked = place[0] - start_x;
    demo::print("walked", walked, "m");
    demo::print("speed", walked / (kEnd - kStand), "m/s");
    demo::print("off its line by", drift, "m");
    demo::print("lowest trunk", lowest, "m");
    demo::print("largest tilt", tilt, "degrees");
    demo::print("time with fewer than two feet on the ground", 100.0 * airborne / trotting, "%");
    demo::claim(walked > 3, "it walked %g m", walked);
    demo::claim(lowest > 0.22 && tilt < 15, "it fell to %g m or tilted by %g degrees", lowest, tilt);
    demo::claim(drift < 0.5, "it went %g m off its line", drift);
    robot.destroy();
}

int main(int argc, char** argv)
{
    return demo::run(argc, argv,
                     {{1.25f, -1.25f, 0.75f},
                      {118, -17, 0},
                      kEnd,
                      build,
                      judge,
                      every_step,
                      nullptr,
                      nullptr,
                      kStepsAFrame,
                      true});
}
