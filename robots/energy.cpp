// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See energy.h. Half s'Ms of the velocities s; -m g.c of a link's centre c, less what of it is not pulled; half k e^2 of a spring, e of
// a ball being its angle from the reference.
#include "robots/energy.h"

#include <algorithm>
#include <cmath>

#include "robots/body_poses.h"
#include "robots/kinematics.h"

namespace epode::robots {

namespace {

double half_square(double stiffness, double extension) { return stiffness * extension * extension / 2; }

double of_joint(const Joint& joint, const std::vector<double>& positions)
{
    const double* const q = &positions[size_t(joint.position)];
    if (joint.is_scalar()) return half_square(joint.stiffness, q[0] - joint.spring_reference);
    if (joint.kind == JointKind::kFree) return 0;
    return half_square(joint.stiffness, 2 * std::atan2(length(Vec{q[1], q[2], q[3]}), std::fabs(q[0])));
}

double of_gravity(const Link& link, const Pose& pose, Vec gravity)
{
    if (link.is_weightless) return 0;
    double out = -link.mass * dot(gravity, pose * link.centre);
    for (const Lift& lift : link.lifts) out += lift.share * lift.mass * dot(gravity, pose * lift.centre);
    return out;
}

}  // namespace

double kinetic_energy(const Robot& robot)
{
    const std::vector<double> s = robot.velocities(), m = mass_matrix(robot.model(), robot.positions());
    double sum = 0;
    for (size_t i = 0; i < s.size(); ++i)
        for (size_t k = 0; k < s.size(); ++k) sum += s[i] * m[i * s.size() + k] * s[k];
    return sum / 2;
}

double potential_energy(const Robot& robot, Vec gravity)
{
    const RobotModel& model = robot.model();
    const std::vector<double> positions = robot.positions();
    double sum = 0;
    for (size_t i = 1; i < model.links.size(); ++i)
        sum += of_gravity(model.links[i], robot.link_pose(int(i)), gravity);
    for (const Joint& joint : model.joints)
        if (joint.stiffness > 0) sum += of_joint(joint, positions);
    for (size_t i = 0; i < model.tendons.size(); ++i) {
        if (!(model.tendons[i].stiffness > 0)) continue;
        const double length = robot.tendon_stroke(int(i)).length;
        const auto [low, high] = robot.rests()[i];
        sum += half_square(model.tendons[i].stiffness,
                           length > high ? length - high : std::min(0.0, length - low));
    }
    return sum;
}

}  // namespace epode::robots
