// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Coordinates of joints and drives on them, for joints of any type.
#include <cstdio>

#include "base/objects/struct_size.h"
#include "dynamics/coupling.h"
#include "dynamics/world.h"
#include "joints/access.h"
#include "joints/drive_rows.h"
#include "joints/limit_motor.h"
#include "joints/registry.h"
#include "ode/ode.h"

namespace epode {

template <>
inline constexpr std::size_t kSmallestSize<dDrive> = offsetof(dDrive, damping);

}  // namespace epode

using namespace epode;

namespace {

bool has_coordinates(const Joint& joint) { return joint.attached() || is_coupling(joint); }

bool has_axis(const Joint& joint, int axis) { return axis >= 0 && axis < axis_count(joint); }

const AxisDrive* axis_drive(const Joint& joint, int axis)
{
    return joint.driven ? &drives_of(joint).axis[axis] : nullptr;
}

AxisDrive* take_axis_drive(Joint& joint, int axis)
{
    JointDrives* drives = take_drives(static_cast<LastingJoint&>(joint));
    return drives ? &drives->axis[axis] : nullptr;
}

// Calls take(field, value, whether it may be so, what it must be) for each number until one returns false. Returns whether none has.
template <typename Take>
bool each_number(const dDrive& drive, Take take)
{
    constexpr const char* kShare = "finite and 0 or more";
    const auto share = [](Real value) { return usable(value) && value >= 0; };
    const Real limit = drive.force_limit;
    return take("stiffness", drive.stiffness, share(drive.stiffness), kShare) &&
           take("damping", drive.damping, share(drive.damping), kShare) &&
           take("armature", drive.armature, share(drive.armature), kShare) &&
           take("friction", drive.friction, share(drive.friction), kShare) &&
           take("target", drive.target, usable(drive.target), "finite") &&
           take("target_velocity", drive.target_velocity, usable(drive.target_velocity), "finite") &&
           take("force", drive.force, usable(drive.force), "finite") &&
           take("force_limit", limit, usable_or_infinite(limit) && limit >= 0, "0 or more, or dInfinity");
}

bool is_good(const dDrive& drive)
{
    return each_number(drive, [](const char*, Real, bool good, const char*) { return good; });
}

// What is wrong with a drive, in words.
struct Fault {
    char text[128];

    explicit Fault(const dDrive& drive)
    {
        each_number(drive, [this](const char* field, Real value, bool good, const char* wanted) {
            if (!good)
                std::snprintf(text, sizeof text, "dDrive::%s is %g, must be %s", field, double(value),
                              wanted);
            return good;
        });
    }
};

constexpr dDrive kNoDrive = {sizeof(dDrive), 0, 0, 0, 0, 0, 0, 0, 0};

bool same(const dDrive& a, const dDrive& b)
{
    return a.stiffness == b.stiffness && a.damping == b.damping && a.armature == b.armature &&
           a.friction == b.friction && a.target == b.target && a.target_velocity == b.target_velocity &&
           a.force == b.force && a.force_limit == b.force_limit;
}

LimitMotor* stops_of(Joint& joint, int axis)
{
    return joint.type->stops ? joint.type->stops(joint, axis) : nullptr;
}

OwnSoftness* own_softness(Joint& joint)
{
    return joint.type->softness ? joint.type->softness(joint) : nullptr;
}

int set_spring(Joint& joint, Spring& spring, Real stiffness, Real damping, const char* caller)
{
    if (!demand(usable(stiffness) && stiffness >= 0 && usable(damping) && damping >= 0, caller)) return 0;
    if (is_busy(joint)) return refuse_for(caller, busy_text(*joint.world)), 0;
    // Steps look for rows in physical units where there are JointDrives.
    if (!take_drives(static_cast<LastingJoint&>(joint))) return refuse_for(caller, kOutOfMemory), 0;
    spring.drive.stiffness = stiffness, spring.drive.damping = damping;
    spring.acts = stiffness > 0 || damping > 0;
    return 1;
}

int get_spring(const Spring& spring, Real* stiffness, Real* damping)
{
    *stiffness = spring.drive.stiffness, *damping = spring.drive.damping;
    return spring.acts;
}

void wake_bodies(Joint& joint)
{
    if (is_coupling(joint))
        for_each_body(coupling_of(joint), [](Body& body) {
            if (body.disabled) wake(body);
        });
    for (const JointNode& node : joint.node)
        if (node.body && node.body->disabled) wake(*node.body);
}

// Programs that control robots come here for each joint before each step.
int put_drive(Joint& joint, int axis, const dDrive& drive, bool driven)
{
    constexpr const char* kCaller = "dJointSetDrive";
    if (!is_good(drive)) return refuse_for(kCaller, Fault(drive).text), 0;
    if (is_busy(joint)) return refuse_for(kCaller, busy_text(*joint.world)), 0;
    AxisDrive* const to = take_axis_drive(joint, axis);
    if (!to) return refuse_for(kCaller, kOutOfMemory), 0;
    if (to->driven != driven || !same(to->drive, drive)) wake_bodies(joint);
    to->driven = driven;
    to->drive = drive;
    if (!driven) to->force = 0;
    return 1;
}

}  // namespace

