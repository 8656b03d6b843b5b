// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Materials of world-managed contacts against closed forms: what rolls and spins slows down as
// mechanics says and holds on slopes, soft surfaces carry weight as springs and creep as dampers, and bodies
// in the same world do not notice.
#include <algorithm>

#include "golden/golden.h"
#include "rig.h"

namespace epode::physics {
namespace {

constexpr double kH = 1.0 / 120, kG = 9.81, kMass = 2, kRadius = 0.5;
constexpr double kLayer = 2e-4;  // that contacts may keep when the world's own is 0

dMaterial material(double rolling, double softness = 0, double damping_time = 0)
{
    dMaterial m{};
    m.struct_size = sizeof m;
    m.friction = real(0.8);
    m.rolling_friction = real(rolling), m.compliance = real(softness), m.damping_time = real(damping_time);
    return m;
}

// A ball or a box on a plane, the world's contacts.
struct Scene : Sim {
    dGeomID floor;

    explicit Scene(Stepper s) : Sim(s)
    {
        substeps = 5;
        gravity(0, 0, -kG);
        dWorldSetContactSpace(world, space);
        floor = ground();
    }
    void run(double seconds)
    {
        for (int i = 0; i < int(seconds / kH + 0.5); ++i) ASSERT_TRUE(advance(kH));
    }
    dBodyID ball() { return sphere({0, 0, kRadius}, kRadius, kMass); }
};

void paint(dGeomID geom, const dMaterial& m) { ASSERT_EQ(dGeomSetMaterial(geom, &m), 1); }
void paint(dBodyID body, const dMaterial& m) { paint(dBodyGetFirstGeom(body), m); }

class Materials : public testing::TestWithParam<Stepper> {};
INSTANTIATE_TEST_SUITE_P(Steppers, Materials, testing::ValuesIn(kSteppers), case_name);

// I w' = F r - rho N and m v' = -F with v = w r and I = 2/5 m r^2:  v' = -rho g / (1.4 r).
TEST_P(Materials, a_rolling_ball_slows_down_by_the_rolling_resistance)
{
    for (const double fast : {0.3, 3.0}) {
        Scene scene(GetParam());
        const dBodyID ball = scene.ball();
        paint(ball, material(0.02));
        velocity(ball, {fast, 0, 0}, {0, fast / kRadius, 0});
        scene.run(0.5);
        const double a = 0.02 * kG / (1.4 * kRadius);
        EXPECT_NEAR(velocity(ball).x, fast - 0.5 * a, 0.008) << fast;
        EXPECT_NEAR(spin(ball).y * kRadius, fast - 0.5 * a, 0.008) << fast;
        if (fast > 1) continue;
        scene.run(8);  // and does not roll back
        EXPECT_LT(length(velocity(ball)) + length(spin(ball)), 1e-3);
        EXPECT_NEAR(position(ball).x, fast * fast / (2 * a), 0.008);
    }
}

TEST_P(Materials, a_ball_that_spins_in_place_slows_down_too)
{
    Scene scene(GetParam());
    const dBodyID ball = scene.ball();
    paint(scene.floor, material(0.05));  // the larger one counts
    velocity(ball, {}, {0, 0, 8});
    scene.run(1);
    EXPECT_NEAR(spin(ball).z, 8 - 0.05 * kG / (0.4 * kRadius * kRadius), 0.1);
    EXPECT_LT(length(velocity(ball)), 1e-3);
}

TEST_P(Materials, a_ball_stays_on_a_slope_below_the_angle_of_its_resistance)
{
    for (const double rolling : {0.02, 0.01}) {  // over the radius: 0.04 and 0.02
        Scene scene(GetParam());
        const double slope = std::atan(0.03);
        scene.gravity(kG * std::sin(slope), 0, -kG * std::cos(slope));
        const dBodyID ball = scene.ball();
        paint(ball, material(rolling));
        scene.run(2);
        const double pull = std::sin(slope) - rolling / kRadius * std::cos(slope);
        if (pull < 0)
            EXPECT_LT(position(ball).x, 2e-3);
        else
            EXPECT_NEAR(position(ball).x, 0.5 * kG * pull / 1.4 * 4, 0.01);
    }
}

// N = depth / softness at each point, and softness adds up.
TEST_P(Materials, soft_surfaces_give_way_by_the_load_of_each_point)
{
    Scene scene(GetParam());
    const dBodyID ball = scene.ball(), box = scene.box({5, 0, 0.5}, {1, 1, 1}, 4);
    const double softness = 1e-3, more = 5e-4;
    paint(scene.floor, material(0, softness, 0.05));
    paint(box, material(0, more, 0.05));
    scene.run(5);
    EXPECT_NEAR(kRadius - position(ball).z, kLayer + kMass * kG * softness, 2e-4);
    EXPECT_NEAR(0.5 - position(box).z, kLayer + 4 * kG * (softness + more) / 4, 2e-4);
    EXPECT_LT(length(velocity(ball)) + length(velocity(box)), 1e-3);
}

// With so much damping that mass has no part in it:  depth = m g s (1 - exp(-t / damping_time)).
TEST_P(Materials, a_damped_surface_gives_way_slowly)
{
    const double softness = 0.05 / (kMass * kG);
    for (const double t : {0.25, 0.5, 1.0}) {
        Scene scene(GetParam());
        const dBodyID ball = scene.ball();
        // One behind the other: (1 * 0.2 + 3 * 0.6) / 4 = 0.5 s.
        paint(ball, material(0, softness / 4, 0.2)), paint(scene.floor, material(0, softness * 3 / 4, 0.6));
        scene.run(t);
        EXPECT_NEAR(kRadius - position(ball).z, kLayer + 0.05 * (1 - std::exp(-t / 0.5)), 0.0015) << t;
    }
}

// A spring without a damper keeps its period:  2 pi sqrt(m s), a little damped by the steps.
TEST_P(Materials, a_soft_surface_swings_as_a_spring)
{
    Scene scene(GetParam());
    const dBodyID ball = scene.ball();
    const double softness = 0.1 / (kMass * kG), w = 1 / std::sqrt(kMass * softness);
    paint(ball, material(0, softness));
    place(ball, {0, 0, kRadius - 0.1});  // at rest there
    velocity(ball, {0, 0, -0.3});
    std::vector<double> crossings;
    for (int i = 0; i < 240; ++i) {
        const double before = position(ball).z;
        ASSERT_TRUE(scene.advance(kH));
        const double rest = kRadius - 0.1 - kLayer, after = position(ball).z;
        if (before > rest && after <= rest) crossings.push_back(i + (before - rest) / (before - after));
    }
    ASSERT_GE(crossings.size(), 2u);
    EXPECT_NEAR((crossings[1] - crossings[0]) * kH, 2 * kPi / w, 0.03 * 2 * kPi / w);
}

std::uint64_t hash_of(const std::vector<dBodyID>& bodies)
{
    std::uint64_t hash = 0;
    for (const dBodyID body : bodies) {
        hash = hash_reals(dBodyGetPosition(body), 3, hash);
        hash = hash_reals(dBodyGetQuaternion(body), 4, hash);
        hash = hash_reals(dBodyGetAngularVel(body), 3, hash);
    }
    return hash;
}

// A hard pile, and islands of everything else in the same world, which share its lanes.
std::uint64_t pile_with_others(Stepper stepper, int threads, bool others, std::uint64_t* all)
{
    Scene scene(stepper);
    dWorldSetStepThreads(scene.world, threads);
    std::vector<dBodyID> pile;
    for (int i = 0; i < 12; ++i)
        pile.push_back(scene.box({0.2 * (i % 3), 0.3 * (i % 2), 0.6 + 1.05 * i}, {1, 1, 1}, 1 + i % 3));
    for (int i = 0; others && i < 9; ++i) {
        const dBodyID body = i % 2 ? scene.sphere({6.0 + 2 * i, 0, 0.7}, 0.5, 1)
                                   : scene.box({6.0 + 2 * i, 0, 0.7}, {1, 1, 1}, 2);
        paint(body, material(i % 3 ? 0.03 : 0, i % 3 != 1 ? 1e-3 : 0, 0.02));
        velocity(body, {1, 0.5, 0}, {1, 2, 3});
    }
    scene.run(0.7);
    if (all) *all = hash_state(scene);
    return hash_of(pile);
}

TEST_P(Materials, leave_the_bits_of_hard_bodies_in_the_same_world)
{
    std::uint64_t one = 0, many = 0;
    const std::uint64_t together = pile_with_others(GetParam(), 1, true, &one);
    // QuickStep's random orders depend on how many islands there are.
    if (GetParam() != Stepper::kQuick) {
        EXPECT_EQ(pile_with_others(GetParam(), 1, false, nullptr), together);
    }
    for (const int threads : {2, 5}) {
        EXPECT_EQ(pile_with_others(GetParam(), threads, true, &many), together);
        EXPECT_EQ(many, one);
    }
}

// The same on every kind of machine.
TEST(MaterialBits, are_these)
{
    if (kSingle) GTEST_SKIP() << "of doubles";
    for (const Stepper stepper : kSteppers) {
        std::uint64_t all = 0;
        pile_with_others(stepper, 1, true, &all);
        EXPECT_TRUE(golden::is_golden(std::string("physics/materials/") + name_of(stepper), all));
    }
}

}  // namespace
}  // namespace epode::physics
