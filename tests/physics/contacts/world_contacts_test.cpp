// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// World-managed contacts against what mechanics says: weight, friction in every direction, rebound,
// belts, momentum; against ODE's way where both must agree; what is reported of them; and the same bits on
// any number of threads.
#include <algorithm>
#include <map>
#include <utility>

#include "golden/golden.h"
#include "mesh_floors.h"
#include "world_contacts.h"

#pragma GCC diagnostic ignored "-Wdeprecated-declarations"  // transforms are part of the interface

namespace epode::physics {
namespace {

class WorldContacts : public testing::TestWithParam<Stepper> {};

TEST_P(WorldContacts, carry_the_weight_of_what_rests_on_them)
{
    WorldContactsSim sim(GetParam());
    sim.ground();
    const dBodyID low = sim.box({0, 0, 0.5}, {1, 1, 1}, 4), high = sim.box({0.1, 0, 1.5}, {1, 1, 1}, 2);
    const dBodyID ball = sim.sphere({5, 0, 0.5}, 0.5, 3), can = sim.cylinder({10, 0, 0.5}, 0.5, 1, 5);
    sim.run(240);
    V3 force[4];
    const dBodyID bodies[4] = {low, high, ball, can};
    for (const dWorldContact& c : sim.all_contacts()) {
        const V3 f = double(c.normal_force) * vec(c.normal) + vec(c.friction_force);
        for (int k = 0; k < 4; ++k) {
            if (dGeomGetBody(c.g1) == bodies[k]) force[k] = force[k] + f;
            if (dGeomGetBody(c.g2) == bodies[k]) force[k] = force[k] - f;
        }
        EXPECT_NEAR(double(c.depth), 2e-4, 1.5e-3);
    }
    const double mass[4] = {4, 2, 3, 5};
    for (int k = 0; k < 4; ++k) {
        EXPECT_NEAR(force[k].z, 9.81 * mass[k], 0.01 * 9.81 * mass[k]) << k;
        EXPECT_LT(length(velocity(bodies[k])), 2e-3) << k;
    }
}

TEST_P(WorldContacts, slow_what_slides_by_mu_g)
{
    // The exact and the quick solver bound friction in two directions, so along an axis only.
    const bool cone = GetParam() == Stepper::kFast;
    for (const double angle : {0.0, 22.5, 45.0, 80.0}) {
        if (!cone && angle > 0) continue;
        WorldContactsSim sim(GetParam());
        set_material(sim.ground(), 0.4);
        const dBodyID box = sim.box({0, 0, 0.149}, {0.6, 0.6, 0.3}, 2);
        set_material(geom_of(box), 0.4);
        sim.run(30);
        const double a = angle * kPi / 180, v0 = 6;
        velocity(box, {v0 * std::cos(a), v0 * std::sin(a), 0});
        const V3 from = position(box);
        sim.run(60);
        const V3 v = velocity(box), way = position(box) - from;
        EXPECT_NEAR(length(v), v0 - 0.4 * 9.81, 0.01 * 0.4 * 9.81) << angle;
        EXPECT_NEAR(std::atan2(way.y, way.x) * 180 / kPi, angle, 0.2) << angle;
    }
}

// In touch from the beginning, and with speculative contacts from a millimetre above the ground.
TEST_P(WorldContacts, let_roll_what_rolls)
{
    for (const double height : {0.4998, 0.501}) {
        WorldContactsSim sim(GetParam());
        sim.ground();
        const dBodyID ball = sim.sphere({0, 0, height}, 0.5, 3),
                      wheel = sim.cylinder({0, 5, height}, 0.5, 0.3, 2);
        const dQuaternion lying = {real(std::sqrt(0.5)), real(std::sqrt(0.5)), 0, 0};  // along y
        dBodySetQuaternion(wheel, lying);
        for (const dBodyID body : {ball, wheel}) velocity(body, {10, 0, 0}, {0, 20, 0});
        sim.run(180);
        for (const dBodyID body : {ball, wheel}) {
            EXPECT_NEAR(velocity(body).x, 10, 0.01) << height;
            EXPECT_NEAR(spin(body).y, 20, 0.02) << height;
            EXPECT_NEAR(position(body).x, 30, 0.03) << height;
            EXPECT_NEAR(position(body).z, 0.5, 0.001) << height;
        }
    }
}

TEST_P(WorldContacts, rebound_with_the_share_of_the_larger_bounce)
{
    WorldContactsSim sim(GetParam());
    set_material(sim.ground(), 0.5, 0.2);
    const dBodyID ball = sim.sphere({0, 0, 2}, 0.25, 1);
    set_material(geom_of(ball), 0.5, 0.8);
    double before = 0, after = 0;
    for (int i = 0; i < 120 && after <= 0; ++i) {
        before = velocity(ball).z;
        sim.run(1);
        after = velocity(ball).z;
    }
    EXPECT_NEAR(after, -0.8 * before, 0.04 * -before);
}

TEST_P(WorldContacts, move_with_a_belt)
{
    WorldContactsSim sim(GetParam());
    const dGeomID belt = dCreateBox(sim.space, 40, 2, 1);
    dGeomSetPosition(belt, 0, 0, real(-0.5));
    set_material(belt, 0.5, 0, {2, 0, 0});
    const dBodyID box = sim.box({-10, 0, 0.2}, {0.4, 0.4, 0.4}, 1);
    sim.run(120);
    EXPECT_NEAR(velocity(box).x, 2, 0.02);
    EXPECT_LT(std::fabs(velocity(box).y), 0.01);
}

TEST_P(WorldContacts, keep_momentum)
{
    WorldContactsSim sim(GetParam());
    sim.gravity(0, 0, 0);
    for (int i = 0; i < 12; ++i) {
        const double x = i % 3 * 1.05, y = i / 3 % 2 * 1.05, z = i / 6 * 1.05;
        const dBodyID b = i % 2 ? sim.box({x, y, z}, {1, 1, 1}, 1 + i) : sim.sphere({x, y, z}, 0.5, 1 + i);
        velocity(b, {0.3 * (1 - x), 0.4 * (0.5 - y), 0.7 * (0.5 - z)}, {0, 0.1 * i, 0});
    }
    const V3 before = momentum(sim), turn = angular_momentum(sim);
    sim.run(100);
    EXPECT_GT(sim.all_contacts().size(), 0u);
    EXPECT_LT(length(momentum(sim) - before), 2e-4);
    EXPECT_LT(length(angular_momentum(sim) - turn), 0.03 * (1 + length(turn)));
}

TEST_P(WorldContacts, hold_on_meshes_and_height_fields)
{
    for (const Floor floor : {Floor::kMesh, Floor::kTwoMeshes, Floor::kField}) {
        WorldContactsSim sim(GetParam());
        const FlatGround ground(sim, floor, 20, 0.7);
        const dBodyID box = sim.box({0.3, 0.2, 0.5}, {1, 1, 1}, 2);
        const dBodyID ball = sim.sphere({3.1, 2.2, 0.5}, 0.5, 2);
        sim.run(180);
        EXPECT_NEAR(position(box).z, 0.5, 0.005);
        EXPECT_NEAR(position(ball).z, 0.5, 0.005);
        EXPECT_LT(length(velocity(box)), 5e-3);
    }
}

TEST_P(WorldContacts, work_together_with_joints_and_contact_joints)
{
    WorldContactsSim sim(GetParam());
    sim.ground();
    const dBodyID a = sim.box({0, 0, 0.5}, {1, 1, 1}, 1), b = sim.box({1, 0, 0.5}, {1, 1, 1}, 1);
    const dJointID hinge = dJointCreateHinge(sim.world, nullptr);
    dJointAttach(hinge, a, b);
    dJointSetHingeAnchor(hinge, real(0.5), 0, real(0.5));
    dJointSetHingeAxis(hinge, 0, 1, 0);
    // This one is held by contacts of the program's own: its geom is not in the space.
    const dBodyID own = sim.body({5, 0, 0});
    for (int i = 0; i < 120; ++i) {
        for (const double x : {4.5, 5.5})
            for (const double y : {-0.5, 0.5}) {
                dContact c = make_contact({x, y, 0}, {0, 0, 1}, -position(own).z);
                dJointAttach(dJointCreateContact(sim.world, sim.contacts, &c), own, nullptr);
            }
        sim.run(1);
        dJointGroupEmpty(sim.contacts);
    }
    EXPECT_NEAR(position(own).z, 0, 0.02);
    EXPECT_NEAR(position(a).z, 0.5, 0.01);
    EXPECT_NEAR(length(position(a) - position(b)), 1, 0.005);
    EXPECT_EQ(dBodyGetNumJoints(a), 1);
    for (const dWorldContact& c : sim.all_contacts())
        EXPECT_FALSE(dGeomGetBody(c.g1) == a && dGeomGetBody(c.g2) == b) << "joined bodies do not collide";
}

bool collide_after_a_step(WorldContactsSim& sim, dGeomID a, dGeomID b)
{
    sim.run(1);
    const auto all = sim.all_contacts();
    return std::any_of(all.begin(), all.end(), [&](const dWorldContact& c) {
        return (c.g1 == a && c.g2 == b) || (c.g1 == b && c.g2 == a);
    });
}

// What is known of a pair from the step before must not outlive the joint.
TEST_P(WorldContacts, are_between_bodies_without_a_joint_whenever_it_comes_or_goes)
{
    WorldContactsSim sim(GetParam());
    sim.ground();
    const dBodyID low = sim.box({0, 0, 0.5}, {1, 1, 1}, 4), high = sim.box({0, 0, 1.5}, {1, 1, 1}, 2);
    const dGeomID below = geom_of(low), above = geom_of(high);
    sim.run(30);
    EXPECT_TRUE(collide_after_a_step(sim, below, above));
    const dJointID joint = dJointCreateFixed(sim.world, nullptr);
    EXPECT_TRUE(collide_after_a_step(sim, below, above)) << "attached to nothing";
    for (int times = 0; times < 2; ++times) {
        dJointAttach(joint, low, high);
        dJointSetFixed(joint);
        EXPECT_FALSE(collide_after_a_step(sim, below, above));
        EXPECT_FALSE(collide_after_a_step(sim, below, above));
        dJointAttach(joint, nullptr, nullptr);
        EXPECT_TRUE(collide_after_a_step(sim, below, above));
    }
    dJointAttach(joint, high, low);
    dJointSetFixed(joint);
    EXPECT_FALSE(collide_after_a_step(sim, below, above));
    dJointDestroy(joint);
    EXPECT_TRUE(collide_after_a_step(sim, below, above));
}

TEST_P(WorldContacts, follow_a_geom_to_a_body_with_a_joint_and_back)
{
    WorldContactsSim sim(GetParam());
    sim.ground();
    const dBodyID low = sim.box({0, 0, 0.5}, {1, 1, 1}, 4), high = sim.box({0, 0, 1.5}, {1, 1, 1}, 2);
    const dGeomID below = geom_of(low), above = geom_of(high);
    const dBodyID tied = sim.body({0, 0, 1.5});
    const dJointID joint = dJointCreateFixed(sim.world, nullptr);
    dJointAttach(joint, low, tied);
    dJointSetFixed(joint);
    sim.run(30);
    EXPECT_TRUE(collide_after_a_step(sim, below, above));
    dGeomSetBody(above, tied);
    EXPECT_FALSE(collide_after_a_step(sim, below, above));
    dGeomSetBody(above, high);
    dBodySetPosition(high, 0, 0, real(1.4999));
    EXPECT_TRUE(collide_after_a_step(sim, below, above));
}

INSTANTIATE_TEST_SUITE_P(Steppers, WorldContacts, testing::ValuesIn(kSteppers), case_name);

TEST(WorldContactEvents, are_sent_when_geoms_begin_and_cease_to_touch)
{
    WorldContactsSim sim(Stepper::kFast);
    const dGeomID ground = sim.ground();
    const dBodyID box = sim.box({0, 0, 0.6}, {1, 1, 1}, 1);
    std::vector<dContactEventKind> seen;
    const auto note = [&] {
        for (const dContactEvent& e : sim.events()) {
            EXPECT_EQ(e.g1, geom_of(box));
            EXPECT_EQ(e.g2, ground);
            if (seen.empty() || seen.back() != e.kind) seen.push_back(e.kind);
        }
    };
    for (int i = 0; i < 60; ++i) sim.run(1), note();
    velocity(box, {0, 0, 3});
    for (int i = 0; i < 20; ++i) sim.run(1), note();
    EXPECT_EQ(seen, (std::vector{dContactBegin, dContactPersist, dContactEnd}));
    EXPECT_TRUE(sim.events().empty());
}

TEST(WorldContactEvents, of_geoms_that_are_gone_report_the_end_of_touch)
{
    WorldContactsSim sim(Stepper::kFast);
    sim.ground();
    const dBodyID box = sim.box({0, 0, 0.499}, {1, 1, 1}, 1);
    sim.run(2);
    ASSERT_EQ(sim.events().size(), 1u);
    dGeomDestroy(geom_of(box));
    EXPECT_EQ(sim.events()[0].g1, nullptr);
    EXPECT_EQ(sim.all_contacts()[0].g1, nullptr);
    sim.run(1);
    ASSERT_EQ(sim.events().size(), 1u);
    EXPECT_EQ(sim.events()[0].kind, dContactEnd);
    EXPECT_EQ(sim.events()[0].g1, nullptr);
    sim.run(1);
    EXPECT_TRUE(sim.events().empty());
}

struct Asked {
    std::map<std::pair<dGeomID, dGeomID>, int> times;
    dGeomID never;
};

int ask(void* data, dGeomID a, dGeomID b)
{
    auto& asked = *static_cast<Asked*>(data);
    ++asked.times[{std::min(a, b), std::max(a, b)}];
    return a != asked.never && b != asked.never;
}

TEST(WorldContactFilter, is_asked_once_and_obeyed)
{
    WorldContactsSim sim(Stepper::kFast);
    sim.ground();
    const dBodyID stays = sim.box({0, 0, 0.5}, {1, 1, 1}, 1), falls = sim.box({3, 0, 0.5}, {1, 1, 1}, 1);
    Asked asked{{}, geom_of(falls)};
    dWorldSetContactFilter(sim.world, ask, &asked);
    sim.run(30);
    EXPECT_EQ(asked.times.size(), 2u);
    for (const auto& [pair, times] : asked.times) EXPECT_EQ(times, 1);
    EXPECT_NEAR(position(stays).z, 0.5, 0.01);
    EXPECT_LT(position(falls).z, 0);
}

TEST(WorldContactFilter, cannot_take_a_geom_from_under_the_step)
{
    WorldContactsSim sim(Stepper::kQuick);
    sim.ground();
    sim.box({0, 0, 0.5}, {1, 1, 1}, 1);
    const Messages messages;
    dWorldSetContactFilter(
        sim.world,
        [](void*, dGeomID a, dGeomID b) {
            dGeomDestroy(a);
            dGeomDestroy(b);
            return 1;
        },
        nullptr);
    sim.run(1);
    EXPECT_EQ(messages.count(), 2);
    EXPECT_EQ(sim.all_contacts().size(), 4u);
}

TEST(ContactSpace, is_let_go_when_it_is_destroyed)
{
    WorldContactsSim sim(Stepper::kFast);
    const dSpaceID other = dSimpleSpaceCreate(nullptr);
    dWorldSetContactSpace(sim.world, other);
    EXPECT_EQ(dWorldGetContactSpace(sim.world), other);
    dSpaceDestroy(other);
    EXPECT_EQ(dWorldGetContactSpace(sim.world), nullptr);
    const dBodyID ball = sim.sphere({0, 0, 1}, 0.5, 1);
    sim.ground();
    sim.run(60);
    EXPECT_LT(position(ball).z, 0);  // nothing stops it
}

TEST(ContactSpace, opens_spaces_in_it)
{
    WorldContactsSim sim(Stepper::kFast);
    sim.ground();
    const dSpaceID inner = dHashSpaceCreate(sim.space), innermost = dSimpleSpaceCreate(inner);
    const dBodyID low = sim.box({0, 0, 0.5}, {1, 1, 1}, 1), high = sim.box({0, 0, 1.5}, {1, 1, 1}, 1);
    for (const auto& [body, into] : {std::pair{low, inner}, std::pair{high, innermost}}) {
        dSpaceRemove(sim.space, geom_of(body));
        dSpaceAdd(into, geom_of(body));
    }
    sim.run(60);
    EXPECT_NEAR(position(low).z, 0.5, 0.01);
    EXPECT_NEAR(position(high).z, 1.5, 0.01);
}

TEST(WorldContactsSleep, puts_a_pile_to_sleep_and_wakes_what_is_hit)
{
    WorldContactsSim sim(Stepper::kFast);
    sim.ground();
    dWorldSetAutoDisableFlag(sim.world, 1);
    const dBodyID low = sim.box({0, 0, 0.5}, {1, 1, 1}, 1), high = sim.box({0, 0, 1.5}, {1, 1, 1}, 1);
    sim.run(240);
    EXPECT_FALSE(dBodyIsEnabled(low));
    EXPECT_FALSE(dBodyIsEnabled(high));
    const V3 at = position(high);
    sim.run(60);
    EXPECT_EQ(length(position(high) - at), 0);
    const dBodyID ball = sim.sphere({-3, 0, 1.6}, 0.3, 1);
    velocity(ball, {10, 0, 0});
    sim.run(30);
    EXPECT_GT(position(high).x, 0.005);
}

TEST(WorldContactsContinuous, bullets_stop_at_walls_and_are_held)
{
    for (const double speed : {5.0, 300.0}) {
        WorldContactsSim sim(Stepper::kFast);
        sim.gravity(0, 0, 0);
        dCreateBox(sim.space, real(0.02), 4, 4);
        const dBodyID ball = sim.sphere({-2, 0, 0}, 0.05, 1);
        dGeomSetContinuous(geom_of(ball), dContinuousOn);
        velocity(ball, {speed, 0, 0});
        sim.run(60);
        EXPECT_LT(position(ball).x, -0.05) << speed;
        EXPECT_LT(std::fabs(velocity(ball).x), 0.1) << speed;
    }
}

// Towers and loose boxes, balls and capsules, a chain; nothing of libm.
void build_mixture(WorldContactsSim& sim)
{
    set_material(sim.ground(), 0.5, 0.1);
    Random random(11);
    for (int i = 0; i < 60; ++i) {
        const V3 at{random.uniform(-3, 3), random.uniform(-3, 3), 0.6 + 0.25 * i};
        dBodyID b = nullptr;
        if (i % 4 == 0) b = sim.sphere(at, 0.3, 1);
        if (i % 4 == 1) b = sim.capsule(at, 0.2, 0.5, 1);
        if (i % 4 == 2) b = sim.cylinder(at, 0.3, 0.4, 1);
        if (i % 4 == 3) b = sim.box(at, {0.5, 0.6, 0.4}, 1);
        const V3 spin = random.point(1), way = random.point(1);  // in this order with every compiler
        velocity(b, way, spin);
    }
    for (int i = 0; i < 40; ++i)
        for (int k = 0; k < 3; ++k) sim.box({10.0 + 2 * i, 0, 0.5 + k}, {1, 1, 1}, 1);
    for (int i = 0; i < 6; ++i) {
        sim.box({-6, 0.3 * i, 1.5}, {0.2, 0.2, 0.2}, 1);
        if (i == 0) continue;
        const dJointID ball = dJointCreateBall(sim.world, nullptr);
        dJointAttach(ball, sim.bodies[sim.bodies.size() - 2], sim.bodies.back());
        dJointSetBallAnchor(ball, -6, real(0.3 * i - 0.15), real(1.5));
    }
}

std::uint64_t mixture(Stepper stepper, int threads, bool report)
{
    WorldContactsSim sim(stepper);
    dWorldSetStepThreads(sim.world, threads);
    dWorldSetStepReportMode(sim.world, report);
    build_mixture(sim);
    sim.run(60);
    EXPECT_TRUE(finite_state(sim));
    return hash_state(sim);
}

TEST(WorldContactsThreads, have_the_same_bits_on_any_number_and_with_a_report)
{
    for (int k = 0; k < 3; ++k) {
        const std::uint64_t alone = mixture(kSteppers[k], 1, false);
        for (const int threads : {2, 3, 5, 8})
            EXPECT_EQ(mixture(kSteppers[k], threads, false), alone)
                << name_of(kSteppers[k]) << ' ' << threads;
        EXPECT_EQ(mixture(kSteppers[k], 2, true), alone) << name_of(kSteppers[k]);
        if (kSingle) continue;
        EXPECT_TRUE(golden::is_golden(std::string("physics/mixture/") + name_of(kSteppers[k]), alone));
    }
}

// Geoms that need the caller's thread, or that are elsewhere: in an inner space, in none that the world looks
// at, behind a transform, of size zero, on bodies with callbacks.
std::vector<dBodyID>* t_moved;

void note_moved(dBodyID body)
{
    t_moved->push_back(body);
    dBodyAddForce(body, 1000, 0, 0);  // accumulators are emptied after the callback
}

struct Traces {
    std::uint64_t hash = 0;
    std::vector<std::size_t> moved;  // places of bodies
    std::vector<double> boxes;       // of all geoms, and of the space
    std::vector<std::pair<int, int>> pairs;
    bool operator==(const Traces&) const = default;
};

Traces scattered(int threads)
{
    WorldContactsSim sim(Stepper::kFast);
    dWorldSetStepThreads(sim.world, threads);
    build_mixture(sim);
    const dSpaceID inner = dSimpleSpaceCreate(sim.space), other = dHashSpaceCreate(nullptr);
    const auto move_to = [&](dBodyID body, dSpaceID to) {
        dSpaceRemove(sim.space, geom_of(body));
        dSpaceAdd(to, geom_of(body));
    };
    std::vector<dBodyID> moved;
    t_moved = &moved;
    std::vector<dGeomID> geoms;
    for (std::size_t i = 0; i < sim.bodies.size(); ++i) {
        const dBodyID body = sim.bodies[i];
        geoms.push_back(geom_of(body));
        if (i % 17 == 5)
            move_to(body, other);
        else if (i % 13 == 3)
            move_to(body, inner);
        if (i % 11 == 0) dBodySetMovedCallback(body, note_moved);
        if (i % 19 == 7) {
            const dGeomID held = dCreateSphere(nullptr, real(0.4)), holder = dCreateGeomTransform(sim.space);
            dGeomTransformSetCleanup(holder, 1);
            dGeomTransformSetGeom(holder, held);
            dGeomSetBody(holder, body);
            geoms.push_back(holder);
        }
        if (i % 23 == 9) {
            const dGeomID second = dCreateSphere(sim.space, i % 2 ? real(0.2) : real(0));
            dGeomSetBody(second, body);
            dGeomSetOffsetPosition(second, real(0.3), 0, 0);
            geoms.push_back(second);
        }
    }
    sim.run(50);
    EXPECT_TRUE(finite_state(sim));
    Traces out{hash_state(sim), {}, {}, {}};
    for (const dBodyID body : moved)
        out.moved.push_back(
            std::size_t(std::find(sim.bodies.begin(), sim.bodies.end(), body) - sim.bodies.begin()));
    geoms.push_back(reinterpret_cast<dGeomID>(sim.space));
    for (const dGeomID geom : geoms) {
        dReal box[6];
        dGeomGetAABB(geom, box);
        out.boxes.insert(out.boxes.end(), box, box + 6);
    }
    for (std::size_t i = 0; i < geoms.size(); ++i) dGeomSetData(geoms[i], reinterpret_cast<void*>(i + 1));
    dSpaceCollide(sim.space, &out.pairs, [](void* data, dGeomID a, dGeomID b) {
        const auto number = [](dGeomID g) { return int(reinterpret_cast<std::intptr_t>(dGeomGetData(g))); };
        static_cast<std::vector<std::pair<int, int>>*>(data)->push_back({number(a), number(b)});
    });
    for (const dBodyID body : sim.bodies) dBodySetMovedCallback(body, nullptr);
    for (std::size_t i = 5; i < sim.bodies.size(); i += 17) dGeomDestroy(geom_of(sim.bodies[i]));
    dSpaceDestroy(other);
    return out;
}

TEST(WorldContactsThreads, all_geoms_are_known_to_have_moved)
{
    const Traces alone = scattered(1);
    EXPECT_GT(alone.moved.size(), 50u * 10);
    EXPECT_GT(alone.pairs.size(), 50u);
    for (const int threads : {2, 4}) EXPECT_TRUE(scattered(threads) == alone) << threads;
}

TEST(WorldContacts, of_a_first_exact_step_are_those_of_contact_joints)
{
    const auto velocities = [](bool world_contacts) {
        Sim sim(Stepper::kExact);
        sim.gravity(0, 0, -9.81);
        sim.ground();
        dWorldSetContactSurfaceLayer(sim.world, real(1e-3));
        sim.surface.mu = real(0.6);
        sim.surface.mode = dContactApprox1;
        const dBodyID ball = sim.sphere({0, 0, 0.49}, 0.5, 1), box = sim.box({3, 0, 0.495}, {1, 1, 1}, 2);
        velocity(ball, {1, 0.5, -1}, {0, 2, 0});
        velocity(box, {0.5, 0, -0.3});
        if (world_contacts) {
            dWorldSetContactSpace(sim.world, sim.space);
            EXPECT_TRUE(sim.advance(0.01));
        } else {
            sim.step(0.01);
        }
        return std::vector<V3>{velocity(ball), spin(ball), velocity(box), spin(box)};
    };
    const std::vector<V3> ours = velocities(true), odes = velocities(false);
    for (std::size_t i = 0; i < ours.size(); ++i) EXPECT_LT(length(ours[i] - odes[i]), 1e-5) << i;
}

TEST(WorldContacts, refuse_what_is_not_usable)
{
    WorldContactsSim sim(Stepper::kFast);
    const dGeomID ground = sim.ground();
    dMaterial before{}, after{};
    before.struct_size = after.struct_size = sizeof before;
    EXPECT_EQ(dGeomGetMaterial(ground, &before), 1);
    EXPECT_NEAR(before.friction, 0.6, 1e-6);
    Messages messages;
    int expected = 0;
    const auto refused = [&](double friction, double bounce, double speed, double belt) {
        dMaterial m{};
        m.struct_size = sizeof m;
        m.friction = real(friction), m.bounce = real(bounce), m.bounce_speed = real(speed);
        m.surface_velocity[0] = real(belt);
        EXPECT_EQ(dGeomSetMaterial(ground, &m), 0);
        EXPECT_EQ(messages.count(), ++expected);
    };
    const double nan = std::nan("");
    refused(-1, 0, 0, 0), refused(nan, 0, 0, 0), refused(1, 1.5, 0, 0), refused(1, 0, -1, 0),
        refused(1, 0, 0, nan);
    EXPECT_EQ(dGeomGetMaterial(ground, nullptr), 0);
    EXPECT_EQ(dWorldGetContacts(sim.world, nullptr, 3), 0);
    EXPECT_EQ(dWorldGetContactEvents(nullptr, nullptr, 0), 0);
    EXPECT_EQ(messages.count(), expected + 3);
    EXPECT_EQ(dGeomGetMaterial(ground, &after), 1);
    EXPECT_EQ(after.friction, before.friction);
}

}  // namespace
}  // namespace epode::physics
