// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A fluid as the program describes it (ode/fluid.h), in the list of its world. What it does to bodies is in src/fluid.
#pragma once

#include "base/objects/handle.h"
#include "math/vec.h"
#include "ode/fluid.h"

namespace epode {

struct World;

inline constexpr dFluidSettings kDefaultFluidSettings = {
    sizeof(dFluidSettings), 1000, 1, 200, 1, {0, 0, 0, 0}};

struct Fluid : Tagged {
    explicit Fluid(World& in) : Tagged(Tag::kFluid), world(&in) {}

    World* world;
    dFluidSettings settings = kDefaultFluidSettings;
    Vec3 normal{0, 0, 1};  // unit, out of it
    Real offset = 0;
    dFluidSurface* surface = nullptr;
    void* surface_data = nullptr;
    dFluidCurrent* current = nullptr;
    void* current_data = nullptr;
    dGeomID volume = nullptr;  // perhaps destroyed; null: no limit
    Real time = 0;             // of its functions, s

    bool has_functions() const { return surface || current; }
};

template <>
struct HandleOf<Fluid> {
    using Id = dFluidID;
    static constexpr Tag kTag = Tag::kFluid;
};

Fluid* create_fluid(World& world);  // null: out of memory
void destroy_fluid(Fluid& fluid);

}  // namespace epode
