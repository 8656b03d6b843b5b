// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// dWorldSetManifoldFriction: one force and one couple for all points of a contact. Boxes on their faces
// against closed forms: mu g in every direction, the mean radius of four corners while turning, the ellipsoid
// between the two; what is reported of the forces; what keeps its own friction point by point; bits.
#include <algorithm>
#include <functional>

#include "golden/golden.h"
#include "world_contacts.h"

namespace epode::physics {
namespace {

constexpr double kG = 9.81, kMu = 0.4;

struct Way {
    const char* name;
    Stepper stepper;
    bool world_contacts;
};
constexpr Way kWays[] = {{"quick", Stepper::kQuick, false},
                         {"fast", Stepper::kFast, false},
                         {"managed_quick", Stepper::kQuick, true},
                         {"managed_fast", Stepper::kFast, true}};

// Contact joints, or world-managed contacts, all with friction of 0.4.
struct Faces : Sim {
    explicit Faces(const Way& way, int mode = 1, double mu = kMu)
        : Sim(way.stepper), world_contacts(way.world_contacts)
    {
        gravity(0, 0, -kG);
        surface.mu = real(mu);
        friction = mu;
        dWorldSetManifoldFriction(world, mode);
        if (world_contacts) dWorldSetContactSpace(world, space), substeps = 5;
    }

    void floor() { dress(ground()); }
    dBodyID add(V3 at, V3 size, double mass)
    {
        const dBodyID body = box(at, size, mass);
        dress(geom_of(body));
        return body;
    }
    void run(int count, double h)
    {
        for (int i = 0; i < count; ++i) world_contacts ? advance(h) : step(h);
    }
    void dress(dGeomID geom) const { set_material(geom, friction); }

