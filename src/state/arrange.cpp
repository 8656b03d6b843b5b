// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Lists of the world never give memory back, and all objects of a topology were in them at one time: joining
// again needs no memory.
#include "state/arrange.h"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <new>

#include "base/objects/structure_edition.h"
#include "collide/describe.h"
#include "collide/space.h"
#include "collide/types/registry.h"
#include "dynamics/coupling.h"
#include "dynamics/sleep/sleeping_forces.h"
#include "step/common/link.h"

namespace epode {
namespace {

template <typename Records, typename Key>
bool same(const Records& a, const Records& b, Key&& key)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [&](const auto& x, const auto& y) { return key(x) == key(y); });
}

bool same_offset(const Geom& geom, const Topology::GeomRecord& r)
{
    if ((geom.offset != nullptr) != r.has_offset) return false;
    return !geom.offset || std::memcmp(geom.offset, &r.offset, sizeof r.offset) == 0;
}

bool has_geoms(const Body& body, std::span<const Topology::GeomRecord> geoms)
{
    std::size_t i = 0;
    bool all = true;
    for_each_geom(body, [&](Geom& geom) {
        all = all && i < geoms.size() && geoms[i].geom.object == &geom && same_offset(geom, geoms[i]);
        ++i;
    });
    return all && i == geoms.size();
}

bool has_members(const Space& space, std::span<const Topology::GeomRecord> members)
{
    std::size_t i = 0;
    for (const Geom* geom : space.geoms)
        if (geom && (i >= members.size() || members[i++].geom.object != geom)) return false;
    return i == members.size();
}

bool is_newcomer(const Topology::GeomRecord& r, const Topology& to)
{
    return r.geom.serial > to.geoms_made && !is_space(*r.geom.object);
}

// From a body that it was not on, to the place where it was.
void free_geom(const Topology::GeomRecord& r)
{
    Geom& geom = *r.geom.object;
    unlink_body(geom);
    std::memcpy(geom.own_position, r.offset.position, sizeof r.offset.position);
    std::memcpy(geom.own_rotation, r.offset.rotation, sizeof r.offset.rotation);
    mark_moved(geom);
}

// A coupling names joints by address, in a list of the world that is not recorded.
bool has_coupling(const Topology& topology)
{
    return std::any_of(topology.joints.begin(), topology.joints.end(),
                       [](const Topology::JointRecord& r) { return is_coupling(*r.joint.object); });
}

// The same bodies and lasting joints, and these attached as they were.
bool same_joints(const Topology& from, const Topology& to)
{
    const Topology::JointRecord* next = to.joints.begin();
    for (const Topology::JointRecord& r : from.joints) {
        if (is_contact(*r.joint.object)) continue;
        if (next == to.joints.end() || next->joint.object != r.joint.object) return false;
        if (next++->attachments != r.attachments) return false;
    }
    return next == to.joints.end() &&
           same(from.bodies, to.bodies, [](const Topology::BodyRecord& r) { return r.body.object; });
}

// Still to be removed: it is alive and recorded as part of the present.
bool is_present(const Geom& geom) { return geom.tag == HandleOf<Geom>::kTag; }

}  // namespace

Arrangement::~Arrangement()
{
    for (GeomOffset* offset : offsets_) release(offset, sizeof *offset);
}

const char* Arrangement::prepare(const Topology& from, const Topology& to, char* text, std::size_t size)
{
    if (const char* obstacle = find_obstacle(to, text, size)) return obstacle;
    if ((has_coupling(from) || has_coupling(to)) && !same_joints(from, to))
        return "bodies or joints were created, destroyed or attached since, in a world with couplings";
    for (const Topology::GeomRecord& r : from.geoms.span().first(std::size_t(from.own_geoms)))
        if (is_newcomer(r, to) && is_held(*r.geom.object)) return "Invalid operation during a collision";
    return reserve(from, to) ? nullptr : kOutOfMemory;
}

