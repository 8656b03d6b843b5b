// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Vehicles as C functions.
#include <algorithm>

#include "base/float_environment.h"
#include "collide/types/registry.h"
#include "dynamics/world.h"
#include "step/common/link.h"
#include "vehicles/update.h"

namespace epode {
namespace {

Body* vehicle_from(dBodyID id)
{
    Body* const body = from_handle<Body>(id);
    return body && body->vehicle ? body : nullptr;
}

constexpr const char* kNoVehicle = "argument not a vehicle";
constexpr const char* kNoWheel = "no such wheel of the vehicle";

bool has_wheel(const Body& body, int i) { return i >= 0 && i < body.vehicle->wheel_count; }

bool same_controls(const dVehicleControls& a, const dVehicleControls& b)
{
    return a.throttle == b.throttle && a.brake == b.brake && a.handbrake == b.handbrake &&
           a.steer == b.steer && a.clutch == b.clutch;
}

void wake_vehicle(Body& body)
{
    if (body.disabled && body.auto_disable) wake(body);
}

dVehicleReport report_of(const Vehicle& v)
{
    dVehicleReport out{};
    out.gear = v.gear, out.speed = v.speed;
    out.engine_speed = v.engine_speed, out.engine_torque = v.engine_torque,
    out.clutch_torque = v.clutch_torque;
    out.is_shifting = v.shift_left > 0;
    for (const VehicleWheel& wheel : v.all_wheels()) out.wheels_on_ground += wheel.on_ground;
    out.steer = v.steer, out.lean = v.lean, out.curvature = v.curvature;
    return out;
}

dVehicleWheelReport report_of(const Body& body, const VehicleWheel& w)
{
    const VehicleFrame frame = frame_of(body);
    dVehicleWheelReport out{};
    out.on_ground = w.on_ground;
    const bool lives = w.on_ground && from_handle<Geom>(w.ground);
    out.ground = lives ? w.ground : nullptr;
    out.ground_side = lives ? w.ground_side : -1;
    if (w.on_ground) store(out.ground_pos, w.ground_pos), store(out.ground_normal, w.ground_normal);
    store(out.hub, body.pose().to_world(load(w.settings.position)) + w.compression * frame.up);
    out.steer = w.steer, out.angle = w.angle,
    out.spin = w.spin - dot(frame.axle_of(w.steer), body.angular_velocity()), out.compression = w.compression;
    out.load = w.load, out.force_x = w.force_x, out.force_y = w.force_y;
    out.slip_ratio = w.slip_ratio, out.slip_angle = w.slip_angle, out.slip = w.slip;
    return out;
}

}  // namespace
}  // namespace epode

#define EPODE_VEHICLE(body, id, ...)                 \
    ::epode::Body* body = ::epode::vehicle_from(id); \
    EPODE_USER_SAY(body, ::epode::kNoVehicle __VA_OPT__(, ) __VA_ARGS__)
#define EPODE_IDLE_VEHICLE(body, id) \
    EPODE_VEHICLE(body, id, 0);      \
    EPODE_USER_SAY(!is_busy(*(body)->world), busy_text(*(body)->world), 0)

using namespace epode;

extern "C" int dVehicleSettingsInit(dVehicleSettings* settings, unsigned struct_size)
{
    EPODE_SIZED_AS(settings, struct_size, 0);
    copy_sized(kDefaultVehicle, settings, struct_size);
    return 1;
}

extern "C" int dVehicleWheelInit(dVehicleWheel* wheel, unsigned struct_size)
{
    EPODE_SIZED_AS(wheel, struct_size, 0);
    copy_sized(kDefaultWheel, wheel, struct_size);
    return 1;
}

extern "C" int dVehicleCreate(dBodyID id, const dVehicleSettings* settings)
{
    const FloatEnvironment floats;
    Body* const body = from_handle<Body>(id);
    EPODE_USER(body, 0);
    EPODE_USER_SAY(!is_busy(*body->world), busy_text(*body->world), 0);
    EPODE_USER_SAY(!body->vehicle, "the body is a vehicle already", 0);
    dVehicleSettings whole = kDefaultVehicle;
    if (settings) {
        EPODE_SIZED(settings, 0);
        whole = completed(*settings, kDefaultVehicle);
    }
    const char* const fault = fault_of(whole);
    EPODE_USER_SAY(!fault, fault, 0);
    EPODE_USER_SAY(make_vehicle(*body, whole), kOutOfMemory, 0);
    return 1;
}

extern "C" int dBodyIsVehicle(dBodyID id)
{
    Body* const body = from_handle<Body>(id);
    EPODE_USER(body, 0);
    return body->vehicle != nullptr;
}

extern "C" int dVehicleSetSettings(dBodyID id, const dVehicleSettings* settings)
{
    const FloatEnvironment floats;
    EPODE_IDLE_VEHICLE(body, id);
    EPODE_SIZED(settings, 0);
    Vehicle& vehicle = *body->vehicle;
    const dVehicleSettings whole = completed(*settings, vehicle.settings);
    const char* const fault = fault_of(whole);
    EPODE_USER_SAY(!fault, fault, 0);
    Vehicle as_car = vehicle;
    as_car.settings = whole;
    for (int i = 0; i < vehicle.wheel_count; ++i) {
        const char* const wrong = fault_of_axle(as_car, vehicle.wheels[i].settings, i);
        EPODE_USER_SAY(!wrong, wrong, 0);
    }
    vehicle.settings = whole;
    vehicle.gear = std::min(vehicle.gear, whole.gears);
    wake_vehicle(*body);
    return 1;
}

