// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Forces of ties (tie.h), taken at a step's beginning as those of spatial tendons are (step_forces.cpp). Of a tie that is e off, which grows
// at the rate V, with the inverse masses A_ij = J_i M^-1 J_j' and S = sum |A_ij| of its row,
//     F = H - 2 W / (h S),    H <- H - W / (h S),    W = V + b e / h,    b = A / (10 S).
// H is what it took to hold so far, so that it holds a load without creep. With a = A / S the three of V, e and H shrink from step to
// step for all 0 < a <= 1, and while the world lets the tie give way at least a tenth as much as the tree alone would.
#include <ode/ext.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "robots/body_poses.h"
#include "robots/build.h"
#include "robots/mass_factor.h"
#include "robots/tie.h"

namespace epode::robots {

namespace {

constexpr double kPull = 0.1;

// A and S of rows.
std::vector<std::array<double, 2>> inverse_masses(const MassFactor& masses, const std::vector<double>& rows)
{
    const size_t n = masses.size(), count = rows.size() / n;
    std::vector<std::vector<double>> halves;
    for (size_t i = 0; i < count; ++i) halves.push_back(masses.halfway(&rows[i * n]));
    std::vector<std::array<double, 2>> out(count, {0, 0});
    for (size_t i = 0; i < count; ++i)
        for (size_t k = 0; k < count; ++k) {
            const double its = std::inner_product(halves[k].begin(), halves[k].end(), halves[i].begin(), 0.0);
            out[i][1] += std::fabs(its);
            if (i == k) out[i][0] = its;
        }
    return out;
}

}  // namespace

bool Robot::is_awake(const Tie& tie) const
{
    for (int number : {tie.tendon1, tie.tendon2}) {
        if (number < 0) continue;
        const Tendon& tendon = model().tendons[size_t(number)];
        if (is_awake(tendon)) return true;
        for (const Coupling::Term& term : tendon.terms)
            if (const dBodyID its = body(model().joints[size_t(term.joint)].link);
                its && dBodyIsEnabled(its) && !dBodyIsKinematic(its))
                return true;
    }
    return false;
}

// A force along a tendon's length.
void Robot::pull(int number, double force, const std::vector<Pose>& poses) const
{
    const Tendon& tendon = model().tendons[size_t(number)];
    if (!tendon.path.empty()) return act(path_of(tendon, poses), force);
    for (const Coupling::Term& term : tendon.terms) {
        const dJointID its = joints_[size_t(term.joint)];
        if (!its) continue;
        const bool is_slide = model().joints[size_t(term.joint)].kind == JointKind::kSlide;
        (is_slide ? dJointAddSliderForce : dJointAddHingeTorque)(its, dReal(term.factor * force));
    }
}

int Robot::add_ties(double h)
{
    const auto& ties = model().ties;
    if (std::none_of(ties.begin(), ties.end(), [&](const Tie& tie) { return is_awake(tie); })) return 0;
    const std::vector<double> q = positions(), rates = velocities();
    const MassFactor masses(model(), q);
    if (!masses.is_good()) return 0;
    const std::vector<double> errors = tie_errors(model(), q), rows = tie_jacobian(model(), q),
                              lengths = tendon_lengths(model(), q);
    const std::vector<std::array<double, 2>> inverse = inverse_masses(masses, rows);
    const std::vector<Pose> poses = link_poses();
    for (size_t i = 0; i < ties.size(); ++i) {
        const auto [own, sum] = inverse[i];
        if (!(own > 0)) continue;
        const double rate =
            std::inner_product(rates.begin(), rates.end(), rows.begin() + long(i * rates.size()), 0.0);
        const double stop = (rate + kPull * own / sum * errors[i] / h) / (h * sum);
        holds_[i] -= stop;
        const double force = holds_[i] - stop;
        pull(ties[i].tendon1, force, poses);
        if (ties[i].tendon2 < 0) continue;
        const double slope = curve_of(ties[i], lengths[size_t(ties[i].tendon2)]).slope;
        pull(ties[i].tendon2, -slope * force, poses);
    }
    return int(ties.size());
}

}  // namespace epode::robots
