// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Bobs that are small compared with the arms that they swing on: a ball of radius r, d from its joint, resists a force
// there 1 + 2.5 (d/r)^2 times as much along the arm as across it. Substeps must see the arm turn. Joints do
// no work, so at rest in the beginning nothing gains energy, and arms keep their length.
#include <algorithm>
#include <vector>

#include "rig.h"

namespace epode::physics {
namespace {

constexpr double kG = 9.81, kArm = 1;

double energy(dBodyID body, double radius)
{
    dMass mass;
    dBodyGetMass(body, &mass);
    const V3 v = vec(dBodyGetLinearVel(body)), w = vec(dBodyGetAngularVel(body));
    return double(mass.mass) *
           (0.5 * dot(v, v) + 0.2 * radius * radius * dot(w, w) + kG * vec(dBodyGetPosition(body)).z);
}

// Bobs in a row, each on an arm to the one before it or, `apart`, each to the world.
struct Bobs {
    Bobs(Stepper stepper, int count, double radius, bool hinges, bool apart) : sim(stepper), r(radius)
    {
        sim.gravity(0, 0, -kG);
        for (int i = 0; i < count; ++i) {
            const V3 at{kArm * (i + 1), 0, 0};
            const dBodyID bob = sim.body(at, 1, 0.4 * r * r),
                          before = i == 0 || apart ? nullptr : bobs.back();
            const dJointID joint =
                hinges ? dJointCreateHinge(sim.world, nullptr) : dJointCreateBall(sim.world, nullptr);
            dJointAttach(joint, bob, before);
            if (hinges) {
                dJointSetHingeAnchor(joint, real(at.x - kArm), 0, 0);
                dJointSetHingeAxis(joint, 0, 1, 0);
            } else {
                dJointSetBallAnchor(joint, real(at.x - kArm), 0, 0);
            }
            bobs.push_back(bob), joints.push_back(joint);
        }
    }

    double total() const
    {
        double sum = 0;
        for (dBodyID bob : bobs) sum += energy(bob, r);
        return sum;
    }

    double gap() const
    {
        double largest = 0;
        for (dJointID joint : joints) {
            dVector3 one, two;
            const bool hinge = dJointGetType(joint) == dJointTypeHinge;
            hinge ? dJointGetHingeAnchor(joint, one) : dJointGetBallAnchor(joint, one);
            hinge ? dJointGetHingeAnchor2(joint, two) : dJointGetBallAnchor2(joint, two);
            largest = std::max(largest, length(vec(one) - vec(two)));
        }
        return largest;
    }

    Sim sim;
    double r;
    std::vector<dBodyID> bobs;
    std::vector<dJointID> joints;
};

struct Case {
    int substeps;
    double radius, h;
};

constexpr double kSecond = 1;

class LongArms : public testing::TestWithParam<Case> {};

// The method is of first order: a double pendulum may gain some thousandths of its fall.
void swing(Bobs& bobs, const Case& c, double gap)
{
    bobs.sim.substeps = c.substeps;
    const double start = bobs.total(), fall = kG * kArm * double(bobs.bobs.size());
    for (int i = 0; i * c.h < 4 * kSecond; ++i) {
        bobs.sim.advance(c.h);
        ASSERT_LT(bobs.total(), start + 5e-3 * fall) << "r " << c.radius << ", step " << i;
        ASSERT_LT(bobs.gap(), gap) << "r " << c.radius << ", step " << i;
    }
    EXPECT_GT(bobs.total(), start - 0.25 * fall);
}

TEST_P(LongArms, of_a_pendulum)
{
    for (const bool hinges : {true, false}) {
        Bobs bobs(Stepper::kFast, 1, GetParam().radius, hinges, true);
        swing(bobs, GetParam(), 0.01);
    }
}

TEST_P(LongArms, of_a_double_pendulum)
{
    for (const bool hinges : {true, false}) {
        Bobs bobs(Stepper::kFast, 2, GetParam().radius, hinges, false);
        swing(bobs, GetParam(), 0.06);
    }
}

// The wheel of a hinge-2 with its centre far from the anchor.
TEST_P(LongArms, of_a_wheel)
{
    const Case& c = GetParam();
    Bobs bobs(Stepper::kFast, 0, c.radius, false, true);
    const dBodyID bob = bobs.sim.body({kArm, 0, 0}, 1, 0.4 * c.radius * c.radius),
                  axle = bobs.sim.body({0, 0, 0});
    dBodySetKinematic(axle);
    const dJointID wheel = dJointCreateHinge2(bobs.sim.world, nullptr);
    dJointAttach(wheel, axle, bob);
    dJointSetHinge2Anchor(wheel, 0, 0, 0);
    const dVector3 up = {0, 0, 1}, across = {0, 1, 0};
    dJointSetHinge2Axes(wheel, up, across);
    dJointSetHinge2Param(wheel, dParamSuspensionERP, real(0.8));
    dJointSetHinge2Param(wheel, dParamSuspensionCFM, real(1e-9));
    bobs.bobs.push_back(bob);
    swing(bobs, c, 0.01);
    EXPECT_NEAR(length(vec(dBodyGetPosition(bob))), kArm, 0.005);
}

// Enough joints for lanes of floats.
TEST_P(LongArms, of_many_pendulums)
{
    Bobs bobs(Stepper::kFast, 48, GetParam().radius, true, true);
    swing(bobs, GetParam(), 0.01);
}

INSTANTIATE_TEST_SUITE_P(Radii, LongArms,
                         testing::Values(Case{4, 0.3, 1 / 60.0}, Case{4, 0.1, 1 / 60.0},
                                         Case{4, 0.06, 1 / 60.0}, Case{4, 0.02, 1 / 60.0},
                                         Case{4, 0.05, 1 / 120.0}, Case{4, 0.02, 1 / 240.0},
                                         Case{12, 0.1, 1 / 60.0}, Case{12, 0.02, 1 / 60.0}));

}  // namespace
}  // namespace epode::physics
