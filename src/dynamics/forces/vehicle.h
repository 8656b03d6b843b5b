// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What makes a body a vehicle: its settings, its wheels, and what one update leaves for the next
// (ode/vehicle.h). It belongs to the body and goes where the body goes: states, histories, clones and files.
// How it drives is in src/vehicles, which knows geoms.
#pragma once

#include <span>

#include "base/objects/struct_size.h"
#include "dynamics/body.h"
#include "ode/vehicle.h"

namespace epode {

template <>
inline constexpr std::size_t kSmallestSize<dVehicleSettings> = offsetof(dVehicleSettings, forward);
template <>
inline constexpr std::size_t kSmallestSize<dVehicleWheel> = offsetof(dVehicleWheel, position);
template <>
inline constexpr std::size_t kSmallestSize<dVehicleControls> = offsetof(dVehicleControls, brake);
template <>
inline constexpr std::size_t kSmallestSize<dVehicleReport> = offsetof(dVehicleReport, speed);
template <>
inline constexpr std::size_t kSmallestSize<dVehicleWheelReport> = offsetof(dVehicleWheelReport, ground);

class StructureStream;
class StateStream;

struct VehicleWheel {
    dVehicleWheel settings{};

    // ---- what the last update has left ----
    Real spin = 0;                      // about the axle, of the wheel in the world
    Real angle = 0;                     // that it has turned, 0 ... 2 pi
    Real steer = 0;                     // its own angle
    Real compression = 0;               // of the suspension
    Real bristle_x = 0, bristle_y = 0;  // deflection of the tyre, m (vehicles/tyre.h)
    Vec3 ground_pos, ground_normal;
    Real load = 0, force_x = 0, force_y = 0;
    Real slip_ratio = 0, slip_angle = 0, slip = 0;
    std::uint64_t ground_pose = 0;  // a hash of it
    dGeomID ground = nullptr;       // perhaps destroyed since
    int ground_side = -1;
    bool on_ground = false;
};

struct Vehicle {
    dVehicleSettings settings{};
    dVehicleControls controls{};
    VehicleWheel wheels[dVehicleMaxWheels];
    int wheel_count = 0;

    // ---- what the last update has left ----
    Real engine_speed = 0, engine_torque = 0, clutch_torque = 0;
    Real steer = 0;  // its angle
    Real speed = 0, lean = 0, curvature = 0;
    Real shift_left = 0;  // of the shift time
    int gear = 1;
    bool stands = false;  // on some wheel: the body may fall asleep

    std::span<VehicleWheel> all_wheels() { return {wheels, std::size_t(wheel_count)}; }
    std::span<const VehicleWheel> all_wheels() const { return {wheels, std::size_t(wheel_count)}; }
};

extern const dVehicleSettings kDefaultVehicle;
extern const dVehicleWheel kDefaultWheel;
// Null: good; else what is refused.
const char* fault_of(const dVehicleSettings& settings);
const char* fault_of(const dVehicleWheel& wheel);
const char* fault_of(const dVehicleControls& controls);
// Of a wheel number i, or a new one, among those that the vehicle has.
const char* fault_of_axle(const Vehicle& vehicle, const dVehicleWheel& wheel, int i);

// False: out of memory.
[[nodiscard]] bool make_vehicle(Body& body, const dVehicleSettings& settings);
void drop_vehicle(Body& body);

// Its settings and wheels, of a body that is a vehicle or, while it loads, becomes one.
void structure_of_vehicle(Body& body, StructureStream& stream);
// All that the last update has left, but for the grounds' geoms.
void state_of_vehicle(Vehicle& vehicle, StateStream& stream);

}  // namespace epode
