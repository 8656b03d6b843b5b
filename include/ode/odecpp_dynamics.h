/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * C++ wrappers of worlds, bodies and joint groups. Included by odecpp.h, which names the classes programs use
 * (dWorld, dBody, dJointGroup); the joints are in odecpp_joints.h.
 *
 * A wrapper owns one object of the library: it makes it, hands its number out wherever the C functions want
 * one, and destroys it when it goes out of scope. Wrappers cannot be copied. Each member calls the C function
 * of its name, which tells units, frames, defaults and refusals. There is no library code behind them, and
 * they compile from C++98 on.
 * The class that holds the number is a parameter: a program can bring its own (see odecpp.h). */
#ifndef _ODE_ODECPP_DYNAMICS_H_
#define _ODE_ODECPP_DYNAMICS_H_

#include <ode/mass.h>
#include <ode/objects.h>

#ifdef __cplusplus

/** Holds a world's number and destroys the world with itself. */
class dWorldSimpleIDContainer {
  protected:
    dWorldID _id; /**< 0: none */

    dWorldSimpleIDContainer() : _id(0) {}
    ~dWorldSimpleIDContainer() { destroy(); }

    /** Destroy the world, if there is one; the container is empty afterwards. */
    void destroy()
    {
        if (_id) {
            dWorldDestroy(_id);
            _id = 0;
        }
    }
};

/** The same with a virtual destructor, for programs that delete through a base class. */
class dWorldDynamicIDContainer : public dWorldSimpleIDContainer {
  protected:
    virtual ~dWorldDynamicIDContainer() {}
};

/** A world: what dWorld is. It is created by the constructor. */
template <class dWorldTemplateBase>
class dWorldTemplate : public dWorldTemplateBase {
    dWorldTemplate(const dWorldTemplate&);
    void operator=(const dWorldTemplate&);

  protected:
    /** The number, for derived classes; its change; the end of the object. */
    dWorldID get_id() const { return dWorldTemplateBase::_id; }
    void set_id(dWorldID value) { dWorldTemplateBase::_id = value; }

  public:
    dWorldTemplate() { set_id(dWorldCreate()); }

    /** The world's number, for the C functions. */
    dWorldID id() const { return get_id(); }
    operator dWorldID() const { return get_id(); }

    /** dWorldSetGravity and dWorldGetGravity: three components, or g of 3 reals. */
    void setGravity(dReal x, dReal y, dReal z) { dWorldSetGravity(get_id(), x, y, z); }
    void setGravity(const dVector3 g) { setGravity(g[0], g[1], g[2]); }
    void getGravity(dVector3 g) const { dWorldGetGravity(get_id(), g); }

    /** The world's erp and cfm: dWorldSetERP, dWorldSetCFM. */
    void setERP(dReal erp) { dWorldSetERP(get_id(), erp); }
    dReal getERP() const { return dWorldGetERP(get_id()); }
    void setCFM(dReal cfm) { dWorldSetCFM(get_id(), cfm); }
    dReal getCFM() const { return dWorldGetCFM(get_id()); }

    /** Advance by stepsize: dWorldStep, dWorldQuickStep. */
    void step(dReal stepsize) { dWorldStep(get_id(), stepsize); }
    void quickStep(dReal stepsize) { dWorldQuickStep(get_id(), stepsize); }

    /** Iterations (num) and over_relaxation of quickStep. */
    void setQuickStepNumIterations(int num) { dWorldSetQuickStepNumIterations(get_id(), num); }
    int getQuickStepNumIterations() const { return dWorldGetQuickStepNumIterations(get_id()); }
    void setQuickStepW(dReal over_relaxation) { dWorldSetQuickStepW(get_id(), over_relaxation); }
    dReal getQuickStepW() const { return dWorldGetQuickStepW(get_id()); }

    /** Automatic disabling for bodies to come: the dWorldSetAutoDisable... functions (threshold, steps, time,
        do_auto_disable). */
    void setAutoDisableLinearThreshold(dReal threshold)
    {
        dWorldSetAutoDisableLinearThreshold(get_id(), threshold);
    }
    dReal getAutoDisableLinearThreshold() const { return dWorldGetAutoDisableLinearThreshold(get_id()); }
    void setAutoDisableAngularThreshold(dReal threshold)
    {
        dWorldSetAutoDisableAngularThreshold(get_id(), threshold);
    }
    dReal getAutoDisableAngularThreshold() const { return dWorldGetAutoDisableAngularThreshold(get_id()); }
    void setAutoDisableSteps(int steps) { dWorldSetAutoDisableSteps(get_id(), steps); }
    int getAutoDisableSteps() const { return dWorldGetAutoDisableSteps(get_id()); }
    void setAutoDisableTime(dReal time) { dWorldSetAutoDisableTime(get_id(), time); }
    dReal getAutoDisableTime() const { return dWorldGetAutoDisableTime(get_id()); }
    void setAutoDisableFlag(int do_auto_disable) { dWorldSetAutoDisableFlag(get_id(), do_auto_disable); }
    int getAutoDisableFlag() const { return dWorldGetAutoDisableFlag(get_id()); }

