// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Manifolds in lanes: the kernels of every machine leave the same bits, an island has the same answer alone
// and packed with others, and what a sweep leaves is what Signorini and Coulomb ask for.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include "../tasks/taken_pool.h"
#include "solve/substeps/manifold_set.h"
#include "systems.h"

namespace {

using namespace epode_test;

struct Contacts {
    std::vector<SolverBody> bodies;
    std::vector<ContactManifold> manifolds;
};

Float3 float3(Vec3 a) { return narrow(a); }

// Bodies and manifolds between them: chains and stars, points in any number, some against the world or a
// kinematic body; one platform with more neighbours than there are colours in a mask.
Contacts random_contacts(std::uint64_t seed, int bodies, int manifolds, bool platform = false)
{
    Dice dice(seed);
    Contacts c;
    const auto vector = [&](Real size) {
        return Vec3{dice.real(-size, size), dice.real(-size, size), dice.real(-size, size)};
    };
    for (int i = 0; i < bodies; ++i) {
        SolverBody b;
        b.v = vector(1), b.w = vector(1);
        if (i % 9 != 8) {
            b.inv_mass = dice.real(Real(0.2), 2);
            b.inv_inertia = {dice.real(1, 9), dice.real(1, 9), dice.real(1, 9), 0, 0, 0};
        }
        c.bodies.push_back(b);
    }
    for (int i = 0; i < manifolds; ++i) {
        ContactManifold p{};
        p.max_impulse = std::numeric_limits<float>::infinity();
        p.body1 = platform ? 0 : int(dice.real(0, Real(bodies - 1)));
        p.body2 = platform ? 1 + i % (bodies - 1) : int(dice.real(-1, Real(bodies)));
        if (p.body2 == p.body1) p.body2 = -1;
        p.count = 1 + int(dice.real(0, Real(3.99)));
        Vec3 n = vector(1);
        normalize(n);
        p.normal = float3(n);
        p.mu = float(dice.real(0, 1));
        p.restitution = i % 5 ? 0 : 0.5f;
        for (int k = 0; k < p.count; ++k) {
            ManifoldPoint& point = p.points[k];
            point.r1 = float3(vector(Real(0.5))), point.r2 = float3(vector(Real(0.5)));
            point.separation = float(dice.real(Real(-0.01), Real(0.005)));
            point.normal_impulse = float(dice.real(0, 1));
            const Vec3 f = vector(Real(0.3));
            point.friction_impulse = float3(f - dot(f, n) * n);
        }
        c.manifolds.push_back(p);
    }
    return c;
}

struct Answer {
    std::vector<Velocity> velocities;
    std::vector<ContactManifold> manifolds;
};

// The contacts as a solver gets them; they must stay where they are.
struct Island {
    RowSystem system;
    std::vector<ContactManifold*> pointers;

