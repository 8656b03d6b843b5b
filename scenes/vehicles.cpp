// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "scenes/vehicles.h"

#include <algorithm>
#include <cmath>

#include "record/watch/lookup.h"
#include "scenes/vectors.h"

namespace epode::scenes {

namespace {

#define EPODE_SOUGHT(name) reinterpret_cast<decltype(&(name))>(record::library_function(#name))

void turn_wheel(dGeomID shown, double steer, double angle)
{
    dMatrix3 about_up, about_axle, upright;
    dRFromAxisAndAngle(about_up, 0, 0, 1, dReal(steer));
    dRFromAxisAndAngle(about_axle, 0, 1, 0, dReal(angle));
    dRFromAxisAndAngle(upright, 1, 0, 0, dReal(kPi / 2));
    dMatrix3 rolled, all;
    dMultiply0(rolled, about_axle, upright, 3, 3, 3);
    dMultiply0(all, about_up, rolled, 3, 3, 3);
    dGeomSetOffsetRotation(shown, all);
}

void show(const Vehicle& vehicle)
{
    static const auto report = EPODE_SOUGHT(dVehicleGetWheelReport);
    for (std::size_t i = 0; i < vehicle.shown.size(); ++i) {
        dVehicleWheelReport now{};
        now.struct_size = sizeof now;
        if (!report || !report(vehicle.chassis, int(i), &now)) return;
        const dReal* hub = vehicle.wheels[i].position;
        dGeomSetOffsetPosition(vehicle.shown[i], hub[0], hub[1], hub[2] + now.compression);
        turn_wheel(vehicle.shown[i], double(now.steer), double(now.angle));
    }
}

dGeomID add_shown(Scene& scene, dBodyID chassis, const dVehicleWheel& wheel)
{
    const bool known = wheel.radius > 0;
    const dGeomID shown =
        dCreateCylinder(scene.space(), known ? wheel.radius : dReal(0.3), known ? wheel.width : dReal(0.2));
    dGeomSetCategoryBits(shown, 0);
    dGeomSetCollideBits(shown, 0);
    dGeomSetBody(shown, chassis);
    dGeomSetOffsetPosition(shown, wheel.position[0], wheel.position[1], wheel.position[2]);
    turn_wheel(shown, 0, 0);
    scene.add_geom(shown);
    return shown;
}

}  // namespace

dVehicleSettings vehicle_settings()
{
    dVehicleSettings settings{};
    if (const auto init = EPODE_SOUGHT(dVehicleSettingsInit)) init(&settings, sizeof settings);
    return settings;
}

dVehicleWheel vehicle_wheel()
{
    dVehicleWheel wheel{};
    if (const auto init = EPODE_SOUGHT(dVehicleWheelInit)) init(&wheel, sizeof wheel);
    return wheel;
}

Vehicle make_vehicle(Scene& scene, dBodyID chassis, const dVehicleSettings& settings,
                     const std::vector<dVehicleWheel>& wheels)
{
    Vehicle vehicle{chassis, wheels, {}, {}, 0};
    vehicle.controls.struct_size = sizeof vehicle.controls;
    const auto create = EPODE_SOUGHT(dVehicleCreate);
    const auto add = EPODE_SOUGHT(dVehicleAddWheel);
    if (create && add) create(chassis, &settings);
    for (const dVehicleWheel& wheel : wheels) {
        if (create && add) add(chassis, &wheel);
        vehicle.shown.push_back(add_shown(scene, chassis, wheel));
    }
    return vehicle;
}

void drive(Vehicle& vehicle, double dt)
{
    static const auto set = EPODE_SOUGHT(dVehicleSetControls);
    static const auto update = EPODE_SOUGHT(dVehicleUpdate);
    if (!set || !update) return;
    dVehicleControls controls = vehicle.controls;
    controls.steer = dReal(std::clamp(double(controls.steer) + vehicle.steering, -1.0, 1.0));
    set(vehicle.chassis, &controls);
    update(vehicle.chassis, dReal(dt));
    show(vehicle);
}

double forward_speed(const Vehicle& vehicle)
{
    dVector3 forward;
    dBodyVectorToWorld(vehicle.chassis, 1, 0, 0, forward);
    return double(dCalcVectorDot3(forward, dBodyGetLinearVel(vehicle.chassis)));
}

double steer_towards(const Vehicle& vehicle, double x, double y)
{
    dVector3 local;
    const dReal* at = dBodyGetPosition(vehicle.chassis);
    dBodyGetPosRelPoint(vehicle.chassis, dReal(x), dReal(y), at[2], local);
    return std::clamp(2 * std::atan2(double(local[1]), double(local[0])), -1.0, 1.0);
}

double throttle_for(const Vehicle& vehicle, double speed)
{
    return std::clamp(0.3 * (speed - forward_speed(vehicle)), 0.0, 1.0);
}

}  // namespace epode::scenes
