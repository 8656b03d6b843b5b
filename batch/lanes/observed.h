// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Where observations of a group lie: rows of as many numbers as it has lanes, counted here. See observe.h.
#pragma once

#include "batch/model/model_view.h"

namespace epode::batch {

// What is to be found.
enum : int { kOfState = 1, kOfStep = 2, kOfSensors = 4 };

struct ObservedLayout {
    int position, turn, velocity, inertia, centre, actuator, contact, constraint, sensor, rows;

    // A BatchModel or a ModelView: links and dofs are counted by both.
    template <typename Model>
    EPODE_ALWAYS explicit ObservedLayout(const Model& model)
        : position(0),
          turn(position + 3 * int(model.links.size())),
          velocity(turn + 4 * int(model.links.size())),
          inertia(velocity + 6 * int(model.links.size())),
          centre(inertia + 10 * int(model.links.size())),
          actuator(centre + 3),
          contact(actuator + model.velocities),
          constraint(contact + 6 * int(model.links.size())),
          sensor(constraint + model.velocities),
          rows(sensor + model.sensor_values)
    {}
};

}  // namespace epode::batch
