// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A gripper closes on a capsule, lifts it and holds it for 10 s by friction alone. Exact friction does not creep: the
// capsule's way in the fingers stays below a tenth of a millimetre.
#include <cmath>

#include "robot_stage.h"

static constexpr double kDown = 0.5, kClosed = 1, kUp = 2.5, kHeld = 3.5, kEnd = kHeld + 10;  // s

static demo::Robot gripper;
static dVector3 at_first;  // of the capsule in the palm's frame
static double creep = 0, least_grip = 1e9, mimic = 0;

static void place_in_palm(dVector3 out)
{
    const dReal* place =
        dBodyGetPosition(dRobotGetBody(gripper.robot, dRobotModelFindLink(gripper.model, "capsule")));
    dBodyGetPosRelPoint(dRobotGetBody(gripper.robot, dRobotModelFindLink(gripper.model, "palm")), place[0],
                        place[1], place[2], out);
}

static void build()
{
    gripper.load("gripper.xml");
    dReal q[10] = {0};
    for (size_t i = 0; i < 10; ++i) q[i] = gripper.positions()[i];
    q[0] = -0.35, q[1] = q[2] = -0.02;  // down, open
    dRobotSetPositions(gripper.robot, q, 10);
}

// What both pads bear, N.
static double grip()
{
    dReal left = 0, right = 0;
    dRobotReadSensor(gripper.robot, 0, nullptr, &left, 1);
    dRobotReadSensor(gripper.robot, 1, nullptr, &right, 1);
    return std::fmin(double(left), double(right));
}

static void every_step(double t)
{
    const double lift = t < kClosed ? 0 : t < kUp ? (t - kClosed) / (kUp - kClosed) : 1;
    dRobotSetControl(gripper.robot, gripper.actuator("lift"), -0.35 + 0.3 * lift * lift * (3 - 2 * lift));
    dRobotSetControl(gripper.robot, gripper.actuator("grip"), t < kDown ? 0 : 40);
    const std::vector<dReal> q = gripper.positions();
    mimic = std::fmax(mimic, std::fabs(double(q[2] - q[1])));
    dVector3 now;
    place_in_palm(now);
    if (t < kHeld) {
        for (int i = 0; i < 3; ++i) at_first[i] = now[i];
        return;
    }
    double way = 0;
    for (int i = 0; i < 3; ++i) way += (now[i] - at_first[i]) * (now[i] - at_first[i]);
    creep = std::fmax(creep, std::sqrt(way));
    least_grip = std::fmin(least_grip, grip());
}

static void judge()
{
    demo::print("the capsule's way in the fingers in 10 s", 1000 * creep, "mm");
    demo::print("least force on a pad", least_grip, "N");
    demo::print("largest difference of the fingers", 1e6 * mimic, "um");
    const dReal* place =
        dBodyGetPosition(dRobotGetBody(gripper.robot, dRobotModelFindLink(gripper.model, "capsule")));
    demo::claim(place[2] > 0.3, "the capsule is at %g m", double(place[2]));
    demo::claim(creep < 1e-4, "the capsule creeps by %g m", creep);
    demo::claim(mimic < (demo::kIsDouble ? 1e-6 : 1e-4), "the fingers differ by %g m", mimic);
    gripper.destroy();
}

int main(int argc, char** argv)
{
    return demo::run(
        argc, argv,
        {{0.50f, -0.42f, 0.50f}, {140, -8, 0}, kEnd, build, judge, every_step, nullptr, nullptr, 4, true});
}