    /** Damping and speed limit for bodies to come: dWorldSetLinearDamping and its neighbours (threshold,
        scale, linear_scale, angular_scale, max_speed). */
    dReal getLinearDampingThreshold() const { return dWorldGetLinearDampingThreshold(get_id()); }
    void setLinearDampingThreshold(dReal threshold) { dWorldSetLinearDampingThreshold(get_id(), threshold); }
    dReal getAngularDampingThreshold() const { return dWorldGetAngularDampingThreshold(get_id()); }
    void setAngularDampingThreshold(dReal threshold)
    {
        dWorldSetAngularDampingThreshold(get_id(), threshold);
    }
    dReal getLinearDamping() const { return dWorldGetLinearDamping(get_id()); }
    void setLinearDamping(dReal scale) { dWorldSetLinearDamping(get_id(), scale); }
    dReal getAngularDamping() const { return dWorldGetAngularDamping(get_id()); }
    void setAngularDamping(dReal scale) { dWorldSetAngularDamping(get_id(), scale); }
    void setDamping(dReal linear_scale, dReal angular_scale)
    {
        dWorldSetDamping(get_id(), linear_scale, angular_scale);
    }
    dReal getMaxAngularSpeed() const { return dWorldGetMaxAngularSpeed(get_id()); }
    void setMaxAngularSpeed(dReal max_speed) { dWorldSetMaxAngularSpeed(get_id(), max_speed); }

    /** dWorldSetContactSurfaceLayer: a depth that contacts may keep. */
    void setContactSurfaceLayer(dReal depth) { dWorldSetContactSurfaceLayer(get_id(), depth); }
    dReal getContactSurfaceLayer() const { return dWorldGetContactSurfaceLayer(get_id()); }

    /** dWorldImpulseToForce: the force that gives the impulse (ix, iy, iz) in a step of stepsize. */
    void impulseToForce(dReal stepsize, dReal ix, dReal iy, dReal iz, dVector3 force)
    {
        dWorldImpulseToForce(get_id(), stepsize, ix, iy, iz, force);
    }
};

/** Holds a body's number and destroys the body with itself. */
class dBodySimpleIDContainer {
  protected:
    dBodyID _id; /**< 0: none */

    dBodySimpleIDContainer() : _id(0) {}
    ~dBodySimpleIDContainer() { destroy(); }

    /** Destroy the body, if there is one; the container is empty afterwards. */
    void destroy()
    {
        if (_id) {
            dBodyDestroy(_id);
            _id = 0;
        }
    }
};

/** The same with a virtual destructor. */
class dBodyDynamicIDContainer : public dBodySimpleIDContainer {
  protected:
    virtual ~dBodyDynamicIDContainer() {}
};

/** A rigid body: what dBody is. Made by a constructor that is given a world, or by create(). Wherever a C
    function takes a vector in three numbers, there is a form that takes an array of 3 reals. */
template <class dBodyTemplateBase, class dWorldTemplateBase>
class dBodyTemplate : public dBodyTemplateBase {
    dBodyTemplate(const dBodyTemplate&);
    void operator=(const dBodyTemplate&);

  protected:
    /** The number, for derived classes; its change; the end of the object. */
    dBodyID get_id() const { return dBodyTemplateBase::_id; }
    void set_id(dBodyID value) { dBodyTemplateBase::_id = value; }
    void destroy() { dBodyTemplateBase::destroy(); }

  public:
    /** Without a world there is no body yet. */
    dBodyTemplate() {}
    dBodyTemplate(dWorldID world) { create(world); }
    dBodyTemplate(dWorldTemplate<dWorldTemplateBase>& world) { create(world.id()); }

    /** Make a new body in the world; the one before is destroyed. */
    void create(dWorldID world)
    {
        destroy();
        set_id(dBodyCreate(world));
    }
    void create(dWorldTemplate<dWorldTemplateBase>& world) { create(world.id()); }

    /** The body's number, for the C functions; 0: there is none. */
    dBodyID id() const { return get_id(); }
    operator dBodyID() const { return get_id(); }

