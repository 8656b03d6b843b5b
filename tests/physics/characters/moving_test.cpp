// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Characters and what moves: platforms, bodies that they push and that push them, other characters, platforms
// that let them through from below.
#include "stage.h"

namespace epode::characters {
namespace {

class Moving : public EveryCharacter {};
INSTANTIATE_TEST_SUITE_P(shapes, Moving, testing::ValuesIn(cases()), case_name);

// The platform turns by omega about its centre; the character stands 2 m off it.
TEST_P(Moving, is_carried_on_its_circle_by_a_platform_that_turns)
{
    Stage stage;
    const dBodyID platform = stage.heavy_box({0, 0, -0.5}, {8, 8, 1}, 1000);
    dBodySetKinematic(platform);
    const double omega = 0.7;
    dBodySetAngularVel(platform, 0, 0, dReal(omega));
    dBodySetFiniteRotationMode(platform, 1);  // an exact angle in each step
    const dGeomID c = stage.add({2, 0, 0}, settings());
    walk(c, {}, 0, h());
    double turned = 0;
    const int n = int(3 / h() + 0.5);
    for (int i = 1; i <= n; ++i) {
        dWorldStep(stage.world, dReal(h()));
        EXPECT_EQ(walk(c, {}, 0, h()), dCharacterOnGround);
        turned += report(c).turn;
        const double angle = omega * i * h();
        EXPECT_NEAR(feet(c).x, 2 * std::cos(angle), 1e-6 + 10 * kRounding);
        EXPECT_NEAR(feet(c).y, 2 * std::sin(angle), 1e-6 + 10 * kRounding);
        EXPECT_NEAR(turned, angle, 1e-6 + 10 * kRounding);
    }
    const dReal* R = dGeomGetRotation(c);
    EXPECT_NEAR(std::atan2(R[4], R[0]), turned, 1e-6 + 10 * kRounding);
}

TEST_P(Moving, rides_a_lift_up_and_down_and_sideways)
{
    Stage stage;
    const dBodyID lift = stage.heavy_box({0, 0, -0.5}, {4, 4, 1}, 100);
    dBodySetKinematic(lift);
    const dGeomID c = stage.add({0.5, 0.5, 0}, settings());
    walk(c, {}, 0, h());
    for (const V v : {V{0, 0, 2}, V{3, 1, 0}, V{0, 0, -2}, V{-1, 0, -1}}) {
        dBodySetLinearVel(lift, dReal(v.x), dReal(v.y), dReal(v.z));
        const int n = int(1 / h() + 0.5);
        for (int i = 0; i < n; ++i) {
            dWorldStep(stage.world, dReal(h()));
            EXPECT_EQ(walk(c, {}, 0, h()), dCharacterOnGround);
            EXPECT_NEAR(velocity(c).z, v.z, 1e-5 + 1e4 * kRounding);
            EXPECT_NEAR(report(c).ground_velocity[0], v.x, 1e-6 + kRounding);
        }
        const dReal* p = dBodyGetPosition(lift);
        EXPECT_NEAR(feet(c).x - p[0], 0.5, 1e-6 + 10 * kRounding);
        EXPECT_NEAR(feet(c).z - p[2], 0.5, 1e-5 + 10 * kRounding);
    }
}

// It rides as far as the ground has moved: after the step that is all of it, before the step all but that step's.
TEST_P(Moving, lags_by_nothing_after_the_step_and_by_one_steps_motion_before_it)
{
    for (const bool after : {true, false}) {
        Stage stage;
        const dBodyID raft = stage.heavy_box({0, 0, -0.5}, {8, 8, 1}, 100);
        dBodySetKinematic(raft);
        const dGeomID c = stage.add({0, 0, 0}, settings());
        walk(c, {}, 0, h());
        for (int i = 0; i * h() < 4; ++i) {
            const double v = 3 * std::sin(i * h());
            dBodySetLinearVel(raft, dReal(v), 0, dReal(0.3 * v));
            if (!after) walk(c, {}, 0, h());
            dWorldStep(stage.world, dReal(h()));
            if (after) walk(c, {}, 0, h());
            const dReal* p = dBodyGetPosition(raft);
            const double lag = after ? 0 : v * h();
            EXPECT_NEAR(p[0] - feet(c).x, lag, 1e-6 + 10 * kRounding) << i;
            EXPECT_NEAR(p[2] + 0.5 - feet(c).z, 0.3 * lag, 1e-5 + 10 * kRounding) << i;
        }
    }
}

TEST_P(Moving, takes_the_velocity_of_a_platform_into_a_jump)
{
    Stage stage;
    const dBodyID cart = stage.heavy_box({0, 0, -0.5}, {60, 4, 1}, 100);
    dBodySetKinematic(cart);
    dBodySetLinearVel(cart, 4, 0, 0);
    const dGeomID c = stage.add({0, 0, 0}, settings());
    for (int i = 0; i * h() < 1.5; ++i) {
        dWorldStep(stage.world, dReal(h()));
        walk(c, {}, i == 5 ? 4 : 0, h());
    }
    EXPECT_EQ(report(c).state, dCharacterOnGround);
    // It has landed where it jumped from, but for the step in which it was carried and flew.
    EXPECT_NEAR(feet(c).x - dBodyGetPosition(cart)[0], 0, 4 * 2 * h());
}

// The momentum of the body after n steps is at most F n h; against a wall it gets none of it.
TEST_P(Moving, pushes_bodies_with_a_bounded_force)
{
    Stage stage;
    stage.floor();
    dMaterial ice;
    dMaterialInit(&ice, sizeof ice);
    ice.friction = 0;
    const dBodyID crate = stage.heavy_box({1.2, 0, 0.5}, {1, 1, 1}, 300);
    dGeomSetMaterial(dBodyGetFirstGeom(crate), &ice);
    dCharacterSettings s = settings();
    s.max_force = 200;
    const dGeomID c = stage.add({0, 0, 0}, s);
    double pushed = 0;
    for (int i = 1; i * h() < 2; ++i) {
        walk(c, {3, 0, 0}, 0, h());
        const dReal* v = dBodyGetLinearVel(crate);
        EXPECT_LE(300 * v[0], 200 * i * h() * (1 + 1e-6) + 1e-3);
        pushed = 300 * v[0];
        dWorldStep(stage.world, dReal(h()));
    }
    EXPECT_GT(pushed, 0.5 * 200 * 1.8);
}

TEST_P(Moving, shoves_a_light_body_along_at_its_own_speed)
{
    Stage stage(dDefaultsGame);
    stage.floor();
    const dBodyID crate = stage.heavy_box({1.2, 0, 0.5}, {1, 1, 1}, 20);
    const dGeomID c = stage.add({0, 0, 0}, settings());
    for (int i = 0; i * h() < 3; ++i) {
        walk(c, {2, 0, 0}, 0, h());
        dWorldStep(stage.world, dReal(h()));
    }
    EXPECT_GT(dBodyGetPosition(crate)[0], 3);
    EXPECT_LT(feet(c).x + 0.3, dBodyGetPosition(crate)[0] - 0.5 + 0.005);
}

TEST_P(Moving, does_not_move_what_is_too_heavy)
{
    Stage stage(dDefaultsGame);
    stage.floor();
    const dBodyID crate = stage.heavy_box({1.2, 0, 0.5}, {1, 1, 1}, 2000);
    const dGeomID c = stage.add({0, 0, 0}, settings());
    for (int i = 0; i * h() < 2; ++i) {
        walk(c, {2, 0, 0}, 0, h());
        dWorldStep(stage.world, dReal(h()));
    }
    EXPECT_NEAR(dBodyGetPosition(crate)[0], 1.2, 5e-3);
    EXPECT_LT(feet(c).x, 0.4);
}

TEST_P(Moving, is_pushed_by_what_runs_into_it)
{
    Stage stage;
    stage.floor();
    const dBodyID wall = stage.heavy_box({1.5, 0, 1}, {1, 3, 2}, 100);
    dBodySetKinematic(wall);
    dBodySetLinearVel(wall, -2, 0, 0);
    const dGeomID c = stage.add({0, 0, 0}, settings());
    for (int i = 0; i * h() < 2; ++i) {
        dWorldStep(stage.world, dReal(h()));
        EXPECT_EQ(walk(c, {}, 0, h()), dCharacterOnGround);
        EXPECT_LE(feet(c).x + 0.3 + 0.01, dBodyGetPosition(wall)[0] - 0.5 + 1e-4);
    }
    EXPECT_NEAR(feet(c).x, 1.5 - 4 - 0.5 - 0.31, 2 * 2 * h());
}

TEST_P(Moving, weighs_on_what_it_stands_on)
{
    Stage stage;
    dCharacterSettings s = settings();
    const dBodyID board = stage.heavy_box({0, 0, 10}, {2, 2, 0.2}, 30);
    const dJointID spring = dJointCreateSlider(stage.world, nullptr);  // it falls freely along z
    dJointAttach(spring, board, nullptr);
    dJointSetSliderAxis(spring, 0, 0, 1);
    dBodySetGravityMode(board, 0);
    const dGeomID c = stage.add({0, 0, 10.1}, s);
    double weighed = 0;
    for (int i = 0; i < 5; ++i) {
        if (walk(c, {}, 0, h()) == dCharacterOnGround) weighed += s.mass * s.gravity * h();
        EXPECT_NEAR(30 * dBodyGetLinearVel(board)[2], -weighed, 1e-3 * weighed);
        dWorldStep(stage.world, dReal(h()));
    }
    EXPECT_GT(weighed, 0);
}

TEST_P(Moving, lets_a_sleeping_body_sleep_that_it_stands_on_or_next_to)
{
    Stage stage(dDefaultsGame);
    stage.floor();
    const dBodyID crate = stage.heavy_box({1, 0, 0.25}, {1, 1, 0.5}, 50);
    for (int i = 0; i * h() < 4; ++i) dWorldStep(stage.world, dReal(h()));
    ASSERT_EQ(dBodyIsEnabled(crate), 0);
    const dGeomID neighbour = stage.add({0, 0, 0}, settings());
    const dGeomID on = stage.add({1, 0, 0.5}, settings());
    for (int i = 0; i * h() < 2; ++i) {
        walk(neighbour, {}, 0, h()), walk(on, {}, 0, h());
        dWorldStep(stage.world, dReal(h()));
        EXPECT_EQ(dBodyIsEnabled(crate), 0);
    }
    for (int i = 0; i * h() < 0.5; ++i) walk(neighbour, {2, 0, 0}, 0, h());
    EXPECT_EQ(dBodyIsEnabled(crate), 1);
}

// A surface that moves while its geom does not; it turns with the geom, and a plane has one, too.
TEST_P(Moving, is_carried_by_a_belt)
{
    for (const bool plane : {false, true}) {
        Stage stage;
        const dGeomID ground = plane ? stage.floor() : stage.box({0, 0, -0.5}, {20, 20, 1});
        dMatrix3 turned;
        dRFromAxisAndAngle(turned, 0, 0, 1, dReal(0.5));
        if (!plane) dGeomSetRotation(ground, turned);
        dMaterial belt;
        dMaterialInit(&belt, sizeof belt);
        belt.surface_velocity[0] = dReal(1.5);
        dGeomSetMaterial(ground, &belt);
        const double cx = plane ? 1 : std::cos(0.5), cy = plane ? 0 : std::sin(0.5);
        const dGeomID c = stage.add({0, 0, 0}, settings());
        const int n = int(2 / h() + 0.5);
        for (int i = 0; i < n; ++i) {
            dWorldStep(stage.world, dReal(h()));
            EXPECT_EQ(walk(c, {}, 0, h()), dCharacterOnGround);
        }
        const double way = 1.5 * n * h();
        EXPECT_NEAR(feet(c).x, way * cx, 1e-6 + 10 * kRounding);
        EXPECT_NEAR(feet(c).y, way * cy, 1e-6 + 10 * kRounding);
        EXPECT_NEAR(feet(c).z, 0, 1e-6 + 10 * kRounding);
        EXPECT_NEAR(report(c).ground_velocity[0], 1.5 * cx, 1e-6);
        EXPECT_NEAR(velocity(c).x, 1.5 * cx, 1e-5 + 1e4 * kRounding);
    }
}

// A raft that has fallen asleep sinks by m / (rho A) under who steps on it, heels by m x / (rho I) as he walks, and comes up again.
TEST_P(Moving, weighs_on_what_floats_and_sleeps)
{
    Stage stage(dDefaultsGame);
    dFluidCreate(stage.world);
    const dBodyID raft = stage.heavy_box({0, 0, 0}, {3, 3, 0.4}, 1800);
    dBodySetLinearDamping(raft, dReal(h())), dBodySetAngularDamping(raft, dReal(h()));
    dBodySetLinearDampingThreshold(raft, 0), dBodySetAngularDampingThreshold(raft, 0);
    const auto settle = [&](dGeomID c) {
        for (int i = 0; i * h() < 12; ++i) {
            dWorldStepHybrid(stage.world, dReal(h()));
            if (c) walk(c, {}, 0, h());
        }
        return double(dBodyGetPosition(raft)[2]);
    };
    const double alone = settle(nullptr);
    ASSERT_EQ(dBodyIsEnabled(raft), 0);
    const dGeomID c = stage.add({0, 0, alone + 0.2}, settings());
    EXPECT_NEAR(alone - settle(c), 70.0 / (1000 * 9), 0.05 * 70 / (1000 * 9));
    for (int i = 0; i * h() < 0.5; ++i) {
        dWorldStepHybrid(stage.world, dReal(h()));
        walk(c, {2, 0, 0}, 0, h());
    }
    settle(c);
    // A capsule weighs under its middle, what has a flat sole somewhere under that.
    const double heel = std::asin(-dBodyGetRotation(raft)[8]), arm = feet(c).x - dBodyGetPosition(raft)[0];
    const double sole = GetParam().shape == dCapsuleClass ? 0 : 0.3;
    // Stability: of the waterplane, rho I, and the weights, whose middle is 0.1 m above that of the displaced water.
    const double per_metre = 70 / (1000 * (27 / 4.0) - 1870 * 0.1);
    EXPECT_GT(heel, 0.95 * per_metre * (arm - sole));
    EXPECT_LT(heel, 1.05 * per_metre * (arm + sole));
    dCharacterSetPosition(c, 9, 9, 9);
    dGeomDestroy(c);
    EXPECT_NEAR(settle(nullptr), alone, 2e-3);
}

TEST_P(Moving, weighs_on_a_bridge_that_sleeps)
{
    Stage stage(dDefaultsGame);
    dRopeSettings rope;
    dRopeSettingsInit(&rope, sizeof rope);
    rope.links = 10, rope.length = dReal(5.1), rope.mass = 100, rope.width = 1, rope.radius = dReal(0.03);
    dBodyID planks[10];
    const dVector3 from = {dReal(-2.5), 0, 0}, to = {dReal(2.5), 0, 0};
    ASSERT_EQ(dRopeCreate(stage.world, stage.space, from, to, nullptr, nullptr, &rope, planks, nullptr), 10);
    for (const dBodyID plank : planks)
        dBodySetLinearDamping(plank, dReal(3 * h())), dBodySetAngularDamping(plank, dReal(3 * h()));
    for (int i = 0; i * h() < 8; ++i) dWorldStepHybrid(stage.world, dReal(h()));
    for (const dBodyID plank : planks) dBodyDisable(plank);
    const double alone = dBodyGetPosition(planks[7])[2], x = dBodyGetPosition(planks[7])[0];
    const dGeomID c = stage.add({x, 0, alone + 0.1}, settings());
    for (int i = 0; i * h() < 3; ++i) {
        dWorldStepHybrid(stage.world, dReal(h()));
        walk(c, {}, 0, h());
    }
    EXPECT_EQ(report(c).state, dCharacterOnGround);
    EXPECT_LT(dBodyGetPosition(planks[7])[2], alone - 0.02);
}

TEST_P(Moving, is_stopped_by_another_character_and_rides_on_it)
{
    Stage stage;
    stage.floor();
    const dGeomID a = stage.add({0, 0, 0}, settings()), b = stage.add({2, 0, 0}, settings());
    for (int i = 0; i * h() < 2; ++i) walk(a, {2, 0, 0}, 0, h()), walk(b, {}, 0, h());
    EXPECT_NEAR(feet(a).x, 2 - 0.6 - 0.01, 1e-3);
    EXPECT_NEAR(feet(b).x, 2, kRounding);
    if (GetParam().shape == dCapsuleClass) return;  // a round head is no place to stand on
    dCharacterSetPosition(a, 2, 0, dReal(1.81));
    for (int i = 0; i * h() < 1; ++i) walk(b, {1, 0, 0}, 0, h()), walk(a, {}, 0, h());
    EXPECT_NEAR(feet(a).x - feet(b).x, 0, 1e-3 + h());
    EXPECT_EQ(report(a).ground, b);
}

// The platform's upper side is its z; it holds what comes from above.
struct OneWay {
    dGeomID platform;
    bool drop = false;
};
int from_above(void* data, dGeomID character, dGeomID other, const dVector3 velocity)
{
    const auto& way = *static_cast<OneWay*>(data);
    if (other != way.platform) return 1;
    dReal box[6];
    dGeomGetAABB(other, box);
    return !way.drop && velocity[2] <= 0 && feet(character).z >= box[5] - 0.02;
}

TEST_P(Moving, passes_a_one_way_platform_from_below_and_drops_through)
{
    Stage stage;
    stage.floor();
    OneWay way{stage.box({0, 0, 0.95}, {4, 4, 0.1})};
    dCharacterSettings s = settings();
    s.filter = from_above, s.data = &way;
    const dGeomID c = stage.add({0, 0, 0}, s);
    walk(c, {}, 0, h());
    for (int i = 0; i * h() < 1.5; ++i) walk(c, {}, i == 0 ? 6 : 0, h());
    EXPECT_EQ(report(c).ground, way.platform);
    EXPECT_NEAR(feet(c).z, 1, 1e-3);
    way.drop = true;
    for (int i = 0; i * h() < 1.5; ++i) walk(c, {}, 0, h());
    EXPECT_NEAR(feet(c).z, 0, 1e-3);
}

TEST_P(Moving, is_seen_by_sensors_and_exerts_no_contact_force)
{
    Stage stage;
    stage.floor();
    const dGeomID zone = stage.box({2, 0, 1}, {1, 1, 2});
    dGeomSetSensor(zone, 1);
    dEventSettings events;
    dEventSettingsInit(&events, sizeof events);
    dWorldSetEventSettings(stage.world, &events);
    const dGeomID c = stage.add({0, 0, 0}, settings());
    int begins = 0;
    for (int i = 0; i * h() < 2; ++i) {
        walk(c, {2, 0, 0}, 0, h());
        dWorldStep(stage.world, dReal(h()));
        dEvent list[8];
        const int n = dWorldGetEvents(stage.world, list, 8);
        for (int k = 0; k < std::min(n, 8); ++k) begins += list[k].kind == dEventSensorBegin;
    }
    EXPECT_EQ(begins, 1);
    EXPECT_GT(feet(c).x, 3.5);
}

}  // namespace
}  // namespace epode::characters
