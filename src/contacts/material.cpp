// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "contacts/material.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "base/memory.h"
#include "collide/space.h"

namespace epode {
namespace {

bool usable_rule(int rule) { return rule >= dCombineDefault && rule <= dCombineMaximum; }

// A float, and times a zero still zero.
constexpr Real kMostFriction = Real(1e6);
constexpr int kMostPriority = 1'000'000;
constexpr Real kHardest = Real(1e-9), kMostRolling = Real(1e6), kSoftest = Real(1e9), kSlowest = Real(1e6);

Real combined(int rule, Real a, Real b)
{
    switch (rule) {
        case dCombineAverage:
            return Real(0.5) * a + Real(0.5) * b;
        case dCombineMinimum:
            return std::min(a, b);
        case dCombineProduct:
            return a > 0 && b > 0 ? a * b : 0;  // none against what does not slide
        default:
            return std::max(a, b);
    }
}

// The one whose coefficients count alone; null: both.
const dMaterial* foremost(const dMaterial& a, const dMaterial& b)
{
    if (a.priority == b.priority) return nullptr;
    return a.priority > b.priority ? &a : &b;
}

void combine_friction(const dMaterial& a, const dMaterial& b, ContactManifold& manifold)
{
    if (const dMaterial* const its = foremost(a, b)) {
        manifold.mu = float(std::min(its->friction, kMostFriction));
        return;
    }
    const int rule = std::max(a.friction_rule, b.friction_rule);
    const Real mu = rule == dCombineDefault ? std::sqrt(a.friction) * std::sqrt(b.friction)
                                            : combined(rule, a.friction, b.friction);
    manifold.mu = float(std::min(mu, kMostFriction));
    if (!(manifold.mu >= 0)) manifold.mu = 0;  // infinite against none
}

void combine_compliance(const dMaterial& a, const dMaterial& b, ContactManifold& manifold)
{
    const Real sum = a.compliance + b.compliance;
    manifold.compliance = sum < kHardest ? 0 : float(std::min(sum, kSoftest));
    manifold.damping_time = 0;
    if (!(manifold.compliance > 0)) return;
    const Real share = a.compliance / sum;
    manifold.damping_time = float(std::min(share * a.damping_time + (1 - share) * b.damping_time, kSlowest));
}

static_assert(kDefaultMaterial.bounce == 0 && kDefaultMaterial.rolling_friction == 0 &&
              kDefaultMaterial.compliance == 0);

void combine_others(const dMaterial& a, const dMaterial& b, ContactManifold& manifold)
{
    combine_compliance(a, b, manifold);
    if (const dMaterial* const its = foremost(a, b)) {
        manifold.restitution = float(its->bounce);
        manifold.rolling_friction = float(std::min(its->rolling_friction, kMostRolling));
        return;
    }
    manifold.restitution = float(combined(std::max(a.bounce_rule, b.bounce_rule), a.bounce, b.bounce));
    const Real rolling = combined(std::max(a.rolling_friction_rule, b.rolling_friction_rule),
                                  a.rolling_friction, b.rolling_friction);
    manifold.rolling_friction = float(std::min(rolling, kMostRolling));
}

Vec3 surface_velocity(const Geom& geom)
{
    if (!geom.material) return {};
    return load_mat(geom.rotation) * load(geom.material->surface_velocity);
}

const Real kDefaultMu = std::sqrt(kDefaultMaterial.friction) * std::sqrt(kDefaultMaterial.friction);

// Both are the default's.
void take_defaults(ContactManifold& manifold)
{
    manifold.mu = float(kDefaultMu);
    manifold.restitution = manifold.rolling_friction = manifold.compliance = manifold.damping_time = 0;
    manifold.restitution_threshold = float(kDefaultMaterial.bounce_speed);
    manifold.surface_velocity = {};
}

bool same(const dMaterial& a, const dMaterial& b)
{
    const auto fields = [](const dMaterial& m) {
        return std::tie(m.friction, m.bounce, m.bounce_speed, m.rolling_friction, m.compliance,
                        m.damping_time, m.friction_rule, m.bounce_rule, m.rolling_friction_rule, m.priority);
    };
    return fields(a) == fields(b) && load(a.surface_velocity) == load(b.surface_velocity);
}

}  // namespace

bool usable_material(const dMaterial& m)
{
    if (!usable_rule(m.friction_rule) || !usable_rule(m.bounce_rule) || !usable_rule(m.rolling_friction_rule))
        return false;
    if (m.priority < -kMostPriority || m.priority > kMostPriority) return false;
    for (const Real x : {m.rolling_friction, m.compliance, m.damping_time})
        if (!(x >= 0) || !usable(x)) return false;
    return m.friction >= 0 && usable_or_infinite(m.friction) && m.bounce >= 0 && m.bounce <= 1 &&
           m.bounce_speed >= 0 && usable_or_infinite(m.bounce_speed) && usable(m.surface_velocity, 3);
}

bool set_material(Geom& geom, const dMaterial* material)
{
    const dMaterial& wanted = material ? *material : kDefaultMaterial;
    if (!same(wanted, material_of(geom))) note_rules_changed(geom);
    if (!material) {
        drop_material(geom);
        return true;
    }
    if (!geom.material) geom.material = static_cast<dMaterial*>(allocate(sizeof(dMaterial)));
    if (!geom.material) return false;
    *geom.material = *material;
    return true;
}

void combine_materials(const Geom& g1, const Geom& g2, ContactManifold& manifold)
{
    if (!g1.material && !g2.material) return take_defaults(manifold);
    const dMaterial &a = material_of(g1), &b = material_of(g2);
    combine_friction(a, b, manifold);
    combine_others(a, b, manifold);
    manifold.restitution_threshold = float(std::max(a.bounce_speed, b.bounce_speed));
    // Surfaces do not slide against each other: v1 + s1 = v2 + s2.
    const Vec3 drift = surface_velocity(g2) - surface_velocity(g1), n = widen(manifold.normal);
    manifold.surface_velocity = narrow(drift - dot(n, drift) * n);
}

}  // namespace epode
