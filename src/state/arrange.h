// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Gives a world the structure that a topology has recorded: objects that it has and the world lacks come back
// from parking, those that the world has and it lacks are parked, and all lists get the recorded order. What
// is in order already is left alone. Everything that may fail is done first: apply() cannot fail, and
// apply(to, from) undoes apply(from, to).
#pragma once

#include "state/parking.h"
#include "state/topology.h"

namespace epode {

class Arrangement {
  public:
    Arrangement(World& world, Parking& parking) : world_(world), parking_(parking) {}
    Arrangement(const Arrangement&) = delete;
    Arrangement& operator=(const Arrangement&) = delete;
    ~Arrangement();

    // Null: apply() may follow; else why not, in words.
    const char* prepare(const Topology& from, const Topology& to, char* text, std::size_t size);
    // `last`: the last frame that may have what is parked now.
    void apply(const Topology& from, const Topology& to, std::uint64_t last);

  private:
    const char* find_obstacle(const Topology& to, char* text, std::size_t size) const;
    [[nodiscard]] bool reserve(const Topology& from, const Topology& to);
    void arrange_bodies(const Topology& from, const Topology& to);
    void arrange_joints(const Topology& from, const Topology& to, std::uint64_t last);
    void arrange_links(const Topology& from, const Topology& to);
    void arrange_geoms(const Topology& from, const Topology& to, std::uint64_t last);
    void arrange_space(const Topology& to, const Topology::SpaceRecord& r);
    void link_geoms(Body& body, std::span<const Topology::GeomRecord> geoms);

    World& world_;
    Parking& parking_;
    Array<GeomOffset*> offsets_;  // memory for those that come back
};

}  // namespace epode
