// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Islands: bodies connected by acting joints, which must be solved together and nothing else. The static
// world does not connect; kinematic bodies do, as in ODE. Sleeping ones that they reach belong to them.
#pragma once

#include <algorithm>
#include <span>

#include "base/arena.h"
#include "dynamics/joint.h"
#include "dynamics/world.h"
#include "rows/contact_manifold.h"

namespace epode {

// A manifold of contact as what holds two bodies together; body[1] is null for the static world.
struct ManifoldEdge {
    Body* body[2];
    ManifoldEdge* next[2];  // in the lists of the bodies
    ContactManifold* manifold;
    int place[2];  // of the bodies among the active ones; -1: the static world
};

struct Island {
    std::span<Body*> bodies;
    std::span<Joint*> joints;
    std::span<ManifoldEdge*> manifolds;
    int plain_contacts = 0;  // of the joints
    bool feedback = false;   // is asked of one of these contacts
    bool impulses = false;   // are remembered by a joint
    Real kept_depth = 0;     // that contact joints may keep while it settles, m; 0: it does not

    bool settles() const { return kept_depth > 0; }
};

inline bool has_lasting_joints(const Island& island)
{
    return std::any_of(island.joints.begin(), island.joints.end(),
                       [](const Joint* joint) { return !is_contact(*joint); });
}

// Of a step of size h.
struct Islands {
    std::span<Island> all;    // but those that now fall asleep
    std::span<Body*> asleep;  // active bodies of none
};

// `manifolds`: those that touch in this step. If world.reached is not empty afterwards, active bodies hold to
// others, which have to become active; then it has to be done again. False: out of memory.
bool find_islands(World& world, Real h, std::span<ManifoldEdge> manifolds, Arena& arena, Islands& found);

}  // namespace epode
