// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The classes of the joint types, member by member. Each test has two equal worlds with two bodies on a
// joint: one joint is a wrapper, the other a plain number.
#include "joint_rig.h"

namespace {

Numbers read_ball(dJointID j)
{
    Numbers n = read_joint(j);
    dVector3 v = {0, 0, 0, 0};
    dJointGetBallAnchor(j, v);
    append(n, v, 3);
    dJointGetBallAnchor2(j, v);
    append(n, v, 3);
    append_params(n, dJointGetBallParam, j);
    return n;
}

void test_ball()
{
    Rig rig;
    dBallJoint a(rig.wrapped.world, rig.wrapped.group.id());
    dJointID b = dJointCreateBall(rig.plain.world, rig.plain.group);
    const dVector3 v = {REAL(0.5), 2, -1, 0};
    test_making<dBallJoint>("Ball", rig, dJointTypeBall);
    rig.attach(a, b);
    SET("dBallJointTemplate::setAnchor", read_ball, a, b, a.setAnchor(1, REAL(0.25), 3),
        dJointSetBallAnchor(b, 1, REAL(0.25), 3));
    SET("dBallJointTemplate::setAnchor array", read_ball, a, b, a.setAnchor(v),
        dJointSetBallAnchor(b, v[0], v[1], v[2]));
    SET("dBallJointTemplate::setParam", read_ball, a, b, a.setParam(dParamCFM, REAL(0.125)),
        dJointSetBallParam(b, dParamCFM, REAL(0.125)));
    judge_get("dBallJointTemplate::getParam", a.getParam(dParamCFM), dJointGetBallParam(b, dParamCFM));
    const dJoint& base = a;
    judge_get("dBallJointTemplate::getParam through dJoint", base.getParam(dParamCFM), REAL(0.125));
    rig.step();
    GET_ARRAY("dBallJointTemplate::getAnchor", 3, a.getAnchor(out), dJointGetBallAnchor(b, out));
    GET_ARRAY("dBallJointTemplate::getAnchor2", 3, a.getAnchor2(out), dJointGetBallAnchor2(b, out));
}

Numbers read_hinge(dJointID j)
{
    Numbers n = read_joint(j);
    dVector3 v = {0, 0, 0, 0};
    dJointGetHingeAnchor(j, v);
    append(n, v, 3);
    dJointGetHingeAnchor2(j, v);
    append(n, v, 3);
    dJointGetHingeAxis(j, v);
    append(n, v, 3);
    n.push_back(dJointGetHingeAngle(j));
    n.push_back(dJointGetHingeAngleRate(j));
    append_params(n, dJointGetHingeParam, j);
    return n;
}

void test_hinge()
{
    Rig rig;
    dHingeJoint a(rig.wrapped.world, rig.wrapped.group.id());
    dJointID b = dJointCreateHinge(rig.plain.world, rig.plain.group);
    const dVector3 v = {REAL(0.5), 2, -1, 0};
    test_making<dHingeJoint>("Hinge", rig, dJointTypeHinge);
    rig.attach(a, b);
    SET("dHingeJointTemplate::setAnchor", read_hinge, a, b, a.setAnchor(1, REAL(0.25), 3),
        dJointSetHingeAnchor(b, 1, REAL(0.25), 3));
    SET("dHingeJointTemplate::setAnchor array", read_hinge, a, b, a.setAnchor(v),
        dJointSetHingeAnchor(b, v[0], v[1], v[2]));
    SET("dHingeJointTemplate::setAxis", read_hinge, a, b, a.setAxis(1, REAL(0.25), 3),
        dJointSetHingeAxis(b, 1, REAL(0.25), 3));
    SET("dHingeJointTemplate::setAxis array", read_hinge, a, b, a.setAxis(v),
        dJointSetHingeAxis(b, v[0], v[1], v[2]));
    SET("dHingeJointTemplate::setParam", read_hinge, a, b, a.setParam(dParamFMax, REAL(0.125)),
        dJointSetHingeParam(b, dParamFMax, REAL(0.125)));
    judge_get("dHingeJointTemplate::getParam", a.getParam(dParamFMax), dJointGetHingeParam(b, dParamFMax));
    const dJoint& base = a;
    judge_get("dHingeJointTemplate::getParam through dJoint", base.getParam(dParamFMax), REAL(0.125));
    rig.step();
    GET_ARRAY("dHingeJointTemplate::getAnchor", 3, a.getAnchor(out), dJointGetHingeAnchor(b, out));
    GET_ARRAY("dHingeJointTemplate::getAnchor2", 3, a.getAnchor2(out), dJointGetHingeAnchor2(b, out));
    GET_ARRAY("dHingeJointTemplate::getAxis", 3, a.getAxis(out), dJointGetHingeAxis(b, out));
    judge_get("dHingeJointTemplate::getAngle", a.getAngle(), dJointGetHingeAngle(b));
    judge_get("dHingeJointTemplate::getAngleRate", a.getAngleRate(), dJointGetHingeAngleRate(b));
    const Numbers before = rig.wrapped.read_bodies();
    a.addTorque(7);
    dJointAddHingeTorque(b, 7);
    judge_set("dHingeJointTemplate::addTorque", before, rig.wrapped.read_bodies(), rig.plain.read_bodies());
}

Numbers read_slider(dJointID j)
{
    Numbers n = read_joint(j);
    dVector3 v = {0, 0, 0, 0};
    dJointGetSliderAxis(j, v);
    append(n, v, 3);
    n.push_back(dJointGetSliderPosition(j));
    n.push_back(dJointGetSliderPositionRate(j));
    append_params(n, dJointGetSliderParam, j);
    return n;
}

void test_slider()
{
    Rig rig;
    dSliderJoint a(rig.wrapped.world, rig.wrapped.group.id());
    dJointID b = dJointCreateSlider(rig.plain.world, rig.plain.group);
    const dVector3 v = {REAL(0.5), 2, -1, 0};
    test_making<dSliderJoint>("Slider", rig, dJointTypeSlider);
    rig.attach(a, b);
    SET("dSliderJointTemplate::setAxis", read_slider, a, b, a.setAxis(1, REAL(0.25), 3),
        dJointSetSliderAxis(b, 1, REAL(0.25), 3));
    SET("dSliderJointTemplate::setAxis array", read_slider, a, b, a.setAxis(v),
        dJointSetSliderAxis(b, v[0], v[1], v[2]));
    SET("dSliderJointTemplate::setParam", read_slider, a, b, a.setParam(dParamFMax, REAL(0.125)),
        dJointSetSliderParam(b, dParamFMax, REAL(0.125)));
    judge_get("dSliderJointTemplate::getParam", a.getParam(dParamFMax), dJointGetSliderParam(b, dParamFMax));
    const dJoint& base = a;
    judge_get("dSliderJointTemplate::getParam through dJoint", base.getParam(dParamFMax), REAL(0.125));
    rig.step();
    GET_ARRAY("dSliderJointTemplate::getAxis", 3, a.getAxis(out), dJointGetSliderAxis(b, out));
    judge_get("dSliderJointTemplate::getPosition", a.getPosition(), dJointGetSliderPosition(b));
    judge_get("dSliderJointTemplate::getPositionRate", a.getPositionRate(), dJointGetSliderPositionRate(b));
    const Numbers before = rig.wrapped.read_bodies();
    a.addForce(7);
    dJointAddSliderForce(b, 7);
    judge_set("dSliderJointTemplate::addForce", before, rig.wrapped.read_bodies(), rig.plain.read_bodies());
}

Numbers read_universal(dJointID j)
{
    Numbers n = read_joint(j);
    dVector3 v = {0, 0, 0, 0};
    dJointGetUniversalAnchor(j, v);
    append(n, v, 3);
    dJointGetUniversalAnchor2(j, v);
    append(n, v, 3);
    dJointGetUniversalAxis1(j, v);
    append(n, v, 3);
    dJointGetUniversalAxis2(j, v);
    append(n, v, 3);
    n.push_back(dJointGetUniversalAngle1(j));
    n.push_back(dJointGetUniversalAngle1Rate(j));
    n.push_back(dJointGetUniversalAngle2(j));
    n.push_back(dJointGetUniversalAngle2Rate(j));
    append_params(n, dJointGetUniversalParam, j);
    return n;
}

void test_universal()
{
    Rig rig;
    dUniversalJoint a(rig.wrapped.world, rig.wrapped.group.id());
    dJointID b = dJointCreateUniversal(rig.plain.world, rig.plain.group);
    const dVector3 v = {REAL(0.5), 2, -1, 0};
    test_making<dUniversalJoint>("Universal", rig, dJointTypeUniversal);
    rig.attach(a, b);
    SET("dUniversalJointTemplate::setAnchor", read_universal, a, b, a.setAnchor(1, REAL(0.25), 3),
        dJointSetUniversalAnchor(b, 1, REAL(0.25), 3));
    SET("dUniversalJointTemplate::setAnchor array", read_universal, a, b, a.setAnchor(v),
        dJointSetUniversalAnchor(b, v[0], v[1], v[2]));
    const dVector3 axis1 = {0, 0, 2, 0}, axis2 = {1, 0, 0, 0};
    SET("dUniversalJointTemplate::setAxis1", read_universal, a, b, a.setAxis1(0, 1, 3),
        dJointSetUniversalAxis1(b, 0, 1, 3));
    SET("dUniversalJointTemplate::setAxis1 array", read_universal, a, b, a.setAxis1(axis1),
        dJointSetUniversalAxis1(b, axis1[0], axis1[1], axis1[2]));
    SET("dUniversalJointTemplate::setAxis2", read_universal, a, b, a.setAxis2(3, 1, 0),
        dJointSetUniversalAxis2(b, 3, 1, 0));
    SET("dUniversalJointTemplate::setAxis2 array", read_universal, a, b, a.setAxis2(axis2),
        dJointSetUniversalAxis2(b, axis2[0], axis2[1], axis2[2]));
    SET("dUniversalJointTemplate::setParam", read_universal, a, b, a.setParam(dParamFMax2, REAL(0.125)),
        dJointSetUniversalParam(b, dParamFMax2, REAL(0.125)));
    judge_get("dUniversalJointTemplate::getParam", a.getParam(dParamFMax2),
              dJointGetUniversalParam(b, dParamFMax2));
    const dJoint& base = a;
    judge_get("dUniversalJointTemplate::getParam through dJoint", base.getParam(dParamFMax2), REAL(0.125));
    rig.step();
    GET_ARRAY("dUniversalJointTemplate::getAnchor", 3, a.getAnchor(out), dJointGetUniversalAnchor(b, out));
    GET_ARRAY("dUniversalJointTemplate::getAnchor2", 3, a.getAnchor2(out), dJointGetUniversalAnchor2(b, out));
    GET_ARRAY("dUniversalJointTemplate::getAxis1", 3, a.getAxis1(out), dJointGetUniversalAxis1(b, out));
    GET_ARRAY("dUniversalJointTemplate::getAxis2", 3, a.getAxis2(out), dJointGetUniversalAxis2(b, out));
    judge_get("dUniversalJointTemplate::getAngle1", a.getAngle1(), dJointGetUniversalAngle1(b));
    judge_get("dUniversalJointTemplate::getAngle1Rate", a.getAngle1Rate(), dJointGetUniversalAngle1Rate(b));
    judge_get("dUniversalJointTemplate::getAngle2", a.getAngle2(), dJointGetUniversalAngle2(b));
    judge_get("dUniversalJointTemplate::getAngle2Rate", a.getAngle2Rate(), dJointGetUniversalAngle2Rate(b));
    GET_ARRAY("dUniversalJointTemplate::getAngles", 2, a.getAngles(&out[0], &out[1]),
              dJointGetUniversalAngles(b, &out[0], &out[1]));
    const Numbers before = rig.wrapped.read_bodies();
    a.addTorques(7, 5);
    dJointAddUniversalTorques(b, 7, 5);
    judge_set("dUniversalJointTemplate::addTorques", before, rig.wrapped.read_bodies(),
              rig.plain.read_bodies());
}

Numbers read_hinge2(dJointID j)
{
    Numbers n = read_joint(j);
    dVector3 v = {0, 0, 0, 0};
    dJointGetHinge2Anchor(j, v);
    append(n, v, 3);
    dJointGetHinge2Anchor2(j, v);
    append(n, v, 3);
    dJointGetHinge2Axis1(j, v);
    append(n, v, 3);
    dJointGetHinge2Axis2(j, v);
    append(n, v, 3);
    n.push_back(dJointGetHinge2Angle1(j));
    n.push_back(dJointGetHinge2Angle1Rate(j));
    n.push_back(dJointGetHinge2Angle2Rate(j));
    append_params(n, dJointGetHinge2Param, j);
    return n;
}

void test_hinge2()
{
    Rig rig;
    dHinge2Joint a(rig.wrapped.world, rig.wrapped.group.id());
    dJointID b = dJointCreateHinge2(rig.plain.world, rig.plain.group);
    const dVector3 v = {REAL(0.5), 2, -1, 0};
    test_making<dHinge2Joint>("Hinge2", rig, dJointTypeHinge2);
    rig.attach(a, b);
    SET("dHinge2JointTemplate::setAnchor", read_hinge2, a, b, a.setAnchor(1, REAL(0.25), 3),
        dJointSetHinge2Anchor(b, 1, REAL(0.25), 3));
    SET("dHinge2JointTemplate::setAnchor array", read_hinge2, a, b, a.setAnchor(v),
        dJointSetHinge2Anchor(b, v[0], v[1], v[2]));
    const dVector3 up = {0, 0, 2, 0}, across = {0, 3, 1, 0};
    SET("dHinge2JointTemplate::setAxes", read_hinge2, a, b, a.setAxes(up, across),
        dJointSetHinge2Axes(b, up, across));
    SET("dHinge2JointTemplate::setAxis1", read_hinge2, a, b, a.setAxis1(1, REAL(0.25), 3),
        dJointSetHinge2Axis1(b, 1, REAL(0.25), 3));
    SET("dHinge2JointTemplate::setAxis1 array", read_hinge2, a, b, a.setAxis1(v),
        dJointSetHinge2Axis1(b, v[0], v[1], v[2]));
    SET("dHinge2JointTemplate::setAxis2", read_hinge2, a, b, a.setAxis2(1, REAL(0.25), 3),
        dJointSetHinge2Axis2(b, 1, REAL(0.25), 3));
    SET("dHinge2JointTemplate::setAxis2 array", read_hinge2, a, b, a.setAxis2(across),
        dJointSetHinge2Axis2(b, 0, 3, 1));
    SET("dHinge2JointTemplate::setParam", read_hinge2, a, b, a.setParam(dParamVel2, REAL(0.125)),
        dJointSetHinge2Param(b, dParamVel2, REAL(0.125)));
    judge_get("dHinge2JointTemplate::getParam", a.getParam(dParamVel2), dJointGetHinge2Param(b, dParamVel2));
    const dJoint& base = a;
    judge_get("dHinge2JointTemplate::getParam through dJoint", base.getParam(dParamVel2), REAL(0.125));
    rig.step();
    GET_ARRAY("dHinge2JointTemplate::getAnchor", 3, a.getAnchor(out), dJointGetHinge2Anchor(b, out));
    GET_ARRAY("dHinge2JointTemplate::getAnchor2", 3, a.getAnchor2(out), dJointGetHinge2Anchor2(b, out));
    GET_ARRAY("dHinge2JointTemplate::getAxis1", 3, a.getAxis1(out), dJointGetHinge2Axis1(b, out));
    GET_ARRAY("dHinge2JointTemplate::getAxis2", 3, a.getAxis2(out), dJointGetHinge2Axis2(b, out));
    judge_get("dHinge2JointTemplate::getAngle1", a.getAngle1(), dJointGetHinge2Angle1(b));
    judge_get("dHinge2JointTemplate::getAngle1Rate", a.getAngle1Rate(), dJointGetHinge2Angle1Rate(b));
    judge_get("dHinge2JointTemplate::getAngle2Rate", a.getAngle2Rate(), dJointGetHinge2Angle2Rate(b));
    const Numbers before = rig.wrapped.read_bodies();
    a.addTorques(7, 5);
    dJointAddHinge2Torques(b, 7, 5);
    judge_set("dHinge2JointTemplate::addTorques", before, rig.wrapped.read_bodies(), rig.plain.read_bodies());
}

Numbers read_pr(dJointID j)
{
    Numbers n = read_joint(j);
    dVector3 v = {0, 0, 0, 0};
    dJointGetPRAnchor(j, v);
    append(n, v, 3);
    dJointGetPRAxis1(j, v);
    append(n, v, 3);
    dJointGetPRAxis2(j, v);
    append(n, v, 3);
    n.push_back(dJointGetPRPosition(j));
    n.push_back(dJointGetPRPositionRate(j));
    n.push_back(dJointGetPRAngle(j));
    n.push_back(dJointGetPRAngleRate(j));
    append_params(n, dJointGetPRParam, j);
    return n;
}

void test_pr()
{
    Rig rig(false);
    dPRJoint a(rig.wrapped.world, rig.wrapped.group.id());
    dJointID b = dJointCreatePR(rig.plain.world, rig.plain.group);
    const dVector3 v = {REAL(0.5), 2, -1, 0};
    test_making<dPRJoint>("PR", rig, dJointTypePR);
    rig.attach(a, b);
    SET("dPRJointTemplate::setAnchor", read_pr, a, b, a.setAnchor(1, REAL(0.25), 3),
        dJointSetPRAnchor(b, 1, REAL(0.25), 3));
    SET("dPRJointTemplate::setAnchor array", read_pr, a, b, a.setAnchor(v),
        dJointSetPRAnchor(b, v[0], v[1], v[2]));
    const dVector3 axis1 = {0, 0, 2, 0}, axis2 = {1, 0, 0, 0};
    SET("dPRJointTemplate::setAxis1", read_pr, a, b, a.setAxis1(0, 1, 3), dJointSetPRAxis1(b, 0, 1, 3));
    SET("dPRJointTemplate::setAxis1 array", read_pr, a, b, a.setAxis1(axis1),
        dJointSetPRAxis1(b, axis1[0], axis1[1], axis1[2]));
    SET("dPRJointTemplate::setAxis2", read_pr, a, b, a.setAxis2(3, 1, 0), dJointSetPRAxis2(b, 3, 1, 0));
    SET("dPRJointTemplate::setAxis2 array", read_pr, a, b, a.setAxis2(axis2),
        dJointSetPRAxis2(b, axis2[0], axis2[1], axis2[2]));
    SET("dPRJointTemplate::setParam", read_pr, a, b, a.setParam(dParamFMax2, REAL(0.125)),
        dJointSetPRParam(b, dParamFMax2, REAL(0.125)));
    judge_get("dPRJointTemplate::getParam", a.getParam(dParamFMax2), dJointGetPRParam(b, dParamFMax2));
    const dJoint& base = a;
    judge_get("dPRJointTemplate::getParam through dJoint", base.getParam(dParamFMax2), REAL(0.125));
    GET_ARRAY("dPRJointTemplate::getAnchor", 3, a.getAnchor(out), dJointGetPRAnchor(b, out));
    GET_ARRAY("dPRJointTemplate::getAxis1", 3, a.getAxis1(out), dJointGetPRAxis1(b, out));
    GET_ARRAY("dPRJointTemplate::getAxis2", 3, a.getAxis2(out), dJointGetPRAxis2(b, out));
    judge_get("dPRJointTemplate::getPosition", a.getPosition(), dJointGetPRPosition(b));
    judge_get("dPRJointTemplate::getPositionRate", a.getPositionRate(), dJointGetPRPositionRate(b));
    judge_get("dPRJointTemplate::getAngle", a.getAngle(), dJointGetPRAngle(b));
    judge_get("dPRJointTemplate::getAngleRate", a.getAngleRate(), dJointGetPRAngleRate(b));
}

Numbers read_pu(dJointID j)
{
    Numbers n = read_joint(j);
    dVector3 v = {0, 0, 0, 0};
    dJointGetPUAnchor(j, v);
    append(n, v, 3);
    dJointGetPUAxis1(j, v);
    append(n, v, 3);
    dJointGetPUAxis2(j, v);
    append(n, v, 3);
    dJointGetPUAxis3(j, v);
    append(n, v, 3);
    dJointGetPUAxisP(j, v);
    append(n, v, 3);
    n.push_back(dJointGetPUAngle1(j));
    n.push_back(dJointGetPUAngle1Rate(j));
    n.push_back(dJointGetPUAngle2(j));
    n.push_back(dJointGetPUAngle2Rate(j));
    n.push_back(dJointGetPUPosition(j));
    n.push_back(dJointGetPUPositionRate(j));
    append_params(n, dJointGetPUParam, j);
    return n;
}

void test_pu()
{
    Rig rig(false);
    dPUJoint a(rig.wrapped.world, rig.wrapped.group.id());
    dJointID b = dJointCreatePU(rig.plain.world, rig.plain.group);
    const dVector3 v = {REAL(0.5), 2, -1, 0};
    test_making<dPUJoint>("PU", rig, dJointTypePU);
    rig.attach(a, b);
    SET("dPUJointTemplate::setAnchor", read_pu, a, b, a.setAnchor(1, REAL(0.25), 3),
        dJointSetPUAnchor(b, 1, REAL(0.25), 3));
    SET("dPUJointTemplate::setAnchor array", read_pu, a, b, a.setAnchor(v),
        dJointSetPUAnchor(b, v[0], v[1], v[2]));
    const dVector3 axis1 = {0, 0, 2, 0}, axis2 = {1, 0, 0, 0};
    SET("dPUJointTemplate::setAxis2", read_pu, a, b, a.setAxis2(3, 1, 0), dJointSetPUAxis2(b, 3, 1, 0));
#ifdef _ODE_ODECPP_DYNAMICS_H_
    // Debian's class has no such form; this is the one member more that ours has.
    SET("dPUJointTemplate::setAxis2 array (ours)", read_pu, a, b, a.setAxis2(axis2),
        dJointSetPUAxis2(b, axis2[0], axis2[1], axis2[2]));
#else
    dJointSetPUAxis2(a, axis2[0], axis2[1], axis2[2]);
    dJointSetPUAxis2(b, axis2[0], axis2[1], axis2[2]);
#endif
    SET("dPUJointTemplate::setAxis1", read_pu, a, b, a.setAxis1(0, 1, 3), dJointSetPUAxis1(b, 0, 1, 3));
    SET("dPUJointTemplate::setAxis1 array", read_pu, a, b, a.setAxis1(axis1),
        dJointSetPUAxis1(b, axis1[0], axis1[1], axis1[2]));
    SET("dPUJointTemplate::setAxis3", read_pu, a, b, a.setAxis3(1, 1, 1), dJointSetPUAxis3(b, 1, 1, 1));
    SET("dPUJointTemplate::setAxis3 array", read_pu, a, b, a.setAxis3(v),
        dJointSetPUAxis3(b, v[0], v[1], v[2]));
    SET("dPUJointTemplate::setAxisP", read_pu, a, b, a.setAxisP(0, 1, 1), dJointSetPUAxisP(b, 0, 1, 1));
    SET("dPUJointTemplate::setAxisP array", read_pu, a, b, a.setAxisP(v),
        dJointSetPUAxisP(b, v[0], v[1], v[2]));
    SET("dPUJointTemplate::setParam", read_pu, a, b, a.setParam(dParamFMax3, REAL(0.125)),
        dJointSetPUParam(b, dParamFMax3, REAL(0.125)));
    judge_get("dPUJointTemplate::getParam", a.getParam(dParamFMax3), dJointGetPUParam(b, dParamFMax3));
    const dJoint& base = a;
    judge_get("dPUJointTemplate::getParam through dJoint", base.getParam(dParamFMax3), REAL(0.125));
    GET_ARRAY("dPUJointTemplate::getAnchor", 3, a.getAnchor(out), dJointGetPUAnchor(b, out));
    GET_ARRAY("dPUJointTemplate::getAxis1", 3, a.getAxis1(out), dJointGetPUAxis1(b, out));
    GET_ARRAY("dPUJointTemplate::getAxis2", 3, a.getAxis2(out), dJointGetPUAxis2(b, out));
    GET_ARRAY("dPUJointTemplate::getAxis3", 3, a.getAxis3(out), dJointGetPUAxis3(b, out));
    GET_ARRAY("dPUJointTemplate::getAxisP", 3, a.getAxisP(out), dJointGetPUAxisP(b, out));
    judge_get("dPUJointTemplate::getAngle1", a.getAngle1(), dJointGetPUAngle1(b));
    judge_get("dPUJointTemplate::getAngle1Rate", a.getAngle1Rate(), dJointGetPUAngle1Rate(b));
    judge_get("dPUJointTemplate::getAngle2", a.getAngle2(), dJointGetPUAngle2(b));
    judge_get("dPUJointTemplate::getAngle2Rate", a.getAngle2Rate(), dJointGetPUAngle2Rate(b));
    judge_get("dPUJointTemplate::getPosition", a.getPosition(), dJointGetPUPosition(b));
    judge_get("dPUJointTemplate::getPositionRate", a.getPositionRate(), dJointGetPUPositionRate(b));
}

Numbers read_piston(dJointID j)
{
    Numbers n = read_joint(j);
    dVector3 v = {0, 0, 0, 0};
    dJointGetPistonAnchor(j, v);
    append(n, v, 3);
    dJointGetPistonAnchor2(j, v);
    append(n, v, 3);
    dJointGetPistonAxis(j, v);
    append(n, v, 3);
    n.push_back(dJointGetPistonPosition(j));
    n.push_back(dJointGetPistonPositionRate(j));
    append_params(n, dJointGetPistonParam, j);
    return n;
}

void test_piston()
{
    Rig rig;
    dPistonJoint a(rig.wrapped.world, rig.wrapped.group.id());
    dJointID b = dJointCreatePiston(rig.plain.world, rig.plain.group);
    const dVector3 v = {REAL(0.5), 2, -1, 0};
    test_making<dPistonJoint>("Piston", rig, dJointTypePiston);
    rig.attach(a, b);
    SET("dPistonJointTemplate::setAnchor", read_piston, a, b, a.setAnchor(1, REAL(0.25), 3),
        dJointSetPistonAnchor(b, 1, REAL(0.25), 3));
    SET("dPistonJointTemplate::setAnchor array", read_piston, a, b, a.setAnchor(v),
        dJointSetPistonAnchor(b, v[0], v[1], v[2]));
    SET("dPistonJointTemplate::setAxis", read_piston, a, b, a.setAxis(1, REAL(0.25), 3),
        dJointSetPistonAxis(b, 1, REAL(0.25), 3));
    SET("dPistonJointTemplate::setAxis array", read_piston, a, b, a.setAxis(v),
        dJointSetPistonAxis(b, v[0], v[1], v[2]));
    SET("dPistonJointTemplate::setParam", read_piston, a, b, a.setParam(dParamFMax, REAL(0.125)),
        dJointSetPistonParam(b, dParamFMax, REAL(0.125)));
    judge_get("dPistonJointTemplate::getParam", a.getParam(dParamFMax), dJointGetPistonParam(b, dParamFMax));
    const dJoint& base = a;
    judge_get("dPistonJointTemplate::getParam through dJoint", base.getParam(dParamFMax), REAL(0.125));
    rig.step();
    GET_ARRAY("dPistonJointTemplate::getAnchor", 3, a.getAnchor(out), dJointGetPistonAnchor(b, out));
    GET_ARRAY("dPistonJointTemplate::getAnchor2", 3, a.getAnchor2(out), dJointGetPistonAnchor2(b, out));
    GET_ARRAY("dPistonJointTemplate::getAxis", 3, a.getAxis(out), dJointGetPistonAxis(b, out));
    judge_get("dPistonJointTemplate::getPosition", a.getPosition(), dJointGetPistonPosition(b));
    judge_get("dPistonJointTemplate::getPositionRate", a.getPositionRate(), dJointGetPistonPositionRate(b));
    const dReal* centre = rig.wrapped.second.getPosition();
    a.setAnchor(centre);
    dJointSetPistonAnchor(b, centre[0], centre[1], centre[2]);
    const Numbers before = rig.wrapped.read_bodies();
    a.addForce(7);
    dJointAddPistonForce(b, 7);
    judge_set("dPistonJointTemplate::addForce", before, rig.wrapped.read_bodies(), rig.plain.read_bodies());
}

Numbers read_fixed(dJointID j)
{
    Numbers n = read_joint(j);
    append_params(n, dJointGetFixedParam, j);
    return n;
}

void test_fixed()
{
    Rig rig;
    dFixedJoint a(rig.wrapped.world, rig.wrapped.group.id());
    dJointID b = dJointCreateFixed(rig.plain.world, rig.plain.group);
    test_making<dFixedJoint>("Fixed", rig, dJointTypeFixed);
    rig.attach(a, b);
    a.set();
    dJointSetFixed(b);
    SET("dFixedJointTemplate::setParam", read_fixed, a, b, a.setParam(dParamCFM, REAL(0.125)),
        dJointSetFixedParam(b, dParamCFM, REAL(0.125)));
    judge_get("dFixedJointTemplate::getParam", a.getParam(dParamCFM), dJointGetFixedParam(b, dParamCFM));
    const Numbers before = rig.wrapped.read_bodies();
    rig.step();
    judge_set("dFixedJointTemplate::set", before, rig.wrapped.read_bodies(), rig.plain.read_bodies());
}

Numbers read_amotor(dJointID j)
{
    Numbers n = read_joint(j);
    n.push_back(dJointGetAMotorMode(j));
    n.push_back(dJointGetAMotorNumAxes(j));
    for (int i = 0; i < dJointGetAMotorNumAxes(j); ++i) {
        dVector3 v = {0, 0, 0, 0};
        dJointGetAMotorAxis(j, i, v);
        append(n, v, 3);
        n.push_back(dJointGetAMotorAxisRel(j, i));
        n.push_back(dJointGetAMotorAngle(j, i));
        n.push_back(dJointGetAMotorAngleRate(j, i));
    }
    append_params(n, dJointGetAMotorParam, j);
    return n;
}

void test_amotor()
{
    Rig rig;
    dAMotorJoint a(rig.wrapped.world, rig.wrapped.group.id());
    dJointID b = dJointCreateAMotor(rig.plain.world, rig.plain.group);
    const dVector3 v = {1, 2, 0, 0};
    test_making<dAMotorJoint>("AMotor", rig, dJointTypeAMotor);
    rig.attach(a, b);
    SET("dAMotorJointTemplate::setNumAxes", read_amotor, a, b, a.setNumAxes(2), dJointSetAMotorNumAxes(b, 2));
    judge_get("dAMotorJointTemplate::getNumAxes", a.getNumAxes(), 2);
    SET("dAMotorJointTemplate::setAxis", read_amotor, a, b, a.setAxis(0, 1, 0, 3, 4),
        dJointSetAMotorAxis(b, 0, 1, 0, 3, 4));
    SET("dAMotorJointTemplate::setAxis array", read_amotor, a, b, a.setAxis(1, 2, v),
        dJointSetAMotorAxis(b, 1, 2, 1, 2, 0));
    GET_ARRAY("dAMotorJointTemplate::getAxis", 3, a.getAxis(1, out), dJointGetAMotorAxis(b, 1, out));
    judge_get("dAMotorJointTemplate::getAxisRel", a.getAxisRel(1), 2);
    SET("dAMotorJointTemplate::setAngle", read_amotor, a, b, a.setAngle(1, REAL(0.25)),
        dJointSetAMotorAngle(b, 1, REAL(0.25)));
    judge_get("dAMotorJointTemplate::getAngle", a.getAngle(1), dJointGetAMotorAngle(b, 1));
    SET("dAMotorJointTemplate::setParam", read_amotor, a, b, a.setParam(dParamFMax2, 3),
        dJointSetAMotorParam(b, dParamFMax2, 3));
    judge_get("dAMotorJointTemplate::getParam", a.getParam(dParamFMax2), 3);
    rig.step();
    judge_get("dAMotorJointTemplate::getAngleRate", a.getAngleRate(1), dJointGetAMotorAngleRate(b, 1));
    const Numbers before = rig.wrapped.read_bodies();
    a.addTorques(1, 2, 3);
    dJointAddAMotorTorques(b, 1, 2, 3);
    judge_set("dAMotorJointTemplate::addTorques", before, rig.wrapped.read_bodies(), rig.plain.read_bodies());
    a.setNumAxes(3);
    dJointSetAMotorNumAxes(b, 3);
    a.setAxis(2, 2, 1, 0, 0);
    dJointSetAMotorAxis(b, 2, 2, 1, 0, 0);
    SET("dAMotorJointTemplate::setMode", read_amotor, a, b, a.setMode(dAMotorEuler),
        dJointSetAMotorMode(b, dAMotorEuler));
    judge_get("dAMotorJointTemplate::getMode", a.getMode(), dAMotorEuler);
}

Numbers read_lmotor(dJointID j)
{
    Numbers n = read_joint(j);
    n.push_back(dJointGetLMotorNumAxes(j));
    for (int i = 0; i < dJointGetLMotorNumAxes(j); ++i) {
        dVector3 v = {0, 0, 0, 0};
        dJointGetLMotorAxis(j, i, v);
        append(n, v, 3);
    }
    append_params(n, dJointGetLMotorParam, j);
    return n;
}

void test_lmotor()
{
    Rig rig;
    dLMotorJoint a(rig.wrapped.world, rig.wrapped.group.id());
    dJointID b = dJointCreateLMotor(rig.plain.world, rig.plain.group);
    const dVector3 v = {1, 2, 0, 0};
    test_making<dLMotorJoint>("LMotor", rig, dJointTypeLMotor);
    rig.attach(a, b);
    SET("dLMotorJointTemplate::setNumAxes", read_lmotor, a, b, a.setNumAxes(2), dJointSetLMotorNumAxes(b, 2));
    judge_get("dLMotorJointTemplate::getNumAxes", a.getNumAxes(), 2);
    SET("dLMotorJointTemplate::setAxis", read_lmotor, a, b, a.setAxis(0, 0, 0, 3, 4),
        dJointSetLMotorAxis(b, 0, 0, 0, 3, 4));
    SET("dLMotorJointTemplate::setAxis array", read_lmotor, a, b, a.setAxis(1, 1, v),
        dJointSetLMotorAxis(b, 1, 1, 1, 2, 0));
    GET_ARRAY("dLMotorJointTemplate::getAxis", 3, a.getAxis(1, out), dJointGetLMotorAxis(b, 1, out));
    SET("dLMotorJointTemplate::setParam", read_lmotor, a, b, a.setParam(dParamFMax2, 3),
        dJointSetLMotorParam(b, dParamFMax2, 3));
    judge_get("dLMotorJointTemplate::getParam", a.getParam(dParamFMax2), 3);
}

void test_contact_and_null()
{
    Rig rig;
    dContact contact;
    std::memset(&contact, 0, sizeof contact);
    contact.surface.mode = dContactBounce;
    contact.surface.mu = 1;
    contact.geom.normal[2] = 1;
    contact.geom.depth = REAL(0.125);

    test_making<dNullJoint>("Null", rig, dJointTypeNull);
    dContactJoint empty, by_number(rig.wrapped.world.id(), rig.wrapped.group.id(), &contact);
    dContactJoint by_wrapper(rig.wrapped.world, rig.wrapped.group.id(), &contact),
        alone(rig.wrapped.world, 0, &contact);
    judge_get("dContactJointTemplate::dContactJointTemplate empty", empty.id() == 0, true);
    judge_get("dContactJointTemplate::dContactJointTemplate number", by_number.getType(), dJointTypeContact);
    judge_get("dContactJointTemplate::dContactJointTemplate wrapper", by_wrapper.getType(),
              dJointTypeContact);
    judge_get("dContactJointTemplate::dContactJointTemplate alone", alone.getType(), dJointTypeContact);
    empty.create(rig.wrapped.world, rig.wrapped.group.id(), &contact);
    judge_get("dContactJointTemplate::create wrapper", empty.getType(), dJointTypeContact);
    empty.create(rig.wrapped.world.id(), rig.wrapped.group.id(), &contact);

    dJointID plain = dJointCreateContact(rig.plain.world, rig.plain.group, &contact);
    rig.attach(empty, plain);
    const Numbers before = rig.wrapped.read_bodies();
    rig.step();
    judge_set("dContactJointTemplate::create number", before, rig.wrapped.read_bodies(),
              rig.plain.read_bodies());
}

}  // namespace

void test_joint_types()
{
    test_ball();
    test_hinge();
    test_slider();
    test_universal();
    test_hinge2();
    test_pr();
    test_pu();
    test_piston();
    test_fixed();
    test_amotor();
    test_lmotor();
    test_contact_and_null();
}