    /** A pointer (data) of the program's: dBodySetData. */
    void setData(void* data) { dBodySetData(get_id(), data); }
    void* getData() const { return dBodyGetData(get_id()); }

    /** Pose and velocity: dBodySetPosition, dBodySetRotation, dBodySetQuaternion, dBodySetLinearVel,
        dBodySetAngularVel (x, y, z, or p, R, q, v), and the pointers into the body. */
    void setPosition(dReal x, dReal y, dReal z) { dBodySetPosition(get_id(), x, y, z); }
    void setPosition(const dVector3 p) { setPosition(p[0], p[1], p[2]); }
    void setRotation(const dMatrix3 R) { dBodySetRotation(get_id(), R); }
    void setQuaternion(const dQuaternion q) { dBodySetQuaternion(get_id(), q); }
    void setLinearVel(dReal x, dReal y, dReal z) { dBodySetLinearVel(get_id(), x, y, z); }
    void setLinearVel(const dVector3 v) { setLinearVel(v[0], v[1], v[2]); }
    void setAngularVel(dReal x, dReal y, dReal z) { dBodySetAngularVel(get_id(), x, y, z); }
    void setAngularVel(const dVector3 v) { setAngularVel(v[0], v[1], v[2]); }
    const dReal* getPosition() const { return dBodyGetPosition(get_id()); }
    const dReal* getRotation() const { return dBodyGetRotation(get_id()); }
    const dReal* getQuaternion() const { return dBodyGetQuaternion(get_id()); }
    const dReal* getLinearVel() const { return dBodyGetLinearVel(get_id()); }
    const dReal* getAngularVel() const { return dBodyGetAngularVel(get_id()); }

    /** The mass: dBodySetMass, dBodyGetMass. */
    void setMass(const dMass* mass) { dBodySetMass(get_id(), mass); }
    void setMass(const dMass& mass) { setMass(&mass); }
    dMass getMass() const
    {
        dMass mass;
        dBodyGetMass(get_id(), &mass);
        return mass;
    }

    /** Forces and torques of the next step: the dBodyAdd... functions of these names. A force is (fx, fy, fz)
        or f, a torque t, a point (px, py, pz) or p. */
    void addForce(dReal fx, dReal fy, dReal fz) { dBodyAddForce(get_id(), fx, fy, fz); }
    void addForce(const dVector3 f) { addForce(f[0], f[1], f[2]); }
    void addTorque(dReal fx, dReal fy, dReal fz) { dBodyAddTorque(get_id(), fx, fy, fz); }
    void addTorque(const dVector3 t) { addTorque(t[0], t[1], t[2]); }
    void addRelForce(dReal fx, dReal fy, dReal fz) { dBodyAddRelForce(get_id(), fx, fy, fz); }
    void addRelForce(const dVector3 f) { addRelForce(f[0], f[1], f[2]); }
    void addRelTorque(dReal fx, dReal fy, dReal fz) { dBodyAddRelTorque(get_id(), fx, fy, fz); }
    void addRelTorque(const dVector3 t) { addRelTorque(t[0], t[1], t[2]); }
    void addForceAtPos(dReal fx, dReal fy, dReal fz, dReal px, dReal py, dReal pz)
    {
        dBodyAddForceAtPos(get_id(), fx, fy, fz, px, py, pz);
    }
    void addForceAtPos(const dVector3 f, const dVector3 p)
    {
        addForceAtPos(f[0], f[1], f[2], p[0], p[1], p[2]);
    }
    void addForceAtRelPos(dReal fx, dReal fy, dReal fz, dReal px, dReal py, dReal pz)
    {
        dBodyAddForceAtRelPos(get_id(), fx, fy, fz, px, py, pz);
    }
    void addForceAtRelPos(const dVector3 f, const dVector3 p)
    {
        addForceAtRelPos(f[0], f[1], f[2], p[0], p[1], p[2]);
    }
    void addRelForceAtPos(dReal fx, dReal fy, dReal fz, dReal px, dReal py, dReal pz)
    {
        dBodyAddRelForceAtPos(get_id(), fx, fy, fz, px, py, pz);
    }
    void addRelForceAtPos(const dVector3 f, const dVector3 p)
    {
        addRelForceAtPos(f[0], f[1], f[2], p[0], p[1], p[2]);
    }
    void addRelForceAtRelPos(dReal fx, dReal fy, dReal fz, dReal px, dReal py, dReal pz)
    {
        dBodyAddRelForceAtRelPos(get_id(), fx, fy, fz, px, py, pz);
    }
    void addRelForceAtRelPos(const dVector3 f, const dVector3 p)
    {
        addRelForceAtRelPos(f[0], f[1], f[2], p[0], p[1], p[2]);
    }
    const dReal* getForce() const { return dBodyGetForce(get_id()); }
    const dReal* getTorque() const { return dBodyGetTorque(get_id()); }
    void setForce(dReal x, dReal y, dReal z) { dBodySetForce(get_id(), x, y, z); }
    void setForce(const dVector3 f) { setForce(f[0], f[1], f[2]); }
    void setTorque(dReal x, dReal y, dReal z) { dBodySetTorque(get_id(), x, y, z); }
    void setTorque(const dVector3 t) { setTorque(t[0], t[1], t[2]); }

