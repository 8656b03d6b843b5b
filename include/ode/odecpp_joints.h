/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * C++ wrappers of the joints. Included by odecpp.h, which names the classes programs use (dBallJoint,
 * dHingeJoint, ...). Conventions as in odecpp_dynamics.h: each member calls the C function of its name.
 *
 * What all types have in common is in dJointTemplate, what makes a joint of one type in dMadeJointTemplate;
 * so a class below holds only what its type adds. (A joint in a group dies with the group: dJointDestroy
 * leaves it alone. Let the wrapper go first.) */
#ifndef _ODE_ODECPP_JOINTS_H_
#define _ODE_ODECPP_JOINTS_H_

#include <ode/odecpp_dynamics.h>

#ifdef __cplusplus

/** Holds a joint's number and destroys the joint with itself. */
class dJointSimpleIDContainer {
  protected:
    dJointID _id; /**< 0: none */

    dJointSimpleIDContainer() : _id(0) {}
    ~dJointSimpleIDContainer() { destroy(); }

    /** Destroy the joint, if there is one; the container is empty afterwards. */
    void destroy()
    {
        if (_id) {
            dJointDestroy(_id);
            _id = 0;
        }
    }
};

/** The same with a virtual destructor. */
class dJointDynamicIDContainer : public dJointSimpleIDContainer {
  protected:
    virtual ~dJointDynamicIDContainer() {}
};

/** What joints of all types share: dJoint. Only the classes of the types can be made. */
template <class dJointTemplateBase, class dWorldTemplateBase, class dBodyTemplateBase>
class dJointTemplate : public dJointTemplateBase {
    dJointTemplate(const dJointTemplate&);
    void operator=(const dJointTemplate&);

  protected:
    /** This class. */
    typedef dJointTemplate<dJointTemplateBase, dWorldTemplateBase, dBodyTemplateBase> dBaseTemplate;

    dJointTemplate() {}
    /** The number, for derived classes; its change; the end of the object. */
    dJointID get_id() const { return dJointTemplateBase::_id; }
    void set_id(dJointID value) { dJointTemplateBase::_id = value; }
    void destroy() { dJointTemplateBase::destroy(); }

  public:
    /** The joint's number, for the C functions; 0: there is none. */
    dJointID id() const { return get_id(); }
    operator dJointID() const { return get_id(); }

    /** The bodies: dJointAttach (body1, body2), dJointGetNumBodies, dJointGetBody (index). */
    int getNumBodies() const { return dJointGetNumBodies(get_id()); }
    void attach(dBodyID body1, dBodyID body2) { dJointAttach(get_id(), body1, body2); }
    void attach(dBodyTemplate<dBodyTemplateBase, dWorldTemplateBase>& body1,
                dBodyTemplate<dBodyTemplateBase, dWorldTemplateBase>& body2)
    {
        attach(body1.id(), body2.id());
    }
    dBodyID getBody(int index) const { return dJointGetBody(get_id(), index); }

    /** dJointEnable, dJointDisable, dJointIsEnabled, dJointGetType. */
    void enable() { dJointEnable(get_id()); }
    void disable() { dJointDisable(get_id()); }
    bool isEnabled() const { return dJointIsEnabled(get_id()) != 0; }
    dJointType getType() const { return dJointGetType(get_id()); }

    /** A pointer (data) of the program's, and where forces are reported to (fb): dJointSetData,
        dJointSetFeedback. */
    void setData(void* data) { dJointSetData(get_id(), data); }
    void* getData() const { return dJointGetData(get_id()); }
    void setFeedback(dJointFeedback* fb) { dJointSetFeedback(get_id(), fb); }
    dJointFeedback* getFeedback() const { return dJointGetFeedback(get_id()); }

    /** Parameters of the joint's type; a type without parameters ignores them and answers 0. */
    virtual void setParam(int, dReal) {}
    virtual dReal getParam(int) const { return 0; }
};

/** Makes joints of one type: make is the function of the C interface that does it. */
template <class dJointTemplateBase, class dWorldTemplateBase, class dBodyTemplateBase,
          dJointID (*make)(dWorldID, dJointGroupID)>
