// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Motorbike: two wheels in a line that lean into the curves of a slalom between posts (ode/vehicle.h).
#include <algorithm>
#include <cmath>
#include <memory>

#include "scenes/build.h"
#include "scenes/vehicles.h"

namespace epode::scenes {

namespace {

constexpr double kGap = 18, kSwing = 2.2, kPace = 12;  // between posts, m; to their sides, m; m/s
constexpr double kMaxSteer = 0.5;
constexpr int kPosts = 10;

dVehicleWheel bike_wheel(bool front)
{
    dVehicleWheel wheel = vehicle_wheel();
    wheel.cast = dWheelSphere;
    wheel.position[0] = dReal(front ? 0.72 : -0.68), wheel.position[2] = dReal(-0.36);
    wheel.radius = dReal(0.31), wheel.width = dReal(0.13), wheel.travel = dReal(0.15);
    wheel.stiffness = 16000, wheel.bump_damping = 900, wheel.rebound_damping = 1200,
    wheel.nominal_load = 1200;
    wheel.inertia = dReal(0.6), wheel.brake_torque = 500;
    wheel.axle = !front, wheel.steer = front, wheel.drive = !front;
    return wheel;
}

// It looks ahead at a curve that passes the posts left and right in turn, and steers the circle that leads there.
void slalom(Vehicle& bike, double dt)
{
    constexpr double kLook = 6, kWheelbase = 1.4;
    const dReal* at = dBodyGetPosition(bike.chassis);
    const double ahead = double(at[0]) + kLook, fade = ahead < kGap / 2 ? 0 : 1;
    dVector3 goal;
    dBodyGetPosRelPoint(bike.chassis, dReal(ahead),
                        dReal(fade * kSwing * std::sin(kPi * (ahead / kGap - 0.5))), at[2], goal);
    const double bend = 2 * double(goal[1]) / double(goal[0] * goal[0] + goal[1] * goal[1]);
    bike.controls.steer = dReal(std::clamp(kWheelbase * bend / kMaxSteer, -1.0, 1.0));
    bike.controls.throttle = dReal(throttle_for(bike, kPace));
    drive(bike, dt);
}

// A quarter of a car's.
void take_small_engine(dVehicleSettings& settings)
{
    for (dReal& torque : settings.engine_torques) torque *= dReal(0.22);
    settings.engine_inertia = dReal(0.04), settings.engine_drag = 12, settings.clutch_torque = 150;
}

void build(Scene& scene)
{
    add_ground(scene);
    for (int i = 1; i <= kPosts; ++i) add_cylinder(scene, 0.12, 0.9, 200, {kGap * i, 0, 0.45});
    const dBodyID chassis = add_box(scene, {1.1, 0.25, 0.45}, 1370, {0, 0, 0.6});
    attach_box(scene, chassis, {0.3, 0.36, 0.6}, {-0.2, 0, 0.5});  // the rider
    attach_sphere(scene, chassis, 0.15, {-0.08, 0, 0.92});
    dVehicleSettings settings = vehicle_settings();
    settings.kind = dVehicleBike, settings.max_steer = dReal(kMaxSteer), settings.steer_speed = 1;
    settings.drag = dReal(0.3);
    take_small_engine(settings);
    const auto bike = std::make_shared<Vehicle>(
        make_vehicle(scene, chassis, settings, {bike_wheel(true), bike_wheel(false)}));
    scene.before_step([bike](double, double dt) { slalom(*bike, dt); });
    scene.dials.push_back(
        {"steering", "", -1, 1, [bike] { return bike->steering; }, [bike](double v) { bike->steering = v; }});
    scene.tracked = {chassis};
    set_view(scene, {4.6, -4.2, 2}, {-0.6, 0.5, 0.6});
    scene.view.follow = chassis;
}

}  // namespace

extern const Recipe kMotorbike = {
    .name = "motorbike",
    .description = "a motorbike that leans into the curves of a slalom",
    .dt = 1.0 / 60,
    .seconds = 12,
    .stepper = Stepper::kQuick,
    .build = build,
};

}  // namespace epode::scenes
