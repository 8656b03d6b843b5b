// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What a sweep changes, and nothing else: one cache line per body (half a line in floats), while masses stay
// where only preparation reads them. The slots after the last body are the world, one for each part. The
// world is gathered like any body, and scattering to it changes nothing, because its inverse mass is zero.
#pragma once

#include <span>

#include "base/arena.h"
#include "rows/row_system.h"

namespace epode {

struct alignas(8 * sizeof(Real)) Velocity {
    Vec3 v;
    Real unused1;
    Vec3 w;
    Real unused2;
};

// Access number by number, the unused ones included: loops over them are vectorised.
inline constexpr int kTwistNumbers = 8;
static_assert(sizeof(Velocity) == kTwistNumbers * sizeof(Real));

// The same in floats, half a cache line.
struct alignas(kTwistNumbers * sizeof(float)) FloatVelocity {
    float at[kTwistNumbers];
};

inline Real* numbers(Velocity& a) { return reinterpret_cast<Real*>(&a); }
inline const Real* numbers(const Velocity& a) { return reinterpret_cast<const Real*>(&a); }

// to += by
inline void add(std::span<Velocity> to, std::span<const Velocity> by)
{
    for (std::size_t i = 0; i < by.size(); ++i)
        for (int k = 0; k < kTwistNumbers; ++k) numbers(to[i])[k] += numbers(by[i])[k];
}

// Takes velocities for the bodies and the worlds; empty when the arena is exhausted.
inline std::span<Velocity> take_velocities(const RowSystem& system, Arena& arena)
{
    return arena.take<Velocity>(int(system.bodies.size()) + system.worlds());
}

inline void load_velocities(const RowSystem& system, std::span<Velocity> out)
{
    for (std::size_t i = 0; i < system.bodies.size(); ++i)
        out[i] = {system.bodies[i].v, 0, system.bodies[i].w, 0};
    for (std::size_t i = system.bodies.size(); i < out.size(); ++i) out[i] = {};
}

inline void store_velocities(std::span<const Velocity> from, RowSystem& system)
{
    for (std::size_t i = 0; i < system.bodies.size(); ++i) {
        system.bodies[i].v = from[i].v;
        system.bodies[i].w = from[i].w;
    }
}

// The index of a second body in the velocities.
inline int second_slot(const RowSystem& system, int body2)
{
    return body2 >= 0 ? body2 : int(system.bodies.size()) - 1 - body2;
}

}  // namespace epode
