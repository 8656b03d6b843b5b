// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Transmission: the rims of two wheels do not slip on each other, or on the chain around both.
//   S(x) = -g1 r1 f1 + g2 r2 f2 + (l.(a1 - a2)) - S0      slip; |S| <= backlash
//   J    = [ l, (c1 - x1) x l, -l, -((c2 - x2) x l) ],    dS/dt = J v     l, c_i: see gear_mesh.h
// f_i is the angle of the spoke c_i - a_i as body i sees it, about n_i, counted on through full turns: it
// runs against the wheel's own turning. g_i = +1 where turning about n_i moves the rim along l, else -1; for
// parallel axes that makes S = r1 f1 + r2 f2, for a chain r1 f1 - r2 f2. The bracket, of intersecting axes
// alone, makes J the exact derivative of S. A chain pulls: it is taken on the side where the force that S
// calls for is tension. ODE gives S one sign for all intersecting axes, so that some gears drive themselves,
// and has the chain push.
#include "joints/access.h"
#include "joints/types/gear_mesh.h"
#include "math/trig.h"

namespace epode {

struct Transmission : LastingJoint {
    static constexpr int kMaxRows = 1;
    static constexpr const char* kDifName = "transmission_joint";
    static constexpr bool kNeedsTwoBodies = true;
    Transmission(const JointType& t, World& w) : LastingJoint(t, w), softness(w) {}

    int mode = dTransmissionParallelAxes;
    AnchorPair anchor;                            // centres of the wheels
    Vec3 axis_local[2] = {{1, 0, 0}, {1, 0, 0}};  // each in its own body
    Real ratio = 1, backlash = 0;
    Real radius[2] = {0, 0};  // chain: given; else measured
    OwnSoftness softness;

    // What is kept from step to step.
    bool fresh = true;      // wheels have been moved: angles start at zero
    bool regeared = false;  // sizes have changed: slip starts at zero
    bool meshing = false;   // the wheels had a line in this step
    enum class Play : unsigned char { kNone, kInside, kAhead, kBehind } play = Play::kNone;
    bool mirrored = false;  // side of the chain
    GearMesh mesh;
    Vec3 spoke_local[2];             // in each body, where its angle is zero
    Real angle[2] = {0, 0};          // at the beginning of the step
    Real present_angle[2] = {0, 0};  // at the last pose seen
    Real zero_slip = 0;

    Vec3 axis(int i) const { return direction_to_world(node[i].body, axis_local[i]); }
    void set_axis(int i, Vec3 unit)
    {
        axis_local[i] = direction_to_local(node[i].body, unit);
        fresh = true;
    }

    void emit(RowWriter& out);
    void bodies_changed() { fresh = true; }
    OwnSoftness* own_softness() { return &softness; }
    bool set_param(int param, Real value) { return softness.set(param, value); }
    bool get_param(int param, Real& value) const { return softness.get(param, value); }
    void state(StateStream& stream);
    void shift(Vec3 by)
    {
        for (Vec3& contact : mesh.contact) contact += by;
    }
    void structure(StructureStream& stream)
    {
        stream.number(mode, int(dTransmissionParallelAxes), dTransmissionChainDrive + 1,
                      "a transmission of an unknown mode");
        anchor.structure(stream);
    }
    void describe(DifWriter& out) const;

