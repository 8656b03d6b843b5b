// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// How much kinetic energy corrections of positions may make (island/divergence.h): as much as there is, and that of all bodies at
// 3 m/s, the largest velocity with which relaxing leaves contacts.
#pragma once

#include "dynamics/body.h"
#include "step/island/problem/assemble.h"

namespace epode {

inline constexpr Real kCorrecting = 3;  // m/s

inline bool moves_by_itself(const SolverBody& body) { return !(body.inv_mass > 0); }

inline double kinetic_of(const Body& body, Vec3 v, Vec3 w_local)
{
    return 0.5 * (double(body.mass.mass) * double(length2(v)) + double(dot(w_local, body.inertia * w_local)));
}

// Kinetic energy and mass of an island's bodies with the velocities of its solution.
struct SolvedMotion {
    double energy = 0, mass = 0;
};

inline SolvedMotion solved_motion(const IslandWork& work)
{
    SolvedMotion sum;
    for (std::size_t i = 0; i < work.system.bodies.size(); ++i) {
        const SolverBody& solved = work.system.bodies[i];
        if (moves_by_itself(solved)) continue;
        const Body& body = *work.island.bodies[i];
        sum.energy += kinetic_of(body, solved.v, transposed_times(body.rotation(), solved.w));
        sum.mass += double(body.mass.mass);
    }
    return sum;
}

inline bool is_thrown(const SolvedMotion& before, const SolvedMotion& after)
{
    return after.energy > 2 * before.energy + before.mass * double(kCorrecting * kCorrecting);
}

}  // namespace epode
