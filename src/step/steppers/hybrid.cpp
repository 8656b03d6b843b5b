// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The rules of the model, in their order:
//   couplings                     exact: sweeps leave a mimic joint behind
//   nothing but free motion       substeps: a flying body keeps its solver when it lands
//   contacts only                 substeps; exact if cheap, for unequal masses and stacks that would topple
//   loads that swing fast         exact in joint coordinates, where nothing touches them; else substeps with exact joints
//   joints only                   exact: one linear system, no iteration
//   figures                       exact if cheap, else substeps: small trees of joints between bodies of like
//                                 masses that hang on nothing; sweeps hold them, or are seen not to (island/strain.h)
//   other joints and contacts     exact if cheap, else substeps with exact joints
// Quick is used on request only: substeps of equal cost are more accurate.
#include "step/steppers/hybrid.h"

#include <algorithm>
#include <cmath>

#include "dynamics/coupling.h"
#include "step/island/strain.h"
#include "step/steppers/exact_tree.h"
#include "step/steppers/hybrid_budget.h"

namespace epode {
namespace {

constexpr double kBudget = 200;         // microseconds: limit of an exact step
constexpr double kLinearBudget = 2000;  // the same without contacts, and for stacks without loops
constexpr double kStay = 2;             // times the budget for islands that were exact
constexpr double kUnequal = 20;         // ratio of masses from which substeps converge badly
constexpr int kFigure = 20;             // joints of a tree that sweeps hold together
constexpr double kLoaded = 100;         // ratio of masses from which they do not
constexpr double kSmall = 1e-3;         // largest fall in a substep over the radius of gyration
constexpr double kTall = 0.4;           // the same times (height / radius)^2, of tall stacks
constexpr double kTreeWork = 5;         // microseconds, the limit of what does not turn out as a tree
constexpr std::uint8_t kStrainedSteps = 50;
constexpr std::uint8_t kRefusedSteps = 30;
constexpr int kGuess = 8, kGuessJoints = 2;  // factorisations, where bodies remember no work
// Microseconds in four substeps.
constexpr double kBodyWork = 0.3, kPointWork = 0.3, kJointWork = 0.9, kExactJointWork = 1.7;
constexpr double kLeastPart = 20;  // microseconds, of a solution that iterates
constexpr double kMargin = 1.5;    // of what an exact solution may take, over what the last one took
constexpr double kBeginning = 2;   // factorisations of a step in which joints begin
constexpr int kForgetting = 16;    // share of the work that is forgotten in a step without an exact solution

struct Structure {
    int bodies = 0;  // that can move
    int joints = 0, contacts = 0;
    int pairs = 0;  // of bodies that can move, connected
    int links = 0;  // of these, by joints
    double lightest = 0, heaviest = 0, mass = 0;
    double joined = 1;          // the largest ratio of two bodies on a joint
    double arm = 0;             // the least m r, with r the radius of gyration
    double radius = 0;          // the least radius of gyration
    double deep = 0, high = 0;  // extremes of g . x of the centres
    bool coupled = false;       // there are couplings
    bool hung = false;          // a joint connects a body with something that cannot move