class dMadeJointTemplate : public dJointTemplate<dJointTemplateBase, dWorldTemplateBase, dBodyTemplateBase> {
  protected:
    dMadeJointTemplate() {}

  public:
    /** Make a new joint in the world, in the group or (0) alone; the one before is destroyed. */
    void create(dWorldID world, dJointGroupID group = 0)
    {
        this->destroy();
        this->set_id(make(world, group));
    }
    void create(dWorldTemplate<dWorldTemplateBase>& world, dJointGroupID group = 0)
    {
        create(world.id(), group);
    }
};

/** A ball joint: what dBallJoint is. */
template <class dJointTemplateBase, class dWorldTemplateBase, class dBodyTemplateBase>
class dBallJointTemplate
    : public dMadeJointTemplate<dJointTemplateBase, dWorldTemplateBase, dBodyTemplateBase, dJointCreateBall> {
  public:
    /** Without a world there is no joint yet; else it is made at once, in the group or (0) alone. */
    dBallJointTemplate() {}
    dBallJointTemplate(dWorldID world, dJointGroupID group = 0) { this->create(world, group); }
    dBallJointTemplate(dWorldTemplate<dWorldTemplateBase>& world, dJointGroupID group = 0)
    {
        this->create(world, group);
    }

    /** The anchor (x, y, z) or a: dJointSetBallAnchor; getAnchor writes body 1's, getAnchor2 body 2's result.
     */
    void setAnchor(dReal x, dReal y, dReal z) { dJointSetBallAnchor(this->get_id(), x, y, z); }
    void setAnchor(const dVector3 a) { setAnchor(a[0], a[1], a[2]); }
    void getAnchor(dVector3 result) const { dJointGetBallAnchor(this->get_id(), result); }
    void getAnchor2(dVector3 result) const { dJointGetBallAnchor2(this->get_id(), result); }

    /** dJointSetBallParam (parameter, value). */
    virtual void setParam(int parameter, dReal value)
    {
        dJointSetBallParam(this->get_id(), parameter, value);
    }
    virtual dReal getParam(int parameter) const { return dJointGetBallParam(this->get_id(), parameter); }
};

/** A hinge: what dHingeJoint is. */
template <class dJointTemplateBase, class dWorldTemplateBase, class dBodyTemplateBase>
class dHingeJointTemplate : public dMadeJointTemplate<dJointTemplateBase, dWorldTemplateBase,
                                                      dBodyTemplateBase, dJointCreateHinge> {
  public:
    /** Without a world there is no joint yet; else it is made at once, in the group or (0) alone. */
    dHingeJointTemplate() {}
    dHingeJointTemplate(dWorldID world, dJointGroupID group = 0) { this->create(world, group); }
    dHingeJointTemplate(dWorldTemplate<dWorldTemplateBase>& world, dJointGroupID group = 0)
    {
        this->create(world, group);
    }

    /** Anchor and axis, (x, y, z) or a: dJointSetHingeAnchor, dJointSetHingeAxis; the getters write result.
     */
    void setAnchor(dReal x, dReal y, dReal z) { dJointSetHingeAnchor(this->get_id(), x, y, z); }
    void setAnchor(const dVector3 a) { setAnchor(a[0], a[1], a[2]); }
    void getAnchor(dVector3 result) const { dJointGetHingeAnchor(this->get_id(), result); }
    void getAnchor2(dVector3 result) const { dJointGetHingeAnchor2(this->get_id(), result); }
    void setAxis(dReal x, dReal y, dReal z) { dJointSetHingeAxis(this->get_id(), x, y, z); }
    void setAxis(const dVector3 a) { setAxis(a[0], a[1], a[2]); }
    void getAxis(dVector3 result) const { dJointGetHingeAxis(this->get_id(), result); }

    /** dJointGetHingeAngle and its rate. */
    dReal getAngle() const { return dJointGetHingeAngle(this->get_id()); }
    dReal getAngleRate() const { return dJointGetHingeAngleRate(this->get_id()); }

    /** dJointSetHingeParam (parameter, value); dJointAddHingeTorque (torque). */
    virtual void setParam(int parameter, dReal value)
    {
        dJointSetHingeParam(this->get_id(), parameter, value);
    }
    virtual dReal getParam(int parameter) const { return dJointGetHingeParam(this->get_id(), parameter); }
    void addTorque(dReal torque) { dJointAddHingeTorque(this->get_id(), torque); }
};

