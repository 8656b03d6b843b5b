// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// One axis of a joint with stops, a motor and a bounce. With value x and rate x' = J v along the axis:
//
//   between the stops    J v = vel,              |lambda| <= fmax
//   x <= lo              J v >= erp/h (lo - x),  lambda >= 0
//   x >= hi              J v <= erp/h (hi - x),  lambda <= 0
//   lo = hi              J v = erp/h (lo - x),   unbounded: a servo spring through stop ERP and CFM
//
// With a rate r, erp/h is at most r where errors become velocities, which stay: an axis that begins far beyond a
// stop does not leave it the faster, the smaller the step is.
//
// An angle is known up to whole turns: the turn is counted from step to step while there are stops or the
// program wants it (turn_count.h). In a world with ODE's behaviour stops compare angles in -pi ... pi.
//
// One row serves stop or motor, not both: at a stop the motor's whole force acts as an external force of the
// step, scaled by the fudge factor when it pulls away (the meaning that ODE's guide gives to
// dParamFudgeFactor). An unlimited motor that pulls away from a stop keeps the row instead: an infinite force
// cannot be added.
#pragma once

#include "dynamics/joint.h"
#include "joints/parts.h"
#include "joints/turn_count.h"
#include "rows/row_writer.h"

namespace epode {

struct World;

// Is this number fit for this parameter (of any group)? Only stops and FMax may be infinite.
bool usable_param(int param, Real value);

struct LimitMotor {
    explicit LimitMotor(const World& world);

    bool set(int param, Real value);  // false: unknown here
    bool get(int param, Real& value) const;
    void state(const World& world, StateStream& stream);
    bool has_stops() const
    {
        return (lo <= hi || crossed_act) && lo < kInf && hi > -kInf && (lo > -kInf || hi < kInf);
    }

    // At most one row. `value` is read only when there are stops. Whether a stop acts, and how it rebounds,
    // is decided at the first call of a step and kept at inner poses, so that the number of rows stays the
    // same. Returns the row, or null.
    // `angle`: returns the angle up to whole turns.
    template <typename Angle>
    Row* emit_angular(const Joint& j, RowWriter& out, Vec3 axis, Angle angle)
    {
        const Real value = needs_value() ? follow(j, out, angle()) : (turns.follows = false, 0);
        return emit(j, out, angular_jacobian(j, axis), value, dot(axis, relative_angular_velocity(j)));
    }
    void emit_linear(const Joint& j, RowWriter& out, Vec3 axis, Real position);
    Row* emit(const Joint& j, RowWriter& out, const Jacobian& jacobian, Real value, Real rate);
    // The motor alone, whatever the stops.
    Row* emit_motor(RowWriter& out, const Jacobian& jacobian) const;

    bool needs_value() const { return has_stops() || turns.continuous; }
    bool counts_turns(const Joint& j) const;
    // The angle with the turns that are counted, or as it is.
    Real counted(const Joint& j, Real angle) const
    {
        return counts_turns(j) ? turns.of(angle, lo, hi) : angle;
    }
    // What the stop has exerted, the mean over the last step in which the joint acted; 0 where no stop did.
    Real stop_force(const LastingJoint& j) const
    {
        const bool acted = stop_row_ >= 0 && stop_row_ < int(j.impulse_rows) && j.impulse_step > 0;
        return acted ? j.impulse[stop_row_] / j.impulse_step : 0;
    }
    // The same, which becomes that of the last step when a step begins.
    Real follow(const Joint& j, const RowWriter& out, Real angle);

    Real lo = -kInf, hi = kInf;
    Real vel = 0, fmax = 0, fudge = 1, bounce = 0;
    Real cfm, stop_erp, stop_cfm;
    bool cfm_chosen = false, stop_chosen = false;  // set by the client, not the world's
    bool crossed_act = false;                      // stops with lo > hi count, the low one first
    Spring stop_spring;                            // in place of stop_erp and stop_cfm
    Real stop_rate = kInf;                         // the largest share of an error that pushes back in 1 s
    TurnCount turns;                               // of an angle, in the sense of the stops

  private:
    enum class Stop : unsigned char { kNone, kLow, kHigh };

    void note(Real value, Real rate);
    Row& write_stop(const Joint& j, RowWriter& out, const Jacobian& jacobian, Real value) const;
    Real erp_of(const Joint& j, const RowWriter& out) const;
    void push(const Joint& j, RowWriter& out, const Jacobian& jacobian) const;
    bool pulls_away() const;

    Stop stop_ = Stop::kNone;  // of the present step
    bool has_restitution_ = false;
    short stop_row_ = -1;  // among the joint's rows; -1: none of this step
    Real restitution_velocity_ = 0;
};

// What turns or moves an axis, and the sense of its stops against the position that a program reads.
struct AxisMotor {
    LimitMotor& motor;
    Real sense = 1;
};

// The rule of joints with two such axes: numbers of group 2 lose their group and go to the second axis, all
// others go to the first as they are.
template <typename Motor>
Motor& motor_of(Motor (&pair)[2], int& param)
{
    if ((param & 0xff00) != dParamGroup2) return pair[0];
    param &= 0xff;
    return pair[1];
}

// The rule of joints with three such axes: the group of a parameter is the number of its axis.
inline bool in_three_groups(int param) { return param >= 0 && param < 3 * dParamGroup; }
inline bool set_by_group(LimitMotor (&three)[3], int param, Real value)
{
    return in_three_groups(param) && three[param / dParamGroup].set(param % dParamGroup, value);
}
inline bool get_by_group(const LimitMotor (&three)[3], int param, Real& value)
{
    return in_three_groups(param) && three[param / dParamGroup].get(param % dParamGroup, value);
}

}  // namespace epode
