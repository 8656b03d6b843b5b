// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Engine, clutch, gears and differentials. An engine of speed w_e and inertia I_e has the torque
//   T_e = u T_full(w_e) - (1 - u) T_drag w_e / w_max,  0 drive above w_max,  and what keeps it at idle
// with the throttle u. Everything that turns together is a row: sum c_i w_i + e w_e = 0, held by an impulse
// of at most `limit`, so that a clutch, a lock or a brake is the same with another c:
//   clutch        w_e - G sum r_i w_i        G = gear ratio times final ratio, r_i: shares of the drive
//   differential  w_left - w_right           limit 0 (open: no row), h lock torque, or without a limit
//   centre        mean of one axle - mean of the next
//   brake         w_i                        limit h (brake torque + rolling resistance R N)
// An open differential is the clutch's row alone: it gives the share r_i G of the torque to wheel i at any
// speeds whose weighted mean is the shaft's (Milliken, Race Car Vehicle Dynamics, ch. 20). Speeds are those
// against the chassis, which gets the reaction of every torque.
//   automatic gearbox: shifts by the speed of the shaft at which the driven wheels roll or would roll. By that of wheels that
//     spin it would shift up, find them rolling slowly when they are driven no more, and shift down again
//   automatic clutch: its torque grows from 0 at 1.05 w_idle to all at 1.55 w_idle
//   tracks: left and right turn as rho_l : rho_r, (1 - 2 s) : 1 for s > 0, on the spot at s = 1
#pragma once

#include "dynamics/forces/vehicle.h"

namespace epode {

// Of the speeds that a vehicle has: a track is one, whatever its wheels.
struct ShaftRow {
    Real factor[dVehicleMaxWheels];  // of first ... end - 1; the others are 0
    int first = 0, end = 0;
    Real engine = 0;
    Real limit = 0;
    Real impulse = 0;
    Vec3 axle;          // sum of factor times axle
    Real response = 0;  // the speed that a unit impulse gives

    void set(int i, Real value);
};

// The index of a wheel's speed: its own, or that of its track. 0: left.
int speed_of_wheel(const Vehicle& vehicle, int wheel);
int speed_count(const Vehicle& vehicle);

// Shifts as time passes and as the automatic gearbox wants.
void change_gears(Vehicle& vehicle, Real h);

// Torque of the engine at its speed.
Real engine_torque(const Vehicle& vehicle);

// The rows of clutch and differentials for a step of size h; at most kMostShaftRows. Returns how many.
inline constexpr int kMostShaftRows = 2 * dVehicleMaxWheels;
int make_shaft_rows(const Vehicle& vehicle, Real h, ShaftRow* rows);

}  // namespace epode
