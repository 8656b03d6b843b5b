// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "stage.h"

#include <algorithm>

namespace epode::trials {

namespace {

int preset_of(Method method)
{
    if (method == Method::kGame) return dDefaultsGame;
    return method == Method::kRobot ? dDefaultsRobot : dDefaultsOde;
}

// As docs/guide/sleeping.md recommends; the game preset has the same values.
void let_sleep(dWorldID world)
{
    dWorldSetAutoDisableFlag(world, 1);
    dWorldSetAutoDisableLinearThreshold(world, 0.02);
    dWorldSetAutoDisableAngularThreshold(world, 0.02);
    dWorldSetAutoDisableSteps(world, 20);
    dWorldSetAutoDisableTime(world, 0.3);
}

}  // namespace

Turn orientation(dBodyID body)
{
    const dReal* q = dBodyGetQuaternion(body);
    return {double(q[0]), double(q[1]), double(q[2]), double(q[3])};
}

void set_velocity(dBodyID body, Vec linear, Vec angular)
{
    dBodySetLinearVel(body, linear.x, linear.y, linear.z);
    dBodySetAngularVel(body, angular.x, angular.y, angular.z);
}

Stage::Stage(const Setting& where, Vec gravity, double step_size)
    : setting(where),
      h(step_size > 0 ? step_size : where.h()),
      callback(contains(kCallback, where.method)),
      world(dWorldCreate()),
      space(dHashSpaceCreate(nullptr)),
      contacts_(dJointGroupCreate(0))
{
    dWorldUseDefaults(world, preset_of(setting.method));
    dWorldSetStepThreads(world, 1);  // changes no bit; cells run in processes of their own
    if (setting.sleep)
        let_sleep(world);
    else
        dWorldSetAutoDisableFlag(world, 0);
    dWorldSetGravity(world, gravity.x, gravity.y, gravity.z);
    if (!callback) dWorldSetContactSpace(world, space);
    dMaterialInit(&surface, sizeof surface);
}

Stage::~Stage()
{
    dJointGroupDestroy(contacts_);
    dSpaceDestroy(space);
    dWorldDestroy(world);
}

void Stage::adopt(dWorldID other, dSpaceID its_space)
{
    dSpaceDestroy(space);
    dWorldDestroy(world);
    world = other;
    space = its_space;
}

void Stage::step()
{
    made_.clear();
    feedback_.clear();
    if (callback) dSpaceCollide(space, this, &near_callback);
    switch (setting.method) {
        case Method::kOdeExact:
        case Method::kExact:
            dWorldStep(world, h);
            break;
        case Method::kOdeQuick:
        case Method::kQuick:
            dWorldQuickStep(world, h);
            break;
        case Method::kSubsteps:
            dWorldStepFast1(world, h, 4);
            break;
        default:
            dWorldStepHybrid(world, h);
    }
    dJointGroupEmpty(contacts_);
}

void Stage::finish(dGeomID geom, dBodyID body)
{
    constexpr unsigned long kStatic = 1, kMoving = 2;
    dGeomSetBody(geom, body);
    dGeomSetMaterial(geom, &surface);
    dGeomSetCategoryBits(geom, body ? kMoving : kStatic);
    dGeomSetCollideBits(geom, !body ? kMoving : bodies_meet ? kStatic | kMoving : kStatic);
}

dBodyID Stage::part(dMass mass, Vec at, Turn q)
{
    const dBodyID body = dBodyCreate(world);
    dBodySetMass(body, &mass);
    dBodySetPosition(body, at.x, at.y, at.z);
    const dQuaternion turned = {dReal(q.w), dReal(q.x), dReal(q.y), dReal(q.z)};
    dBodySetQuaternion(body, turned);
    return body;
}

dBodyID Stage::body(dGeomID geom, dMass mass, Vec at, Turn q)
{
    const dBodyID made = part(mass, at, q);
    finish(geom, made);
    return made;
}

dBodyID Stage::bar(Vec size, double mass, Vec at, Turn q)
{
    dMass m;
    dMassSetBoxTotal(&m, mass, size.x, size.y, size.z);
    return part(m, at, q);
}

dBodyID Stage::box(Vec size, double mass, Vec at, Turn q)
{
    dMass m;
    dMassSetBoxTotal(&m, mass, size.x, size.y, size.z);
    return body(dCreateBox(space, size.x, size.y, size.z), m, at, q);
}

dBodyID Stage::ball(double radius, double mass, Vec at)
{
    dMass m;
    dMassSetSphereTotal(&m, mass, radius);
    return body(dCreateSphere(space, radius), m, at);
}

dBodyID Stage::capsule(double radius, double length, double mass, Vec at, Turn q)
{
    dMass m;
    dMassSetCapsuleTotal(&m, mass, 3, radius, length);
    return body(dCreateCapsule(space, radius, length), m, at, q);
}

dBodyID Stage::cylinder(double radius, double length, double mass, Vec at, Turn q)
{
    dMass m;
    dMassSetCylinderTotal(&m, mass, 3, radius, length);
    return body(dCreateCylinder(space, radius, length), m, at, q);
}

dGeomID Stage::floor() { return place(dCreatePlane(space, 0, 0, 1, 0)); }
dGeomID Stage::block(Vec size, Vec at, Turn q)
{
    return place(dCreateBox(space, size.x, size.y, size.z), at, q);
}

dGeomID Stage::place(dGeomID geom, Vec at, Turn q)
{
    finish(geom, nullptr);
    if (dGeomGetClass(geom) == dPlaneClass) return geom;
    dGeomSetPosition(geom, at.x, at.y, at.z);
    const dQuaternion turned = {dReal(q.w), dReal(q.x), dReal(q.y), dReal(q.z)};
    dGeomSetQuaternion(geom, turned);
    return geom;
}

dJointID Stage::ball_joint(dBodyID body1, dBodyID body2, Vec at)
{
    const dJointID joint = dJointCreateBall(world, nullptr);
    dJointAttach(joint, body1, body2);
    dJointSetBallAnchor(joint, at.x, at.y, at.z);
    return joint;
}

dJointID Stage::hinge(dBodyID body1, dBodyID body2, Vec at, Vec axis)
{
    const dJointID joint = dJointCreateHinge(world, nullptr);
    dJointAttach(joint, body1, body2);
    dJointSetHingeAnchor(joint, at.x, at.y, at.z);
    dJointSetHingeAxis(joint, axis.x, axis.y, axis.z);
    return joint;
}

dJointID Stage::fix(dBodyID body1, dBodyID body2)
{
    const dJointID joint = dJointCreateFixed(world, nullptr);
    dJointAttach(joint, body1, body2);
    dJointSetFixed(joint);
    return joint;
}

}  // namespace epode::trials
