// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Forces along dofs. Springs k, dampers d and servos act at the step's end (implicit), as ODE's drives of ours do:
//     M (v+ - v) = h (tau - c - k (q + h v+ - q0) - d v+)
//     (M + h d + h^2 k) (v+ - v) = h (tau - c - k (q - q0) - (d + h k) v),
// so M's diagonal gains h d + h^2 k. A servo whose force is limited is that where it stays within half of its limit, and elsewhere a
// row of its own with that limit (rows.h), which has the same force wherever it does not reach it.
#pragma once

#include "batch/lanes/filters.h"

namespace epode::batch {
namespace {

template <typename P, bool own>
struct Drives {
    using T = typename P::Number;
    const ModelView& model;
    Numbers<P, own> numbers;
    const P *q, *v, *control, *applied, *activations;
    P h;
    Work<P>& work;

    void find() const
    {
        ServoWork<P>* servos = work.servos;
        for (int i = 0; i < model.dofs.size(); ++i) passive(model.dofs[i], i);
        for (const BatchJoint& joint : model.joints)
            if (joint.kind == JointKind::kFree) turn_torque(joint);
        for (int i = 0; i < model.servos; ++i) servos[i] = {P(0), P(0), P(0)};
        for (int i = 0; i < model.sums.size(); ++i) measure(model.sums[i], work.sums[i]);
        for (int i = 0; i < model.actuators.size(); ++i) {
            const BatchActuator& its = model.actuators[i];
            actuate(its, input(its, control[i]), servos);
        }
        for (int i = 0; i < model.dofs.size(); ++i)
            if (model.dofs[i].servo >= 0) settle(model.dofs[i], i, servos[model.dofs[i].servo]);
    }

    void passive(const Dof& dof, int i) const
    {
        const auto number = [&](int which) { return numbers[dof.first + which]; };
        const P d = number(dof_number::kDamping), k = number(dof_number::kStiffness);
        work.added[i] = number(dof_number::kArmature) + h * (d + h * k);
        work.torque[i] = applied[i] - (d + h * k) * v[i];
        if (!dof.is_scalar) return;
        const P position = q[model.joints[dof.joint].position];
        work.torque[i] = work.torque[i] - k * (position - number(dof_number::kRest));
    }

    // A torque on a floating base is given in its link's axes, where its velocity is in the world's.
    void turn_torque(const BatchJoint& joint) const
    {
        const P* its = applied + joint.dof + 3;
        const Vec3Of<P> turned = work.link[joint.link].r * Vec3Of<P>{its[0], its[1], its[2]};
        const P by[3] = {turned.x, turned.y, turned.z};
        for (int k = 0; k < 3; ++k)
            work.torque[joint.dof + 3 + k] = work.torque[joint.dof + 3 + k] + (by[k] - its[k]);
    }

    P length_of(const BatchSum& sum) const
    {
        const P out = total(sum.first_term, sum.terms);
        return sum.curve < 0 ? out : out - bend_of(sum).value;
    }

    P total(int first, int count) const
    {
        P out(0);
        for (int k = first; k < first + count; ++k)
            out = out + numbers[model.sum_terms[k].factor] * q[model.sum_terms[k].position];
        return out;
    }

    // c2 x^2 + c3 x^3 + c4 x^4 and its derivative.
    struct Bend {
        P value, slope;
    };
    Bend bend_of(const BatchSum& sum) const
    {
        const auto c = [&](int power) { return numbers[sum.curve + curve_number::kFirst + power - 2]; };
        const P x = total(sum.first_inner, sum.inner) - numbers[sum.curve + curve_number::kZero];
        const P two(2), three(3), four(4);
        return {x * x * (c(2) + x * (c(3) + x * c(4))),
                x * (two * c(2) + x * (three * c(3) + x * (four * c(4))))};
    }

    // The sum's length, and what its own spring and damper ask for.
    void measure(const BatchSum& sum, SumWork<P>& its) const
    {
        const auto number = [&](int which) { return numbers[sum.first + which]; };
        its.length = length_of(sum);
        if (sum.curve >= 0) its.slope = bend_of(sum).slope;
        const P k = number(sum_number::kStiffness);
        its.drive = {-k * (its.length - number(sum_number::kRest)), number(sum_number::kDamping) + h * k,
                     P(1)};
    }

