// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The forces of all wheels in one step, implicit in what they change: the velocity (v, w) of the chassis, of
// the bodies under it, the speeds w_i of the wheels and w_e of the engine. Unknown are impulses P = h F at
//   N     along the normal n of the ground, at the contact
//   x, y  along t = a x n at the hub, and along n x t at the contact, raised by the roll centre
//   rows  of the drivetrain, and the brakes (vehicles/drivetrain.h)
// which give v = v* + M^-1 sum P, w_i = w_i* + (Q_i - R P_x) / I_i, with Q the angular impulses of the rows,
// whose opposite acts on the chassis. v* has the program's forces and gravity. Each is solved in turn from
// the others' last values (Gauss-Seidel), with steps of Newton's between (wheel_forces_newton.h), until none changes:
//   suspension, along u with c = n . u:  F_s = k x + f_0 + stop + anti-roll + d ((1 - T) x'_0 + T x'_1)
//                N = F_s / c,  x' = -(v_contact . n) / c,   N >= 0
//   tyre         vehicles/tyre.h;   rows: the impulse that makes their speed 0, within their limits
// The spring acts from where it is, as in semi-implicit Euler, whose frequency has an error of (w h)^2 / 24
// alone; so a step of the world must not be finer for the weight than for the spring (step/island/free_flight.h).
// The damper's mean T is 1/2 + a / (12 + 2 a), a = h d / m: second order for short steps, implicit
// Euler for long ones, for exp(-a) of a free damper has nearly that. A spring that a step cannot follow, of h^2 k /
// m > 1/4, is taken implicitly for the rest.
#pragma once

#include "vehicles/drivetrain.h"
#include "vehicles/tyre.h"
#include "vehicles/wheel_contact.h"

namespace epode {

// A body that takes part: what impulses do to it.
struct MovedBody {
    Body* body = nullptr;  // null: it does not move by impulses
    Real inv_mass = 0;
    Mat3 inv_inertia;  // in the world
    Vec3 centre, v, w;

    Vec3 velocity_at(Vec3 arm) const { return v + cross(w, arm); }
    Real yielding(Vec3 arm, Vec3 d) const
    {
        const Vec3 turn = cross(arm, d);
        return inv_mass + dot(turn, inv_inertia * turn);
    }
    void push(Vec3 impulse, Vec3 arm)
    {
        v += inv_mass * impulse;
        w += inv_inertia * cross(arm, impulse);
    }
};

class WheelForces {
  public:
    WheelForces(Body& chassis, Real h);
    // Wheel i stands on this.
    void stand(int i, const WheelContact& contact);
    // After all wheels stand.
    void solve();
    // Gives bodies their forces, and the vehicle what it keeps.
    void apply();
    // A moment about forward that holds a bike; its opposite acts on what the bike stands on.
    void add_lean(Real torque);

    const VehicleFrame& frame() const { return frame_; }
    Vec3 mean_contact() const;

  private:
    struct Line {  // of an impulse, between the chassis and what a wheel stands on
        Vec3 d, arm, arm_ground;
        Vec3 turn, turned;  // arm x d, and what inv_inertia of the chassis makes of it
        Real response = 0, impulse = 0;
    };
    struct Stand {
        bool stands = false;
        int ground = -1;
        Line normal, x, y;
        Vec3 drift;  // of the ground's surface, with no impulse of its body
        Real slope = 1, rate = 0, spring = 0, resists = 0;  // F_s = spring - resists x'
        Real gain = 0, start_x = 0, start_y = 0, factor = 1, rolling = 0;
        Real s_x = 0, s_y = 0, z = 0;
    };

    struct Braking {  // the greatest impulse, and its derivative by the normal one
        Real impulse, slope;
    };
    class Newton;  // wheel_forces_newton.h

    void take_chassis();
    int ground_of(Body* body);
    void make_lines(int i, Stand& at, const WheelContact& contact);
    void make_spring(int i, Stand& at);
    void make_tyre(int i, Stand& at);
    void advance_bristles(int i, Stand& at);
    void make_rows();
    void make_brakes();
    void complete(ShaftRow& row) const;

    Real relative(const Stand& at, const Line& line) const;
    void give(const Stand& at, Line& line, Real impulse);
    void solve_normal(Stand& at);
    void solve_tyre(int i, Stand& at);
    Real rate_of(const ShaftRow& row) const;
    void give(ShaftRow& row, Real impulse);
    void solve_row(ShaftRow& row);
    Braking braking(int i, Real normal) const;
    void set_brake_limit(int k);
    void sweep();

    Real compression_of_pair(int i) const;
    void keep(int i, const Stand& at);
    void push_ground(const Stand& at, Vec3 force, Vec3 at_arm, Real change);

    Body& body_;
    Vehicle& vehicle_;
    VehicleFrame frame_;
    Real h_;
    MovedBody chassis_;
    Stand stands_[dVehicleMaxWheels];
    MovedBody grounds_[dVehicleMaxWheels];
    int ground_count_ = 0;
    Real speed_[dVehicleMaxWheels] = {}, inv_spin_inertia_[dVehicleMaxWheels] = {};
    Vec3 axle_[dVehicleMaxWheels];
    int speeds_ = 0;
    Real engine_ = 0, inv_engine_ = 0;
    ShaftRow rows_[kMostShaftRows], brakes_[dVehicleMaxWheels];
    int row_count_ = 0;
    Real last_change_ = 0, largest_ = 0;
    Vec3 lean_;  // angular impulse on the chassis
};

}  // namespace epode