const char* Arrangement::find_obstacle(const Topology& to, char* text, std::size_t size) const
{
    const auto say = [&](const char* format, int i, int count) {
        std::snprintf(text, size, format, i, count);
        return static_cast<const char*>(text);
    };
    const auto can_come = [&](const auto& named) {
        return named.lives() || (named.is_parked() && parking_.has(named.object));
    };
    if (to.fluids != world_.fluids.size()) return "the world has more or fewer fluids than the state";
    for (int i = 0; i < to.bodies.size(); ++i) {
        if (!can_come(to.bodies[i].body))
            return say("body %d (of %d, in order of creation) has been destroyed", i, to.bodies.size());
        if (to.bodies[i].wheels != wheels_of(*to.bodies[i].body.object))
            return say(
                "body %d (of %d, in order of creation) has become a vehicle since, is none any more, or has "
                "more or fewer wheels",
                i, to.bodies.size());
    }
    for (int i = 0; i < to.joints.size(); ++i) {
        if (!can_come(to.joints[i].joint))
            return say("joint %d (of %d, in order of creation) has been destroyed", i, to.joints.size());
        if (to.joints[i].joint.object->driven != to.joints[i].driven)
            return say("joint %d (of %d, in order of creation) had no drives or limits yet", i,
                       to.joints.size());
    }
    for (const Topology::GeomRecord& r : to.geoms) {
        if (!can_come(r.geom))
            return say(
                "a geom of class %d has been destroyed that cannot be kept: a space, a transform, a geom "
                "of a class of the program, or a member of a destroyed space",
                r.number, 0);
        if (in_locked_space(*r.geom.object)) return EPODE_LOCKED_TEXT;
        if (shape_hash(*r.geom.object) != r.shape)
            return say("a geom of class %d has another shape now", r.number, 0);
    }
    for (const Topology::SpaceRecord& r : to.spaces)
        if (!r.space.lives()) return "a space with geoms of the world has been destroyed";
    return nullptr;
}

bool Arrangement::reserve(const Topology& from, const Topology& to)
{
    int wanted = 0;
    for (const Topology* t : {&from, &to})
        for (const Topology::BodyRecord& r : t->bodies)
            for (const Topology::GeomRecord& g : t->of(r.geoms)) wanted += g.has_offset;
    if (!parking_.reserve_groups() || !offsets_.reserve(wanted) ||
        !parking_.reserve(from.bodies.size() + from.joints.size() + from.geoms.size() + to.bodies.size() +
                          to.joints.size() + to.geoms.size()))
        return false;
    while (offsets_.size() < wanted) {
        void* memory = allocate(sizeof(GeomOffset));
        if (!memory) return false;
        (void)offsets_.push(new (memory) GeomOffset);
    }
    return true;
}

void Arrangement::apply(const Topology& from, const Topology& to, std::uint64_t last)
{
    arrange_bodies(from, to);
    arrange_joints(from, to, last);
    arrange_links(from, to);
    arrange_geoms(from, to, last);
    for (const Topology::BodyRecord& r : from.bodies)
        if (r.body.object->place < 0) parking_.put(*r.body.object, last);
    note_structure_changed();
}

void Arrangement::arrange_bodies(const Topology& from, const Topology& to)
{
    const auto object = [](const Topology::BodyRecord& r) { return r.body.object; };
    if (!same(from.bodies, to.bodies, object)) {
        for (int i = from.bodies.size(); i-- > 0;) {
            forget_forces(*from.bodies[i].body.object);
            world_.bodies.leave(*from.bodies[i].body.object);
        }
        for (const Topology::BodyRecord& r : to.bodies) {
            parking_.take(*r.body.object);
            (void)world_.bodies.join(*r.body.object);
        }
    }
    for (const Topology::BodyRecord& r : to.bodies)
        if (Body& body = *r.body.object; body.mass_hash != r.mass_hash) set_mass(body, r.mass);
}

void Arrangement::arrange_joints(const Topology& from, const Topology& to, std::uint64_t last)
{
    const auto object = [](const Topology::JointRecord& r) { return r.joint.object; };
    for (const Topology::JointRecord& r : to.joints) {
        Joint& joint = *r.joint.object;
        if (is_contact(joint) || static_cast<LastingJoint&>(joint).attachments == r.attachments) continue;
        static_cast<LastingJoint&>(joint).attachments = r.attachments;
        const auto own = own_part(joint);
        std::copy_n(to.own_bytes.data() + r.first_byte, own.size(), own.data());
    }
    if (same(from.joints, to.joints, object)) return;
    for (int i = from.joints.size(); i-- > 0;) world_.joints.leave(*from.joints[i].joint.object);
    for (const Topology::JointRecord& r : to.joints) {
        Joint& joint = *r.joint.object;
        parking_.take(joint);
        joint.world = &world_;
        (void)world_.joints.join(joint);
    }
    for (const Topology::JointRecord& r : from.joints) {
        Joint& joint = *r.joint.object;
        if (joint.place >= 0) continue;
        joint.world = nullptr;
        parking_.put(joint, nullptr, last);
    }
}

