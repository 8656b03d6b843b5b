// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The polytope alone, unpolished, on round solids, where nearly coplanar faces are the rule: the depth it
// stops at is within its tolerance of the least h(n) that a search over directions finds.
#include "geometry/overlap/epa.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "math/pose.h"

namespace epode {
namespace {

// Compass search over directions from the best of a grid; an upper bound of the depth like every h(n).
Real least_extent(const ConvexView& a, const ConvexView& b)
{
    Vec3 best{1, 0, 0};
    Real least = kInf;
    const auto offer = [&](Vec3 n) {
        if (!normalize(n)) return;
        const Real h = extent(a, b, n).h;
        if (h < least) least = h, best = n;
    };
    for (int i = -5; i <= 5; ++i)
        for (int j = -5; j <= 5; ++j)
            for (int k = -5; k <= 5; ++k)
                if (std::max({std::abs(i), std::abs(j), std::abs(k)}) == 5)
                    offer({Real(i), Real(j), Real(k)});
    for (Real step = Real(0.2); step > Real(1e-5);) {
        const Real before = least;
        Vec3 u, v;
        plane_space(best, u, v);
        const Vec3 at = best;
        for (Vec3 d : {u, v, u + v, u - v})
            for (Real sign : {1, -1}) offer(at + sign * step * d);
        if (!(least < before)) step /= 2;
    }
    return least;
}

TEST(Polytope, comes_as_near_as_it_promises_on_round_solids)
{
    std::mt19937_64 engine(7);
    const auto between = [&](Real lo, Real hi) {
        return lo + (hi - lo) * Real(double(engine() >> 11) * 0x1p-53);
    };
    const auto pose = [&](Real far) {
        Quat q = {between(-1, 1), between(-1, 1), between(-1, 1), between(-1, 1)};
        normalize(q);
        return Pose{{between(-far, far), between(-far, far), between(-far, far)}, to_matrix(q)};
    };
    int overlaps = 0;
    for (int i = 0; i < 4000; ++i) {
        const Cylinder one{between(Real(0.2), 1), between(Real(0.2), 2)};
        const Cylinder other{between(Real(0.2), 1), between(Real(0.2), 2)};
        const ConvexView a = view_of(one, pose(Real(0.3))), b = view_of(other, pose(Real(0.3)));
        const Real tolerance = (kSingle ? Real(1e-4) : Real(2e-6)) * (a.size + b.size);
        Overlap found;
        expand(a, b, tolerance, 0, found);
        if (found.depth <= 0) continue;
        ++overlaps;
        EXPECT_LE(found.depth - least_extent(a, b), 2 * tolerance) << i;
    }
    EXPECT_GT(overlaps, 3000);
}

}  // namespace
}  // namespace epode
