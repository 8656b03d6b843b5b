// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A flywheel on the hinge of an arm that a ball joint holds at one end: it goes round at m g l / (I w) and does not fall. At 60 Hz it turns
// by 1.7 rad in a step, and the light arm swings faster than a step follows.
#include <gtest/gtest.h>
#include <ode/ext.h>
#include <ode/ode.h>

#include <cmath>

#ifdef dIDEDOUBLE  // the bounds are those of doubles

namespace epode::motion {
namespace {

constexpr double kArm = 0.2, kFlywheel = 2, kArmMass = 0.5, kRadius = 0.15, kSpin = 100, kGravity = 9.81;

class Gyroscope {
  public:
    explicit Gyroscope(int preset)
    {
        dWorldUseDefaults(world_, preset);
        dWorldSetGravity(world_, 0, 0, dReal(-kGravity));
        dMass mass;
        dMassSetBoxTotal(&mass, dReal(kArmMass), dReal(0.02), dReal(0.02), dReal(0.02));
        dBodySetMass(arm_, &mass);
        dMassSetCylinderTotal(&mass, dReal(kFlywheel), 1, dReal(kRadius), dReal(0.04));
        dBodySetMass(wheel_, &mass);
        const dJointID pivot = dJointCreateBall(world_, nullptr), axle = dJointCreateHinge(world_, nullptr);
        dJointAttach(pivot, arm_, nullptr);
        dJointSetBallAnchor(pivot, dReal(-kArm), 0, 0);
        dJointAttach(axle, arm_, wheel_);
        dJointSetHingeAnchor(axle, 0, 0, 0);
        dJointSetHingeAxis(axle, 1, 0, 0);
        dBodySetAngularVel(wheel_, dReal(kSpin), 0, 0);
    }
    ~Gyroscope() { dWorldDestroy(world_); }
    Gyroscope(const Gyroscope&) = delete;
    Gyroscope& operator=(const Gyroscope&) = delete;

    void run(double seconds, double h)
    {
        for (int i = 0; i < int(std::lround(seconds / h)); ++i) {
            ASSERT_EQ(dWorldStepHybrid(world_, dReal(h)), 1);
            const dReal* x = dBodyGetPosition(wheel_);
            lowest_ = std::fmin(lowest_, double(x[2]));
            const double now = std::atan2(double(x[1]), double(x[0]) + kArm);
            turned_ += std::remainder(now - heading_, 2 * M_PI), heading_ = now;
        }
    }
    double turned() const { return turned_; }
    double lowest() const { return lowest_; }
    double spin() const
    {
        const dReal* w = dBodyGetAngularVel(wheel_);
        return std::hypot(double(w[0]), double(w[1]), double(w[2]));
    }

  private:
    dWorldID world_ = dWorldCreate();
    dBodyID arm_ = dBodyCreate(world_), wheel_ = dBodyCreate(world_);
    double turned_ = 0, heading_ = 0, lowest_ = 0;
};

TEST(Gyroscope, goes_round_and_does_not_fall_in_the_presets)
{
    constexpr double kSeconds = 6, kMoment = (kFlywheel + kArmMass) * kGravity * kArm,
                     kMomentum = kFlywheel * kRadius * kRadius / 2 * kSpin;
    for (const int preset : {dDefaultsGame, dDefaultsRobot})
        for (const double h : {1.0 / 60, 1.0 / 240}) {
            Gyroscope gyroscope(preset);
            gyroscope.run(kSeconds, h);
            EXPECT_NEAR(gyroscope.turned(), kMoment / kMomentum * kSeconds, 0.4) << preset << ' ' << h;
            EXPECT_NEAR(gyroscope.spin(), kSpin, 0.05) << preset << ' ' << h;
            EXPECT_GT(gyroscope.lowest(), -0.05) << preset << ' ' << h;  // it nods
        }
}

}  // namespace
}  // namespace epode::motion

#endif
