// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "state/world_state.h"

#include <algorithm>
#include <cstdio>

#include "base/structure_edition.h"
#include "contacts/contact_state.h"
#include "dynamics/active.h"
#include "dynamics/body_state.h"
#include "dynamics/joint_state.h"
#include "state/state_header.h"
#include "step/common/link.h"

namespace epode {
namespace {

enum GeomBit : std::uint8_t { kEnabled = 1, kPose = 4, kRest = kGeomDisturbed | kGeomAtRest };
static_assert((kRest & (kEnabled | kPose)) == 0);

// A geom without a body stays where the program has placed it.
bool has_own_pose(const Geom& geom) { return geom.type->placeable && !geom.body.id && !is_space(geom); }

struct Counts {
    std::uint64_t hash;
    std::uint32_t bodies, joints, geoms, padding;
};

}  // namespace

bool WorldState::prepare(Joints which)
{
    kept_ = step_state(world_);
    const std::uint64_t edition = structure_edition();
    if (edition_ != edition) {
        edition_ = 0;
        if (!kept_ || !bodies_.gather(world_) || !geoms_.gather(kept_->world_contacts.live_space()) ||
            !structure_.measure(world_, bodies_, geoms_))
            return false;
        edition_ = edition;
    }
    joints_.clear();
    if (!rest_.resize(geoms_.count()) || !joints_.reserve(world_.joints.count())) return false;
    std::fill(rest_.begin(), rest_.end(), std::uint8_t(0));
    for (Joint& joint : world_.joints)
        if (which == Joints::kAll || !is_contact(joint)) (void)joints_.push(&joint);
    return structure_.measure_joints(joints_.span(), bodies_);
}

bool WorldState::measure(std::size_t& size)
{
    if (!body_bits_.resize(bodies_.count())) return false;
    for (int i = 0; i < bodies_.count(); ++i) body_bits_[i] = state_bits(bodies_[i]);
    kept_->world_contacts.mark_rest(geoms_, rest_.span());
    StateStream counter;
    if (!save(counter)) return false;
    size = sizeof(StateHeader) + counter.size();
    return true;
}

void WorldState::write(std::byte* to, Seal with)
{
    StateStream stream(to + sizeof(StateHeader));
    (void)save(stream);  // has the memory of measure()
    seal(to, sizeof(StateHeader) + std::size_t(stream.at() - (to + sizeof(StateHeader))), StateHeader::kWhole,
         with);
}

bool WorldState::save(StateStream& stream)
{
    const Counts counts{structure_.hash(), std::uint32_t(structure_.bodies()),
                        std::uint32_t(structure_.joints()), std::uint32_t(structure_.geoms()), 0};
    const auto put = [&](const void* from, std::size_t size) {
        if (std::byte* to = stream.block(size); to && size > 0) std::memcpy(to, from, size);
    };
    put(&counts, sizeof counts);
    put(structure_.marks().data(), structure_.marks().size());
    visit(stream);
    kept_->contacts.save(bodies_, stream);
    return kept_->world_contacts.save(world_, geoms_, stream);
}

void WorldState::visit(StateStream& stream)
{
    const std::uint64_t steps = stream.long_word(world_.step_count);
    std::byte* const body_bits = stream.block(sizeof(std::uint16_t) * std::size_t(structure_.bodies()));
    std::byte* const joint_bits = stream.block(std::size_t(structure_.joints()));
    std::byte* const geom_bits = stream.block(std::size_t(structure_.geoms()));
    if (stream.failed()) return;
    visit_bodies(stream, body_bits);
    visit_joints(stream, joint_bits);
    visit_geoms(stream, geom_bits);
    if (stream.stores()) world_.step_count = steps;
}

void WorldState::visit_bodies(StateStream& stream, std::byte* bits)
{
    constexpr int kAhead = 6;
    const int count = bodies_.count();
    for (int i = 0; i < count && !stream.failed(); ++i) {
        if (i + kAhead < count) prefetch<5>(bodies_[i + kAhead].pos);
        std::uint16_t own = stream.saves() ? body_bits_.data()[i] : std::uint16_t(0);
        std::byte* const at = bits + sizeof own * std::size_t(i);
        if (!stream.saves())
            std::memcpy(&own, at, sizeof own);
        else if (bits)
            std::memcpy(at, &own, sizeof own);
        if (state(bodies_[i], own, stream)) body_moved(bodies_[i]);
    }
}

void WorldState::visit_joints(StateStream& stream, std::byte* bits)
{
    for (int i = 0; i < joints_.size(); ++i) {
        Joint& joint = *joints_.data()[i];
        if (stream.failed()) return;
        const std::uint8_t own = stream.saves() ? state_bits(joint) : std::uint8_t(bits[i]);
        if (stream.saves() && bits) bits[i] = std::byte(own);
        state(joint, own, stream);
    }
}

void WorldState::visit_geoms(StateStream& stream, std::byte* bits)
{
    for (int i = 0; i < geoms_.count() && !stream.failed(); ++i) {
        Geom& geom = geoms_[i];
        unsigned present = geom.enabled ? unsigned(kEnabled) : 0u;
        present |= rest_.data()[i];
        if (has_own_pose(geom)) present |= kPose;
        const std::uint8_t own = stream.saves() ? std::uint8_t(present) : std::uint8_t(bits[i]);
        if (stream.saves() && bits) bits[i] = std::byte(own);
        if (!stream.saves()) rest_.data()[i] = own & kRest;
        take_geom(geom, own, stream);
    }
}

void WorldState::take_geom(Geom& geom, std::uint8_t bits, StateStream& stream)
{
    const bool posed = bits & kPose;
    if (!stream.demand(posed == has_own_pose(geom), "a geom of the state has a pose and no body, or none"))
        return;
    if (const bool enabled = bits & kEnabled; stream.stores() && enabled != geom.enabled) {
        geom.enabled = enabled;
        note_rules_changed(geom);
    }
    if (!posed) return;
    Real pose[12];
    std::memcpy(pose, geom.own_position, 3 * sizeof(Real));
    for (int row = 0; row < 3; ++row)
        std::memcpy(pose + 3 + 3 * row, geom.own_rotation + 4 * row, 3 * sizeof(Real));
    Real before[12];
    std::memcpy(before, pose, sizeof pose);
    stream.reals(pose, 12);
    if (!stream.stores() || std::memcmp(before, pose, sizeof pose) == 0) return;
    std::memcpy(geom.own_position, pose, 3 * sizeof(Real));
    for (int row = 0; row < 3; ++row)
        std::memcpy(geom.own_rotation + 4 * row, pose + 3 + 3 * row, 3 * sizeof(Real));
    mark_moved(geom);
}

const char* WorldState::check(const std::byte* from, std::size_t size, Seal with)
{
    StateHeader header;
    if (const char* wrong = read_header(from, size, StateHeader::kWhole, header, text_, sizeof text_, with))
        return wrong;
    const auto length = std::size_t(header.size);
    Counts counts;
    if (length < sizeof header + sizeof counts) return "the state ends too early";
    std::memcpy(&counts, from + sizeof header, sizeof counts);
    const struct {
        const char* name;
        std::uint32_t state;
        int world;
    } kinds[] = {{"bodies", counts.bodies, structure_.bodies()},
                 {"joints", counts.joints, structure_.joints()},
                 {"geoms", counts.geoms, structure_.geoms()}};
    for (const auto& kind : kinds)
        if (kind.state != std::uint32_t(kind.world)) {
            std::snprintf(text_, sizeof text_, "the state has %u %s and the world %d", kind.state, kind.name,
                          kind.world);
            return text_;
        }
    const std::size_t marks = structure_.marks().size();
    if (length < sizeof header + sizeof counts + (marks + 3) / 4 * 4) return "the state ends too early";
    if (counts.hash == structure_.hash()) return nullptr;
    return structure_.difference(reinterpret_cast<const std::uint8_t*>(from + sizeof header + sizeof counts),
                                 text_, sizeof text_);
}

const char* WorldState::set(const std::byte* from, std::size_t size, Seal with)
{
    if (const char* wrong = check(from, size, with)) return wrong;
    StateHeader header;
    std::memcpy(&header, from, sizeof header);
    const std::size_t begin = sizeof header + sizeof(Counts) + (structure_.marks().size() + 3) / 4 * 4;
    const std::size_t length = std::size_t(header.size) - begin;
    StateStream stream(StateStream::Mode::kCheck, from + begin, length);
    visit(stream);
    ContactCache::Loaded cached;
    ContactWorld::Loaded loaded;
    stream.set_mode(StateStream::Mode::kRead);  // into memory of its own
    if (!stream.failed() && !ContactCache::load(bodies_, stream, cached)) return kOutOfMemory;
    if (!stream.failed() && !kept_->world_contacts.load(world_, geoms_, stream, loaded)) return kOutOfMemory;
    if (!stream.failed()) stream.demand(stream.size() == 0, "the state has bytes too many");
    if (stream.failed()) {
        std::snprintf(text_, sizeof text_, "%s", stream.text());
        return text_;
    }
    StateStream values(StateStream::Mode::kRead, from + begin, length, true);
    visit(values);
    kept_->contacts.accept(cached);
    kept_->world_contacts.accept(loaded, geoms_, rest_.span());
    kept_->events.restart(world_, kept_->world_contacts.live_space());
    world_.report_made = false;
    return nullptr;
}

}  // namespace epode
