// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See joints.h.
#include "integrations/gazebo/joints.h"

#include <algorithm>

#include "integrations/gazebo/convert.h"
#include "integrations/gazebo/links.h"

namespace epode::gazebo {

namespace {

using robots::turn;

// Of the library: which axis, and whether it counts the other way.
struct Dof {
    dJointID joint = nullptr;
    int axis = 0;
    double sign = 1;
};

bool is_angle(const Joint& joint) { return joint.kind != JointKind::kPrismatic; }

bool are_square(const Joint& joint) { return std::abs(dot(joint.axes[0], joint.axes[1])) < 1e-9; }

// A universal's first axis is part of the library's first body, here the child: the axes change places.
Dof dof_of(const Joint& joint, std::size_t degree)
{
    switch (joint.kind) {
        case JointKind::kUniversal:
        case JointKind::kRevolute2:
            return {joint.joint, 1 - int(degree), 1};
        case JointKind::kScrew:
            return {joint.joint, 1, 1};
        case JointKind::kBall:
            return {joint.helper, int(degree), 1};
        default:
            return {joint.joint, int(degree), 1};
    }
}

void set_parameter(const Joint& joint, std::size_t degree, int parameter, double value)
{
    const Dof dof = dof_of(joint, degree);
    const int number = parameter + dof.axis * dParamGroup;
    switch (dJointGetType(dof.joint)) {
        case dJointTypeHinge:
            return dJointSetHingeParam(dof.joint, number, value);
        case dJointTypeSlider:
            return dJointSetSliderParam(dof.joint, number, value);
        case dJointTypeUniversal:
            return dJointSetUniversalParam(dof.joint, number, value);
        case dJointTypeHinge2:
            return dJointSetHinge2Param(dof.joint, number, value);
        case dJointTypePiston:
            return dJointSetPistonParam(dof.joint, number, value);
        case dJointTypeAMotor:
            return dJointSetAMotorParam(dof.joint, number, value);
        default:
            return;
    }
}

// J(q).
Pose displacement(const Joint& joint, const std::array<double, Joint::kMaxAxes>& q)
{
    const Vec a = joint.axes[0];
    switch (joint.kind) {
        case JointKind::kRevolute:
            return {{}, turn(a, q[0])};
        case JointKind::kPrismatic:
            return {q[0] * a, {}};
        case JointKind::kUniversal:
        case JointKind::kRevolute2:
            return {{}, turn(a, q[0]) * turn(joint.axes[1], q[1])};
        case JointKind::kScrew:
            return {joint.pitch * q[0] * a, turn(a, q[0])};
        case JointKind::kBall: {
            const Vec v{q[0], q[1], q[2]};
            return {{}, turn(v, length(v))};
        }
        case JointKind::kFixed:
            break;
    }
    return {};
}

Pose parent_frame(const Joint& joint)
{
    return joint.parent ? pose_of(*joint.parent) * joint.from_parent : joint.from_parent;
}

std::array<double, Joint::kMaxAxes> positions_of(const Joint& joint)
{
    std::array<double, Joint::kMaxAxes> q{};
    for (std::size_t i = 0; i < degrees_of(joint); ++i) q[i] = position_of(joint, i);
    return q;
}

void move_to(Joint& joint, const std::array<double, Joint::kMaxAxes>& q)
{
    const Pose target = parent_frame(joint) * displacement(joint, q) * joint.to_child;
    move_all(carried_by(joint), target * inverse(pose_of(*joint.child)));
}

dJointID make_plain(Joint& joint, dWorldID world)
{
    switch (joint.kind) {
        case JointKind::kRevolute:
            return dJointCreateHinge(world, nullptr);
        case JointKind::kPrismatic:
            return dJointCreateSlider(world, nullptr);
        case JointKind::kFixed:
            return dJointCreateFixed(world, nullptr);
        case JointKind::kUniversal:
            return dJointCreateUniversal(world, nullptr);
        case JointKind::kRevolute2:
            return are_square(joint) ? dJointCreateUniversal(world, nullptr)
                                     : dJointCreateHinge2(world, nullptr);
        case JointKind::kScrew:
            return dJointCreatePiston(world, nullptr);
        case JointKind::kBall:
            return dJointCreateBall(world, nullptr);
    }
    return nullptr;
}

void set_frame(const Joint& joint, const Pose& frame)
{
    const dJointID id = joint.joint;
    const Vec p = frame.p, a = rotate(frame.q, joint.axes[0]), b = rotate(frame.q, joint.axes[1]);
    const dReal first[3] = {b.x, b.y, b.z}, second[3] = {a.x, a.y, a.z};
    switch (dJointGetType(id)) {
        case dJointTypeHinge:
            dJointSetHingeAnchor(id, p.x, p.y, p.z), dJointSetHingeAxis(id, a.x, a.y, a.z);
            break;
        case dJointTypeSlider:
            dJointSetSliderAxis(id, a.x, a.y, a.z);
            break;
        case dJointTypeFixed:
            dJointSetFixed(id);
            break;
        case dJointTypeUniversal:
            dJointSetUniversalAnchor(id, p.x, p.y, p.z);
            dJointSetUniversalAxis1(id, b.x, b.y, b.z), dJointSetUniversalAxis2(id, a.x, a.y, a.z);
            break;
        case dJointTypeHinge2:
            dJointSetHinge2Anchor(id, p.x, p.y, p.z);
            dJointSetHinge2Axes(id, first, second);
            break;
        case dJointTypePiston:
            dJointSetPistonAnchor(id, p.x, p.y, p.z), dJointSetPistonAxis(id, a.x, a.y, a.z);
            break;
        case dJointTypeBall:
            dJointSetBallAnchor(id, p.x, p.y, p.z);
            break;
        default:
            break;
    }
}

bool make_helper(Joint& joint, dWorldID world)
{
    if (joint.kind == JointKind::kScrew) {
        joint.helper = dJointCreateCoupling(world, nullptr);
        return joint.helper && dJointSetCouplingAxis(joint.helper, 0, joint.joint, 0, 1) &&
               (joint.pitch == 0 || dJointSetCouplingAxis(joint.helper, 1, joint.joint, 1, -joint.pitch));
    }
    if (joint.kind != JointKind::kBall) return true;
    joint.helper = dJointCreateAMotor(world, nullptr);
    if (!joint.helper) return false;
    dJointAttach(joint.helper, joint.child->body, joint.parent ? joint.parent->body : nullptr);
    dJointSetAMotorMode(joint.helper, dAMotorTurn);
    return true;
}

void wake_ends(const Joint& joint)
{
    wake(*joint.child);
    if (joint.parent) wake(*joint.parent);
}

}  // namespace

std::size_t degrees_of(const Joint& joint)
{
    switch (joint.kind) {
        case JointKind::kFixed:
            return 0;
        case JointKind::kUniversal:
        case JointKind::kRevolute2:
            return 2;
        case JointKind::kBall:
            return 3;
        default:
            return 1;
    }
}

bool make_joint(Joint& joint)
{
    const dWorldID world = joint.model->world->world;
    joint.joint = make_plain(joint, world);
    if (!joint.joint) return false;
    dJointAttach(joint.joint, joint.child->body, joint.parent ? joint.parent->body : nullptr);
    set_frame(joint, frame_of(joint));
    if (!make_helper(joint, world)) return false;
    dJointSetFeedback(joint.joint, &joint.feedback);
    for (std::size_t i = 0; i < degrees_of(joint); ++i) {
        const Dof dof = dof_of(joint, i);
        if (is_angle(joint)) dJointSetAxisContinuous(dof.joint, dof.axis, 1);
        put_limits(joint, i), put_drive(joint, i);
    }
    wake_ends(joint);
    return true;
}

bool make_again(Joint& joint)
{
    const auto q = positions_of(joint);
    for (dJointID mimic : joint.mimics) dJointDestroy(mimic);
    joint.mimics.clear();
    destroy_joint(joint);
    move_to(joint, {});
    if (!make_joint(joint)) return false;
    move_to(joint, q);
    return true;
}

void destroy_joint(Joint& joint)
{
    if (joint.helper) dJointDestroy(joint.helper);
    if (joint.joint) dJointDestroy(joint.joint);
    joint.helper = joint.joint = nullptr;
}

double position_of(const Joint& joint, std::size_t degree)
{
    const Dof dof = dof_of(joint, degree);
    return dof.sign * dJointGetAxisPosition(dof.joint, dof.axis);
}

double velocity_of(const Joint& joint, std::size_t degree)
{
    const Dof dof = dof_of(joint, degree);
    return dof.sign * dJointGetAxisRate(dof.joint, dof.axis);
}

double exerted_force(const Joint& joint, std::size_t degree)
{
    const Dof dof = dof_of(joint, degree);
    return dof.sign * dJointGetDriveForce(dof.joint, dof.axis);
}

void set_position(Joint& joint, std::size_t degree, double value)
{
    auto q = positions_of(joint);
    q[degree] = value;
    move_to(joint, q);
    const Dof dof = dof_of(joint, degree);
    if (is_angle(joint) && joint.kind != JointKind::kBall)
        dJointSetAxisTurn(dof.joint, dof.axis, dof.sign * value);
}

void set_velocity(Joint& joint, std::size_t degree, double value)
{
    const double more = value - velocity_of(joint, degree);
    const Pose outer = parent_frame(joint), inner = frame_of(joint);
    Vec axis = rotate(outer.q, joint.axes[0]);
    if (joint.kind == JointKind::kBall)
        axis = rotate(inner.q, {double(degree == 0), double(degree == 1), double(degree == 2)});
    else if (degree == 1)
        axis = rotate(inner.q, joint.axes[1]);
    const double along = joint.kind == JointKind::kPrismatic ? 1
                         : joint.kind == JointKind::kScrew   ? joint.pitch
                                                             : 0;
    add_velocity(carried_by(joint), inner.p, along * more * axis, is_angle(joint) ? more * axis : Vec{});
}

void set_force(Joint& joint, std::size_t degree, double value)
{
    Joint::Axis& its = joint.axis[degree];
    its.force = std::clamp(value, its.min_effort, its.max_effort);
    if (its.is_velocity_commanded) set_parameter(joint, degree, dParamFMax, 0);
    its.is_velocity_commanded = false;
    put_drive(joint, degree);
}

void set_velocity_command(Joint& joint, std::size_t degree, double value)
{
    Joint::Axis& its = joint.axis[degree];
    its.is_velocity_commanded = true;
    set_parameter(joint, degree, dParamVel,
                  dof_of(joint, degree).sign * std::clamp(value, its.min_velocity, its.max_velocity));
    set_parameter(joint, degree, dParamFMax, std::min(its.max_effort, double(dInfinity)));
    wake_ends(joint);
}

void put_limits(Joint& joint, std::size_t degree)
{
    const Joint::Axis& its = joint.axis[degree];
    if (joint.kind == JointKind::kBall) return;
    // The lower stop first loses its bound: a lower one above the upper is no stop for the library.
    set_parameter(joint, degree, dParamLoStop, -dInfinity);
    set_parameter(joint, degree, dParamHiStop, std::min(its.high, double(dInfinity)));
    set_parameter(joint, degree, dParamLoStop, std::max(its.low, -double(dInfinity)));
    wake_ends(joint);
}

void put_drive(Joint& joint, std::size_t degree)
{
    const Joint::Axis& its = joint.axis[degree];
    const Dof dof = dof_of(joint, degree);
    dDrive drive;
    dDriveInit(&drive, sizeof drive);
    drive.stiffness = its.stiffness, drive.target = dof.sign * its.spring_reference;
    drive.damping = its.damping, drive.friction = its.friction;
    drive.force = dof.sign * its.force;
    const bool acts = its.stiffness != 0 || its.damping != 0 || its.friction != 0 || its.force != 0;
    dJointSetDrive(dof.joint, dof.axis, acts ? &drive : nullptr);
}

bool couple(Joint& follower, const Joint& leader, const Mimic& mimic)
{
    const Dof one = dof_of(follower, mimic.follower_axis), two = dof_of(leader, mimic.leader_axis);
    const dJointID coupling = dJointCreateCoupling(follower.model->world->world, nullptr);
    if (!coupling) return false;
    const bool is_made = dJointSetCouplingAxis(coupling, 0, one.joint, one.axis, one.sign) &&
                         (mimic.multiplier == 0 || dJointSetCouplingAxis(coupling, 1, two.joint, two.axis,
                                                                         -mimic.multiplier * two.sign));
    const double at = mimic.offset - mimic.multiplier * mimic.reference;
    dJointSetCouplingParam(coupling, dParamLoStop, at);
    dJointSetCouplingParam(coupling, dParamHiStop, at);
    if (!is_made) return dJointDestroy(coupling), false;
    follower.mimics.push_back(coupling);
    return true;
}

Pose frame_of(const Joint& joint) { return pose_of(*joint.child) * inverse(joint.to_child); }

JointWrench transmitted_wrench(const Joint& joint)
{
    const Pose frame = frame_of(joint);
    const bool is_child = joint.child->body != nullptr;
    const dBodyID body = is_child ? joint.child->body : joint.parent->body;
    const double sign = is_child ? 1 : -1;
    const Vec force = sign * vec_of(joint.feedback.f1), torque = sign * vec_of(joint.feedback.t1);
    const Vec arm = vec_of(dBodyGetPosition(body)) - frame.p;
    const Quat in = conjugate(frame.q);
    return {rotate(in, force), rotate(in, torque + cross(arm, force))};
}

}  // namespace epode::gazebo
