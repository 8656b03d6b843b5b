// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Rows of drives. With the drive's stiffness k, damping d, armature I, dry friction F, target q0, target
// velocity u and feed-forward force f on an axis with position q and rate w,
//
//   servo     lambda = f + k (q0 - q') + d (u - w'),   |lambda| <= limit     q' = q + h w'
//   rotor     lambda = I ((w - w')/h - D)
//   friction  w' = 0,   |lambda| <= F
//
// each implicit in the rate w' after the step or substep (RowDrive), alongside the row of stop and motor.
// A rotor resists the second derivative of q, J dv/dt + D. The drift D = dJ/dt v is that of bodies that move
// uniformly: of a slide that turns its centrifugal acceleration, of several angles their Coriolis terms.
// Without a limit, servo and rotor are one row, the sum of both. A servo without k and d is a constant force:
// with a rotor it is part of the rotor's row; without one it is a row with equal bounds.
#include "joints/drive_rows.h"

#include <algorithm>
#include <optional>

#include "joints/coupling.h"
#include "joints/parts.h"
#include "joints/turn_count.h"

namespace epode {
namespace {

// From the position to the target; the shorter direction for angles whose turns are not counted.
Real error(const JointAxis& at, const AxisDrive& axis)
{
    const Real e = axis.drive.target - at.value;
    return at.turns ? nearest_turn(e, 0) : e;
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

bool drifts(const JointAxis& at) { return at.slides || at.carrier != AxisCarrier::kNone; }

// D of a joint's axes at the velocities of its bodies.
class Drift {
  public:
    Drift(const Joint& joint, const BodyMotion* motion) : joint_(joint)
    {
        const Body *b1 = joint.body1(), *b2 = joint.body2();
        m1_ = motion ? motion[0] : BodyMotion{b1->velocity(), b1->angular_velocity()};
        if (b2) m2_ = motion ? motion[1] : BodyMotion{b2->velocity(), b2->angular_velocity()};
    }

    Real of(const JointAxis& at)
    {
        if (at.slides) return of_slide(at);
        const Vec3 n = at.J.ang1;
        if (at.axis == Vec3{}) return dot(cross(spin(at.carrier, {}), n), m1_.w - m2_.w);
        if (!has_swing_) swing_ = swing(), has_swing_ = true;
        return -dot(n, swing_);
    }

  private:
    // q = d.(p1 - p2)  along a direction d of body 1.
    Real of_slide(const JointAxis& at) const
    {
        const Body* b2 = joint_.body2();
        const Vec3 d = at.J.lin1, turned = cross(m1_.w, d);
        const Vec3 u1 = cross(m1_.w, at.point1 - joint_.body1()->position());
        const Vec3 u2 = b2 ? cross(m2_.w, at.point2 - b2->position()) : Vec3{};
        return dot(d, cross(m1_.w, u1) - cross(m2_.w, u2)) + 2 * dot(turned, m1_.v + u1 - m2_.v - u2) +
               dot(cross(m1_.w, turned), at.point1 - at.point2);
    }

    // Angles with rates r_i about axes a_i, of which J has the dual basis n_i: w1 - w2 = sum r_i a_i. As
    // n_i.a_j does not change, D_i = -n_i.s with the swing s = sum r_j da_j/dt.
    Vec3 swing() const
    {
        Vec3 sum, before;  // what turns between body 1 and the next axis
        JointAxis between;
        for (int i = 0; i < axis_count(joint_); ++i) {
            const JointAxis at = joint_.type->axis(joint_, i);
            if (at.slides) continue;
            if (at.carrier == AxisCarrier::kBetween) {
                between = at;
                continue;
            }
            const Vec3 turn = dot(at.J.ang1, m1_.w - m2_.w) * at.axis;
            if (at.carrier == AxisCarrier::kBody1) before = turn;
            sum += cross(spin(at.carrier, {}), turn);
        }
        if (between.carrier == AxisCarrier::kBetween)
            sum += cross(spin(between.carrier, before), dot(between.J.ang1, m1_.w - m2_.w) * between.axis);
        return sum;
    }

    Vec3 spin(AxisCarrier carrier, Vec3 before) const
    {
        if (carrier == AxisCarrier::kBody2) return m2_.w;
        return carrier == AxisCarrier::kBody1 ? m1_.w : m1_.w - before;
    }

    const Joint& joint_;
    BodyMotion m1_, m2_;
    Vec3 swing_;
    bool has_swing_ = false;
};

Real drift_of_members(const CouplingJoint& coupling)
{
    Real sum = 0;
    for_each_member(coupling, [&](const CoupledAxis& m) {
        if (!m.joint->attached() || m.axis >= axis_count(*m.joint)) return;
        const JointAxis at = m.joint->type->axis(*m.joint, m.axis);
        if (drifts(at)) sum += m.factor * Drift(*m.joint, nullptr).of(at);
    });
    return sum;
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
        axis.rotor.force -= drive.armature * axis.drift;
        axis.with_rotor = together;
        soft_row(out, at.J, axis.rotor, together ? error : 0, kInf);
    } else if (together && gives_way) {
        soft_row(out, at.J, axis.servo, error, kInf);
    } else if (together && drive.force != 0) {
        firm_row(out, at.J, RowKind::kLimit, axis.servo.force, axis.servo.force);
    }
    if (out.count() == axis.servo_row) axis.servo_row = -1;
}

// `drift`: that of the axis; asked for if there is a rotor.
template <typename DriftOf>
void emit_axis(Joint& joint, const JointAxis& at, AxisDrive& axis, RowWriter& out, DriftOf&& drift)
{
    axis.servo_row = -1, axis.with_rotor = false;
    if (!axis.driven || (is_zero(at.J) && out.terms().empty())) return;
    out.emit_every_substep();
    axis.rate = rate(joint, out, at.J);
    axis.drift = axis.drive.armature > 0 ? drift() : 0;
    if (!out.info().inner) axis.start_rate = axis.rate, axis.start_drift = axis.drift, axis.passes = 0;
    ++axis.passes;
    emit_servo(out, axis, at, error(at, axis));
    const Real friction = axis.drive.friction;
    if (friction > 0) firm_row(out, at.J, RowKind::kFriction, -friction, friction);
}

}  // namespace

Real axis_position(const Joint& joint, int i) { return joint.type->axis(joint, i).value; }

void set_continuous(Joint& joint, int i, bool continuous)
{
    if (joint.type->continuous(joint, i) == continuous) return;
    joint.type->count_turns(joint, i, continuous, joint.attached() ? axis_position(joint, i) : 0);
}

Real axis_rate(const Joint& joint, int i)
{
    if (is_coupling(joint)) return coupling_rate(coupling_of(joint));
    return rate_along(joint, joint.type->axis(joint, i).J);
}

void emit_drives(Joint& joint, RowWriter& out)
{
    const int count = axis_count(joint);
    std::optional<Drift> drift;
    for (int i = 0; i < count; ++i) {
        const JointAxis at = joint.type->axis(joint, i);
        emit_axis(joint, at, drives_of(joint).axis[i], out, [&]() -> Real {
            if (is_coupling(joint)) return drift_of_members(coupling_of(joint));
            if (!drifts(at)) return 0;
            if (!drift) drift.emplace(joint, out.motion());
            return drift->of(at);
        });
    }
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
            // In later substeps the drift is in the difference of rates.
            const Real drifted = axis.start_drift * system.h / Real(axis.passes);
            p -= axis.drive.armature * (axis.start_rate - drifted - now);
        }
        axis.force = p / system.h;
    }
}

}  // namespace epode
