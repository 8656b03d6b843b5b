// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Joints whose rows follow their bodies through the substeps of a step, and whose matrices are kept while
// bodies turn by little.
#include <gtest/gtest.h>

#include <cstring>
#include <vector>

#include "joint_mechanisms.h"
#include "math/rotation.h"

namespace {

using namespace epode_test;

// Bodies at rest at the origin of the step, then moved and turned by a fraction of a radian.
struct Moved {
    Problem p;
    std::vector<SolverPose> poses;
    RowSystem system;

    Moved(std::uint64_t seed, int bodies, int joints) : p(mechanism(seed, bodies, joints))
    {
        Dice dice(seed + 77);
        for (std::size_t i = 0; i < p.bodies.size(); ++i) {
            SolverPose pose;
            pose.x = p.places[i], pose.inv_mass = p.bodies[i].inv_mass;
            pose.q = rotation_about(dice.direction(), dice.real(0, 3));
            put_inertia(p.bodies[i].inv_inertia, pose);
            poses.push_back(pose);
        }
        poses.push_back({});
        poses.back().q = {};
        system = p.system();
        system.poses = poses;
    }

    static void put_inertia(const Sym3& s, SolverPose& pose)
    {
        pose.main = {s.xx, s.yy, s.zz}, pose.mixed = {s.xy, s.xz, s.yz};
    }

    std::vector<Velocity> velocities() const
    {
        std::vector<Velocity> out(poses.size());
        load_velocities(system, out);
        return out;
    }
    void turn(std::size_t i, Vec3 way, Vec3 axis, Real angle)
    {
        poses[i].x += way;
        poses[i].q = rotation_about(axis, angle) * poses[i].q;
    }
    Vec3 now(std::size_t i, const SolverPose& then, Vec3 a) const
    {
        return to_matrix(poses[i].q) * transposed_times(to_matrix(then.q), a);
    }
};

std::size_t slot_of(const Moved& m, int body) { return body >= 0 ? std::size_t(body) : m.p.bodies.size(); }

template <typename L>
void expect_followed_rows_of_the_moved_bodies()
{
    const Substep step{Real(0.002), 5};
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        Moved m(seed, 9, 14);
        const std::vector<SolverPose> then = m.poses;
        const std::vector<Row> said = m.p.rows;
        Arena arena;
        JointSetOf<L> set;
        ASSERT_TRUE(set.pack(m.system, joints_of(m.system), arena));
        ASSERT_TRUE(set.follow(m.system, step, m.velocities(), arena));
        Dice dice(seed + 99);
        for (std::size_t i = 0; i < m.p.bodies.size(); ++i)
            m.turn(i, dice.vec(Real(0.05)), dice.direction(), dice.real(0, Real(0.3)));
        set.turn(m.system), set.load_substep(m.system, step);
        std::vector<Row> rows = m.p.rows;
        set.describe(m.p.numbers, rows);
        int followed = 0;
        for (const RowBlock& block : m.p.blocks) {
            if (!block.followed) continue;
            ++followed;
            const std::size_t b1 = std::size_t(block.body1), b2 = slot_of(m, block.body2);
            const Vec3 r1 = m.now(b1, then[b1], block.arms.r1), r2 = m.now(b2, then[b2], block.arms.r2);
            const Vec3 gap = m.poses[b1].x + r1 - m.poses[b2].x - r2;
            const bool move = m.poses[b1].inv_mass > 0 && m.poses[b2].inv_mass > 0;
            const Vec3 half = move ? Real(0.5) * gap : Vec3{};  // both feel the force at one point
            const Vec3 gap0 = then[b1].x + block.arms.r1 - then[b2].x - block.arms.r2;
            const bool first =
                block.form == RowForm::kTurned ||
                length2(m.p.bodies[b1].w) <= (block.body2 >= 0 ? length2(m.p.bodies[b2].w) : Real(0));
            const std::size_t guide = first ? b1 : b2;
            for (int i = 0; i < block.count; ++i) {
                const std::size_t k = std::size_t(block.first + i);
                const Real tolerance = kCoarse<L> ? Real(1e-4) : Real(1e-11);
                const bool turns = i >= 3 || block.form == RowForm::kTurned;
                const Vec3 a0 = i < 3 ? said[k].lin1 : said[k].ang1;
                const Vec3 a = turns ? m.now(guide, then[guide], a0) : a0;
                EXPECT_LT(length((i < 3 ? rows[k].lin1 : rows[k].ang1) - a), tolerance);
                if (i >= 3) continue;
                EXPECT_LT(length(rows[k].ang1 - cross(r1 - half, a)), tolerance);
                EXPECT_LT(length(rows[k].ang2 + cross(r2 + half, a)), tolerance);
                const RowAim aim = map_row(said[k], step, kInf);
                const Real error = said[k].error - (dot(a, gap) - dot(a0, gap0));
                EXPECT_NEAR(m.p.numbers[k].c, aim.rate * error + said[k].speed, 100 * tolerance);
                EXPECT_EQ(m.p.numbers[k].C, typename L::Number(aim.C));
            }
        }
        EXPECT_GT(followed, 5);
    }
}