    bool world_contacts;
    double friction;
};

class ManifoldFriction : public testing::TestWithParam<Way> {};

// 16 boxes are 64 contacts, which QuickStep takes in floats.
TEST_P(ManifoldFriction, brakes_by_mu_g_in_every_direction)
{
    const double h = 0.002, v0 = 3;
    const int steps = 200;
    for (const int boxes : {1, 16})
        for (int k = 0; k < 8; ++k) {
            Faces sim(GetParam());
            const double angle = 0.1 + k * kPi / 4.3;
            const V3 along{std::cos(angle), std::sin(angle), 0}, across{-along.y, along.x, 0};
            sim.floor();
            for (int i = 0; i < boxes; ++i) sim.add({4.0 * i, 0, 0.1}, {1, 1, 0.2}, 5);
            sim.run(100, h);
            for (const dBodyID box : sim.bodies) velocity(box, v0 * along);
            sim.run(steps, h);
            for (const dBodyID box : sim.bodies) {
                const double rate = (v0 - dot(velocity(box), along)) / (steps * h);
                EXPECT_NEAR(rate, kMu * kG, 0.01 * kMu * kG) << boxes << ' ' << k;
                EXPECT_LT(std::abs(dot(velocity(box), across)), 0.01) << boxes << ' ' << k;
            }
        }
}

TEST_P(ManifoldFriction, holds_on_a_slope_that_is_less_than_mu_and_lets_go_on_one_that_is_more)
{
    const double h = 0.01;
    for (const double share : {0.97, 1.1}) {  // of the steepest slope that holds
        Faces sim(GetParam());
        const double angle = std::atan(share * kMu);
        sim.gravity(0, 0, -kG);
        sim.floor();
        const dBodyID box = sim.add({0, 0, 0.2}, {1, 1, 0.4}, 3);
        sim.run(50, h);
        sim.gravity(kG * std::sin(angle), 0, -kG * std::cos(angle));
        const double from = position(box).x, seconds = 2;
        sim.run(int(seconds / h), h);
        const double a = kG * (std::sin(angle) - kMu * std::cos(angle));
        if (share < 1) {
            EXPECT_LT(std::abs(position(box).x - from), 0.01);
        } else {
            EXPECT_NEAR(velocity(box).x, a * seconds, 0.03 * a * seconds);
        }
    }
}

struct Face {
    double mass = 5, side = 1, height = 0.2;
    double inertia() const { return mass * side * side / 6; }
    double radius() const { return side / std::sqrt(2.0); }  // of all corners
    dBodyID add(Faces& sim) const { return sim.add({0, 0, height / 2}, {side, side, height}, mass); }
};

// Four corners with a quarter of the weight each: I w' = -mu m g r.
TEST_P(ManifoldFriction, brings_a_turning_box_to_rest_in_the_time_of_the_mean_radius)
{
    const double h = 0.002, w0 = 6;
    const Face face;
    const double slowing = kMu * face.mass * kG * face.radius() / face.inertia(), rest = w0 / slowing;
    Faces sim(GetParam());
    sim.floor();
    const dBodyID box = face.add(sim);
    sim.run(100, h);
    velocity(box, {}, {0, 0, w0});
    double before = kinetic_energy(box);
    for (int i = 1; i * h < 2 * rest; ++i) {
        sim.run(1, h);
        EXPECT_GT(spin(box).z, -1e-3) << i;  // never back
        const double expected = std::max(w0 - slowing * i * h, 0.0);
        EXPECT_NEAR(spin(box).z, expected, 0.01 * w0 + (i * h > 0.97 * rest && i * h < 1.03 * rest)) << i;
        const double now = kinetic_energy(box);
        EXPECT_LT(now, before + 1e-3) << i;
        before = now;
    }
    EXPECT_LT(std::abs(spin(box).z), 1e-3);
    EXPECT_LT(std::hypot(position(box).x, position(box).y), 1e-3);
}

// m v' = -mu m g v/s, I w' = -mu m g rho (rho w)/s, s = |(v, rho w)|.
TEST_P(ManifoldFriction, shares_itself_between_sliding_and_turning)
{
    const double h = 0.002;
    const int steps = 200, fine = 100;
    const Face face;
    for (const double w0 : {1.0, 4.0, 12.0}) {
        Faces sim(GetParam());
        sim.floor();
        const dBodyID box = face.add(sim);
        sim.run(100, h);
        double v = 2, w = w0, before = 1e9;
        velocity(box, {v, 0, 0}, {0, 0, w});
        for (int i = 0; i < steps; ++i) {
            for (int k = 0; k < fine; ++k) {
                const double s = std::max(std::hypot(v, face.radius() * w), 1e-9);
                v -= h / fine * kMu * kG * v / s;
                w -= h / fine * kMu * face.mass * kG * face.radius() * face.radius() * w / s / face.inertia();
            }
            sim.run(1, h);
            EXPECT_LT(kinetic_energy(box), before + 1e-4);
            before = kinetic_energy(box);
            EXPECT_NEAR(length(velocity(box)), v, 0.03 * 2) << w0 << ' ' << i;
            EXPECT_NEAR(spin(box).z, w, 0.03 * w0) << w0 << ' ' << i;
        }
    }
}

// Friction of what only slides goes through the centre of push, which is below the centre of mass and not in
// the middle of the face.
TEST_P(ManifoldFriction, acts_at_the_centre_of_the_normal_forces)
{
    const double h = 0.002;
    Faces sim(GetParam());
    sim.floor();
    const dBodyID body = sim.add({0, 0, 0.01}, {1, 1, 0.02}, 5);
    dGeomSetOffsetPosition(geom_of(body), 0, real(0.3), 0);
    sim.run(100, h);
    velocity(body, {3, 0, 0});
    sim.run(200, h);
    EXPECT_NEAR(velocity(body).x, 3 - kMu * kG * 0.4, 0.02 * kMu * kG * 0.4);
    EXPECT_LT(std::abs(spin(body).z), 0.05);
}

// As good as with friction at each point; 20 sweeps let a stack creep by a centimetre in three seconds.
TEST_P(ManifoldFriction, keeps_a_stack_and_a_ball_where_they_are)
{
    double moved[2] = {0, 0}, fastest[2] = {0, 0};
    for (const int mode : {0, 1}) {
        Faces sim(GetParam(), mode);
        sim.floor();
        for (int i = 0; i < 6; ++i) sim.add({0.02 * (i % 2), 0, 0.25 + 0.5 * i}, {0.5, 0.5, 0.5}, 2);
        const dBodyID ball = sim.sphere({3, 0, 0.3}, 0.3, 1);
        sim.dress(geom_of(ball));
        sim.run(300, 0.01);
        for (std::size_t i = 0; i < sim.bodies.size(); ++i) {
            fastest[mode] = std::max(fastest[mode], length(velocity(sim.bodies[i])));
            const double from = sim.bodies[i] == ball ? 3 : 0.02 * double(i % 2);
            const V3 at = position(sim.bodies[i]);
            moved[mode] = std::max(moved[mode], std::hypot(at.x - from, at.y));
        }
    }
    EXPECT_LT(moved[1], std::max(0.015, 1.2 * moved[0]));
    EXPECT_LT(fastest[1], std::max(0.01, fastest[0]));
}

TEST_P(ManifoldFriction, keeps_the_momentum_of_free_bodies)
{
    Faces sim(GetParam());
    sim.gravity(0, 0, 0);
    const dBodyID low = sim.add({0, 0, 0}, {1, 1, 1}, 3), high = sim.add({0.1, 0.05, 1.02}, {1.2, 0.9, 1}, 2);
    velocity(low, {0.3, 0.1, 1}, {0, 0, 0.5}), velocity(high, {-0.5, 0.4, -1.5}, {0, 0, -1});
    const V3 p = momentum(sim), l = angular_momentum(sim);
    sim.run(60, 0.002);
    EXPECT_LT(length(momentum(sim) - p), tol(1e-5, 1e-4));
    EXPECT_LT(length(angular_momentum(sim) - l), 0.02 * length(l));
    EXPECT_GT(length(velocity(low) - V3{0.3, 0.1, 1}), 0.3);  // they met, and rubbed
    EXPECT_GT(std::abs(velocity(low).x - 0.3), 0.05);
    EXPECT_LT(std::abs(spin(low).z - spin(high).z), 1.4);
}

TEST_P(ManifoldFriction, moves_with_a_belt)
{
    const double h = 0.01;
    Faces sim(GetParam());
    const dGeomID belt = sim.ground();
    set_material(belt, kMu, 0, {1, 0.5, 0});
    sim.surface.mode |= dContactMotion1 | dContactMotion2 | dContactFDir1;
    const dBodyID box = sim.add({0, 0, 0.2}, {1, 1, 0.4}, 3);
    if (!sim.world_contacts) {
        dJointGroupEmpty(sim.contacts);
        sim.surface.motion1 = real(1), sim.surface.motion2 = real(0.5);
        sim.surface.mode &= ~dContactFDir1;
    }
    sim.run(200, h);
    const V3 v = velocity(box);
    EXPECT_NEAR(std::hypot(v.x, v.y), std::hypot(1, 0.5), 0.02);
    EXPECT_LT(std::abs(spin(box).z), 0.01);
}

std::string way_name(const testing::TestParamInfo<Way>& info) { return info.param.name; }
INSTANTIATE_TEST_SUITE_P(Sweeping, ManifoldFriction, testing::ValuesIn(kWays), way_name);

// A box on four contact joints, each with a feedback.
struct Reader {
    Faces sim;
    dBodyID box;
    dJointFeedback feedback[4]{};