    explicit Island(Contacts& c, bool whole, Real h = Real(0.01))
    {
        system.manifold_friction = whole;
        for (ContactManifold& p : c.manifolds) pointers.push_back(&p);
        system.h = h;
        system.bodies = c.bodies;
        system.contact_manifolds = pointers;
    }
};

// `whole`: one friction per manifold.
Answer solve(const ManifoldKernels& kernels, Contacts c, int steps, bool whole)
{
    Arena arena;
    const Island island(c, whole);
    const RowSystem& system = island.system;
    ManifoldSet set(kernels);
    EXPECT_TRUE(set.prepare(system, {system.h / Real(steps), steps}, Tasks(1), arena));
    Answer out;
    out.velocities.resize(c.bodies.size() + 1);
    load_velocities(system, out.velocities);
    for (int i = 0; i < steps; ++i) {
        set.apply_impulses(out.velocities);
        set.correct(out.velocities);
        set.follow_motion(out.velocities);
        set.relax(out.velocities);
    }
    set.store_impulses(island.pointers);
    out.manifolds = c.manifolds;
    return out;
}

void expect_same(const Answer& a, const Answer& b, std::size_t body0 = 0, std::size_t manifold0 = 0)
{
    for (std::size_t i = 0; i + 1 < a.velocities.size(); ++i)
        EXPECT_EQ(std::memcmp(&a.velocities[i], &b.velocities[body0 + i], sizeof(Velocity)), 0)
            << "body " << i;
    for (std::size_t i = 0; i < a.manifolds.size(); ++i)
        EXPECT_EQ(std::memcmp(a.manifolds[i].points, b.manifolds[manifold0 + i].points,
                              sizeof a.manifolds[i].points),
                  0)
            << "manifold " << i;
}

TEST(ManifoldKernels, of_all_machines_make_the_same_bits)
{
    const auto all = manifold_kernels();
    ASSERT_STREQ(all[0]->name, "baseline");
    if (all.size() == 1) GTEST_SKIP() << "this machine runs the baseline only";
    for (std::uint64_t seed = 1; seed <= 16; ++seed) {
        const bool whole = seed > 8, many = seed % 2 == 0;  // batches of eight alone, and of sixteen, too
        const Contacts c = random_contacts(seed, many ? 300 : 40, many ? 900 : 90, seed % 8 == 0);
        const Answer expected = solve(*all[0], c, 4, whole);
        for (const ManifoldKernels* other : all.subspan(1)) {
            SCOPED_TRACE(other->name);
            expect_same(expected, solve(*other, c, 4, whole));
        }
    }
}

// Substeps of random contacts.
Answer run_substeps(std::uint64_t seed, int workers)
{
    const std::vector<Velocity> force_velocity(300, {{0, 0, Real(-0.02)}, 0, {}, 0});
    Contacts c = random_contacts(seed, 300, 900, seed % 4 == 0);
    Arena arena;
    const Island island(c, seed > 4);
    ManifoldSet set;
    EXPECT_TRUE(set.prepare(island.system, {island.system.h / 5, 5}, Tasks(workers), arena));
    Answer answer;
    answer.velocities.resize(301);
    load_velocities(island.system, answer.velocities);
    std::vector<Velocity> mean(300);
    set.run_substeps(5, answer.velocities, force_velocity, mean, {});
    set.store_impulses(island.pointers);
    answer.manifolds = c.manifolds;
    return answer;
}

TEST(ManifoldSet, has_the_same_bits_on_any_number_of_workers)
{
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        const Answer alone = run_substeps(seed, 1);
        for (const int workers : {2, 3, 8}) expect_same(alone, run_substeps(seed, workers));
    }
}

TEST(ManifoldSet, has_the_same_bits_when_its_workers_do_not_come)
{
    const TakenPool taken;
    for (std::uint64_t seed = 1; seed <= 8; ++seed) expect_same(run_substeps(seed, 1), run_substeps(seed, 3));
}

// Three visits to each body instead of nine must not move a bit.
TEST(ManifoldSet, substeps_in_one_run_are_those_of_single_calls)
{
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        Contacts c = random_contacts(seed, 40, seed == 4 ? 0 : 90);
        Arena arena;
        const Island island(c, seed > 4);
        const RowSystem& system = island.system;
        const std::size_t bodies = c.bodies.size();
        const std::vector<Velocity> force_velocity(bodies, {{0, 0, Real(-0.02)}, 0, {Real(0.001), 0, 0}, 0});
        std::vector<Velocity> v[2], mean[2];
        for (const bool whole : {false, true}) {
            ManifoldSet set;
            ASSERT_TRUE(set.prepare(system, {system.h / 4, 4}, Tasks(1), arena));
            v[whole].resize(bodies + 1), mean[whole].resize(bodies);
            load_velocities(system, v[whole]);
            if (whole) set.run_substeps(4, v[whole], force_velocity, mean[whole], {});
            for (int i = 0; !whole && i < 4; ++i) {
                add(v[whole], force_velocity);
                set.apply_impulses(v[whole]);
                set.correct(v[whole]);
                add(mean[whole], std::span(std::as_const(v[whole])).first(bodies));
                set.follow_motion(v[whole]);
                set.relax(v[whole]);
            }
        }
        EXPECT_EQ(std::memcmp(v[0].data(), v[1].data(), bodies * sizeof(Velocity)), 0);
        EXPECT_EQ(std::memcmp(mean[0].data(), mean[1].data(), bodies * sizeof(Velocity)), 0);
        EXPECT_NE(std::memcmp(v[0].data(), mean[0].data(), bodies * sizeof(Velocity)), 0);
    }
}

