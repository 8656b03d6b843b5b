// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Rows of drives. With the drive's stiffness k, damping d, armature I, dry friction F, target q0, target
// velocity u and feed-forward force f on an axis with position q and rate w,
//
//   servo     lambda = f + k (q0 - q') + d (u - w'),   |lambda| <= limit     q' = q + h w'
//   rotor     lambda = I (w - w')/h
//   friction  w' = 0,   |lambda| <= F
//
// each implicit in the rate w' after the step or substep (RowDrive), alongside the row of stop and motor.
// Without a limit, servo and rotor are one row, the sum of both. A servo without k and d is a constant force:
// with a rotor it is part of the rotor's row; without one it is a row with equal bounds.
#include "joints/drive_rows.h"

#include <algorithm>
#include <cmath>

#include "joints/coupling.h"
#include "joints/parts.h"

namespace epode {
namespace {

// The angle + 2 pi n that is nearest to `to`.
Real nearest_turn(Real angle, Real to)
{
    constexpr Real kTurn = 2 * kPi;
    return angle + kTurn * std::round((to - angle) / kTurn);
}

Real position(const JointAxis& at, const AxisDrive& axis)
{
    return at.turns && axis.continuous ? nearest_turn(at.value, axis.reference) : at.value;
}

// From the position to the target; the shorter direction for angles that do not count turns.
Real error(const JointAxis& at, const AxisDrive& axis, Real value)
{
    const Real e = axis.drive.target - value;
    return at.turns && !axis.continuous ? nearest_turn(e, 0) : e;
}

bool is_zero(const Jacobian& J) { return J.lin1 == Vec3{} && J.ang1 == Vec3{}; }

Real wide_rate(std::span<const BodyTerm> terms, const BodyMotion* motion)
{
    Real sum = 0;
    for (const BodyTerm& term : terms) {
        sum += dot(term.lin, motion->v) + dot(term.ang, motion->w);
        ++motion;
    }
    return sum;
}

Real rate(const Joint& joint, const RowWriter& out, const Jacobian& J)
{
    const BodyMotion* m = out.motion();
    if (is_coupling(joint)) return m ? wide_rate(out.terms(), m) : coupling_rate(coupling_of(joint));
    if (!m) return rate_along(joint, J);
    return dot(J.lin1, m[0].v) + dot(J.ang1, m[0].w) + dot(J.lin2, m[1].v) + dot(J.ang2, m[1].w);
}

Row& soft_row(RowWriter& out, const Jacobian& J, const RowDrive& drive, Real error, Real limit)
{
    Row& row = out.row(J, error, RowKind::kLimit);
    row.drive = &drive;
    row.erp = row.cfm = 0;
    row.soft = true;
    row.lo = -limit, row.hi = limit;
    return row;
}

// A row without position and softness.
Row& firm_row(RowWriter& out, const Jacobian& J, RowKind kind, Real lo, Real hi)
{
    Row& row = out.row(J, 0, kind);
    row.erp = row.cfm = 0;
    row.lo = lo, row.hi = hi;
    return row;
}

void emit_servo(RowWriter& out, AxisDrive& axis, const JointAxis& at, Real error)
{
    const dDrive& drive = axis.drive;
    const Real limit = drive.force_limit > 0 ? drive.force_limit : kInf;
    const bool gives_way = drive.stiffness > 0 || drive.damping > 0;
    axis.servo = {drive.stiffness, drive.damping, 0, drive.force, drive.target_velocity, 0};
    if (!gives_way) axis.servo.force = std::clamp(drive.force, -limit, limit);
    const bool together = !gives_way || limit == kInf;
    axis.servo_row = out.count();
    if (!together) soft_row(out, at.J, axis.servo, error, limit);
    if (drive.armature > 0) {
        axis.rotor = together ? axis.servo : RowDrive{};
        axis.rotor.inertia = drive.armature, axis.rotor.rate = axis.rate;
        axis.with_rotor = together;
        soft_row(out, at.J, axis.rotor, together ? error : 0, kInf);
    } else if (together && gives_way) {
        soft_row(out, at.J, axis.servo, error, kInf);
    } else if (together && drive.force != 0) {
        firm_row(out, at.J, RowKind::kLimit, axis.servo.force, axis.servo.force);
    }
    if (out.count() == axis.servo_row) axis.servo_row = -1;
}

void emit_axis(Joint& joint, int i, AxisDrive& axis, RowWriter& out)
{
    const JointAxis at = joint.type->axis(joint, i);
    const Real value = position(at, axis);
    axis.servo_row = -1, axis.with_rotor = false;
    if (!out.info().inner) axis.reference = value;
    if (!axis.driven || (is_zero(at.J) && out.terms().empty())) return;
    out.emit_every_substep();
    axis.rate = rate(joint, out, at.J);
    if (!out.info().inner) axis.start_rate = axis.rate;
    emit_servo(out, axis, at, error(at, axis, value));
    const Real friction = axis.drive.friction;
    if (friction > 0) firm_row(out, at.J, RowKind::kFriction, -friction, friction);
}

}  // namespace

Real axis_position(const Joint& joint, int i)
{
    const JointAxis at = joint.type->axis(joint, i);
    if (!joint.driven) return at.value;
    return position(at, drives_of(joint).axis[i]);
}

Real axis_rate(const Joint& joint, int i)
{
    if (is_coupling(joint)) return coupling_rate(coupling_of(joint));
    return rate_along(joint, joint.type->axis(joint, i).J);
}

void emit_drives(Joint& joint, RowWriter& out)
{
    const int axes = axis_count(joint);
    for (int i = 0; i < axes; ++i) emit_axis(joint, i, drives_of(joint).axis[i], out);
}

void store_drive_forces(Joint& joint, const RowBlock& block, const RowSystem& system)
{
    // Each axis has lines of the cache of its own. Motors may have had more axes in an earlier step.
    const bool varies = joint.type->number == dJointTypeAMotor || joint.type->number == dJointTypeLMotor;
    const int axes = varies ? kMaxAxes : axis_count(joint);
    for (int i = 0; i < axes; ++i) {
        AxisDrive& axis = drives_of(joint).axis[i];
        axis.force = 0;
        if (axis.servo_row < 0) continue;
        const auto at = std::size_t(block.first + axis.servo_row);
        Real p = system.numbers[at].p;
        if (axis.with_rotor) {
            const Real now = row_velocity(system, block, system.rows[at], system.bodies);
            p -= axis.drive.armature * (axis.start_rate - now);
        }
        axis.force = p / system.h;
    }
}

}  // namespace epode
