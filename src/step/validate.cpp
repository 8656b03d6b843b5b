// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "step/validate.h"

#include <cmath>
#include <utility>

#include "dynamics/active.h"
#include "dynamics/coupling.h"
#include "step/common/link.h"
#include "step/step.h"

namespace epode {
namespace {

bool finite(const Real* numbers, int count)
{
    for (int i = 0; i < count; ++i)
        if (!within(numbers[i], std::numeric_limits<Real>::max())) return false;
    return true;
}

template <typename T, int kLines>
const char* fault_of_roster(const Roster<T, kLines>& roster)
{
    int count = 0, active = 0, before = roster.places();
    for (const T& one : roster) {
        if (one.place < 0 || one.place >= before)
            return "roster: a member stands in another place than it knows";
        before = one.place;
        ++count, active += roster.is_active(one);
    }
    if (count != roster.count()) return "roster: the count of members is wrong";
    return active != roster.active_count() ? "roster: the count of active members is wrong" : nullptr;
}

const char* fault_of_numbers(const Body& body)
{
    if (!finite(body.pos, 3) || !finite(body.q, 4) || !finite(body.R, 12))
        return "body: its pose is not finite";
    if (!finite(body.lvel, 3) || !finite(body.avel, 3)) return "body: its velocity is not finite";
    const Quat q = body.orientation();
    const Real square = q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z;
    if (!(std::abs(square - 1) < Real(1e-3))) return "body: its quaternion is not of unit length";
    if (body.kinematic() ? body.inv_mass != 0 : !(body.inv_mass > 0))
        return "body: its inverse mass is wrong";
    return nullptr;
}

// The body's list of joints, in both directions, and its first joint that is no contact.
const char* fault_of_joints(const Body& body)
{
    const JointNode* before = nullptr;
    const JointNode* lasting = nullptr;
    for (const JointNode* node = body.joints; node; before = node, node = node->next) {
        const Joint& joint = *node->joint;
        if (node != &joint.node[0] && node != &joint.node[1]) return "body: a joint does not own its node";
        if (node->body != &body) return "body: a joint in its list is attached elsewhere";
        if (before && node->prev != before) return "body: its list of joints does not lead back";
        if (joint.world != body.world && joint.world) return "body: a joint of another world";
        if (!lasting && !is_contact(joint)) lasting = node;
        if (joint.world && is_active(body) && !body.world->joints.is_active(joint))
            return "body: it is active and its joint is not";
    }
    return lasting != body.lasting ? "body: the first joint that is no contact is another" : nullptr;
}

const char* fault_of_geoms(const Body& body)
{
    const Geom* before = nullptr;
    const char* found = nullptr;
    for_each_geom(body, [&](const Geom& geom) {
        if (geom.body.id != to_handle(&body)) found = "body: a geom in its list is on another";
        if (geom.body_prev != before) found = "body: its list of geoms does not lead back";
        if (!geom.offset && geom.position != body.pos) found = "geom: it does not share its body's pose";
        before = &geom;
    });
    return found;
}

const char* fault_of(const Body& body)
{
    if (const char* found = fault_of_numbers(body)) return found;
    if (const char* found = fault_of_joints(body)) return found;
    if (!body.disabled && !is_active(body)) return "body: it is awake and not active";
    return fault_of_geoms(body);
}

const char* fault_of(const Joint& joint)
{
    for (const JointNode& node : joint.node) {
        if (node.joint != &joint) return "joint: a node belongs to another";
        if (node.body && !node.body->joints) return "joint: its body does not know it";
    }
    return joint.body2() && !joint.body1() ? "joint: attached to a second body alone" : nullptr;
}

// If the geom does not wait for the next cleaning and stands alone, the broadphase must have its box.
const char* fault_of_member(const Space& space, const Geom& geom, int slot)
{
    if (geom.space != &space) return "space: a member is in another one";
    if (geom.slot != slot) return "space: a member stands in another slot than it knows";
    if (!finite(geom.own_position, 3)) return "geom: its position is not finite";
    if (geom.queued || geom.box_stale || !stands_alone(geom) || !space.broadphase.present(slot))
        return nullptr;
    const Aabb &own = geom.box, &known = space.broadphase.box(slot);
    const bool same = own.lo == known.lo && own.hi == known.hi;
    return same ? nullptr : "space: a member that has not moved has another box than the broadphase";
}

const char* fault_of_pairs(const Broadphase& boxes)
{
    const std::span<const SlotPair> pairs = boxes.pairs();
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        if (pairs[i].newer >= boxes.slots() || pairs[i].older < 0 || pairs[i].newer <= pairs[i].older)
            return "broadphase: a pair of slots that are none";
        if (i > 0 && !in_order(pairs[i - 1], pairs[i])) return "broadphase: pairs are not in order";
    }
    for (int slot = 0; slot < boxes.slots(); ++slot)
        if (boxes.present(slot) && !contains(boxes.way(slot), boxes.box(slot)))
            return "broadphase: a box lies outside of what is expected of it";
    return nullptr;
}

}  // namespace