TEST(ManifoldSet, an_island_has_the_same_answer_alone_and_packed)
{
    Contacts together;
    std::vector<Contacts> islands;
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        Contacts c = random_contacts(seed, 3 + int(seed % 13), 2 + int(seed % 13));
        islands.push_back(c);
        const int base = int(together.bodies.size());
        together.bodies.insert(together.bodies.end(), c.bodies.begin(), c.bodies.end());
        for (ContactManifold p : c.manifolds) {
            p.body1 += base;
            if (p.body2 >= 0) p.body2 += base;
            together.manifolds.push_back(p);
        }
    }
    const ManifoldKernels& kernels = *manifold_kernels().back();
    for (const bool whole : {false, true}) {
        const Answer packed = solve(kernels, together, 3, whole);
        std::size_t body = 0, manifold = 0;
        for (const Contacts& c : islands) {
            expect_same(solve(kernels, c, 3, whole), packed, body, manifold);
            body += c.bodies.size(), manifold += c.manifolds.size();
        }
    }
}

Vec3 slip(const Answer& a, const ContactManifold& p, const ManifoldPoint& point)
{
    const Velocity &b1 = a.velocities[std::size_t(p.body1)], none{},
                   &b2 = p.body2 < 0 ? none : a.velocities[std::size_t(p.body2)];
    return b1.v + cross(b1.w, widen(point.r1)) - b2.v - cross(b2.w, widen(point.r2));
}

// The friction of a manifold as one: its force and its couple about the centre of pressure, bounds and
// velocities there, by the formulas of manifold_friction.inc in Reals.
struct ManifoldFrictionReference {
    Real normal = 0, radius = 0, couple = 0, turn;
    Vec3 centre, force, along;

    ManifoldFrictionReference(const Answer& a, const ContactManifold& p, const ContactManifold& was)
    {
        const Vec3 n = widen(p.normal);
        Vec3 arm2;
        const auto pushed = [&](int k) {
            return Real(p.points[k].normal_impulse) - Real(was.points[k].normal_impulse);
        };
        for (int k = 0; k < p.count; ++k) normal += pushed(k);
        for (int k = 0; k < p.count && normal > 0; ++k)
            centre += pushed(k) / normal * widen(p.points[k].r1),
                arm2 += pushed(k) / normal * widen(p.points[k].r2);
        for (int k = 0; k < p.count && normal > 0; ++k) {
            const Vec3 f = widen(p.points[k].friction_impulse) - widen(was.points[k].friction_impulse);
            const Vec3 d = widen(p.points[k].r1) - centre;
            force += f, couple += dot(n, cross(d, f));
            radius += pushed(k) / normal * length(d - dot(n, d) * n);
        }
        ManifoldPoint point{};
        point.r1 = narrow(centre), point.r2 = narrow(arm2);
        const Vec3 u = slip(a, p, point);
        along = u - dot(n, u) * n;
        const Velocity none{};
        turn = dot(n, a.velocities[std::size_t(p.body1)].w -
                          (p.body2 < 0 ? none : a.velocities[std::size_t(p.body2)]).w);
    }
};

TEST(ManifoldSet, whole_manifolds_leave_what_the_ellipsoid_asks_for)
{
    Contacts c = random_contacts(3, 24, 20);
    for (ContactManifold& p : c.manifolds) {
        p.restitution = 0, p.mu = 0.4f;
        const Vec3 n = widen(p.normal);
        for (ManifoldPoint& point : p.points) {
            const Vec3 r = widen(point.r1);  // in one plane
            point.normal_impulse = 0, point.separation = 0, point.friction_impulse = {};
            point.r1 = point.r2 = float3(r - (dot(n, r) - Real(0.1)) * n);
        }
    }
    Arena arena;
    const Island island(c, true, Real(1e-6));  // nothing moves
    ManifoldSet set;
    ASSERT_TRUE(set.prepare(island.system, {island.system.h, 1}, Tasks(1), arena));
    Answer a;
    a.velocities.resize(c.bodies.size() + 1);
    load_velocities(island.system, a.velocities);
    set.correct(a.velocities);  // finds out who touches
    for (int i = 0; i < 4000; ++i) set.relax(a.velocities);
    set.store_impulses(island.pointers);
    const std::vector<ContactManifold> before = c.manifolds;
    set.relax(a.velocities);
    set.store_impulses(island.pointers);
    int sliding = 0, sticking = 0;
    for (std::size_t i = 0; i < before.size(); ++i) {
        const ContactManifold& p = c.manifolds[i];
        if (c.bodies[std::size_t(p.body1)].inv_mass +
                (p.body2 < 0 ? 0 : c.bodies[std::size_t(p.body2)].inv_mass) ==
            0)
            continue;
        const ManifoldFrictionReference w(a, p, before[i]);
        if (w.normal < 0.05) continue;
        // In the coordinates in which the ellipsoid is a ball.
        const Real rest = w.radius > 0.01 ? w.couple / w.radius : 0;
        const Real limit = Real(0.4) * w.normal, size = std::sqrt(length2(w.force) + rest * rest);
        const Real speed = std::sqrt(length2(w.along) + w.radius * w.radius * w.turn * w.turn);
        EXPECT_LT(size, limit + 2e-2) << i;  // sums of thousands of floats, one less the other
        if (speed < 1e-2) {
            ++sticking;
            continue;
        }
        ++sliding;
        EXPECT_NEAR(size, limit, 2e-2) << i;
        const Real against = dot(w.force, w.along) + rest * w.radius * w.turn;
        EXPECT_LT(against, -0.99 * size * speed + 2e-2 * speed) << i;
    }
    EXPECT_GT(sliding, 3);
    EXPECT_GT(sticking, 0);
}

