// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The only file that knows both bodies and geoms. A body holds the head of a list of geoms and never looks
// into it; a geom holds pointers to its body's pose and never asks whose they are.
#pragma once

#include "base/prefetch.h"
#include "collide/geom.h"
#include "dynamics/body.h"

namespace epode {

// Puts the geom on another body, or on none: then it keeps its pose in the world. A new body drops the
// offset.
void attach_geom(Geom& geom, Body* body);

Body* body_of(const Geom& geom);

// visit(geom) for every geom of the body, newest first; they stay its geoms meanwhile.
template <typename Visit>
void for_each_geom(const Body& body, Visit&& visit)
{
    for_each_geom_from(body.first_geom, visit);
}

// The body's pose has changed: its geoms are marked. Costs a few instructions per geom. Not to be called from
// several threads at once for bodies whose geoms share a space.
void body_moved(Body& body);
// The same by a step.
void body_stepped(Body& body);
// The program sets the pose; the matrix is that of q.
void place_body(Body& body, Vec3 position);
void orient_body(Body& body, Quat q, const Mat3& R);
// And by any worker, for a body whose geoms are all members of the space, in their own right; false if
// they are not. When all bodies have been told of, note_geoms_marked() must follow.
bool mark_members(Body& body, const Space& space);
// Lists the members among its geoms that have been marked; note_geoms_marked() need not follow then. False:
// there was no memory, and it must.
[[nodiscard]] bool list_members(const Body& body, Space& space);
// body_moved() is about to be called.
inline void prefetch_geoms(const Body& body) { prefetch<2>(body.first_geom); }

// The program disables it: what happens to its support before the next step does not wake it.
void disable(Body& body);

// The body is about to go: its geoms stay where they are.
void release_geoms(Body& body);

// Whether a geom of the body lies in a space that is being collided, so that the body must not be moved.
bool in_locked_space(const Body& body);

// Moves the geom, or its body so that the geom gets there; the other half of the geom's pose stays. A matrix that is
// no rotation is made one, if it can be (false: nothing has changed).
void set_geom_position(Geom& geom, Vec3 position);
bool set_geom_rotation(Geom& geom, const Mat3& R);
bool set_geom_pose(Geom& geom, const Pose& pose);  // both
bool set_geom_orientation(Geom& geom, Quat q);     // of unit length if the geom is on a body

}  // namespace epode