void Arrangement::arrange_links(const Topology& from, const Topology& to)
{
    for (const Topology::BodyRecord& r : from.bodies)
        r.body.object->joints = r.body.object->lasting = nullptr;
    for (const Topology::BodyRecord& r : to.bodies) r.body.object->joints = r.body.object->lasting = nullptr;
    for (const Topology::JointRecord& r : from.joints)
        for (JointNode& node : r.joint.object->node) node.body = nullptr, node.next = node.prev = nullptr;
    world_.driven_joints = 0;
    for (const Topology::JointRecord& r : to.joints) {
        Joint& joint = *r.joint.object;
        joint.reverse = r.reverse;
        for (int i = 0; i < 2; ++i) joint.node[i].body = r.body[i], joint.node[i].next = nullptr;
        world_.driven_joints += joint.driven;
    }
    for (const Topology::BodyRecord& r : to.bodies) {
        Body& body = *r.body.object;
        const auto nodes = to.links_of(r);
        for (std::size_t i = nodes.size(); i-- > 0;) {
            nodes[i]->next = body.joints;
            if (body.joints) body.joints->prev = nodes[i];
            body.joints = nodes[i];
            if (!is_contact(*nodes[i]->joint)) body.lasting = nodes[i];
        }
    }
    ++world_.connections_version;
}

void Arrangement::arrange_geoms(const Topology& from, const Topology& to, std::uint64_t last)
{
    for (const Topology::GeomRecord& r : to.geoms)
        if (!r.on_body && r.geom.object->body.id) free_geom(r);
    for (const Topology::BodyRecord& r : from.bodies)
        if (r.body.object->place < 0) release_geoms(*r.body.object);
    for (const Topology::BodyRecord& r : to.bodies)
        if (!has_geoms(*r.body.object, to.of(r.geoms))) release_geoms(*r.body.object);
    for (const Topology::GeomRecord& r : from.geoms.span().first(std::size_t(from.own_geoms))) {
        Geom& geom = *r.geom.object;
        if (!is_newcomer(r, to) || !is_present(geom)) continue;
        if (geom.space) remove_geom(*geom.space, geom);
        unlink_body(geom);
        parking_.put(geom, last);
    }
    for (const Topology::GeomRecord& r : to.geoms) parking_.take(*r.geom.object);
    for (const Topology::SpaceRecord& r : to.spaces) arrange_space(to, r);
    for (const Topology::BodyRecord& r : to.bodies)
        if (!has_geoms(*r.body.object, to.of(r.geoms))) link_geoms(*r.body.object, to.of(r.geoms));
}

void Arrangement::arrange_space(const Topology& to, const Topology::SpaceRecord& r)
{
    Space& space = static_cast<Space&>(*r.space.object);
    const auto members = to.of(r.members);
    if (has_members(space, members)) return;
    for (int slot = space.geoms.size(); slot-- > 0;)
        if (Geom* geom = slot < space.geoms.size() ? space.geoms[slot] : nullptr) remove_geom(space, *geom);
    for (const Topology::GeomRecord& m : members) {
        Geom& geom = *m.geom.object;
        if (geom.space) remove_geom(*geom.space, geom);
        (void)add_geom(space, geom);
    }
}

// The newest comes last, which is the first of the record.
void Arrangement::link_geoms(Body& body, std::span<const Topology::GeomRecord> geoms)
{
    release_geoms(body);
    for (std::size_t i = geoms.size(); i-- > 0;) {
        Geom& geom = *geoms[i].geom.object;
        attach_geom(geom, &body);
        if (!geoms[i].has_offset) continue;
        geom.offset = offsets_.back();
        offsets_.pop();
        *geom.offset = geoms[i].offset;
        geom.position = geom.own_position, geom.rotation = geom.own_rotation;
        mark_moved(geom);
    }
}

}  // namespace epode
