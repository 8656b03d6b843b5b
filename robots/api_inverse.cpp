// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The C functions of frames and inverse kinematics: see api.h.
#include "robots/api.h"
#include "robots/body_poses.h"
#include "robots/inverse.h"
#include "robots/kinematics.h"

using namespace epode::robots;

namespace {

constexpr dReal kTolerance = sizeof(dReal) == 8 ? dReal(1e-10) : dReal(1e-5);
constexpr int kMaxTries = 1000;

Pose pose_of(const dReal* p, const dReal* q) { return {vec_of(p), normalised(quat_of(q))}; }

bool is_turn(const dReal* q)
{
    return are_usable(q, 4) && q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3] > 0;
}

bool is_good(const RobotModel& model, const dRobotTarget& target)
{
    const dReal weights[2] = {target.position_weight, target.orientation_weight};
    return target.link >= 0 && target.link < int(model.links.size()) && are_usable(target.point, 3) &&
           are_usable(target.position, 3) && is_turn(target.point_q) && is_turn(target.q) &&
           are_usable(weights, 2) && weights[0] >= 0 && weights[1] >= 0;
}

bool is_good(const RobotModel& model, const dRobotInverseOptions& options)
{
    const int velocities = number_of_velocities(model);
    const bool weights_are_good =
        !options.weights || (are_usable(options.weights, velocities) &&
                             std::all_of(options.weights, options.weights + velocities,
                                         [](dReal weight) { return weight >= 0 && weight <= 1e6; }));
    return options.struct_size == sizeof(dRobotInverseOptions) && options.max_iterations > 0 &&
           options.max_iterations <= kMaxTries && options.max_starts > 0 && options.max_starts <= kMaxTries &&
           is_usable(options.tolerance) && options.tolerance >= 0 && weights_are_good &&
           (!options.posture || are_usable(options.posture, model.coordinates));
}

Goal goal_of(const dRobotTarget& target)
{
    return {target.link, pose_of(target.point, target.point_q), pose_of(target.position, target.q),
            double(target.position_weight), double(target.orientation_weight)};
}

InverseSettings settings_of(const RobotModel& model, const dRobotInverseOptions& options)
{
    InverseSettings out;
    out.max_iterations = options.max_iterations, out.max_starts = options.max_starts;
    out.tolerance = double(options.tolerance);
    if (options.weights) out.weights = doubles_of(options.weights, number_of_velocities(model));
    if (options.posture) out.posture = doubles_of(options.posture, model.coordinates);
    return out;
}

}  // namespace

int dRobotModelFindFrame(dRobotModelID model, const char* name, dReal* frame)
{
    model = alive(model);
    CHECK(model && name && frame, "a model, a name and an array of 7 reals");
    return guarded(__func__, [&] {
        Frame its;
        if (!model->model.frame_named(name, its)) return -1;
        const Pose& p = its.pose;
        copy_positions({p.p.x, p.p.y, p.p.z, p.q.w, p.q.x, p.q.y, p.q.z}, frame, 7);
        return its.link;
    });
}

int dRobotTargetInit(dRobotTarget* target, int link)
{
    CHECK(target, "a target");
    *target = dRobotTarget{};
    target->link = link;
    target->point_q[0] = target->q[0] = target->position_weight = target->orientation_weight = 1;
    return 1;
}

int dRobotInverseOptionsInit(dRobotInverseOptions* options, unsigned struct_size)
{
    CHECK(options && struct_size == sizeof(dRobotInverseOptions),
          "a structure and its size, sizeof(dRobotInverseOptions)");
    *options = {struct_size, 100, 32, kTolerance, nullptr, nullptr};
    return 1;
}

int dRobotModelGetInverse(dRobotModelID model, const dRobotTarget* targets, int count,
                          const dRobotInverseOptions* options, dReal* positions, dRobotInverseResult* result)
{
    model = alive(model);
    CHECK(can_compute(model, positions), "a model without errors and its finite positions");
    CHECK(count >= 0 && (targets || count == 0) &&
              std::all_of(targets, targets + count,
                          [&](const dRobotTarget& target) { return is_good(model->model, target); }),
          "targets with the number of a link, finite numbers, quaternions that are not 0 and weights of 0 or "
          "more");
    CHECK(!options || is_good(model->model, *options),
          "NULL, or options with their size, 1 ... 1000 iterations and starts, finite positions, a tolerance "
          "of "
          "0 or more and weights from 0 to 1e6");
    CHECK(!result || result->struct_size == sizeof(dRobotInverseResult), "NULL, or a result with its size");
    return guarded(__func__, [&] {
        dRobotInverseOptions its;
        dRobotInverseOptionsInit(&its, sizeof its);
        if (options) its = *options;
        std::vector<Goal> goals;
        for (int i = 0; i < count; ++i) goals.push_back(goal_of(targets[i]));
        const InverseAnswer answer =
            solve_inverse(model->model, doubles_of(positions, model->model.coordinates), goals,
                          settings_of(model->model, its));
        copy_positions(answer.positions, positions, model->model.coordinates);
        if (result)
            *result = {result->struct_size,
                       answer.is_reached,
                       answer.starts,
                       answer.iterations,
                       dReal(answer.residual),
                       dReal(answer.position_error),
                       dReal(answer.orientation_error)};
        return answer.is_reached ? 1 : 2;
    });
}
