// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// How the forces are set up; wheel_forces_solve.cpp solves for them.
#include "vehicles/wheel_forces.h"

#include <algorithm>

#include "contacts/material.h"
#include "dynamics/impulse.h"
#include "dynamics/world.h"
#include "math/trig.h"
#include "step/common/link.h"

namespace epode {
namespace {

constexpr Real kFollowed = Real(0.25);  // h^2 k / m of a spring that a step can follow

Mat3 inverse_inertia(const Body& body)
{
    const Vec3 x = turned_by(body, {1, 0, 0}), y = turned_by(body, {0, 1, 0}), z = turned_by(body, {0, 0, 1});
    return from_columns(x, y, z);
}

MovedBody moved_body(Body& body)
{
    return {&body,           body.inv_mass,   inverse_inertia(body),
            body.position(), body.velocity(), body.angular_velocity()};
}

Vec3 surface_velocity(const WheelContact& contact)
{
    if (!contact.geom->material) return {};
    const dMaterial& material = material_at(*contact.geom, contact.pos, contact.normal);
    return pose_of(*contact.geom).R * load(material.surface_velocity);
}

// Times the friction of the tyre: the ground's, of which the default material has 1.
Real friction_of(const WheelContact& contact)
{
    const dMaterial& material = material_at(*contact.geom, contact.pos, contact.normal);
    return std::min(material.friction / kDefaultMaterial.friction, Real(100));
}

}  // namespace

WheelForces::WheelForces(Body& chassis, Real h)
    : body_(chassis), vehicle_(*chassis.vehicle), frame_(frame_of(chassis)), h_(h)
{
    take_chassis();
    const dVehicleSettings& s = vehicle_.settings;
    inv_engine_ = 1 / s.engine_inertia;
    vehicle_.engine_torque = engine_torque(vehicle_);
    engine_ = std::max(vehicle_.engine_speed + h * inv_engine_ * vehicle_.engine_torque, Real(0));
    speeds_ = speed_count(vehicle_);
    Real inertia[dVehicleMaxWheels] = {};
    for (int i = 0; i < vehicle_.wheel_count; ++i) {
        const VehicleWheel& wheel = vehicle_.wheels[i];
        const int k = speed_of_wheel(vehicle_, i);
        inertia[k] += wheel.settings.inertia;
        speed_[k] = wheel.spin;
        axle_[k] = frame_.axle_of(wheel.steer);
    }
    for (int k = 0; k < speeds_; ++k) inv_spin_inertia_[k] = inertia[k] > 0 ? 1 / inertia[k] : Real(0);
}

// v* and w*, but for the air: that depends on the velocity.
void WheelForces::take_chassis()
{
    chassis_ = moved_body(body_);
    const dVehicleSettings& s = vehicle_.settings;
    const Vec3 v = chassis_.v;
    const Real speed = length(v);
    const Vec3 air = (-s.drag * speed / (1 + h_ * s.drag * speed * body_.inv_mass)) * v -
                     (s.downforce * dot(v, frame_.forward) * dot(v, frame_.forward)) * frame_.up;
    store(body_.facc, load(body_.facc) + air);
    const Vec3 fall = body_.gravity && !body_.kinematic() ? body_.world->gravity : Vec3{};
    chassis_.v += h_ * (body_.inv_mass * load(body_.facc) + fall);
    chassis_.w += h_ * (chassis_.inv_inertia * load(body_.tacc));
}

int WheelForces::ground_of(Body* body)
{
    for (int k = 0; k < ground_count_; ++k)
        if (grounds_[k].body == body) return k;
    if (body) grounds_[ground_count_] = moved_body(*body);
    return ground_count_++;
}

void WheelForces::stand(int i, const WheelContact& contact)
{
    VehicleWheel& wheel = vehicle_.wheels[i];
    Stand& at = stands_[i];
    at = {};
    wheel.compression = contact.geom ? contact.compression : Real(0);
    if (!contact.geom) return;
    at.stands = true;
    at.ground = ground_of(body_of(*contact.geom));
    at.factor = friction_of(contact);
    at.drift = surface_velocity(contact);
    make_lines(i, at, contact);
}

void WheelForces::make_lines(int i, Stand& at, const WheelContact& contact)
{
    const dVehicleWheel& w = vehicle_.wheels[i].settings;
    const Vec3 n = contact.normal, arm = contact.pos - chassis_.centre;
    const MovedBody& ground = grounds_[at.ground];
    const Vec3 t = normalized_or(cross(frame_.axle_of(vehicle_.wheels[i].steer), n), frame_.forward);
    const Vec3 hub = body_.pose().R * load(w.position) + contact.compression * frame_.up;
    const Vec3 raised = w.roll_centre * frame_.up;
    at.slope = std::max(dot(n, frame_.up), kLeastSlope);
    const auto line = [&](Vec3 d, Vec3 at_chassis, Vec3 at_ground) {
        const Vec3 turn = cross(at_chassis, d);
        Line out{d, at_chassis, at_ground, turn, chassis_.inv_inertia * turn};
        out.response = chassis_.inv_mass + dot(out.turn, out.turned) + ground.yielding(at_ground, d);
        return out;
    };
    const Vec3 arm_ground = contact.pos - ground.centre;
    at.normal = line(n, arm, arm_ground);
    at.x = line(t, hub, arm_ground);
    at.y = line(cross(n, t), arm + raised, arm_ground + raised);
}

Real WheelForces::compression_of_pair(int i) const
{
    for (int k = 0; k < vehicle_.wheel_count; ++k)
        if (k != i && vehicle_.wheels[k].settings.axle == vehicle_.wheels[i].settings.axle)
            return vehicle_.wheels[k].compression;
    return vehicle_.wheels[i].compression;
}

// F_s = spring - resists x', with x' at the end of the step; at.rate is x' at its beginning.
void WheelForces::make_spring(int i, Stand& at)
{
    const dVehicleWheel& w = vehicle_.wheels[i].settings;
    const Real x = vehicle_.wheels[i].compression, beyond = std::max(x - w.travel, Real(0));
    const Real weight = at.normal.response / (at.slope * at.slope);  // 1/m
    const Real damping = at.rate > 0 ? w.bump_damping : w.rebound_damping;
    const Real a = h_ * damping * weight, mean = Real(0.5) + a / (12 + 2 * a);
    const Real stiffness = w.stiffness + (beyond > 0 ? w.stop_stiffness : Real(0)) + w.anti_roll;
    const Real followed = kFollowed / (h_ * h_ * std::max(weight, Real(1e-30)));
    const Real rest = std::max(stiffness - followed, Real(0));
    at.spring = w.preload + w.stiffness * x + w.stop_stiffness * beyond +
                w.anti_roll * (x - compression_of_pair(i)) + (1 - mean) * damping * at.rate;
    at.resists = mean * damping + h_ * rest;
}

// What the tread has slipped since the last update.
void WheelForces::advance_bristles(int i, Stand& at)
{
    VehicleWheel& wheel = vehicle_.wheels[i];
    const Vec3 v = body_.velocity(), w = body_.angular_velocity();
    const MovedBody& ground = grounds_[at.ground];
    const auto moves = [&](const Line& line) {
        return dot(v + cross(w, line.arm) - ground.velocity_at(line.arm_ground) - at.drift, line.d);
    };
    at.rate = -moves(at.normal) / at.slope;
    const Real rim = wheel.spin * wheel.settings.radius, vx = moves(at.x), vy = moves(at.y);
    at.rolling = std::max(std::fabs(vx), std::fabs(rim));
    const Tyre tyre{wheel.settings, at.rolling};
    if (wheel.on_ground)
        tyre.roll(wheel.bristle_x, wheel.bristle_y, rim - vx, -vy, h_);
    else
        wheel.bristle_x = wheel.bristle_y = 0;
}

void WheelForces::make_tyre(int i, Stand& at)
{
    const VehicleWheel& wheel = vehicle_.wheels[i];
    const Tyre tyre{wheel.settings, at.rolling};
    at.gain = tyre.gain(h_);
    at.start_x = tyre.start(wheel.bristle_x, h_), at.start_y = tyre.start(wheel.bristle_y, h_);
}

void WheelForces::complete(ShaftRow& row) const
{
    row.axle = {};
    row.response = row.engine * row.engine * inv_engine_;
    for (int k = row.first; k < row.end; ++k) {
        row.axle += row.factor[k] * axle_[k];
        row.response += row.factor[k] * row.factor[k] * inv_spin_inertia_[k];
    }
    row.response += dot(row.axle, chassis_.inv_inertia * row.axle);
}

void WheelForces::make_rows()
{
    row_count_ = make_shaft_rows(vehicle_, h_, rows_);
    for (int r = 0; r < row_count_; ++r) complete(rows_[r]);
}

void WheelForces::make_brakes()
{
    for (int k = 0; k < speeds_; ++k) {
        brakes_[k].set(k, 1);
        complete(brakes_[k]);
    }
}

void WheelForces::add_lean(Real torque)
{
    lean_ = (h_ * torque) * frame_.forward;
    chassis_.w += chassis_.inv_inertia * lean_;
}

Vec3 WheelForces::mean_contact() const
{
    Vec3 sum;
    int count = 0;
    for (int i = 0; i < vehicle_.wheel_count; ++i)
        if (stands_[i].stands) sum += stands_[i].normal.arm, ++count;
    return count > 0 ? sum / Real(count) : sum;
}

}  // namespace epode
