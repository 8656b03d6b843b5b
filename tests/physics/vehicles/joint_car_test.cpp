// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The car of hinge-2 joints of docs/guide/howto/vehicles.md, at 60 Hz: its wheels turn by 2 rad in a step at 40 m/s, and its path is
// still that of its steering angles, where rotation is exact or the program says before every step about which axis each wheel turns fast.
// With neither the same car turns by 0.019 rad where 0.031 are steered, and goes on turning when its wheels are straight again.
#include <gtest/gtest.h>
#include <ode/ext.h>
#include <ode/ode.h>

#include <cmath>

#ifdef dIDEDOUBLE  // the bounds are those of doubles

namespace epode::vehicles {
namespace {

constexpr double kTyre = 0.33, kLong = 2.6, kWide = 1.5, kCarStep = 1.0 / 60;

enum class Axles { kUnknown, kSaid, kFound };
constexpr Axles kKnown[] = {Axles::kSaid, Axles::kFound};

class JointCar {
  public:
    explicit JointCar(double speed, Axles axles) : speed_(speed), says_axles_(axles == Axles::kSaid)
    {
        dWorldSetExactRotation(world_, axles == Axles::kFound);
        dWorldSetGravity(world_, 0, 0, dReal(-9.81));
        dWorldSetContactSpace(world_, space_);
        dCreatePlane(space_, 0, 0, 1, 0);
        add_chassis();
        for (int i = 0; i < 4; ++i) add_wheel(i);
    }
    ~JointCar()
    {
        dSpaceDestroy(space_);
        dWorldDestroy(world_);
    }
    JointCar(const JointCar&) = delete;
    JointCar& operator=(const JointCar&) = delete;

    // Both front wheels point to the centre of the turn of a middle one with that angle.
    void steer(double angle)
    {
        for (int i = 0; i < 2; ++i) {
            const double y = i ? -kWide / 2 : kWide / 2, t = std::tan(angle),
                         own = std::atan2(kLong * t, kLong - y * t);
            dJointSetHinge2Param(joints_[i], dParamLoStop, dReal(-own));
            dJointSetHinge2Param(joints_[i], dParamHiStop, dReal(-own));
        }
    }
    void run(double seconds, bool hybrid)
    {
        for (int i = 0; i < int(std::lround(seconds / kCarStep)); ++i) {
            for (int w = 0; w < 4 && says_axles_; ++w) {
                dVector3 axle;
                dJointGetHinge2Axis2(joints_[w], axle);
                dBodySetFiniteRotationAxis(wheels_[w], axle[0], axle[1], axle[2]);
            }
            ASSERT_EQ((hybrid ? dWorldStepHybrid : dWorldStep)(world_, dReal(kCarStep)), 1);
        }
    }
    void push(double yaw_rate) { dBodySetAngularVel(chassis_, 0, 0, dReal(yaw_rate)); }
    double heading() const
    {
        const dReal* R = dBodyGetRotation(chassis_);
        return std::atan2(double(R[4]), double(R[0]));
    }
    double sideways() const { return double(dBodyGetPosition(chassis_)[1]); }
    // Speed over yaw rate, at the rear axle.
    double radius() const
    {
        dVector3 v;
        dBodyGetRelPointVel(chassis_, dReal(-kLong / 2), 0, 0, v);
        return std::hypot(double(v[0]), double(v[1])) / std::fabs(double(dBodyGetAngularVel(chassis_)[2]));
    }

