// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What all joints have in common: the two bodies, their place in the lists, feedback and last impulses; and
// JointType, the table of functions that makes one type out of a file in joints/. Node 0 holds "body 1" of
// the mathematics and is never empty on an acting joint: attaching (0, B) stores B at node 0 and sets
// `reverse`, as ODE does, so rows are always written from node 0's side.
#pragma once

#include "base/objects/handle.h"
#include "dynamics/body.h"
#include "ode/objects.h"
#include "rows/row.h"

namespace epode {

class DifWriter;
class RowWriter;
class StateStream;
class StructureStream;
struct StepInfo;
struct JointGroup;
struct LimitMotor;
struct OwnSoftness;
struct JointDrives;
struct Joint;

// Membership of a joint in one body's list.
struct JointNode {
    Joint* joint = nullptr;
    Body* body = nullptr;
    JointNode* next = nullptr;
    JointNode* prev = nullptr;  // of the first of a list: anything
};

enum class AxisCarrier : char { kNone, kBody1, kBody2, kBetween };

// One of a joint's axes: J v is the derivative of `value`, both in the sense in which a client reads them.
struct JointAxis {
    Jacobian J;
    Real value = 0;      // m or rad
    bool turns = false;  // an angle that is known up to whole turns, and they are not counted
    // A position along a direction of body 1, J.lin1, from a point of body 2 to one of body 1.
    bool slides = false;
    Vec3 point1{}, point2{};
    // One of several angles: what carries the axis that it turns about, which the J of the others leave out.
    // Without an axis it is J itself that is carried.
    AxisCarrier carrier = AxisCarrier::kNone;
    Vec3 axis{};
};

// A line of a body, in its frame, about which a joint lets it turn.
struct Axle {
    Vec3 direction, point;
    bool shared = false;  // the only one of the joint: the other body has it, too
};

struct JointType {
    int number;        // dJointType
    const char* name;  // as in the C names: "Ball", "Hinge2"
    int max_rows;
    unsigned size;  // of the struct, in bytes
    bool needs_two_bodies;
    // Writes the rows of this step; may note limit states in the joint. Called once a step and, by steppers
    // with inner steps, again at inner poses.
    void (*emit)(Joint&, RowWriter&);
    void (*attached)(Joint&);                          // bodies have changed: recompute relative values
    bool (*set_param)(Joint&, int param, Real value);  // false: unknown here
    bool (*get_param)(const Joint&, int param, Real& value);
    int (*axes)(const Joint&);               // how many it has; null: it has none
    JointAxis (*axis)(const Joint&, int i);  // of an attached joint
    Axle (*axle)(const Joint&, int node);    // of the body there; null: it has none
    LimitMotor* (*stops)(Joint&, int i);     // of an axis; null, or returns null: none
    // Of an axis: whether its turns are counted without stops too; lets it be so, from the position that it has now;
    // and lets the turns of all axes be unknown where they are not.
    bool (*continuous)(const Joint&, int i);
    void (*count_turns)(Joint&, int i, bool continuous, Real position);
    void (*forget_turns)(Joint&);
    OwnSoftness* (*softness)(Joint&);                // ERP and CFM of its own; null: none
    const char* dif_name;                            // in dWorldExportDIF
    void (*describe)(const Joint&, DifWriter& out);  // its fields there
    void (*state)(Joint&, StateStream&);  // in states of the world (dynamics/joint_state.h); null: none
    // All that lies in the world moves by a vector (dWorldShiftOrigin): its points there; null: it has none.
    void (*shift)(Joint&, Vec3 by);
    // What it is made of besides that, in clones and files (base/streams/structure_stream.h): anchors, axes, modes.
    void (*structure)(Joint&, StructureStream&);
    // A new joint, neither linked nor attached, as the stream has it. Null: no memory, or the stream fails.
    Joint* (*make)(World&, StructureStream&);
    void (*destroy)(Joint&);
    Real (*stop_force)(Joint&, int i);  // of an axis, in the sense in which its position is read
};

struct Joint : Tagged {
    Joint(const JointType& t, World& w) : Tagged(Tag::kJoint), type(&t), world(&w)
    {
        node[0].joint = node[1].joint = this;
    }

