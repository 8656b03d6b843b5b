// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// dWorld, dBody and dMass, member by member.
#include "twins.h"

namespace {

Numbers read_world(dWorldID w)
{
    Numbers n;
    dVector3 g;
    dWorldGetGravity(w, g);
    append(n, g, 3);
    n.push_back(dWorldGetERP(w));
    n.push_back(dWorldGetCFM(w));
    n.push_back(dWorldGetQuickStepNumIterations(w));
    n.push_back(dWorldGetQuickStepW(w));
    n.push_back(dWorldGetAutoDisableLinearThreshold(w));
    n.push_back(dWorldGetAutoDisableAngularThreshold(w));
    n.push_back(dWorldGetAutoDisableSteps(w));
    n.push_back(dWorldGetAutoDisableTime(w));
    n.push_back(dWorldGetAutoDisableFlag(w) != 0);
    n.push_back(dWorldGetLinearDampingThreshold(w));
    n.push_back(dWorldGetAngularDampingThreshold(w));
    n.push_back(dWorldGetLinearDamping(w));
    n.push_back(dWorldGetAngularDamping(w));
    n.push_back(dWorldGetMaxAngularSpeed(w));
    n.push_back(dWorldGetContactSurfaceLayer(w));
    return n;
}

Numbers read_body(dBodyID b)
{
    Numbers n;
    dVector3 axis = {0, 0, 0, 0};
    dMass mass;
    append(n, dBodyGetPosition(b), 3);
    append(n, dBodyGetRotation(b), 12);
    append(n, dBodyGetQuaternion(b), 4);
    append(n, dBodyGetLinearVel(b), 3);
    append(n, dBodyGetAngularVel(b), 3);
    append(n, dBodyGetForce(b), 3);
    append(n, dBodyGetTorque(b), 3);
    dBodyGetMass(b, &mass);
    n.push_back(mass.mass);
    append(n, mass.I, 12);
    n.push_back(dBodyIsKinematic(b) != 0);
    n.push_back(dBodyIsEnabled(b) != 0);
    n.push_back(dBodyGetFiniteRotationMode(b) != 0);
    dBodyGetFiniteRotationAxis(b, axis);
    append(n, axis, 3);
    n.push_back(dBodyGetGravityMode(b) != 0);
    n.push_back(dBodyGetGyroscopicMode(b) != 0);
    n.push_back(dBodyGetNumJoints(b));
    n.push_back(dBodyGetData(b) != 0);
    n.push_back(dBodyGetAutoDisableLinearThreshold(b));
    n.push_back(dBodyGetAutoDisableAngularThreshold(b));
    n.push_back(dBodyGetAutoDisableSteps(b));
    n.push_back(dBodyGetAutoDisableTime(b));
    n.push_back(dBodyGetAutoDisableFlag(b) != 0);
    n.push_back(dBodyGetLinearDamping(b));
    n.push_back(dBodyGetAngularDamping(b));
    n.push_back(dBodyGetLinearDampingThreshold(b));
    n.push_back(dBodyGetAngularDampingThreshold(b));
    n.push_back(dBodyGetMaxAngularSpeed(b));
    return n;
}

Numbers read_mass(const dMass& m)
{
    Numbers n(1, m.mass);
    append(n, m.c, 3);
    append(n, m.I, 12);
    return n;
}

void test_world_settings(dWorld& a, dWorldID b)
{
    const dVector3 g = {1, 2, -3, 0};
    SET("dWorldTemplate::setGravity", read_world, a, b, a.setGravity(0, 0, REAL(-9.5)),
        dWorldSetGravity(b, 0, 0, REAL(-9.5)));
    SET("dWorldTemplate::setGravity array", read_world, a, b, a.setGravity(g), dWorldSetGravity(b, 1, 2, -3));
    GET_ARRAY("dWorldTemplate::getGravity", 3, a.getGravity(out), dWorldGetGravity(b, out));
    SET("dWorldTemplate::setERP", read_world, a, b, a.setERP(REAL(0.75)), dWorldSetERP(b, REAL(0.75)));
    judge_get("dWorldTemplate::getERP", a.getERP(), dWorldGetERP(b));
    SET("dWorldTemplate::setCFM", read_world, a, b, a.setCFM(REAL(0.125)), dWorldSetCFM(b, REAL(0.125)));
    judge_get("dWorldTemplate::getCFM", a.getCFM(), dWorldGetCFM(b));
    SET("dWorldTemplate::setQuickStepNumIterations", read_world, a, b, a.setQuickStepNumIterations(33),
        dWorldSetQuickStepNumIterations(b, 33));
    judge_get("dWorldTemplate::getQuickStepNumIterations", a.getQuickStepNumIterations(),
              dWorldGetQuickStepNumIterations(b));
    SET("dWorldTemplate::setQuickStepW", read_world, a, b, a.setQuickStepW(REAL(1.125)),
        dWorldSetQuickStepW(b, REAL(1.125)));
    judge_get("dWorldTemplate::getQuickStepW", a.getQuickStepW(), dWorldGetQuickStepW(b));
    SET("dWorldTemplate::setContactSurfaceLayer", read_world, a, b, a.setContactSurfaceLayer(REAL(0.25)),
        dWorldSetContactSurfaceLayer(b, REAL(0.25)));
    judge_get("dWorldTemplate::getContactSurfaceLayer", a.getContactSurfaceLayer(),
              dWorldGetContactSurfaceLayer(b));
}

void test_world_defaults_of_bodies(dWorld& a, dWorldID b)
{
    SET("dWorldTemplate::setAutoDisableLinearThreshold", read_world, a, b,
        a.setAutoDisableLinearThreshold(REAL(0.5)), dWorldSetAutoDisableLinearThreshold(b, REAL(0.5)));
    judge_get("dWorldTemplate::getAutoDisableLinearThreshold", a.getAutoDisableLinearThreshold(),
              dWorldGetAutoDisableLinearThreshold(b));
    SET("dWorldTemplate::setAutoDisableAngularThreshold", read_world, a, b,
        a.setAutoDisableAngularThreshold(REAL(0.625)), dWorldSetAutoDisableAngularThreshold(b, REAL(0.625)));
    judge_get("dWorldTemplate::getAutoDisableAngularThreshold", a.getAutoDisableAngularThreshold(),
              dWorldGetAutoDisableAngularThreshold(b));
    SET("dWorldTemplate::setAutoDisableSteps", read_world, a, b, a.setAutoDisableSteps(17),
        dWorldSetAutoDisableSteps(b, 17));
    judge_get("dWorldTemplate::getAutoDisableSteps", a.getAutoDisableSteps(), dWorldGetAutoDisableSteps(b));
    SET("dWorldTemplate::setAutoDisableTime", read_world, a, b, a.setAutoDisableTime(3),
        dWorldSetAutoDisableTime(b, 3));
    judge_get("dWorldTemplate::getAutoDisableTime", a.getAutoDisableTime(), dWorldGetAutoDisableTime(b));
    SET("dWorldTemplate::setAutoDisableFlag", read_world, a, b, a.setAutoDisableFlag(1),
        dWorldSetAutoDisableFlag(b, 1));
    judge_get("dWorldTemplate::getAutoDisableFlag", a.getAutoDisableFlag() != 0,
              dWorldGetAutoDisableFlag(b) != 0);
    SET("dWorldTemplate::setLinearDampingThreshold", read_world, a, b,
        a.setLinearDampingThreshold(REAL(0.1875)), dWorldSetLinearDampingThreshold(b, REAL(0.1875)));
    judge_get("dWorldTemplate::getLinearDampingThreshold", a.getLinearDampingThreshold(),
              dWorldGetLinearDampingThreshold(b));
    SET("dWorldTemplate::setAngularDampingThreshold", read_world, a, b,
        a.setAngularDampingThreshold(REAL(0.3125)), dWorldSetAngularDampingThreshold(b, REAL(0.3125)));
    judge_get("dWorldTemplate::getAngularDampingThreshold", a.getAngularDampingThreshold(),
              dWorldGetAngularDampingThreshold(b));
    SET("dWorldTemplate::setLinearDamping", read_world, a, b, a.setLinearDamping(REAL(0.0625)),
        dWorldSetLinearDamping(b, REAL(0.0625)));
    judge_get("dWorldTemplate::getLinearDamping", a.getLinearDamping(), dWorldGetLinearDamping(b));
    SET("dWorldTemplate::setAngularDamping", read_world, a, b, a.setAngularDamping(REAL(0.03125)),
        dWorldSetAngularDamping(b, REAL(0.03125)));
    judge_get("dWorldTemplate::getAngularDamping", a.getAngularDamping(), dWorldGetAngularDamping(b));
    SET("dWorldTemplate::setDamping", read_world, a, b, a.setDamping(REAL(0.5), REAL(0.25)),
        dWorldSetDamping(b, REAL(0.5), REAL(0.25)));
    SET("dWorldTemplate::setMaxAngularSpeed", read_world, a, b, a.setMaxAngularSpeed(40),
        dWorldSetMaxAngularSpeed(b, 40));
    judge_get("dWorldTemplate::getMaxAngularSpeed", a.getMaxAngularSpeed(), dWorldGetMaxAngularSpeed(b));
}

void test_stepping(dWorld& a, dWorldID b)
{
    dBody wrapped(a);
    dBodyID plain = dBodyCreate(b);
    SET("dWorldTemplate::step", read_body, wrapped, plain, a.step(REAL(0.25)), dWorldStep(b, REAL(0.25)));
    SET("dWorldTemplate::quickStep", read_body, wrapped, plain, a.quickStep(REAL(0.125)),
        dWorldQuickStep(b, REAL(0.125)));
    GET_ARRAY("dWorldTemplate::impulseToForce", 3, a.impulseToForce(REAL(0.5), 1, 2, 3, out),
              dWorldImpulseToForce(b, REAL(0.5), 1, 2, 3, out));
}

void test_pose(dBody& a, dBodyID b)
{
    const dVector3 p = {4, 5, 6, 0};
    const dQuaternion q = {REAL(0.5), REAL(0.5), REAL(-0.5), REAL(0.5)};
    dMatrix3 R;
    dRFromAxisAndAngle(R, 1, 2, 3, REAL(0.75));
    SET("dBodyTemplate::setPosition", read_body, a, b, a.setPosition(1, 2, 3), dBodySetPosition(b, 1, 2, 3));
    SET("dBodyTemplate::setPosition array", read_body, a, b, a.setPosition(p), dBodySetPosition(b, 4, 5, 6));
    SET("dBodyTemplate::setQuaternion", read_body, a, b, a.setQuaternion(q), dBodySetQuaternion(b, q));
    SET("dBodyTemplate::setRotation", read_body, a, b, a.setRotation(R), dBodySetRotation(b, R));
    SET("dBodyTemplate::setLinearVel", read_body, a, b, a.setLinearVel(1, 0, 2),
        dBodySetLinearVel(b, 1, 0, 2));
    SET("dBodyTemplate::setLinearVel array", read_body, a, b, a.setLinearVel(p),
        dBodySetLinearVel(b, 4, 5, 6));
    SET("dBodyTemplate::setAngularVel", read_body, a, b, a.setAngularVel(1, 3, 2),
        dBodySetAngularVel(b, 1, 3, 2));
    SET("dBodyTemplate::setAngularVel array", read_body, a, b, a.setAngularVel(p),
        dBodySetAngularVel(b, 4, 5, 6));
    judge_get("dBodyTemplate::getPosition", a.getPosition()[1], dBodyGetPosition(b)[1]);
    judge_get("dBodyTemplate::getRotation", a.getRotation()[4], dBodyGetRotation(b)[4]);
    judge_get("dBodyTemplate::getQuaternion", a.getQuaternion()[2], dBodyGetQuaternion(b)[2]);
    judge_get("dBodyTemplate::getLinearVel", a.getLinearVel()[2], dBodyGetLinearVel(b)[2]);
    judge_get("dBodyTemplate::getAngularVel", a.getAngularVel()[0], dBodyGetAngularVel(b)[0]);
}

void test_mass_and_forces(dBody& a, dBodyID b)
{
    const dVector3 f = {3, -1, 2, 0}, p = {1, 2, REAL(-0.5), 0};
    dMass one, two;
    one.setBoxTotal(3, 1, 2, 3);
    two.setSphereTotal(5, REAL(0.5));
    SET("dBodyTemplate::setMass", read_body, a, b, a.setMass(one), dBodySetMass(b, &one));
    SET("dBodyTemplate::setMass pointer", read_body, a, b, a.setMass(&two), dBodySetMass(b, &two));
    judge_get("dBodyTemplate::getMass", read_mass(a.getMass()), read_mass(two));

    SET("dBodyTemplate::addForce", read_body, a, b, a.addForce(1, 2, 3), dBodyAddForce(b, 1, 2, 3));
    SET("dBodyTemplate::addForce array", read_body, a, b, a.addForce(f), dBodyAddForce(b, 3, -1, 2));
    SET("dBodyTemplate::addTorque", read_body, a, b, a.addTorque(1, 2, 3), dBodyAddTorque(b, 1, 2, 3));
    SET("dBodyTemplate::addTorque array", read_body, a, b, a.addTorque(f), dBodyAddTorque(b, 3, -1, 2));
    SET("dBodyTemplate::addRelForce", read_body, a, b, a.addRelForce(1, 2, 3), dBodyAddRelForce(b, 1, 2, 3));
    SET("dBodyTemplate::addRelForce array", read_body, a, b, a.addRelForce(f), dBodyAddRelForce(b, 3, -1, 2));
    SET("dBodyTemplate::addRelTorque", read_body, a, b, a.addRelTorque(1, 2, 3),
        dBodyAddRelTorque(b, 1, 2, 3));
    SET("dBodyTemplate::addRelTorque array", read_body, a, b, a.addRelTorque(f),
        dBodyAddRelTorque(b, 3, -1, 2));
    SET("dBodyTemplate::addForceAtPos", read_body, a, b, a.addForceAtPos(1, 2, 3, 4, 5, 6),
        dBodyAddForceAtPos(b, 1, 2, 3, 4, 5, 6));
    SET("dBodyTemplate::addForceAtPos array", read_body, a, b, a.addForceAtPos(f, p),
        dBodyAddForceAtPos(b, f[0], f[1], f[2], p[0], p[1], p[2]));
    SET("dBodyTemplate::addForceAtRelPos", read_body, a, b, a.addForceAtRelPos(1, 2, 3, 4, 5, 6),
        dBodyAddForceAtRelPos(b, 1, 2, 3, 4, 5, 6));
    SET("dBodyTemplate::addForceAtRelPos array", read_body, a, b, a.addForceAtRelPos(f, p),
        dBodyAddForceAtRelPos(b, f[0], f[1], f[2], p[0], p[1], p[2]));
    SET("dBodyTemplate::addRelForceAtPos", read_body, a, b, a.addRelForceAtPos(1, 2, 3, 4, 5, 6),
        dBodyAddRelForceAtPos(b, 1, 2, 3, 4, 5, 6));
    SET("dBodyTemplate::addRelForceAtPos array", read_body, a, b, a.addRelForceAtPos(f, p),
        dBodyAddRelForceAtPos(b, f[0], f[1], f[2], p[0], p[1], p[2]));
    SET("dBodyTemplate::addRelForceAtRelPos", read_body, a, b, a.addRelForceAtRelPos(1, 2, 3, 4, 5, 6),
        dBodyAddRelForceAtRelPos(b, 1, 2, 3, 4, 5, 6));
    SET("dBodyTemplate::addRelForceAtRelPos array", read_body, a, b, a.addRelForceAtRelPos(f, p),
        dBodyAddRelForceAtRelPos(b, f[0], f[1], f[2], p[0], p[1], p[2]));
    judge_get("dBodyTemplate::getForce", a.getForce()[1], dBodyGetForce(b)[1]);
    judge_get("dBodyTemplate::getTorque", a.getTorque()[2], dBodyGetTorque(b)[2]);
    SET("dBodyTemplate::setForce", read_body, a, b, a.setForce(7, 8, 9), dBodySetForce(b, 7, 8, 9));
    SET("dBodyTemplate::setForce array", read_body, a, b, a.setForce(f), dBodySetForce(b, 3, -1, 2));
    SET("dBodyTemplate::setTorque", read_body, a, b, a.setTorque(7, 8, 9), dBodySetTorque(b, 7, 8, 9));
    SET("dBodyTemplate::setTorque array", read_body, a, b, a.setTorque(f), dBodySetTorque(b, 3, -1, 2));
}

void test_points(dBody& a, dBodyID b)
{
    const dVector3 p = {1, 2, 3, 0};
    GET_ARRAY("dBodyTemplate::getRelPointPos", 3, a.getRelPointPos(1, 2, 3, out),
              dBodyGetRelPointPos(b, 1, 2, 3, out));
    GET_ARRAY("dBodyTemplate::getRelPointPos array", 3, a.getRelPointPos(p, out),
              dBodyGetRelPointPos(b, 1, 2, 3, out));
    GET_ARRAY("dBodyTemplate::getRelPointVel", 3, a.getRelPointVel(1, 2, 3, out),
              dBodyGetRelPointVel(b, 1, 2, 3, out));
    GET_ARRAY("dBodyTemplate::getRelPointVel array", 3, a.getRelPointVel(p, out),
              dBodyGetRelPointVel(b, 1, 2, 3, out));
    GET_ARRAY("dBodyTemplate::getPointVel", 3, a.getPointVel(1, 2, 3, out),
              dBodyGetPointVel(b, 1, 2, 3, out));
    GET_ARRAY("dBodyTemplate::getPointVel array", 3, a.getPointVel(p, out),
              dBodyGetPointVel(b, 1, 2, 3, out));
    GET_ARRAY("dBodyTemplate::getPosRelPoint", 3, a.getPosRelPoint(1, 2, 3, out),
              dBodyGetPosRelPoint(b, 1, 2, 3, out));
    GET_ARRAY("dBodyTemplate::getPosRelPoint array", 3, a.getPosRelPoint(p, out),
              dBodyGetPosRelPoint(b, 1, 2, 3, out));
    GET_ARRAY("dBodyTemplate::vectorToWorld", 3, a.vectorToWorld(1, 2, 3, out),
              dBodyVectorToWorld(b, 1, 2, 3, out));
    GET_ARRAY("dBodyTemplate::vectorToWorld array", 3, a.vectorToWorld(p, out),
              dBodyVectorToWorld(b, 1, 2, 3, out));
    GET_ARRAY("dBodyTemplate::vectorFromWorld", 3, a.vectorFromWorld(1, 2, 3, out),
              dBodyVectorFromWorld(b, 1, 2, 3, out));
    GET_ARRAY("dBodyTemplate::vectorFromWorld array", 3, a.vectorFromWorld(p, out),
              dBodyVectorFromWorld(b, 1, 2, 3, out));
}

void test_modes(dBody& a, dBodyID b)
{
    const dVector3 axis = {0, 3, 4, 0};
    int something = 0;
    SET("dBodyTemplate::setKinematic", read_body, a, b, a.setKinematic(), dBodySetKinematic(b));
    judge_get("dBodyTemplate::isKinematic", a.isKinematic(), true);
    SET("dBodyTemplate::setDynamic", read_body, a, b, a.setDynamic(), dBodySetDynamic(b));
    judge_get("dBodyTemplate::isKinematic not", a.isKinematic(), false);
    SET("dBodyTemplate::disable", read_body, a, b, a.disable(), dBodyDisable(b));
    judge_get("dBodyTemplate::isEnabled", a.isEnabled(), false);
    SET("dBodyTemplate::enable", read_body, a, b, a.enable(), dBodyEnable(b));
    judge_get("dBodyTemplate::isEnabled yes", a.isEnabled(), true);
    SET("dBodyTemplate::setFiniteRotationMode", read_body, a, b, a.setFiniteRotationMode(true),
        dBodySetFiniteRotationMode(b, 1));
    judge_get("dBodyTemplate::getFiniteRotationMode", a.getFiniteRotationMode(), true);
    SET("dBodyTemplate::setFiniteRotationAxis", read_body, a, b, a.setFiniteRotationAxis(1, 0, 0),
        dBodySetFiniteRotationAxis(b, 1, 0, 0));
    SET("dBodyTemplate::setFiniteRotationAxis array", read_body, a, b, a.setFiniteRotationAxis(axis),
        dBodySetFiniteRotationAxis(b, 0, 3, 4));
    GET_ARRAY("dBodyTemplate::getFiniteRotationAxis", 3, a.getFiniteRotationAxis(out),
              dBodyGetFiniteRotationAxis(b, out));
    SET("dBodyTemplate::setGravityMode", read_body, a, b, a.setGravityMode(false), dBodySetGravityMode(b, 0));
    judge_get("dBodyTemplate::getGravityMode", a.getGravityMode(), false);
    SET("dBodyTemplate::setGyroscopicMode", read_body, a, b, a.setGyroscopicMode(false),
        dBodySetGyroscopicMode(b, 0));
    judge_get("dBodyTemplate::getGyroscopicMode", a.getGyroscopicMode(), false);
    SET("dBodyTemplate::setData", read_body, a, b, a.setData(&something), dBodySetData(b, &something));
    judge_get("dBodyTemplate::getData", a.getData() == &something, true);
}

void test_disabling_and_damping(dBody& a, dBodyID b)
{
    SET("dBodyTemplate::setAutoDisableLinearThreshold", read_body, a, b,
        a.setAutoDisableLinearThreshold(REAL(0.375)), dBodySetAutoDisableLinearThreshold(b, REAL(0.375)));
    judge_get("dBodyTemplate::getAutoDisableLinearThreshold", a.getAutoDisableLinearThreshold(),
              dBodyGetAutoDisableLinearThreshold(b));
    SET("dBodyTemplate::setAutoDisableAngularThreshold", read_body, a, b,
        a.setAutoDisableAngularThreshold(REAL(0.875)), dBodySetAutoDisableAngularThreshold(b, REAL(0.875)));
    judge_get("dBodyTemplate::getAutoDisableAngularThreshold", a.getAutoDisableAngularThreshold(),
              dBodyGetAutoDisableAngularThreshold(b));
    SET("dBodyTemplate::setAutoDisableSteps", read_body, a, b, a.setAutoDisableSteps(5),
        dBodySetAutoDisableSteps(b, 5));
    judge_get("dBodyTemplate::getAutoDisableSteps", a.getAutoDisableSteps(), dBodyGetAutoDisableSteps(b));
    SET("dBodyTemplate::setAutoDisableTime", read_body, a, b, a.setAutoDisableTime(4),
        dBodySetAutoDisableTime(b, 4));
    judge_get("dBodyTemplate::getAutoDisableTime", a.getAutoDisableTime(), dBodyGetAutoDisableTime(b));
    SET("dBodyTemplate::setAutoDisableFlag", read_body, a, b, a.setAutoDisableFlag(false),
        dBodySetAutoDisableFlag(b, 0));
    judge_get("dBodyTemplate::getAutoDisableFlag", a.getAutoDisableFlag(), false);
    SET("dBodyTemplate::setLinearDamping", read_body, a, b, a.setLinearDamping(REAL(0.625)),
        dBodySetLinearDamping(b, REAL(0.625)));
    judge_get("dBodyTemplate::getLinearDamping", a.getLinearDamping(), dBodyGetLinearDamping(b));
    SET("dBodyTemplate::setAngularDamping", read_body, a, b, a.setAngularDamping(REAL(0.875)),
        dBodySetAngularDamping(b, REAL(0.875)));
    judge_get("dBodyTemplate::getAngularDamping", a.getAngularDamping(), dBodyGetAngularDamping(b));
    SET("dBodyTemplate::setDamping", read_body, a, b, a.setDamping(REAL(0.0625), REAL(0.125)),
        dBodySetDamping(b, REAL(0.0625), REAL(0.125)));
    SET("dBodyTemplate::setLinearDampingThreshold", read_body, a, b, a.setLinearDampingThreshold(2),
        dBodySetLinearDampingThreshold(b, 2));
    judge_get("dBodyTemplate::getLinearDampingThreshold", a.getLinearDampingThreshold(),
              dBodyGetLinearDampingThreshold(b));
    SET("dBodyTemplate::setAngularDampingThreshold", read_body, a, b, a.setAngularDampingThreshold(3),
        dBodySetAngularDampingThreshold(b, 3));
    judge_get("dBodyTemplate::getAngularDampingThreshold", a.getAngularDampingThreshold(),
              dBodyGetAngularDampingThreshold(b));
    SET("dBodyTemplate::setMaxAngularSpeed", read_body, a, b, a.setMaxAngularSpeed(11),
        dBodySetMaxAngularSpeed(b, 11));
    judge_get("dBodyTemplate::getMaxAngularSpeed", a.getMaxAngularSpeed(), dBodyGetMaxAngularSpeed(b));
    SET("dBodyTemplate::setDampingDefaults", read_body, a, b, a.setDampingDefaults(),
        dBodySetDampingDefaults(b));
}

void test_neighbours(dWorld& world, dBody& a)
{
    dBody other(world), apart(world);
    dBallJoint ball(world);
    ball.attach(a, other);
    judge_get("dBodyTemplate::getNumJoints", a.getNumJoints(), 1);
    judge_get("dBodyTemplate::getJoint", a.getJoint(0) == ball.id(), true);
    judge_get("dBodyTemplate::isConnectedTo", a.isConnectedTo(other), true);
    judge_get("dBodyTemplate::isConnectedTo not", a.isConnectedTo(apart), false);
}

void test_making_bodies(dWorld& world)
{
    dBody empty, by_number(world.id()), by_wrapper(world);
    judge_get("dBodyTemplate::dBodyTemplate empty", empty.id() == 0, true);
    judge_get("dBodyTemplate::dBodyTemplate number", dBodyGetWorld(by_number) == world.id(), true);
    judge_get("dBodyTemplate::dBodyTemplate wrapper", dBodyGetWorld(by_wrapper.id()) == world.id(), true);
    empty.create(world);
    judge_get("dBodyTemplate::create", dBodyGetWorld(empty) == world.id(), true);
    empty.setPosition(1, 2, 3);
    empty.create(world.id());
    judge_get("dBodyTemplate::create again", read_body(empty), read_body(by_number));
    judge_get("dBodyTemplate::id", dBodyID(empty) == empty.id(), true);
}

}  // namespace

