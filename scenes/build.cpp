// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See build.h.
#include "scenes/build.h"

#include <cmath>

namespace epode::scenes {

namespace {

void place(dBodyID body, Vec pos, Turn q)
{
    const dQuaternion quaternion = {dReal(q.w), dReal(q.x), dReal(q.y), dReal(q.z)};
    dBodySetPosition(body, dReal(pos.x), dReal(pos.y), dReal(pos.z));
    dBodySetQuaternion(body, quaternion);
}

dGeomID attach(Scene& scene, dBodyID body, dGeomID geom, Vec offset, Turn q)
{
    const dQuaternion quaternion = {dReal(q.w), dReal(q.x), dReal(q.y), dReal(q.z)};
    dGeomSetBody(geom, body);
    dGeomSetOffsetPosition(geom, dReal(offset.x), dReal(offset.y), dReal(offset.z));
    dGeomSetOffsetQuaternion(geom, quaternion);
    scene.add_geom(geom);
    return geom;
}

dJointID connect(dJointID joint, dBodyID body1, dBodyID body2)
{
    dJointAttach(joint, body1, body2);
    return joint;
}

}  // namespace

dBodyID add_body(Scene& scene, dGeomID geom, const dMass& mass, Vec pos, Turn q)
{
    dBodyID body = dBodyCreate(scene.world());
    dBodySetMass(body, &mass);
    dGeomSetBody(geom, body);
    place(body, pos, q);
    scene.add_body(body);
    scene.add_geom(geom);
    return body;
}

dBodyID add_sphere(Scene& scene, double radius, double density, Vec pos)
{
    dMass mass;
    dMassSetSphere(&mass, dReal(density), dReal(radius));
    return add_body(scene, dCreateSphere(scene.space(), dReal(radius)), mass, pos, {});
}

dBodyID add_box(Scene& scene, Vec size, double density, Vec pos, Turn q)
{
    dMass mass;
    dMassSetBox(&mass, dReal(density), dReal(size.x), dReal(size.y), dReal(size.z));
    return add_body(scene, dCreateBox(scene.space(), dReal(size.x), dReal(size.y), dReal(size.z)), mass, pos,
                    q);
}

dBodyID add_capsule(Scene& scene, double radius, double length, double density, Vec pos, Turn q)
{
    dMass mass;
    dMassSetCapsule(&mass, dReal(density), 3, dReal(radius), dReal(length));
    return add_body(scene, dCreateCapsule(scene.space(), dReal(radius), dReal(length)), mass, pos, q);
}

dBodyID add_cylinder(Scene& scene, double radius, double length, double density, Vec pos, Turn q)
{
    dMass mass;
    dMassSetCylinder(&mass, dReal(density), 3, dReal(radius), dReal(length));
    return add_body(scene, dCreateCylinder(scene.space(), dReal(radius), dReal(length)), mass, pos, q);
}

dBodyID add_limb(Scene& scene, double radius, double density, Vec from, Vec to)
{
    const Vec along = to - from;
    const double length = std::sqrt(along.x * along.x + along.y * along.y + along.z * along.z);
    // The shortest turn from z to `along`; opposite to z any axis across will do.
    const Vec axis{-along.y, along.x, 0};
    const double across = std::sqrt(axis.x * axis.x + axis.y * axis.y);
    const Turn q =
        across > 1e-9 * length ? turn(axis, std::atan2(across, along.z)) : turn(kX, along.z > 0 ? 0 : kPi);
    return add_capsule(scene, radius, length - 2 * radius, density, 0.5 * (from + to), q);
}

dGeomID attach_box(Scene& scene, dBodyID body, Vec size, Vec offset, Turn q)
{
    return attach(scene, body, dCreateBox(scene.space(), dReal(size.x), dReal(size.y), dReal(size.z)), offset,
                  q);
}

dGeomID attach_sphere(Scene& scene, dBodyID body, double radius, Vec offset)
{
    return attach(scene, body, dCreateSphere(scene.space(), dReal(radius)), offset, {});
}

dGeomID attach_cylinder(Scene& scene, dBodyID body, double radius, double length, Vec offset, Turn q)
{
    return attach(scene, body, dCreateCylinder(scene.space(), dReal(radius), dReal(length)), offset, q);
}

dGeomID add_ground(Scene& scene, double height)
{
    dGeomID plane = dCreatePlane(scene.space(), 0, 0, 1, dReal(height));
    scene.add_geom(plane);
    return plane;
}

dGeomID add_floor(Scene& scene, double height)
{
    dGeomID plane = add_ground(scene, height);
    dGeomSetCategoryBits(plane, 0);
    dGeomSetCollideBits(plane, 0);
    return plane;
}

dGeomID add_static_box(Scene& scene, Vec size, Vec pos, Turn q)
{
    const dQuaternion quaternion = {dReal(q.w), dReal(q.x), dReal(q.y), dReal(q.z)};
    dGeomID geom = dCreateBox(scene.space(), dReal(size.x), dReal(size.y), dReal(size.z));
    dGeomSetPosition(geom, dReal(pos.x), dReal(pos.y), dReal(pos.z));
    dGeomSetQuaternion(geom, quaternion);
    scene.add_geom(geom);
    return geom;
}

void add_pit(Scene& scene, double half_x, double half_y, double height)
{
    const double thick = 0.6;
    for (double side : {-1.0, 1.0}) {
        add_static_box(scene, {thick, 2 * (half_y + thick), height},
                       {side * (half_x + thick / 2), 0, height / 2});
        add_static_box(scene, {2 * half_x, thick, height}, {0, side * (half_y + thick / 2), height / 2});
    }
}

void set_velocity(dBodyID body, Vec linear, Vec angular)
{
    dBodySetLinearVel(body, dReal(linear.x), dReal(linear.y), dReal(linear.z));
    dBodySetAngularVel(body, dReal(angular.x), dReal(angular.y), dReal(angular.z));
}

void set_bits(dBodyID body, unsigned long category, unsigned long collide)
{
    for (dGeomID geom = dBodyGetFirstGeom(body); geom; geom = dBodyGetNextGeom(geom)) {
        dGeomSetCategoryBits(geom, category);
        dGeomSetCollideBits(geom, collide);
    }
}

dJointID add_ball(Scene& scene, dBodyID body1, dBodyID body2, Vec anchor)
{
    dJointID joint = connect(dJointCreateBall(scene.world(), nullptr), body1, body2);
    dJointSetBallAnchor(joint, dReal(anchor.x), dReal(anchor.y), dReal(anchor.z));
    scene.add_joint(joint);
    return joint;
}

dJointID add_hinge(Scene& scene, dBodyID body1, dBodyID body2, Vec anchor, Vec axis)
{
    dJointID joint = connect(dJointCreateHinge(scene.world(), nullptr), body1, body2);
    dJointSetHingeAnchor(joint, dReal(anchor.x), dReal(anchor.y), dReal(anchor.z));
    dJointSetHingeAxis(joint, dReal(axis.x), dReal(axis.y), dReal(axis.z));
    scene.add_joint(joint);
    return joint;
}

dJointID add_universal(Scene& scene, dBodyID body1, dBodyID body2, Vec anchor, Vec axis1, Vec axis2)
{
    dJointID joint = connect(dJointCreateUniversal(scene.world(), nullptr), body1, body2);
    dJointSetUniversalAnchor(joint, dReal(anchor.x), dReal(anchor.y), dReal(anchor.z));
    dJointSetUniversalAxis1(joint, dReal(axis1.x), dReal(axis1.y), dReal(axis1.z));
    dJointSetUniversalAxis2(joint, dReal(axis2.x), dReal(axis2.y), dReal(axis2.z));
    scene.add_joint(joint);
    return joint;
}

dJointID add_hinge2(Scene& scene, dBodyID body1, dBodyID body2, Vec anchor, Vec axis1, Vec axis2)
{
    dJointID joint = connect(dJointCreateHinge2(scene.world(), nullptr), body1, body2);
    const dVector3 first = {dReal(axis1.x), dReal(axis1.y), dReal(axis1.z)};
    const dVector3 second = {dReal(axis2.x), dReal(axis2.y), dReal(axis2.z)};
    dJointSetHinge2Anchor(joint, dReal(anchor.x), dReal(anchor.y), dReal(anchor.z));
    dJointSetHinge2Axes(joint, first, second);
    scene.add_joint(joint);
    return joint;
}

dJointID add_slider(Scene& scene, dBodyID body1, dBodyID body2, Vec axis)
{
    dJointID joint = connect(dJointCreateSlider(scene.world(), nullptr), body1, body2);
    dJointSetSliderAxis(joint, dReal(axis.x), dReal(axis.y), dReal(axis.z));
    scene.add_joint(joint);
    return joint;
}

void set_hinge_stops(dJointID joint, double low, double high)
{
    dJointSetHingeParam(joint, dParamLoStop, dReal(low));
    dJointSetHingeParam(joint, dParamHiStop, dReal(high));
}

void set_universal_stops(dJointID joint, double low1, double high1, double low2, double high2)
{
    dJointSetUniversalParam(joint, dParamLoStop1, dReal(low1));
    dJointSetUniversalParam(joint, dParamHiStop1, dReal(high1));
    dJointSetUniversalParam(joint, dParamLoStop2, dReal(low2));
    dJointSetUniversalParam(joint, dParamHiStop2, dReal(high2));
}

void set_view(Scene& scene, Vec eye, Vec target)
{
    scene.view = {true, {eye.x, eye.y, eye.z}, {target.x, target.y, target.z}};
}

}  // namespace epode::scenes
