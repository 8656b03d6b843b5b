// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Tank: a vehicle on tracks (ode/vehicle.h) climbs over beams, pushes crates away and turns on the spot.
#include <memory>

#include "scenes/build.h"
#include "scenes/vehicles.h"

namespace epode::scenes {

namespace {

constexpr int kRollers = 6;  // of a side

std::vector<dVehicleWheel> rollers()
{
    std::vector<dVehicleWheel> wheels;
    for (int i = 0; i < 2 * kRollers; ++i) {
        dVehicleWheel wheel = vehicle_wheel();
        const bool at_end = i / 2 == 0 || i / 2 == kRollers - 1;
        wheel.cast = dWheelSphere;
        wheel.position[0] = dReal(1.75 - 0.7 * (i / 2)), wheel.position[1] = dReal(i % 2 ? -1.15 : 1.15);
        wheel.position[2] = dReal(at_end ? -0.2 : -0.42);
        wheel.radius = dReal(0.38), wheel.width = dReal(0.45), wheel.travel = dReal(0.28);
        wheel.stiffness = 60000, wheel.bump_damping = 6000, wheel.rebound_damping = 6000,
        wheel.nominal_load = 5000;
        wheel.axle = i / 2, wheel.drive = 1, wheel.brake_torque = 2000;
        wheels.push_back(wheel);
    }
    return wheels;
}

void patrol(Vehicle& tank, double time, double dt)
{
    const bool turns = time > 9;
    tank.controls.throttle = dReal(turns ? 0.9 : throttle_for(tank, 3.2));
    tank.controls.steer = dReal(turns ? 1 : 0);
    tank.controls.brake = 0;
    drive(tank, dt);
}

void build(Scene& scene)
{
    add_ground(scene);
    for (int i = 0; i < 4; ++i)
        add_static_box(scene, {0.3, 4.4, 0.3}, {5.0 + 2.1 * i, 0, 0.1 + 0.05 * (i % 2)});
    for (int i = 0; i < 9; ++i)
        add_box(scene, {0.8, 0.8, 0.8}, 120, {17.0, 0.85 * (i % 3 - 1), 0.4 + 0.81 * (i / 3)});
    const dBodyID hull = add_box(scene, {4.4, 1.7, 0.6}, 800, {0, 0, 0.95});
    attach_box(scene, hull, {1.8, 1.4, 0.5}, {-0.2, 0, 0.56});
    attach_cylinder(scene, hull, 0.09, 2.2, {1.7, 0, 0.6}, turn(kY, kPi / 2));
    dVehicleSettings settings = vehicle_settings();
    settings.kind = dVehicleTracked, settings.differential = dDifferentialLocked, settings.final_ratio = 14;
    settings.automatic = 0;  // it stays in first gear
    const auto tank = std::make_shared<Vehicle>(make_vehicle(scene, hull, settings, rollers()));
    scene.before_step([tank](double time, double dt) { patrol(*tank, time, dt); });
    scene.dials.push_back(
        {"steering", "", -1, 1, [tank] { return tank->steering; }, [tank](double v) { tank->steering = v; }});
    scene.tracked = {hull};
    set_view(scene, {5.5, -8, 3.6}, {0.6, 0, 0.5});
    scene.view.follow = hull;
}

}  // namespace

extern const Recipe kTank = {
    .name = "tank",
    .description = "a tank on tracks over beams, through crates, and around on the spot",
    .dt = 1.0 / 60,
    .seconds = 12,
    .stepper = Stepper::kQuick,
    .build = build,
};

}  // namespace epode::scenes
