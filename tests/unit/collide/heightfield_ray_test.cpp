// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Rays on height fields: measured numbers of the original, all hits against brute force, no holes at seams.
#include <algorithm>

#include "terrain.h"

namespace epode::test {
namespace {

struct Probe {
    dGeomID ray = dCreateRay(nullptr, 100);
    ~Probe() { dGeomDestroy(ray); }
    std::vector<Found> cast(const Ground& ground, Vec3 o, Vec3 d, Real length = 100) const
    {
        dGeomRaySet(ray, o.x, o.y, o.z, d.x, d.y, d.z);
        dGeomRaySetLength(ray, length);
        return contacts(ray, ground.geom, 256);
    }
};

TEST(HeightfieldRay, agrees_with_measured_numbers_of_the_original)
{
    const Ground ground(3, 3, 4, 4, [](int i, int j) { return i == 1 && j == 1 ? 1 : 0; });
    const Probe probe;
    const Vec3 n{Real(-0.408248), Real(0.816497), Real(-0.408248)};
    for (const Real from : {Real(3), Real(-3)}) {
        const std::vector<Found> f =
            probe.cast(ground, {Real(-0.5), from, Real(-0.6)}, {0, from > 0 ? Real(-1) : Real(1), 0});
        ASSERT_EQ(f.size(), 1u);
        EXPECT_NEAR(f[0].pos.y, 0.45, 1e-6);
        EXPECT_LT(length(f[0].normal - n), 2e-6) << "up, from below too";
        EXPECT_NEAR(f[0].depth, std::fabs(from - Real(0.45)), 1e-6);
    }
    const std::vector<Found> f = probe.cast(ground, {-3, Real(0.5), Real(0.1)}, {1, 0, 0});
    ASSERT_EQ(f.size(), 2u);
    EXPECT_NEAR(f[0].depth, 2, 1e-6);
    EXPECT_NEAR(f[1].depth, 3.9, 1e-6);
}

TEST(HeightfieldRay, samples_run_fastest_along_x)
{
    const double rows[2][3] = {{0, 1, 2}, {10, 11, 12}};
    const Ground ground(3, 2, 2, 1, [&](int i, int j) { return rows[j][i]; });
    const Probe probe;
    const Real at[3][3] = {{Real(-0.99), Real(-0.49), Real(0.11)},
                           {Real(0.99), Real(-0.49), Real(2.09)},
                           {Real(-0.99), Real(0.49), Real(9.91)}};
    for (const auto& p : at) {
        const std::vector<Found> f = probe.cast(ground, {p[0], 50, p[1]}, {0, -1, 0});
        ASSERT_EQ(f.size(), 1u);
        EXPECT_NEAR(f[0].pos.y, p[2], 1e-5);
    }
}

std::vector<Real> hits(const std::vector<Tri>& all, Vec3 o, Vec3 d, Real length)
{
    std::vector<Real> out;
    for (const Tri& t : all) {
        const Vec3 n = cross(t.b - t.a, t.c - t.a);
        const Real rate = dot(n, d);
        if (rate == 0) continue;
        const Real s = dot(n, t.a - o) / rate;
        const Vec3 p = o + s * d;
        const Real u = dot(n, cross(t.b - t.a, p - t.a)), v = dot(n, cross(t.c - t.b, p - t.b)),
                   w = dot(n, cross(t.a - t.c, p - t.c));
        if (s >= 0 && s <= length && u >= 0 && v >= 0 && w >= 0) out.push_back(s);
    }
    std::sort(out.begin(), out.end());
    return out;
}

TEST(HeightfieldRay, finds_every_hit_in_order_on_random_fields)
{
    RandomNumbers dice(3);
    const Ground ground(15, 11, 14, 10, [&](int, int) { return dice.in(-1, 1); });
    const std::vector<Tri> all = ground.triangles();
    const Probe probe;
    int total = 0;
    for (int trial = 0; trial < 3000; ++trial) {
        const Vec3 o{dice.in(-9, 9), dice.in(-2, 2), dice.in(-7, 7)};
        Vec3 d = dice.direction();
        if (trial % 3) d = normalized_or(Vec3{d.x, Real(0.1) * d.y, d.z}, d);
        const Real length = dice.in(1, 30);
        const std::vector<Real> expected = hits(all, o, d, length);
        const std::vector<Found> f = probe.cast(ground, o, d, length);
        ASSERT_EQ(f.size(), expected.size()) << trial;
        for (std::size_t k = 0; k < f.size(); ++k) {
            EXPECT_NEAR(f[k].depth, expected[k], kSingle ? 1e-3 : 1e-9);
            EXPECT_GT(f[k].normal.y, 0);
            EXPECT_LT(epode::length(f[k].pos - (o + f[k].depth * d)), 1e-4);
        }
        total += int(f.size());
    }
    EXPECT_GT(total, 1000);
}

TEST(HeightfieldRay, slips_through_no_seam_corner_or_diagonal)
{
    RandomNumbers dice(4);
    const Ground ground(9, 9, 8, 8, [&](int, int) { return dice.in(-1, 1); });
    const Probe probe;
    for (int i = 0; i <= 32; ++i)
        for (int j = 0; j <= 32; ++j) {  // quarters of cells: on corners, edges, diagonals
            const Vec3 p{Real(i) / 4 - 4, 0, Real(j) / 4 - 4};
            EXPECT_EQ(probe.cast(ground, p + Vec3{0, 5, 0}, {0, -1, 0}).size(), 1u) << i << ' ' << j;
            EXPECT_EQ(probe.cast(ground, p - Vec3{0, 5, 0}, {0, 1, 0}).size(), 1u) << i << ' ' << j;
            if (i > 2 && j > 2 && i < 30 && j < 30)
                for (const Vec3 lean :
                     {Vec3{Real(0.1), 0, 0}, Vec3{0, 0, Real(0.1)}, Vec3{Real(0.1), 0, Real(-0.1)}}) {
                    const Vec3 from = p + Vec3{0, 5, 0};
                    EXPECT_EQ(probe.cast(ground, from, Vec3{0, -1, 0} + lean).size() % 2, 1u)
                        << i << ' ' << j;
                }
        }
}

TEST(HeightfieldRay, follows_a_wrapped_field_and_a_turned_one)
{
    const Ground ground(
        5, 5, 4, 4, [](int i, int j) { return i % 4 == 2 && j % 4 == 2 ? 1 : 0; }, true);
    const Probe probe;
    const std::vector<Found> f = probe.cast(ground, {-50, Real(0.5), 0}, {1, 0, 0}, 100);
    EXPECT_EQ(f.size(), 50u) << "25 hills, each entered and left";
    place(ground.geom, {1, 2, 3}, from_columns({0, 0, 1}, {1, 0, 0}, {0, 1, 0}));  // up is x
    const std::vector<Found> g = probe.cast(ground, {10, Real(2.1), Real(3.1)}, {-1, 0, 0});
    ASSERT_EQ(g.size(), 1u);
    EXPECT_NEAR(g[0].pos.x, 1.8, 1e-5);
    EXPECT_GT(g[0].normal.x, 0);
}

TEST(HeightfieldRay, ends_where_its_length_does)
{
    const Ground ground(5, 5, 4, 4, [](int, int) { return 0; });
    const Probe probe;
    EXPECT_TRUE(probe.cast(ground, {0, 2, 0}, {0, -1, 0}, Real(1.99)).empty());
    EXPECT_EQ(probe.cast(ground, {0, 2, 0}, {0, -1, 0}, 2).size(), 1u);
    EXPECT_EQ(probe.cast(ground, {0, 0, 0}, {0, -1, 0}, 2).size(), 1u) << "starting on the ground";
    EXPECT_TRUE(probe.cast(ground, {3, 2, 0}, {0, -1, 0}).empty()) << "off the rectangle";
    EXPECT_TRUE(probe.cast(ground, {0, 2, 0}, {1, 0, 0}).empty());
}

}  // namespace
}  // namespace epode::test
