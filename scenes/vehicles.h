// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Vehicles (ode/vehicle.h) for scenes. Their functions are sought at run time: in a library without them the chassis lies on the
// ground. Wheels of vehicles are no bodies; what is seen are cylinders on the chassis that touch nothing.
#pragma once

#include <ode/ext.h>

#include <vector>

#include "scenes/scene.h"

namespace epode::scenes {

// The defaults of the library, forward x and up z; all 0 in a library without vehicles.
dVehicleSettings vehicle_settings();
dVehicleWheel vehicle_wheel();

struct Vehicle {
    dBodyID chassis = nullptr;
    std::vector<dVehicleWheel> wheels;
    std::vector<dGeomID> shown;  // one for each wheel
    dVehicleControls controls{};
    double steering = 0;  // of whoever turns a dial, added to that of the scene
};

// Makes a body a vehicle.
Vehicle make_vehicle(Scene& scene, dBodyID chassis, const dVehicleSettings& settings,
                     const std::vector<dVehicleWheel>& wheels);
// Before each step: what the driver does, the forces of the wheels, and where the wheels are seen.
void drive(Vehicle& vehicle, double dt);
double forward_speed(const Vehicle& vehicle);
// The control that leads the vehicle to a point, from the angle between where it points and where the point is.
double steer_towards(const Vehicle& vehicle, double x, double y);
// The throttle that keeps a speed.
double throttle_for(const Vehicle& vehicle, double speed);

}  // namespace epode::scenes