TEST(JointSet, followed_rows_are_those_of_the_moved_bodies)
{
    expect_followed_rows_of_the_moved_bodies<Lanes>();
    expect_followed_rows_of_the_moved_bodies<FloatLanes>();
}

// Also with bounds and in another order within the lanes.
template <typename L>
void expect_rows_that_ask_for_what_they_said()
{
    const Substep step{Real(0.002), 5};
    const Real tolerance = kCoarse<L> ? Real(1e-4) : Real(1e-11);
    Moved m(3, 40, 60);
    for (std::size_t k = 0; k < m.p.rows.size(); ++k)
        m.p.rows[k].erp = Real(0.1) + Real(0.001) * Real(k), m.p.rows[k].cfm = Real(1e-6) * Real(k % 7);
    const std::vector<Row> said = m.p.rows;
    Arena arena;
    JointSetOf<L> set;
    ASSERT_TRUE(set.pack(m.system, joints_of(m.system), arena));
    ASSERT_TRUE(set.follow(m.system, step, m.velocities(), arena));
    set.turn(m.system), set.load_substep(m.system, step);
    std::vector<Row> rows = m.p.rows;
    set.describe(m.p.numbers, rows);
    int followed = 0;
    for (const RowBlock& block : m.p.blocks)
        for (int i = 0; block.followed && i < block.count; ++i, ++followed) {
            const std::size_t k = std::size_t(block.first + i);
            const RowAim aim = map_row(said[k], step, kInf);
            EXPECT_NEAR(m.p.numbers[k].c, aim.rate * said[k].error + said[k].speed, 100 * tolerance);
            EXPECT_EQ(m.p.numbers[k].C, typename L::Number(aim.C));
            const Vec3 off = i < 3 ? rows[k].lin1 - said[k].lin1 : rows[k].ang1 - said[k].ang1;
            EXPECT_LT(length(off), tolerance);
        }
    EXPECT_GT(followed, 100);
}

TEST(JointSet, before_anything_moves_followed_rows_ask_for_what_they_said)
{
    expect_rows_that_ask_for_what_they_said<Lanes>();
    expect_rows_that_ask_for_what_they_said<FloatLanes>();
}

// A row that the user made soft keeps its error in relaxing sweeps, others aim at their speed.
template <typename L>
void expect_soft_rows_to_keep_their_aim()
{
    const Substep step{Real(0.002), 5};
    Moved m(1, 1, 0);
    std::vector<Row> of(4);
    for (int i = 0; i < 3; ++i) of[std::size_t(i)].lin1.set(i, 1);
    of[3].ang1 = {0, 0, 1};
    for (Row& row : of) row.erp = Real(0.2), row.error = Real(0.01);
    of[1].soft = of[3].soft = true;
    m.p.block(0, -1, false, of);
    m.p.blocks[0].form = RowForm::kPoint;
    m.system = m.p.system();
    m.system.poses = m.poses;
    Arena arena;
    JointSetOf<L> set;
    std::vector<Velocity> velocities = m.velocities();
    ASSERT_TRUE(set.pack(m.system, joints_of(m.system), arena));
    ASSERT_TRUE(set.follow(m.system, step, velocities, arena));
    set.turn(m.system), set.load_substep(m.system, step), set.apply_impulses(velocities);
    set.sweep(velocities, {1, true});
    const Real c = map_row(of[0], step, kInf).rate * Real(0.01), tolerance = kCoarse<L> ? 1e-5 : 1e-12;
    const Velocity& now = velocities[0];
    EXPECT_NEAR(now.v.x, 0, tolerance);
    EXPECT_NEAR(now.v.y, c, tolerance);
    EXPECT_NEAR(now.v.z, 0, tolerance);
    EXPECT_NEAR(now.w.z, c, tolerance);
}

TEST(JointSet, followed_rows_that_are_soft_keep_their_aim)
{
    expect_soft_rows_to_keep_their_aim<Lanes>();
    expect_soft_rows_to_keep_their_aim<FloatLanes>();
}

