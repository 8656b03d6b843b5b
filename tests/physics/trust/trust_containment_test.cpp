// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What cannot be computed is contained: a body pushed beyond all numbers, a joint torn to absurd distances, a
// body stepped at absurd speed. Its island keeps finite numbers and the report counts it; every other island
// ends with the bits it would have without the rogue.
#include <memory>
#include <vector>

#include "scenes.h"
#include "world_contacts.h"

namespace epode::physics {
namespace {

// Largest force that is accepted as a number, near enough.
constexpr double kHuge = tol(1e99, 1e17);
constexpr double kTiny = tol(1e-9, 1e-4);

struct TrustContainment : testing::TestWithParam<Stepper> {
    Sim sim{GetParam()};
    Messages messages;
    TrustContainment() { dWorldSetStepReportMode(sim.world, 1); }

    // A settling pile 100 m away from the origin would not notice; here it shares the space with the rogue.
    static void neighbours(Sim& s)
    {
        s.gravity(0, 0, -9.81);
        s.ground();
        for (int i = 0; i < 4; ++i) s.box({20, 0, 0.25 + 0.5 * i}, {0.5, 0.5, 0.5}, 1);
        s.sphere({20.1, 0, 3}, 0.3, 2);
    }
};

TEST_P(TrustContainment, a_body_pushed_beyond_all_numbers_is_contained_and_reported)
{
    dBodyID rogue = sim.body({0, 0, 5}, kTiny);
    velocity(rogue, {1, 2, 3});
    dBodyAddForce(rogue, real(kHuge), 0, 0);
    ASSERT_EQ(sim.advance(0.01), 1);
    EXPECT_EQ(sim.report().contained_islands, 1);
    EXPECT_EQ(velocity(rogue).x, 1) << "as before";
    EXPECT_EQ(velocity(rogue).z, 3);
    EXPECT_TRUE(finite_state(sim));
    // The force is gone with the step.
    ASSERT_EQ(sim.advance(0.01), 1);
    EXPECT_EQ(sim.report().contained_islands, 0);
}

TEST_P(TrustContainment, the_others_never_notice)
{
    Sim reference(GetParam());
    neighbours(reference);
    neighbours(sim);
    const std::size_t count = sim.bodies.size();
    dBodyID rogue = sim.body({0, 0, 50}, kTiny), tied = sim.body({1, 0, 50}, kTiny);
    dJointID j = dJointCreateBall(sim.world, nullptr);
    dJointAttach(j, rogue, tied);
    dJointSetBallAnchor(j, real(0.5), 0, 50);
    int contained = 0;
    for (int i = 0; i < 100; ++i) {
        if (i % 3 == 0) dBodyAddForce(rogue, real(kHuge), real(-kHuge), 0);
        ASSERT_EQ(sim.step(0.01), 1);
        contained += sim.report().contained_islands;
        ASSERT_EQ(reference.step(0.01), 1);
        ASSERT_TRUE(finite_state(sim)) << "step " << i;
    }
    EXPECT_EQ(contained, 34) << "once for each push";
    for (std::size_t i = 0; i < count; ++i)
        for (int k = 0; k < 3; ++k) {
            // QuickStep's order of sweeps is a function of the island's number, which the rogue may change.
            if (GetParam() == Stepper::kExact) {
                EXPECT_EQ(dBodyGetPosition(sim.bodies[i])[k], dBodyGetPosition(reference.bodies[i])[k]);
            } else {
                EXPECT_NEAR(dBodyGetPosition(sim.bodies[i])[k], dBodyGetPosition(reference.bodies[i])[k],
                            0.05);
            }
        }
}

// Islands that nothing holds are moved together; whatever their number, each has the bits that it has alone.
TEST_P(TrustContainment, free_bodies_move_together_as_each_does_alone)
{
    constexpr int kBodies = 1500, kRogue = 600;
    for (const bool world_contacts : {false, true})
        for (const bool exact_rotation : {false, true}) {
            Sim all(GetParam());
            std::vector<std::unique_ptr<Sim>> alone;
            Random random(31);
            const auto set_up = [&](Sim& s) {
                s.gravity(0, 0, -9.81);
                if (world_contacts) dWorldSetContactSpace(s.world, s.space);
                dWorldSetExactRotation(s.world, exact_rotation);
                dWorldSetStepReportMode(s.world, 1);
            };
            set_up(all);
            for (int i = 0; i < kBodies; ++i) {
                const V3 at{3.0 * i, 0, 0}, v = random.point(5), w = random.point(9);
                const auto put = [&](Sim& s) { velocity(s.box(at, {1, 0.8, 0.6}, 2), v, w); };
                i == kRogue ? (void)all.body(at, kTiny) : put(all);
                if (i % 100 != 7) continue;
                alone.push_back(std::make_unique<Sim>(GetParam()));
                set_up(*alone.back()), put(*alone.back());
            }
            const dBodyID rogue = all.bodies[kRogue];
            for (int step = 0; step < 10; ++step) {
                if (step == 4) dBodyAddForce(rogue, real(kHuge), 0, 0);
                ASSERT_EQ(all.step(0.01), 1);
                EXPECT_EQ(all.report().islands, kBodies);
                EXPECT_EQ(all.report().contained_islands, step == 4 ? 1 : 0) << step;
                for (const auto& one : alone) ASSERT_EQ(one->step(0.01), 1);
            }
            for (std::size_t k = 0; k < alone.size(); ++k) {
                const dBodyID a = all.bodies[100 * k + 7], b = alone[k]->bodies[0];
                for (int i = 0; i < 4; ++i) EXPECT_EQ(dBodyGetQuaternion(a)[i], dBodyGetQuaternion(b)[i]);
                for (int i = 0; i < 3; ++i) {
                    EXPECT_EQ(dBodyGetPosition(a)[i], dBodyGetPosition(b)[i]);
                    EXPECT_EQ(dBodyGetAngularVel(a)[i], dBodyGetAngularVel(b)[i]);
                }
            }
        }
}

TEST_P(TrustContainment, an_absurd_force_never_makes_a_nan)
{
    build(sim, Scene::kMachine);
    Random random(23);
    for (int i = 0; i < 200; ++i) {
        const double size = std::pow(10.0, random.uniform(0, kSingle ? 17 : 90));
        dBodyID b = sim.bodies[std::size_t(random.uniform(0, 13.99))];
        dBodyAddForce(b, real(size), 0, real(-size));
        dBodyAddTorque(b, 0, real(size), 0);
        ASSERT_EQ(sim.step(0.01), 1);
        ASSERT_TRUE(finite_state(sim)) << "step " << i << " size " << size;
    }
}

void put_back(dBodyID b, V3 at)
{
    const dQuaternion upright{1, 0, 0, 0};
    place(b, at);
    dBodySetQuaternion(b, upright);
    velocity(b, {});
}

// Rounding of a gyroscopic torque at 1e20 rad/s (1e9 in floats) is larger than what it turns: 20 steps made 1e102 of it.
TEST_P(TrustContainment, an_absurd_spin_neither_grows_nor_makes_a_nan)
{
    Random random(29);
    for (const bool world_contacts : {false, true})
        for (const int exponent : {3, 6, 9, 12, 16, kSingle ? 17 : 20, kSingle ? 17 : 52, kSingle ? 17 : 98})
            for (int k = 0; k < 10; ++k) {
                Sim one(GetParam());
                if (world_contacts) dWorldSetContactSpace(one.world, one.space);
                const dBodyID body = one.box({0, 0, 5}, {1, 0.9, 0.8}, 3);
                const V3 way = random.point(1);
                const double spin_at_first = std::pow(10.0, exponent);
                velocity(body, {1, 2, 3}, (spin_at_first / length(way)) * way);
                for (int i = 0; i < 20; ++i) one.advance(0.01);
                EXPECT_TRUE(finite_state(one)) << exponent;
                EXPECT_LT(length(spin(body)), 1.1 * spin_at_first) << exponent << ' ' << world_contacts;
            }
}

TEST_P(TrustContainment, a_joint_torn_apart_never_makes_a_nan_and_mends_when_put_back)
{
    dBodyID a = sim.body({0, 0, 0}), b = sim.body({1, 0, 0});
    dJointID j = dJointCreateHinge(sim.world, nullptr);
    dJointAttach(j, a, b);
    dJointSetHingeAnchor(j, real(0.5), 0, 0);
    // The iterating steppers start from the impulses of before, and need their time to forget them.
    const int tries = GetParam() == Stepper::kExact ? 1 : 20;
    for (double far : {1e6, 1e12, kSingle ? 1e15 : 1e50, kSingle ? 1e17 : 1e99}) {
        place(b, {far, 0, 0});
        for (int i = 0; i < 5; ++i) ASSERT_EQ(sim.advance(0.01), 1);
        ASSERT_TRUE(finite_state(sim)) << far;
        for (int i = 0; i < tries; ++i) {
            put_back(a, {}), put_back(b, {1, 0, 0});
            ASSERT_EQ(sim.advance(0.01), 1);
        }
        EXPECT_LT(length(velocity(b)), 1e-3) << far;
    }
}

TEST_P(TrustContainment, a_body_far_away_does_not_disturb_collision)
{
    neighbours(sim);
    dBodyID far = sim.sphere({0, 0, kSingle ? 1e15 : 1e30}, 0.5, 1);
    velocity(far, {kSingle ? 1e15 : 1e40, 0, 0}, {1e6, 0, 0});
    for (int i = 0; i < 20; ++i) ASSERT_EQ(sim.step(0.01), 1);
    EXPECT_TRUE(finite_state(sim));
    EXPECT_NEAR(position(sim.bodies[0]).z, 0.25, 0.02);
}

// Found by tests/robots/hostile: from 1e10 m/s on the exact stepper left world-managed contacts with normal forces below 0, and the
// iterating one with infinite ones, with which the next step began.
TEST_P(TrustContainment, no_contact_pulls_at_any_speed)
{
    for (const double speed :
         {1e3, 1e10, kSingle ? 1e14 : 1e20, kSingle ? 1e16 : 1e40, kSingle ? 1e17 : 1e90})
        for (const V3 direction : {V3{-1, 0, 0}, V3{0, -1, 0}, V3{0, 0, -1}}) {
            WorldContactsSim s(GetParam());
            s.ground();
            const dBodyID rogue = s.box({0, 0, 0.48}, {1, 1, 1}, 1);
            s.box({0.1, 0, 1.45}, {1, 1, 1}, 1);
            s.run(3);
            velocity(rogue, speed * direction);
            for (int i = 0; i < 3; ++i) {
                ASSERT_EQ(s.advance(0.005), 1);
                ASSERT_TRUE(finite_state(s)) << speed;
                for (const dWorldContact& contact : s.all_contacts()) {
                    ASSERT_GE(contact.normal_force, 0) << speed;
                    ASSERT_TRUE(std::isfinite(contact.normal_force)) << speed;
                    for (int k = 0; k < 3; ++k)
                        ASSERT_TRUE(std::isfinite(contact.friction_force[k])) << speed;
                }
            }
        }
}

INSTANTIATE_TEST_SUITE_P(Steppers, TrustContainment, testing::ValuesIn(kSteppers), case_name);

}  // namespace
}  // namespace epode::physics