  private:
    bool find_mesh(bool other_side);
    Vec3 spoke(int i) const;
    Real sense(int i) const;
    void align_axes();
    void measure();
    void update_angles(Real lookahead);
    Real raw_slip() const;
    void begin_step(Real h);
    void decide(Real slip);
    void write(RowWriter& out, Real slip) const;
};

JOINT_DEFINE(Transmission);

void Transmission::describe(DifWriter& out) const
{
    out.integer("mode", mode);
    epode::describe(out, anchor);
    for (int i = 0; i < 2; ++i) epode::describe(out, "axis", axis_local[i], i + 1);
    for (int i = 0; i < 2; ++i) out.real("radius", radius[i], i + 1);
    out.real("ratio", ratio);
    out.real("backlash", backlash);
    epode::describe(out, softness);
}

// Axes, ratio and radii too: the first step measures them.
void Transmission::state(StateStream& stream)
{
    for (Vec3* v : {&axis_local[0], &axis_local[1], &spoke_local[0], &spoke_local[1], &mesh.line,
                    &mesh.contact[0], &mesh.contact[1]})
        stream.reals(&v->x, 3);
    const auto computed = [](Real& x, Real usual) { return StateStream::computed(x, usual); };
    stream.unusual(
        {computed(ratio, 1), {&backlash, 0, false, 0}, computed(radius[0], 0), computed(radius[1], 0)});
    stream.unusual({computed(angle[0], 0), computed(angle[1], 0), computed(zero_slip, 0)});
    const std::uint32_t bits = stream.word((fresh ? 1u : 0u) | (regeared ? 2u : 0u));
    if (stream.stores()) fresh = bits & 1, regeared = bits & 2;
    softness.state(*world, stream);
}

bool Transmission::find_mesh(bool other_side)
{
    const Wheel wheel[2] = {{anchor.world(*this, 0), axis(0)}, {anchor.world(*this, 1), axis(1)}};
    if (mode == dTransmissionParallelAxes) return mesh_parallel(wheel, ratio, mesh);
    if (mode == dTransmissionIntersectingAxes) return mesh_intersecting(wheel, mesh);
    return mesh_chain(wheel, radius, other_side, mesh);
}

// In the plane of wheel i.
Vec3 Transmission::spoke(int i) const
{
    const Vec3 n = axis(i), s = mesh.contact[i] - anchor.world(*this, i);
    return s - dot(n, s) * n;
}

Real Transmission::sense(int i) const
{
    return dot(mesh.line, cross(axis(i), spoke(i))) < 0 ? Real(-1) : Real(1);
}

// Axes that point against each other: the first is turned round, as in ODE; at right angles rounding must not
// decide.
void Transmission::align_axes()
{
    constexpr Real kClearlyObtuse = sizeof(Real) == 8 ? Real(-1e-9) : Real(-1e-4);
    if (dot(axis(0), axis(1)) < kClearlyObtuse) axis_local[0] = -axis_local[0];
}

void Transmission::measure()
{
    if (mode != dTransmissionChainDrive)
        for (int i = 0; i < 2; ++i) radius[i] = length(spoke(i));
    if (mode != dTransmissionParallelAxes && radius[1] > 0) ratio = radius[0] / radius[1];
}

// Whole turns are counted from the last angle, moved on by what the wheel turns in `lookahead`.
void Transmission::update_angles(Real lookahead)
{
    for (int i = 0; i < 2; ++i) {
        const Vec3 n = axis(i), s = spoke(i), e = direction_to_world(node[i].body, spoke_local[i]);
        const Real expected = present_angle[i] - lookahead * dot(n, node[i].body->angular_velocity());
        const Real a = atan2(dot(s, cross(n, e)), dot(s, e));
        present_angle[i] = a + 2 * kPi * std::round((expected - a) / (2 * kPi));
    }
}

Real Transmission::raw_slip() const
{
    const Real turned = sense(1) * radius[1] * present_angle[1] - sense(0) * radius[0] * present_angle[0];
    if (mode != dTransmissionIntersectingAxes) return turned;
    return turned + dot(mesh.line, anchor.world(*this, 0) - anchor.world(*this, 1));
}

void Transmission::begin_step(Real h)
{
    if (fresh) align_axes();
    meshing = find_mesh(false);
    if (!meshing) return;
    if (fresh || regeared) measure();
    for (int i = 0; i < 2; ++i) {
        if (fresh)
            angle[i] = 0, spoke_local[i] = direction_to_local(node[i].body, normalized_or(spoke(i), {}));
        present_angle[i] = angle[i];
    }
    update_angles(fresh ? 0 : h);
    for (int i = 0; i < 2; ++i) angle[i] = present_angle[i];
    if (fresh || regeared) zero_slip = raw_slip();
    fresh = regeared = false;
    decide(raw_slip() - zero_slip);
}

// On which side of the play, and of the chain, this step is.
void Transmission::decide(Real slip)
{
    const bool inside = std::fabs(slip) <= backlash;
    play = backlash == 0 ? Play::kNone : inside ? Play::kInside : slip > 0 ? Play::kAhead : Play::kBehind;
    mirrored = mode == dTransmissionChainDrive && slip > 0;
}

void Transmission::write(RowWriter& out, Real slip) const
{
    const Vec3 r1 = mesh.contact[0] - body1()->position(), r2 = mesh.contact[1] - body2()->position();
    const RowKind kind = play == Play::kNone ? RowKind::kLock : RowKind::kLimit;
    Row& row = out.row(point_jacobian(*this, mesh.line, r1, r2), 0, kind);
    softness.apply_to(out, row);
    if (play != Play::kInside) row.error = -slip + (play == Play::kNone ? 0 : std::copysign(backlash, slip));
    if (play == Play::kAhead || play == Play::kInside) row.hi = 0;
    if (play == Play::kBehind || play == Play::kInside) row.lo = 0;
}

// Inside the play the row is there without force, so that feedback reads zero.
void Transmission::emit(RowWriter& out)
{
    const bool inner = out.info().inner;
    if (!inner) begin_step(out.info().h);
    if (!meshing) return;
    if (inner && find_mesh(false)) update_angles(0);
    const Real slip = raw_slip() - zero_slip;
    if (mirrored) find_mesh(true);
    write(out, slip);
}

namespace {

void set_end(dJointID id, int i, Vec3 point, const char* caller)
{
    Transmission* j = joint_for_point<Transmission>(id, point, caller);
    if (!j) return;
    j->anchor.local[i] = point_to_local(j->node[i].body, point);
    j->fresh = true;
}

void get_end(dJointID id, int i, Real* result, const char* caller)
{
    if (const Transmission* j = joint_for_result<Transmission>(id, result, caller))
        store(result, j->anchor.world(*j, i));
}

void set_axis(dJointID id, int i, Vec3 axis, const char* caller)
{
    Transmission* j = joint_for_axis<Transmission>(id, axis, caller);
    if (j && demand(j->mode == dTransmissionIntersectingAxes, caller)) j->set_axis(i, axis);
}

void get_axis(dJointID id, int i, Real* result, const char* caller)
{
    if (const Transmission* j = joint_for_result<Transmission>(id, result, caller)) store(result, j->axis(i));
}

void get_contact(dJointID id, int i, Real* result, const char* caller)
{
    const Transmission* j = checked<Transmission>(id, caller);
    if (j && demand(result, caller)) store(result, j->mesh.contact[i]);
}

void set_radius(dJointID id, int i, Real radius, const char* caller)
{
    Transmission* j = joint_for_number<Transmission>(id, radius, caller);
    if (!j || !demand(j->mode == dTransmissionChainDrive && radius > 0, caller)) return;
    j->radius[i] = radius;
    j->regeared = true;
}

Real radius_of(dJointID id, int i, const char* caller)
{
    const Transmission* j = checked<Transmission>(id, caller);
    return j ? j->radius[i] : 0;
}

Real angle_of(dJointID id, int i, const char* caller)
{
    const Transmission* j = checked<Transmission>(id, caller);
    return j ? j->angle[i] : 0;
}

}  // namespace
}  // namespace epode

