// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "state/topology.h"

#include <algorithm>
#include <cstring>

#include "base/objects/structure_edition.h"
#include "collide/describe.h"
#include "collide/space.h"
#include "step/common/link.h"
#include "step/step.h"

namespace epode {

bool Topology::record(const World& world, bool contacts)
{
    bodies.clear(), joints.clear(), links.clear(), own_bytes.clear(), geoms.clear(), spaces.clear();
    edition = structure_edition();
    geoms_made = newest_geom_serial();
    fluids = world.fluids.size();
    bool complete = bodies.reserve(world.bodies.count()) && joints.reserve(world.joints.count());
    for (Body& body : world.bodies) complete = complete && record_body(body, contacts);
    for (Joint& joint : world.joints)
        if (contacts || !is_contact(joint)) complete = complete && record_joint(joint);
    if (!complete) return false;
    std::reverse(bodies.begin(), bodies.end());
    std::reverse(joints.begin(), joints.end());
    if (world.step_state && !record_space(world.step_state->world_contacts.live_space())) return false;
    for (int i = 0, count = geoms.size(); i < count; ++i)
        if (!record_space(geoms[i].geom.object->space)) return false;
    own_geoms = geoms.size();
    return true;
}

bool Topology::record_spaces_of(const Topology& other)
{
    for (const GeomRecord& r : other.geoms)
        if (r.geom.lives() && !record_space(r.geom.object->space)) return false;
    return true;
}

bool Topology::record_body(Body& body, bool contacts)
{
    BodyRecord r{Named<Body>(body), body.mass,         body.mass_hash,
                 {links.size(), 0}, {geoms.size(), 0}, wheels_of(body)};
    bool complete = true;
    for (JointNode* n = body.joints; n; n = n->next)
        if (contacts || !is_contact(*n->joint)) complete = complete && links.push(n);
    for_each_geom(body, [&](Geom& geom) { complete = complete && record_geom(geom); });
    r.links.count = links.size() - r.links.first;
    r.geoms.count = geoms.size() - r.geoms.first;
    return complete && bodies.push(r);
}

bool Topology::record_joint(Joint& joint)
{
    JointRecord r{
        Named<Joint>(joint), {joint.node[0].body, joint.node[1].body}, joint.reverse, joint.driven, 0,
        own_bytes.size()};
    if (!is_contact(joint)) {
        r.attachments = static_cast<LastingJoint&>(joint).attachments;
        const auto own = own_part(joint);
        if (!own_bytes.extend(int(own.size()))) return false;
        std::copy(own.begin(), own.end(), own_bytes.data() + r.first_byte);
    }
    return joints.push(r);
}

bool Topology::record_geom(Geom& geom)
{
    GeomRecord r{.geom = Named<Geom>(geom),
                 .shape = shape_hash(geom),
                 .number = geom.type->number,
                 .on_body = geom.body.id != nullptr,
                 .has_offset = geom.offset != nullptr,
                 .watched = geom.watched,
                 .disturbed = geom.disturbed,
                 .offset = {}};
    if (geom.offset) {
        r.offset = *geom.offset;
    } else if (!r.on_body) {
        std::memcpy(r.offset.position, geom.own_position, sizeof r.offset.position);
        std::memcpy(r.offset.rotation, geom.own_rotation, sizeof r.offset.rotation);
    }
    return geoms.push(r);
}

// And the spaces in it.
bool Topology::record_space(Space* space)
{
    if (!space) return true;
    for (const SpaceRecord& known : spaces)
        if (known.space.object == space) return true;
    SpaceRecord r{Named<Geom>(*space), {geoms.size(), 0}};
    for (Geom* geom : space->geoms)
        if (geom && !record_geom(*geom)) return false;
    r.members.count = geoms.size() - r.members.first;
    if (!spaces.push(r)) return false;
    for (int i = r.members.first; i < r.members.first + r.members.count; ++i)
        if (Geom* inner = geoms[i].geom.object; is_space(*inner) && !record_space(static_cast<Space*>(inner)))
            return false;
    return true;
}

std::size_t Topology::bytes() const
{
    const auto of = [](const auto& list) { return sizeof(*list.data()) * std::size_t(list.capacity()); };
    return sizeof *this + of(bodies) + of(joints) + of(links) + of(own_bytes) + of(geoms) + of(spaces);
}

}  // namespace epode
