// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Birth, death and invariants of bodies: q is a unit quaternion and R its matrix, inv_mass and inv_inertia
// are zero for a kinematic body and the inverses of the stored mass otherwise.
#include "dynamics/body.h"

#include "base/objects/pool.h"
#include "base/objects/structure_edition.h"
#include "base/streams/content_hash.h"
#include "dynamics/active.h"
#include "dynamics/forces/vehicle.h"
#include "dynamics/joint.h"
#include "dynamics/sleep/sleeping_forces.h"
#include "dynamics/world.h"

namespace epode {
namespace {

dMass unit_mass()
{
    dMass m{};
    m.mass = m.I[0] = m.I[5] = m.I[10] = 1;
    return m;
}

std::uint64_t hash_of(const dMass& mass)
{
    ContentHash hash;
    hash.add(mass.mass);
    for (int row = 0; row < 3; ++row) hash.add(mass.I + 4 * row, 3);
    return hash.value();
}

// Sylvester's criterion, relative to the size of the entries.
bool positive_definite(const Sym3& s)
{
    const Real minor2 = s.xx * s.yy - s.xy * s.xy;
    const Real minor3 = determinant(full(s));
    const Real size = max_component({s.xx, s.yy, s.zz});
    return s.xx > 0 && s.yy > 0 && s.zz > 0 && minor2 > 0 && minor3 > 0 && size < kInf;
}

}  // namespace

Body::Body(World& w) : Numbered(Tag::kBody), world(&w), mass(unit_mass())
{
    mass_hash = hash_of(mass);
    watch(*this, w.auto_disable);
    sleep = w.sleep;
    damping = w.damping;
    max_angular_speed = w.max_angular_speed;
    idle_steps_left = sleep.steps;
    idle_time_left = sleep.time;
}

Body::~Body() { drop_vehicle(*this); }

Body* create_body(World& world)
{
    Body* body = Pool<Body>::create(world);
    if (!body) return nullptr;
    if (!set_sleep_samples(*body, world.sleep.samples) || !world.bodies.join(*body)) {
        Pool<Body>::destroy(body);
        return nullptr;
    }
    body->serial = ++world.bodies_made;
    note_structure_changed();
    return body;
}

void destroy_body(Body& body)
{
    while (body.joints) detach(*body.joints->joint);
    forget_forces(body);
    body.world->bodies.leave(body);
    note_structure_changed();
    Pool<Body>::destroy(&body);
}

void set_orientation(Body& body, Quat unit)
{
    store_quat(body.q, unit);
    store_mat(body.R, to_matrix(unit));
}

bool set_mass(Body& body, const dMass& mass)
{
    const Sym3 inertia = symmetric_part(load_mat(mass.I));
    Mat3 inverse;
    if (!usable(mass.mass) || !(mass.mass > 0) || !usable(mass.c, 3) || !usable(mass.I, 12)) return false;
    if (max_component(abs(load(mass.c))) > kEpsilon || !positive_definite(inertia)) return false;
    if (!invert(full(inertia), inverse)) return false;
    if (body.driven) activate(body);  // another rule for its contacts
    body.mass = mass;
    if (const std::uint64_t hash = hash_of(mass); hash != body.mass_hash)
        body.mass_hash = hash, note_structure_changed();
    body.inertia = inertia;
    body.driven = false;
    body.inv_mass = 1 / mass.mass;
    body.inv_inertia = symmetric_part(inverse);
    body.spin_excess = {};
    return true;
}

void set_kinematic(Body& body)
{
    activate(body);  // as above
    body.driven = true;
    body.inv_mass = 0;
    body.inv_inertia = Sym3{};
}

void set_dynamic(Body& body)
{
    const dMass stored = body.mass;
    set_mass(body, stored);
}

void watch(Body& body, bool on)
{
    body.auto_disable = on;
    if (on) body.world->watches_bodies = true;
}

// Switching it off also wakes the body and takes the idle rules of the world again, as ODE does.
bool set_auto_disable(Body& body, bool on)
{
    if (!on) {
        if (!set_sleep_samples(body, body.world->sleep.samples)) return false;
        enable(body);
        body.sleep.steps = body.world->sleep.steps;
        body.sleep.time = body.world->sleep.time;
    }
    watch(body, on);
    return true;
}

bool set_sleep_samples(Body& body, int samples)
{
    Array<Vec3> v, w;
    if (!v.resize(samples) || !w.resize(samples)) return false;
    body.sample_v.swap(v);
    body.sample_w.swap(w);
    body.sleep.samples = samples;
    body.sample_next = 0;
    body.samples_ready = false;
    return true;
}

void enable(Body& body)
{
    body.disabled = false;
    activate(body);
}

void wake(Body& body)
{
    enable(body);
    body.idle_steps_left = body.sleep.steps;
    body.idle_time_left = body.sleep.time;
    forget_stillness(body);
}

void forget_stillness(Body& body)
{
    body.short_window.time = body.long_window.time = body.settling_time = 0;
    body.short_window.still = body.long_window.still = false;
}

bool is_sleeper(const Body& body)
{
    return body.disabled && body.auto_disable && body.world->wakes_sleepers();
}

void wake_sleeper(Body& body)
{
    if (is_sleeper(body)) wake(body);
}

void wake_if_driven(Body& body)
{
    if (!body.kinematic()) return;
    if (body.velocity() != Vec3() || body.angular_velocity() != Vec3()) wake_sleeper(body);
}

}  // namespace epode
