// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A world as a setting says, and words for building in it. Surfaces are materials of geoms; where contacts are
// joints of a near callback, the callback combines the materials as the world would (ode/contacts.h).
// Only the public headers. Boxes have full side lengths, capsules and cylinders lie along their local z.
#pragma once

#include "scenes/vectors.h"
#include "trial.h"

#include <ode/ext.h>
#include <ode/ode.h>

#include <deque>
#include <vector>

namespace epode::trials {

using scenes::cross;
using scenes::dot;
using scenes::inverse;
using scenes::kPi;
using scenes::kX;
using scenes::kY;
using scenes::kZ;
using scenes::Lcg;
using scenes::length;
using scenes::rotate;
using scenes::Turn;
using scenes::turn;
using scenes::Vec;

inline Vec vec(const dReal* p) { return {double(p[0]), double(p[1]), double(p[2])}; }
inline Vec position(dBodyID body) { return vec(dBodyGetPosition(body)); }
inline Vec velocity(dBodyID body) { return vec(dBodyGetLinearVel(body)); }
inline Vec spin(dBodyID body) { return vec(dBodyGetAngularVel(body)); }
Turn orientation(dBodyID body);
void set_velocity(dBodyID body, Vec linear, Vec angular = {});

constexpr double kGravity = 9.81;

// A point of contact of the last step with its force on body1, N.
struct Touch {
    dBodyID body1, body2;  // body2 is null for what has no body
    Vec pos, normal, force;
    double normal_force;
};

class Stage {
  public:
    // step_size: another than the setting's.
    explicit Stage(const Setting& where, Vec gravity = {0, 0, -kGravity}, double step_size = 0);
    explicit Stage(const Run& run, Vec gravity = {0, 0, -kGravity}) : Stage(run.setting, gravity) {}
    ~Stage();
    Stage(const Stage&) = delete;
    Stage& operator=(const Stage&) = delete;

    // Takes another world and its space in place of its own.
    void adopt(dWorldID other, dSpaceID its_space);
    void step();
    int steps_in(double seconds) const { return int(seconds / h + 0.5); }
    void advance(double seconds)
    {
        advance(seconds, [] {});
    }
    template <class AfterStep>
    void advance(double seconds, AfterStep after_step)
    {
        for (int i = steps_in(seconds); i-- > 0;) {
            step();
            after_step();
        }
    }

    // Bodies with one geom and its mass, with the surface at hand.
    dBodyID body(dGeomID geom, dMass mass, Vec at, Turn q = {});
    dBodyID box(Vec size, double mass, Vec at, Turn q = {});
    dBodyID ball(double radius, double mass, Vec at);
    dBodyID capsule(double radius, double length, double mass, Vec at, Turn q = {});
    dBodyID cylinder(double radius, double length, double mass, Vec at, Turn q = {});
    // Without a geom.
    dBodyID part(dMass mass, Vec at, Turn q = {});
    dBodyID bar(Vec size, double mass, Vec at, Turn q = {});

    // Static geoms.
    dGeomID floor();
    dGeomID block(Vec size, Vec at, Turn q = {});
    dGeomID place(dGeomID geom, Vec at = {}, Turn q = {});

    // Joints. body2 may be null: the world.
    dJointID ball_joint(dBodyID body1, dBodyID body2, Vec at);
    dJointID hinge(dBodyID body1, dBodyID body2, Vec at, Vec axis);
    dJointID fix(dBodyID body1, dBodyID body2);

    // For things of a few centimetres: no surface layer of a millimetre (docs/guide/defaults.md).
    void toys() { dWorldSetContactSurfaceLayer(world, 0); }
    // The overlap that contacts may keep (docs/guide/world_contacts.md), m.
    double layer() const;
    // Points of contact of the last step; want_touches() before it.
    void want_touches() { wants_touches_ = true; }
    std::vector<Touch> touches() const;

    const Setting setting;
    const double h;
    const bool callback;  // contacts are joints
    dWorldID world;
    dSpaceID space;
    dMaterial surface;        // of geoms that come
    bool bodies_meet = true;  // false: bodies that come touch static geoms alone

  private:
    static void near_callback(void* stage, dGeomID geom1, dGeomID geom2);
    void collide(dGeomID geom1, dGeomID geom2);
    dSurfaceParameters combined(dGeomID geom1, dGeomID geom2, dContact& contact) const;
    void finish(dGeomID geom, dBodyID body);

    dJointGroupID contacts_;
    bool wants_touches_ = false;
    std::vector<Touch> made_;
    std::deque<dJointFeedback> feedback_;
};

}  // namespace epode::trials
