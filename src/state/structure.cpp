// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "state/structure.h"

#include <cstdio>

#include "base/streams/content_hash.h"
#include "collide/describe.h"
#include "dynamics/coupling.h"
#include "step/common/link.h"

namespace epode {
namespace {

constexpr std::uint64_t kNobody = ~0ull, kStranger = ~1ull;

// The number of a body of this world; bodies of other worlds have none.
std::uint64_t number_of(const Body* body, const World& world)
{
    if (!body) return kNobody;
    return body->world == &world ? std::uint64_t(body->island_index) : kStranger;
}

void add_shape(Geom& geom, ContentHash& hash)
{
    hash.add(shape_hash(geom));
    if (!geom.offset) return;
    hash.add(geom.offset->position, 3);
    for (int row = 0; row < 3; ++row) hash.add(geom.offset->rotation + 4 * row, 3);
}

std::uint64_t hash_of(const Body& body)
{
    ContentHash hash;
    hash.add(body.mass_hash);
    for_each_geom(body, [&](Geom& geom) { add_shape(geom, hash); });
    return hash.value();
}

std::uint64_t hash_of(const Joint& joint, const BodyTable& bodies)
{
    ContentHash hash;
    hash.add(std::uint64_t(joint.type->number) << 2 | joint.driven << 1 | joint.reverse);
    for (int i = 0; i < 2; ++i) {
        const Body* body = joint.node[i].body;
        hash.add(body ? std::uint64_t(bodies.find(body->serial)) : kNobody);
    }
    if (is_coupling(joint))
        for_each_member(coupling_of(joint), [&](const CoupledAxis& member) {
            for (const JointNode& node : member.joint->node)
                hash.add(node.body ? std::uint64_t(bodies.find(node.body->serial)) : kNobody);
            hash.add(std::uint64_t(member.joint->type->number) << 8 | std::uint64_t(member.axis));
            const Real factor = coupling_of(joint).moves ? 0 : member.factor;  // 0 is none that it could have
            hash.add(&factor, 1);
        });
    return hash.value();
}

std::uint64_t hash_of(Geom& geom, const World& world)
{
    ContentHash hash;
    add_shape(geom, hash);
    hash.add(number_of(body_of(geom), world));
    return hash.value();
}

}  // namespace

void Structure::add(std::uint64_t own)
{
    ContentHash all;
    all.add(hash_), all.add(own);
    hash_ = all.value();
    (void)marks_.push(std::uint8_t(own >> 56 ^ own));
}

bool Structure::measure(const World& world, const BodyTable& bodies, const SpaceGeoms& geoms)
{
    constexpr int kAhead = 8;
    bodies_ = bodies.count(), geoms_ = geoms.count();
    hash_ = 0;
    marks_.clear();
    if (!marks_.reserve(bodies_ + geoms_)) return false;
    for (int i = 0; i < bodies_; ++i) {
        if (i + kAhead < bodies_)
            prefetch<1>(&bodies[i + kAhead].mass_hash), prefetch<1>(bodies[i + kAhead].first_geom);
        add(hash_of(bodies[i]));
    }
    for (int i = 0; i < geoms_; ++i) add(hash_of(geoms[i], world));
    lasting_hash_ = hash_;
    return true;
}

bool Structure::measure_joints(std::span<Joint* const> joints, const BodyTable& bodies)
{
    joints_ = int(joints.size());
    hash_ = lasting_hash_;
    marks_.truncate(bodies_ + geoms_);
    if (!marks_.reserve(bodies_ + geoms_ + joints_)) return false;
    for (const Joint* joint : joints) add(hash_of(*joint, bodies));
    return true;
}

// The joints' marks begin with the newest joint.
const char* Structure::difference(const std::uint8_t* marks, char* text, std::size_t size) const
{
    int at = 0;
    while (at < marks_.size() && marks_[at] == marks[at]) ++at;
    if (at == marks_.size())
        std::snprintf(text, size, "a body, joint or geom differs from the one the state was saved with");
    else if (at < bodies_)
        std::snprintf(text, size, "body %d (of %d, in order of creation) had another mass or other geoms", at,
                      bodies_);
    else if (at < bodies_ + geoms_)
        std::snprintf(text, size,
                      "geom %d (of %d, in order of creation) had another class, shape, offset or body",
                      at - bodies_, geoms_);
    else
        std::snprintf(text, size,
                      "joint %d (of %d, in order of creation) had another type, other bodies, or drives that "
                      "the other lacks",
                      marks_.size() - 1 - at, joints_);
    return text;
}

}  // namespace epode