/** A slider: what dSliderJoint is. */
template <class dJointTemplateBase, class dWorldTemplateBase, class dBodyTemplateBase>
class dSliderJointTemplate : public dMadeJointTemplate<dJointTemplateBase, dWorldTemplateBase,
                                                       dBodyTemplateBase, dJointCreateSlider> {
  public:
    /** Without a world there is no joint yet; else it is made at once, in the group or (0) alone. */
    dSliderJointTemplate() {}
    dSliderJointTemplate(dWorldID world, dJointGroupID group = 0) { this->create(world, group); }
    dSliderJointTemplate(dWorldTemplate<dWorldTemplateBase>& world, dJointGroupID group = 0)
    {
        this->create(world, group);
    }

    /** The axis (x, y, z) or a: dJointSetSliderAxis; getAxis writes result. */
    void setAxis(dReal x, dReal y, dReal z) { dJointSetSliderAxis(this->get_id(), x, y, z); }
    void setAxis(const dVector3 a) { setAxis(a[0], a[1], a[2]); }
    void getAxis(dVector3 result) const { dJointGetSliderAxis(this->get_id(), result); }

    /** dJointGetSliderPosition and its rate. */
    dReal getPosition() const { return dJointGetSliderPosition(this->get_id()); }
    dReal getPositionRate() const { return dJointGetSliderPositionRate(this->get_id()); }

    /** dJointSetSliderParam (parameter, value); dJointAddSliderForce (force). */
    virtual void setParam(int parameter, dReal value)
    {
        dJointSetSliderParam(this->get_id(), parameter, value);
    }
    virtual dReal getParam(int parameter) const { return dJointGetSliderParam(this->get_id(), parameter); }
    void addForce(dReal force) { dJointAddSliderForce(this->get_id(), force); }
};

/** A universal joint: what dUniversalJoint is. */
template <class dJointTemplateBase, class dWorldTemplateBase, class dBodyTemplateBase>
class dUniversalJointTemplate : public dMadeJointTemplate<dJointTemplateBase, dWorldTemplateBase,
                                                          dBodyTemplateBase, dJointCreateUniversal> {
  public:
    /** Without a world there is no joint yet; else it is made at once, in the group or (0) alone. */
    dUniversalJointTemplate() {}
    dUniversalJointTemplate(dWorldID world, dJointGroupID group = 0) { this->create(world, group); }
    dUniversalJointTemplate(dWorldTemplate<dWorldTemplateBase>& world, dJointGroupID group = 0)
    {
        this->create(world, group);
    }

    /** Anchor and axes, (x, y, z) or a: dJointSetUniversalAnchor and its neighbours; the getters write
     * result. */
    void setAnchor(dReal x, dReal y, dReal z) { dJointSetUniversalAnchor(this->get_id(), x, y, z); }
    void setAnchor(const dVector3 a) { setAnchor(a[0], a[1], a[2]); }
    void setAxis1(dReal x, dReal y, dReal z) { dJointSetUniversalAxis1(this->get_id(), x, y, z); }
    void setAxis1(const dVector3 a) { setAxis1(a[0], a[1], a[2]); }
    void setAxis2(dReal x, dReal y, dReal z) { dJointSetUniversalAxis2(this->get_id(), x, y, z); }
    void setAxis2(const dVector3 a) { setAxis2(a[0], a[1], a[2]); }
    void getAnchor(dVector3 result) const { dJointGetUniversalAnchor(this->get_id(), result); }
    void getAnchor2(dVector3 result) const { dJointGetUniversalAnchor2(this->get_id(), result); }
    void getAxis1(dVector3 result) const { dJointGetUniversalAxis1(this->get_id(), result); }
    void getAxis2(dVector3 result) const { dJointGetUniversalAxis2(this->get_id(), result); }

    /** dJointSetUniversalParam (parameter, value). */
    virtual void setParam(int parameter, dReal value)
    {
        dJointSetUniversalParam(this->get_id(), parameter, value);
    }
    virtual dReal getParam(int parameter) const { return dJointGetUniversalParam(this->get_id(), parameter); }

    /** Both angles (angle1, angle2), each angle, and the rates: dJointGetUniversalAngles and its neighbours.
     */
    void getAngles(dReal* angle1, dReal* angle2) const
    {
        dJointGetUniversalAngles(this->get_id(), angle1, angle2);
    }
    dReal getAngle1() const { return dJointGetUniversalAngle1(this->get_id()); }
    dReal getAngle1Rate() const { return dJointGetUniversalAngle1Rate(this->get_id()); }
    dReal getAngle2() const { return dJointGetUniversalAngle2(this->get_id()); }
    dReal getAngle2Rate() const { return dJointGetUniversalAngle2Rate(this->get_id()); }

    /** dJointAddUniversalTorques (torque1, torque2). */
    void addTorques(dReal torque1, dReal torque2)
    {
        dJointAddUniversalTorques(this->get_id(), torque1, torque2);
    }
};

