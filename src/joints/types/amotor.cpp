// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Angular motor: up to three axes about which the relative rotation has stops and motors; no anchor.
//   rows  J = [ 0, a, 0, -a ],  a = axis i, given in the world, body 1 or body 2
// User mode: the client names axes and angles. Euler mode: axis 0 is fixed in body 1, axis 2 in body 2,
// axis 1 = a2 x a0 / |..|; with references b1 (axis 2 seen from body 1) and b2 (axis 0 seen from body 2)
// taken when mode or axes are set (body 1 and 2 as the client counts them),
//   angle0 = -atan2(a2.(a0 x b1), a2.b1)
//   angle1 = -atan2(a2.a0, a2.(a0 x a1))
//   angle2 = -atan2(b2.a1, b2.(a1 x a2))
// and motors work along a1 x a2, a1, a0 x a1: the directions that change one angle and leave the others. These are unit vectors, and
// with V = a0.(a1 x a2), the sine between the outer axes, the spin w along the first and the last is V times the rate of their angle:
//
//   w.(a1 x a2) = V angle0',   w.(a0 x a1) = V angle2'
//
// so V e is the error of a row whose angle has the error e. ODE asks for erp/h e all the same, and removes erp/V of e in a step: where V
// < erp/2 an angle overshoots by more than it was off, and where V = 0, with the two directions opposite, stops ask for a spin of
// (e0 + e2) erp/(h V). Ours ask for V e erp/(h max(V, 1 - V)): what ODE's do as long as V >= 1/2, where no ERP of 0 ... 1 overshoots
// so, and less below it, so that no angle is asked for a rate above 2 e erp/h, nor the bodies. The same holds for the speeds of motors
// and of rebounds.
//
// Turn mode: the rotation of body 1 against body 2 from the turn where the mode was set, as a vector r along its axis n, as long as
// its angle, 0 ... pi. The three axes are body 1's, with the components of r as positions; the stops of axis 0 hold |r|, whose row is
// [ 0, n, 0, -n ]. axis_local then keeps body 1's axes as body 2 saw them at the time: F, so that R1 = R2 F exp(r).
#include <algorithm>
#include <cmath>

#include "joints/access.h"
#include "joints/reading.h"
#include "math/trig.h"
#include "ode/drives.h"

namespace epode {

constexpr Real kNearLock = Real(0.05);    // V from which on drives hold their Jacobians
constexpr Real kFarFromLock = Real(0.5);  // V from which on outer angles are coordinates of their own
constexpr Real kJump = Real(1.5);         // of an Euler angle in one step, rad

struct AMotor : LastingJoint {
    static constexpr int kMaxRows = 3;
    static constexpr const char* kDifName = "ODE_angular_motor_joint";
    AMotor(const JointType& t, World& w)
        : LastingJoint(t, w), motor{LimitMotor(w), LimitMotor(w), LimitMotor(w)}
    {
        for (LimitMotor& m : motor) m.crossed_act = true;  // as in ODE, on this type alone
    }

    int mode = dAMotorUser;
    int count = 0;
    int rel[3] = {0, 0, 0};  // 0 world, 1 body 1, 2 body 2 (internal numbers)
    Vec3 axis_local[3];
    Real angle[3] = {0, 0, 0};
    Vec3 reference1, reference2;
    LimitMotor motor[3];

    // In Euler mode the axis number decides, also when the joint is attached again the other way round.
    const Body* frame(int i) const
    {
        if (mode == dAMotorTurn) return user_body(0);
        return mode == dAMotorEuler && i != 1 ? user_body(i / 2) : frame_of_rel(rel[i]);
    }
    const Body* frame_of_rel(int r) const { return r == 0 ? nullptr : node[r - 1].body; }
    Vec3 given_axis(int i) const
    {
        return direction_to_world(frame(i), mode == dAMotorTurn ? unit(i) : axis_local[i]);
    }
    static Vec3 unit(int i) { return {Real(i == 0), Real(i == 1), Real(i == 2)}; }
    int user_rel(int r) const { return reverse && r > 0 ? 3 - r : r; }