// A stop's or motor's axis is what the bodies turn about: then its error is exact.
TEST(JointSet, a_turn_about_an_axis_is_an_angle_whoever_turns)
{
    const Substep step{Real(0.002), 5};
    for (int who = 0; who < 4; ++who) {
        Moved m(1, 2, 0);
        Dice dice(5);
        const Vec3 axis = dice.direction();
        const bool second = who % 2, world = who >= 2;
        if (world && second) continue;
        m.p.bodies[second ? 1 : 0].w = 9 * axis;  // and the other one guides
        std::vector<Row> of(4);
        for (int i = 0; i < 3; ++i) of[std::size_t(i)].lin1.set(i, 1);
        of[3].ang1 = axis, of[3].ang2 = world ? Vec3{} : -axis;
        of[3].erp = Real(0.2), of[3].error = Real(0.01);
        m.p.block(0, world ? -1 : 1, false, of);
        m.p.blocks[0].form = RowForm::kPoint;
        m.system = m.p.system();
        m.system.poses = m.poses;
        Arena arena;
        JointSet set;
        ASSERT_TRUE(set.pack(m.system, joints_of(m.system), arena) &&
                    set.follow(m.system, step, m.velocities(), arena));
        const Vec3 other = dice.direction();
        if (!world) m.turn(0, {}, other, 1), m.turn(1, {}, other, 1);  // together: no change
        const Vec3 now = world ? axis : to_matrix(rotation_about(other, 1)) * axis;
        m.turn(second ? 1 : 0, {}, now, Real(0.7));
        set.turn(m.system), set.load_substep(m.system, step);
        std::vector<Row> rows = m.p.rows;
        set.describe(m.p.numbers, rows);
        const RowAim aim = map_row(of[3], step, kInf);
        EXPECT_NEAR(m.p.numbers[3].c / aim.rate, Real(0.01) + Real(second ? 0.7 : -0.7), 1e-4) << who;
        EXPECT_LT(length(rows[3].ang1 - now), kSingle ? 1e-5 : 1e-12) << who;
    }
}

template <typename L>
void expect_to_follow_with_the_same_bits()
{
    const auto all = joint_kernels();
    const Substep step{Real(0.002), 5};
    const auto aims = [&](const JointKernels& kernels) {
        Moved m(4, 200, 600);  // enough to fill all lanes
        Arena arena;
        JointSetOf<L> set(kernels);
        EXPECT_TRUE(set.pack(m.system, joints_of(m.system), arena) &&
                    set.follow(m.system, step, m.velocities(), arena));
        Dice dice(8);
        for (std::size_t i = 0; i < m.p.bodies.size(); ++i)
            m.turn(i, dice.vec(Real(0.05)), dice.direction(), dice.real(0, Real(0.3)));
        set.turn(m.system), set.load_substep(m.system, step);
        set.describe(m.p.numbers, m.p.rows);
        return m.p;
    };
    const Problem a = aims(*all[0]);
    for (const JointKernels* other : all.subspan(1)) {
        SCOPED_TRACE(other->name);
        const Problem b = aims(*other);
        for (std::size_t k = 0; k < a.rows.size(); ++k) {
            EXPECT_EQ(std::memcmp(&a.numbers[k].c, &b.numbers[k].c, sizeof(Real)), 0);
            EXPECT_EQ(std::memcmp(static_cast<const Jacobian*>(&a.rows[k]),
                                  static_cast<const Jacobian*>(&b.rows[k]), sizeof(Jacobian)),
                      0);
        }
    }
}

TEST(JointKernels, all_machines_follow_with_the_same_bits)
{
    if (joint_kernels().size() == 1) GTEST_SKIP() << "this machine runs the baseline only";
    expect_to_follow_with_the_same_bits<Lanes>();
    expect_to_follow_with_the_same_bits<FloatLanes>();
}

// Pairs of bodies, each held together by a point and an axis, of which one turns by the angle of the pair
// between two substeps; then they are visited.
template <typename L>
class TurnedPairs {
  public:
    explicit TurnedPairs(std::vector<Real> angles)
    {
        for (std::size_t i = 0; i < angles.size(); ++i) add_pair();
        RowSystem system = p_.system();
        poses_.resize(p_.bodies.size() + 1);
        for (std::size_t i = 0; i < p_.bodies.size(); ++i) {
            poses_[i].x = p_.places[i], poses_[i].inv_mass = p_.bodies[i].inv_mass;
            Moved::put_inertia(p_.bodies[i].inv_inertia, poses_[i]);
        }
        system.poses = poses_;
        velocities_.resize(poses_.size());
        load_velocities(system, velocities_);
        EXPECT_TRUE(set_.pack(system, joints_of(system), arena_) &&
                    set_.follow(system, kStep, velocities_, arena_));
        set_.turn(system), set_.load_substep(system, kStep), set_.apply_impulses(velocities_);
        for (std::size_t i = 0; i < angles.size(); ++i)
            poses_[2 * i].q = rotation_about({0, 0, 1}, angles[i]) * poses_[2 * i].q;
        set_.turn(system), set_.load_substep(system, kStep), set_.apply_impulses(velocities_);
    }

