// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Coupling: one row along s = sum a_i q_i between two stops, at first lo = hi = 0. With the Jacobians J_i of
// the members' axes (dq_i/dt = J_i v) its Jacobian is sum a_i J_i, spread over the bodies of all members:
// RowWriter::couple, rows/row_system.h. Everything else about an axis, stops, springs, drives, is that of
// other joints.
#include "dynamics/coupling.h"

#include <algorithm>

#include "base/objects/structure_edition.h"
#include "joints/access.h"
#include "joints/coupling.h"
#include "joints/drive_rows.h"
#include "ode/couplings.h"

namespace epode {
namespace {

// Sums terms of the same body.
class Terms {
  public:
    void clear() { count_ = 0; }
    void add(Body* body, Vec3 lin, Vec3 ang)
    {
        if (!body) return;
        BodyTerm* const end = terms_ + count_;
        BodyTerm* const term = std::find_if(terms_, end, [&](const BodyTerm& t) { return t.body == body; });
        if (term == end) terms_[count_++] = {body, {}, {}};
        term->lin += lin, term->ang += ang;
    }
    std::span<const BodyTerm> all() const { return {terms_, std::size_t(count_)}; }

  private:
    BodyTerm terms_[kMaxBodyTerms];
    int count_ = 0;
};

bool has_axes(const CouplingJoint& coupling)
{
    bool all = true;
    for_each_member(coupling, [&](const CoupledAxis& m) { all = all && m.axis < axis_count(*m.joint); });
    return all;
}

}  // namespace

struct Coupling : CouplingJoint {
    static constexpr int kMaxRows = 1;
    static constexpr const char* kDifName = "coupling_joint";

    Coupling(const JointType& t, World& w) : CouplingJoint(t, w), stops(w) { stops.lo = stops.hi = 0; }

    void emit(RowWriter& out)
    {
        if (!acts(*this) || !has_axes(*this)) return;
        terms.clear();
        for_each_member(*this, [&](const CoupledAxis& m) {
            const Jacobian J = m.joint->type->axis(*m.joint, m.axis).J;
            terms.add(m.joint->body1(), m.factor * J.lin1, m.factor * J.ang1);
            terms.add(m.joint->body2(), m.factor * J.lin2, m.factor * J.ang2);
        });
        out.couple(terms.all());
        stops.emit(*this, out, {}, axis_at(0).value, coupling_rate(*this));
    }

    int axes() const { return 1; }
    // Without a Jacobian: see RowWriter::couple.
    JointAxis axis_at(int) const
    {
        Real s = 0;
        for_each_member(*this, [&](const CoupledAxis& m) {
            if (m.joint->attached() && m.axis < axis_count(*m.joint))
                s += m.factor * axis_position(*m.joint, m.axis);
        });
        return {{}, s, false};
    }
    LimitMotor* stops_of(int) { return &stops; }
    AxisMotor motor_at(int) { return {stops}; }

    bool set_param(int param, Real value) { return is_own(param) && stops.set(param, value); }
    bool get_param(int param, Real& value) const { return is_own(param) && stops.get(param, value); }
    static bool is_own(int param)
    {
        return param == dParamLoStop || param == dParamHiStop || param == dParamStopERP ||
               param == dParamStopCFM || param == dParamBounce;
    }

    void state(StateStream& stream)
    {
        stops.state(*world, stream);
        for (CoupledAxis& m : member)
            if (moves && m.joint) visit_factor(stream, m);
    }
    // A damaged state may have 0, which is none: the factor stays.
    static void visit_factor(StateStream& stream, CoupledAxis& m)
    {
        Real factor = m.factor;
        stream.reals(&factor, 1);
        if (factor != 0) m.factor = factor;
    }
    void structure(StructureStream& stream) { stream.real(force); }  // members: state/world_structure
    void describe(DifWriter& out) const
    {
        for (int i = 0; i < kMaxCoupledAxes; ++i)
            if (member[i].joint) out.list("axis", {Real(member[i].axis), member[i].factor}, i + 1);
        epode::describe(out, stops);
    }