    void plain_axes(Vec3 a[3]) const;
    void motor_axes(Vec3 a[3]) const;
    void set_axis(int i, int r, Vec3 unit);
    void take_references();
    // In Euler mode: axes, and what follows from them.
    struct Euler {
        Vec3 a[3];
        Real angle[3];
    };
    const Euler& euler() const;
    int axes() const { return count; }
    LimitMotor* stops_of(int i) { return &motor[i]; }
    AxisMotor motor_at(int i) { return {motor[i], sense()}; }
    JointAxis axis_at(int i) const;
    // Attached as (0, B), Euler angles run against the axes; stops act on the internal sense, as a hinge's
    // do. (ODE tests the angle as read and so drives the body away from the range.)
    Real sense() const { return reverse && mode == dAMotorEuler ? Real(-1) : Real(1); }
    void emit(RowWriter& out);
    void count_turns_at_lock();
    static bool jumps(const TurnCount& turns, Real now);
    void emit_euler(int i, RowWriter& out, Vec3 axis);
    static Real volume(const Vec3 (&a)[3]) { return dot(a[0], cross(a[1], a[2])); }
    static void measure_along(Row& row, Real V);
    Vec3 turn() const;  // r
    void emit_turn(RowWriter& out);

    bool set_param(int param, Real value) { return set_by_group(motor, param, value); }
    bool get_param(int param, Real& value) const { return get_by_group(motor, param, value); }
    void state(StateStream& stream)
    {
        for (LimitMotor& m : motor) m.state(*world, stream);
        const auto computed = [](Real& x) { return StateStream::computed(x, 0); };
        stream.unusual({computed(angle[0]), computed(angle[1]), computed(angle[2])});
    }
    void structure(StructureStream& stream)
    {
        stream.number(mode, int(dAMotorUser), dAMotorTurn + 1, "an angular motor of an unknown mode");
        structure_of_axes(stream, count, rel, axis_local);
        stream.vector(reference1), stream.vector(reference2);
    }
    void describe(DifWriter& out) const;