    /** Dynamic or kinematic, enabled or disabled: the functions of these names. */
    void setDynamic() { dBodySetDynamic(get_id()); }
    void setKinematic() { dBodySetKinematic(get_id()); }
    bool isKinematic() const { return dBodyIsKinematic(get_id()) != 0; }
    void enable() { dBodyEnable(get_id()); }
    void disable() { dBodyDisable(get_id()); }
    bool isEnabled() const { return dBodyIsEnabled(get_id()) != 0; }

    /** Points and directions between body and world: dBodyGetRelPointPos and its neighbours write result (3
        reals) for the point (px, py, pz) or p. */
    void getRelPointPos(dReal px, dReal py, dReal pz, dVector3 result) const
    {
        dBodyGetRelPointPos(get_id(), px, py, pz, result);
    }
    void getRelPointPos(const dVector3 p, dVector3 result) const { getRelPointPos(p[0], p[1], p[2], result); }
    void getRelPointVel(dReal px, dReal py, dReal pz, dVector3 result) const
    {
        dBodyGetRelPointVel(get_id(), px, py, pz, result);
    }
    void getRelPointVel(const dVector3 p, dVector3 result) const { getRelPointVel(p[0], p[1], p[2], result); }
    void getPointVel(dReal px, dReal py, dReal pz, dVector3 result) const
    {
        dBodyGetPointVel(get_id(), px, py, pz, result);
    }
    void getPointVel(const dVector3 p, dVector3 result) const { getPointVel(p[0], p[1], p[2], result); }
    void getPosRelPoint(dReal px, dReal py, dReal pz, dVector3 result) const
    {
        dBodyGetPosRelPoint(get_id(), px, py, pz, result);
    }
    void getPosRelPoint(const dVector3 p, dVector3 result) const { getPosRelPoint(p[0], p[1], p[2], result); }
    void vectorToWorld(dReal px, dReal py, dReal pz, dVector3 result) const
    {
        dBodyVectorToWorld(get_id(), px, py, pz, result);
    }
    void vectorToWorld(const dVector3 p, dVector3 result) const { vectorToWorld(p[0], p[1], p[2], result); }
    void vectorFromWorld(dReal px, dReal py, dReal pz, dVector3 result) const
    {
        dBodyVectorFromWorld(get_id(), px, py, pz, result);
    }
    void vectorFromWorld(const dVector3 p, dVector3 result) const
    {
        vectorFromWorld(p[0], p[1], p[2], result);
    }

    /** How the body turns: dBodySetFiniteRotationMode, dBodySetFiniteRotationAxis (x, y, z or a). */
    void setFiniteRotationMode(bool mode) { dBodySetFiniteRotationMode(get_id(), mode); }
    void setFiniteRotationAxis(dReal x, dReal y, dReal z) { dBodySetFiniteRotationAxis(get_id(), x, y, z); }
    void setFiniteRotationAxis(const dVector3 a) { setFiniteRotationAxis(a[0], a[1], a[2]); }
    bool getFiniteRotationMode() const { return dBodyGetFiniteRotationMode(get_id()) != 0; }
    void getFiniteRotationAxis(dVector3 result) const { dBodyGetFiniteRotationAxis(get_id(), result); }
    bool getGyroscopicMode() const { return dBodyGetGyroscopicMode(get_id()) != 0; }
    void setGyroscopicMode(bool mode) { dBodySetGyroscopicMode(get_id(), mode); }
    void setGravityMode(bool mode) { dBodySetGravityMode(get_id(), mode); }
    bool getGravityMode() const { return dBodyGetGravityMode(get_id()) != 0; }

    /** The joints: number index of dBodyGetNumJoints; is there one to that body (dAreConnected)? */
    int getNumJoints() const { return dBodyGetNumJoints(get_id()); }
    dJointID getJoint(int index) const { return dBodyGetJoint(get_id(), index); }
    bool isConnectedTo(dBodyID body) const { return dAreConnected(get_id(), body) != 0; }