    // What the rows of the first pair are off by after so many visits.
    Real error_after(int visits)
    {
        for (int i = 0; i < visits; ++i) set_.sweep(velocities_, {1, false});
        std::vector<Row> rows = p_.rows;
        set_.describe(p_.numbers, rows);
        SolverBody a, b;
        a.v = velocities_[0].v, a.w = velocities_[0].w, b.v = velocities_[1].v, b.w = velocities_[1].w;
        Real worst = 0;
        for (int i = 0; i < p_.blocks[0].count; ++i) {
            const RowNumbers& n = p_.numbers[std::size_t(i)];
            const Real off = row_velocity(rows[std::size_t(i)], a, &b) + n.C * n.p - n.c;
            worst = std::max(worst, std::fabs(off));
        }
        return worst;
    }

    std::span<const Velocity> of_pair(std::size_t i) const
    {
        return std::span(velocities_).subspan(2 * i, 2);
    }

  private:
    static constexpr Substep kStep{Real(0.002), 5};

    void add_pair()
    {
        const int a = p_.body({0, 0, 0}, 1, {1, Real(0.5), 2}), b = p_.body({1, 1, 0}, 2, {1, 2, Real(0.5)});
        p_.bodies[std::size_t(a)].v = {1, 2, 3}, p_.bodies[std::size_t(b)].w = {-1, 1, 2};
        std::vector<Row> of;
        const Vec3 at{1, 0, Real(0.3)}, directions[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
        for (const Vec3& d : directions) of.push_back(p_.point_row(a, b, at, d, Real(0.2), 0));
        Row axis;
        axis.ang1 = {0, 1, 0}, axis.ang2 = {0, -1, 0};
        of.push_back(axis);
        p_.block(a, b, false, of);
        p_.blocks.back().form = RowForm::kPoint;
        p_.blocks.back().arms = {at - p_.places[std::size_t(a)], at - p_.places[std::size_t(b)]};
    }

    Problem p_;
    std::vector<SolverPose> poses_;
    std::vector<Velocity> velocities_;
    Arena arena_;
    JointSetOf<L> set_;
};

// Its matrix is recomputed when a body has turned by more than 0.1 rad. One that is kept leaves a part of the
// error, and that part of it in the next visit.
template <typename L>
void expect_matrices_kept_for_small_turns()
{
    const Real rounding = kCoarse<L> ? Real(2e-5) : Real(1e-12);
    EXPECT_LT(TurnedPairs<L>({0}).error_after(1), rounding);
    EXPECT_LT(TurnedPairs<L>({Real(0.11)}).error_after(1), rounding);
    EXPECT_GT(TurnedPairs<L>({Real(0.09)}).error_after(1), Real(1e-3));
    TurnedPairs<L> kept({Real(0.09)});
    const Real before = kept.error_after(0);
    EXPECT_LT(kept.error_after(1), Real(0.1) * before);
    EXPECT_LT(kept.error_after(20), rounding);
}

// Whichever joints share its group of lanes.
template <typename L>
void expect_matrices_made_by_lane()
{
    const std::vector<Real> angles{0,          Real(0.05), Real(0.2),  Real(0.09),
                                   Real(0.11), 1,          Real(0.01), Real(-0.3)};
    TurnedPairs<L> all(angles);
    (void)all.error_after(3);
    for (std::size_t i = 0; i < angles.size(); ++i) {
        TurnedPairs<L> one({angles[i]});
        (void)one.error_after(3);
        EXPECT_EQ(std::memcmp(one.of_pair(0).data(), all.of_pair(i).data(), 2 * sizeof(Velocity)), 0) << i;
    }
}

TEST(JointSet, matrices_are_kept_for_small_turns)
{
    expect_matrices_kept_for_small_turns<Lanes>();
    expect_matrices_kept_for_small_turns<FloatLanes>();
}

TEST(JointSet, matrices_are_recomputed_joint_by_joint)
{
    expect_matrices_made_by_lane<Lanes>();
    expect_matrices_made_by_lane<FloatLanes>();
}

}  // namespace
