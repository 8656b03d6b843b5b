// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See limit_motor.h. Stops are limits of position: they act from the first step that begins beyond them.
#include "joints/limit_motor.h"

#include "base/streams/state_stream.h"
#include "dynamics/world.h"
#include "joints/parts.h"

namespace epode {

bool usable_param(int param, Real value)
{
    const int kind = param & (dParamGroup - 1);
    const bool may_be_infinite = kind == dParamLoStop || kind == dParamHiStop || kind == dParamFMax;
    return may_be_infinite ? usable_or_infinite(value) : usable(value);
}

LimitMotor::LimitMotor(const World& world) : cfm(world.cfm), stop_erp(world.erp), stop_cfm(world.cfm) {}

bool LimitMotor::set(int param, Real value)
{
    switch (param) {
        case dParamLoStop:
            lo = value;
            break;
        case dParamHiStop:
            hi = value;
            break;
        case dParamVel:
            vel = value;
            break;
        case dParamFMax:
            if (value >= 0) fmax = value;
            break;
        case dParamFudgeFactor:
            if (value >= 0 && value <= 1) fudge = value;
            break;
        case dParamBounce:
            bounce = value;
            break;
        case dParamCFM:
            cfm = value, cfm_chosen = true;
            break;
        case dParamStopERP:
            stop_erp = value, stop_chosen = true;
            break;
        case dParamStopCFM:
            stop_cfm = value, stop_chosen = true;
            break;
        default:
            return false;
    }
    return true;
}

void LimitMotor::state(const World& world, StateStream& stream)
{
    const OwnSoftness::Usual usual(world, stream);
    const std::uint32_t bits =
        stream.unusual({{&lo, -kInf, true},
                        {&hi, kInf, true},
                        {&vel, 0},
                        {&fmax, 0, true, 0},
                        {&fudge, 1},
                        {&bounce, 0},
                        {&cfm, usual.cfm},
                        {&stop_erp, usual.erp},
                        {&stop_cfm, usual.cfm},
                        {&stop_spring.drive.stiffness, 0, false, 0},
                        {&stop_spring.drive.damping, 0, false, 0},
                        {&turns.last, 0},
                        {&stop_rate, kInf, true, 0}},
                       (cfm_chosen ? 1u : 0u) | (stop_chosen ? 2u : 0u) | (stop_spring.acts ? 4u : 0u) |
                           (turns.continuous ? 8u : 0u) | (turns.follows ? 16u : 0u));
    if (!stream.stores()) return;
    stop_row_ = -1;
    cfm_chosen = bits & 1, stop_chosen = bits & 2, stop_spring.acts = bits & 4;
    turns.continuous = bits & 8, turns.follows = bits & 16;
}

bool LimitMotor::get(int param, Real& value) const
{
    switch (param) {
        case dParamLoStop:
            value = lo;
            break;
        case dParamHiStop:
            value = hi;
            break;
        case dParamVel:
            value = vel;
            break;
        case dParamFMax:
            value = fmax;
            break;
        case dParamFudgeFactor:
            value = fudge;
            break;
        case dParamBounce:
            value = bounce;
            break;
        case dParamCFM:
            value = cfm;
            break;
        case dParamStopERP:
            value = stop_erp;
            break;
        case dParamStopCFM:
            value = stop_cfm;
            break;
        default:
            return false;
    }
    return true;
}

bool LimitMotor::counts_turns(const Joint& j) const
{
    return turns.continuous || (has_stops() && !j.world->acts_as_ode());
}

Real LimitMotor::follow(const Joint& j, const RowWriter& out, Real angle)
{
    const Real value = counted(j, angle);
    if (!out.info().inner && counts_turns(j)) turns.take(value);
    return value;
}

void LimitMotor::emit_linear(const Joint& j, RowWriter& out, Vec3 axis, Real position)
{
    emit(j, out, sliding_jacobian(j, axis), position, dot(axis, relative_velocity(j)));
}

Row* LimitMotor::emit(const Joint& j, RowWriter& out, const Jacobian& jacobian, Real value, Real rate)
{
    if (!out.info().inner) note(value, rate);
    stop_row_ = -1;
    const bool unlimited_pull = pulls_away() && fmax == kInf && lo != hi;
    if (stop_ == Stop::kNone || unlimited_pull) return emit_motor(out, jacobian);
    stop_row_ = short(out.count());
    Row& row = write_stop(j, out, jacobian, value);
    if (fmax > 0 && fmax < kInf && lo != hi && !out.info().inner) push(j, out, jacobian);
    return &row;
}

Row* LimitMotor::emit_motor(RowWriter& out, const Jacobian& jacobian) const
{
    if (!(fmax > 0)) return nullptr;
    Row& row = out.row(jacobian, 0, RowKind::kLimit);
    row.speed = vel;
    row.erp = 0;  // there is no position to correct
    row.cfm = cfm;
    row.soft = cfm_chosen;
    row.lo = -fmax;
    row.hi = fmax;
    return &row;
}

// Decides the state of this step.
void LimitMotor::note(Real value, Real rate)
{
    stop_ = Stop::kNone;
    has_restitution_ = false;
    if (!has_stops()) return;
    if (value <= lo)
        stop_ = Stop::kLow;
    else if (value >= hi)
        stop_ = Stop::kHigh;
    const bool hits = (stop_ == Stop::kLow && rate < 0) || (stop_ == Stop::kHigh && rate > 0);
    has_restitution_ = hits && bounce > 0 && lo != hi;
    restitution_velocity_ = -bounce * rate;
}

// Projection and poses that stops move (step/island/positions/stops.h) leave no velocity behind.
Real LimitMotor::erp_of(const Joint& j, const RowWriter& out) const
{
    const World& world = *j.world;
    const bool moves_poses =
        world.projection_iterations > 0 || (!world.acts_as_ode() && world.contact_max_vel < kInf);
    return moves_poses ? stop_erp : std::min(stop_erp, stop_rate / out.info().fps);
}

Row& LimitMotor::write_stop(const Joint& j, RowWriter& out, const Jacobian& jacobian, Real value) const
{
    const bool servo = lo == hi;
    const Real error = (stop_ == Stop::kLow ? lo : hi) - value;
    Row& row = out.row(jacobian, error, servo ? RowKind::kLock : RowKind::kLimit);
    row.erp = erp_of(j, out);
    row.cfm = stop_cfm;
    row.soft = stop_chosen;
    row.has_restitution = has_restitution_;
    row.restitution_velocity = restitution_velocity_;
    stop_spring.apply_to(out, row);
    if (!servo) (stop_ == Stop::kLow ? row.lo : row.hi) = 0;
    return row;
}

bool LimitMotor::pulls_away() const
{
    return (stop_ == Stop::kLow && vel > 0) || (stop_ == Stop::kHigh && vel < 0);
}

// The motor's force outright, since the row belongs to the stop.
void LimitMotor::push(const Joint& j, RowWriter& out, const Jacobian& jacobian) const
{
    Real f = pulls_away() ? fmax * fudge : fmax;
    if (vel < 0 || (vel == 0 && stop_ == Stop::kLow)) f = -f;
    out.apply(0, f * jacobian.lin1, f * jacobian.ang1);
    if (j.body2()) out.apply(1, f * jacobian.lin2, f * jacobian.ang2);
}

}  // namespace epode