    P input(const BatchActuator& a, const P& control_of) const
    {
        const P u = clip(control_of, numbers[a.first + actuator_number::kLow],
                         numbers[a.first + actuator_number::kHigh]);
        if (a.filter < 0) return u;
        return filtered(a, numbers, activations[a.filter], u, h, work.activations[a.filter]);
    }

    // On a sum of coordinates: what depends on it joins its row.
    void pull(const BatchActuator& a, const P& u) const
    {
        const auto number = [&](int which) { return numbers[a.first + which]; };
        const BatchSum& sum = model.sums[a.sum];
        SumWork<P>& its = work.sums[a.sum];
        const P gear = number(actuator_number::kGear), zero(0);
        P force = number(actuator_number::kGain) * u + number(actuator_number::kBias);
        if (!a.is_servo)
            force = clip(force, number(actuator_number::kForceLow), number(actuator_number::kForceHigh));
        const P k = at_least(zero, gear * gear * number(actuator_number::kBiasPosition)),
                d = at_least(zero, gear * gear * number(actuator_number::kBiasVelocity));
        if (sum.drive >= 0) {
            its.drive.force = its.drive.force + (gear * force - k * its.length);
            its.drive.gain = its.drive.gain + (d + h * k);
            return;
        }
        spread(sum, gear * force, work.torque);
    }

    // The force along the sum, to its dofs.
    void spread(const BatchSum& sum, const P& force, P* to) const
    {
        for (int i = sum.first_term; i < sum.first_term + sum.terms; ++i) {
            const SumTerm& term = model.sum_terms[i];
            to[term.dof] = to[term.dof] + numbers[term.factor] * force;
        }
        if (sum.curve < 0) return;
        const P bent = bend_of(sum).slope * force;
        for (int i = sum.first_inner; i < sum.first_inner + sum.inner; ++i) {
            const SumTerm& term = model.sum_terms[i];
            to[term.dof] = to[term.dof] - numbers[term.factor] * bent;
        }
    }

    void actuate(const BatchActuator& a, const P& u, ServoWork<P>* servos) const
    {
        const auto number = [&](int which) { return numbers[a.first + which]; };
        if (a.sum >= 0) return pull(a, u);
        const Dof& dof = model.dofs[a.dof];
        const P gear = number(actuator_number::kGear);
        const P force = number(actuator_number::kGain) * u + number(actuator_number::kBias);
        if (!a.is_servo) {
            const P most = numbers[dof.first + dof_number::kForceLimit];
            const P clipped =
                gear * clip(force, number(actuator_number::kForceLow), number(actuator_number::kForceHigh));
            work.torque[a.dof] = work.torque[a.dof] + clip(clipped, -most, most);
            return;
        }
        const P k = gear * gear * number(actuator_number::kBiasPosition),
                d = gear * gear * number(actuator_number::kBiasVelocity);
        const P gain = d + h * k, at_rest = gear * force - k * q[a.position];
        if (dof.servo >= 0) {
            ServoWork<P>& its = servos[dof.servo];
            its.force = its.force + at_rest, its.gain = its.gain + gain;
        } else {
            work.added[a.dof] = work.added[a.dof] + h * gain;
            work.torque[a.dof] = work.torque[a.dof] + (at_rest - gain * v[a.dof]);
        }
    }

    void settle(const Dof& dof, int i, ServoWork<P>& its) const
    {
        const P most = numbers[dof.first + dof_number::kForceLimit], now = its.force - its.gain * v[i];
        its.wanted = if_greater(magnitude(now), P(T(0.5)) * most, P(1), P(0));
        work.added[i] = work.added[i] + if_positive(its.wanted, P(0), h * its.gain);
        work.torque[i] = work.torque[i] + if_positive(its.wanted, P(0), now);
    }
};

}  // namespace
}  // namespace epode::batch
