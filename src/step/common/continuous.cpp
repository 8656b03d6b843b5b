// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See continuous.h. With l half the thickness of what moves, L that of what it meets and g h^2 what a body
// falls in a step from rest, allowed depth is max(l/4, min(2 g h^2, (l + L)/4)): a thin plate may leave the
// floor and come back as contacts let it.
#include "step/common/continuous.h"

#include <algorithm>

#include "collide/collide.h"
#include "collide/types/registry.h"
#include "ode/shapes.h"
#include "query/candidates.h"
#include "query/triangle_set.h"
#include "step/common/link.h"

namespace epode {
namespace {

constexpr int kRounds = 4;
constexpr Real kShare = Real(0.25);  // of the half thickness, that it may go deep
constexpr Real kSwing = 2;           // times as far as the carrier's points, what it carries rigidly may move
constexpr Real kHair = Real(0.02);   // of that, how deep it is when it stops

// Every geom of a body, newest first, until f answers false. It stays while functions of its class run.
template <typename F>
bool each_geom(const Body& body, F&& f)
{
    for (Geom* g = from_handle<Geom>(body.first_geom); g; g = g->body_next) {
        const GeomHold hold(*g, geom_calls_program(*g));
        if (!f(*g)) return false;
    }
    return true;
}

Real arm_of(const Aabb& box, Vec3 centre) { return length(max(abs(box.lo - centre), abs(box.hi - centre))); }

bool is_moving_shape(const QueryShape& shape)
{
    const QueryKind sort = kind_of(shape);
    return (sort == QueryKind::kSolid && shape.number() != dRayClass) || sort == QueryKind::kMesh;
}

// What joints and world-managed contacts say of two bodies; the second is null for what does not move.
struct Bond {
    bool contact = false, other = false;
};
Bond bond_between(const Body& a, const Body* b)
{
    Bond bond;
    for (const JointNode* n = find_connection(a.joints, b); n; n = find_connection(n->next, b))
        (is_contact(*n->joint) ? bond.contact : bond.other) = true;
    for (const ManifoldEdge* e = a.manifolds; e;) {
        const int side = e->body[0] == &a ? 0 : 1;
        bond.contact = bond.contact || e->body[1 - side] == b;
        e = e->next[side];
    }
    return bond;
}

}  // namespace

bool Continuous::stop_at_impacts()
{
    if (!any_continuous() || undo_.bodies().empty()) return true;
    if (!look_at_bodies()) return !arena_.failed();
    if (!choose_active()) return true;
    join_groups();
    if (!list_items()) return false;
    if (!meet_while_held()) return false;
    place_bodies();
    return true;
}

bool Continuous::meet_while_held()
{
    const auto let_go = [](void*, const void* items, std::size_t count) {
        for (const Item& item : std::span(static_cast<const Item*>(items), count))
            item.geom->users.fetch_sub(1, std::memory_order_relaxed);
    };
    const CallGuard guard(let_go, nullptr, items_.data(), items_.size());
    for (const Item& item : items_) item.geom->users.fetch_add(1, std::memory_order_relaxed);
    return meet_all();
}

bool Continuous::meet_all()
{
    for (const Item& item : items_)
        if (item.geom->continuous == dContinuousOn && !meet_others(item)) return false;
    return meet_each_other();
}

// False: there is nothing to do, or no memory.
bool Continuous::look_at_bodies()
{
    const auto bodies = undo_.bodies();
    const auto wants = [](const Geom& g) { return g.continuous != dContinuousOn; };
    const bool any = std::any_of(bodies.begin(), bodies.end(),
                                 [&](const Body* b) { return !b->kinematic() && !each_geom(*b, wants); });
    if (!any) return false;
    states_ = arena_.take<State>(int(bodies.size()));
    if (arena_.failed()) return false;
    marked_ = true;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        bodies[i]->island_index = int(i);
        body_stepped(*bodies[i]);
        states_[i] = state_of(i);
    }
    return true;
}