#define JOINT_OR(...)                           \
    Joint* const joint = from_handle<Joint>(j); \
    EPODE_USER(joint != nullptr __VA_OPT__(, ) __VA_ARGS__)

#define AXIS_OR(...)       \
    JOINT_OR(__VA_ARGS__); \
    EPODE_USER_SAY(has_axis(*joint, axis), "the joint does not have this axis" __VA_OPT__(, ) __VA_ARGS__)

extern "C" {

int dJointGetNumAxes(dJointID j)
{
    JOINT_OR(0);
    return axis_count(*joint);
}

dReal dJointGetAxisPosition(dJointID j, int axis)
{
    AXIS_OR(0);
    return has_coordinates(*joint) ? axis_position(*joint, axis) : 0;
}

dReal dJointGetAxisRate(dJointID j, int axis)
{
    AXIS_OR(0);
    return has_coordinates(*joint) ? axis_rate(*joint, axis) : 0;
}

int dJointSetAxisContinuous(dJointID j, int axis, int mode)
{
    AXIS_OR(0);
    EPODE_USER_SAY(mode == 0 || mode == 1, "the mode must be 0 or 1", 0);
    EPODE_USER_SAY(!is_busy(*joint), busy_text(*joint->world), 0);
    set_continuous(*joint, axis, mode == 1);
    return 1;
}

int dJointGetAxisContinuous(dJointID j, int axis)
{
    AXIS_OR(0);
    return joint->type->continuous(*joint, axis);
}

int dJointSetAxisTurn(dJointID j, int axis, dReal position)
{
    AXIS_OR(0);
    EPODE_USER_SAY(usable(position), "the position must be finite", 0);
    EPODE_USER_SAY(!is_busy(*joint), busy_text(*joint->world), 0);
    const auto read = [&] { return has_coordinates(*joint) ? axis_position(*joint, axis) : 0; };
    change_value(*joint, read, [&] {
        joint->type->count_turns(*joint, axis, joint->type->continuous(*joint, axis), position);
    });
    return 1;
}

int dDriveInit(dDrive* drive, unsigned struct_size)
{
    EPODE_SIZED_AS(drive, struct_size, 0);
    copy_sized(kNoDrive, drive, struct_size);
    return 1;
}

int dJointSetDrive(dJointID j, int axis, const dDrive* drive)
{
    AXIS_OR(0);
    if (!drive) return put_drive(*joint, axis, kNoDrive, false);
    EPODE_SIZED(drive, 0);
    return put_drive(*joint, axis, completed(*drive, kNoDrive), true);
}

int dJointGetDrive(dJointID j, int axis, dDrive* drive)
{
    AXIS_OR(0);
    EPODE_SIZED(drive, 0);
    const AxisDrive* const from = axis_drive(*joint, axis);
    copy_sized(from ? from->drive : kNoDrive, drive, drive->struct_size);
    return from && from->driven;
}

dReal dJointGetDriveForce(dJointID j, int axis)
{
    AXIS_OR(0);
    const AxisDrive* const drive = axis_drive(*joint, axis);
    return drive ? drive->force : 0;
}

int dJointSetStopSpring(dJointID j, int axis, dReal stiffness, dReal damping)
{
    AXIS_OR(0);
    LimitMotor* const stops = stops_of(*joint, axis);
    EPODE_USER_SAY(stops, "the axis has no stops", 0);
    return set_spring(*joint, stops->stop_spring, stiffness, damping, __func__);
}

int dJointGetStopSpring(dJointID j, int axis, dReal* stiffness, dReal* damping)
{
    AXIS_OR(0);
    EPODE_USER(stiffness && damping, 0);
    LimitMotor* const stops = stops_of(*joint, axis);
    EPODE_USER_SAY(stops, "the axis has no stops", 0);
    return get_spring(stops->stop_spring, stiffness, damping);
}

int dJointSetStopRate(dJointID j, int axis, dReal rate)
{
    AXIS_OR(0);
    LimitMotor* const stops = stops_of(*joint, axis);
    EPODE_USER_SAY(stops, "the axis has no stops", 0);
    EPODE_USER_SAY(usable_or_infinite(rate) && rate > 0, "the rate is not above 0", 0);
    EPODE_USER_SAY(!is_busy(*joint), busy_text(*joint->world), 0);
    change_value(
        *joint, [&] { return stops->stop_rate; }, [&] { stops->stop_rate = rate; });
    return 1;
}

dReal dJointGetStopRate(dJointID j, int axis)
{
    AXIS_OR(0);
    LimitMotor* const stops = stops_of(*joint, axis);
    EPODE_USER_SAY(stops, "the axis has no stops", 0);
    return stops->stop_rate;
}

dReal dJointGetStopForce(dJointID j, int axis)
{
    AXIS_OR(0);
    EPODE_USER_SAY(stops_of(*joint, axis), "the axis has no stops", 0);
    return joint->type->stop_force(*joint, axis);
}

int dJointSetSpring(dJointID j, dReal stiffness, dReal damping)
{
    JOINT_OR(0);
    OwnSoftness* const own = own_softness(*joint);
    EPODE_USER_SAY(own, "the joint's type has no ERP and CFM of its own", 0);
    return set_spring(*joint, own->spring, stiffness, damping, __func__);
}

int dJointGetSpring(dJointID j, dReal* stiffness, dReal* damping)
{
    JOINT_OR(0);
    EPODE_USER(stiffness && damping, 0);
    OwnSoftness* const own = own_softness(*joint);
    EPODE_USER_SAY(own, "the joint's type has no ERP and CFM of its own", 0);
    return get_spring(own->spring, stiffness, damping);
}

int dSpringFromFrequency(dReal mass, dReal hertz, dReal damping_ratio, dReal* stiffness, dReal* damping)
{
    const bool good = usable(mass) && usable(hertz) && usable(damping_ratio);
    EPODE_USER(good && mass > 0 && hertz > 0 && damping_ratio >= 0 && stiffness && damping, 0);
    const Real w = 2 * kPi * hertz, k = mass * w * w, d = 2 * damping_ratio * mass * w;
    EPODE_USER_SAY(usable(k) && usable(d), "the spring would be too stiff", 0);
    *stiffness = k, *damping = d;
    return 1;
}

int dJointSetBreakLimits(dJointID j, dReal force, dReal torque)
{
    JOINT_OR(0);
    const auto limit = [](Real x) { return usable_or_infinite(x) && x >= 0; };
    EPODE_USER_SAY(limit(force) && limit(torque), "limits must be 0 or more, or dInfinity", 0);
    EPODE_USER_SAY(!is_contact(*joint), "contact joints do not break", 0);
    EPODE_USER_SAY(!is_busy(*joint), busy_text(*joint->world), 0);
    JointDrives* const drives = take_drives(static_cast<LastingJoint&>(*joint));
    EPODE_USER_SAY(drives, kOutOfMemory, 0);
    drives->limits.force = force > 0 ? force : kInf;
    drives->limits.torque = torque > 0 ? torque : kInf;
    return 1;
}

int dJointGetBreakLimits(dJointID j, dReal* force, dReal* torque)
{
    JOINT_OR(0);
    EPODE_USER(force && torque, 0);
    const BreakLimits limits = joint->driven ? drives_of(*joint).limits : BreakLimits{};
    *force = limits.force, *torque = limits.torque;
    return limits.any();
}

int dJointIsBroken(dJointID j)
{
    JOINT_OR(0);
    return joint->driven && drives_of(*joint).limits.broken;
}

int dWorldGetBrokenJoints(dWorldID w, dJointID* joints, int capacity)
{
    const World* const world = from_handle<World>(w);
    EPODE_USER(world && capacity >= 0 && (joints || capacity == 0), 0);
    int count = 0;
    if (world->driven_joints == 0) return 0;
    for (Joint& joint : world->joints) {
        if (!joint.driven || !drives_of(joint).limits.broken) continue;
        if (drives_of(joint).limits.step != world->step_count) continue;
        if (count < capacity) joints[count] = to_handle(&joint);
        ++count;
    }
    return count;
}

}  // extern "C"
