// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "contacts/material.h"

#include <algorithm>
#include <cmath>
#include <new>
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

float combined_friction(const dMaterial& a, const dMaterial& b, Real mu_a, Real mu_b)
{
    if (const dMaterial* const its = foremost(a, b))
        return float(std::min(its == &a ? mu_a : mu_b, kMostFriction));
    const int rule = std::max(a.friction_rule, b.friction_rule);
    const Real mu = rule == dCombineDefault ? std::sqrt(mu_a) * std::sqrt(mu_b) : combined(rule, mu_a, mu_b);
    const float bounded = float(std::min(mu, kMostFriction));
    return bounded >= 0 ? bounded : 0;  // infinite against none
}

void combine_friction(const dMaterial& a, const dMaterial& b, ContactManifold& manifold)
{
    manifold.mu = combined_friction(a, b, a.friction, b.friction);
    manifold.friction_axis = {}, manifold.cross_mu = manifold.mu;
    manifold.max_impulse = float(kInf);
}

// A surface seen in the contact plane.
struct Grain {
    Vec3 axis;  // unit, or zero
    Real along, across;

    Grain(const Geom& geom, const dMaterial& m, Vec3 n)
        : along(std::min(m.friction, kMostFriction)), across(along)
    {
        const Vec3 own = load(m.friction_axis);
        if (own == Vec3{}) return;
        const Vec3 a = load_mat(geom.rotation) * own, seen = a - dot(a, n) * n;
        constexpr Real kUpright = Real(1e-3);  // the sine of an angle
        if (!(length2(seen) > kUpright * kUpright * length2(a))) return;
        axis = normalized_or(seen, {}), across = std::min(m.cross_friction, kMostFriction);
    }
    bool has_axis() const { return axis != Vec3{} && along != across; }
    // What takes most power out of a slip along the unit vector d brakes it with this.
    Real seen_along(Vec3 d, Vec3 n) const
    {
        if (!has_axis()) return along;
        const Real x = along * dot(d, axis), y = across * dot(d, cross(n, axis));
        return std::sqrt(x * x + y * y);
    }
    bool differs_more_than(const Grain& o) const
    {
        return std::max(along, across) * std::min(o.along, o.across) >=
               std::max(o.along, o.across) * std::min(along, across);
    }
};

// Both directions of the surface that differs more, if one of the two has an axis there.
void combine_axes(const Geom& g1, const dMaterial& a, const Geom& g2, const dMaterial& b,
                  ContactManifold& manifold)
{
    const Vec3 n = widen(manifold.normal);
    const Grain one(g1, a, n), two(g2, b, n);
    const bool first = !two.has_axis() || (one.has_axis() && one.differs_more_than(two));
    const Vec3 along = first ? one.axis : two.axis, across = cross(n, along);
    if (!(first ? one : two).has_axis()) return;
    const auto mu = [&](Vec3 d) {
        return combined_friction(a, b, one.seen_along(d, n), two.seen_along(d, n));
    };
    manifold.mu = mu(along), manifold.cross_mu = mu(across);
    if (manifold.mu != manifold.cross_mu) manifold.friction_axis = narrow(along);
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

Vec3 surface_velocity(const Geom& geom, const dMaterial& material)
{
    if (&material == &kDefaultMaterial) return {};
    return load_mat(geom.rotation) * load(material.surface_velocity);
}

bool has_axis(const dMaterial& m) { return load(m.friction_axis) != Vec3{}; }

const Real kDefaultMu = std::sqrt(kDefaultMaterial.friction) * std::sqrt(kDefaultMaterial.friction);

// Both are the default's.
void take_defaults(ContactManifold& manifold)
{
    manifold.mu = float(kDefaultMu);
    manifold.restitution = manifold.rolling_friction = manifold.compliance = manifold.damping_time = 0;
    manifold.restitution_threshold = float(kDefaultMaterial.bounce_speed);
    manifold.surface_velocity = manifold.friction_axis = {};
    manifold.cross_mu = manifold.mu, manifold.max_impulse = float(kInf);
}

bool same(const dMaterial& a, const dMaterial& b)
{
    const auto fields = [](const dMaterial& m) {
        return std::tie(m.friction, m.bounce, m.bounce_speed, m.rolling_friction, m.compliance,
                        m.damping_time, m.friction_rule, m.bounce_rule, m.rolling_friction_rule, m.priority,
                        m.cross_friction, m.kind);
    };
    return fields(a) == fields(b) && load(a.surface_velocity) == load(b.surface_velocity) &&
           load(a.friction_axis) == load(b.friction_axis);
}

}  // namespace

bool usable_material(const dMaterial& m)
{
    if (!usable_rule(m.friction_rule) || !usable_rule(m.bounce_rule) || !usable_rule(m.rolling_friction_rule))
        return false;
    if (m.priority < -kMostPriority || m.priority > kMostPriority) return false;
    if (m.kind < 0 || m.kind > kMostFaceMaterials) return false;
    for (const Real x : {m.rolling_friction, m.compliance, m.damping_time})
        if (!(x >= 0) || !usable(x)) return false;
    return m.friction >= 0 && usable_or_infinite(m.friction) && m.cross_friction >= 0 &&
           usable_or_infinite(m.cross_friction) && usable(m.friction_axis, 3) && m.bounce >= 0 &&
           m.bounce <= 1 && m.bounce_speed >= 0 && usable_or_infinite(m.bounce_speed) &&
           usable(m.surface_velocity, 3);
}

