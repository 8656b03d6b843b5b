// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What one kind of cause is: a function that looks at a step, and one sentence. A cause sees the bodies at
// the beginning of the step and of the one before, what touches, the step's report and energy ledger, and the world as the step
// has left it. It changes nothing.
#pragma once

#include "base/array.h"
#include "base/refusals.h"
#include "diagnose/findings.h"
#include "dynamics/world.h"

namespace epode {

// A body at the beginning of a step.
struct BodyBefore {
    dBodyID id = nullptr;  // null: it does not exist or rests
    Vec3 x, v, w;
    Vec3 force, torque;  // of the program
};

// A point of contact; its place is that of the step's beginning.
struct Touch {
    Body *a, *b;            // b null: what does not move
    Vec3 position, normal;  // into a
    Real depth;
};

// What a joint was open by after the last step, and in how many steps that stayed.
struct JointError {
    dJointID id = nullptr;
    Real error = 0;
    int steps = 0;    // in succession that have left it open
    int at_rest = 0;  // the last of these that were solved and have not changed it
};

// Working memory of the search for loops of joints: one node for each place of a body, behind that of what
// does not move.
struct GraphNode {
    int parent;
    bool loop;
};

// What a body hangs on: its heaviest neighbour, and whether it has another one.
struct Neighbours {
    const Body *heaviest = nullptr, *first = nullptr;
    bool any = false, two = false;
};

struct StepFacts {
    World& world;
    Real h;
    std::span<const BodyBefore> before, last;  // by Body::place; `last`: of the step before
    std::span<const BodyBefore> after_last;    // as that step left them
    std::span<const Touch> touches;
    std::span<JointError> joint_errors;  // by Joint::place
    std::span<GraphNode> graph;
    std::span<Neighbours> neighbours;  // by Body::place
    std::span<Real> swings;            // likewise, working memory
    std::span<const dIslandStepReport> islands;
    std::span<const Refusal> refusals;  // since the step before
    const dWorldStepReport& report;
    const dEnergyLedger& ledger;
    Findings& findings;

    // Null: it had none.
    static const BodyBefore* of(std::span<const BodyBefore> list, const Body& body)
    {
        const auto i = std::size_t(body.place);
        return body.place >= 0 && i < list.size() && list[i].id == to_handle(&body) ? &list[i] : nullptr;
    }
    // f(body, at its beginning) for all bodies that took part and can be moved.
    template <typename F>
    void for_each_body(F&& f) const
    {
        for (Body& body : world.bodies)
            if (const BodyBefore* b = of(before, body); b && !body.kinematic()) f(body, *b);
    }
};

// Half of the thinnest geom of the body (infinite: it has none that is a solid), and how far they reach from
// its centre (0: likewise, or without end).
struct Extent {
    Real half_thickness = kInf, reach = 0;
};
Extent extent_of(const Body& body);

// Is the joint in a component of bodies and joints that has a loop? For causes after that of contradiction.
bool closes_loop(const StepFacts& facts, const Joint& joint);

// Speed with which the two sides of a contact approach each other at the beginning of the step.
Real approach_of(const StepFacts& facts, const Touch& touch);

#define CAUSE(name)                           \
    void find_##name(const StepFacts& facts); \
    extern const char* const k_text_of_##name;
#include "diagnose/causes.inc"
#undef CAUSE

}  // namespace epode