    LimitMotor stops;
    Terms terms;  // of the current step
};

JOINT_DEFINE(Coupling);

Real coupling_rate(const CouplingJoint& coupling)
{
    Real rate = 0;
    for_each_member(coupling, [&](const CoupledAxis& m) {
        if (m.joint->attached() && m.axis < axis_count(*m.joint))
            rate += m.factor * axis_rate(*m.joint, m.axis);
    });
    return rate;
}

namespace {

void add_share(const CoupledAxis& m, Real force)
{
    const Jacobian J = m.joint->type->axis(*m.joint, m.axis).J;
    dJointFeedback& out = *m.joint->feedback;
    const Real f = m.factor * force;
    store(out.f1, load(out.f1) + f * J.lin1), store(out.t1, load(out.t1) + f * J.ang1);
    if (!m.joint->body2()) return;
    store(out.f2, load(out.f2) + f * J.lin2), store(out.t2, load(out.t2) + f * J.ang2);
}

}  // namespace

void clear_feedback_of_members(const CouplingJoint& coupling)
{
    for_each_member(coupling, [](const CoupledAxis& m) {
        if (m.joint->feedback) *m.joint->feedback = {};
    });
}

void add_feedback_of_members(const CouplingJoint& coupling)
{
    for_each_member(coupling, [&](const CoupledAxis& m) {
        if (m.joint->feedback) add_share(m, coupling.force);
    });
}

namespace {

// The place, or null after a refusal.
CoupledAxis* place_of(dJointID id, int i, const char* caller)
{
    Coupling* const coupling = checked<Coupling>(id, caller);
    const bool good = coupling && demand(i >= 0 && i < kMaxCoupledAxes, caller);
    return good ? &coupling->member[i] : nullptr;
}

const char* fault_of(const Coupling& coupling, const Joint* joint, int axis, Real factor)
{
    if (!joint || joint->world != coupling.world) return "the joint must be a live one of the same world";
    if (is_coupling(*joint)) return "a coupling cannot be coupled itself";
    if (axis < 0 || axis >= axis_count(*joint)) return "the joint does not have this axis";
    if (!usable(factor) || factor == 0) return "the factor must be finite and not 0";
    return nullptr;
}

void wake_bodies(const CouplingJoint& coupling)
{
    for_each_body(coupling, [](Body& body) {
        if (body.disabled) wake(body);
    });
}

// Of an axis that it has: that is no other structure, so a state of before or after can be loaded from the second change on.
void change_factor(CouplingJoint& coupling, CoupledAxis& place, Real factor)
{
    if (place.factor == factor) return;
    place.factor = factor;
    if (!coupling.moves) note_structure_changed();
    coupling.moves = true;
    forget_impulses(coupling);
    wake_bodies(coupling);
}

}  // namespace
}  // namespace epode

using namespace epode;

extern "C" {

dJointID dJointCreateCoupling(dWorldID w, dJointGroupID g) { return create_joint<Coupling>(w, g); }

int dJointSetCouplingAxis(dJointID id, int i, dJointID joint_id, int axis, dReal factor)
{
    CoupledAxis* const place = place_of(id, i, __func__);
    if (!place) return 0;
    Coupling& coupling = *checked<Coupling>(id);
    Joint* const joint = from_handle<Joint>(joint_id);
    EPODE_USER(coupling.world, 0);
    EPODE_USER_SAY(!is_busy(coupling), busy_text(*coupling.world), 0);
    if (joint_id) {
        const char* const fault = fault_of(coupling, joint, axis, factor);
        EPODE_USER_SAY(!fault, fault, 0);
        if (place->joint == joint && place->axis == axis) return change_factor(coupling, *place, factor), 1;
        EPODE_USER_SAY(list_coupling(coupling), kOutOfMemory, 0);
        set_continuous(*joint, axis, true);
        joint->coupled = true;
    }
    *place = joint_id ? CoupledAxis{joint, axis, factor} : CoupledAxis{};
    forget_impulses(coupling);
    ++coupling.world->connections_version;
    ++coupling.attachments;  // its own part has changed
    note_structure_changed();
    wake_bodies(coupling);
    return 1;
}

dJointID dJointGetCouplingJoint(dJointID id, int i)
{
    const CoupledAxis* const place = place_of(id, i, __func__);
    return place && place->joint ? to_handle(place->joint) : nullptr;
}

int dJointGetCouplingAxis(dJointID id, int i)
{
    const CoupledAxis* const place = place_of(id, i, __func__);
    return place ? place->axis : 0;
}

dReal dJointGetCouplingFactor(dJointID id, int i)
{
    const CoupledAxis* const place = place_of(id, i, __func__);
    return place ? place->factor : 0;
}

void dJointSetCouplingParam(dJointID id, int parameter, dReal value)
{
    set_joint_param<Coupling>(id, parameter, value);
}
dReal dJointGetCouplingParam(dJointID id, int parameter) { return get_joint_param<Coupling>(id, parameter); }

dReal dJointGetCouplingForce(dJointID id)
{
    const Coupling* const coupling = checked<Coupling>(id);
    return coupling ? coupling->force : 0;
}

}  // extern "C"
