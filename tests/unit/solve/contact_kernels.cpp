// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The kernels of every machine must leave the same bits: whoever steps a world on another processor gets the
// same world. Each is run by name here, whatever the library would choose.
#include <gtest/gtest.h>

#include <cstring>
#include <vector>

#include "solve/common/contact_rows.h"
#include "solve/common/residual.h"
#include "solve/sweeps/contact_set.h"
#include "systems.h"

namespace {

using namespace epode_test;

// In the box or the ellipse of its limits at every point, or one of a whole manifold.
enum class Friction { kBox, kCone, kManifold };

struct Outcome {
    std::vector<Velocity> velocities;
    std::vector<RowNumbers> numbers;
    std::vector<Lanes> approach;  // J_n v of every point
};

// The contacts of a problem in lanes of one kind.
template <typename L>
struct Packed {
    Packed(const ContactKernels& kernels, Problem& problem, Friction friction)
        : system(problem.system()), set(kernels), velocities(system.bodies.size() + 1)
    {
        for (RowBlock& block : system.blocks) block.cone = friction == Friction::kCone;
        system.manifold_friction = friction == Friction::kManifold;
        const auto taken = arena.take<bool>(int(system.blocks.size()));
        EXPECT_TRUE(rows.gather(system, taken, arena));
        EXPECT_TRUE(set.pack(system, rows.list(), Real(1.3), arena));
        for (const bool t : taken) EXPECT_TRUE(t);
        load_velocities(system, velocities);
    }

    void run(std::span<typename VelocityOf<L>::Type> bodies, int sweeps)
    {
        CounterRandom random(3);
        set.apply_impulses(bodies);
        for (int i = 0; i < sweeps; ++i) {
            set.shuffle(random);
            set.sweep(bodies);
        }
        set.store_impulses(rows.list().points);
    }

    Arena arena;
    RowSystem system;
    ContactRows rows;
    ContactSetOf<L> set;
    std::vector<Velocity> velocities;
};

Outcome outcome_of(const ContactKernels& kernels, Problem problem, int sweeps, Friction friction)
{
    Packed<Lanes> packed(kernels, problem, friction);
    packed.run(packed.velocities, sweeps);
    packed.rows.for_each_impulse([&](int row, Real p) { problem.numbers[std::size_t(row)].p = p; });
    Outcome out{packed.velocities, problem.numbers, {}};
    for (const ContactBatch& batch : packed.set.batches()) {
        Lanes v[kManifoldPoints];
        packed.set.normal_velocities(batch, out.velocities, v);
        out.approach.insert(out.approach.end(), v, v + batch.count);
    }
    return out;
}

// The impulses that float sweeps find, and the velocities that they leave.
struct FloatOutcome {
    std::vector<Velocity> velocities;
    std::vector<JointManifoldPoint> points;
};

FloatOutcome outcome_in_floats(const ContactKernels& kernels, Problem problem, int sweeps, Friction friction)
{
    Packed<BroadLanes> packed(kernels, problem, friction);
    const int slots = int(packed.velocities.size());
    std::vector<FloatVelocity> floats(packed.velocities.size());
    kernels.round_velocities(packed.velocities.data(), slots, floats.data());
    packed.run(floats, sweeps);
    kernels.add_changes(floats.data(), slots, packed.velocities.data());
    const auto points = packed.rows.list().points;
    return {packed.velocities, {points.begin(), points.end()}};
}

Problem warm_problem(std::uint64_t seed)
{
    RandomKind kind;
    kind.bodies = 40, kind.joints = 0, kind.contacts = 90, kind.heaviest = 5, kind.kinematic = true;
    Problem p = random_problem(seed, kind);
    Dice dice(seed + 1000);
    for (RowNumbers& n : p.numbers) n.p = dice.real(-1, 1);  // some beyond their limits
    return p;
}

template <typename T>
void expect_same_bits(const std::vector<T>& a, const std::vector<T>& b)
{
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i)
        EXPECT_EQ(std::memcmp(&a[i], &b[i], sizeof(T)), 0) << "at " << i;
}

std::vector<Problem> all_problems()
{
    std::vector<Problem> problems{box_grid(3, 3, 4, Real(0.5), true), box_grid(3, 2, 2, -1, false),
                                  pyramid(6, Real(0.4))};
    for (std::uint64_t seed = 1; seed <= 5; ++seed) problems.push_back(warm_problem(seed));
    return problems;
}

// With each kind of friction.
template <typename F>
void for_all_problems(F&& f)
{
    for (const Friction friction : {Friction::kBox, Friction::kCone, Friction::kManifold})
        for (const Problem& problem : all_problems()) f(problem, friction);
}

