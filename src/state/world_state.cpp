// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "state/world_state.h"

#include <algorithm>
#include <cstdio>

#include "base/objects/structure_edition.h"
#include "base/random.h"
#include "base/streams/little_endian.h"
#include "collide/character.h"
#include "dynamics/active.h"
#include "dynamics/body_state.h"
#include "dynamics/forces/fluid.h"
#include "dynamics/forces/vehicle.h"
#include "dynamics/joint_state.h"
#include "math/rotation.h"
#include "step/common/link.h"

namespace epode {
namespace {

constexpr int kAhead = 4;
constexpr std::uint32_t kSeeded = 1;      // of the flags: the seed of dRand follows
constexpr std::uint32_t kCharacters = 2;  // geoms are characters
constexpr std::uint32_t kFluids = 4;      // the world has fluids
enum FluidBit : std::uint8_t { kWet = 1, kFloats = 2, kRestless = 4 };
constexpr std::uint32_t kVehicles = 8;  // bodies are vehicles

enum GeomBit : std::uint8_t {
    kEnabled = 1,
    kPose = 4,
    kRest = kGeomDisturbed | kGeomAtRest | kGeomUnsupported | kGeomPutDown
};
static_assert((kRest & (kEnabled | kPose)) == 0);

// A geom without a body stays where the program has placed it.
bool has_own_pose(const Geom& geom) { return geom.type->placeable && !geom.body.id && !is_space(geom); }

std::size_t padded(std::size_t bytes) { return (bytes + 3) / 4 * 4; }

}  // namespace

// ---- structure ----

bool WorldState::prepare(Joints which)
{
    kept_ = step_state(world_);
    if (!kept_) return false;
    const std::uint64_t edition = structure_edition();
    const bool same = edition_ == edition;
    if (!same) {
        edition_ = 0;
        if (!find_structure()) return false;
    }
    if (!find_joints(which, same)) return false;
    edition_ = edition;
    return true;
}

bool WorldState::find_structure()
{
    return bodies_.gather(world_) && geoms_.gather(kept_->world_contacts.live_space()) && find_spaces() &&
           structure_.measure(world_, bodies_, geoms_) && body_bits_.resize(bodies_.count()) &&
           geom_bits_.resize(geoms_.count());
}

// Contact joints come and go without a trace in the edition.
bool WorldState::find_joints(Joints which, bool same)
{
    if (same && lasting_ && joints_.size() == world_.joints.count()) return true;
    lasting_ = false;
    joints_.clear();
    if (!joints_.reserve(world_.joints.count()) || !joint_bits_.resize(world_.joints.count())) return false;
    int contacts = 0;
    for (Joint& joint : world_.joints) {
        contacts += is_contact(joint);
        if (which == Joints::kAll || !is_contact(joint)) (void)joints_.push(&joint);
    }
    if (!structure_.measure_joints(joints_.span(), bodies_)) return false;
    lasting_ = contacts == 0;
    return true;
}

bool WorldState::find_spaces()
{
    spaces_.clear();
    bool complete = true;
    const auto add = [&](Space* space) {
        if (space && std::find(spaces_.begin(), spaces_.end(), space) == spaces_.end())
            complete = spaces_.push(space) && complete;
    };
    add(kept_->world_contacts.live_space());
    const Space* last = nullptr;
    for (const Body* body : bodies_.all())
        for_each_geom(*body, [&](Geom& geom) {
            if (geom.space != last) add(geom.space);
            last = geom.space;
        });
    return complete;
}

bool WorldState::is_locked() const
{
    return std::any_of(spaces_.begin(), spaces_.end(),
                       [](const Space* space) { return epode::is_locked(*space); });
}

std::size_t WorldState::begin_of_parts() const
{
    return sizeof(StateHeader) + sizeof(Counts) + padded(structure_.marks().size());
}

// ---- saving ----

bool WorldState::append(StateBytes& out, Seal with)
{
    const std::size_t begin = out.size;
    StateStream stream(out);
    stream.set_format(StateHeader::kVersion);
    (void)stream.block(sizeof(StateHeader));
    if (!save(stream) || !stream.close()) {
        out.size = begin;
        return false;
    }
    seal(out.data + begin, out.size - begin, StateHeader::kWhole, with);
    return true;
}

bool WorldState::has_characters() const
{
    const std::span<Geom* const> all = geoms_.all();
    return std::any_of(all.begin(), all.end(), [](const Geom* geom) { return geom->character != nullptr; });
}

WorldState::Counts WorldState::Counts::little() const
{
    using epode::little;
    return {little(hash), little(bodies), little(joints), little(geoms), little(flags)};
}

bool WorldState::save(StateStream& stream)
{
    const bool seeded = world_.acts_as_ode();
    const Counts counts{structure_.hash(), std::uint32_t(structure_.bodies()),
                        std::uint32_t(structure_.joints()), std::uint32_t(structure_.geoms()),
                        (seeded ? kSeeded : 0) | (has_characters() ? kCharacters : 0) |
                            (world_.fluids.empty() ? 0 : kFluids) | (count_vehicles() > 0 ? kVehicles : 0)};
    const auto put = [&](const void* from, std::size_t size) {
        if (std::byte* to = stream.block(size); to && size > 0) std::memcpy(to, from, size);
    };
    const Counts written = counts.little();
    put(&written, sizeof written);
    put(structure_.marks().data(), structure_.marks().size());
    (void)stream.long_word(world_.step_count);
    if (seeded) (void)stream.word(ProcessRandom::state());
    visit_fluids(stream, counts.flags & kFluids);
    visit_vehicles(stream, counts.flags & kVehicles);
    save_objects(stream);
    kept_->contacts.save(bodies_, stream);
    return kept_->world_contacts.save(world_, geoms_, stream);
}

// Bits of all objects stand before their numbers, and are known after them.
void WorldState::save_objects(StateStream& stream)
{
    const std::size_t place = stream.failed() ? 0 : stream.written();
    (void)stream.block(sizeof(std::uint16_t) * std::size_t(structure_.bodies()));
    (void)stream.block(std::size_t(structure_.joints()));
    (void)stream.block(std::size_t(structure_.geoms()));
    const int count = bodies_.count();
    for (int i = 0; i < count; ++i) {
        if (i + kAhead < count) prefetch_state(bodies_[i + kAhead]);
        body_bits_.data()[i] = save_state(bodies_[i], stream);
    }
    for (int i = 0; i < joints_.size(); ++i) {
        Joint& joint = *joints_.data()[i];
        joint_bits_.data()[i] = state_bits(joint);
        state(joint, joint_bits_.data()[i], stream);
    }
    std::fill(geom_bits_.begin(), geom_bits_.end(), std::uint8_t(0));
    kept_->world_contacts.mark_rest(world_, geoms_, geom_bits_.span());
    for (int i = 0; i < geoms_.count(); ++i) {
        Geom& geom = geoms_[i];
        std::uint8_t& bits = geom_bits_.data()[i];
        bits = std::uint8_t(bits | (geom.enabled ? kEnabled : 0) | (has_own_pose(geom) ? kPose : 0));
        visit_geom(geom, bits, stream);
    }
    if (!stream.failed()) save_bits(stream, place);
}

void WorldState::save_bits(StateStream& stream, std::size_t place)
{
    const auto put = [&](const void* from, std::size_t size) {
        if (size > 0) std::memcpy(stream.written_at(place), from, size);
        place += padded(size);
    };
    const std::size_t bodies = sizeof(std::uint16_t) * std::size_t(structure_.bodies());
    copy_little<sizeof(std::uint16_t)>(stream.written_at(place), body_bits_.data(),
                                       std::size_t(structure_.bodies()));
    place += padded(bodies);
    put(joint_bits_.data(), std::size_t(structure_.joints()));
    put(geom_bits_.data(), std::size_t(structure_.geoms()));
}

// ---- loading ----

// Their times, and what a step leaves for the next one to decide which bodies may sleep.
void WorldState::visit_fluids(StateStream& stream, bool has)
{
    constexpr const char* kAnother = "the world has more or fewer fluids than the state";
    if (!stream.demand(has == !world_.fluids.empty(), kAnother) || !has) return;
    const auto count = std::uint32_t(world_.fluids.size());
    if (!stream.demand(stream.word(count) == count, kAnother)) return;
    for (Fluid* fluid : world_.fluids) {
        Real time = fluid->time;
        stream.reals(&time, 1);
        if (stream.stores()) fluid->time = time;
    }
    std::byte* const bits = stream.block(std::size_t(bodies_.count()));
    for (int i = 0; bits && i < bodies_.count(); ++i) {
        BodyInFluid& in = bodies_[i].fluid;
        if (stream.saves())
            bits[i] =
                std::byte((in.wet ? kWet : 0) | (in.floats ? kFloats : 0) | (in.restless ? kRestless : 0));
        const auto own = std::uint8_t(bits[i]);
        if (!stream.demand(own < 8, "a body of the state is in a fluid in an unknown way")) return;
        if (stream.stores()) in = {bool(own & kWet), bool(own & kFloats), bool(own & kRestless), {}, {}};
    }
}

int WorldState::count_vehicles() const
{
    const auto all = bodies_.all();
    return int(std::count_if(all.begin(), all.end(), [](const Body* body) { return body->vehicle; }));
}

// The geom that something stands on: its number plus 1, or 0 if it is not in the state.
std::uint32_t WorldState::visit_ground(dGeomID ground, StateStream& stream, const char* text)
{
    const Geom* const geom = stream.saves() ? from_handle<Geom>(ground) : nullptr;
    const int known = geom ? geoms_.find(*geom) : -1;
    return stream.index(std::uint32_t(known + 1), std::uint32_t(geoms_.count()) + 1, text);
}

void WorldState::visit_vehicle(Vehicle& vehicle, StateStream& stream)
{
    std::uint32_t grounds[dVehicleMaxWheels] = {};
    for (int i = 0; i < vehicle.wheel_count; ++i)
        grounds[i] = visit_ground(vehicle.wheels[i].ground, stream, "the ground of a wheel is not there");
    state_of_vehicle(vehicle, stream);
    for (int i = 0; i < vehicle.wheel_count && stream.stores(); ++i)
        vehicle.wheels[i].ground = grounds[i] > 0 ? to_handle(&geoms_[int(grounds[i]) - 1]) : nullptr;
}

void WorldState::visit_vehicles(StateStream& stream, bool has)
{
    constexpr const char* kAnother =
        "a body of the state is a vehicle and in the world it is none, or is one and was none";
    const auto count = std::uint32_t(count_vehicles());
    if (!stream.demand(has == (count > 0), kAnother) || !has) return;
    if (!stream.demand(stream.word(count) == count, kAnother)) return;
    for (Body* body : bodies_.all()) {
        if (!body->vehicle) continue;
        const auto wheels = std::uint32_t(body->vehicle->wheel_count);
        const auto number = std::uint32_t(bodies_.find(body->serial));
        if (!stream.demand(stream.word(number) == number && stream.word(wheels) == wheels, kAnother)) return;
        visit_vehicle(*body->vehicle, stream);
    }
}

void WorldState::load(StateStream& stream, std::uint32_t flags)
{
    const bool seeded = flags & kSeeded;
    const std::uint64_t steps = stream.long_word(0);
    const std::uint32_t seed = seeded ? stream.word(0) : 0;
    visit_fluids(stream, flags & kFluids);
    visit_vehicles(stream, flags & kVehicles);
    const std::byte* const body_bits = stream.block(sizeof(std::uint16_t) * std::size_t(structure_.bodies()));
    const std::byte* const joint_bits = stream.block(std::size_t(structure_.joints()));
    const std::byte* const geom_bits = stream.block(std::size_t(structure_.geoms()));
    if (stream.failed()) return;
    load_bodies(stream, body_bits);
    load_joints(stream, joint_bits);
    for (int i = 0; i < geoms_.count() && !stream.failed(); ++i) {
        const auto own = std::uint8_t(geom_bits[i]);
        geom_bits_.data()[i] = own & kRest;
        visit_geom(geoms_[i], own, stream);
    }
    if (!stream.stores()) return;
    world_.step_count = steps;
    if (seeded && world_.acts_as_ode()) ProcessRandom::set_state(seed);
}

void WorldState::load_bodies(StateStream& stream, const std::byte* bits)
{
    const int count = bodies_.count();
    const bool stores = stream.stores();
    for (int i = 0; i < count && !stream.failed(); ++i) {
        if (stores && i + 2 * kAhead < count) prefetch_state(bodies_[i + 2 * kAhead]);
        if (stores && i + kAhead < count) prefetch_geoms(bodies_[i + kAhead]);
        const auto own = get_little<std::uint16_t>(bits, std::size_t(i));
        if (load_state(bodies_[i], own, stream)) body_moved(bodies_[i]);
    }
}

void WorldState::load_joints(StateStream& stream, const std::byte* bits)
{
    for (int i = 0; i < joints_.size() && !stream.failed(); ++i)
        state(*joints_.data()[i], std::uint8_t(bits[i]), stream);
}

// Its ground by number, if that is in the state.
void WorldState::visit_character(Geom& geom, StateStream& stream)
{
    const std::uint32_t number =
        visit_ground(geom.character->ground, stream, "the ground of a character is not there");
    state_of_character(geom, stream);
    if (stream.stores()) geom.character->ground = number > 0 ? to_handle(&geoms_[int(number) - 1]) : nullptr;
}

void WorldState::visit_geom(Geom& geom, std::uint8_t bits, StateStream& stream)
{
    const bool posed = bits & kPose;
    if (!stream.demand(posed == has_own_pose(geom), "a geom of the state has a pose and no body, or none"))
        return;
    if (const bool enabled = bits & kEnabled; stream.stores() && enabled != geom.enabled) {
        geom.enabled = enabled;
        note_rules_changed(geom);
    }
    if (geom.character) visit_character(geom, stream);
    if (posed) visit_pose(geom, stream);
}

// What is loaded goes through a copy, to be judged as a whole.
void WorldState::visit_pose(Geom& geom, StateStream& stream)
{
    Real pose[12];
    std::memcpy(pose, geom.own_position, 3 * sizeof(Real));
    for (int row = 0; row < 3; ++row)
        std::memcpy(pose + 3 + 3 * row, geom.own_rotation + 4 * row, 3 * sizeof(Real));
    Real before[12];
    std::memcpy(before, pose, sizeof pose);
    {
        const StateStream::IntoCopies into(stream);
        stream.reals(pose, 12);
    }
    if (stream.saves() || stream.failed() || std::memcmp(before, pose, sizeof pose) == 0) return;
    const Mat3 R{{pose[3], pose[4], pose[5]}, {pose[6], pose[7], pose[8]}, {pose[9], pose[10], pose[11]}};
    if (!stream.is_checked() &&
        !stream.demand(is_rotation(R, kUnitTolerance),
                       "a geom of the state is turned by a matrix that is no rotation"))
        return;
    if (!stream.stores()) return;
    std::memcpy(geom.own_position, pose, 3 * sizeof(Real));
    store_mat(geom.own_rotation, R);
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
    counts = counts.little();
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
    if (length < begin_of_parts()) return "the state ends too early";
    if (counts.flags & ~(kSeeded | kCharacters | kFluids | kVehicles))
        return "the state has parts that this library does not know";
    if (counts.hash == structure_.hash()) return nullptr;
    return structure_.difference(reinterpret_cast<const std::uint8_t*>(from + sizeof header + sizeof counts),
                                 text_, sizeof text_);
}

const char* WorldState::set(const std::byte* from, std::size_t size, Seal with)
{
    if (const char* wrong = check(from, size, with)) return wrong;
    StateHeader header;
    Counts counts;
    std::memcpy(&header, from, sizeof header), std::memcpy(&counts, from + sizeof header, sizeof counts);
    header = epode::little(header), counts = counts.little();
    const std::size_t begin = begin_of_parts(), length = std::size_t(header.size) - begin;
    StateStream stream(StateStream::Mode::kCheck, from + begin, length);
    stream.set_format(header.version);
    load(stream, counts.flags);
    stream.set_mode(StateStream::Mode::kRead);  // into memory of its own
    if (!stream.failed() && !ContactCache::load(bodies_, stream, cached_)) return kOutOfMemory;
    if (!stream.failed() && !kept_->world_contacts.load(world_, geoms_, stream, loaded_)) return kOutOfMemory;
    if (!stream.failed()) stream.demand(stream.left() == 0, "the state has bytes too many");
    if (stream.failed()) {
        std::snprintf(text_, sizeof text_, "%s", stream.text());
        return text_;
    }
    StateStream values(StateStream::Mode::kRead, from + begin, length, true);
    values.set_format(header.version);
    load(values, counts.flags);
    kept_->contacts.accept(cached_);
    kept_->world_contacts.accept(world_, loaded_, geoms_, geom_bits_.span());
    kept_->events.restart(world_, kept_->world_contacts.live_space());
    world_.report_made = false;
    return nullptr;
}

}  // namespace epode
