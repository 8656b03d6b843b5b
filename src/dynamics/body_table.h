// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The bodies of a world by number, the oldest first: what names them in a state, where addresses and serial
// numbers mean nothing. While the table is used, each body carries its number in `island_index`.
#pragma once

#include "dynamics/world.h"

namespace epode {

class BodyTable {
  public:
    // False: out of memory.
    [[nodiscard]] bool gather(const World& world)
    {
        if (!bodies_.resize(world.bodies.count()) || !serials_.resize(world.bodies.count())) return false;
        int number = world.bodies.count();
        for (Body& body : world.bodies) {
            body.island_index = --number;
            bodies_.data()[number] = &body;
            serials_.data()[number] = body.serial;
        }
        return true;
    }

    int count() const { return bodies_.size(); }
    Body& operator[](int i) const { return *bodies_.data()[i]; }
    std::span<Body* const> all() const { return bodies_.span(); }

    // The number of the body with this serial, or -1. Mostly none has been destroyed since the first.
    int find(std::uint64_t serial) const
    {
        if (bodies_.empty() || serial < serials_.data()[0]) return -1;
        int low = 0, high = count();
        const std::uint64_t guess = serial - serials_.data()[0];
        if (guess < std::uint64_t(count()) && serials_.data()[guess] == serial) return int(guess);
        while (high - low > 1) {
            const int middle = (low + high) / 2;
            (serials_.data()[middle] <= serial ? low : high) = middle;
        }
        return serials_.data()[low] == serial ? low : -1;
    }

  private:
    Array<Body*> bodies_;
    Array<std::uint64_t> serials_;  // ascending
};

}  // namespace epode