extern "C" int dVehicleGetSettings(dBodyID id, dVehicleSettings* settings)
{
    EPODE_VEHICLE(body, id, 0);
    EPODE_SIZED(settings, 0);
    copy_sized(body->vehicle->settings, settings, settings->struct_size);
    return 1;
}

extern "C" int dVehicleAddWheel(dBodyID id, const dVehicleWheel* wheel)
{
    const FloatEnvironment floats;
    EPODE_IDLE_VEHICLE(body, id);
    Vehicle& vehicle = *body->vehicle;
    dVehicleWheel whole = kDefaultWheel;
    if (wheel) {
        EPODE_SIZED(wheel, 0);
        whole = completed(*wheel, kDefaultWheel);
    }
    const char* const fault = fault_of(whole);
    EPODE_USER_SAY(!fault, fault, 0);
    EPODE_USER_SAY(vehicle.wheel_count < dVehicleMaxWheels, "too many wheels (accepted: 32)", 0);
    const char* const wrong = fault_of_axle(vehicle, whole, vehicle.wheel_count);
    EPODE_USER_SAY(!wrong, wrong, 0);
    vehicle.wheels[vehicle.wheel_count] = {};
    vehicle.wheels[vehicle.wheel_count++].settings = whole;
    wake_vehicle(*body);
    return vehicle.wheel_count;
}

extern "C" int dVehicleGetNumWheels(dBodyID id)
{
    EPODE_VEHICLE(body, id, 0);
    return body->vehicle->wheel_count;
}

extern "C" int dVehicleSetWheel(dBodyID id, int i, const dVehicleWheel* as)
{
    const FloatEnvironment floats;
    EPODE_IDLE_VEHICLE(body, id);
    EPODE_USER_SAY(has_wheel(*body, i), kNoWheel, 0);
    EPODE_SIZED(as, 0);
    const dVehicleWheel whole = completed(*as, body->vehicle->wheels[i].settings);
    const char* fault = fault_of(whole);
    if (!fault) fault = fault_of_axle(*body->vehicle, whole, i);
    EPODE_USER_SAY(!fault, fault, 0);
    body->vehicle->wheels[i].settings = whole;
    wake_vehicle(*body);
    return 1;
}

extern "C" int dVehicleGetWheel(dBodyID id, int i, dVehicleWheel* out)
{
    EPODE_VEHICLE(body, id, 0);
    EPODE_USER_SAY(has_wheel(*body, i), kNoWheel, 0);
    EPODE_SIZED(out, 0);
    copy_sized(body->vehicle->wheels[i].settings, out, out->struct_size);
    return 1;
}

extern "C" int dVehicleSetControls(dBodyID id, const dVehicleControls* controls)
{
    const FloatEnvironment floats;
    EPODE_IDLE_VEHICLE(body, id);
    EPODE_SIZED(controls, 0);
    const dVehicleControls whole = completed(*controls, dVehicleControls{});
    const char* const fault = fault_of(whole);
    EPODE_USER_SAY(!fault, fault, 0);
    if (!same_controls(whole, body->vehicle->controls)) wake_vehicle(*body);
    body->vehicle->controls = whole;
    return 1;
}

extern "C" int dVehicleGetControls(dBodyID id, dVehicleControls* controls)
{
    EPODE_VEHICLE(body, id, 0);
    EPODE_SIZED(controls, 0);
    copy_sized(body->vehicle->controls, controls, controls->struct_size);
    return 1;
}

extern "C" int dVehicleSetGear(dBodyID id, int gear)
{
    EPODE_IDLE_VEHICLE(body, id);
    Vehicle& vehicle = *body->vehicle;
    EPODE_USER_SAY(gear >= -1 && gear <= vehicle.settings.gears, "no such gear of the vehicle", 0);
    if (gear == vehicle.gear) return 1;
    vehicle.gear = gear;
    vehicle.shift_left = vehicle.settings.shift_time;
    wake_vehicle(*body);
    return 1;
}

extern "C" int dVehicleUpdate(dBodyID id, dReal h)
{
    const FloatEnvironment floats;
    EPODE_IDLE_VEHICLE(body, id);
    EPODE_USER_SAY(usable(h) && h > 0 && h <= 1, "h (accepted: above 0, at most 1 s)", 0);
    if (Space* space = space_of_wheels(*body)) {
        EPODE_USER_SAY(!is_locked(*space), EPODE_LOCKED_TEXT, 0);
        clean(*space);  // may call the program
    }
    body = vehicle_from(id);
    EPODE_USER_SAY(body && update_vehicle(*body, space_of_wheels(*body), h), kOutOfMemory, 0);
    return report_of(*body->vehicle).wheels_on_ground;
}

extern "C" int dVehicleGetReport(dBodyID id, dVehicleReport* report)
{
    EPODE_VEHICLE(body, id, 0);
    EPODE_SIZED(report, 0);
    copy_sized(report_of(*body->vehicle), report, report->struct_size);
    return 1;
}

extern "C" int dVehicleGetWheelReport(dBodyID id, int i, dVehicleWheelReport* report)
{
    const FloatEnvironment floats;
    EPODE_VEHICLE(body, id, 0);
    EPODE_USER_SAY(has_wheel(*body, i), kNoWheel, 0);
    EPODE_SIZED(report, 0);
    copy_sized(report_of(*body, body->vehicle->wheels[i]), report, report->struct_size);
    return 1;
}
