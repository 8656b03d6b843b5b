// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The C functions of tendons, of what acts from step to step, and of a robot's state.
#include "robots/api.h"
#include "robots/kinematics.h"
#include "robots/tendon.h"

using namespace epode::robots;

namespace {

bool has_actuator(dRobotID robot, int actuator)
{
    return robot && actuator >= 0 && actuator < int(robot->robot->model().actuators.size());
}

}  // namespace

int dRobotModelFindTendon(dRobotModelID model, const char* name)
{
    model = alive(model);
    CHECK(model && name, "a model and a name");
    return guarded(__func__, [&] { return model->model.tendon_named(name); });
}

int dRobotModelGetTendons(dRobotModelID model, const dReal* positions, dReal* lengths, dReal* jacobian,
                          int capacity)
{
    model = alive(model);
    CHECK(can_compute(model, positions) && capacity >= 0,
          "a model without errors, its finite positions, and a capacity of 0 or more");
    return guarded(__func__, [&] {
        const auto q = doubles_of(positions, model->model.coordinates);
        const int count = int(model->model.tendons.size()), rows = std::min(capacity, count),
                  columns = epode::robots::number_of_velocities(model->model);
        if (lengths) copy_positions(tendon_lengths(model->model, q), lengths, rows);
        if (jacobian) copy_positions(tendon_jacobian(model->model, q), jacobian, rows * columns);
        return count;
    });
}

int dRobotAddForces(dRobotID robot, dReal stepsize)
{
    robot = alive(robot);
    CHECK(robot && is_usable(stepsize) && stepsize > 0 && is_usable(1 / stepsize),
          "a robot and a stepsize above 0");
    return guarded(__func__, [&] { return robot->robot->add_forces(double(stepsize)); });
}

int dRobotSetActivation(dRobotID robot, int actuator, dReal activation)
{
    robot = alive(robot);
    CHECK(has_actuator(robot, actuator) && is_usable(activation),
          "a robot, the number of an actuator and a finite activation");
    robot->robot->set_activation(actuator, double(activation));
    return 1;
}

dReal dRobotGetActivation(dRobotID robot, int actuator)
{
    robot = alive(robot);
    CHECK(has_actuator(robot, actuator), "a robot and the number of an actuator");
    return dReal(robot->robot->activation(actuator));
}

int dRobotGetState(dRobotID robot, dReal* numbers, int capacity)
{
    robot = alive(robot);
    CHECK(robot && capacity >= 0 && (numbers || capacity == 0),
          "a robot, a capacity of 0 or more, and an array unless it is 0");
    return guarded(__func__, [&] { return copy_positions(robot->robot->state(), numbers, capacity); });
}

int dRobotSetState(dRobotID robot, const dReal* numbers, int count)
{
    constexpr const char* kWanted = "a robot, and the numbers that dRobotGetState returns for its model";
    robot = alive(robot);
    CHECK(robot && count > 0 && size_t(count) == robot->robot->state_size(), kWanted);
    CHECK(numbers && are_usable(numbers, count), kWanted);
    return guarded(__func__, [&] {
        if (!check(robot->robot->set_state(doubles_of(numbers, count)), "dRobotSetState", kWanted)) return 0;
        robot->sensors->begin();
        return 1;
    });
}
