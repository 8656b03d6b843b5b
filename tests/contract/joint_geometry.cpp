// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "joint_geometry.h"

namespace epode::test {
namespace {

// A joint is made by dJointCreate and its name; a contact wants to know where.
template <auto create>
dJointID make(dWorldID world, const JointGeometry& g, bool swapped)
{
    if constexpr (std::is_invocable_v<decltype(create), dWorldID, dJointGroupID>) {
        return create(world, nullptr);
    } else {
        dContact c{};
        c.surface.mode = dContactRolling | dContactApprox1;
        c.surface.mu = 1;
        c.surface.rho = Real(0.1);
        store(c.geom.pos, g.anchor);
        store(c.geom.normal, swapped ? -g.axis1 : g.axis1);
        return create(world, nullptr, &c);
    }
}

// The geometry as the functions of the interface want it. `a` and `b` are the axes of the bodies that the
// joint has first and second; `p1` and `p2` the ends of a rod, level with p about axis 1.
struct Placing {
    dJointID j;
    Vec3 p, axis1, axis2, a, b, p1, p2;
    bool swapped;

    Placing(dJointID joint, const JointGeometry& g, bool exchanged)
        : j(joint),
          p(g.anchor),
          axis1(g.axis1),
          axis2(g.axis2),
          a(exchanged ? axis2 : axis1),
          b(exchanged ? axis1 : axis2),
          swapped(exchanged)
    {
        const Vec3 end = p + Real(1.5) * axis2;
        p1 = swapped ? end : p, p2 = swapped ? p : end;
    }
    Vec3 oblique() const { return axis1 + Real(0.5) * axis2 + Real(0.7) * cross(axis1, axis2); }
};

using Setter = void(dJointID, dReal, dReal, dReal);
void set(Setter* setter, const Placing& g, Vec3 v) { setter(g.j, v.x, v.y, v.z); }

void set_hinge2_axes(const Placing& g)
{
    const dReal a[4] = {g.a.x, g.a.y, g.a.z, 0}, b[4] = {g.b.x, g.b.y, g.b.z, 0};
    dJointSetHinge2Axes(g.j, a, b);
}

// Both motors: axis 0 of body 1, axis 1 of body 2, axis 2 of the world, all of them driven.
template <auto set_count, auto set_axis, auto set_param>
void set_motor(const Placing& g)
{
    set_count(g.j, 3);
    set_axis(g.j, 0, 1, g.a.x, g.a.y, g.a.z);
    set_axis(g.j, 1, 2, g.b.x, g.b.y, g.b.z);
    set_axis(g.j, 2, 0, g.p.x, g.p.y, g.p.z);
    for (int i = 0; i < 3; ++i) set_param(g.j, dParamFMax + i * dParamGroup, 1);
}

struct Placement {
    int number;
    void (*place)(const Placing&);
};

constexpr Placement kPlacements[] = {
    {dJointTypeBall, [](const Placing& g) { set(dJointSetBallAnchor, g, g.p); }},
    {dJointTypeHinge,
     [](const Placing& g) {
         set(dJointSetHingeAnchor, g, g.p);
         set(dJointSetHingeAxis, g, g.axis1);
     }},
    {dJointTypeSlider, [](const Placing& g) { set(dJointSetSliderAxis, g, g.axis1); }},
    {dJointTypeContact, [](const Placing&) {}},
    {dJointTypeUniversal,
     [](const Placing& g) {
         set(dJointSetUniversalAnchor, g, g.p);
         set(dJointSetUniversalAxis1, g, g.a);
         set(dJointSetUniversalAxis2, g, g.b);
     }},
    {dJointTypeHinge2,
     [](const Placing& g) {
         set(dJointSetHinge2Anchor, g, g.p);
         set_hinge2_axes(g);
     }},
    {dJointTypeFixed, [](const Placing& g) { dJointSetFixed(g.j); }},
    {dJointTypeNull, [](const Placing&) {}},
    {dJointTypeAMotor, set_motor<dJointSetAMotorNumAxes, dJointSetAMotorAxis, dJointSetAMotorParam>},
    {dJointTypeLMotor, set_motor<dJointSetLMotorNumAxes, dJointSetLMotorAxis, dJointSetLMotorParam>},
    {dJointTypePR,
     [](const Placing& g) {
         set(dJointSetPRAnchor, g, g.p);
         set(dJointSetPRAxis1, g, g.axis1);
         set(dJointSetPRAxis2, g, g.axis2);
     }},
    {dJointTypePU,
     [](const Placing& g) {
         set(dJointSetPUAnchor, g, g.p);
         set(dJointSetPUAxis1, g, g.a);
         set(dJointSetPUAxis2, g, g.b);
         set(dJointSetPUAxis3, g, g.oblique());
     }},
    {dJointTypePiston,
     [](const Placing& g) {
         set(dJointSetPistonAnchor, g, g.p);
         set(dJointSetPistonAxis, g, g.axis1);
     }},
    {dJointTypeDBall,
     [](const Placing& g) {
         set(dJointSetDBallAnchor1, g, g.p1);
         set(dJointSetDBallAnchor2, g, g.p2);
     }},
    {dJointTypeDHinge,
     [](const Placing& g) {
         set(dJointSetDHingeAxis, g, g.axis1);
         set(dJointSetDHingeAnchor1, g, g.p1);
         set(dJointSetDHingeAnchor2, g, g.p2);
     }},
    {dJointTypeTransmission,
     [](const Placing& g) {
         set(dJointSetTransmissionAxis, g, g.axis1);
         set(dJointSetTransmissionAnchor1, g, g.p1);
         set(dJointSetTransmissionAnchor2, g, g.p2);
         dJointSetTransmissionRatio(g.j, g.swapped ? Real(0.5) : 2);
     }},
};

const Placement* placement_of(dJointID joint)
{
    for (const Placement& placement : kPlacements)
        if (placement.number == dJointGetType(joint)) return &placement;
    return nullptr;
}

}  // namespace

JointGeometry::JointGeometry(Dice& dice)
{
    anchor = dice.vector();
    axis1 = dice.unit();
    axis2 = normalized_or(cross(axis1, dice.unit()), {0, 1, 0});
}

std::vector<JointCase> joint_cases()
{
    return {
#define JOINT_TYPE(Name, Number) {Number, #Name, &make<&dJointCreate##Name>},
#include "joints/joint_types.inc"
#undef JOINT_TYPE
    };
}

bool has_geometry(dJointID joint) { return placement_of(joint) != nullptr; }

void set_geometry(dJointID joint, const JointGeometry& g, bool swapped)
{
    if (const Placement* placement = placement_of(joint)) placement->place(Placing(joint, g, swapped));
}

}  // namespace epode::test