Continuous::State Continuous::state_of(std::size_t i) const
{
    const Body& body = *undo_.bodies()[i];
    State s{};
    s.group = int(i), s.until = 1, s.carrier = -1;
    const Pose before = undo_.pose_before(i);
    if (!usable(body.pos, 3)) return s;
    s.motion = motion_between(before.p, undo_.orientation_before(i), body.position(), body.orientation());
    each_geom(body, [&](Geom& g) {
        s.max_distance = std::max(s.max_distance, s.motion.max_travel(arm_of(box_of(g), body.position())));
        s.flagged = s.flagged || (g.continuous == dContinuousOn && !body.kinematic());
        return true;
    });
    return s;
}

// How far the body and others may move towards each other without being swept.
Real Continuous::gate(const Body& body) const
{
    Real least = kInf;
    each_geom(body, [&](Geom& g) {
        const QueryShape shape = g.continuous == dContinuousOn ? query_shape_of(g) : QueryShape{};
        if (is_moving_shape(shape)) least = std::min(least, half_thickness(shape));
        return true;
    });
    return kShare / 4 * least;
}

bool Continuous::choose_active()
{
    Real others = 0;
    for (const State& s : states_)
        if (!s.flagged) others = std::max(others, s.max_distance);
    bool any = false;
    for (std::size_t i = 0; i < states_.size(); ++i) {
        State& s = states_[i];
        s.active = s.flagged && s.max_distance + others > gate(*undo_.bodies()[i]);
        any = any || s.active;
        if (!s.active) others_max_distance_ = std::max(others_max_distance_, s.max_distance);
    }
    return any;
}

int Continuous::find(int i)
{
    while (states_[std::size_t(i)].group != i) {
        State& s = states_[std::size_t(i)];
        s.group = states_[std::size_t(s.group)].group;
        i = s.group;
    }
    return i;
}

void Continuous::join_groups()
{
    for (std::size_t i = 0; i < states_.size(); ++i) {
        const Body& body = *undo_.bodies()[i];
        if (body.kinematic()) continue;
        for (const JointNode* n = body.joints; n; n = n->next) {
            const Joint& joint = *n->joint;
            const Body* partner = joint.node[n == &joint.node[0] ? 1 : 0].body;
            if (!partner || partner->kinematic() || is_contact(joint) || !acting(joint)) continue;
            const int a = find(int(i)), b = find(partner->island_index);
            states_[std::size_t(std::max(a, b))].group = std::min(a, b);
        }
    }
    for (std::size_t i = 0; i < states_.size(); ++i) states_[i].group = find(int(i));
}

// The geoms of active bodies.
bool Continuous::list_items()
{
    int count = 0;
    for (int pass = 0; pass < 2; ++pass) {
        if (pass == 1) items_ = arena_.take<Item>(count);
        if (arena_.failed()) return false;
        count = 0;
        for (std::size_t i = 0; i < states_.size(); ++i) {
            if (!states_[i].active) continue;
            each_geom(*undo_.bodies()[i], [&](Geom& g) {
                Space* root = outermost_space(g);
                if (!g.enabled || !root || !is_moving_shape(query_shape_of(g))) return true;
                if (pass == 1) items_[std::size_t(count)] = {&g, root, int(i), way_of(g, &states_[i])};
                ++count;
                return true;
            });
        }
    }
    return true;
}

// A box about all places where the geom has been in the step.
Aabb Continuous::way_of(Geom& geom, const State* state) const
{
    const Aabb& end = box_of(geom);
    if (!state || !state->motion.moves() || !bounded(end)) return end;
    const Motion& m = state->motion;
    const Aabb both = {min(end.lo, end.lo - m.shift), max(end.hi, end.hi - m.shift)};
    const Real angle = length(m.turn);
    return angle > 0 ? grown(both, angle * arm_of(end, m.centre + m.shift)) : both;
}

// Among the bodies of this step; -1: its geom does not move.
int Continuous::index_of(const Geom& geom) const
{
    const Body* body = body_of(geom);
    const bool known = body && body->world == &world_ && body->island_index >= 0 &&
                       std::size_t(body->island_index) < states_.size() &&
                       undo_.bodies()[std::size_t(body->island_index)] == body;
    return known ? body->island_index : -1;
}

