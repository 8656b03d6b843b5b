// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A table from kinds to functions that set a joint's geometry and say which groups of parameters it has.
// Numbers are drawn in any case; only the calls depend on `joint` being there.
#include "joints.h"

#include <cmath>
#include <cstdio>

namespace epode::mechanisms {
namespace {

using parity::Random;
using parity::Vec3;
using SetParam = void (*)(dJointID, int, dReal);

struct Draft {
    Random& random;
    dJointID joint;  // null: only draw
    Vec3 anchor;
    std::string& text;

    void set(SetParam call, int parameter, double value)
    {
        if (joint) call(joint, parameter, dReal(value));
    }
    void say(const char* what, double value)
    {
        char word[48];
        std::snprintf(word, sizeof word, " %s=%.3g", what, value);
        text += word;
    }
    void draw(SetParam call, int group, int parameter, const char* what, double value)
    {
        set(call, group + parameter, value);
        say(what, value);
    }
};

Vec3 cross(const Vec3& a, const Vec3& b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

Vec3 perpendicular(Random& random, const Vec3& n)
{
    for (;;) {
        const Vec3 c = cross(n, random.direction());
        const double length = std::sqrt(c.x * c.x + c.y * c.y + c.z * c.z);
        if (length > 0.1) return {c.x / length, c.y / length, c.z / length};
    }
}

void draw_motor(Draft& d, SetParam call, int group)
{
    if (d.random.unit() < 0.5) return;
    d.draw(call, group, dParamVel, "vel", d.random.range(-5, 5));
    d.draw(call, group, dParamFMax, "fmax", log_uniform(d.random, 1e-3, 1e4));
    if (d.random.unit() < 0.3) d.draw(call, group, dParamCFM, "cfm", log_uniform(d.random, 1e-10, 1e-3));
    if (d.random.unit() < 0.3) d.draw(call, group, dParamFudgeFactor, "fudge", d.random.unit());
}

void draw_stops(Draft& d, SetParam call, int group)
{
    if (d.random.unit() < 0.5) return;
    const bool locked = d.random.unit() < 0.2;
    const double low = locked ? 0 : d.random.range(-0.5, 0);
    const double high = locked ? 0 : d.random.range(0, 0.5);
    d.draw(call, group, dParamLoStop, "lo", low);
    d.draw(call, group, dParamHiStop, "hi", high);
    if (d.random.unit() < 0.4) d.draw(call, group, dParamBounce, "bounce", d.random.unit());
    if (d.random.unit() < 0.4) d.draw(call, group, dParamStopERP, "stop_erp", d.random.range(0, 0.8));
    if (d.random.unit() < 0.4)
        d.draw(call, group, dParamStopCFM, "stop_cfm", log_uniform(d.random, 1e-10, 1e-3));
}

void draw_softness(Draft& d, SetParam call)
{
    if (d.random.unit() < 0.7) return;
    d.draw(call, 0, dParamERP, "erp", d.random.range(0, 0.8));
    d.draw(call, 0, dParamCFM, "cfm", log_uniform(d.random, 1e-10, 1e-3));
}

void ball(Draft& d)
{
    if (d.joint) dJointSetBallAnchor(d.joint, dReal(d.anchor.x), dReal(d.anchor.y), dReal(d.anchor.z));
    draw_softness(d, dJointSetBallParam);
}

void hinge(Draft& d)
{
    const Vec3 n = d.random.direction();
    if (d.joint) {
        dJointSetHingeAnchor(d.joint, dReal(d.anchor.x), dReal(d.anchor.y), dReal(d.anchor.z));
        dJointSetHingeAxis(d.joint, dReal(n.x), dReal(n.y), dReal(n.z));
    }
    draw_stops(d, dJointSetHingeParam, 0);
    draw_motor(d, dJointSetHingeParam, 0);
}

void slider(Draft& d)
{
    const Vec3 n = d.random.direction();
    if (d.joint) dJointSetSliderAxis(d.joint, dReal(n.x), dReal(n.y), dReal(n.z));
    draw_stops(d, dJointSetSliderParam, 0);
    draw_motor(d, dJointSetSliderParam, 0);
}

void universal(Draft& d)
{
    const Vec3 n = d.random.direction(), m = perpendicular(d.random, n);
    if (d.joint) {
        dJointSetUniversalAnchor(d.joint, dReal(d.anchor.x), dReal(d.anchor.y), dReal(d.anchor.z));
        dJointSetUniversalAxis1(d.joint, dReal(n.x), dReal(n.y), dReal(n.z));
        dJointSetUniversalAxis2(d.joint, dReal(m.x), dReal(m.y), dReal(m.z));
    }
    for (int group : {0, 0x100}) {
        draw_stops(d, dJointSetUniversalParam, group);
        draw_motor(d, dJointSetUniversalParam, group);
    }
}

void hinge2(Draft& d)
{
    const Vec3 n = d.random.direction(), m = perpendicular(d.random, n);
    if (d.joint) {
        const dVector3 axis1 = {dReal(n.x), dReal(n.y), dReal(n.z), 0};
        const dVector3 axis2 = {dReal(m.x), dReal(m.y), dReal(m.z), 0};
        dJointSetHinge2Anchor(d.joint, dReal(d.anchor.x), dReal(d.anchor.y), dReal(d.anchor.z));
        dJointSetHinge2Axes(d.joint, axis1, axis2);
    }
    draw_stops(d, dJointSetHinge2Param, 0);
    draw_motor(d, dJointSetHinge2Param, 0);
    draw_motor(d, dJointSetHinge2Param, 0x100);
    if (d.random.unit() < 0.5) return;
    d.draw(dJointSetHinge2Param, 0, dParamSuspensionERP, "s_erp", d.random.range(0, 0.8));
    d.draw(dJointSetHinge2Param, 0, dParamSuspensionCFM, "s_cfm", log_uniform(d.random, 1e-10, 1e-2));
}

void fixed(Draft& d)
{
    if (d.joint) dJointSetFixed(d.joint);
    draw_softness(d, dJointSetFixedParam);
}

void user_motor(Draft& d)
{
    const int axes = 1 + d.random.below(3);
    if (d.joint) dJointSetAMotorNumAxes(d.joint, axes);
    for (int i = 0; i < axes; ++i) {
        const Vec3 n = d.random.direction();
        const int relative = d.random.below(2);
        if (d.joint) dJointSetAMotorAxis(d.joint, i, relative, dReal(n.x), dReal(n.y), dReal(n.z));
        draw_stops(d, dJointSetAMotorParam, 0x100 * i);
        draw_motor(d, dJointSetAMotorParam, 0x100 * i);
    }
}

void euler_motor(Draft& d)
{
    const Vec3 n = d.random.direction(), m = perpendicular(d.random, n);
    if (d.joint) {
        dJointSetAMotorMode(d.joint, dAMotorEuler);
        dJointSetAMotorAxis(d.joint, 0, 1, dReal(n.x), dReal(n.y), dReal(n.z));
        dJointSetAMotorAxis(d.joint, 2, 2, dReal(m.x), dReal(m.y), dReal(m.z));
    }
    for (int i = 0; i < 3; ++i) {
        draw_stops(d, dJointSetAMotorParam, 0x100 * i);
        draw_motor(d, dJointSetAMotorParam, 0x100 * i);
    }
}

void linear_motor(Draft& d)
{
    const int axes = 1 + d.random.below(3);
    if (d.joint) dJointSetLMotorNumAxes(d.joint, axes);
    for (int i = 0; i < axes; ++i) {
        const Vec3 n = d.random.direction();
        const int relative = d.random.below(2);
        if (d.joint) dJointSetLMotorAxis(d.joint, i, relative, dReal(n.x), dReal(n.y), dReal(n.z));
        draw_motor(d, dJointSetLMotorParam, 0x100 * i);
    }
}

void plane2d(Draft& d)
{
    const auto motor = [&](void (*call)(dJointID, int, dReal)) { draw_motor(d, call, 0); };
    motor(dJointSetPlane2DXParam);
    motor(dJointSetPlane2DYParam);
    motor(dJointSetPlane2DAngleParam);
}

void pr(Draft& d)
{
    const Vec3 n = d.random.direction(), m = perpendicular(d.random, n);
    if (d.joint) {
        dJointSetPRAnchor(d.joint, dReal(d.anchor.x), dReal(d.anchor.y), dReal(d.anchor.z));
        dJointSetPRAxis1(d.joint, dReal(n.x), dReal(n.y), dReal(n.z));
        dJointSetPRAxis2(d.joint, dReal(m.x), dReal(m.y), dReal(m.z));
    }
    for (int group : {0, 0x100}) {
        draw_stops(d, dJointSetPRParam, group);
        draw_motor(d, dJointSetPRParam, group);
    }
}

void pu(Draft& d)
{
    const Vec3 n = d.random.direction(), m = perpendicular(d.random, n), along = d.random.direction();
    if (d.joint) {
        dJointSetPUAnchor(d.joint, dReal(d.anchor.x), dReal(d.anchor.y), dReal(d.anchor.z));
        dJointSetPUAxis1(d.joint, dReal(n.x), dReal(n.y), dReal(n.z));
        dJointSetPUAxis2(d.joint, dReal(m.x), dReal(m.y), dReal(m.z));
        dJointSetPUAxisP(d.joint, dReal(along.x), dReal(along.y), dReal(along.z));
    }
    for (int group : {0, 0x100, 0x200}) {
        draw_stops(d, dJointSetPUParam, group);
        draw_motor(d, dJointSetPUParam, group);
    }
}

void piston(Draft& d)
{
    const Vec3 n = d.random.direction();
    if (d.joint) {
        dJointSetPistonAnchor(d.joint, dReal(d.anchor.x), dReal(d.anchor.y), dReal(d.anchor.z));
        dJointSetPistonAxis(d.joint, dReal(n.x), dReal(n.y), dReal(n.z));
    }
    for (int group : {0, 0x100}) {
        draw_stops(d, dJointSetPistonParam, group);
        draw_motor(d, dJointSetPistonParam, group);
    }
}

// The second anchor half a metre away.
void dball(Draft& d)
{
    const Vec3 n = d.random.direction();
    if (d.joint) {
        dJointSetDBallAnchor1(d.joint, dReal(d.anchor.x), dReal(d.anchor.y), dReal(d.anchor.z));
        dJointSetDBallAnchor2(d.joint, dReal(d.anchor.x + 0.5 * n.x), dReal(d.anchor.y + 0.5 * n.y),
                              dReal(d.anchor.z + 0.5 * n.z));
    }
    draw_softness(d, dJointSetDBallParam);
}

void dhinge(Draft& d)
{
    const Vec3 n = d.random.direction(), m = perpendicular(d.random, n);
    if (d.joint) {
        dJointSetDHingeAxis(d.joint, dReal(n.x), dReal(n.y), dReal(n.z));
        dJointSetDHingeAnchor1(d.joint, dReal(d.anchor.x), dReal(d.anchor.y), dReal(d.anchor.z));
        dJointSetDHingeAnchor2(d.joint, dReal(d.anchor.x + 0.5 * m.x), dReal(d.anchor.y + 0.5 * m.y),
                               dReal(d.anchor.z + 0.5 * m.z));
    }
    draw_softness(d, dJointSetDHingeParam);
}

struct Type {
    const char* name;
    dJointID (*create)(dWorldID, dJointGroupID);
    void (*furnish)(Draft&);
    bool to_world;
};

const Type kTypes[kKinds] = {
    {"ball", dJointCreateBall, ball, false},
    {"hinge", dJointCreateHinge, hinge, false},
    {"slider", dJointCreateSlider, slider, false},
    {"universal", dJointCreateUniversal, universal, false},
    {"hinge2", dJointCreateHinge2, hinge2, false},
    {"fixed", dJointCreateFixed, fixed, false},
    {"user_motor", dJointCreateAMotor, user_motor, false},
    {"euler_motor", dJointCreateAMotor, euler_motor, false},
    {"linear_motor", dJointCreateLMotor, linear_motor, false},
    {"plane2d", dJointCreatePlane2D, plane2d, true},
    {"pr", dJointCreatePR, pr, false},
    {"pu", dJointCreatePU, pu, false},
    {"piston", dJointCreatePiston, piston, false},
    {"dball", dJointCreateDBall, dball, false},
    {"dhinge", dJointCreateDHinge, dhinge, false},
};

}  // namespace

const char* name_of(int kind) { return kTypes[kind].name; }

double log_uniform(Random& random, double low, double high)
{
    return std::exp(random.range(std::log(low), std::log(high)));
}

void make_joint(int kind, dWorldID world, Random& random, dBodyID a, dBodyID b, bool make, std::string& text)
{
    const Type& type = kTypes[kind];
    const dJointID joint = make ? type.create(world, nullptr) : nullptr;
    if (joint) dJointAttach(joint, a, type.to_world ? nullptr : b);
    // Somewhere about the middle of the two.
    const dReal* pa = dBodyGetPosition(a);
    const dReal* pb = b ? dBodyGetPosition(b) : pa;
    const Vec3 off = random.in_cube(0.3);
    const Vec3 anchor{0.5 * double(pa[0] + pb[0]) + off.x, 0.5 * double(pa[1] + pb[1]) + off.y,
                      0.5 * double(pa[2] + pb[2]) + off.z};
    Draft draft{random, joint, anchor, text};
    type.furnish(draft);
}

}  // namespace epode::mechanisms
