// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Two equal worlds with two bodies each, for the tests of the joint wrappers: in one world everything is done
// by wrappers, in the other by the C functions.
#ifndef TESTS_CPP_JOINT_RIG_H
#define TESTS_CPP_JOINT_RIG_H

#include <string>

#include "twins.h"

/** What can be read of a joint of any type. */
inline Numbers read_joint(dJointID j)
{
    Numbers n;
    n.push_back(dJointGetType(j));
    n.push_back(dJointGetNumBodies(j));
    n.push_back(dJointIsEnabled(j));
    n.push_back(dJointGetData(j) != 0);
    n.push_back(dJointGetFeedback(j) != 0);
    return n;
}

/** All finite parameters of a joint, by its type's getter. */
inline void append_params(Numbers& to, dReal (*get)(dJointID, int), dJointID j)
{
    for (int group = 0; group < 3 * dParamGroup; group += dParamGroup)
        for (int p = 0; p < dParamsInGroup; ++p) {
            const dReal value = get(j, group + p);
            to.push_back(value > -1e30 && value < 1e30 ? value : 1e30);
        }
}

/** State of a body that a joint can change. */
inline void append_body(Numbers& to, dBodyID b)
{
    append(to, dBodyGetPosition(b), 3);
    append(to, dBodyGetQuaternion(b), 4);
    append(to, dBodyGetLinearVel(b), 3);
    append(to, dBodyGetAngularVel(b), 3);
    append(to, dBodyGetForce(b), 3);
    append(to, dBodyGetTorque(b), 3);
}

/** The two bodies' places and speeds, the same in both worlds. */
template <class Body>
void place(Body first, Body second)
{
    dBodySetPosition(first, -1, 0, 0);
    dBodySetPosition(second, 1, 0, REAL(0.5));
    dBodySetLinearVel(first, 0, REAL(0.25), 0);
    dBodySetAngularVel(second, REAL(0.5), REAL(0.125), -1);
}

struct WrappedSide {
    dWorld world;
    dJointGroup group;
    dBody first, second;
    WrappedSide() : first(world), second(world) { place(first.id(), second.id()); }
    Numbers read_bodies() const
    {
        Numbers n;
        append_body(n, first);
        append_body(n, second);
        return n;
    }
};

struct PlainSide {
    dWorldID world;
    dJointGroupID group;
    dBodyID first, second;
    PlainSide()
        : world(dWorldCreate()),
          group(dJointGroupCreate(0)),
          first(dBodyCreate(world)),
          second(dBodyCreate(world))
    {
        place(first, second);
    }
    ~PlainSide()
    {
        dJointGroupDestroy(group);
        dWorldDestroy(world);
    }
    Numbers read_bodies() const
    {
        Numbers n;
        append_body(n, first);
        append_body(n, second);
        return n;
    }

  private:
    PlainSide(const PlainSide&);
    void operator=(const PlainSide&);
};

struct Rig {
    WrappedSide wrapped;
    PlainSide plain;

    /** Without spin: for joints whose readings the original gets wrong when bodies spin (docs/compat.md). */
    explicit Rig(bool spin = true)
    {
        if (!spin) {
            dBodySetAngularVel(wrapped.second, 0, 0, 0);
            dBodySetAngularVel(plain.second, 0, 0, 0);
        }
    }
    void attach(dJoint& a, dJointID b)
    {
        a.attach(wrapped.first, wrapped.second);
        dJointAttach(b, plain.first, plain.second);
    }
    void step()
    {
        wrapped.world.step(REAL(0.015625));
        dWorldStep(plain.world, REAL(0.015625));
    }
};

/** Every way to make a joint of one type. */
template <class Joint>
void test_making(const char* type, Rig& rig, dJointType number)
{
    const std::string name = std::string("d") + type + "JointTemplate::";
    Joint empty, by_number(rig.wrapped.world.id()), by_wrapper(rig.wrapped.world);
    Joint grouped(rig.wrapped.world.id(), rig.wrapped.group),
        grouped_too(rig.wrapped.world, rig.wrapped.group);
    judge_get((name + "empty").c_str(), empty.id() == 0, true);
    judge_get((name + "by number").c_str(), by_number.getType(), number);
    judge_get((name + "by wrapper").c_str(), by_wrapper.getType(), number);
    judge_get((name + "grouped by number").c_str(), grouped.getType(), number);
    judge_get((name + "grouped by wrapper").c_str(), grouped_too.getType(), number);
    empty.create(rig.wrapped.world);
    judge_get((name + "create by wrapper").c_str(), empty.getType(), number);
    empty.attach(rig.wrapped.first, rig.wrapped.second);
    empty.create(rig.wrapped.world.id());
    judge_get((name + "create by number").c_str(), empty.getNumBodies(), 0);
    judge_get((name + "create destroys").c_str(), dBodyGetNumJoints(rig.wrapped.first), 0);
    Joint in_group, in_group_too;
    in_group.create(rig.wrapped.world.id(), rig.wrapped.group);
    in_group_too.create(rig.wrapped.world, rig.wrapped.group);
    judge_get((name + "create in group").c_str(), in_group.getType(), in_group_too.getType());
}

#endif
