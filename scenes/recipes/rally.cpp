// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Rally: a car with suspension, tyres, engine and gears (ode/vehicle.h) drives around hills on a height field. It steers to a point of
// its circle ahead and keeps a speed.
#include <cmath>
#include <memory>

#include "scenes/build.h"
#include "scenes/terrain.h"
#include "scenes/vehicles.h"

namespace epode::scenes {

namespace {

constexpr double kRadius = 17, kAhead = 0.45, kSide = 64, kPace = 11;

double hills(double x, double y)
{
    return 0.8 * std::sin(0.21 * x) * std::cos(0.18 * y) + 0.16 * std::sin(0.62 * x + 1) * std::sin(0.55 * y);
}

dVehicleWheel rally_wheel(int number)
{
    dVehicleWheel wheel = vehicle_wheel();
    wheel.cast = dWheelSphere;
    wheel.position[0] = dReal(number < 2 ? 1.25 : -1.25);
    wheel.position[1] = dReal(number % 2 ? -0.8 : 0.8);
    wheel.position[2] = dReal(-0.45);
    wheel.radius = dReal(0.36), wheel.width = dReal(0.26), wheel.travel = dReal(0.35);
    wheel.stiffness = 22000, wheel.bump_damping = 1800, wheel.rebound_damping = 2400, wheel.anti_roll = 8000;
    wheel.axle = number / 2, wheel.steer = number < 2, wheel.drive = 1;
    return wheel;
}

void follow_circle(Vehicle& car, double dt)
{
    const dReal* at = dBodyGetPosition(car.chassis);
    const double angle = std::atan2(double(at[1]), double(at[0])) + kAhead;
    car.controls.steer = dReal(steer_towards(car, kRadius * std::cos(angle), kRadius * std::sin(angle)));
    car.controls.throttle = dReal(throttle_for(car, kPace));
    drive(car, dt);
}

void build(Scene& scene)
{
    add_terrain(scene, kSide, 128, hills);
    const Vec start{kRadius, 0, hills(kRadius, 0) + 0.85};
    const dBodyID chassis = add_box(scene, {3.4, 1.3, 0.45}, 450, start, turn(kZ, kPi / 2));
    attach_box(scene, chassis, {1.5, 1.15, 0.45}, {-0.25, 0, 0.42});
    dVehicleSettings settings = vehicle_settings();
    settings.centre_differential = dDifferentialLimited;
    std::vector<dVehicleWheel> wheels;
    for (int i = 0; i < 4; ++i) wheels.push_back(rally_wheel(i));
    const auto car = std::make_shared<Vehicle>(make_vehicle(scene, chassis, settings, wheels));
    scene.before_step([car](double, double dt) { follow_circle(*car, dt); });
    scene.dials.push_back(
        {"steering", "", -1, 1, [car] { return car->steering; }, [car](double v) { car->steering = v; }});
    scene.tracked = {chassis};
    set_view(scene, {6.5, -5.5, 3.6}, {-0.5, 0.8, 0.4});
    scene.view.follow = chassis;
}

}  // namespace

extern const Recipe kRally = {
    .name = "rally",
    .description = "a car with springs, tyres and gears on the hills of a height field",
    .dt = 1.0 / 60,
    .seconds = 12,
    .stepper = Stepper::kQuick,
    .build = build,
};

}  // namespace epode::scenes