Mover Continuous::mover(Geom& geom, int body) const
{
    Mover m{query_shape_of(geom), {}};
    if (body < 0 || !m.shape.geom) return m;
    const auto i = std::size_t(body);
    if (!states_[i].motion.moves()) return m;
    m.motion = states_[i].motion;
    m.motion.until = states_[std::size_t(states_[i].group)].until;
    m.shape.pose = undo_.pose_before(i) * inverse_times(undo_.bodies()[i]->pose(), m.shape.pose);
    return m;
}

// Has what does not depend on their motion nothing against it?
bool Continuous::stops(Geom& a, Geom& b) const
{
    if (&a == &b || of_one_body(a, b) || a.sensor || b.sensor || a.character || b.character ||
        b.continuous == dContinuousIgnored)
        return false;
    return a.continuous != dContinuousIgnored && !overridden(a, b);
}

// False: joints keep the two from meeting.
bool Continuous::rule_for(const Mover& a, const Mover& b, const Body& body, const Body* other,
                          ImpactRule& rule) const
{
    const Bond bond = bond_between(body, other);
    if (bond.other && other) return false;
    const Real own = half_thickness(a.shape), fall = 2 * length(world_.gravity) * h_ * h_;
    const Real of_both = kShare * (own + half_thickness(b.shape));
    const Real rounding = 64 * kEpsilon * (length(a.motion.centre) + a.motion.max_travel(own) + own);
    rule.allowed = std::max(kShare * own, std::min(fall, of_both));
    rule.hair = std::max(kHair * rule.allowed, rounding);
    rule.held = bond.contact;
    return rule.hair < rule.allowed;
}

void Continuous::meet(const Item& a, Geom& other, int other_body)
{
    const Mover moving = mover(*a.geom, a.body), met = mover(other, other_body);
    if (!met.shape.geom || met.shape.number() == dRayClass || kind_of(met.shape) == QueryKind::kNone) return;
    ImpactRule rule;
    if (!rule_for(moving, met, *body_of(*a.geom), body_of(other), rule)) return;
    const auto group_of = [&](int body) { return states_[std::size_t(states_[std::size_t(body)].group)]; };
    const bool moves = other_body >= 0 && states_[std::size_t(other_body)].motion.moves();
    const bool stops_too = moves && states_[std::size_t(other_body)].active;
    // As long as one of those that can be stopped is on its way.
    Real until = group_of(a.body).until;
    if (stops_too) until = std::max(until, group_of(other_body).until);
    const auto [time, cut_short] = time_of_impact(moving, met, rule, until);
    if (cut_short) cut_short_.add(*a.geom, other, "continuous collision");
    if (!(time < until)) return;
    stop(a.body, time, moves && !stops_too ? other_body : -1);
    if (stops_too) stop(other_body, time, -1);
}

void Continuous::stop(int body, Real time, int carrier)
{
    State& group = states_[std::size_t(states_[std::size_t(body)].group)];
    if (time >= group.until) return;
    group.until = time;
    group.carrier = carrier, group.met = body;
}

// What is in the geom's outermost space and not active. False: out of memory.
bool Continuous::meet_others(const Item& item)
{
    Geom& geom = *item.geom;
    clean(*item.root);
    lists_.near.clear();
    if (!collect_near(*item.root, {geom.category, geom.collide}, grown(item.way, others_max_distance_),
                      lists_.near))
        return false;
    const bool called = may_call_program(lists_.near.span(), {});
    const CandidateLock lock(called ? item.root : nullptr, lists_.near);
    for (Geom* other : lists_.near) {
        const int body = index_of(*other);
        const State* state = body >= 0 ? &states_[std::size_t(body)] : nullptr;
        if ((state && state->active) || !stops(geom, *other)) continue;
        if (overlap(item.way, way_of(*other, state))) meet(item, *other, body);
    }
    return true;
}

