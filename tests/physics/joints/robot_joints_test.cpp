// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A quadruped of learners' size (Gymnasium's Ant) under random torques: its hinges stay together. The exact step
// is linear in the turn of a step, which is up to 0.5 rad here, so hinges open by centimetres; the projection
// of positions, which dDefaultsRobot switches on, closes them. EPODE_ROBOT_STEPS in the environment: how many steps (scripts/nightly: 100,000).
#include <algorithm>
#include <cstdlib>

#include "rig.h"

namespace epode::physics {
namespace {

constexpr double kStep = 0.01, kGap = 1e-3;  // s, m
constexpr double kTorque = 150;              // N m
constexpr int kHold = 5;                     // steps of the same torque

int step_count()
{
    const char* wanted = std::getenv("EPODE_ROBOT_STEPS");
    return wanted ? std::atoi(wanted) : 3000;
}

class Quadruped {
  public:
    Quadruped()
    {
        sim_.gravity(0, 0, -9.81);
        const dGeomID plane = dCreatePlane(sim_.space, 0, 0, 1, 0);
        dGeomSetCategoryBits(plane, 1);
        dGeomSetCollideBits(plane, 2);
        torso_ = sim_.sphere({0, 0, 0.75}, 0.25, 0.33);
        collide_with_ground(torso_);
        for (int leg = 0; leg < 4; ++leg) add_leg(leg % 2 ? -1 : 1, leg / 2 ? -1 : 1);
        dWorldSetContactSpace(sim_.world, sim_.space);
        dWorldUseDefaults(sim_.world, dDefaultsRobot);
    }

    void step()
    {
        for (const dJointID hinge : hinges_) {
            dDrive drive;
            dDriveInit(&drive, sizeof drive);
            drive.armature = 1, drive.damping = 1;
            drive.force = real(random_.uniform(-kTorque, kTorque));
            dJointSetDrive(hinge, 0, &drive);
        }
        for (int i = 0; i < kHold; ++i) ASSERT_EQ(dWorldStep(sim_.world, real(kStep)), 1);
    }

    double gap() const
    {
        double worst = 0;
        for (const dJointID hinge : hinges_) {
            dVector3 a, b;
            dJointGetHingeAnchor(hinge, a);
            dJointGetHingeAnchor2(hinge, b);
            worst = std::max(worst, length(vec(a) - vec(b)));
        }
        return worst;
    }
    V3 place() const { return vec(dBodyGetPosition(torso_)); }

  private:
    static void collide_with_ground(dBodyID body)
    {
        for (dGeomID geom = dBodyGetFirstGeom(body); geom; geom = dBodyGetNextGeom(geom)) {
            dGeomSetCategoryBits(geom, 2);
            dGeomSetCollideBits(geom, 1);
        }
    }

    // Two capsules, along (x, y): the hip turns about z, the ankle about a level axis.
    void add_leg(int x, int y)
    {
        const dBodyID thigh = add_link({0.3 * x, 0.3 * y, 0.75}, x, y, 0.283);
        const dBodyID shin = add_link({0.6 * x, 0.6 * y, 0.75}, x, y, 0.566);
        const double s = 0.70710678118654752;
        add_hinge(thigh, torso_, {0.2 * x, 0.2 * y, 0.75}, {0, 0, 1}, -0.5, 0.5);
        add_hinge(shin, thigh, {0.4 * x, 0.4 * y, 0.75}, {-s * y, s * x, 0}, 0.5, 1.2);
    }

    dBodyID add_link(V3 at, int x, int y, double reach)
    {
        const dBodyID body = sim_.capsule(at, 0.08, reach, 0.05);
        dMatrix3 R;
        dRFromZAxis(R, real(x), real(y), 0);
        dBodySetRotation(body, R);
        collide_with_ground(body);
        return body;
    }

    void add_hinge(dBodyID body, dBodyID parent, V3 at, V3 axis, double low, double high)
    {
        const dJointID hinge = dJointCreateHinge(sim_.world, nullptr);
        dJointAttach(hinge, body, parent);
        dJointSetHingeAnchor(hinge, real(at.x), real(at.y), real(at.z));
        dJointSetHingeAxis(hinge, real(axis.x), real(axis.y), real(axis.z));
        dJointSetHingeParam(hinge, dParamLoStop, real(low));
        dJointSetHingeParam(hinge, dParamHiStop, real(high));
        hinges_.push_back(hinge);
    }

    Sim sim_;
    Random random_{1};
    dBodyID torso_;
    std::vector<dJointID> hinges_;
};

TEST(RobotJoints, stay_together_under_random_torques)
{
    Quadruped robot;
    double worst = 0;
    for (int i = 0; i < step_count(); i += kHold) {
        robot.step();
        worst = std::max(worst, robot.gap());
        ASSERT_LE(worst, kGap) << "after " << i + kHold << " steps";
    }
    EXPECT_LT(std::fabs(robot.place().z), 50) << "it hops, and does not fly";
    RecordProperty("gap", std::to_string(worst));
}

}  // namespace
}  // namespace epode::physics