  private:
    // What the angles follow from; of the bodies as the client counts them.
    struct Turn {
        Mat3 R1, R2;
        Vec3 axis0, axis2, reference1, reference2;
    };
    Euler read_euler() const;
    Reading<Turn, Euler> euler_;
};

JOINT_DEFINE(AMotor);

void AMotor::describe(DifWriter& out) const
{
    out.integer("num", count);
    out.integer("mode", mode);
    out.list("rel", {Real(rel[0]), Real(rel[1]), Real(rel[2])});
    for (int i = 0; i < 3; ++i) epode::describe(out, "axis", axis_local[i], i + 1);
    epode::describe(out, motor);
    for (int i = 0; i < 3; ++i) out.real("angle", angle[i], i + 1);
}

void AMotor::plain_axes(Vec3 a[3]) const
{
    for (int i = 0; i < 3; ++i) a[i] = given_axis(i);
    if (mode == dAMotorEuler) a[1] = normalized_or(cross(a[2], a[0]), Vec3{});
}

void AMotor::motor_axes(Vec3 a[3]) const
{
    plain_axes(a);
    if (mode != dAMotorEuler) return;
    const Vec3 first = cross(a[1], a[2]), last = cross(a[0], a[1]);
    a[0] = first, a[2] = last;
}

void AMotor::set_axis(int i, int r, Vec3 unit)
{
    rel[i] = r;
    axis_local[i] = direction_to_local(frame_of_rel(r), unit);
    if (mode == dAMotorEuler) take_references();
}

void AMotor::take_references()
{
    for (LimitMotor& m : motor) m.turns.follows = false;
    if (!attached()) return;
    if (mode == dAMotorTurn) {
        for (int i = 0; i < 3; ++i)
            axis_local[i] = direction_to_local(user_body(1), direction_to_world(user_body(0), unit(i)));
        return;
    }
    reference1 = direction_to_local(user_body(0), given_axis(2));
    reference2 = direction_to_local(user_body(1), given_axis(0));
}

AMotor::Euler AMotor::read_euler() const
{
    Euler now;
    const Vec3(&a)[3] = now.a;
    plain_axes(now.a);
    const Vec3 b1 = direction_to_world(user_body(0), reference1),
               b2 = direction_to_world(user_body(1), reference2);
    now.angle[0] = -atan2(dot(a[2], cross(a[0], b1)), dot(a[2], b1));
    now.angle[1] = -atan2(dot(a[2], a[0]), dot(a[2], cross(a[0], a[1])));
    now.angle[2] = -atan2(dot(b2, a[1]), dot(b2, cross(a[1], a[2])));
    return now;
}

const AMotor::Euler& AMotor::euler() const
{
    return euler_.of({rotation_of(user_body(0)), rotation_of(user_body(1)), axis_local[0], axis_local[2],
                      reference1, reference2},
                     [this] { return read_euler(); });
}

// The spin is the sum of rate_i a_i: an angle's Jacobian is a vector of the basis dual to the axes, which
// grows without bound where the outer axes become parallel and is held there.
JointAxis AMotor::axis_at(int i) const
{
    if (mode != dAMotorEuler) {
        const Vec3 axis = given_axis(i);
        const Body* carries = frame(i);
        JointAxis at{angular_jacobian(*this, reverse ? -axis : axis), angle[i]};
        if (mode == dAMotorTurn) at.value = turn()[i];
        if (carries) at.carrier = carrier_of(carries == body1() ? 0 : 1);
        return at;
    }
    const Euler& now = euler();
    const Vec3(&a)[3] = now.a;
    const Vec3 dual = cross(a[(i + 1) % 3], a[(i + 2) % 3]) / std::max(volume(a), kNearLock);
    const AxisCarrier carrier = i == 1 ? AxisCarrier::kBetween : carrier_of(node_of(*this, i / 2));
    return angle_among(angular_jacobian(*this, reverse ? -dual : dual),
                       sense() * motor[i].counted(*this, sense() * now.angle[i]),
                       !motor[i].counts_turns(*this), carrier, reverse ? -a[i] : a[i]);
}

Vec3 AMotor::turn() const
{
    const Mat3 F = from_columns(axis_local[0], axis_local[1], axis_local[2]);
    const Quat q = to_quat(transpose(rotation_of(user_body(1)) * F) * rotation_of(user_body(0)));
    const Real s = length(q.vec()), theta = 2 * atan2(s, std::fabs(q.w));
    return s > 0 ? ((q.w < 0 ? -theta : theta) / s) * q.vec() : Vec3{};
}

void AMotor::emit_turn(RowWriter& out)
{
    const Vec3 r = turn();
    const Real theta = length(r);
    const Vec3 n = direction_to_world(user_body(0), theta > 0 ? (1 / theta) * r : unit(0));
    const Jacobian J = angular_jacobian(*this, reverse ? -n : n);
    motor[0].emit(*this, out, J, theta, rate_along(*this, J));
}

void AMotor::emit(RowWriter& out)
{
    if (mode == dAMotorTurn) return emit_turn(out);
    Vec3 a[3];
    if (mode == dAMotorEuler) std::copy_n(euler().angle, 3, angle);
    if (mode == dAMotorEuler && !out.info().inner) count_turns_at_lock();
    motor_axes(a);
    for (int i = 0; i < count; ++i)
        if (mode == dAMotorEuler)
            emit_euler(i, out, a[i]);
        else
            motor[i].emit(*this, out, angular_jacobian(*this, a[i]), angle[i],
                          dot(a[i], relative_angular_velocity(*this)));
    if (mode != dAMotorEuler) out.mark_given();
}

// A spring has its torque by the angle, whatever direction the row has.
void AMotor::measure_along(Row& row, Real V)
{
    const Real divisor = std::max(V, 1 - V), share = V / divisor;
    row.error *= row.drive ? share : V;
    row.erp /= divisor;
    row.speed *= share;
    row.restitution_velocity *= share;
}

// Where the outer axes become parallel, the outer angles jump by half a turn, one against the other, and no turns of them can be
// counted: but those of the turn about both axes, their sum or, of opposite axes, difference. Angles whose turns are found one
// by one may ask for a turn of the bodies that is a whole one too far.
void AMotor::count_turns_at_lock()
{
    TurnCount &first = motor[0].turns, &last = motor[2].turns;
    const Real now[2] = {sense() * angle[0], sense() * angle[2]};
    const bool follow = first.follows && last.follows, jump = jumps(first, now[0]) || jumps(last, now[1]);
    if (jump) first.follows = last.follows = false;
    if (!motor[0].counts_turns(*this) || !motor[2].counts_turns(*this) || (follow && !jump)) return;
    const Vec3(&a)[3] = euler().a;
    if (!follow && volume(a) > kFarFromLock) return;
    const Real sign = dot(a[0], a[2]) < 0 ? Real(-1) : Real(1);
    const Real before = follow ? first.last + sign * last.last : 0;
    const Real both = nearest_turn(now[0] + sign * now[1], before);
    const Real of_first = motor[0].counted(*this, now[0]);
    first.take(of_first), last.take(sign * (both - of_first));
}

bool AMotor::jumps(const TurnCount& turns, Real now)
{
    return turns.follows && std::fabs(nearest_turn(now, turns.last) - turns.last) > kJump;
}

void AMotor::emit_euler(int i, RowWriter& out, Vec3 axis)
{
    Row* row = motor[i].emit_angular(*this, out, axis, [&] { return sense() * angle[i]; });
    if (row && i != 1 && !world->acts_as_ode()) measure_along(*row, volume(euler().a));
}

namespace {

AMotor* motor_for_axis(dJointID id, int i, const char* caller)
{
    AMotor* j = checked<AMotor>(id, caller);
    return j && demand(i >= 0 && i < 3, caller) ? j : nullptr;
}

}  // namespace
}  // namespace epode

