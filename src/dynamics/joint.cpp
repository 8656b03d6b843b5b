// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Attaching and detaching: each body keeps a doubly linked list of its joints, the most recent first, so that
// a thousand contacts on one body come and go at constant cost.
#include "dynamics/joint.h"

#include <cmath>

#include "base/objects/structure_edition.h"
#include "dynamics/coupling.h"
#include "dynamics/joint_group.h"
#include "dynamics/world.h"

namespace epode {
namespace {

void enter(JointNode& node, Body* body)
{
    node.body = body;
    if (!body) return;
    node.next = body->joints;
    if (node.next) node.next->prev = &node;
    body->joints = &node;
    if (!is_contact(*node.joint)) body->lasting = &node;
}

JointNode* next_lasting(JointNode* n)
{
    do n = n->next;
    while (n && is_contact(*n->joint));
    return n;
}

// Contacts go the newest first: then nothing is touched but the joint and the first line of the body.
void leave(JointNode& node, bool contact)
{
    Body* const body = node.body;
    if (!body) return;
    if (!contact && body->lasting == &node) body->lasting = next_lasting(&node);
    if (body->joints == &node) {
        body->joints = node.next;
    } else {
        node.prev->next = node.next;
        if (node.next) node.next->prev = node.prev;
    }
    node.body = nullptr;
    node.next = nullptr;
}

void note_tie(Joint& joint)
{
    if (!joint.world || !joint.attached() || is_contact(joint)) return;
    ++joint.world->connections_version;
    note_structure_changed();
}

}  // namespace

void note_turned(Body& body, Quat before)
{
    constexpr Real kCosine = Real(0.99875);  // of half of 0.1 rad
    const Quat now = body.orientation();
    if (std::fabs(before.w * now.w + dot(before.vec(), now.vec())) > kCosine) return;
    for (JointNode* n = body.lasting; n; n = next_lasting(n))
        if (n->joint->type->forget_turns) n->joint->type->forget_turns(*n->joint);
}

void wake_sleepers(Joint& joint)
{
    if (is_coupling(joint)) return for_each_body(coupling_of(joint), wake_sleeper);
    for (const JointNode& node : joint.node)
        if (node.body) wake_sleeper(*node.body);
}

void detach(Joint& joint)
{
    const bool contact = is_contact(joint);
    note_tie(joint);
    if (!contact) wake_sleepers(joint);
    leave(joint.node[0], contact);
    leave(joint.node[1], contact);
    forget_impulses(joint);
}

void attach(Joint& joint, Body* a, Body* b)
{
    if (joint.attached()) detach(joint);
    // A state tells of it, bodies or none.
    if (joint.world && !is_contact(joint) && joint.reverse != (a == nullptr)) note_structure_changed();
    joint.reverse = a == nullptr;
    if (joint.reverse) a = b, b = nullptr;
    enter(joint.node[0], a);
    enter(joint.node[1], b);
    if (joint.world) joint.world->joints.activate(joint);
    note_tie(joint);
    if (!a) return;
    if (!is_contact(joint)) ++static_cast<LastingJoint&>(joint).attachments;
    joint.type->attached(joint);
}

bool link_into_world(Joint& joint, JointGroup* group)
{
    if (group && !group->joints.push(&joint)) return false;
    if (!joint.world->joints.join(joint)) {
        if (group) group->joints.pop();
        return false;
    }
    joint.grouped = group != nullptr;
    if (!is_contact(joint)) note_structure_changed();
    return true;
}

void unlink_from_world(Joint& joint)
{
    if (!joint.world) return;
    if (joint.driven) --joint.world->driven_joints;
    if (!is_contact(joint)) {
        if (joint.coupled || is_coupling(joint)) leave_couplings(joint);
        note_structure_changed();
    }
    joint.world->joints.leave(joint);
    joint.world = nullptr;
}

void destroy_joint(Joint& joint)
{
    detach(joint);
    unlink_from_world(joint);
    joint.type->destroy(joint);
}

}  // namespace epode