    /** Automatic disabling: the dBodySetAutoDisable... functions (threshold, steps, time, do_auto_disable).
     */
    void setAutoDisableLinearThreshold(dReal threshold)
    {
        dBodySetAutoDisableLinearThreshold(get_id(), threshold);
    }
    dReal getAutoDisableLinearThreshold() const { return dBodyGetAutoDisableLinearThreshold(get_id()); }
    void setAutoDisableAngularThreshold(dReal threshold)
    {
        dBodySetAutoDisableAngularThreshold(get_id(), threshold);
    }
    dReal getAutoDisableAngularThreshold() const { return dBodyGetAutoDisableAngularThreshold(get_id()); }
    void setAutoDisableSteps(int steps) { dBodySetAutoDisableSteps(get_id(), steps); }
    int getAutoDisableSteps() const { return dBodyGetAutoDisableSteps(get_id()); }
    void setAutoDisableTime(dReal time) { dBodySetAutoDisableTime(get_id(), time); }
    dReal getAutoDisableTime() const { return dBodyGetAutoDisableTime(get_id()); }
    void setAutoDisableFlag(bool do_auto_disable) { dBodySetAutoDisableFlag(get_id(), do_auto_disable); }
    bool getAutoDisableFlag() const { return dBodyGetAutoDisableFlag(get_id()) != 0; }

    /** Damping and speed limit: dBodySetLinearDamping and its neighbours (scale, linear_scale, angular_scale,
        threshold, max_speed). */
    dReal getLinearDamping() const { return dBodyGetLinearDamping(get_id()); }
    void setLinearDamping(dReal scale) { dBodySetLinearDamping(get_id(), scale); }
    dReal getAngularDamping() const { return dBodyGetAngularDamping(get_id()); }
    void setAngularDamping(dReal scale) { dBodySetAngularDamping(get_id(), scale); }
    void setDamping(dReal linear_scale, dReal angular_scale)
    {
        dBodySetDamping(get_id(), linear_scale, angular_scale);
    }
    dReal getLinearDampingThreshold() const { return dBodyGetLinearDampingThreshold(get_id()); }
    void setLinearDampingThreshold(dReal threshold) const
    {
        dBodySetLinearDampingThreshold(get_id(), threshold);
    }
    dReal getAngularDampingThreshold() const { return dBodyGetAngularDampingThreshold(get_id()); }
    void setAngularDampingThreshold(dReal threshold) { dBodySetAngularDampingThreshold(get_id(), threshold); }
    void setDampingDefaults() { dBodySetDampingDefaults(get_id()); }
    dReal getMaxAngularSpeed() const { return dBodyGetMaxAngularSpeed(get_id()); }
    void setMaxAngularSpeed(dReal max_speed) { dBodySetMaxAngularSpeed(get_id(), max_speed); }
};

/** Holds a joint group's number and destroys the group with itself. */
class dJointGroupSimpleIDContainer {
  protected:
    dJointGroupID _id; /**< 0: none */

    dJointGroupSimpleIDContainer() : _id(0) {}
    ~dJointGroupSimpleIDContainer() { destroy(); }

    /** Destroy the group and its joints, if there is one; the container is empty afterwards. */
    void destroy()
    {
        if (_id) {
            dJointGroupDestroy(_id);
            _id = 0;
        }
    }
};

/** The same with a virtual destructor. */
class dJointGroupDynamicIDContainer : public dJointGroupSimpleIDContainer {
  protected:
    virtual ~dJointGroupDynamicIDContainer() {}
};

/** A group of joints: what dJointGroup is. The constructor makes an empty group. */
template <class dJointGroupTemplateBase>
class dJointGroupTemplate : public dJointGroupTemplateBase {
    dJointGroupTemplate(const dJointGroupTemplate&);
    void operator=(const dJointGroupTemplate&);

  protected:
    /** The number, for derived classes; its change; the end of the object. */
    dJointGroupID get_id() const { return dJointGroupTemplateBase::_id; }
    void set_id(dJointGroupID value) { dJointGroupTemplateBase::_id = value; }
    void destroy() { dJointGroupTemplateBase::destroy(); }

  public:
    dJointGroupTemplate() { set_id(dJointGroupCreate(0)); }

    /** Make a new group; the one before is destroyed with its joints. */
    void create()
    {
        destroy();
        set_id(dJointGroupCreate(0));
    }

    /** The group's number, for the C functions. */
    dJointGroupID id() const { return get_id(); }
    operator dJointGroupID() const { return get_id(); }

    /** dJointGroupEmpty, under two names. */
    void empty() { dJointGroupEmpty(get_id()); }
    void clear() { empty(); }
};

#endif
#endif