void test_world()
{
    dWorld a;
    dWorldID b = dWorldCreate();
    judge_get("dWorldTemplate::dWorldTemplate", read_world(a), read_world(b));
    judge_get("dWorldTemplate::id", a.id() != 0 && dWorldID(a) == a.id(), true);
    test_world_settings(a, b);
    test_world_defaults_of_bodies(a, b);
    test_stepping(a, b);
    dWorldDestroy(b);
}

void test_body()
{
    dWorld world;
    world.setLinearDamping(REAL(0.5));
    world.setAutoDisableFlag(1);
    dBody a(world);
    dBodyID b = dBodyCreate(world);
    test_pose(a, b);
    test_mass_and_forces(a, b);
    test_points(a, b);
    test_modes(a, b);
    test_disabling_and_damping(a, b);
    test_neighbours(world, a);
    test_making_bodies(world);
}

void test_mass()
{
    dMass a, b;
    dMatrix3 R;
    dRFromAxisAndAngle(R, 1, 2, 3, REAL(0.75));
    judge_get("dMass::dMass", read_mass(a), Numbers(16, 0.0));
    SET("dMass::setParameters", read_mass, a, b, a.setParameters(2, 0, 0, 0, 3, 4, 5, REAL(0.5), 0, 0),
        dMassSetParameters(&b, 2, 0, 0, 0, 3, 4, 5, REAL(0.5), 0, 0));
    SET("dMass::setSphere", read_mass, a, b, a.setSphere(7, 2), dMassSetSphere(&b, 7, 2));
    SET("dMass::setSphereTotal", read_mass, a, b, a.setSphereTotal(6, 2), dMassSetSphereTotal(&b, 6, 2));
    SET("dMass::setCapsule", read_mass, a, b, a.setCapsule(7, 3, 1, 2), dMassSetCapsule(&b, 7, 3, 1, 2));
    SET("dMass::setCapsuleTotal", read_mass, a, b, a.setCapsuleTotal(5, 1, 1, 2),
        dMassSetCapsuleTotal(&b, 5, 1, 1, 2));
    SET("dMass::setCylinder", read_mass, a, b, a.setCylinder(7, 2, 1, 2), dMassSetCylinder(&b, 7, 2, 1, 2));
    SET("dMass::setCylinderTotal", read_mass, a, b, a.setCylinderTotal(5, 3, 1, 2),
        dMassSetCylinderTotal(&b, 5, 3, 1, 2));
    SET("dMass::setBox", read_mass, a, b, a.setBox(2, 1, 2, 3), dMassSetBox(&b, 2, 1, 2, 3));
    SET("dMass::setBoxTotal", read_mass, a, b, a.setBoxTotal(4, 1, 2, 3), dMassSetBoxTotal(&b, 4, 1, 2, 3));
    // About its centre: off it, Debian's library counts the shift twice (docs/compat.md, C31).
    const dReal corners[4][4] = {{-1, -1, -1, 0}, {3, -1, -1, 0}, {-1, 3, -1, 0}, {-1, -1, 3, 0}};
    const dTriIndex faces[12] = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
    const dTriMeshDataID data = dGeomTriMeshDataCreate();
    dGeomTriMeshDataBuildSimple(data, corners[0], 4, faces, 12);
    const dGeomID mesh = dCreateTriMesh(0, data, 0, 0, 0);
    SET("dMass::setTrimesh", read_mass, a, b, a.setTrimesh(2, mesh), dMassSetTrimesh(&b, 2, mesh));
    SET("dMass::setTrimeshTotal", read_mass, a, b, a.setTrimeshTotal(6, mesh),
        dMassSetTrimeshTotal(&b, 6, mesh));
    dGeomDestroy(mesh);
    dGeomTriMeshDataDestroy(data);
    SET("dMass::adjust", read_mass, a, b, a.adjust(9), dMassAdjust(&b, 9));
    SET("dMass::translate", read_mass, a, b, a.translate(1, 2, 3), dMassTranslate(&b, 1, 2, 3));
    SET("dMass::rotate", read_mass, a, b, a.rotate(R), dMassRotate(&b, R));
    const dMass part = a;
    SET("dMass::add", read_mass, a, b, a.add(&part), dMassAdd(&b, &part));
    SET("dMass::setZero", read_mass, a, b, a.setZero(), dMassSetZero(&b));
}
