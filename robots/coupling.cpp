// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Sums of coordinates of a built robot, as ODE's couplings: mimic joints and equalities of joints (equal stops),
// tendons (stops, springs, actuators). ODE's positions are p = q - r, so stops of s = sum f q are those of sum f p,
// moved by sum f r.
#include <ode/ext.h>

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
    for (const Coupling& coupling : model().couplings)
        make_coupling(world, coupling.terms, coupling.offset, coupling.offset);
    for (const Tendon& tendon : model().tendons)
        tendons_.push_back(make_coupling(world, tendon.terms, tendon.low, tendon.high));
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
