// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See bend.h.
#include "robots/bend.h"

namespace epode::robots {

Bend bend_of(const RobotModel& model, const Coupling& coupling)
{
    Bend out;
    if (coupling.polynomial.empty()) return out;
    if (coupling.tendons[1] >= 0)
        out.inner = model.tendons[size_t(coupling.tendons[1])].terms;
    else if (coupling.terms.size() > 1)
        out.inner = {{coupling.terms[1].joint, 1}};
    if (!out.inner.empty()) out.powers = coupling.polynomial;
    return out;
}

BendTangent tangent_of(const RobotModel& model, const Bend& bend, const std::vector<double>& positions)
{
    BendTangent out;
    double rest = 0;
    for (const Coupling::Term& term : bend.inner) {
        const Joint& joint = model.joints[size_t(term.joint)];
        out.x += term.factor * (positions[size_t(joint.position)] - joint.reference);
        rest += term.factor * joint.reference;
    }
    for (size_t i = bend.powers.size() + 2; i-- > 0;) {  // Horner's rule
        out.slope = out.slope * out.x + out.value;
        out.value = out.value * out.x + (i >= 2 ? bend.powers[i - 2] : 0);
    }
    out.offset = out.value - out.slope * (out.x + rest);
    return out;
}

}  // namespace epode::robots
