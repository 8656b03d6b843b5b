// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Placing a geom with an offset (p_o, R_o) at (p, R): its body gets R R_o^T and p - R_body p_o.
#include "step/common/link.h"

#include "collide/space.h"
#include "dynamics/sleep/sleeping_forces.h"
#include "dynamics/world.h"
#include "math/rotation.h"

namespace epode {
namespace {

Geom* first_geom(const Body& body) { return from_handle<Geom>(body.first_geom); }

Vec3 offset_position(const Geom& geom) { return geom.offset ? load(geom.offset->position) : Vec3{}; }

}  // namespace

void attach_geom(Geom& geom, Body* body)
{
    if (body_of(geom) != body) {
        unlink_body(geom);
        if (body) link_body(geom, {to_handle(body), body->pos, body->R, &body->first_geom});
    }
    mark_moved(geom);
}

Body* body_of(const Geom& geom) { return from_handle<Body>(geom.body.id); }

void body_moved(Body& body)
{
    for_each_geom(body, [](Geom& geom) { mark_moved(geom); });
}

void body_stepped(Body& body)
{
    for_each_geom(body, [](Geom& geom) { mark_stepped(geom); });
}

void place_body(Body& body, Vec3 position)
{
    const bool elsewhere = position != body.position();
    store(body.pos, position);
    elsewhere ? body_moved(body) : body_stepped(body);
}

void orient_body(Body& body, Quat q, const Mat3& R)
{
    const Quat before = body.orientation();
    store_quat(body.q, q);
    store_mat(body.R, R);
    note_turned(body, before);
    q != before ? body_moved(body) : body_stepped(body);
}

bool mark_members(Body& body, const Space& space)
{
    bool all = true;
    for_each_geom(body, [&](Geom& geom) { all = mark_geom(geom, space) && all; });
    return all;
}

bool list_members(const Body& body, Space& space)
{
    bool has_memory = true;
    for_each_geom(body, [&](const Geom& geom) {
        if (geom.space == &space && geom.queued) has_memory = space.queue.push(geom.slot) && has_memory;
    });
    return has_memory;
}

void disable(Body& body)
{
    body.disabled = true;
    note_forces(body);
    body.put_down = body.world->last_put_down = next_disturbance();
}

void release_geoms(Body& body)
{
    while (Geom* geom = first_geom(body)) {
        unlink_body(*geom);
        mark_moved(*geom);
    }
}

bool in_locked_space(const Body& body)
{
    for (const Geom* geom = first_geom(body); geom; geom = geom->body_next)
        if (in_locked_space(*geom)) return true;
    return false;
}

void set_geom_position(Geom& geom, Vec3 position)
{
    if (Body* body = body_of(geom)) {
        place_body(*body, position - body->rotation() * offset_position(geom));
    } else {
        const bool elsewhere = position != load(geom.own_position);
        store(geom.own_position, position);
        mark_placed(geom, elsewhere);
    }
}

bool set_geom_rotation(Geom& geom, const Mat3& R)
{
    Body* body = body_of(geom);
    if (!body) return set_geom_pose(geom, {load(geom.own_position), R});
    Mat3 given = R;
    if (geom.offset && !make_rotation(given)) return false;
    Mat3 target = geom.offset ? given * transpose(load_mat(geom.offset->rotation)) : R;
    if (!orthonormalize(target)) return false;
    const Vec3 position = pose_of(geom).p;
    Quat q = to_quat(target);
    normalize(q);
    orient_body(*body, q, target);
    set_geom_position(geom, position);
    return true;
}

bool set_geom_pose(Geom& geom, const Pose& pose)
{
    if (geom.body.id) {
        if (!set_geom_rotation(geom, pose.R)) return false;
        set_geom_position(geom, pose.p);
        return true;
    }
    Mat3 R = pose.R;
    if (!make_rotation(R)) return false;
    const bool elsewhere = pose.p != load(geom.own_position) || R != load_mat(geom.own_rotation);
    store(geom.own_position, pose.p);
    store_mat(geom.own_rotation, R);
    mark_placed(geom, elsewhere);
    return true;
}

// Without an offset the body takes q itself: through the matrix it might come back as -q.
bool set_geom_orientation(Geom& geom, Quat q)
{
    Body* body = body_of(geom);
    if (!body || geom.offset) return set_geom_rotation(geom, to_matrix(q));
    orient_body(*body, q, to_matrix(q));
    return true;
}

}  // namespace epode