    double rows() const { return 5.0 * joints + 3.0 * contacts; }
    double loops() const { return std::max(0, pairs - bodies + 1); }
    double ratio() const { return bodies > 0 ? heaviest / lightest : 1; }
};

bool can_move(const Body* body) { return body && !body->kinematic(); }

double ratio_of(const Body& a, const Body& b)
{
    const double ratio = double(a.mass.mass / b.mass.mass);
    return std::max(ratio, 1 / ratio);
}

void add_bodies(const World& world, const Island& island, Structure& s)
{
    for (const Body* body : island.bodies) {
        if (body->kinematic()) continue;
        const double depth = double(dot(world.gravity, body->position()));
        s.deep = s.bodies ? std::max(s.deep, depth) : depth;
        s.high = s.bodies ? std::min(s.high, depth) : depth;
        const double mass = double(body->mass.mass);
        s.lightest = s.bodies ? std::min(s.lightest, mass) : mass;
        s.heaviest = std::max(s.heaviest, mass);
        const double arm =
            std::sqrt(mass * double(body->inertia.xx + body->inertia.yy + body->inertia.zz) / 3);
        s.arm = s.bodies ? std::min(s.arm, arm) : arm;
        s.radius = s.bodies ? std::min(s.radius, arm / mass) : arm / mass;
        s.mass += mass;
        ++s.bodies;
    }
}

Structure structure_of(const World& world, const Island& island)
{
    Structure s;
    add_bodies(world, island, s);
    const Body *last1 = nullptr, *last2 = nullptr;
    for (const Joint* joint : island.joints) {
        s.coupled = s.coupled || is_coupling(*joint);
        if (is_coupling(*joint)) continue;
        const Body *a = joint->body1(), *b = joint->body2();
        const bool contact = joint->type->number == dJointTypeContact;
        ++(contact ? s.contacts : s.joints);
        const bool both = can_move(a) && can_move(b);
        s.hung = s.hung || (!contact && !both);
        if (both && !contact) s.joined = std::max(s.joined, ratio_of(*a, *b));
        // Contacts of the same two bodies are usually consecutive, as are a ball joint and the motor that limits it.
        if (both && !(a == last1 && b == last2)) ++s.pairs, s.links += !contact;
        last1 = a, last2 = b;
    }
    for (const ManifoldEdge* edge : island.manifolds) {
        s.contacts += edge->manifold->count;
        s.pairs += can_move(edge->body[0]) && can_move(edge->body[1]);
    }
    return s;
}

struct History {
    int requested = 0;  // the most exact stepper that a body requests
    double work = 0;    // of an exact solution, microseconds; 0: unknown
    bool exact = false, refused = false;
};

History history_of(const Island& island)
{
    History h;
    for (const Body* body : island.bodies) {
        const int requested = body->hybrid.requested;
        if (requested && (!h.requested || requested < h.requested)) h.requested = requested;
        h.exact = h.exact || body->hybrid.was_exact;
        h.refused = h.refused || body->hybrid.refused > 0;
        h.work = std::max(h.work, double(body->hybrid.work));
    }
    return h;
}

double once(const Structure& s)
{
    const double loops = s.loops();
    return 0.15 * s.bodies + 0.06 * loops * std::sqrt(loops) + 0.1 * s.rows();
}

double exact_work(const Structure& s, const History& history)
{
    if (history.work > 0) return history.work;
    return once(s) * (s.contacts > 0 ? kGuess : kGuessJoints);
}

double substeps_work(const Structure& s, int substeps)
{
    return 0.25 * substeps * (kBodyWork * s.bodies + kPointWork * s.contacts + kJointWork * s.joints);
}

// Is the step too long for the forces of joints that carry a hanging load, whose directions change as it
// swings? Joints that carry a standing load do not swing; the exact solver is right for them.
bool swings_too_fast(const Structure& s, const World& world, Real h)
{
    return s.hung && s.mass * double(length(world.gravity) * h * h) > s.arm;
}

// Would the stack topple with one sweep per substep? By Froude's law times scale as the root of lengths, so
// small bodies topple as large ones do in longer steps; and errors travel one link per sweep, so the sweeps
// that a tower of n needs grow as n^2. Towers of cubes of 1 m fall from 16 on (0.57 for kTall), those of
// 0.5 m from 14 on (0.84).
bool topples(const Structure& s, const World& world, Real h)
{
    if (s.pairs == 0) return false;
    const double g = double(length(world.gravity)), hs = double(h) / world.hybrid_substeps;
    const double fall = g * hs * hs, height = g > 0 ? (s.deep - s.high) / g : 0;
    return fall > kSmall * s.radius || fall * height * height > kTall * s.radius * s.radius * s.radius;
}

// In joint coordinates joints stay closed however far a step turns them, and what swings or spins keeps its energy. In bodies it would tear:
// where the step does not find a tree there (steppers/exact_tree.h), the work that it may cost is used up at once.
bool may_swing_in_tree(const Structure& s, const History& history, const World& world)
{
    return s.contacts == 0 && s.bodies <= kFewTreeBodies && world.joint_coordinates && !world.acts_as_ode() &&
           !history.refused;
}

bool iterates_well(const Structure& s, const World& world, Real h)
{
    return s.contacts == 0 || (s.ratio() < kUnequal && !topples(s, world, h));
}

// Joints that nothing but each other and contacts load. (Where there are loops, there are no trees left to be counted.)
bool is_figures(const Structure& s)
{
    return s.joints > 0 && s.contacts > 0 && !s.hung && s.joined < kUnequal && s.ratio() < kLoaded &&
           s.links <= kFigure * (s.bodies - s.links);
}

bool wants_exact(const Structure& s, const History& history, const World& world, Real h)
{
    if (history.refused || (s.joints == 0 && iterates_well(s, world, h))) return false;
    const bool linear = s.contacts == 0 || (s.joints == 0 && s.loops() == 0);
    const double budget = (linear ? kLinearBudget : kBudget) * (history.exact ? kStay : 1);
    return exact_work(s, history) <= budget;
}

bool has_new_joints(const Island& island)
{
    return std::any_of(island.joints.begin(), island.joints.end(),
                       [](const Joint* joint) { return !is_contact(*joint) && !joint->begun; });
}

// Null: the number leaves the choice to the island.
const Stepper* chosen(int number)
{
    const Stepper* const stepper = stepper_numbered(number);
    return stepper && stepper->step ? stepper : nullptr;
}

// What it gets if it is not stepped exactly.
void choose_substeps(const Structure& s, const World& world, bool swings, HybridChoice& choice)
{
    choice.sweeps_do = !swings && is_figures(s);
    const bool exact_joints = swings || (s.joints > 0 && !choice.sweeps_do);
    choice.stepper = exact_joints ? &kSubstepsExactJoints : &kSubsteps;
    if (exact_joints) choice.network_work = 0.25 * world.hybrid_substeps * kExactJointWork * s.joints;
}

// Of an exact solution: its own of the last step, or what the structure suggests.
double largest_work(const Structure& s, const History& history, bool begins)
{
    if (begins) return std::max(kLeastPart, kBeginning * once(s));
    const double work = history.work > 0 ? kMargin * history.work : exact_work(s, history);
    return s.contacts > 0 ? std::max(kLeastPart, work) : work;
}

void remember_work(HybridState& state, const IslandMethod& method)
{
    const bool direct = !method.stepper->iterates;
    state.was_exact = direct && !method.gave_up;
    if (direct)
        state.work = std::uint16_t(std::clamp(method.work + 1, 1.0, 65535.0));
    else if (state.refused == 0)
        state.work = std::uint16_t(state.work - (state.work + kForgetting - 1) / kForgetting);
    if (method.gave_up)
        state.refused = kRefusedSteps;
    else if (state.refused > 0)
        --state.refused;
}

// After a step: stores what came of the method in the island's bodies and joints.
void remember_choice(const Island& island, const IslandMethod& method)
{
    remember_strain(island, method);
    for (Body* body : island.bodies) remember_work(body->hybrid, method);
    for (Joint* joint : island.joints) joint->begun = true;
}

}  // namespace

HybridChoice choose(const World& world, const Island& island, Real h)
{
    HybridChoice choice;
    const History history = history_of(island);
    if (const Stepper* requested = chosen(history.requested)) return {requested};
    if (const Stepper* wanted = chosen(world.hybrid_stepper)) return {wanted};
    const Structure structure = structure_of(world, island);
    choice.substeps_work = substeps_work(structure, world.hybrid_substeps);
    if (structure.coupled) return choice.stepper = &kExact, choice;
    const bool swings = swings_too_fast(structure, world, h);
    choose_substeps(structure, world, swings, choice);
    choice.begins = structure.joints > 0 && has_new_joints(island);
    choice.in_tree = swings && !choice.begins && may_swing_in_tree(structure, history, world);
    choice.wants_exact =
        choice.begins || (swings ? choice.in_tree : wants_exact(structure, history, world, h));
    if (!choice.wants_exact) return choice;
    choice.was_exact = history.exact && !choice.begins;
    choice.max_work = choice.in_tree ? kTreeWork : largest_work(structure, history, choice.begins);
    return choice;
}

const Stepper& stepper_for_strain(const Stepper& stepper, const Island& island)
{
    if (!stepper.for_strained || !has_lasting_joints(island)) return stepper;
    if (island.settles()) return *stepper.for_strained;
    const auto strained = [](const Body* body) { return body->hybrid.strained > 0; };
    return std::any_of(island.bodies.begin(), island.bodies.end(), strained) ? *stepper.for_strained
                                                                             : stepper;
}

void remember_strain(const Island& island, const IslandMethod& method)
{
    for (Body* body : island.bodies) {
        HybridState& state = body->hybrid;
        if (method.strained)
            state.strained = kStrainedSteps;
        else if (state.strained > 0)
            --state.strained;
        note_gap(state, method.gap);
    }
}

const Stepper kHybrid{.name = "hybrid", .choose = choose_hybrid_methods, .remember = remember_choice};

}  // namespace epode