// Impulses and velocities after sweeps over batches of the forms that were found, or of any form. Counts the
// batches of each.
template <typename L>
std::vector<Real> numbers_after_sweeps(Problem problem, Friction friction, bool as_found, int (&forms)[3])
{
    Packed<L> packed(*contact_kernels().back(), problem, friction);
    for (auto& batch : packed.set.batches()) {
        ++forms[int(batch.form)];
        if (!as_found) batch.form = BatchForm::kAny;
    }
    std::vector<typename VelocityOf<L>::Type> bodies(packed.velocities.size());
    packed.run(bodies, 20);
    std::vector<Real> out;
    for (const JointManifoldPoint& point : packed.rows.list().points)
        out.insert(out.end(), point.p, point.p + 3);
    for (auto& body : bodies) {
        const auto* from = reinterpret_cast<const typename L::Number*>(&body);
        out.insert(out.end(), from, from + kTwistNumbers);
    }
    return out;
}

// Equal, not bit by bit: zeros may differ in their sign.
TEST(ContactKernels, what_forms_leave_out_would_have_been_zero)
{
    int forms[3] = {}, ignored[3] = {};
    std::vector<Problem> problems = all_problems();
    Problem slabs = pyramid(6, Real(0.4));
    for (SolverBody& body : slabs.bodies) body.inv_inertia.xx *= 2, body.inv_inertia.xy = body.inv_mass / 8;
    problems.push_back(slabs);
    for (const Problem& problem : problems)
        for (const Friction friction : {Friction::kBox, Friction::kCone}) {
            EXPECT_EQ(numbers_after_sweeps<Lanes>(problem, friction, true, forms),
                      numbers_after_sweeps<Lanes>(problem, friction, false, ignored));
            EXPECT_EQ(numbers_after_sweeps<BroadLanes>(problem, friction, true, forms),
                      numbers_after_sweeps<BroadLanes>(problem, friction, false, ignored));
        }
    EXPECT_GT(forms[int(BatchForm::kPlain)], 0);
    EXPECT_GT(forms[int(BatchForm::kEven)], 0);
}

TEST(ContactKernels, all_machines_make_the_same_bits)
{
    const auto all = contact_kernels();
    ASSERT_STREQ(all[0]->name, "baseline");
    if (all.size() == 1) GTEST_SKIP() << "this machine runs the baseline only";
    for_all_problems([&](const Problem& problem, Friction friction) {
        const Outcome expected = outcome_of(*all[0], problem, 12, friction);
        for (const ContactKernels* other : all.subspan(1)) {
            SCOPED_TRACE(other->name);
            const Outcome got = outcome_of(*other, problem, 12, friction);
            expect_same_bits(expected.velocities, got.velocities);
            expect_same_bits(expected.approach, got.approach);
            ASSERT_EQ(expected.numbers.size(), got.numbers.size());
            for (std::size_t i = 0; i < got.numbers.size(); ++i)
                EXPECT_EQ(std::memcmp(&expected.numbers[i].p, &got.numbers[i].p, sizeof(Real)), 0) << i;
        }
    });
}

TEST(ContactKernels, all_machines_make_the_same_bits_in_floats)
{
    const auto all = contact_kernels();
    if (all.size() == 1) GTEST_SKIP() << "this machine runs the baseline only";
    for_all_problems([&](const Problem& problem, Friction friction) {
        const FloatOutcome expected = outcome_in_floats(*all[0], problem, 12, friction);
        for (const ContactKernels* other : all.subspan(1)) {
            SCOPED_TRACE(other->name);
            const FloatOutcome got = outcome_in_floats(*other, problem, 12, friction);
            expect_same_bits(expected.velocities, got.velocities);
            expect_same_bits(expected.points, got.points);
        }
    });
}

// Friction lies in the ellipse of its limits, on its rim where it slides.
TEST(ContactKernels, cones_bound_friction_in_the_plane)
{
    for (const ContactKernels* kernels : contact_kernels()) {
        int on_the_rim = 0;
        for (const Problem& problem : all_problems()) {
            const Outcome out = outcome_of(*kernels, problem, 5, Friction::kCone);
            for (const RowBlock& block : problem.blocks) {
                if (block.count < 3) continue;
                const RowNumbers* n = &out.numbers[std::size_t(block.first)];
                Real share2 = 0;
                for (int k = 1; k < 3; ++k) {
                    const Real limit = n[k].parent >= 0 ? n[k].hi * n[0].p : n[k].hi;
                    EXPECT_TRUE(limit > 0 || std::abs(n[k].p) < Real(1e-28));  // what kLeastLimit leaves
                    if (limit > 0) share2 += n[k].p * n[k].p / (limit * limit);
                }
                EXPECT_LT(share2, 1 + 1e-5) << kernels->name;
                on_the_rim += share2 > Real(0.999);
            }
        }
        EXPECT_GT(on_the_rim, 20);
    }
}

