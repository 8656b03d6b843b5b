// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Words for building scenes: a body with its shape and mass in one call, static shapes, joints that are
// recorded for measuring. Densities in kg/m3, sizes in metres, angles in radians. Boxes by full side lengths,
// capsules and cylinders along their local z.
#pragma once

#include "scenes/scene.h"
#include "scenes/vectors.h"

namespace epode::scenes {

// Dynamic bodies: one geom, its mass, one pose.
dBodyID add_body(Scene& scene, dGeomID geom, const dMass& mass, Vec pos, Turn q = {});
dBodyID add_sphere(Scene& scene, double radius, double density, Vec pos);
dBodyID add_box(Scene& scene, Vec size, double density, Vec pos, Turn q = {});
dBodyID add_capsule(Scene& scene, double radius, double length, double density, Vec pos, Turn q = {});
dBodyID add_cylinder(Scene& scene, double radius, double length, double density, Vec pos, Turn q = {});
// A capsule from one point to another, its caps included.
dBodyID add_limb(Scene& scene, double radius, double density, Vec from, Vec to);

// One more geom on a body, without mass, at a pose relative to it.
dGeomID attach_box(Scene& scene, dBodyID body, Vec size, Vec offset, Turn q = {});
dGeomID attach_sphere(Scene& scene, dBodyID body, double radius, Vec offset);
dGeomID attach_cylinder(Scene& scene, dBodyID body, double radius, double length, Vec offset, Turn q = {});

// Static shapes.
dGeomID add_ground(Scene& scene, double height = 0);
// A floor to look at: nothing touches it.
dGeomID add_floor(Scene& scene, double height = 0);
dGeomID add_static_box(Scene& scene, Vec size, Vec pos, Turn q = {});
// Four thick walls around the origin; inner sides 2*half_x by 2*half_y.
void add_pit(Scene& scene, double half_x, double half_y, double height);

void set_velocity(dBodyID body, Vec linear, Vec angular = {});
// What a body touches: its geoms have category `category` and meet only categories in `collide`.
void set_bits(dBodyID body, unsigned long category, unsigned long collide);

// Joints. body2 may be null: the world.
dJointID add_ball(Scene& scene, dBodyID body1, dBodyID body2, Vec anchor);
dJointID add_hinge(Scene& scene, dBodyID body1, dBodyID body2, Vec anchor, Vec axis);
dJointID add_universal(Scene& scene, dBodyID body1, dBodyID body2, Vec anchor, Vec axis1, Vec axis2);
dJointID add_hinge2(Scene& scene, dBodyID body1, dBodyID body2, Vec anchor, Vec axis1, Vec axis2);
dJointID add_slider(Scene& scene, dBodyID body1, dBodyID body2, Vec axis);
void set_hinge_stops(dJointID joint, double low, double high);
void set_universal_stops(dJointID joint, double low1, double high1, double low2, double high2);

void set_view(Scene& scene, Vec eye, Vec target);

}  // namespace epode::scenes
