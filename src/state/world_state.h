// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The state of a world as bytes (ode/state.h): everything that a step changes and later steps read. This file
// defines the order of the parts; each part writes and reads its own:
//   header, structure                 state/state_header, state/structure
//   count of steps                    seeds random orders
//   seed of dRand                     in a world with the behaviour of ODE 0.16, whose dWorldQuickStep draws
//   fluids                            in a world that has any: their times, which bodies are in them
//   bodies, joints                    dynamics/body_state, dynamics/joint_state
//   geoms of the contact space        enabled; poses of those without a body; characters (collide/character.h)
//   impulses of contact joints        step/common/contact_cache_state
//   world-managed contacts            contacts/state/contact_state
// Everything that step/common/undo restores must be here; symbolic factors and working memory are caches.
// A state is written in one walk over the world, to a block that grows, and read in two: all is checked, then
// all is stored.
#pragma once

#include "base/streams/state_stream.h"
#include "contacts/state/contact_state.h"
#include "state/state_header.h"
#include "state/structure.h"
#include "step/step.h"

namespace epode {

class WorldState {
  public:
    explicit WorldState(World& world) : world_(world) {}

    enum class Joints { kAll, kLasting };  // kLasting: without contact joints

    WorldState(const WorldState&) = delete;
    WorldState& operator=(const WorldState&) = delete;
    ~WorldState() { written_.release(); }

    // Finds the world's structure; must be called first. What it has found the last time is used again where
    // no structure has changed since. False: out of memory.
    [[nodiscard]] bool prepare(Joints which = Joints::kAll);

    // Is a geom that the state may move in a space that is being collided?
    bool is_locked() const;

    // Appends the state. False: out of memory.
    [[nodiscard]] bool append(StateBytes& out, Seal with = Seal::kSealed);
    // The same in memory that is kept until the next call.
    [[nodiscard]] bool write(Seal with) { return written_.size = 0, append(written_, with); }
    std::span<const std::byte> written() const { return written_.span(); }

    // Null: done; else what is wrong, with nothing changed.
    const char* set(const std::byte* from, std::size_t size, Seal with = Seal::kSealed);
    // Checks the header and the structure alone.
    const char* check(const std::byte* from, std::size_t size, Seal with = Seal::kSealed);

  private:
    // What stands before the parts.
    struct Counts {
        std::uint64_t hash;
        std::uint32_t bodies, joints, geoms, flags;

        // As the state has them, and the other way round.
        Counts little() const;
    };
    [[nodiscard]] bool find_structure();
    [[nodiscard]] bool find_joints(Joints which, bool same);
    [[nodiscard]] bool find_spaces();
    bool save(StateStream& stream);
    void save_objects(StateStream& stream);
    void save_bits(StateStream& stream, std::size_t place);
    void visit_fluids(StateStream& stream, bool has);
    void load(StateStream& stream, std::uint32_t flags);  // all but the contacts
    void load_bodies(StateStream& stream, const std::byte* bits);
    void load_joints(StateStream& stream, const std::byte* bits);
    void visit_geom(Geom& geom, std::uint8_t bits, StateStream& stream);
    void visit_pose(Geom& geom, StateStream& stream);
    bool has_characters() const;
    void visit_character(Geom& geom, StateStream& stream);
    int count_vehicles() const;
    void visit_vehicles(StateStream& stream, bool has);
    void visit_vehicle(Vehicle& vehicle, StateStream& stream);
    std::uint32_t visit_ground(dGeomID ground, StateStream& stream, const char* text);
    std::size_t begin_of_parts() const;

    World& world_;
    StepState* kept_ = nullptr;
    BodyTable bodies_;
    SpaceGeoms geoms_;
    Structure structure_;
    Array<Space*> spaces_;       // that have geoms of bodies, and that of the contacts
    std::uint64_t edition_ = 0;  // of the structure that all these show
    Array<Joint*> joints_;       // the newest first
    bool lasting_ = false;       // none of them is a contact, and no other lasting joint exists
    Array<std::uint16_t> body_bits_;
    Array<std::uint8_t> joint_bits_, geom_bits_;
    StateBytes written_;
    ContactCache::Loaded cached_;
    ContactWorld::Loaded loaded_;
    char text_[200] = {};
};

}  // namespace epode