  private:
    void add_chassis()
    {
        dMass mass;
        dMassSetBoxTotal(&mass, 1100, 4, dReal(1.6), dReal(0.6));
        dBodySetMass(chassis_, &mass);
        dBodySetPosition(chassis_, 0, 0, dReal(0.55));
        dBodySetLinearVel(chassis_, dReal(speed_), 0, 0);
    }
    void add_wheel(int i)
    {
        const dReal x = dReal(i < 2 ? kLong / 2 : -kLong / 2), y = dReal(i % 2 ? -kWide / 2 : kWide / 2),
                    r = dReal(kTyre);
        const dBodyID wheel = wheels_[i] = dBodyCreate(world_);
        dMass mass;
        dMassSetCylinderTotal(&mass, 25, 2, r, dReal(0.2));
        dBodySetMass(wheel, &mass);
        dBodySetPosition(wheel, x, y, r);
        dBodySetLinearVel(wheel, dReal(speed_), 0, 0);
        dBodySetAngularVel(wheel, 0, dReal(speed_) / r, 0);
        const dGeomID tyre = dCreateSphere(space_, r);
        dGeomSetBody(tyre, wheel);
        dMaterial material{};
        material.struct_size = sizeof material;
        dGeomGetMaterial(tyre, &material);
        material.friction = 1;
        dGeomSetMaterial(tyre, &material);
        dBodySetFiniteRotationMode(wheel, 1);
        mount(i, x, y);
    }
    void mount(int i, dReal x, dReal y)
    {
        const dReal up[3] = {0, 0, 1}, axle[3] = {0, 1, 0}, h = dReal(kCarStep), k = 40000, d = 4000;
        const dJointID joint = joints_[i] = dJointCreateHinge2(world_, nullptr);
        dJointAttach(joint, chassis_, wheels_[i]);
        dJointSetHinge2Anchor(joint, x, y, dReal(kTyre));
        dJointSetHinge2Axes(joint, up, axle);
        dJointSetHinge2Param(joint, dParamSuspensionERP, h * k / (h * k + d));
        dJointSetHinge2Param(joint, dParamSuspensionCFM, 1 / (h * k + d));
        dJointSetHinge2Param(joint, dParamLoStop, 0);
        dJointSetHinge2Param(joint, dParamHiStop, 0);
        if (i < 2) return;
        dJointSetHinge2Param(joint, dParamVel2, dReal(-speed_ / kTyre));
        dJointSetHinge2Param(joint, dParamFMax2, 600);
    }

    double speed_;
    bool says_axles_;
    dWorldID world_ = dWorldCreate();
    dSpaceID space_ = dHashSpaceCreate(nullptr);
    dBodyID chassis_ = dBodyCreate(world_);
    dBodyID wheels_[4] = {};
    dJointID joints_[4] = {};
};

class JointCars : public testing::TestWithParam<Axles> {};
INSTANTIATE_TEST_SUITE_P(Axles, JointCars, testing::ValuesIn(kKnown),
                         [](const auto& its) { return its.param == Axles::kSaid ? "said" : "found"; });

TEST_P(JointCars, go_straight_at_40_m_s)
{
    for (const bool hybrid : {false, true}) {
        JointCar car(40, GetParam());
        car.run(10, hybrid);
        EXPECT_NEAR(car.sideways(), 0, 0.1);
        EXPECT_NEAR(car.heading(), 0, 1e-3);
    }
}

// Wheels that do not skid do not let a car turn. (At 60 Hz it spun out from 0.01 rad/s on.)
TEST_P(JointCars, go_straight_after_a_blow)
{
    for (const bool hybrid : {false, true}) {
        JointCar car(40, GetParam());
        car.run(1, hybrid);
        car.push(0.2);
        car.run(9, hybrid);
        EXPECT_NEAR(car.heading(), 0, 0.01);
    }
}

// v tan(angle) / L times the time that the wheels were turned, and no more once they are straight.
void steer_for_a_while(JointCar& car, bool hybrid)
{
    car.run(1, hybrid);
    car.steer(0.01);
    car.run(0.2, hybrid);
    car.steer(0);
    car.run(0.8, hybrid);
}

constexpr double kSteered = 40 * 0.01 / kLong * 0.2;

TEST_P(JointCars, turn_by_what_is_steered_at_40_m_s_and_no_farther)
{
    for (const bool hybrid : {false, true}) {
        JointCar car(40, GetParam());
        steer_for_a_while(car, hybrid);
        const double turned = car.heading();
        EXPECT_NEAR(std::fabs(turned), kSteered, 0.03 * kSteered);
        car.run(8, hybrid);
        EXPECT_NEAR(car.heading(), turned, 1e-4);
    }
}

TEST_P(JointCars, turn_with_ackermanns_radius)
{
    struct Turn {
        double speed, angle;
    };
    for (const Turn turn : {Turn{8, 0.2}, Turn{20, 0.03}, Turn{40, 0.008}}) {
        JointCar car(turn.speed, GetParam());
        car.steer(turn.angle);
        car.run(8, false);
        const double asked = kLong / std::tan(turn.angle);
        EXPECT_NEAR(car.radius(), asked, 0.03 * asked) << turn.speed;
    }
}

TEST(JointCar, turns_by_something_else_where_axles_are_unknown)
{
    JointCar car(40, Axles::kUnknown);
    steer_for_a_while(car, false);
    car.run(8, false);
    EXPECT_GT(std::fabs(std::fabs(car.heading()) - kSteered), 1e-4);
}

}  // namespace
}  // namespace epode::vehicles
#endif
