// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Placing a geom that has an offset o on its body: body = pose * o^-1, so that body * o = pose.
#include "step/link.h"

#include "math/rotation.h"

namespace epode {
namespace {

Geom* first_geom(const Body& body) { return from_handle<Geom>(body.first_geom); }

Pose inverse(const Pose& pose)
{
    const Mat3 Rt = transpose(pose.R);
    return {-(Rt * pose.p), Rt};
}

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
    for (Geom* geom = first_geom(body); geom; geom = geom->body_next) mark_moved(*geom);
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

void place_geom(Geom& geom, const Pose& pose)
{
    Body* body = body_of(geom);
    if (!body) {
        write_own_pose(geom, pose);
        return;
    }
    const Pose target =
        geom.offset ? pose * inverse(load_pose(geom.offset->position, geom.offset->rotation)) : pose;
    store(body->pos, target.p);
    Mat3 R = target.R;
    Quat q;
    if (orthonormalize(R) && normalize(q = to_quat(R))) set_orientation(*body, q);
    body_moved(*body);
}

}  // namespace epode