    // A cache line that every part of a step reads, and one for the lists of the bodies; no more, since
    // contacts come by the ten thousand and are fetched from far away.
    bool reverse : 1 = false;
    bool disabled : 1 = false;
    bool grouped : 1 = false;  // a group destroys it
    bool driven : 1 = false;   // a LastingJoint with JointDrives
    bool coupled : 1 = false;  // has been a member of a coupling (dynamics/coupling.h)
    bool plain : 1 =
        false;  // a contact that is a normal with two tangents or with none (rows/joint_manifold.h)
    bool begun : 1 = false;         // has been in a hybrid step since it was attached or enabled
    std::uint8_t impulse_rows = 0;  // of a LastingJoint
    std::uint16_t mode = 0;         // of a contact's surface
    const JointType* type;
    World* world;  // null once its world is gone and only a group keeps it
    dJointFeedback* feedback = nullptr;
    void* data = nullptr;
    int place = -1;  // in the world's roster
    alignas(kCacheLine) JointNode node[2];

    Body* body1() const { return node[0].body; }
    Body* body2() const { return node[1].body; }
    bool attached() const { return node[0].body != nullptr; }
    // Body as the user numbered them.
    Body* user_body(int i) const { return node[reverse ? 1 - i : i].body; }
};

// What outlives a step: all but contacts, which are found again by the bodies and the place.
struct LastingJoint : Joint {
    using Joint::Joint;
    ~LastingJoint();
    // For warm starting (step/island/problem/joint_memory.h).
    Real impulse[kMaxBlockRows];  // of the last solution: the first `impulse_rows`
    Real impulse_step = 0;        // how long they have acted, s; 0: as long as the coming step
    Real mean[kMaxBlockRows];     // force: the first `mean_rows`
    Real mean_time = 0;           // s that it is the mean of
    std::uint8_t mean_rows = 0;
    JointDrives* drives = nullptr;  // of a joint that is `driven`
    unsigned attachments = 0;       // how often its type has taken anchors from new bodies
};

template <>
struct HandleOf<Joint> {
    using Id = dJointID;
    static constexpr Tag kTag = Tag::kJoint;
};

void detach(Joint& joint);         // leaves both body lists
void wake_sleepers(Joint& joint);  // of its bodies
// The program has turned the body: its joints do not follow their angles across more than a small turn.
void note_turned(Body& body, Quat before);
void attach(Joint& joint, Body* a, Body* b);                          // arguments already checked
[[nodiscard]] bool link_into_world(Joint& joint, JointGroup* group);  // false: no memory, nothing done
void unlink_from_world(Joint& joint);  // `world` becomes null; a group may still keep the joint
void destroy_joint(Joint& joint);

// Acts in the step: not disabled and at least one body that can move.
inline bool acting(const Joint& j)
{
    return !j.disabled && ((j.body1() && !j.body1()->kinematic()) || (j.body2() && !j.body2()->kinematic()));
}

inline bool is_contact(const Joint& joint) { return joint.type->number == dJointTypeContact; }

inline LastingJoint& lasting(Joint& joint) { return static_cast<LastingJoint&>(joint); }
inline const LastingJoint& lasting(const Joint& joint) { return static_cast<const LastingJoint&>(joint); }

// It begins again, as one that has never been in a step.
inline void forget_impulses(Joint& joint) { joint.impulse_rows = 0, joint.begun = false; }

// Of a joint that is no contact.
inline Real* impulses(Joint& joint) { return static_cast<LastingJoint&>(joint).impulse; }
inline const Real* impulses(const Joint& joint) { return static_cast<const LastingJoint&>(joint).impulse; }

// Of the joints of a body, from this one in its list on, the first that leads to `other` (null: the world).
inline JointNode* find_connection(JointNode* n, const Body* other)
{
    while (n && n->joint->node[n == &n->joint->node[0] ? 1 : 0].body != other) n = n->next;
    return n;
}

}  // namespace epode
