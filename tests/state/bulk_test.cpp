// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Many bodies and joints at once: what the functions for one say, and all or nothing.
#include <cmath>
#include <limits>

#include "scene.h"

namespace epode::states {
namespace {

constexpr unsigned kAll = dStatePosition | dStateQuaternion | dStateLinearVel | dStateAngularVel |
                          dStateForce | dStateTorque | dStateEnabled;

std::vector<dReal> read(const std::vector<dBodyID>& bodies, unsigned fields, int width)
{
    std::vector<dReal> rows(bodies.size() * std::size_t(width));
    EXPECT_EQ(dBodiesGetStates(bodies.data(), int(bodies.size()), fields, rows.data(), 0), 1);
    return rows;
}

TEST(BodyStates, are_what_each_body_says)
{
    Scene a({.piles = 2}), b({.world_contacts = false, .piles = 1});
    a.steps(3), b.steps(2);
    std::vector<dBodyID> bodies = a.bodies;
    bodies.insert(bodies.end(), b.bodies.begin(), b.bodies.end());
    dBodyAddForce(bodies[1], 1, 2, 3), dBodyAddTorque(bodies[1], 4, 5, 6), dBodyDisable(bodies[2]);
    const std::vector<dReal> rows = read(bodies, kAll, 20);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const dReal* row = rows.data() + 20 * i;
        for (int k = 0; k < 3; ++k) {
            EXPECT_EQ(row[k], dBodyGetPosition(bodies[i])[k]);
            EXPECT_EQ(row[7 + k], dBodyGetLinearVel(bodies[i])[k]);
            EXPECT_EQ(row[10 + k], dBodyGetAngularVel(bodies[i])[k]);
            EXPECT_EQ(row[13 + k], dBodyGetForce(bodies[i])[k]);
            EXPECT_EQ(row[16 + k], dBodyGetTorque(bodies[i])[k]);
        }
        for (int k = 0; k < 4; ++k) EXPECT_EQ(row[3 + k], dBodyGetQuaternion(bodies[i])[k]);
        EXPECT_EQ(row[19], dReal(dBodyIsEnabled(bodies[i])));
    }
    std::vector<dReal> wide(bodies.size() * 9, -1);
    ASSERT_EQ(dBodiesGetStates(bodies.data(), int(bodies.size()), dStateLinearVel, wide.data(), 9), 1);
    EXPECT_EQ(wide[9 + 1], dBodyGetLinearVel(bodies[1])[1]);
    EXPECT_EQ(wide[9 + 3], -1) << "what is between rows is left alone";
}

TEST(BodyStates, set_as_the_setters_do)
{
    const Messages messages;
    const Setting setting{.stepper = Stepper::kSubsteps};
    Scene many(setting), single(setting);
    many.steps(30), single.steps(30);
    std::vector<dReal> rows = read(many.bodies, kAll, 20);
    for (std::size_t i = 0; i < many.bodies.size(); ++i) {
        dReal* row = rows.data() + 20 * i;
        row[2] += dReal(0.01), row[7] += 1, row[12] = dReal(i % 3), row[13] = 5, row[19] = i % 4 ? 1 : 0;
        row[3] *= 2, row[4] *= 2, row[5] *= 2, row[6] *= 2;  // setters make it a unit
        const dBodyID b = single.bodies[i];
        dBodySetPosition(b, row[0], row[1], row[2]), dBodySetQuaternion(b, row + 3);
        dBodySetLinearVel(b, row[7], row[8], row[9]), dBodySetAngularVel(b, row[10], row[11], row[12]);
        dBodySetForce(b, row[13], row[14], row[15]), dBodySetTorque(b, row[16], row[17], row[18]);
        row[19] != 0 ? dBodyEnable(b) : dBodyDisable(b);
    }
    ASSERT_EQ(dBodiesSetStates(many.bodies.data(), int(many.bodies.size()), kAll, rows.data(), 0), 1);
    EXPECT_TRUE(many.save() == single.save());
    many.steps(10), single.steps(10);
    EXPECT_TRUE(many.save() == single.save());
}

TEST(BodyStates, are_all_refused_where_one_is)
{
    const Messages messages;
    Scene scene({.piles = 1});
    const Bytes before = scene.save();
    std::vector<dReal> rows = read(scene.bodies, kAll, 20);
    for (dReal& x : rows) x += dReal(0.5);
    const int count = int(scene.bodies.size());
    const auto refused = [&](const std::vector<dBodyID>& bodies, int n, unsigned fields, const dReal* in,
                             int stride) {
        const int messages_before = Messages::count();
        EXPECT_EQ(dBodiesSetStates(bodies.data(), n, fields, in, stride), 0);
        EXPECT_EQ(Messages::count(), messages_before + 1);
        EXPECT_TRUE(scene.save() == before);
    };
    std::vector<dBodyID> bodies = scene.bodies;
    bodies.back() = nullptr;
    refused(bodies, count, kAll, rows.data(), 0);
    bodies = scene.bodies;
    refused(bodies, -1, kAll, rows.data(), 0);
    refused(bodies, count, 0, rows.data(), 0);
    refused(bodies, count, 128, rows.data(), 0);
    refused(bodies, count, kAll, nullptr, 0);
    refused(bodies, count, kAll, rows.data(), 19);
    rows[rows.size() - 5] = std::numeric_limits<dReal>::quiet_NaN();
    refused(bodies, count, kAll, rows.data(), 0);
    std::vector<dReal> zeros(std::size_t(4 * count), 0);
    refused(bodies, count, dStateQuaternion, zeros.data(), 0);
    EXPECT_EQ(dBodiesSetStates(nullptr, 0, kAll, nullptr, 0), 1) << "no bodies, nothing to do";
}

TEST(JointStates, are_what_each_joint_says)
{
    Scene scene({});
    scene.steps(40);
    constexpr int kStride = 3;
    std::vector<dReal> value(scene.joints.size() * kStride, -7), rate = value;
    ASSERT_EQ(
        dJointsGetStates(scene.joints.data(), int(scene.joints.size()), value.data(), rate.data(), kStride),
        1);
    EXPECT_EQ(value[0], 0) << "a ball has none";
    EXPECT_EQ(value[3], dJointGetHingeAngle(scene.joints[1]));
    EXPECT_EQ(rate[3], dJointGetHingeAngleRate(scene.joints[1]));
    EXPECT_EQ(value[4], 0);
    EXPECT_EQ(value[6], dJointGetSliderPosition(scene.joints[2]));
    EXPECT_EQ(rate[10], dJointGetUniversalAngle2Rate(scene.joints[3]));
    EXPECT_EQ(value[7 * 3 + 2], dJointGetPUPosition(scene.joints[7]));
    EXPECT_NE(value[7 * 3 + 2], 0);
    EXPECT_EQ(dJointsGetStates(scene.joints.data(), 1, nullptr, rate.data(), 1), 1);
    const Messages messages;
    EXPECT_EQ(dJointsGetStates(scene.joints.data(), 1, nullptr, rate.data(), 0), 0);
}

TEST(WorldLists, are_in_order_of_creation)
{
    Scene scene({.piles = 2});
    std::vector<dBodyID> bodies(scene.bodies.size());
    ASSERT_EQ(dWorldGetBodies(scene.world, bodies.data(), int(bodies.size())), int(bodies.size()));
    EXPECT_EQ(bodies, scene.bodies);
    dBodyID first[2] = {};
    EXPECT_EQ(dWorldGetBodies(scene.world, first, 2), int(bodies.size()));
    EXPECT_EQ(first[1], bodies[1]);
    EXPECT_EQ(dWorldGetBodies(scene.world, nullptr, 0), int(bodies.size()));
    std::vector<dJointID> joints(scene.joints.size());
    ASSERT_EQ(dWorldGetJoints(scene.world, joints.data(), int(joints.size())), int(joints.size()));
    EXPECT_EQ(joints, scene.joints);
}

}  // namespace
}  // namespace epode::states