    Reader(const Way& way, int mode) : sim(way, mode), box(sim.body({0, 0, 0.1}, 5, 0.8)) {}

    void step(double h, const std::function<void(dContact&)>& change = {})
    {
        dJointGroupEmpty(sim.contacts);
        for (int k = 0; k < 4; ++k) {
            const V3 at = position(box) + V3{k % 2 ? 0.5 : -0.4, k / 2 ? 0.3 : -0.5, -0.1};
            dContact c = make_contact(at, {0, 0, 1}, 0);
            c.surface.mu = real(kMu);
            if (change) change(c);
            const dJointID joint = dJointCreateContact(sim.world, sim.contacts, &c);
            dJointAttach(joint, box, nullptr);
            dJointSetFeedback(joint, &feedback[k]);
        }
        sim.advance(h);
    }
};

// What is reported at the points adds up to what moves the body, couple included; each has its share of the normal force.
TEST(ManifoldFeedback, adds_up_to_the_force_and_the_couple_that_act)
{
    for (const Stepper stepper : {Stepper::kQuick, Stepper::kFast}) {
        const double h = 0.005, inertia = 0.8;
        Reader rig({"", stepper, false}, 1);
        velocity(rig.box, {1, 0.5, 0}, {0, 0, 3});
        for (int i = 0; i < 30; ++i) {
            const V3 v = velocity(rig.box), w = spin(rig.box);
            rig.step(h);
            V3 force, torque;
            for (const dJointFeedback& f : rig.feedback) {
                force = force + vec(f.f1), torque = torque + vec(f.t1);
                const double n = double(f.f1[2]);
                if (n < 1e-3) { EXPECT_LT(std::hypot(double(f.f1[0]), double(f.f1[1])), 1e-3); }
            }
            const V3 expected = (5 / h) * (velocity(rig.box) - v) + V3{0, 0, 5 * kG};
            EXPECT_LT(length(force - expected), tol(0.02, 0.05)) << name_of(stepper) << ' ' << i;
            EXPECT_LT(std::abs(torque.z - inertia / h * (spin(rig.box).z - w.z)), tol(0.02, 0.05))
                << name_of(stepper) << ' ' << i;
        }
        EXPECT_LT(length(velocity(rig.box)), 1);
    }
}

TEST(ManifoldFeedback, of_contacts_that_the_world_manages_adds_up_too)
{
    const double h = 1.0 / 60;
    Faces sim(kWays[3]);
    sim.floor();
    const Face face;
    const dBodyID box = face.add(sim);
    sim.run(30, h);
    velocity(box, {3, 1, 0}, {0, 0, 5});
    for (int i = 0; i < 10; ++i) {
        const V3 v = velocity(box), w = spin(box), at = position(box);
        sim.run(1, h);
        std::vector<dWorldContact> all(std::size_t(dWorldGetContacts(sim.world, nullptr, 0)));
        dWorldGetContacts(sim.world, all.data(), int(all.size()));
        V3 force;
        double couple = 0;
        for (const dWorldContact& c : all) {
            const double sign = dGeomGetBody(c.g1) == box ? 1 : -1;
            const V3 f = sign * vec(c.friction_force);
            force = force + f;
            couple += cross(vec(c.pos) - 0.5 * (at + position(box)), f).z;
        }
        const V3 expected = (face.mass / h) * (velocity(box) - v);
        EXPECT_LT(std::hypot(force.x - expected.x, force.y - expected.y), 0.05) << i;
        EXPECT_NEAR(couple, face.inertia() / h * (spin(box).z - w.z), 0.3) << i;
    }
}

// With these, contacts have their friction point by point, on or off.
TEST(ManifoldFallback, keeps_the_bits_of_what_no_disc_can_be)
{
    const std::function<void(dContact&)> changes[] = {
        [](dContact& c) { c.surface.mode |= dContactMu2, c.surface.mu2 = real(2 * kMu); },
        [](dContact& c) { c.surface.mu = dInfinity; },
        [](dContact& c) { c.surface.mode |= dContactRolling, c.surface.rho = real(0.01); },
        [](dContact& c) {
            c.surface.mode |= dContactAxisDep | dContactMu2 | dContactSlip1, c.surface.mu2 = real(kMu),
                                                                             c.surface.slip1 = real(0.01);
        },
    };
    for (const Stepper stepper : {Stepper::kQuick, Stepper::kFast})
        for (std::size_t k = 0; k < std::size(changes); ++k) {
            std::uint64_t hash[3];
            for (const int mode : {0, 1}) {
                Reader rig({"", stepper, false}, mode);
                velocity(rig.box, {1, 0.5, 0}, {0, 0, 3});
                for (int i = 0; i < 20; ++i) rig.step(0.005, changes[k]);
                hash[mode] = hash_state(rig.sim);
            }
            EXPECT_EQ(hash[0], hash[1]) << name_of(stepper) << ' ' << k;
        }
}

TEST(ManifoldFrictionOfTheExactStepper, is_that_of_each_point)
{
    for (const bool world_contacts : {false, true}) {
        std::uint64_t hash[2];
        for (const int mode : {0, 1}) {
            Faces sim({"", Stepper::kExact, world_contacts}, mode);
            sim.floor();
            velocity(Face().add(sim), {1, 2, 0}, {0, 0, 2});
            sim.run(40, 0.01);
            hash[mode] = hash_state(sim);
        }
        EXPECT_EQ(hash[0], hash[1]);
    }
}

// What is reported is measured against what is solved: swept for long, nothing is left.
TEST(ManifoldReport, is_zero_after_many_sweeps)
{
    for (const bool world_contacts : {false, true}) {
        Faces sim({"", Stepper::kQuick, world_contacts});
        sim.gravity(1, 2, -kG);
        dWorldSetQuickStepNumIterations(sim.world, 2000);
        dWorldSetStepReportMode(sim.world, 1);
        sim.floor();
        velocity(Face().add(sim), {1, 2, 0}, {0, 0, 3});
        sim.run(10, 0.01);
        EXPECT_LT(sim.report().residual, tol(1e-6, 1e-3)) << world_contacts;
        EXPECT_GT(length(velocity(sim.bodies[0])), 1) << world_contacts;  // it slides
    }
}

TEST(ManifoldFrictionSetter, is_off_by_default_and_refuses_other_modes)
{
    Sim sim;
    Messages messages;
    EXPECT_EQ(dWorldGetManifoldFriction(sim.world), 0);
    dWorldSetManifoldFriction(sim.world, 1);
    dWorldSetManifoldFriction(sim.world, 2);
    dWorldSetManifoldFriction(sim.world, -1);
    EXPECT_EQ(dWorldGetManifoldFriction(sim.world), 1);
    EXPECT_EQ(messages.count(), 2);
}

std::uint64_t pile(const Way& way, int threads, int mode)
{
    Faces sim(way, mode, 0.5);
    dWorldSetStepThreads(sim.world, threads);
    sim.floor();
    Random random(7);
    for (int i = 0; i < 120; ++i) {
        const V3 at{random.uniform(-2, 2), random.uniform(-2, 2), 0.4 + 0.06 * i};
        const V3 size{random.uniform(0.2, 0.6), random.uniform(0.2, 0.6), random.uniform(0.2, 0.6)};
        const dBodyID body = i % 4 ? sim.add(at, size, 1) : sim.sphere(at, size.x / 2, 1);
        if (i % 4 == 0) sim.dress(geom_of(body));
    }
    for (int i = 0; i < 5; ++i) sim.add({10, 0, 0.25 + 0.5 * i}, {0.5, 0.5, 0.5}, 1);
    sim.run(60, 1.0 / 60);
    EXPECT_TRUE(finite_state(sim));
    return hash_state(sim);
}

TEST(ManifoldBits, are_the_same_on_any_number_of_threads)
{
    for (int k = 0; k < 4; ++k) {
        const std::uint64_t alone = pile(kWays[k], 1, 1);
        EXPECT_NE(alone, pile(kWays[k], 1, 0)) << kWays[k].name;
        for (const int threads : {2, 3}) EXPECT_EQ(pile(kWays[k], threads, 1), alone) << kWays[k].name;
        if (kSingle) continue;
        EXPECT_TRUE(golden::is_golden(std::string("physics/manifold_friction/") + kWays[k].name, alone));
    }
}

}  // namespace
}  // namespace epode::physics
