// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What joints of all types share, and joint groups.
#include "joint_rig.h"

namespace {

void test_base()
{
    Rig rig;
    dBallJoint made(rig.wrapped.world);
    dJoint& a = made;
    dJointID b = dJointCreateBall(rig.plain.world, 0);
    dJointFeedback feedback;
    int something = 0;
    judge_get("dJointTemplate::id", a.id() != 0 && dJointID(a) == a.id(), true);
    judge_get("dJointTemplate::getType", a.getType(), dJointTypeBall);
    SET("dJointTemplate::attach", read_joint, a, b, a.attach(rig.wrapped.first, rig.wrapped.second),
        dJointAttach(b, rig.plain.first, rig.plain.second));
    judge_get("dJointTemplate::getBody", a.getBody(1) == rig.wrapped.second.id(), true);
    SET("dJointTemplate::attach numbers", read_joint, a, b, a.attach(rig.wrapped.first.id(), 0),
        dJointAttach(b, rig.plain.first, 0));
    judge_get("dJointTemplate::getNumBodies", a.getNumBodies(), 1);
    judge_get("dJointTemplate::getBody none", a.getBody(1) == 0, true);
    SET("dJointTemplate::disable", read_joint, a, b, a.disable(), dJointDisable(b));
    judge_get("dJointTemplate::isEnabled", a.isEnabled(), false);
    SET("dJointTemplate::enable", read_joint, a, b, a.enable(), dJointEnable(b));
    judge_get("dJointTemplate::isEnabled yes", a.isEnabled(), true);
    SET("dJointTemplate::setData", read_joint, a, b, a.setData(&something), dJointSetData(b, &something));
    judge_get("dJointTemplate::getData", a.getData() == &something, true);
    SET("dJointTemplate::setFeedback", read_joint, a, b, a.setFeedback(&feedback),
        dJointSetFeedback(b, &feedback));
    judge_get("dJointTemplate::getFeedback", a.getFeedback() == &feedback, true);
    a.setFeedback(0);

    // A type without parameters: whatever is set, nothing is there.
    dNullJoint none(rig.wrapped.world);
    dJoint& base = none;
    base.setParam(dParamFMax, 5);
    judge_get("dJointTemplate::setParam", base.getParam(dParamFMax), 0);
    judge_get("dJointTemplate::getParam", base.getParam(dParamLoStop), 0);
}

void test_group()
{
    Rig rig;
    dJointGroup group;
    judge_get("dJointGroupTemplate::id", group.id() != 0 && dJointGroupID(group) == group.id(), true);
    const char* names[] = {"dJointGroupTemplate::empty", "dJointGroupTemplate::clear",
                           "dJointGroupTemplate::create"};
    for (int i = 0; i < 3; ++i) {
        dJointAttach(dJointCreateBall(rig.wrapped.world, group), rig.wrapped.first, rig.wrapped.second);
        const bool was_there = rig.wrapped.first.getNumJoints() == 1;
        if (i == 0) group.empty();
        if (i == 1) group.clear();
        if (i == 2) group.create();
        judge_get(names[i], was_there && rig.wrapped.first.getNumJoints() == 0 && group.id() != 0, true);
    }
    {
        dJointGroup passing;
        dJointAttach(dJointCreateBall(rig.wrapped.world, passing), rig.wrapped.first, 0);
    }
    judge_get("dJointGroupTemplate::~", rig.wrapped.first.getNumJoints(), 0);
}

void test_destructors()
{
    dWorld world;
    dBody kept(world);
    {
        dBody passing(world);
        dHingeJoint hinge(world);
        hinge.attach(kept, passing);
        judge_get("dBodyTemplate::~ before", kept.getNumJoints(), 1);
    }
    judge_get("dJointTemplate::~", kept.getNumJoints(), 0);
    {
        dHingeJoint hinge(world);
        {
            dBody passing(world);
            hinge.attach(passing, kept);
        }
        judge_get("dBodyTemplate::~", hinge.getNumBodies(), 0);
    }
}

}  // namespace

void test_joint_group_and_base()
{
    test_base();
    test_group();
    test_destructors();
}
