// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Distances of cylinders: closed forms for each kind of feature that can be nearest, and for any pose the proof that
// there is no shorter way, from the two supports along the normal. How often the search by Newton's method answers.
#include <gtest/gtest.h>

#include <cmath>

#include "geometry/overlap/gjk.h"
#include "geometry/overlap/rim_distance.h"

using namespace epode;

namespace {

constexpr Real kClose = kSingle ? Real(1e-5) : Real(1e-12);
// Of few poses, features that extend on both sides, the steps of GJK end by rounding, with a plane that leans by 1e-6.
constexpr Real kProved = kSingle ? Real(1e-5) : Real(1e-11);

Pose lying(Vec3 at) { return {at, {{1, 0, 0}, {0, 0, -1}, {0, 1, 0}}}; }  // its axis along y
Pose upright(Vec3 at) { return {at, Mat3::identity()}; }

Distance between(const ConvexView& a, const ConvexView& b)
{
    const Distance d = gjk_distance(a, b, kInf, 4 * kEpsilon, LastDigits::kByNewton);
    EXPECT_NEAR(length(d.on_a - d.on_b), d.distance, kClose);
    EXPECT_LT(length(d.on_a - d.on_b - d.distance * d.normal), kClose * 10);
    return d;
}

}  // namespace

TEST(RimDistance, has_the_values_of_closed_forms)
{
    const Cylinder round{Real(0.5), 1}, other{Real(0.25), 2};
    const Box box{{1, 2, 3}};
    // Side on side, crossed.
    EXPECT_NEAR(
        between(view_of(round, upright({3, 0, 0})), view_of(other, lying({0, Real(0.3), 0}))).distance, 2.25,
        kClose);
    // Rim over an end.
    const Mat3 tilted = {{1, 0, 0}, {0, Real(0.8), Real(-0.6)}, {0, Real(0.6), Real(0.8)}};
    EXPECT_NEAR(
        between(view_of(round, {{0, Real(0.4), 5}, tilted}), view_of(Cylinder{3, 1}, upright({}))).distance,
        5 - 0.8 - 0.5 * 0.6 - 1, kClose);
    // Rim at a corner, a side at an edge, and the side of one over a face.
    EXPECT_NEAR(between(view_of(round, upright({4, 6, 5})), view_of(box, upright({}))).distance,
                std::hypot(std::hypot(3.0, 4.0) - 0.5, 1.0), kClose);
    EXPECT_NEAR(between(view_of(round, upright({4, 6, 0})), view_of(box, upright({}))).distance, 4.5, kClose);
    EXPECT_NEAR(between(view_of(round, lying({4, 0, 0})), view_of(box, upright({}))).distance, 2.5, kClose);
    // Two rims, one over the other and aside: in the plane of both axes.
    EXPECT_NEAR(between(view_of(round, upright({3, 0, 4})), view_of(other, upright({}))).distance,
                std::hypot(3 - 0.75, 4.0 - 3), kClose);
}

// Whatever the poses: no plane is passed, so the points are nearest.
TEST(RimDistance, is_proved_by_the_supports_along_its_normal)
{
    std::uint64_t seed = 3;
    const auto in = [&](Real lo, Real hi) {
        seed = seed * 6364136223846793005ull + 1442695040888963407ull;
        return lo + (hi - lo) * Real(double(seed >> 11) / 9007199254740992.0);
    };
    const auto pose = [&](Real far) {
        Quat q{in(-1, 1), in(-1, 1), in(-1, 1), in(-1, 1)};
        normalize(q);
        return Pose{{in(-far, far), in(-far, far), in(-far, far)}, to_matrix(q)};
    };
    int apart = 0, quick = 0;
    for (int i = 0; i < 4000; ++i) {
        const Cylinder a{in(Real(0.1), 1), in(Real(0.1), 1)}, c{in(Real(0.1), 1), in(Real(0.1), 1)};
        const Box box{{in(Real(0.1), 1), in(Real(0.1), 1), in(Real(0.1), 1)}};
        const Pose A = pose(3), B = pose(3);
        const ConvexView one = view_of(a, A), two = i % 2 ? view_of(c, B) : view_of(box, B);
        const Distance d = gjk_distance(one, two, kInf, 4 * kEpsilon, LastDigits::kByNewton);
        if (!(d.distance > Real(0.05))) continue;
        ++apart;
        const Real bound = dot(d.normal, one.support(-d.normal) - two.support(d.normal));
        EXPECT_NEAR(bound, d.distance, kProved) << i;
        const NearPoints near{d.on_a, d.on_b};
        Distance again;
        if (!rim_distance(one, two, d.normal, {&near, 1}, 4 * kEpsilon, again)) continue;
        ++quick;
        EXPECT_NEAR(again.distance, d.distance, kProved) << i;
    }
    EXPECT_GT(apart, 1000);
    EXPECT_GT(quick, apart / 4);  // from one point nothing is known of features that extend
}
