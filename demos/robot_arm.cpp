// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// An arm of seven axes draws a circle on a slanted board. Inverse kinematics says where the axes must be; inverse
// dynamics says which torques make them accelerate there, against gravity:
//     torque = M(q) (q''* + 2 w (q'* - q') + w^2 (q* - q)) + h(q, q') + d q',    w = 30 / s.
#include <cmath>

#include "robot_stage.h"

static constexpr double kRadius = 0.12, kTurn = 5, kStart = 1.5, kBandwidth = 30;  // m, s, s, rad/s
static constexpr int kAxes = 7, kStepsAFrame = 8;
static constexpr double kH = 1.0 / 60 / kStepsAFrame;
// The board's middle, and its axes to the right and up.
static const double kMiddle[3] = {0.7, 0, 0.48}, kRight[3] = {0, 1, 0}, kUp[3] = {0.5, 0, 0.8660254037844386};

static demo::Robot arm;
static std::vector<dReal> wanted[3], before;  // positions now, a step later, two steps later
static double worst = 0, sum = 0, largest_torque = 0;
static int counted = 0;
static std::vector<dReal> line;

// Smoothly from rest to a steady turn.
static double angle(double t)
{
    const double s = t - kStart, whole = 2 * M_PI / kTurn;
    if (s <= 0) return 0;
    return s < 1 ? whole * (s * s * s - s * s * s * s / 2) : whole * (s - 0.5);
}

static void on_circle(double t, double* out)
{
    const double a = angle(t);
    for (int i = 0; i < 3; ++i)
        out[i] = kMiddle[i] + kRadius * (std::cos(a) * kRight[i] + std::sin(a) * kUp[i]);
}

// From the last answer on, so that axes move on smoothly; the pen stands on the board.
static std::vector<dReal> axes_at(double t, std::vector<dReal> guess)
{
    dRobotTarget pen = arm.target("pen");
    double place[3];
    on_circle(t, place);
    for (int i = 0; i < 3; ++i) pen.position[i] = place[i];
    const dReal into[4] = {0.5, 0, 0.8660254037844386, 0};  // z turned by 120 degrees about y
    for (int i = 0; i < 4; ++i) pen.q[i] = into[i];
    pen.orientation_weight = 1;
    dRobotInverseResult result;
    result.struct_size = sizeof result;
    const std::vector<dReal> posture = {0, 0.3, 0, -1.6, 0, 0.8, 0};
    dRobotInverseOptions options;
    dRobotInverseOptionsInit(&options, sizeof options);
    options.posture = posture.data();
    dRobotModelGetInverse(arm.model, &pen, 1, t == 0 ? &options : nullptr, guess.data(), &result);
    demo::claim(result.is_reached, "the circle is out of reach by %g m at %g s",
                double(result.position_error), t);
    return guess;
}

static void build()
{
    arm.load("arm.urdf");
    const dGeomID board =
        demo::paint(demo::draw(dCreateBox(demo::space, 0.36, 0.5, 0.02)), 0.35f, 0.45f, 0.40f);
    dMatrix3 slant;
    dRFromAxisAndAngle(slant, 0, 1, 0, -M_PI / 3);
    dGeomSetRotation(board, slant);
    dGeomSetPosition(board, kMiddle[0] + 0.016 * 0.866, 0, kMiddle[2] - 0.016 * 0.5);
    wanted[0] = axes_at(0, {0, 0.3, 0, -1.6, 0, 0.8, 0});
    wanted[1] = axes_at(kH, wanted[0]);
    before = wanted[0];
    dRobotSetPositions(arm.robot, wanted[0].data(), kAxes);
}

static void draw_line(const dVector3 tip, double t)
{
    if (t > kStart) line.insert(line.end(), {tip[0], tip[1], tip[2]});
    dsSetTexture(DS_NONE);
    dsSetColor(0.98f, 0.96f, 0.90f);
    for (size_t i = 3; i < line.size(); i += 3) dsDrawLine(&line[i - 3], &line[i]);
}

static void every_step(double t)
{
    wanted[2] = axes_at(t + 2 * kH, wanted[1]);
    const std::vector<dReal> q = arm.positions(), v = arm.velocities();
    dReal acceleration[kAxes], torque[kAxes];
    for (size_t i = 0; i < kAxes; ++i) {
        const double rate = (wanted[1][i] - before[i]) / (2 * kH),
                     bend = (wanted[1][i] - 2 * wanted[0][i] + before[i]) / (kH * kH);
        acceleration[i] =
            bend + 2 * kBandwidth * (rate - v[i]) + kBandwidth * kBandwidth * (wanted[0][i] - q[i]);
    }
    dRobotModelGetInverseDynamics(arm.model, q.data(), v.data(), acceleration, torque, kAxes);
    const double damping[kAxes] = {1, 1, 0.6, 0.6, 0.3, 0.2, 0.1};  // as in the file
    for (int i = 0; i < kAxes; ++i) {
        dRobotSetControl(arm.robot, i, torque[i] + damping[i] * v[size_t(i)]);
        largest_torque = std::fmax(largest_torque, std::fabs(torque[i]));
    }
    dVector3 tip;
    arm.place("pen", tip);
    double place[3];
    on_circle(t, place);
    double error = 0;
    for (int i = 0; i < 3; ++i) error += (tip[i] - place[i]) * (tip[i] - place[i]);
    worst = std::fmax(worst, std::sqrt(error)), sum += error, ++counted;
    if (counted % kStepsAFrame == 0) draw_line(tip, t);
    before = wanted[0], wanted[0] = wanted[1], wanted[1] = wanted[2];
}

static void judge()
{
    demo::print("largest distance from the circle", 1000 * worst, "mm");
    demo::print("root mean square", 1000 * std::sqrt(sum / counted), "mm");
    demo::print("largest torque", largest_torque, "N m");
    demo::claim(worst < 1e-3, "the pen leaves the circle by %g m", worst);
    arm.destroy();
}

int main(int argc, char** argv)
{
    return demo::run(
        argc, argv,
        {{-0.35f, -1.45f, 1.15f}, {58, -22, 0}, 8, build, judge, every_step, nullptr, nullptr, kStepsAFrame});
}