// Contacts that touch, without restitution, swept until nothing changes: u_n >= 0, p >= 0, u_n p = 0, and friction on the
// disc against the slip, or less and no slip. Stored is the sum over all sweeps; the last one is the
// difference.
TEST(ManifoldSet, leaves_what_signorini_and_coulomb_ask_for)
{
    Contacts c = random_contacts(3, 24, 20);
    for (ContactManifold& p : c.manifolds) {
        p.restitution = 0, p.mu = 0.4f;
        for (ManifoldPoint& point : p.points)
            point.separation = -1e-3f, point.normal_impulse = 0, point.friction_impulse = {};
    }
    Arena arena;
    const Island island(c, false, Real(1e-6));  // nothing moves
    const RowSystem& system = island.system;
    ManifoldSet set;
    ASSERT_TRUE(set.prepare(system, {system.h, 1}, Tasks(1), arena));
    Answer a;
    a.velocities.resize(c.bodies.size() + 1);
    load_velocities(system, a.velocities);
    for (int i = 0; i < 2000; ++i) set.relax(a.velocities);
    set.store_impulses(island.pointers);
    const std::vector<ContactManifold> before = c.manifolds;
    set.relax(a.velocities);
    set.store_impulses(island.pointers);
    for (std::size_t i = 0; i < before.size(); ++i)
        for (int k = 0; k < before[i].count; ++k) {
            ManifoldPoint& point = c.manifolds[i].points[k];
            const ManifoldPoint& was = before[i].points[k];
            point.normal_impulse -= was.normal_impulse;
            point.friction_impulse = float3(widen(point.friction_impulse) - widen(was.friction_impulse));
        }
    int pushing = 0, sliding = 0;
    for (const ContactManifold& p : c.manifolds)
        for (int k = 0; k < p.count; ++k) {
            const ManifoldPoint& point = p.points[k];
            const Vec3 n = widen(p.normal), u = slip(a, p, point), friction = widen(point.friction_impulse);
            const Vec3 along = u - dot(n, u) * n;
            const Real moves = c.bodies[std::size_t(p.body1)].inv_mass +
                               (p.body2 < 0 ? 0 : c.bodies[std::size_t(p.body2)].inv_mass);
            if (moves == 0) continue;
            EXPECT_GT(dot(n, u), -1e-3);
            EXPECT_GE(point.normal_impulse, -1e-3);
            if (point.normal_impulse > 1e-2) {
                ++pushing;
                EXPECT_LT(dot(n, u), 1e-3);
            }
            EXPECT_LE(length(friction), 0.4 * point.normal_impulse + 1e-3);
            if (length(along) > 1e-2 && point.normal_impulse > 1e-2) {
                ++sliding;
                EXPECT_NEAR(length(friction), 0.4 * point.normal_impulse, 1e-3);
                EXPECT_LT(length(friction + (length(friction) / length(along)) * along),
                          1e-2 * point.normal_impulse + 1e-3);
            }
        }
    EXPECT_GT(pushing, 5);
    EXPECT_GT(sliding, 3);
}

}  // namespace
