// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// dAreConnectedExcluding says what the joints of the bodies say, whatever order contacts and other joints
// come, move and go in.
#include <algorithm>
#include <random>
#include <vector>

#include "rig.h"

namespace epode::physics {
namespace {

bool connected_but_by(int type, dBodyID a, dBodyID b)
{
    for (int i = 0; i < dBodyGetNumJoints(a); ++i) {
        const dJointID joint = dBodyGetJoint(a, i);
        const bool leads = dJointGetBody(joint, 0) == b || dJointGetBody(joint, 1) == b;
        if (leads && dJointGetType(joint) != type) return true;
    }
    return false;
}

dJointID joint_of_some_kind(dWorldID world, unsigned dice)
{
    dContact contact{};
    contact.geom.normal[2] = 1;
    if (dice % 3 != 0) return dJointCreateContact(world, nullptr, &contact);
    return dice % 2 ? dJointCreateBall(world, nullptr) : dJointCreateHinge(world, nullptr);
}

TEST(Connected, but_by_contacts_is_what_the_lists_of_joints_say)
{
    Sim sim(Stepper::kQuick);
    std::mt19937 dice(5);
    std::vector<dBodyID> bodies;
    for (int i = 0; i < 4; ++i) bodies.push_back(dBodyCreate(sim.world));
    std::vector<dJointID> joints;
    int yes = 0, no = 0;
    for (int turn = 0; turn < 2000; ++turn) {
        const unsigned roll = dice() % 8;
        if (joints.size() < 6 || roll < 4) {
            joints.push_back(joint_of_some_kind(sim.world, dice()));
            dJointAttach(joints.back(), bodies[dice() % 2], bodies[2 + dice() % 2]);
        } else if (roll < 7) {
            const auto gone = joints.begin() + int(dice() % joints.size());
            dJointDestroy(*gone);
            joints.erase(gone);
        } else {
            dJointAttach(joints[dice() % joints.size()], bodies[dice() % 2], bodies[2 + dice() % 2]);
        }
        for (const dBodyID a : bodies)
            for (const dBodyID b : bodies) {
                if (a == b) continue;
                const bool expected = connected_but_by(dJointTypeContact, a, b);
                ASSERT_EQ(dAreConnectedExcluding(a, b, dJointTypeContact) != 0, expected) << turn;
                expected ? ++yes : ++no;
            }
        while (joints.size() > 12) dJointDestroy(joints.back()), joints.pop_back();
    }
    EXPECT_GT(yes, 1000);
    EXPECT_GT(no, 1000);
    dBodyDestroy(bodies[0]);  // with its joints attached
    EXPECT_EQ(dAreConnectedExcluding(bodies[1], bodies[2], dJointTypeContact) != 0,
              connected_but_by(dJointTypeContact, bodies[1], bodies[2]));
    for (const dJointID joint : joints) dJointDestroy(joint);
}

}  // namespace
}  // namespace epode::physics
