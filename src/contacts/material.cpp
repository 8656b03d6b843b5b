// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "contacts/material.h"

#include <algorithm>
#include <cmath>

#include "base/memory.h"

namespace epode {
namespace {

// A float, and times a zero still zero.
constexpr Real kMostFriction = Real(1e6);

Vec3 surface_velocity(const Geom& geom)
{
    if (!geom.material) return {};
    return load_mat(geom.rotation) * load(geom.material->velocity);
}

}  // namespace

bool set_material(Geom& geom, const dMaterial* material)
{
    if (!material) {
        drop_material(geom);
        return true;
    }
    if (!geom.material) geom.material = static_cast<dMaterial*>(allocate(sizeof(dMaterial)));
    if (!geom.material) return false;
    *geom.material = *material;
    return true;
}

void combine_materials(const Geom& g1, const Geom& g2, Patch& patch)
{
    const dMaterial &a = material_of(g1), &b = material_of(g2);
    patch.mu = float(std::min(std::sqrt(a.friction) * std::sqrt(b.friction), kMostFriction));
    if (!(patch.mu >= 0)) patch.mu = 0;  // none against what does not slide
    patch.bounce = float(std::max(a.bounce, b.bounce));
    patch.bounce_speed = float(std::max(a.bounce_speed, b.bounce_speed));
    patch.drift = {};
    if (!g1.material && !g2.material) return;
    // Surfaces do not slide against each other: v1 + s1 = v2 + s2.
    const Vec3 drift = surface_velocity(g2) - surface_velocity(g1), n = widen(patch.normal);
    patch.drift = narrow(drift - dot(n, drift) * n);
}

}  // namespace epode
