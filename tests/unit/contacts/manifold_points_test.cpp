// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Points fixed in two geoms and placed again, four at a time, compared with the formulas one by one.
#include "contacts/manifold_points.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "../math/random_numbers.h"

namespace epode::test {
namespace {

class ManifoldPoints : public testing::Test {
  protected:
    Vec3 vector(Real size) { return size * random.vec(); }
    Pose pose() { return {vector(10), to_matrix(random.rotation())}; }
    // Points around `middle`, all in one manifold.
    void find(int count, Vec3 middle, Vec3 normal)
    {
        for (int i = 0; i < count; ++i) {
            store(contacts[i].pos, middle + vector(1));
            store(contacts[i].normal, normal);
            contacts[i].depth = random.in(Real(-0.01), Real(0.01));
            maker.add(contacts[i]);
        }
        maker.finish();
    }

    RandomNumbers random{7};
    CachedManifold was{}, now{};
    ManifoldMaker maker{std::span(&was, 1)};
    dContactGeom contacts[kManifoldPoints] = {};
};

void expect_equal(Float3 a, Float3 b)
{
    EXPECT_EQ(a.x, b.x);
    EXPECT_EQ(a.y, b.y);
    EXPECT_EQ(a.z, b.z);
}

TEST_F(ManifoldPoints, are_fixed_in_both_frames_and_missing_ones_repeat_the_last)
{
    for (int count = 1; count <= kManifoldPoints; ++count) {
        maker = ManifoldMaker(std::span(&was, 1));
        const Pose A = pose(), B = pose();
        find(count, A.p, {0, 0, 1});
        ASSERT_EQ(maker.count(0), count);
        ContactAnchors anchors;
        fix_points(maker, 0, A, B, Anchors::kTogether, anchors);
        Real largest = 0;
        for (int i = 0; i < kManifoldPoints; ++i) {
            const dContactGeom& c = contacts[std::min(i, count - 1)];
            const Vec3 p = load(c.pos);
            expect_equal(anchors.first(i), narrow(A.to_local(p)));
            expect_equal(anchors.second(i), narrow(B.to_local(p)));
            EXPECT_EQ(anchors.separation[i], float(-c.depth));
            largest = std::max(largest, length2(widen(anchors.second(i))));
        }
        EXPECT_NEAR(largest_reach2(anchors.a2), largest, 1e-6 * largest);
    }
}

TEST_F(ManifoldPoints, follow_both_geoms)
{
    int touching = 0;
    for (int trial = 0; trial < 400; ++trial) {
        const int count = 1 + trial % kManifoldPoints;
        maker = ManifoldMaker(std::span(&was, 1));
        const Pose A = pose(), B = pose();
        find(count, A.p, {0, 0, 1});
        was.found.normal = narrow(A.R.column(trial % 3));
        const Mat3 turn = transpose(A.R) * B.R;
        for (int i = 0; i < 3; ++i) was.found.turn[i] = narrow(turn.row(i));
        fix_points(maker, 0, A, B, Anchors::kTogether, was.found.anchors);
        for (int i = 0; i < count; ++i) was.manifold.points[i].normal_impulse = float(i + 1);
        now = was;

        // Both a little on, the second one on its own.
        const Vec3 away = vector(Real(0.02));
        const Pose A2 = {A.p + vector(Real(0.02)), A.R}, B2 = {B.p + away, B.R};
        const Vec3 x1 = vector(5), x2 = vector(5);
        const Real layer = Real(0.005);
        const bool touches = place_points(A2, B2, x1, trial % 5 ? &x2 : nullptr, layer, was, now.manifold);

        // That of what stands stays with it.
        const Vec3 local = widen(was.found.normal);
        const Mat3 known = {widen(was.found.turn[0]), widen(was.found.turn[1]), widen(was.found.turn[2])};
        const Vec3 n = trial % 5 ? A2.R * local : B2.R * transposed_times(known, local);
        expect_equal(now.manifold.normal, narrow(n));
        bool touched = false;
        for (int i = 0; i < count; ++i) {
            const Vec3 at1 = A2.to_world(widen(was.found.anchors.first(i))),
                       at2 = B2.to_world(widen(was.found.anchors.second(i))), at = Real(0.5) * (at1 + at2);
            const Real separation = Real(was.found.anchors.separation[i]) + dot(n, at1 - at2);
            const ManifoldPoint& point = now.manifold.points[i];
            expect_equal(point.r1, narrow(at - x1));
            expect_equal(point.r2, narrow(trial % 5 ? at - x2 : Vec3{}));
            EXPECT_EQ(point.separation, float(separation + layer));
            EXPECT_EQ(point.normal_impulse, float(i + 1));
            touched = touched || separation <= 0;
        }
        for (int i = count; i < kManifoldPoints; ++i) expect_equal(now.manifold.points[i].r1, {0, 0, 0});
        EXPECT_EQ(touches, touched);
        touching += touches;
    }
    EXPECT_GT(touching, 100);
    EXPECT_LT(touching, 350);
}

}  // namespace
}  // namespace epode::test
