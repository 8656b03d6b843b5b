// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What all geoms share: pose, box, queueing, body list, end of life.
#include "collide/geom.h"

#include <algorithm>
#include <atomic>
#include <new>

#include "base/memory.h"
#include "base/objects/structure_edition.h"
#include "collide/character.h"
#include "collide/geom_leaves.h"
#include "collide/space.h"
#include "collide/transform.h"
#include "ode/contacts.h"
#include "ode/shapes.h"
#include "simd/quad.h"

namespace epode {
namespace {

std::atomic<std::uint64_t> g_serial{0};
std::atomic<int> g_continuous{0};  // geoms with dContinuousOn
std::atomic<int> g_sensors{0};

void use_own_pose(Geom& geom)
{
    geom.position = geom.own_position;
    geom.rotation = geom.own_rotation;
}

}  // namespace

Geom::Geom(const GeomType& geom_type)
    : Numbered(Tag::kGeom), type(&geom_type), position(own_position), rotation(own_rotation)
{
    serial = g_serial.fetch_add(1, std::memory_order_relaxed) + 1;
}

std::uint64_t newest_geom_serial() { return g_serial.load(std::memory_order_relaxed); }

bool is_held(const Geom& geom)
{
    if (geom.users.load(std::memory_order_relaxed) == 0) return false;
    CallGuard::release_left();
    return geom.users.load(std::memory_order_relaxed) > 0;
}

bool is_dying(const Geom& geom)
{
    if (geom.dying) CallGuard::release_left();
    return geom.dying;
}

bool in_locked_space(const Geom& geom) { return geom.space && is_locked(*geom.space); }

void refresh_pose(Geom& geom)
{
    if (!geom.pose_stale) return;
    geom.pose_stale = false;
    const Real *R = geom.body.rotation, *by = geom.offset->rotation;
    const Pose body = load_pose(geom.body.position, R);
    store(geom.own_position, body.to_world(load(geom.offset->position)));
    const Quad x = load_quad(by), y = load_quad(by + 4), z = load_quad(by + 8);
    for (int i = 0; i < 12; i += 4) {
        const Quad row = x * quad(R[i]) + y * quad(R[i + 1]) + z * quad(R[i + 2]);
        store_quad(geom.own_rotation + i, quad(lane(row, 0), lane(row, 1), lane(row, 2), 0));
    }
}

void refresh_box(Geom& geom)
{
    if (!geom.box_stale) return;
    refresh_pose(geom);
    geom.box_stale = false;
    // Made in its place: a copy of what has just been written number by number would wait for it.
    new (&geom.box) Aabb(geom.type->aabb(geom));
}

// Whether it is queued or not: that depends on who has looked at the space before, and states do not tell.
void note_moved(Geom& geom)
{
    if (geom.watched && geom.space) note_disturbed(*geom.space, geom);
    for (TransformGeom* holder = geom.holders; holder; holder = holder->next_holder) note_moved(*holder);
}

void mark_moved(Geom& geom)
{
    mark_stepped(geom);
    note_moved(geom);
}

void mark_stepped(Geom& geom)
{
    geom.pose_stale = geom.offset != nullptr;
    for (TransformGeom* holder = geom.holders; holder; holder = holder->next_holder) mark_stepped(*holder);
    // A queued member implies that everything above it is queued and stale already.
    for (Geom* g = &geom;; g = g->space) {
        g->box_stale = true;
        if (!g->space || g->queued) return;
        enqueue(*g->space, *g);
    }
}

void mark_changed(Geom& geom)
{
    ++geom.changes;
    note_structure_changed();
    for (TransformGeom* holder = geom.holders; holder; holder = holder->next_holder) mark_changed(*holder);
    mark_moved(geom);
}

void set_continuous(Geom& geom, int mode)
{
    const int change = (mode == dContinuousOn) - (geom.continuous == dContinuousOn);
    if (change) g_continuous.fetch_add(change, std::memory_order_relaxed);
    geom.continuous = std::uint8_t(mode);
}

void set_sensor(Geom& geom, bool on)
{
    if (geom.sensor == on) return;
    geom.sensor = on;
    g_sensors.fetch_add(on ? 1 : -1, std::memory_order_relaxed);
    note_rules_changed(geom);
    note_structure_changed();
}

bool any_sensor() { return g_sensors.load(std::memory_order_relaxed) > 0; }

bool any_continuous() { return g_continuous.load(std::memory_order_relaxed) > 0; }

void link_body(Geom& geom, const BodyLink& link)
{
    note_structure_changed();
    geom.body = link;
    geom.position = link.position;
    geom.rotation = link.rotation;
    geom.body_prev = nullptr;
    geom.body_next = from_handle<Geom>(*link.first_geom);
    if (geom.body_next) geom.body_next->body_prev = &geom;
    *link.first_geom = to_handle(&geom);
}

void unlink_body(Geom& geom)
{
    if (!geom.body.id) return;
    note_structure_changed();
    const Pose pose = pose_of(geom);
    drop_offset(geom);
    if (geom.body_next) geom.body_next->body_prev = geom.body_prev;
    if (geom.body_prev)
        geom.body_prev->body_next = geom.body_next;
    else
        *geom.body.first_geom = to_handle(geom.body_next);
    geom.body_next = geom.body_prev = nullptr;
    geom.body = {};
    store(geom.own_position, pose.p);
    store_mat(geom.own_rotation, pose.R);
    use_own_pose(geom);
}

bool ensure_offset(Geom& geom)
{
    if (geom.offset) return true;
    void* memory = allocate(sizeof(GeomOffset));
    if (!memory) return false;
    geom.offset = new (memory) GeomOffset;
    note_structure_changed();
    geom.pose_stale = true;
    use_own_pose(geom);
    return true;
}

void drop_offset(Geom& geom)
{
    if (!geom.offset) return;
    note_structure_changed();
    release(geom.offset, sizeof(GeomOffset));
    geom.offset = nullptr;
    geom.pose_stale = false;
    geom.position = geom.body.position;
    geom.rotation = geom.body.rotation;
}

namespace {

void stay(void* geom, const void*, std::size_t) { static_cast<Geom*>(geom)->dying = false; }

// Whatever the program does to the geom in its function is undone afterwards. If that leaves, the geom stays.
void take_leave(Geom& geom)
{
    CallGuard guard(geom.type->farewell || is_space(geom) ? stay : nullptr, &geom);
    geom.dying = true;
    if (geom.type->farewell) geom.type->farewell(geom);
    if (is_space(geom)) empty_space(static_cast<Space&>(geom));
    (void)guard.end();
}

}  // namespace

void destroy_geom(Geom& geom)
{
    if (geom.dying) return;
    note_structure_changed();
    take_leave(geom);
    set_continuous(geom, dContinuousOff);
    set_sensor(geom, false);
    while (geom.holders) set_transform_geom(*geom.holders, nullptr);
    if (geom.space) remove_geom(*geom.space, geom);
    unlink_body(geom);
    drop_material(geom);
    drop_character(geom);
    drop_leaves(geom);
    geom.type->destroy(&geom);
}

}  // namespace epode
