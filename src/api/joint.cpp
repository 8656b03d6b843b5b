// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What can be done with any joint: attach, enable, ask, group, and find by bodies. Functions of one type
// stand in that type's file.
#include <algorithm>

#include "base/objects/pool.h"
#include "base/prefetch.h"
#include "dynamics/coupling.h"
#include "dynamics/joint_drives.h"
#include "dynamics/joint_group.h"
#include "dynamics/world.h"
#include "joints/breaking.h"
#include "ode/ode.h"
#include "state/world_archive.h"

using namespace epode;

namespace {

// As a rule no world is in a step, and the joints, which may be many, need not be looked at.
bool is_busy(const JointGroup& group)
{
    if (!any_world_busy()) return false;
    bool any = false;
    for_each_prefetched<1>(group.joints.span(),
                           [&](std::size_t, const Joint& joint) { any = any || epode::is_busy(joint); });
    return any;
}

// Those that last may be kept by a history.
void destroy_joints(JointGroup& group)
{
    const auto is_kept = [&](Joint* joint) {
        return !is_contact(*joint) && keep_for_history(*joint, to_handle(&group));
    };
    if (any_history()) {
        const auto end = std::remove_if(group.joints.begin(), group.joints.end(), is_kept);
        group.joints.truncate(int(end - group.joints.begin()));
    }
    empty_group(group);
}

// A null or live handle.
bool valid_or_null(dBodyID id) { return !id || from_handle<Body>(id); }

}  // namespace

#define JOINT_OR(...)                           \
    Joint* const joint = from_handle<Joint>(j); \
    EPODE_USER(joint != nullptr __VA_OPT__(, ) __VA_ARGS__)

#define GROUP_OR(...)                                     \
    JointGroup* const group = from_handle<JointGroup>(g); \
    EPODE_USER(group != nullptr __VA_OPT__(, ) __VA_ARGS__)

extern "C" {

void dJointDestroy(dJointID j)
{
    JOINT_OR();
    EPODE_USER_SAY(!is_busy(*joint), busy_text(*joint->world));
    // The group owns it; clients of ODE call this on grouped joints without harm.
    if (!joint->grouped && !keep_for_history(*joint, nullptr)) destroy_joint(*joint);
}

dJointGroupID dJointGroupCreate(int)
{
    const JointGroup* group = Pool<JointGroup>::create();
    EPODE_USER_SAY(group, kOutOfMemory, nullptr);
    return to_handle(group);
}

void dJointGroupDestroy(dJointGroupID g)
{
    GROUP_OR();
    EPODE_USER_SAY(!is_busy(*group), "Invalid operation during a step");
    destroy_joints(*group);
    Pool<JointGroup>::destroy(group);
}

void dJointGroupEmpty(dJointGroupID g)
{
    GROUP_OR();
    EPODE_USER_SAY(!is_busy(*group), "Invalid operation during a step");
    destroy_joints(*group);
}

void dJointAttach(dJointID j, dBodyID b1, dBodyID b2)
{
    JOINT_OR();
    Body* const a = from_handle<Body>(b1);
    Body* const b = from_handle<Body>(b2);
    EPODE_USER((a || !b1) && (b || !b2));
    EPODE_USER_SAY(!is_busy(*joint), busy_text(*joint->world));
    EPODE_USER_SAY(!is_coupling(*joint), "a coupling has no bodies of its own");
    EPODE_USER_SAY(!a || a != b, "can't have body1==body2");
    EPODE_USER_SAY((!a || a->world == joint->world) && (!b || b->world == joint->world),
                   "joint and bodies must be in same world");
    EPODE_USER_SAY(!joint->type->needs_two_bodies || (a == nullptr) == (b == nullptr),
                   "joint can not be attached to just one body");
    attach(*joint, a, b);
}

int dJointGetNumBodies(dJointID j)
{
    JOINT_OR(0);
    return (joint->body1() != nullptr) + (joint->body2() != nullptr);
}

dBodyID dJointGetBody(dJointID j, int index)
{
    JOINT_OR(nullptr);
    if (index < 0 || index > 1) return nullptr;
    const Body* body = joint->user_body(index);
    return body ? to_handle(body) : nullptr;
}

void dJointEnable(dJointID j)
{
    JOINT_OR();
    if (joint->disabled) {
        wake_sleepers(*joint);
        if (joint->type->forget_turns) joint->type->forget_turns(*joint);  // of all that it has missed
    }
    joint->disabled = false;
    if (!joint->driven) return;
    drives_of(*joint).limits.broken = false;
    forget_load(*joint);
}

void dJointDisable(dJointID j)
{
    JOINT_OR();
    if (!joint->disabled) wake_sleepers(*joint);
    joint->disabled = true;
    forget_impulses(*joint);
}

int dJointIsEnabled(dJointID j)
{
    JOINT_OR(0);
    return !joint->disabled;
}

void dJointSetData(dJointID j, void* data)
{
    JOINT_OR();
    joint->data = data;
}

void* dJointGetData(dJointID j)
{
    JOINT_OR(nullptr);
    return joint->data;
}

dJointType dJointGetType(dJointID j)
{
    JOINT_OR(dJointTypeNone);
    return dJointType(joint->type->number);
}

void dJointSetFeedback(dJointID j, dJointFeedback* feedback)
{
    JOINT_OR();
    joint->feedback = feedback;
}

dJointFeedback* dJointGetFeedback(dJointID j)
{
    JOINT_OR(nullptr);
    return joint->feedback;
}

// ---- joints by bodies ----

dJointID dConnectingJoint(dBodyID b1, dBodyID b2)
{
    EPODE_USER((b1 || b2) && valid_or_null(b1) && valid_or_null(b2), nullptr);
    const Body* a = from_handle<Body>(b1 ? b1 : b2);
    const JointNode* n = find_connection(a->joints, from_handle<Body>(b1 ? b2 : nullptr));
    return n ? to_handle(n->joint) : nullptr;
}

int dConnectingJointList(dBodyID b1, dBodyID b2, dJointID* list)
{
    EPODE_USER((b1 || b2) && valid_or_null(b1) && valid_or_null(b2) && list, 0);
    const Body* a = from_handle<Body>(b1 ? b1 : b2);
    const Body* b = from_handle<Body>(b1 ? b2 : nullptr);
    int count = 0;
    for (JointNode* n = find_connection(a->joints, b); n; n = find_connection(n->next, b))
        list[count++] = to_handle(n->joint);
    return count;
}

int dAreConnected(dBodyID b1, dBodyID b2)
{
    Body* const a = from_handle<Body>(b1);
    EPODE_USER(a && valid_or_null(b2), 0);
    return find_connection(a->joints, from_handle<Body>(b2)) != nullptr;
}

int dAreConnectedExcluding(dBodyID b1, dBodyID b2, int joint_type)
{
    Body* const a = from_handle<Body>(b1);
    EPODE_USER(a && valid_or_null(b2), 0);
    const Body* b = from_handle<Body>(b2);
    // Contacts of the last step, by far the most, need not be looked at when they do not count.
    JointNode* const first = joint_type == dJointTypeContact ? a->lasting : a->joints;
    for (JointNode* n = find_connection(first, b); n; n = find_connection(n->next, b))
        if (n->joint->type->number != joint_type) return 1;
    return 0;
}

}  // extern "C"