/** A hinge-2 joint, a wheel: what dHinge2Joint is. */
template <class dJointTemplateBase, class dWorldTemplateBase, class dBodyTemplateBase>
class dHinge2JointTemplate : public dMadeJointTemplate<dJointTemplateBase, dWorldTemplateBase,
                                                       dBodyTemplateBase, dJointCreateHinge2> {
  public:
    /** Without a world there is no joint yet; else it is made at once, in the group or (0) alone. */
    dHinge2JointTemplate() {}
    dHinge2JointTemplate(dWorldID world, dJointGroupID group = 0) { this->create(world, group); }
    dHinge2JointTemplate(dWorldTemplate<dWorldTemplateBase>& world, dJointGroupID group = 0)
    {
        this->create(world, group);
    }

    /** Anchor and axes, (x, y, z) or a: dJointSetHinge2Anchor, dJointSetHinge2Axes (axis1, axis2); the
       getters write result. */
    void setAnchor(dReal x, dReal y, dReal z) { dJointSetHinge2Anchor(this->get_id(), x, y, z); }
    void setAnchor(const dVector3 a) { setAnchor(a[0], a[1], a[2]); }
    void setAxes(const dReal* axis1, const dReal* axis2)
    {
        dJointSetHinge2Axes(this->get_id(), axis1, axis2);
    }
    void setAxis1(dReal x, dReal y, dReal z)
    {
        dVector3 a = {x, y, z, 0};
        setAxis1(a);
    }
    void setAxis1(const dVector3 a) { setAxes(a, 0); }
    void setAxis2(dReal x, dReal y, dReal z)
    {
        dVector3 a = {x, y, z, 0};
        setAxis2(a);
    }
    void setAxis2(const dVector3 a) { setAxes(0, a); }
    void getAnchor(dVector3 result) const { dJointGetHinge2Anchor(this->get_id(), result); }
    void getAnchor2(dVector3 result) const { dJointGetHinge2Anchor2(this->get_id(), result); }
    void getAxis1(dVector3 result) const { dJointGetHinge2Axis1(this->get_id(), result); }
    void getAxis2(dVector3 result) const { dJointGetHinge2Axis2(this->get_id(), result); }

    /** The steering angle and the two rates: dJointGetHinge2Angle1 and its neighbours. */
    dReal getAngle1() const { return dJointGetHinge2Angle1(this->get_id()); }
    dReal getAngle1Rate() const { return dJointGetHinge2Angle1Rate(this->get_id()); }
    dReal getAngle2Rate() const { return dJointGetHinge2Angle2Rate(this->get_id()); }

    /** dJointSetHinge2Param (parameter, value); dJointAddHinge2Torques (torque1, torque2). */
    virtual void setParam(int parameter, dReal value)
    {
        dJointSetHinge2Param(this->get_id(), parameter, value);
    }
    virtual dReal getParam(int parameter) const { return dJointGetHinge2Param(this->get_id(), parameter); }
    void addTorques(dReal torque1, dReal torque2)
    {
        dJointAddHinge2Torques(this->get_id(), torque1, torque2);
    }
};