bool Continuous::may_meet_on_way(const Item& a, const Item& b) const
{
    if (!overlap(a.way, b.way) || a.root != b.root || !stops(*a.geom, *b.geom)) return false;
    if (a.geom->continuous != dContinuousOn && b.geom->continuous != dContinuousOn) return false;
    if (states_[std::size_t(a.body)].group == states_[std::size_t(b.body)].group) return false;
    return may_meet(*a.geom, *b.geom);
}

// Active bodies among themselves. False: out of memory.
bool Continuous::meet_each_other()
{
    auto& pairs = lists_.pairs;
    pairs.clear();
    for (std::size_t i = 0; i < items_.size(); ++i)
        for (std::size_t k = i + 1; k < items_.size(); ++k)
            if (may_meet_on_way(items_[i], items_[k]) && !pairs.push({int(i), int(k)})) return false;
    for (int round = 0; round < kRounds; ++round) {
        bool changed = false;
        for (const auto& [i, k] : pairs) {
            const Item &a = items_[std::size_t(i)], &b = items_[std::size_t(k)];
            const State& group_a = states_[std::size_t(states_[std::size_t(a.body)].group)];
            const State& group_b = states_[std::size_t(states_[std::size_t(b.body)].group)];
            const Real before = group_a.until + group_b.until;
            const bool first = a.geom->continuous == dContinuousOn;
            first ? meet(a, *b.geom, b.body) : meet(b, *a.geom, a.body);
            changed = changed || group_a.until + group_b.until < before;
        }
        if (!changed) break;
    }
    return true;
}

bool Continuous::stopped(const Body& body) const
{
    if (!marked_ || body.kinematic()) return false;
    return states_[std::size_t(states_[std::size_t(body.island_index)].group)].until < 1;
}

Vec3 Continuous::stopped_place(std::size_t i) const
{
    const Motion& m = states_[i].motion;
    return m.centre + states_[std::size_t(states_[i].group)].until * m.shift;
}

Carriage Continuous::carriage_of(const State& group) const
{
    return {states_[std::size_t(group.carrier)].motion, group.until};
}

Real Continuous::longest_way_of_carrier(const State& group) const
{
    return (1 - group.until) * states_[std::size_t(group.carrier)].max_distance;
}

// Before bodies are placed: the boxes of their geoms are those of the step's end.
void Continuous::find_swung()
{
    for (std::size_t i = 0; i < states_.size(); ++i) {
        State& group = states_[std::size_t(states_[i].group)];
        const Body& body = *undo_.bodies()[i];
        if (!stopped(body) || group.carrier < 0 || group.swung) continue;
        const Carriage carriage = carriage_of(group);
        Real arm = 0;
        each_geom(body,
                  [&](Geom& g) { return arm = std::max(arm, arm_of(box_of(g), body.position())), true; });
        group.swung = carriage.max_way(stopped_place(i), arm) > kSwing * longest_way_of_carrier(group);
    }
}

// As the point of the carrier moves where the group met it.
Vec3 Continuous::way_without_turn(const State& group) const
{
    const Vec3 place = stopped_place(std::size_t(group.met));
    const Vec3 way = carriage_of(group).end_of(place) - place;
    const Real longest = longest_way_of_carrier(group), size = length(way);
    return size > longest ? longest / size * way : way;
}

void Continuous::place_bodies()
{
    find_swung();
    for (std::size_t i = 0; i < states_.size(); ++i) {
        Body& body = *undo_.bodies()[i];
        if (!stopped(body)) continue;
        const State& group = states_[std::size_t(states_[i].group)];
        Vec3 place = stopped_place(i);
        Quat q = turn_by(group.until * states_[i].motion.turn) * undo_.orientation_before(i);
        if (group.carrier >= 0 && group.swung) {
            place += way_without_turn(group);
        } else if (group.carrier >= 0) {
            const Carriage carriage = carriage_of(group);
            place = carriage.end_of(place), q = carriage.turn * q;
        }
        if (!normalize(q)) continue;
        store(body.pos, place);
        set_orientation(body, q);
    }
}

}  // namespace epode
