// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What two surfaces are to each other. Friction of a pair is the geometric mean, if nobody says otherwise:
// the coefficient of equal surfaces is their own, and one that is without friction has none against anything.
// Soft surfaces are a spring k and a damper d each, one behind the other: 1/k = 1/k1 + 1/k2. Two such pairs
// are in general no pair again; with damping times t = d/k, the mean of t1 and t2 weighted by softness is
// what slow motion sees, and exact where they are equal.
#pragma once

#include "base/objects/struct_size.h"
#include "collide/geom.h"
#include "ode/contacts.h"
#include "rows/contact_manifold.h"

namespace epode {

template <>
inline constexpr std::size_t kSmallestSize<dMaterial> = offsetof(dMaterial, bounce);

inline constexpr dMaterial kDefaultMaterial{
    sizeof(dMaterial), Real(0.6),       0, 1, {0, 0, 0, 0}, 0, 0, 0, dCombineDefault,
    dCombineDefault,   dCombineDefault, 0};

inline const dMaterial& material_of(const Geom& geom)
{
    return geom.material ? *geom.material : kDefaultMaterial;
}

// What the interface takes.
bool usable_material(const dMaterial& material);

// False: out of memory. null: the default again.
bool set_material(Geom& geom, const dMaterial* material);

// Coefficients and drift of a manifold between the two, whose normal is known.
void combine_materials(const Geom& g1, const Geom& g2, ContactManifold& manifold);

}  // namespace epode