/** A prismatic-rotoid joint: what dPRJoint is. */
template <class dJointTemplateBase, class dWorldTemplateBase, class dBodyTemplateBase>
class dPRJointTemplate
    : public dMadeJointTemplate<dJointTemplateBase, dWorldTemplateBase, dBodyTemplateBase, dJointCreatePR> {
  public:
    /** Without a world there is no joint yet; else it is made at once, in the group or (0) alone. */
    dPRJointTemplate() {}
    dPRJointTemplate(dWorldID world, dJointGroupID group = 0) { this->create(world, group); }
    dPRJointTemplate(dWorldTemplate<dWorldTemplateBase>& world, dJointGroupID group = 0)
    {
        this->create(world, group);
    }

    /** Anchor and axes, (x, y, z) or a: dJointSetPRAnchor and its neighbours; the getters write result. */
    void setAnchor(dReal x, dReal y, dReal z) { dJointSetPRAnchor(this->get_id(), x, y, z); }
    void setAnchor(const dVector3 a) { setAnchor(a[0], a[1], a[2]); }
    void setAxis1(dReal x, dReal y, dReal z) { dJointSetPRAxis1(this->get_id(), x, y, z); }
    void setAxis1(const dVector3 a) { setAxis1(a[0], a[1], a[2]); }
    void setAxis2(dReal x, dReal y, dReal z) { dJointSetPRAxis2(this->get_id(), x, y, z); }
    void setAxis2(const dVector3 a) { setAxis2(a[0], a[1], a[2]); }
    void getAnchor(dVector3 result) const { dJointGetPRAnchor(this->get_id(), result); }
    void getAxis1(dVector3 result) const { dJointGetPRAxis1(this->get_id(), result); }
    void getAxis2(dVector3 result) const { dJointGetPRAxis2(this->get_id(), result); }

    /** Slide and turn, and their rates: dJointGetPRPosition, dJointGetPRAngle. */
    dReal getPosition() const { return dJointGetPRPosition(this->get_id()); }
    dReal getPositionRate() const { return dJointGetPRPositionRate(this->get_id()); }
    dReal getAngle() const { return dJointGetPRAngle(this->get_id()); }
    dReal getAngleRate() const { return dJointGetPRAngleRate(this->get_id()); }

    /** dJointSetPRParam (parameter, value). */
    virtual void setParam(int parameter, dReal value) { dJointSetPRParam(this->get_id(), parameter, value); }
    virtual dReal getParam(int parameter) const { return dJointGetPRParam(this->get_id(), parameter); }
};