using namespace epode;

extern "C" {

dJointID dJointCreateTransmission(dWorldID w, dJointGroupID g) { return create_joint<Transmission>(w, g); }

void dJointSetTransmissionMode(dJointID id, int mode)
{
    Transmission* j = checked<Transmission>(id);
    const bool known = mode == dTransmissionParallelAxes || mode == dTransmissionIntersectingAxes ||
                       mode == dTransmissionChainDrive;
    if (!j || !demand(known, __func__)) return;
    j->fresh |= j->mode != mode;
    j->mode = mode;
}

int dJointGetTransmissionMode(dJointID id)
{
    const Transmission* j = checked<Transmission>(id);
    return j ? j->mode : 0;
}

void dJointSetTransmissionAnchor1(dJointID id, dReal x, dReal y, dReal z)
{
    set_end(id, 0, {x, y, z}, __func__);
}
void dJointSetTransmissionAnchor2(dJointID id, dReal x, dReal y, dReal z)
{
    set_end(id, 1, {x, y, z}, __func__);
}
void dJointGetTransmissionAnchor1(dJointID id, dVector3 result) { get_end(id, 0, result, __func__); }
void dJointGetTransmissionAnchor2(dJointID id, dVector3 result) { get_end(id, 1, result, __func__); }

// One direction for both wheels; intersecting axes have two.
void dJointSetTransmissionAxis(dJointID id, dReal x, dReal y, dReal z)
{
    Vec3 axis{x, y, z};
    Transmission* j = joint_for_axis<Transmission>(id, axis);
    if (!j || !demand(j->mode != dTransmissionIntersectingAxes, __func__)) return;
    j->set_axis(0, axis);
    j->set_axis(1, axis);
}

void dJointSetTransmissionAxis1(dJointID id, dReal x, dReal y, dReal z)
{
    set_axis(id, 0, {x, y, z}, __func__);
}
void dJointSetTransmissionAxis2(dJointID id, dReal x, dReal y, dReal z)
{
    set_axis(id, 1, {x, y, z}, __func__);
}

void dJointGetTransmissionAxis(dJointID id, dVector3 result)
{
    const Transmission* j = joint_for_result<Transmission>(id, result);
    if (j && demand(j->mode != dTransmissionIntersectingAxes, __func__)) store(result, j->axis(0));
}

void dJointGetTransmissionAxis1(dJointID id, dVector3 result) { get_axis(id, 0, result, __func__); }
void dJointGetTransmissionAxis2(dJointID id, dVector3 result) { get_axis(id, 1, result, __func__); }
void dJointGetTransmissionContactPoint1(dJointID id, dVector3 result)
{
    get_contact(id, 0, result, __func__);
}
void dJointGetTransmissionContactPoint2(dJointID id, dVector3 result)
{
    get_contact(id, 1, result, __func__);
}

void dJointSetTransmissionRatio(dJointID id, dReal ratio)
{
    Transmission* j = joint_for_number<Transmission>(id, ratio);
    if (!j || !demand(j->mode == dTransmissionParallelAxes && ratio > 0, __func__)) return;
    j->ratio = ratio;
    j->regeared = true;
}

dReal dJointGetTransmissionRatio(dJointID id)
{
    const Transmission* j = checked<Transmission>(id);
    return j ? j->ratio : 0;
}

void dJointSetTransmissionRadius1(dJointID id, dReal radius) { set_radius(id, 0, radius, __func__); }
void dJointSetTransmissionRadius2(dJointID id, dReal radius) { set_radius(id, 1, radius, __func__); }
dReal dJointGetTransmissionRadius1(dJointID id) { return radius_of(id, 0, __func__); }
dReal dJointGetTransmissionRadius2(dJointID id) { return radius_of(id, 1, __func__); }
dReal dJointGetTransmissionAngle1(dJointID id) { return angle_of(id, 0, __func__); }
dReal dJointGetTransmissionAngle2(dJointID id) { return angle_of(id, 1, __func__); }

void dJointSetTransmissionBacklash(dJointID id, dReal backlash)
{
    Transmission* j = joint_for_number<Transmission>(id, backlash);
    if (j && demand(backlash >= 0, __func__)) j->backlash = backlash;
}

dReal dJointGetTransmissionBacklash(dJointID id)
{
    const Transmission* j = checked<Transmission>(id);
    return j ? j->backlash : 0;
}

void dJointSetTransmissionParam(dJointID id, int param, dReal value)
{
    set_joint_param<Transmission>(id, param, value);
}
dReal dJointGetTransmissionParam(dJointID id, int param) { return get_joint_param<Transmission>(id, param); }

}  // extern "C"