const char* fault_of(const Space& space)
{
    int count = 0, helped = 0;
    for (int slot = 0; slot < space.geoms.size(); ++slot) {
        const Geom* geom = space.geoms.data()[slot];
        if (!geom) continue;
        ++count, helped += !stands_alone(*geom);
        if (const char* found = fault_of_member(space, *geom, slot)) return found;
        if (const char* found = is_space(*geom) ? fault_of(static_cast<const Space&>(*geom)) : nullptr)
            return found;
    }
    if (count != space.count) return "space: the count of members is wrong";
    if (helped != space.helped) return "space: the count of members that need help is wrong";
    for (int slot : space.queue)
        if (slot < 0 || slot >= space.geoms.size()) return "space: a slot that is none waits for cleaning";
    return fault_of_pairs(space.broadphase);
}

const char* fault_of(const World& world)
{
    if (const char* found = fault_of_roster(world.bodies)) return found;
    if (const char* found = fault_of_roster(world.joints)) return found;
    for (const Body& body : world.bodies)
        if (const char* found = fault_of(body)) return found;
    for (const Joint& joint : world.joints)
        if (const char* found = fault_of(joint)) return found;
    if (!world.step_state) return nullptr;
    if (const char* found = world.step_state->contacts.fault()) return found;
    if (const char* found = world.step_state->world_contacts.fault()) return found;
    const Space* space = world.step_state->world_contacts.live_space();
    return space ? fault_of(*space) : nullptr;
}

namespace {

// Does holds(body) say so of all bodies that a joint of an island holds together?
template <typename Holds>
const char* fault_of_connection(const Joint& joint, const Holds& holds)
{
    if (!is_coupling(joint)) {
        const bool inside = holds(*joint.body1()) && (!joint.body2() || holds(*joint.body2()));
        return inside ? nullptr : "islands: a joint leads out of its island";
    }
    bool inside = true;
    for_each_body(coupling_of(joint),
                  [&](const Body& body) { inside = inside && (body.kinematic() || holds(body)); });
    return inside ? nullptr : "islands: a coupling leads out of its island";
}

}  // namespace

// Active bodies have their number in island_index.
const char* fault_of(const World& world, const Islands& islands, Arena& arena)
{
    const Arena::Scope scope(arena);
    const std::span<int> island_of = arena.take_zeroed<int>(world.bodies.active_count());
    if (arena.failed()) return nullptr;
    const auto claims = [&](const Body* body, int island) {
        const auto i = std::size_t(body->island_index);
        return i < island_of.size() && std::exchange(island_of[i], island) == 0;
    };
    int number = 0;
    const auto holds = [&](const Body& body) {
        const auto i = std::size_t(body.island_index);
        return i < island_of.size() && island_of[i] == number;
    };
    for (const Island& island : islands.all) {
        ++number;
        for (const Body* body : island.bodies)
            if (!claims(body, number)) return "islands: a body is in two of them, or not active";
        for (const Joint* joint : island.joints)
            if (const char* found = fault_of_connection(*joint, holds)) return found;
    }
    for (const Body* body : islands.asleep)
        if (!claims(body, ++number)) return "islands: a body falls asleep and is in an island";
    // Bodies that fall asleep in this step are in no island; they are still active until the step ends.
    bool complete = true;
    world.bodies.for_each_active([&](const Body& body) {
        const auto i = std::size_t(body.island_index);
        complete = complete && (i >= island_of.size() || island_of[i] != 0 || body.disabled);
    });
    if (!complete) return "islands: a body that is awake is in none of them";
    return nullptr;
}

}  // namespace epode