/** A prismatic-universal joint: what dPUJoint is. Axis P is axis 3. */
template <class dJointTemplateBase, class dWorldTemplateBase, class dBodyTemplateBase>
class dPUJointTemplate
    : public dMadeJointTemplate<dJointTemplateBase, dWorldTemplateBase, dBodyTemplateBase, dJointCreatePU> {
  public:
    /** Without a world there is no joint yet; else it is made at once, in the group or (0) alone. */
    dPUJointTemplate() {}
    dPUJointTemplate(dWorldID world, dJointGroupID group = 0) { this->create(world, group); }
    dPUJointTemplate(dWorldTemplate<dWorldTemplateBase>& world, dJointGroupID group = 0)
    {
        this->create(world, group);
    }

    /** Anchor and axes, (x, y, z) or a: dJointSetPUAnchor and its neighbours; the getters write result. */
    void setAnchor(dReal x, dReal y, dReal z) { dJointSetPUAnchor(this->get_id(), x, y, z); }
    void setAnchor(const dVector3 a) { setAnchor(a[0], a[1], a[2]); }
    void setAxis1(dReal x, dReal y, dReal z) { dJointSetPUAxis1(this->get_id(), x, y, z); }
    void setAxis1(const dVector3 a) { setAxis1(a[0], a[1], a[2]); }
    void setAxis2(dReal x, dReal y, dReal z) { dJointSetPUAxis2(this->get_id(), x, y, z); }
    void setAxis2(const dVector3 a) { setAxis2(a[0], a[1], a[2]); }
    void setAxis3(dReal x, dReal y, dReal z) { dJointSetPUAxis3(this->get_id(), x, y, z); }
    void setAxis3(const dVector3 a) { setAxis3(a[0], a[1], a[2]); }
    void setAxisP(dReal x, dReal y, dReal z) { dJointSetPUAxisP(this->get_id(), x, y, z); }
    void setAxisP(const dVector3 a) { setAxisP(a[0], a[1], a[2]); }
    virtual void getAnchor(dVector3 result) const { dJointGetPUAnchor(this->get_id(), result); }
    void getAxis1(dVector3 result) const { dJointGetPUAxis1(this->get_id(), result); }
    void getAxis2(dVector3 result) const { dJointGetPUAxis2(this->get_id(), result); }
    void getAxis3(dVector3 result) const { dJointGetPUAxis3(this->get_id(), result); }
    void getAxisP(dVector3 result) const { dJointGetPUAxisP(this->get_id(), result); }

    /** Angles, position, and their rates: dJointGetPUAngle1 and its neighbours. */
    dReal getAngle1() const { return dJointGetPUAngle1(this->get_id()); }
    dReal getAngle1Rate() const { return dJointGetPUAngle1Rate(this->get_id()); }
    dReal getAngle2() const { return dJointGetPUAngle2(this->get_id()); }
    dReal getAngle2Rate() const { return dJointGetPUAngle2Rate(this->get_id()); }
    dReal getPosition() const { return dJointGetPUPosition(this->get_id()); }
    dReal getPositionRate() const { return dJointGetPUPositionRate(this->get_id()); }

    /** dJointSetPUParam (parameter, value). */
    virtual void setParam(int parameter, dReal value) { dJointSetPUParam(this->get_id(), parameter, value); }
    virtual dReal getParam(int parameter) const { return dJointGetPUParam(this->get_id(), parameter); }
};

/** A piston: what dPistonJoint is. */
template <class dJointTemplateBase, class dWorldTemplateBase, class dBodyTemplateBase>
class dPistonJointTemplate : public dMadeJointTemplate<dJointTemplateBase, dWorldTemplateBase,
                                                       dBodyTemplateBase, dJointCreatePiston> {
  public:
    /** Without a world there is no joint yet; else it is made at once, in the group or (0) alone. */
    dPistonJointTemplate() {}
    dPistonJointTemplate(dWorldID world, dJointGroupID group = 0) { this->create(world, group); }
    dPistonJointTemplate(dWorldTemplate<dWorldTemplateBase>& world, dJointGroupID group = 0)
    {
        this->create(world, group);
    }

    /** Anchor and axis, (x, y, z) or a: dJointSetPistonAnchor, dJointSetPistonAxis; the getters write result.
     */
    void setAnchor(dReal x, dReal y, dReal z) { dJointSetPistonAnchor(this->get_id(), x, y, z); }
    void setAnchor(const dVector3 a) { setAnchor(a[0], a[1], a[2]); }
    void getAnchor(dVector3 result) const { dJointGetPistonAnchor(this->get_id(), result); }
    void getAnchor2(dVector3 result) const { dJointGetPistonAnchor2(this->get_id(), result); }
    void setAxis(dReal x, dReal y, dReal z) { dJointSetPistonAxis(this->get_id(), x, y, z); }
    void setAxis(const dVector3 a) { setAxis(a[0], a[1], a[2]); }
    void getAxis(dVector3 result) const { dJointGetPistonAxis(this->get_id(), result); }

    /** dJointGetPistonPosition and its rate. */
    dReal getPosition() const { return dJointGetPistonPosition(this->get_id()); }
    dReal getPositionRate() const { return dJointGetPistonPositionRate(this->get_id()); }

    /** dJointSetPistonParam (parameter, value); dJointAddPistonForce (force). */
    virtual void setParam(int parameter, dReal value)
    {
        dJointSetPistonParam(this->get_id(), parameter, value);
    }
    virtual dReal getParam(int parameter) const { return dJointGetPistonParam(this->get_id(), parameter); }
    void addForce(dReal force) { dJointAddPistonForce(this->get_id(), force); }
};

