// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The state of a world as bytes (ode/state.h): everything that a step changes and later steps read. This file
// defines the order of the parts; each part writes and reads its own:
//   header, structure                 state/state_header, state/structure
//   count of steps                    seeds random orders
//   bodies, joints                    dynamics/body_state, dynamics/joint_state
//   geoms of the contact space        enabled; poses of those without a body
//   impulses of contact joints        step/common/contact_cache_state
//   world-managed contacts            contacts/contact_state
// Everything that step/common/undo restores must be here; symbolic factors and working memory are caches.
#pragma once

#include "base/streams/state_stream.h"
#include "state/state_header.h"
#include "state/structure.h"
#include "step/step.h"

namespace epode {

class WorldState {
  public:
    explicit WorldState(World& world) : world_(world) {}

    enum class Joints { kAll, kLasting };  // kLasting: without contact joints

    // Finds the world's structure; must be called first. What it has found the last time is used again where
    // no structure has changed since. False: out of memory.
    [[nodiscard]] bool prepare(Joints which = Joints::kAll);

    // The state's size in bytes.
    [[nodiscard]] bool measure(std::size_t& size);  // false: out of memory
    // `to` has that many bytes.
    void write(std::byte* to, Seal with = Seal::kSealed);

    // Null: done; else what is wrong, with nothing changed.
    const char* set(const std::byte* from, std::size_t size, Seal with = Seal::kSealed);
    // Checks the header and the structure alone.
    const char* check(const std::byte* from, std::size_t size, Seal with = Seal::kSealed);

  private:
    void visit(StateStream& stream);  // all but the contacts
    void visit_bodies(StateStream& stream, std::byte* bits);
    void visit_joints(StateStream& stream, std::byte* bits);
    void visit_geoms(StateStream& stream, std::byte* bits);
    [[nodiscard]] bool save(StateStream& stream);
    void take_geom(Geom& geom, std::uint8_t bits, StateStream& stream);

    World& world_;
    StepState* kept_ = nullptr;
    BodyTable bodies_;
    SpaceGeoms geoms_;
    Structure structure_;
    std::uint64_t edition_ = 0;  // of the structure that bodies_ and geoms_ show
    Array<Joint*> joints_;       // the newest first
    Array<std::uint16_t> body_bits_;
    Array<std::uint8_t> rest_;  // of geoms: GeomRest
    char text_[200] = {};
};

}  // namespace epode