namespace {

// Null: out of memory. A new one is the default's.
GeomMaterial* made_material(Geom& geom)
{
    if (geom.material) return own_material(geom);
    void* const memory = allocate(sizeof(GeomMaterial));
    if (!memory) return nullptr;
    GeomMaterial* const made = new (memory) GeomMaterial;
    static_cast<dMaterial&>(*made) = kDefaultMaterial;
    geom.material = made;
    return made;
}

FaceMaterials* made_faces(Geom& geom)
{
    GeomMaterial* const own = made_material(geom);
    if (!own || own->faces) return own ? own->faces : nullptr;
    void* const memory = allocate(sizeof(FaceMaterials));
    if (memory) own->faces = new (memory) FaceMaterials;
    return own->faces;
}

const FaceMaterials* faces_of(const Geom& geom)
{
    return geom.material ? own_material(geom)->faces : nullptr;
}

}  // namespace

bool set_material(Geom& geom, const dMaterial* material)
{
    const dMaterial& wanted = material ? *material : kDefaultMaterial;
    if (!same(wanted, material_of(geom))) note_rules_changed(geom);
    if (!material && !has_face_materials(geom)) {
        drop_material(geom);
        return true;
    }
    GeomMaterial* const own = made_material(geom);
    if (!own) return false;
    static_cast<dMaterial&>(*own) = wanted;
    own->is_given = material != nullptr;
    return true;
}

bool set_face_material(Geom& geom, int number, const dMaterial* material)
{
    if (!material && !has_face_materials(geom)) return true;
    FaceMaterials* const faces = made_faces(geom);
    if (!faces) return false;
    const int size = std::max(number, faces->materials.size());
    if (!faces->materials.resize(size) || !faces->given.resize(size)) return false;
    faces->given[number - 1] = material != nullptr;
    if (material) faces->materials[number - 1] = *material;
    note_rules_changed(geom);
    return true;
}

bool set_face_numbers(Geom& geom, std::span<const unsigned char> numbers)
{
    if (numbers.empty() && !has_face_materials(geom)) return true;
    FaceMaterials* const faces = made_faces(geom);
    if (!faces || !faces->numbers.resize(int(numbers.size()))) return false;
    std::copy(numbers.begin(), numbers.end(), faces->numbers.begin());
    note_rules_changed(geom);
    return true;
}

bool has_face_material(const Geom& geom, int number)
{
    const FaceMaterials* const faces = faces_of(geom);
    return faces && number >= 1 && number <= faces->given.size() && faces->given[number - 1];
}

const dMaterial& face_material(const Geom& geom, int number)
{
    return has_face_material(geom, number) ? faces_of(geom)->materials[number - 1] : kDefaultMaterial;
}

std::span<const unsigned char> face_numbers(const Geom& geom)
{
    const FaceMaterials* const faces = faces_of(geom);
    return faces ? faces->numbers.span() : std::span<const unsigned char>();
}

int material_number_at(const Geom& geom, Vec3 at, Vec3 n)
{
    const FaceMaterials* const faces = faces_of(geom);
    if (!faces || faces->numbers.empty()) return 0;
    const int face = face_at(geom, at, n);
    const int number = face >= 0 && face < faces->numbers.size() ? faces->numbers[face] : 0;
    return has_face_material(geom, number) ? number : 0;
}

const dMaterial& material_at(const Geom& geom, Vec3 at, Vec3 n)
{
    const int number = has_face_materials(geom) ? material_number_at(geom, at, n) : 0;
    return number > 0 ? own_material(geom)->faces->materials[number - 1] : material_of(geom);
}

namespace {

void combine(const Geom& g1, const dMaterial& a, const Geom& g2, const dMaterial& b,
             ContactManifold& manifold)
{
    combine_friction(a, b, manifold);
    if (has_axis(a) || has_axis(b)) combine_axes(g1, a, g2, b, manifold);
    combine_others(a, b, manifold);
    manifold.restitution_threshold = float(std::max(a.bounce_speed, b.bounce_speed));
}

// The geom's material against the other one's kind; null: none of its own.
const dMaterial* against(const Geom& geom, const dMaterial& other)
{
    return has_face_material(geom, other.kind) ? &face_material(geom, other.kind) : nullptr;
}

// Where both have one: of the larger priority, of the smaller friction where that is the same.
bool first_counts(const dMaterial* one, const dMaterial* two)
{
    if (!one || !two) return one;
    if (const dMaterial* const its = foremost(*one, *two)) return its == one;
    return one->friction <= two->friction;
}

// False: neither has one against the other.
bool combine_as_pair(const Geom& g1, const dMaterial& a, const Geom& g2, const dMaterial& b,
                     ContactManifold& manifold)
{
    const dMaterial *const one = against(g1, b), *const two = against(g2, a);
    if (!one && !two) return false;
    const bool first = first_counts(one, two);
    dMaterial alone = first ? *one : *two, none = kDefaultMaterial;
    alone.priority = kMostPriority + 1, none.bounce_speed = 0;
    first ? combine(g1, alone, g2, none, manifold) : combine(g1, none, g2, alone, manifold);
    return true;
}

}  // namespace

void combine_materials(const Geom& g1, const Geom& g2, Vec3 x1, ContactManifold& manifold)
{
    if (!g1.material && !g2.material) return take_defaults(manifold);
    const Vec3 n = widen(manifold.normal), at = x1 + widen(manifold.points[0].r1);
    const dMaterial &a = material_at(g1, at, n), &b = material_at(g2, at, n);
    const bool may_be_pair = a.kind != 0 || b.kind != 0;
    if (!may_be_pair || !combine_as_pair(g1, a, g2, b, manifold)) combine(g1, a, g2, b, manifold);
    // Surfaces do not slide against each other: v1 + s1 = v2 + s2.
    const Vec3 drift = surface_velocity(g2, b) - surface_velocity(g1, a);
    manifold.surface_velocity = narrow(drift - dot(n, drift) * n);
}

}  // namespace epode
