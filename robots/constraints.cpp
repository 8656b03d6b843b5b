// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See constraints.h. Couplings and ties count as their curves; rows are those of couplings, of ties, of loops.
#include "robots/constraints.h"

#include "robots/bend.h"
#include "robots/kinematics.h"
#include "robots/tie.h"

namespace epode::robots {

namespace {

Quat turn_between(const Pose& one, const Pose& two)
{
    const Quat e = one.q * conjugate(two.q);
    return e.w < 0 ? Quat{-e.w, -e.x, -e.y, -e.z} : e;
}

void append(std::vector<double>& out, Vec v) { out.insert(out.end(), {v.x, v.y, v.z}); }
void append(std::vector<double>& out, const std::vector<double>& more)
{
    out.insert(out.end(), more.begin(), more.end());
}

// Six rows of a link's Jacobian, by column.
struct Columns {
    std::vector<double> rows;
    size_t count;
    Vec linear(size_t k) const { return {rows[k], rows[count + k], rows[2 * count + k]}; }
    Vec angular(size_t k) const { return {rows[3 * count + k], rows[4 * count + k], rows[5 * count + k]}; }
};

void add_rows(std::vector<double>& out, size_t count, const std::vector<Vec>& columns)
{
    for (int row = 0; row < 3; ++row)
        for (size_t k = 0; k < count; ++k) out.push_back(columns[k][row]);
}

}  // namespace

std::vector<double> constraint_errors(const RobotModel& model, const std::vector<double>& positions)
{
    std::vector<double> out;
    for (const Coupling& coupling : model.couplings) {
        double sum = -coupling.offset;
        for (const Coupling::Term& term : coupling.terms)
            sum += term.factor * positions[size_t(model.joints[size_t(term.joint)].position)];
        out.push_back(sum - tangent_of(model, bend_of(model, coupling), positions).value);
    }
    append(out, tie_errors(model, positions));
    if (model.closures.empty()) return out;
    const std::vector<Pose> poses = forward_kinematics(model, positions);
    for (const Closure& closure : model.closures) {
        const Pose one = poses[size_t(closure.link1)] * closure.pose1,
                   two = poses[size_t(closure.link2)] * closure.pose2;
        append(out, one.p - two.p);
        const Quat e = turn_between(one, two);
        if (closure.weld) append(out, 2 * Vec{e.x, e.y, e.z});
    }
    return out;
}

std::vector<double> constraint_jacobian(const RobotModel& model, const std::vector<double>& positions)
{
    std::vector<double> out;
    std::vector<size_t> velocity;  // of each joint
    size_t count = 0;
    for (const Joint& joint : model.joints) velocity.push_back(count), count += size_t(velocities_of(joint));
    for (const Coupling& coupling : model.couplings) {
        const size_t row = out.size();
        out.resize(row + count, 0);
        for (const Coupling::Term& term : coupling.terms)
            out[row + velocity[size_t(term.joint)]] += term.factor;
        const Bend bend = bend_of(model, coupling);
        const double slope = tangent_of(model, bend, positions).slope;
        for (const Coupling::Term& term : bend.inner)
            out[row + velocity[size_t(term.joint)]] -= slope * term.factor;
    }
    append(out, tie_jacobian(model, positions));
    if (model.closures.empty()) return out;
    const std::vector<Pose> poses = forward_kinematics(model, positions);
    for (const Closure& closure : model.closures) {
        const Columns one{jacobian(model, positions, closure.link1, closure.pose1.p), count},
            two{jacobian(model, positions, closure.link2, closure.pose2.p), count};
        const Quat e = turn_between(poses[size_t(closure.link1)] * closure.pose1,
                                    poses[size_t(closure.link2)] * closure.pose2);
        std::vector<Vec> apart(count), turned(count);
        for (size_t k = 0; k < count; ++k) {
            apart[k] = one.linear(k) - two.linear(k);
            const Vec w1 = one.angular(k), w2 = two.angular(k);
            turned[k] = e.w * (w1 - w2) + cross(w1 + w2, Vec{e.x, e.y, e.z});
        }
        add_rows(out, count, apart);
        if (closure.weld) add_rows(out, count, turned);
    }
    return out;
}

}  // namespace epode::robots
