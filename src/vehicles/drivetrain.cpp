// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "vehicles/drivetrain.h"

#include <algorithm>

namespace epode {
namespace {

constexpr Real kEngages = Real(1.05), kEngaged = Real(1.55);  // times the idle speed
constexpr Real kLimiterWidth = Real(0.02);                    // of the limiter's speed
constexpr Real kGovernor = 20;                                // 1/s, of the idle speed

Real ratio_of(const dVehicleSettings& s, int gear)
{
    if (gear == 0) return 0;
    return gear < 0 ? -s.reverse_ratio * s.final_ratio : s.gear_ratios[gear - 1] * s.final_ratio;
}

Real left_of(const Vehicle& vehicle, int i)
{
    const dVehicleSettings& s = vehicle.settings;
    return dot(load(vehicle.wheels[i].settings.position), cross(load(s.up), load(s.forward)));
}

// How fast the sides turn against each other.
struct TrackSpeeds {
    Real left = 1, right = 1;
};

TrackSpeeds sides_of(const Vehicle& vehicle)
{
    const Real limit = vehicle.settings.max_steer, s = limit > 0 ? vehicle.steer / limit : Real(0);
    return {1 - 2 * std::max(s, Real(0)), 1 + 2 * std::min(s, Real(0))};
}

// Shares of the drive, by speed.
void make_shares(const Vehicle& vehicle, Real* share)
{
    if (vehicle.settings.kind == dVehicleTracked) {
        const TrackSpeeds sides = sides_of(vehicle);
        const Real sum = sides.left * sides.left + sides.right * sides.right;
        share[0] = sides.left / sum, share[1] = sides.right / sum;
        return;
    }
    Real sum = 0;
    for (const VehicleWheel& wheel : vehicle.all_wheels()) sum += wheel.settings.drive;
    for (int i = 0; i < vehicle.wheel_count; ++i)
        share[i] = sum > 0 ? vehicle.wheels[i].settings.drive / sum : Real(0);
}

// Of a wheel that slides, the one with which it would roll: gears are not for its spin.
Real rolling_speed(const Vehicle& vehicle, const VehicleWheel& wheel)
{
    const bool slides = wheel.on_ground && wheel.slip >= 1;
    return slides ? vehicle.speed / wheel.settings.radius : wheel.spin;
}

Real shaft_speed(const Vehicle& vehicle)
{
    Real share[dVehicleMaxWheels] = {}, speed[dVehicleMaxWheels] = {}, sum = 0;
    make_shares(vehicle, share);
    for (int i = 0; i < vehicle.wheel_count; ++i)
        speed[speed_of_wheel(vehicle, i)] = rolling_speed(vehicle, vehicle.wheels[i]);
    for (int i = 0; i < speed_count(vehicle); ++i) sum += share[i] * speed[i];
    return sum;
}

bool drives(const Vehicle& vehicle, int i) { return vehicle.wheels[i].settings.drive > 0; }

int partner_of(const Vehicle& vehicle, int i)
{
    for (int k = i + 1; k < vehicle.wheel_count; ++k)
        if (vehicle.wheels[k].settings.axle == vehicle.wheels[i].settings.axle && drives(vehicle, k))
            return k;
    return -1;
}

bool limit_of(int differential, Real torque, Real h, ShaftRow& row)
{
    row.limit = differential == dDifferentialLocked ? kInf : h * torque;
    return differential != dDifferentialOpen;
}

Real engagement(const Vehicle& vehicle)
{
    const dVehicleSettings& s = vehicle.settings;
    if (vehicle.shift_left > 0) return 0;
    const Real pressed = 1 - vehicle.controls.clutch, idle = s.idle_speed;
    if (!(idle > 0)) return pressed;
    const Real grip = (vehicle.engine_speed / idle - kEngages) / (kEngaged - kEngages);
    return pressed * std::clamp(grip, Real(0), Real(1));
}

Real torque_at(const dVehicleSettings& s, Real speed)
{
    const Real *x = s.engine_speeds, *y = s.engine_torques;
    if (speed <= x[0]) return y[0];
    for (int i = 1; i < s.torque_points; ++i)
        if (speed <= x[i]) return y[i - 1] + (y[i] - y[i - 1]) * (speed - x[i - 1]) / (x[i] - x[i - 1]);
    return y[s.torque_points - 1];
}

bool make_clutch(const Vehicle& vehicle, Real h, ShaftRow& row)
{
    const dVehicleSettings& s = vehicle.settings;
    const Real ratio = ratio_of(s, vehicle.gear);
    row.limit = h * s.clutch_torque * engagement(vehicle);
    if (ratio == 0 || !(row.limit > 0)) return false;
    Real share[dVehicleMaxWheels] = {};
    make_shares(vehicle, share);
    bool any = false;
    for (int i = 0; i < speed_count(vehicle); ++i)
        if (share[i] != 0) row.set(i, -ratio * share[i]), any = true;
    row.engine = 1;
    return any;
}

bool make_sides(const Vehicle& vehicle, Real h, ShaftRow& row)
{
    const TrackSpeeds sides = sides_of(vehicle);
    row.set(0, sides.right), row.set(1, -sides.left);
    return limit_of(vehicle.settings.differential, vehicle.settings.lock_torque, h, row);
}

// The mean of the driven wheels of an axle, times `sign`; false: there are none.
bool add_axle(const Vehicle& vehicle, int axle, Real sign, ShaftRow& row)
{
    int count = 0;
    for (int i = 0; i < vehicle.wheel_count; ++i)
        count += vehicle.wheels[i].settings.axle == axle && drives(vehicle, i);
    for (int i = 0; i < vehicle.wheel_count && count > 0; ++i)
        if (vehicle.wheels[i].settings.axle == axle && drives(vehicle, i)) row.set(i, sign / Real(count));
    return count > 0;
}

int make_centre_rows(const Vehicle& vehicle, Real h, ShaftRow* rows)
{
    const dVehicleSettings& s = vehicle.settings;
    int count = 0, before = -1;
    for (int axle = 0; axle < dVehicleMaxWheels; ++axle) {
        ShaftRow row;
        if (!add_axle(vehicle, axle, -1, row)) continue;
        if (before >= 0 && limit_of(s.centre_differential, s.centre_lock_torque, h, row)) {
            (void)add_axle(vehicle, before, 1, row);
            rows[count++] = row;
        }
        before = axle;
    }
    return count;
}

int wanted_gear(const Vehicle& vehicle)
{
    const dVehicleSettings& s = vehicle.settings;
    const int gear = vehicle.gear;
    if (!s.automatic || gear < 1 || vehicle.shift_left > 0) return gear;
    const Real shaft = std::fabs(shaft_speed(vehicle)) * s.final_ratio;
    const Real now = shaft * s.gear_ratios[gear - 1];
    if (gear < s.gears && now > s.shift_up_speed && shaft * s.gear_ratios[gear] >= s.shift_down_speed)
        return gear + 1;
    if (gear > 1 && now < s.shift_down_speed && shaft * s.gear_ratios[gear - 2] <= s.shift_up_speed)
        return gear - 1;
    return gear;
}

}  // namespace

void ShaftRow::set(int i, Real value)
{
    if (first == end) first = end = i;
    while (first > i) factor[--first] = 0;
    while (end <= i) factor[end++] = 0;
    factor[i] = value;
}

int speed_of_wheel(const Vehicle& vehicle, int wheel)
{
    if (vehicle.settings.kind != dVehicleTracked) return wheel;
    return left_of(vehicle, wheel) > 0 ? 0 : 1;
}

int speed_count(const Vehicle& vehicle)
{
    return vehicle.settings.kind == dVehicleTracked ? 2 : vehicle.wheel_count;
}

void change_gears(Vehicle& vehicle, Real h)
{
    vehicle.shift_left = std::max(vehicle.shift_left - h, Real(0));
    const int gear = wanted_gear(vehicle);
    if (gear == vehicle.gear) return;
    vehicle.gear = gear;
    vehicle.shift_left = vehicle.settings.shift_time;
}

Real engine_torque(const Vehicle& vehicle)
{
    const dVehicleSettings& s = vehicle.settings;
    const Real speed = vehicle.engine_speed, highest = s.engine_speeds[s.torque_points - 1];
    const Real below = (highest * (1 + kLimiterWidth) - speed) / (highest * kLimiterWidth);
    const Real open = vehicle.shift_left > 0 ? Real(0) : vehicle.controls.throttle;
    const Real throttle = open * std::clamp(below, Real(0), Real(1));
    const Real full = torque_at(s, speed);
    const Real running = throttle * full - (1 - throttle) * s.engine_drag * speed / highest;
    if (speed >= s.idle_speed) return running;
    return std::max(running, std::min(kGovernor * s.engine_inertia * (s.idle_speed - speed), full));
}

int make_shaft_rows(const Vehicle& vehicle, Real h, ShaftRow* rows)
{
    int count = make_clutch(vehicle, h, rows[0]) ? 1 : 0;
    if (vehicle.settings.kind == dVehicleTracked) {
        rows[count] = {};
        return make_sides(vehicle, h, rows[count]) ? count + 1 : count;
    }
    for (int i = 0; i < vehicle.wheel_count; ++i) {
        const int partner = drives(vehicle, i) ? partner_of(vehicle, i) : -1;
        ShaftRow row;
        if (partner < 0 || !limit_of(vehicle.settings.differential, vehicle.settings.lock_torque, h, row))
            continue;
        row.set(i, 1), row.set(partner, -1);
        rows[count++] = row;
    }
    return count + make_centre_rows(vehicle, h, rows + count);
}

}  // namespace epode
