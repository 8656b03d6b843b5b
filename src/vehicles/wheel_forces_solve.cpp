// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include <algorithm>

#include "dynamics/world.h"
#include "math/trig.h"
#include "vehicles/wheel_forces_newton.h"

namespace epode {
namespace {

constexpr int kSweeps = 100;
constexpr Real kConverged = kSingle ? Real(1e-6) : Real(1e-12);  // change of an impulse, of the largest
constexpr Real kTwoPi = Real(6.283185307179586477);
constexpr Real kSlowest = Real(0.1);  // m/s: below, slips are reported as if it moved so fast

Real turned(Real angle, Real by)
{
    const Real turns = (angle + by) / kTwoPi;
    const Real rest = (turns - std::floor(turns)) * kTwoPi;
    return rest < kTwoPi ? rest : Real(0);
}

}  // namespace

// Velocity of the chassis against the ground.
Real WheelForces::relative(const Stand& at, const Line& line) const
{
    const Vec3 ground = grounds_[at.ground].velocity_at(line.arm_ground) + at.drift;
    return dot(chassis_.v - ground, line.d) + dot(chassis_.w, line.turn);
}

void WheelForces::give(const Stand& at, Line& line, Real impulse)
{
    const Real change = impulse - line.impulse;
    line.impulse = impulse;
    chassis_.v += (chassis_.inv_mass * change) * line.d;
    chassis_.w += change * line.turned;
    MovedBody& ground = grounds_[at.ground];
    if (ground.inv_mass > 0) ground.push(-change * line.d, line.arm_ground);
    last_change_ = std::max(last_change_, std::fabs(change));
    largest_ = std::max(largest_, std::fabs(impulse));
}

void WheelForces::solve_normal(Stand& at)
{
    const Real others = relative(at, at.normal) - at.normal.response * at.normal.impulse;
    const Real a = h_ / at.slope, b = at.resists / at.slope;
    const Real impulse = a * (at.spring - b * others) / (1 + a * b * at.normal.response);
    give(at, at.normal, std::max(impulse, Real(0)));
}

void WheelForces::solve_tyre(int i, Stand& at)
{
    const dVehicleWheel& w = vehicle_.wheels[i].settings;
    const int k = speed_of_wheel(vehicle_, i);
    const Real load = at.normal.impulse / h_, grip = load_factor(w, load) * at.factor;
    if (!(load > 0) || !(grip > 0)) {
        if (at.x.impulse == 0 && at.y.impulse == 0) return;
        speed_[k] += w.radius * at.x.impulse * inv_spin_inertia_[k];
        give(at, at.x, 0), give(at, at.y, 0);
        at.s_x = at.s_y = at.z = 0;
        return;
    }
    const Tyre tyre{w, at.rolling};
    at.s_x = at.start_x + at.gain * (speed_[k] * w.radius - relative(at, at.x));
    at.s_y = at.start_y - at.gain * relative(at, at.y);
    const Real zx = tyre.scale_x() * at.s_x / grip, zy = tyre.scale_y() * at.s_y / grip;
    at.z = std::sqrt(zx * zx + zy * zy);
    const Real secant = tyre_secant(at.z, w.sliding) * at.normal.impulse;
    const auto implicit = [&](Real stiffness, Real s, const Line& line, Real response) {
        const Real K = stiffness * secant, yields = at.gain * response;
        return K * (s + yields * line.impulse) / (1 + K * yields);
    };
    // A wheel that its brake holds does not yield.
    const bool held = std::fabs(brakes_[k].impulse) < brakes_[k].limit;
    const Real spins = held ? Real(0) : w.radius * w.radius * inv_spin_inertia_[k];
    const Real x = implicit(w.stiffness_x, at.s_x, at.x, at.x.response + spins), before = at.x.impulse;
    give(at, at.x, x);
    speed_[k] -= w.radius * (x - before) * inv_spin_inertia_[k];
    solve_row(brakes_[k]);
    give(at, at.y, implicit(w.stiffness_y, at.s_y, at.y, at.y.response));
}

Real WheelForces::rate_of(const ShaftRow& row) const
{
    Real rate = row.engine * engine_ - dot(row.axle, chassis_.w);
    for (int k = row.first; k < row.end; ++k) rate += row.factor[k] * speed_[k];
    return rate;
}

void WheelForces::give(ShaftRow& row, Real impulse)
{
    const Real change = impulse - row.impulse;
    row.impulse = impulse;
    for (int k = row.first; k < row.end; ++k) speed_[k] += row.factor[k] * change * inv_spin_inertia_[k];
    engine_ += row.engine * change * inv_engine_;
    chassis_.w -= chassis_.inv_inertia * (change * row.axle);
    last_change_ = std::max(last_change_, std::fabs(change));
    largest_ = std::max(largest_, std::fabs(impulse));
}

void WheelForces::solve_row(ShaftRow& row)
{
    if (!(row.response > 0)) return;
    give(row, std::clamp(row.impulse - rate_of(row) / row.response, -row.limit, row.limit));
}

// Brakes and rolling resistance. With abs the brakes leave the tyre what it has at z = 0.9.
WheelForces::Braking WheelForces::braking(int i, Real normal) const
{
    const dVehicleControls& c = vehicle_.controls;
    const dVehicleWheel& w = vehicle_.wheels[i].settings;
    const Real load = normal / h_, pressed = c.brake * w.brake_torque,
               pulled = c.handbrake * w.handbrake_torque;
    const Real rolls = w.rolling_resistance * w.radius;
    Braking out{h_ * (pressed + pulled) + rolls * normal, rolls};
    if (!vehicle_.settings.abs || !stands_[i].stands) return out;
    const Real kept = Real(0.99) * w.friction_x * stands_[i].factor * w.radius, factor = load_factor(w, load);
    if (kept * factor * normal > h_ * pressed) return out;
    return {kept * factor * normal + h_ * pulled + rolls * normal,
            kept * (factor + load * load_factor_slope(w, load)) + rolls};
}

// Of all wheels that turn with the speed k.
void WheelForces::set_brake_limit(int k)
{
    brakes_[k].limit = 0;
    for (int i = 0; i < vehicle_.wheel_count; ++i)
        if (speed_of_wheel(vehicle_, i) == k)
            brakes_[k].limit += braking(i, stands_[i].normal.impulse).impulse;
}

void WheelForces::sweep()
{
    const std::span<Stand> stands(stands_, std::size_t(vehicle_.wheel_count));
    last_change_ = largest_ = 0;
    for (Stand& at : stands)
        if (at.stands) solve_normal(at);
    for (int k = 0; k < speeds_; ++k) {
        set_brake_limit(k);
        if (brakes_[k].limit > 0) solve_row(brakes_[k]);
    }
    for (int r = 0; r < row_count_; ++r) solve_row(rows_[r]);
    for (int i = 0; i < vehicle_.wheel_count; ++i)
        if (stands_[i].stands) solve_tyre(i, stands_[i]);
}

void WheelForces::solve()
{
    for (int i = 0; i < vehicle_.wheel_count; ++i)
        if (stands_[i].stands)
            advance_bristles(i, stands_[i]), make_spring(i, stands_[i]), make_tyre(i, stands_[i]);
    make_rows(), make_brakes();
    Newton newton(*this);
    Real before = kInf;
    int pause = 1, left = 1;  // sweeps between two steps of Newton's: more where one has led away
    for (int n = 0; n < kSweeps; ++n) {
        sweep();
        if (last_change_ <= kConverged * largest_) return;
        if (last_change_ > before) pause *= 2;
        before = last_change_;
        if (--left < 0 && newton.step()) left = pause - 1;
    }
}

// What sleeps under it has borne it when it fell asleep: it wakes where the load has changed since.
void WheelForces::push_ground(const Stand& at, Vec3 force, Vec3 arm, Real change)
{
    Body* const body = grounds_[at.ground].body;
    if (!body || body->kinematic()) return;
    if (body->disabled && body->auto_disable && change > Real(0.01)) wake(*body);
    if (body->disabled) return;
    store(body->facc, load(body->facc) + force);
    store(body->tacc, load(body->tacc) + cross(arm, force));
}

void WheelForces::keep(int i, const Stand& at)
{
    VehicleWheel& wheel = vehicle_.wheels[i];
    const int k = speed_of_wheel(vehicle_, i);
    const Real before = wheel.on_ground ? wheel.load : Real(0);
    wheel.spin = speed_[k];
    wheel.angle = turned(wheel.angle, h_ * (wheel.spin - dot(axle_[k], chassis_.w)));
    wheel.on_ground = at.stands;
    wheel.load = wheel.force_x = wheel.force_y = wheel.slip = wheel.slip_ratio = wheel.slip_angle = 0;
    if (!at.stands) {
        wheel.bristle_x = wheel.bristle_y = 0;
        return;
    }
    wheel.load = at.normal.impulse / h_;
    wheel.force_x = at.x.impulse / h_, wheel.force_y = at.y.impulse / h_;
    const Real rim = wheel.spin * wheel.settings.radius, vx = relative(at, at.x), vy = relative(at, at.y);
    const Real rolls = std::max({std::fabs(rim), std::fabs(vx), kSlowest});
    wheel.slip = at.z, wheel.slip_ratio = (rim - vx) / rolls;
    wheel.slip_angle = atan2(vy, std::max(std::fabs(vx), kSlowest));
    const Real change = std::fabs(wheel.load - before) / std::max(before, Real(1e-3));
    for (const Line* line : {&at.normal, &at.x, &at.y})
        push_ground(at, (-line->impulse / h_) * line->d, line->arm_ground, change);
}

void WheelForces::apply()
{
    Vec3 force, torque = lean_ / h_;
    int standing = -1;
    for (int i = 0; i < vehicle_.wheel_count; ++i) {
        const Stand& at = stands_[i];
        keep(i, at);
        if (!at.stands) continue;
        standing = standing < 0 ? i : standing;
        for (const Line* line : {&at.normal, &at.x, &at.y}) {
            const Vec3 f = (line->impulse / h_) * line->d;
            force += f, torque += cross(line->arm, f);
        }
    }
    for (int r = 0; r < row_count_; ++r) torque -= (rows_[r].impulse / h_) * rows_[r].axle;
    for (int k = 0; k < speeds_; ++k) torque -= (brakes_[k].impulse / h_) * brakes_[k].axle;
    vehicle_.clutch_torque = row_count_ > 0 && rows_[0].engine > 0 ? -rows_[0].impulse / h_ : Real(0);
    vehicle_.engine_speed = engine_;
    vehicle_.stands = standing >= 0;
    store(body_.facc, load(body_.facc) + force);
    store(body_.tacc, load(body_.tacc) + torque);
    if (Body* under = standing >= 0 ? grounds_[stands_[standing].ground].body : nullptr;
        under && !under->kinematic() && !under->disabled)
        store(under->tacc, load(under->tacc) - lean_ / h_);
}

}  // namespace epode
