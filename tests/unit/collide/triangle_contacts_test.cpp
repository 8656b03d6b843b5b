// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// One triangle against one solid in random poses: met or not as an independent reference says, the deepest
// contact parts the two when followed, and is no deeper than the least of a sweep over directions.
#include "mesh_scene.h"

namespace epode::test {
namespace {

constexpr Real kTight = kSingle ? Real(1e-4) : Real(2e-6);
constexpr Real kKept = kSingle ? Real(2e-3) : Real(1e-3);

template <typename Shape>
constexpr bool kTwoSided = false;
template <>
constexpr bool kTwoSided<Box> = true;

template <typename Shape>
Real overlap_along(const Shape& s, const Pose& pose, const Corners& t, Vec3 n)
{
    const Real low = dot(n, pose.to_world(farthest(s, transposed_times(pose.R, -n))));
    return std::fmax(dot(n, t.v[0]), std::fmax(dot(n, t.v[1]), dot(n, t.v[2]))) - low;
}

// Least overlap over all directions: a sweep, then a pattern search from the best.
template <typename Shape>
Real least_overlap_of(const Shape& s, const Pose& pose, const Corners& t, RandomNumbers& dice)
{
    struct Way {
        Real h;
        Vec3 n;
    };
    Way best[4] = {{kInf, {}}, {kInf, {}}, {kInf, {}}, {kInf, {}}};
    const auto offer = [&](Vec3 n) {
        const Way w{overlap_along(s, pose, t, n), n};
        for (Way& b : best)
            if (w.h < b.h) {
                b = w;
                break;
            }
    };
    for (int i = 0; i < 1500; ++i) offer(dice.direction());
    const Vec3 n = t.normal();
    offer(n), offer(-n);
    for (int i = 0; i < 3; ++i) {
        offer(pose.R.column(i)), offer(-pose.R.column(i));
        for (int k = 0; k < 3; ++k) {
            Vec3 c = cross(pose.R.column(i), t.v[(k + 1) % 3] - t.v[k]);
            if (normalize(c)) offer(c), offer(-c);
        }
    }
    Real least = kInf;
    for (Way w : best) {
        for (Real step = Real(0.05); step > Real(1e-6);) {
            Vec3 u, v;
            plane_space(w.n, u, v);
            bool better = false;
            for (int i = 0; i < 8; ++i) {
                const Real angle = Real(i) * kPi / 4;
                const Vec3 m = normalized_or(w.n + step * (std::cos(angle) * u + std::sin(angle) * v), w.n);
                const Real h = overlap_along(s, pose, t, m);
                if (h < w.h) w = {h, m}, better = true;
            }
            if (!better) step /= 2;
        }
        least = std::fmin(least, w.h);
    }
    return least;
}

template <typename Shape>
struct TriangleContacts : testing::Test {};
using Shapes = testing::Types<Sphere, Box, Capsule, Cylinder>;
TYPED_TEST_SUITE(TriangleContacts, Shapes);

TYPED_TEST(TriangleContacts, agree_with_the_reference_in_random_poses)
{
    using Shape = TypeParam;
    RandomNumbers dice(17);
    int met = 0, behind = 0, compared = 0, twice = 0;
    for (int trial = 0; trial < 3000; ++trial) {
        SCOPED_TRACE(trial);
        const Corners t{{2 * dice.vec(), 2 * dice.vec(), 2 * dice.vec()}};
        const Vec3 n = t.normal();
        if (length(cross(t.v[1] - t.v[0], t.v[2] - t.v[0])) < Real(0.05)) continue;
        Shape s;
        roll(dice, s);
        const Vec3 way = dice.direction();  // before its length with every compiler
        const Pose pose{dice.in(0, 2) * way, to_matrix(dice.rotation())};
        const bool front = dot(n, pose.p - t.v[0]) >= 0;
        const Mesh mesh({t});
        const Real apart = gap(s, pose, t);
        const std::vector<Hit> found = hits(s, pose, mesh);
        if (!front && !kTwoSided<Shape>) {
            EXPECT_TRUE(found.empty());
            ++behind;
            continue;
        }
        if (std::fabs(apart) < kTight) continue;
        ASSERT_EQ(!found.empty(), apart < 0) << "gap " << apart;
        if (found.empty()) continue;
        ++met;
        const Hit deep = *deepest(found);
        // Where the core of a capsule is through the triangle and past its border, a second push is due.
        Pose moved{pose.p + (deep.depth + 2 * kTight) * deep.normal, pose.R};
        if (std::is_same_v<Shape, Capsule> && gap(s, moved, t) < -kKept) {
            const std::vector<Hit> again = hits(s, moved, mesh);
            ASSERT_FALSE(again.empty());
            ASSERT_LT(deepest(again)->depth, deep.depth / 2);
            moved.p += (deepest(again)->depth + 2 * kTight) * deepest(again)->normal;
            ++twice;
        }
        ASSERT_GT(gap(s, moved, t), -kKept) << "the deepest contact does not part them";
        if (trial % 5) continue;
        ++compared;
        const Real least = least_overlap_of(s, pose, t, dice);
        const Real own = overlap_along(s, pose, t, front ? n : -n);
        const ConvexView view = view_of(s, pose);
        if (own > Real(0.011) * (view.size + view.radius)) {
            ASSERT_LE(deep.depth, least / Real(0.95) + kKept) << "own " << own;
        }
    }
    EXPECT_GT(met, 400);
    EXPECT_LT(twice, met / 20);
    EXPECT_GT(compared, 60);
    EXPECT_GT(behind + (kTwoSided<Shape> ? 1000 : 0), 800);
}

}  // namespace
}  // namespace epode::test
