// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A trolley whose wheels are on plain hinges, without springs, as most first programs build one, and its trailer. At 60 Hz its wheels turn by
// 1 to 3 rad in a step. It rolls straight on, on the floor, at its speed; in the presets it once left its line after two seconds at 20 m/s, and at
// 40 m/s was thrown up after one.
#include <gtest/gtest.h>
#include <ode/ext.h>
#include <ode/ode.h>

#include <cmath>
#include <string>
#include <vector>

#ifdef dIDEDOUBLE  // the bounds are those of doubles

namespace epode::vehicles {
namespace {

constexpr double kWheel = 0.3, kWheelStep = 1.0 / 60;
enum class Tyre { kBall, kCylinder, kCapsule };

struct Rolling {
    int preset;
    Tyre tyre;
    bool wheel_first;  // in dJointAttach
};

class Trolley {
  public:
    Trolley(const Rolling& how, double speed, bool pulls) : how_(how), speed_(speed)
    {
        dWorldUseDefaults(world_, how.preset);
        dWorldSetGravity(world_, 0, 0, dReal(-9.81));
        dWorldSetContactSpace(world_, space_);
        dCreatePlane(space_, 0, 0, 1, 0);
        add_cart(0, 500);
        if (!pulls) return;
        add_cart(-3, 300);
        const dJointID hitch = dJointCreateBall(world_, nullptr);
        dJointAttach(hitch, carts_[0], carts_[1]);
        dJointSetBallAnchor(hitch, dReal(-1.5), 0, dReal(0.5));
    }
    ~Trolley()
    {
        dSpaceDestroy(space_);
        dWorldDestroy(world_);
    }
    Trolley(const Trolley&) = delete;
    Trolley& operator=(const Trolley&) = delete;

    void run(double seconds)
    {
        for (int i = 0; i < int(std::lround(seconds / kWheelStep)); ++i)
            ASSERT_EQ(dWorldStepHybrid(world_, dReal(kWheelStep)), 1);
    }
    void expect_straight() const
    {
        for (const dBodyID cart : carts_) {
            const dReal *x = dBodyGetPosition(cart), *v = dBodyGetLinearVel(cart);
            EXPECT_NEAR(double(x[1]), 0, 1e-6);
            EXPECT_NEAR(double(x[2]), 0.5, 0.002);
            EXPECT_NEAR(double(v[0]) / speed_, 1, 1e-6);
            EXPECT_NEAR(double(v[2]), 0, 1e-4);
        }
    }

  private:
    dBodyID place(dGeomID geom, const dMass& mass, dReal x, dReal y, dReal z)
    {
        const dBodyID body = dBodyCreate(world_);
        dBodySetMass(body, &mass);
        if (geom) dGeomSetBody(geom, body);
        dBodySetPosition(body, x, y, z);
        dBodySetLinearVel(body, dReal(speed_), 0, 0);
        return body;
    }
    dGeomID make_tyre()
    {
        const dReal r = dReal(kWheel);
        if (how_.tyre == Tyre::kBall) return dCreateSphere(space_, r);
        return how_.tyre == Tyre::kCylinder ? dCreateCylinder(space_, r, dReal(0.2))
                                            : dCreateCapsule(space_, r, dReal(0.1));
    }
    void add_cart(dReal x, dReal kilograms)
    {
        dMass mass;
        dMassSetBoxTotal(&mass, kilograms, 2, 1, dReal(0.4));
        const dBodyID cart = place(nullptr, mass, x, 0, dReal(0.5));
        for (int i = 0; i < 4; ++i)
            add_wheel(cart, x + dReal(i & 1 ? 0.7 : -0.7), dReal(i & 2 ? 0.65 : -0.65));
        carts_.push_back(cart);
    }
    void add_wheel(dBodyID cart, dReal x, dReal y)
    {
        dMass mass;
        dMassSetCylinderTotal(&mass, 15, 3, dReal(kWheel), dReal(0.2));
        const dBodyID wheel = place(make_tyre(), mass, x, y, dReal(kWheel));
        dMatrix3 lying;
        dRFromAxisAndAngle(lying, 1, 0, 0, dReal(M_PI / 2));
        dBodySetRotation(wheel, lying);
        dBodySetAngularVel(wheel, 0, dReal(speed_ / kWheel), 0);
        const dJointID hinge = dJointCreateHinge(world_, nullptr);
        how_.wheel_first ? dJointAttach(hinge, wheel, cart) : dJointAttach(hinge, cart, wheel);
        dJointSetHingeAnchor(hinge, x, y, dReal(kWheel));
        dJointSetHingeAxis(hinge, 0, 1, 0);
    }

    Rolling how_;
    double speed_;
    dWorldID world_ = dWorldCreate();
    dSpaceID space_ = dHashSpaceCreate(nullptr);
    std::vector<dBodyID> carts_;
};

std::vector<Rolling> all()
{
    std::vector<Rolling> out;
    for (int preset : {dDefaultsGame, dDefaultsRobot})
        for (Tyre tyre : {Tyre::kBall, Tyre::kCylinder, Tyre::kCapsule})
            for (bool first : {false, true}) out.push_back({preset, tyre, first});
    return out;
}

std::string name_of(const testing::TestParamInfo<Rolling>& its)
{
    const char* const tyres[] = {"balls", "cylinders", "capsules"};
    return std::string(its.param.preset == dDefaultsGame ? "game_" : "robot_") + tyres[int(its.param.tyre)] +
           (its.param.wheel_first ? "_wheel_first" : "_cart_first");
}

class HingedWheels : public testing::TestWithParam<Rolling> {};
INSTANTIATE_TEST_SUITE_P(Presets, HingedWheels, testing::ValuesIn(all()), name_of);

TEST_P(HingedWheels, roll_straight_on)
{
    for (const double speed : {5.0, 20.0, 40.0}) {
        Trolley trolley(GetParam(), speed, false);
        trolley.run(5);
        trolley.expect_straight();
    }
}

TEST_P(HingedWheels, and_with_a_trailer)
{
    Trolley trolley(GetParam(), 20, true);
    trolley.run(5);
    trolley.expect_straight();
}

}  // namespace
}  // namespace epode::vehicles

#endif