using namespace epode;

extern "C" {

dJointID dJointCreateAMotor(dWorldID w, dJointGroupID g) { return create_joint<AMotor>(w, g); }

void dJointSetAMotorNumAxes(dJointID id, int count)
{
    AMotor* j = checked<AMotor>(id);
    if (j && demand(count >= 0 && count <= 3, __func__)) j->count = j->mode == dAMotorUser ? count : 3;
}

// In Euler mode, axes 0 and 2 belong to bodies 1 and 2: numbers given with rel 0 are taken as seen from them,
// as ODE does.
void dJointSetAMotorAxis(dJointID id, int i, int rel, dReal x, dReal y, dReal z)
{
    AMotor* j = motor_for_axis(id, i, __func__);
    Vec3 axis{x, y, z};
    if (!j || !demand(rel >= 0 && rel <= 2 && usable(axis) && normalize(axis), __func__)) return;
    const bool fits = j->mode == dAMotorUser || i == 1 || rel == 0 || rel == i / 2 + 1;
    if (demand(fits && j->mode != dAMotorTurn, __func__)) j->set_axis(i, j->user_rel(rel), axis);
}

// In Euler mode, axis 1 follows from the others and the angles are computed.
void dJointSetAMotorAngle(dJointID id, int i, dReal angle)
{
    AMotor* j = motor_for_axis(id, i, __func__);
    if (j && demand(usable(angle) && j->mode == dAMotorUser, __func__)) j->angle[i] = angle;
}

void dJointSetAMotorMode(dJointID id, int mode)
{
    AMotor* j = checked<AMotor>(id);
    if (!j || !demand(mode >= dAMotorUser && mode <= dAMotorTurn, __func__)) return;
    j->mode = mode;
    if (mode == dAMotorUser) return;
    j->count = 3;
    j->take_references();
}

int dJointGetAMotorNumAxes(dJointID id)
{
    const AMotor* j = checked<AMotor>(id);
    return j ? j->count : 0;
}

void dJointGetAMotorAxis(dJointID id, int i, dVector3 result)
{
    const AMotor* j = motor_for_axis(id, i, __func__);
    if (!j || !demand(result, __func__)) return;
    Vec3 a[3];
    j->motor_axes(a);
    store(result, a[i]);
}

int dJointGetAMotorAxisRel(dJointID id, int i)
{
    const AMotor* j = motor_for_axis(id, i, __func__);
    return j ? j->user_rel(j->rel[i]) : 0;
}

dReal dJointGetAMotorAngle(dJointID id, int i)
{
    const AMotor* j = motor_for_axis(id, i, __func__);
    if (j && j->mode == dAMotorTurn) return j->attached() ? j->turn()[i] : 0;
    return j ? j->angle[i] : 0;
}

dReal dJointGetAMotorAngleRate(dJointID id, int i)
{
    const AMotor* j = motor_for_axis(id, i, __func__);
    if (!j || !j->attached()) return 0;
    Vec3 a[3];
    j->motor_axes(a);
    const Real rate = dot(a[i], relative_angular_velocity(*j));
    return j->reverse ? -rate : rate;
}

int dJointGetAMotorMode(dJointID id)
{
    const AMotor* j = checked<AMotor>(id);
    return j ? j->mode : 0;
}

// Along the axes themselves, in Euler mode too.
void dJointAddAMotorTorques(dJointID id, dReal torque1, dReal torque2, dReal torque3)
{
    AMotor* j = joint_for_point<AMotor>(id, {torque1, torque2, torque3});
    if (!j) return;
    const Vec3 torque{torque1, torque2, torque3};
    Vec3 a[3], sum;
    j->plain_axes(a);
    for (int i = 0; i < j->count; ++i) sum += torque[i] * a[i];
    add_torque(*j, j->reverse ? -sum : sum);
}

void dJointSetAMotorParam(dJointID id, int param, dReal value) { set_joint_param<AMotor>(id, param, value); }
dReal dJointGetAMotorParam(dJointID id, int param) { return get_joint_param<AMotor>(id, param); }

}  // extern "C"
