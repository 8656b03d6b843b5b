// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The angle of a hinge comes from the relative quaternion, not from two directions and an arc cosine: it
// is then exact to rounding at every angle. Orientation error: twice the vector part of the error quaternion.
#include "joints/parts.h"

#include <algorithm>

#include "base/streams/state_stream.h"
#include "base/streams/structure_stream.h"
#include "dynamics/sleep/sleeping_forces.h"
#include "dynamics/world.h"
#include "math/rotation.h"
#include "math/trig.h"

namespace epode {

void AnchorPair::set(const Joint& j, Vec3 world_point)
{
    for (int i = 0; i < 2; ++i) local[i] = point_to_local(j.node[i].body, world_point);
}

void AxisPair::set(const Joint& j, Vec3 unit)
{
    for (int i = 0; i < 2; ++i) local[i] = direction_to_local(j.node[i].body, unit);
}

void AnchorPair::structure(StructureStream& stream) { stream.vector(local[0]), stream.vector(local[1]); }

void AxisPair::structure(StructureStream& stream) { stream.vector(local[0]), stream.vector(local[1]); }

void structure_of_axes(StructureStream& stream, int& count, int (&frame)[3], Vec3 (&axis)[3])
{
    stream.number(count, 0, 4, "a motor with more than three axes");
    for (int i = 0; i < 3; ++i) {
        stream.number(frame[i], 0, 3, "an axis of a motor in an unknown frame");
        stream.vector(axis[i]);
    }
}

void Spring::take(RowWriter& out, Row* rows, int count) const
{
    for (Row* row = rows; row < rows + count; ++row) row->drive = &drive, row->soft = true;
    out.emit_every_substep();
}

OwnSoftness::OwnSoftness(const World& world) : erp(world.erp), cfm(world.cfm) {}

bool OwnSoftness::set(int param, Real value)
{
    if (param != dParamERP && param != dParamCFM) return false;
    (param == dParamERP ? erp : cfm) = value;
    return chosen = true;
}

// The numbers belong to the format: they are those of a new world, and must never change with it.
OwnSoftness::Usual::Usual(const World& world, const StateStream& stream)
    : erp(stream.format() < 7 ? world.erp : Real(0.2)),
      cfm(stream.format() < 7 ? world.cfm : Real(sizeof(Real) == 8 ? 1e-10 : 1e-5))
{}

void OwnSoftness::state(const World& world, StateStream& stream)
{
    const Usual usual(world, stream);
    const std::uint32_t bits = stream.unusual({{&erp, usual.erp},
                                               {&cfm, usual.cfm},
                                               {&spring.drive.stiffness, 0, false, 0},
                                               {&spring.drive.damping, 0, false, 0}},
                                              (chosen ? 1u : 0u) | (spring.acts ? 2u : 0u));
    if (stream.stores()) chosen = bits & 1, spring.acts = bits & 2;
}

bool OwnSoftness::get(int param, Real& value) const
{
    if (param != dParamERP && param != dParamCFM) return false;
    value = param == dParamERP ? erp : cfm;
    return true;
}

Vec3 relative_velocity(const Joint& j)
{
    const Vec3 v = j.body1()->velocity();
    return j.body2() ? v - j.body2()->velocity() : v;
}

Vec3 relative_angular_velocity(const Joint& j)
{
    const Vec3 w = j.body1()->angular_velocity();
    return j.body2() ? w - j.body2()->angular_velocity() : w;
}

Quat relative_orientation(const Joint& j)
{
    return conjugate(orientation_of(j.body1())) * orientation_of(j.body2());
}

Real hinge_angle(Quat q1, Quat q2, Quat zero, Vec3 axis_local)
{
    const Quat q = conjugate(q1) * q2 * conjugate(zero);
    const Real s = length(q.vec());
    Real theta = 2 * atan2(s, dot(q.vec(), axis_local) >= 0 ? q.w : -q.w);
    if (theta > kPi) theta -= 2 * kPi;
    return -theta;
}

Quat hinge_zero(Quat q1, Quat q2, Vec3 axis_local, Real angle)
{
    return rotation_about(axis_local, angle) * (conjugate(q1) * q2);
}

Jacobian sliding_jacobian(const Joint& j, Vec3 d)
{
    if (!j.body2()) return {d, {}, {}, {}};
    const Vec3 a = Real(0.5) * cross(j.body2()->position() - j.body1()->position(), d);
    return {d, a, -d, a};
}

Real rate_along(const Joint& j, const Jacobian& row)
{
    const Body *b1 = j.body1(), *b2 = j.body2();
    const Real rate = dot(row.lin1, b1->velocity()) + dot(row.ang1, b1->angular_velocity());
    return b2 ? rate + dot(row.lin2, b2->velocity()) + dot(row.ang2, b2->angular_velocity()) : rate;
}

namespace {

// Two bodies feel the force at one point, or angular momentum would be lost; but where a joint is torn by more
// than a third of its levers, that point would be a lever of its own.
bool meet_at_one_point(const Joint& j, Vec3 gap, Real levers2)
{
    return j.body2() && !j.world->acts_as_ode() && length2(gap) < Real(0.1) * levers2;
}

// Where on the gap e from anchor 1 to anchor 2 that point is: half way, unless a body turns far in the step. A body that has a half of e as
// an arm has the velocity w x e/2 there, which turns e by h w/2, so that it grows by ((1 - erp)^2 + (h w/2)^2)^(1/2) a step. (A car of hinged
// wheels at 40 m/s and 1/60 s threw its chassis up after half a second.) The body that turns less far takes more of it.
Real share_of_gap(const Joint& j, Real fps)
{
    constexpr Real kFarTurn = Real(0.5);  // rad
    const Real first = length2(j.body1()->angular_velocity()),
               second = length2(j.body2()->angular_velocity());
    if (!(std::max(first, second) > kFarTurn * kFarTurn * fps * fps)) return Real(0.5);
    return second / (first + second);
}

}  // namespace

void lock_point(const Joint& j, RowWriter& out, const AnchorPair& anchor, const OwnSoftness* own)
{
    const Vec3 a1 = anchor.world(j, 0), a2 = anchor.world(j, 1);
    const Vec3 error = a2 - a1;
    Vec3 r1 = a1 - j.body1()->position(), r2 = j.body2() ? a2 - j.body2()->position() : Vec3{};
    if (meet_at_one_point(j, error, length2(r1) + length2(r2))) {
        const Real share = share_of_gap(j, out.info().fps);
        r1 += share * error, r2 -= (1 - share) * error;
    }
    if (out.count() == 0) out.point_at(r1, r2, RowForm::kPoint);
    Row* last = nullptr;
    for (int i = 0; i < 3; ++i) {
        Vec3 d;
        d.set(i, 1);
        last = &out.row(point_jacobian(j, d, r1, r2), error[i]);
        if (own) own->apply_to(*last);
    }
    if (own) own->spring.apply_to(out, *(last - 2), 3);
}

void lock_orientation(const Joint& j, RowWriter& out, Quat zero)
{
    const Quat q = relative_orientation(j) * conjugate(zero);
    const Vec3 turn = q.w < 0 ? -q.vec() : q.vec();
    const Vec3 error = Real(2) * direction_to_world(j.body1(), turn);
    for (int i = 0; i < 3; ++i) {
        Vec3 d;
        d.set(i, 1);
        out.row(angular_jacobian(j, d), error[i]);
    }
}

void lock_axis(const Joint& j, RowWriter& out, const AxisPair& axis)
{
    const Vec3 a1 = axis.world(j, 0);
    const Vec3 u = cross(a1, axis.world(j, 1));
    Vec3 p, q;
    plane_space(a1, p, q);
    out.row(angular_jacobian(j, p), dot(u, p));
    out.row(angular_jacobian(j, q), dot(u, q));
}

Jacobian separated_jacobian(const Joint& j, const AnchorPair& anchor, Vec3 d)
{
    const Vec3 p = anchor.world(j, 1);
    return point_jacobian(j, d, p - j.body1()->position(), j.body2() ? p - j.body2()->position() : Vec3{});
}

JointAxis separated_axis(const Joint& j, const AnchorPair& anchor, Vec3 d, Real position)
{
    return {separated_jacobian(j, anchor, d), position, false, true, anchor.world(j, 0), anchor.world(j, 1)};
}

void lock_level(const Joint& j, RowWriter& out, const AnchorPair& anchor, Vec3 d)
{
    out.row(separated_jacobian(j, anchor, d), dot(d, anchor.world(j, 1) - anchor.world(j, 0)));
}

namespace {

void accumulate(Body& body, Vec3 force, Vec3 torque)
{
    store(body.facc, load(body.facc) + force);
    store(body.tacc, load(body.tacc) + torque);
    note_forces(body);
}

}  // namespace

void add_torque(Joint& j, Vec3 torque)
{
    if (Body* b = j.body1()) accumulate(*b, {}, torque);
    if (Body* b = j.body2()) accumulate(*b, {}, -torque);
}

void add_sliding_force(Joint& j, Vec3 force)
{
    Body *b1 = j.body1(), *b2 = j.body2();
    if (!b1) return;
    if (!b2) return accumulate(*b1, force, {});
    const Vec3 torque = Real(0.5) * cross(b2->position() - b1->position(), force);
    accumulate(*b1, force, torque);
    accumulate(*b2, -force, torque);
}

void add_force_at(Joint& j, const AnchorPair& anchor, Vec3 force)
{
    Body *b1 = j.body1(), *b2 = j.body2();
    if (!b1) return;
    if (!b2) return accumulate(*b1, force, {});
    accumulate(*b1, force, cross(b1->rotation() * anchor.local[0], force));
    accumulate(*b2, -force, cross(force, b2->rotation() * anchor.local[1]));
}

}  // namespace epode
