// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What two surfaces are to each other. Friction of a pair is the geometric mean, if nobody says otherwise:
// the coefficient of equal surfaces is their own, and one that is without friction has none against anything.
// Soft surfaces are a spring k and a damper d each, one behind the other: 1/k = 1/k1 + 1/k2. Two such pairs
// are in general no pair again; with damping times t = d/k, the mean of t1 and t2 weighted by softness is
// what slow motion sees, and exact where they are equal.
#pragma once

#include <span>

#include "base/objects/struct_size.h"
#include "collide/face_materials.h"
#include "ode/contacts.h"
#include "rows/contact_manifold.h"

namespace epode {

template <>
inline constexpr std::size_t kSmallestSize<dMaterial> = offsetof(dMaterial, bounce);

inline constexpr dMaterial kDefaultMaterial{
    sizeof(dMaterial), Real(0.6),       0, 1,         {0, 0, 0, 0}, 0, 0, 0, dCombineDefault,
    dCombineDefault,   dCombineDefault, 0, Real(0.6), {0, 0, 0, 0}, 0};

inline const dMaterial& material_of(const Geom& geom)
{
    return geom.material ? *geom.material : kDefaultMaterial;
}

// What the interface takes.
bool usable_material(const dMaterial& material);

// False: out of memory. null: the default again.
bool set_material(Geom& geom, const dMaterial* material);

// The same for faces of a geom (collide/face_materials.h); number 1 ... kMostFaceMaterials. False: out of memory.
bool set_face_material(Geom& geom, int number, const dMaterial* material);
bool set_face_numbers(Geom& geom, std::span<const unsigned char> numbers);
bool has_face_material(const Geom& geom, int number);
const dMaterial& face_material(const Geom& geom, int number);  // the default if it has none
std::span<const unsigned char> face_numbers(const Geom& geom);

// Which of its materials the geom has at a contact; 0: its own.
int material_number_at(const Geom& geom, Vec3 at, Vec3 n);
inline bool has_face_materials(const Geom& geom) { return geom.material && own_material(geom)->faces; }
const dMaterial& material_at(const Geom& geom, Vec3 at, Vec3 n);

// Coefficients and drift of a manifold between the two, whose normal and points are known. x1: of body 1, to which arms
// belong.
void combine_materials(const Geom& g1, const Geom& g2, Vec3 x1, ContactManifold& manifold);

}  // namespace epode
