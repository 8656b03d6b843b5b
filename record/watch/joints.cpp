// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// One table line per joint type: which getters it has. The first anchor is that of body 1, the second of body
// 2, as far as ODE has both.
#include "record/watch/joints.h"

#include <cmath>

namespace epode::record {

namespace {

using Getter = void (*)(dJointID, dVector3);

struct Getters {
    dJointType type;
    Getter anchor[2];
    Getter axis[2];
    bool slides;  // along axis 1: anchors part along it by right
};

void motor_axis(dJointID joint, dVector3 axis)
{
    if (dJointGetAMotorNumAxes(joint) > 0) dJointGetAMotorAxis(joint, 0, axis);
}

void linear_motor_axis(dJointID joint, dVector3 axis)
{
    if (dJointGetLMotorNumAxes(joint) > 0) dJointGetLMotorAxis(joint, 0, axis);
}

constexpr Getters kGetters[] = {
    {dJointTypeBall, {dJointGetBallAnchor, dJointGetBallAnchor2}, {}, false},
    {dJointTypeHinge, {dJointGetHingeAnchor, dJointGetHingeAnchor2}, {dJointGetHingeAxis, nullptr}, false},
    {dJointTypeSlider, {}, {dJointGetSliderAxis, nullptr}, true},
    {dJointTypeUniversal,
     {dJointGetUniversalAnchor, dJointGetUniversalAnchor2},
     {dJointGetUniversalAxis1, dJointGetUniversalAxis2},
     false},
    {dJointTypeHinge2,
     {dJointGetHinge2Anchor, dJointGetHinge2Anchor2},
     {dJointGetHinge2Axis1, dJointGetHinge2Axis2},
     true},
    {dJointTypeAMotor, {}, {motor_axis, nullptr}, false},
    {dJointTypeLMotor, {}, {linear_motor_axis, nullptr}, true},
    {dJointTypePR, {dJointGetPRAnchor, nullptr}, {dJointGetPRAxis1, dJointGetPRAxis2}, true},
    {dJointTypePU, {dJointGetPUAnchor, nullptr}, {dJointGetPUAxis1, dJointGetPUAxis2}, true},
    {dJointTypePiston, {dJointGetPistonAnchor, dJointGetPistonAnchor2}, {dJointGetPistonAxis, nullptr}, true},
    // The anchors of the next two are a constant distance apart, not in one place.
    {dJointTypeDBall, {dJointGetDBallAnchor1, dJointGetDBallAnchor2}, {}, false},
    {dJointTypeDHinge,
     {dJointGetDHingeAnchor1, dJointGetDHingeAnchor2},
     {dJointGetDHingeAxis, nullptr},
     false},
    {dJointTypeTransmission,
     {dJointGetTransmissionAnchor1, dJointGetTransmissionAnchor2},
     {dJointGetTransmissionAxis1, dJointGetTransmissionAxis2},
     false},
};

const Getters* getters_of(dJointType type)
{
    for (const Getters& getters : kGetters) {
        if (getters.type == type) return &getters;
    }
    return nullptr;
}

Vec3 vec(const dReal* v) { return {double(v[0]), double(v[1]), double(v[2])}; }

Vec3 point_in(dBodyID body, const dVector3 p)
{
    if (!body) return vec(p);
    dVector3 local = {0, 0, 0, 0};
    dBodyGetPosRelPoint(body, p[0], p[1], p[2], local);
    return vec(local);
}

Vec3 vector_in(dBodyID body, const dVector3 v)
{
    if (!body) return vec(v);
    dVector3 local = {0, 0, 0, 0};
    dBodyVectorFromWorld(body, v[0], v[1], v[2], local);
    return vec(local);
}

}  // namespace

Joint joint_of(dJointID joint)
{
    Joint out;
    out.type = std::uint32_t(dJointGetType(joint));
    const Getters* getters = getters_of(dJointGetType(joint));
    if (!getters) return out;
    for (int i = 0; i < 2; ++i) {
        dBodyID body = dJointGetBody(joint, i);
        dVector3 value = {0, 0, 0, 0};
        if (getters->anchor[i]) {
            getters->anchor[i](joint, value);
            out.has_anchor[size_t(i)] = 1;
            out.anchor[size_t(i)] = point_in(body, value);
        }
        if (getters->axis[i]) {
            getters->axis[i](joint, value);
            out.has_axis[size_t(i)] = 1;
            out.axis[size_t(i)] = vector_in(body, value);
        }
    }
    return out;
}

double joint_gap(dJointID joint)
{
    const dJointType type = dJointGetType(joint);
    const Getters* getters = getters_of(type);
    if (!getters || !getters->anchor[0] || !getters->anchor[1]) return 0;
    if (type == dJointTypeDBall || type == dJointTypeDHinge || type == dJointTypeTransmission) return 0;
    dVector3 a = {0, 0, 0, 0}, b = {0, 0, 0, 0}, axis = {0, 0, 0, 0};
    getters->anchor[0](joint, a);
    getters->anchor[1](joint, b);
    if (getters->slides) getters->axis[0](joint, axis);
    Vec3 gap;
    double along = 0;
    for (size_t i = 0; i < 3; ++i) {
        gap[i] = double(a[i] - b[i]);
        along += gap[i] * double(axis[i]);
    }
    double sum = 0;
    for (size_t i = 0; i < 3; ++i) {
        const double rest = gap[i] - along * double(axis[i]);
        sum += rest * rest;
    }
    return std::sqrt(sum);
}

}  // namespace epode::record
