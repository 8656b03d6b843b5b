// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Sums of coordinates of a built robot, as ODE's couplings: mimic joints and equalities of joints (equal stops),
// tendons (stops, springs, actuators). One that is no straight line is its tangent (bend.h), again and again. ODE's positions are p = q - r, so stops of s = sum f q are those of sum f p,
// moved by sum f r.
#include <ode/ext.h>

#include <algorithm>

#include "robots/build.h"

namespace epode::robots {

namespace {

// Up to eight hinges and sliders, not all factors 0.
bool can_couple(const RobotModel& model, const std::vector<Coupling::Term>& terms)
{
    int count = 0;
    for (const Coupling::Term& term : terms) {
        if (!model.joints[size_t(term.joint)].is_scalar()) return false;
        count += term.factor != 0;
    }
    return count >= 1 && count <= dMaxCouplingAxes;
}

dReal stop_of(double value)
{
    return std::isinf(value) ? (value > 0 ? dInfinity : -dInfinity) : dReal(value);
}

}  // namespace

// 0 of a relation that the world cannot hold.
dJointID Robot::make_coupling(dWorldID world, const std::vector<Coupling::Term>& terms, double low,
                              double high)
{
    const dJointID coupling = can_couple(model(), terms) ? dJointCreateCoupling(world, nullptr) : nullptr;
    if (!coupling) return nullptr;
    double shift = 0;
    int place = 0;
    for (const Coupling::Term& term : terms) {
        if (term.factor == 0) continue;
        dJointSetCouplingAxis(coupling, place++, joints_[size_t(term.joint)], 0, dReal(term.factor));
        shift += term.factor * model().joints[size_t(term.joint)].reference;
    }
    dJointSetCouplingParam(coupling, dParamLoStop, -dInfinity);
    dJointSetCouplingParam(coupling, dParamHiStop, stop_of(high - shift));
    dJointSetCouplingParam(coupling, dParamLoStop, stop_of(low - shift));
    all_joints_.push_back(coupling);
    return coupling;
}

void Robot::make_couplings(dWorldID world)
{
    for (size_t i = 0; i < model().couplings.size(); ++i) {
        const Coupling& coupling = model().couplings[i];
        const dJointID its = make_coupling(world, coupling.terms, coupling.offset, coupling.offset);
        if (const Bend bend = bend_of(model(), coupling);
            its && !bend.powers.empty() && coupling.terms.size() <= size_t(dMaxCouplingAxes))
            bends_.push_back({int(i), its, bend});
    }
    lay_tangents(reference_positions(model()));
    for (const Tendon& tendon : model().tendons)
        tendons_.push_back(make_coupling(world, tendon.terms, tendon.low, tendon.high));
}

// The line through where the positions are. A factor of 0 would be no place of the coupling: it is nearly 0.
void Robot::lay_tangents(const std::vector<double>& positions)
{
    constexpr double kLeast = 1e-12;
    for (const Bent& bent : bends_) {
        const Coupling& coupling = model().couplings[size_t(bent.coupling)];
        const BendTangent tangent = tangent_of(model(), bent.bend, positions);
        std::vector<Coupling::Term> terms = coupling.terms;
        const size_t first = terms.size() - bent.bend.inner.size();  // the inner ones are the last
        double shift = 0;
        for (size_t i = 0; i < terms.size(); ++i) {
            if (i >= first) terms[i].factor -= tangent.slope * bent.bend.inner[i - first].factor;
            if (terms[i].factor == 0) terms[i].factor = kLeast;
            const Joint& joint = model().joints[size_t(terms[i].joint)];
            dJointSetCouplingAxis(bent.joint, int(i), joints_[size_t(terms[i].joint)], 0,
                                  dReal(terms[i].factor));
            shift += terms[i].factor * joint.reference;
        }
        const double stop = coupling.offset + tangent.offset - shift;
        dJointSetCouplingParam(bent.joint, dParamLoStop, -dInfinity);
        dJointSetCouplingParam(bent.joint, dParamHiStop, dReal(stop));
        dJointSetCouplingParam(bent.joint, dParamLoStop, dReal(stop));
    }
}

// Before a step, unless all rests: what is moved wakes. Returns how many there are, at rest, too.
int Robot::move_tangents()
{
    const auto is_awake = [&](const Bent& bent) {
        for (const Coupling::Term& term : model().couplings[size_t(bent.coupling)].terms)
            if (const dBodyID its = body(model().joints[size_t(term.joint)].link);
                its && dBodyIsEnabled(its) && !dBodyIsKinematic(its))
                return true;
        return false;
    };
    if (std::any_of(bends_.begin(), bends_.end(), is_awake)) lay_tangents(positions());
    return int(bends_.size());
}

std::vector<std::string> Robot::not_built(const RobotModel& model)
{
    std::vector<std::string> out;
    const auto line = [](const std::string& what, int at) {
        return what + (at > 0 ? " (line " + std::to_string(at) + ")" : "") + " is not built";
    };
    for (const Coupling& coupling : model.couplings)
        if (!can_couple(model, coupling.terms))
            out.push_back(line("the coupling '" + coupling.name + "'", coupling.line));
    for (const Tendon& tendon : model.tendons)
        if (tendon.path.empty() && !can_couple(model, tendon.terms))
            out.push_back(line("the tendon '" + tendon.name + "'", tendon.line));
    if (const int left = PairMaterials(model).left_out(); left > 0)
        out.push_back("a contact of its own of " + std::to_string(left) +
                      " pairs of geoms, of more than a world has numbers for, is not built");
    for (const auto& pair : model.excluded_still)
        for (const Shape& shape : model.links[0].shapes)
            if (shape.kind == ShapeKind::kPlane && shape.still == pair[1])
                out.push_back("that the plane of '" + model.still[size_t(pair[1]) - 1] +
                              "' does not touch '" + model.links[size_t(pair[0])].name + "' is not built");
    return out;
}

}  // namespace epode::robots