/** A fixed joint: what dFixedJoint is. */
template <class dJointTemplateBase, class dWorldTemplateBase, class dBodyTemplateBase>
class dFixedJointTemplate : public dMadeJointTemplate<dJointTemplateBase, dWorldTemplateBase,
                                                      dBodyTemplateBase, dJointCreateFixed> {
  public:
    /** Without a world there is no joint yet; else it is made at once, in the group or (0) alone. */
    dFixedJointTemplate() {}
    dFixedJointTemplate(dWorldID world, dJointGroupID group = 0) { this->create(world, group); }
    dFixedJointTemplate(dWorldTemplate<dWorldTemplateBase>& world, dJointGroupID group = 0)
    {
        this->create(world, group);
    }

    /** Keep the pose the bodies have now: dJointSetFixed. */
    void set() { dJointSetFixed(this->get_id()); }

    /** dJointSetFixedParam (parameter, value). */
    virtual void setParam(int parameter, dReal value)
    {
        dJointSetFixedParam(this->get_id(), parameter, value);
    }
    virtual dReal getParam(int parameter) const { return dJointGetFixedParam(this->get_id(), parameter); }
};

/** A joint without constraint: what dNullJoint is. */
template <class dJointTemplateBase, class dWorldTemplateBase, class dBodyTemplateBase>
class dNullJointTemplate
    : public dMadeJointTemplate<dJointTemplateBase, dWorldTemplateBase, dBodyTemplateBase, dJointCreateNull> {
  public:
    /** Without a world there is no joint yet; else it is made at once, in the group or (0) alone. */
    dNullJointTemplate() {}
    dNullJointTemplate(dWorldID world, dJointGroupID group = 0) { this->create(world, group); }
    dNullJointTemplate(dWorldTemplate<dWorldTemplateBase>& world, dJointGroupID group = 0)
    {
        this->create(world, group);
    }
};

/** An angular motor: what dAMotorJoint is. */
template <class dJointTemplateBase, class dWorldTemplateBase, class dBodyTemplateBase>
class dAMotorJointTemplate : public dMadeJointTemplate<dJointTemplateBase, dWorldTemplateBase,
                                                       dBodyTemplateBase, dJointCreateAMotor> {
  public:
    /** Without a world there is no joint yet; else it is made at once, in the group or (0) alone. */
    dAMotorJointTemplate() {}
    dAMotorJointTemplate(dWorldID world, dJointGroupID group = 0) { this->create(world, group); }
    dAMotorJointTemplate(dWorldTemplate<dWorldTemplateBase>& world, dJointGroupID group = 0)
    {
        this->create(world, group);
    }

    /** The mode and the number (num) of axes: dJointSetAMotorMode, dJointSetAMotorNumAxes. */
    void setMode(int mode) { dJointSetAMotorMode(this->get_id(), mode); }
    int getMode() const { return dJointGetAMotorMode(this->get_id()); }
    void setNumAxes(int num) { dJointSetAMotorNumAxes(this->get_id(), num); }
    int getNumAxes() const { return dJointGetAMotorNumAxes(this->get_id()); }

    /** Axis anum, fixed to rel, (x, y, z) or a: dJointSetAMotorAxis; getAxis writes result. */
    void setAxis(int anum, int rel, dReal x, dReal y, dReal z)
    {
        dJointSetAMotorAxis(this->get_id(), anum, rel, x, y, z);
    }
    void setAxis(int anum, int rel, const dVector3 a) { setAxis(anum, rel, a[0], a[1], a[2]); }
    void getAxis(int anum, dVector3 result) const { dJointGetAMotorAxis(this->get_id(), anum, result); }
    int getAxisRel(int anum) const { return dJointGetAMotorAxisRel(this->get_id(), anum); }

    /** The angle about axis anum and its rate: dJointSetAMotorAngle. */
    void setAngle(int anum, dReal angle) { dJointSetAMotorAngle(this->get_id(), anum, angle); }
    dReal getAngle(int anum) const { return dJointGetAMotorAngle(this->get_id(), anum); }
    dReal getAngleRate(int anum) const { return dJointGetAMotorAngleRate(this->get_id(), anum); }

    /** dJointSetAMotorParam (parameter, value); dJointAddAMotorTorques (torque1, torque2, torque3). */
    virtual void setParam(int parameter, dReal value)
    {
        dJointSetAMotorParam(this->get_id(), parameter, value);
    }
    virtual dReal getParam(int parameter) const { return dJointGetAMotorParam(this->get_id(), parameter); }
    void addTorques(dReal torque1, dReal torque2, dReal torque3)
    {
        dJointAddAMotorTorques(this->get_id(), torque1, torque2, torque3);
    }
};