// Swept for long, lanes settle on the answer of the scalar formulas by which residuals are made.
TEST(ContactKernels, manifold_friction_settles_on_its_ball)
{
    Problem falling = box_grid(2, 1, 2, Real(0.3), false), sliding = falling;
    for (SolverBody& body : sliding.bodies) body.v.x += 1, body.w.z += 2;
    for (const ContactKernels* kernels : contact_kernels())
        for (Problem& problem :
             std::vector<Problem>{falling, sliding, pyramid(3, Real(0.2)), warm_problem(2)}) {
            SCOPED_TRACE(kernels->name);
            Packed<Lanes> packed(*kernels, problem, Friction::kManifold);
            packed.run(packed.velocities, 4000);
            packed.rows.for_each_impulse([&](int row, Real p) { problem.numbers[std::size_t(row)].p = p; });
            RowSystem& system = packed.system;
            const auto frictions = packed.set.manifold_frictions(packed.arena);
            ASSERT_FALSE(frictions.empty());
            system.frictions = frictions;
            std::vector<Real> lo(problem.numbers.size()), hi(lo);
            present_bounds(system, lo, hi);
            const auto residual = [&] {
                return natural_residual(system, system.bodies, lo, hi, packed.arena);
            };
            const Real settled = residual();
            EXPECT_LT(settled, kSingle ? 1e-4 : 1e-5);  // pyramids settle slowly
            for (ManifoldFriction& f : frictions) {
                EXPECT_LE(f.p[0] * f.p[0] + f.p[1] * f.p[1] + f.p[2] * f.p[2],
                          f.limit * f.limit * Real(1.001) + Real(1e-6));
                f.p[0] += Real(0.01), f.p[2] += Real(0.01);
            }
            EXPECT_GT(residual(), 10 * settled);
        }
}

// What the points report adds up to the force and the couple of the whole.
TEST(ContactKernels, parts_of_a_manifold_friction_add_up)
{
    for (const ContactKernels* kernels : contact_kernels()) {
        int compared = 0;
        Problem problem = box_grid(3, 2, 3, Real(0.3), true);
        Dice dice(4);
        for (SolverBody& body : problem.bodies) body.v = dice.vec(1), body.w = dice.vec(1);
        Packed<Lanes> packed(*kernels, problem, Friction::kManifold);
        packed.run(packed.velocities, 6);
        const auto frictions = packed.set.manifold_frictions(packed.arena);
        const JointManifoldList& list = packed.rows.list();
        ASSERT_EQ(frictions.size(), list.manifolds.size());
        for (std::size_t i = 0; i < frictions.size(); ++i) {
            const JointManifold& m = list.manifolds[i];
            const ManifoldFriction& f = frictions[i];
            if (f.limit == 0) continue;  // lost its pushes in the last sweep: nobody to tell
            Vec3 force, torque, expected_force, expected_torque;
            for (int k = m.first; k < m.first + m.count; ++k) {
                const JointManifoldPoint& point = list.points[std::size_t(k)];
                const Vec3 here = point.p[1] * m.t1 + point.p[2] * m.t2;
                force += here, torque += cross(point.r1, here);
                EXPECT_TRUE(point.p[0] > 0 || here == Vec3{});
            }
            for (int k = 0; k < 3; ++k)
                expected_force += f.p[k] * f.rows[k].lin1, expected_torque += f.p[k] * f.rows[k].ang1;
            const Real scale = f.limit + Real(1e-3);
            EXPECT_LT(length(force - expected_force), scale * (kSingle ? 1e-4 : 1e-10));
            EXPECT_LT(std::abs(dot(torque - expected_torque, m.n)), scale * (kSingle ? 1e-3 : 1e-9));
            compared += f.p[2] != 0;
        }
        EXPECT_GT(compared, 10);
    }
}

TEST(ContactKernels, approach_is_that_of_the_normal_rows)
{
    const Problem problem = warm_problem(9);
    for (const ContactKernels* kernels : contact_kernels()) {
        SCOPED_TRACE(kernels->name);
        Arena arena;
        Problem p = problem;
        const RowSystem system = p.system();
        ContactSet set(*kernels);
        auto packed = arena.take<bool>(int(system.blocks.size()));
        ContactRows rows;
        ASSERT_TRUE(rows.gather(system, packed, arena) && set.pack(system, rows.list(), 1, arena));
        std::vector<Velocity> velocities(system.bodies.size() + 1);
        load_velocities(system, velocities);
        int compared = 0;
        for (const ContactBatch& batch : set.batches()) {
            Lanes v[kManifoldPoints];
            set.normal_velocities(batch, velocities, v);
            for (int i = 0; i < batch.count; ++i)
                for (int lane = 0; lane < kLanes; ++lane) {
                    const int point = set.sources()[std::size_t(batch.first + i)].point[lane];
                    if (point < 0) continue;
                    const int row = rows.row_of(point);
                    const SolverBody* b2 = std::size_t(batch.body2(lane)) < system.bodies.size()
                                               ? &system.bodies[std::size_t(batch.body2(lane))]
                                               : nullptr;
                    const Real expected = row_velocity(system.rows[std::size_t(row)],
                                                       system.bodies[std::size_t(batch.body1(lane))], b2);
                    EXPECT_NEAR(v[i][lane], expected, kSingle ? 1e-4 : 1e-12);
                    ++compared;
                }
        }
        EXPECT_EQ(compared, int(system.blocks.size()));
    }
}

}  // namespace
