// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Angular motors in the mode of turns: positions are the rotation vector, the stops of axis 0 a cone in all directions, drives springs of
// torsion about any axis; and stops whose rate is bounded.
#include <gtest/gtest.h>
#include <ode/ext.h>
#include <ode/ode.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace {

class TurnMotor : public testing::Test {
  protected:
    TurnMotor()
    {
        dInitODE2(0);
        world = dWorldCreate();
        for (dBodyID* one : {&a, &b}) {
            *one = dBodyCreate(world);
            dMass mass;
            dMassSetSphereTotal(&mass, 1, dReal(0.5));  // 0.1 kg m^2
            dBodySetMass(*one, &mass);
        }
        const dQuaternion anyhow = {dReal(0.8), dReal(0.2), dReal(-0.5), dReal(0.27)};
        dBodySetQuaternion(b, anyhow);
    }
    ~TurnMotor() override
    {
        dWorldDestroy(world);
        dCloseODE();
    }
    dJointID make(dBodyID one, dBodyID two)
    {
        const dJointID motor = dJointCreateAMotor(world, nullptr);
        dJointAttach(motor, one, two);
        dJointSetAMotorMode(motor, dAMotorTurn);
        return motor;
    }
    static std::vector<double> turn_of(dJointID motor)
    {
        std::vector<double> out;
        for (int i = 0; i < 3; ++i) out.push_back(double(dJointGetAxisPosition(motor, i)));
        return out;
    }

    dWorldID world;
    dBodyID a, b;
};

// Body 1 turned by r in its own axes after the mode was set.
TEST_F(TurnMotor, reads_the_rotation_vector)
{
    const double r[3] = {0.4, -1.1, 0.7}, angle = std::sqrt(0.16 + 1.21 + 0.49);
    for (const bool alone : {false, true}) {
        const dJointID motor = alone ? make(a, nullptr) : make(a, b);
        EXPECT_EQ(dJointGetAMotorNumAxes(motor), 3);
        for (double one : turn_of(motor)) EXPECT_NEAR(one, 0, 1e-12);
        const double s = std::sin(angle / 2) / angle;
        const dQuaternion turned = {dReal(std::cos(angle / 2)), dReal(s * r[0]), dReal(s * r[1]),
                                    dReal(s * r[2])};
        const dReal* const q = dBodyGetQuaternion(a);
        dQuaternion before = {q[0], q[1], q[2], q[3]}, after;
        dQMultiply0(after, before, turned);
        dBodySetQuaternion(a, after);
        for (int i = 0; i < 3; ++i) EXPECT_NEAR(turn_of(motor)[size_t(i)], r[i], 1e-6);
        dBodySetQuaternion(a, before);
        dJointDestroy(motor);
    }
}

TEST_F(TurnMotor, holds_the_angle_by_the_stops_of_its_first_axis)
{
    const dJointID motor = make(a, b);
    dJointSetAMotorParam(motor, dParamHiStop, dReal(0.6));
    dBodySetAngularVel(a, dReal(0.5), -1, dReal(0.3));
    double largest = 0;
    for (int i = 0; i < 400; ++i) {
        dWorldStep(world, dReal(0.005));
        const std::vector<double> r = turn_of(motor);
        largest = std::max(largest, std::sqrt(r[0] * r[0] + r[1] * r[1] + r[2] * r[2]));
    }
    EXPECT_NEAR(largest, 0.6, 0.01);
    // The bodies go on together.
    const dReal *wa = dBodyGetAngularVel(a), *wb = dBodyGetAngularVel(b);
    const double sum = double(wa[0] + wb[0]);
    EXPECT_NEAR(sum, 0.5, 0.02) << "momentum about x, of two equal balls";
}

TEST_F(TurnMotor, refuses_axes_and_keeps_its_turn_in_a_clone)
{
    const dJointID motor = make(a, b);
    dBodySetAngularVel(a, 0, 1, 0);
    for (int i = 0; i < 20; ++i) dWorldStep(world, dReal(0.01));
    dHandlePair table[8];
    const dWorldID copy = dWorldClone(world, nullptr, table, 8);
    ASSERT_NE(copy, nullptr);
    const dJointID twin = dBodyGetJoint(dWorldGetBodies(copy, nullptr, 0) > 0 ? [&] {
        dBodyID bodies[2];
        dWorldGetBodies(copy, bodies, 2);
        return bodies[0];
    }() : nullptr, 0);
    EXPECT_EQ(dJointGetAMotorMode(twin), dAMotorTurn);
    EXPECT_EQ(turn_of(twin), turn_of(motor));
    dWorldDestroy(copy);
}

// h v <= rate error h, whatever the step is; ERP / h alone throws the faster, the smaller it is.
TEST_F(TurnMotor, a_rate_bounds_how_fast_a_stop_pushes_back)
{
    const dJointID hinge = dJointCreateHinge(world, nullptr);
    dJointAttach(hinge, a, nullptr);
    dJointSetHingeParam(hinge, dParamLoStop, dReal(0.25)), dJointSetHingeParam(hinge, dParamHiStop, 3);
    EXPECT_EQ(dJointGetStopRate(hinge, 0), dReal(dInfinity));
    EXPECT_EQ(dJointSetStopRate(hinge, 0, 20), 1);
    EXPECT_EQ(dJointGetStopRate(hinge, 0), 20);
    for (const double h : {0.01, 0.001, 0.0001}) {
        const dQuaternion none = {1, 0, 0, 0};
        dBodySetQuaternion(a, none), dBodySetAngularVel(a, 0, 0, 0);
        dJointSetHingeAnchor(hinge, 0, 0, 0);
        dWorldStep(world, dReal(h));
        EXPECT_NEAR(std::fabs(double(dJointGetHingeAngleRate(hinge))), 5, 0.01) << h;
    }
    EXPECT_EQ(dJointSetStopRate(hinge, 0, 0), 0);
    EXPECT_EQ(dJointSetStopRate(hinge, 1, 5), 0);
    EXPECT_EQ(dJointGetStopRate(hinge, 0), 20);
}

}  // namespace