/** A linear motor: what dLMotorJoint is. */
template <class dJointTemplateBase, class dWorldTemplateBase, class dBodyTemplateBase>
class dLMotorJointTemplate : public dMadeJointTemplate<dJointTemplateBase, dWorldTemplateBase,
                                                       dBodyTemplateBase, dJointCreateLMotor> {
  public:
    /** Without a world there is no joint yet; else it is made at once, in the group or (0) alone. */
    dLMotorJointTemplate() {}
    dLMotorJointTemplate(dWorldID world, dJointGroupID group = 0) { this->create(world, group); }
    dLMotorJointTemplate(dWorldTemplate<dWorldTemplateBase>& world, dJointGroupID group = 0)
    {
        this->create(world, group);
    }

    /** The number (num) of axes; axis anum, fixed to rel, (x, y, z) or a: dJointSetLMotorAxis; getAxis writes
     * result. */
    void setNumAxes(int num) { dJointSetLMotorNumAxes(this->get_id(), num); }
    int getNumAxes() const { return dJointGetLMotorNumAxes(this->get_id()); }
    void setAxis(int anum, int rel, dReal x, dReal y, dReal z)
    {
        dJointSetLMotorAxis(this->get_id(), anum, rel, x, y, z);
    }
    void setAxis(int anum, int rel, const dVector3 a) { setAxis(anum, rel, a[0], a[1], a[2]); }
    void getAxis(int anum, dVector3 result) const { dJointGetLMotorAxis(this->get_id(), anum, result); }

    /** dJointSetLMotorParam (parameter, value). */
    virtual void setParam(int parameter, dReal value)
    {
        dJointSetLMotorParam(this->get_id(), parameter, value);
    }
    virtual dReal getParam(int parameter) const { return dJointGetLMotorParam(this->get_id(), parameter); }
};

/** A contact joint: what dContactJoint is. It has no parameters; all is said in the contact it is made from.
 */
template <class dJointTemplateBase, class dWorldTemplateBase, class dBodyTemplateBase>
class dContactJointTemplate
    : public dJointTemplate<dJointTemplateBase, dWorldTemplateBase, dBodyTemplateBase> {
  public:
    /** Without a world there is no joint yet; else it is made at once, from *contact. */
    dContactJointTemplate() {}
    dContactJointTemplate(dWorldID world, dJointGroupID group, dContact* contact)
    {
        create(world, group, contact);
    }
    dContactJointTemplate(dWorldTemplate<dWorldTemplateBase>& world, dJointGroupID group, dContact* contact)
    {
        create(world.id(), group, contact);
    }

    /** Make a new joint from *contact in the group or (0) alone; the one before is destroyed. */
    void create(dWorldID world, dJointGroupID group, dContact* contact)
    {
        this->destroy();
        this->set_id(dJointCreateContact(world, group, contact));
    }
    void create(dWorldTemplate<dWorldTemplateBase>& world, dJointGroupID group, dContact* contact)
    {
        create(world.id(), group, contact);
    }
};

#endif
#endif
