// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Collisions with a margin: corners of polyhedra that are nearer than that to a face are contacts of negative
// depth, as long as fewer than four touch. Over boxes, hulls and planes in random places; other shapes have
// the contacts that they have without.
#include <gtest/gtest.h>
#include <ode/ext.h>
#include <ode/ode.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>
#include <string>

#include "collide/collide.h"

namespace epode::test {
namespace {

constexpr Real kMargin = Real(0.1);
constexpr Real kTight = kSingle ? Real(1e-4) : Real(1e-7);
const Vec3 kUpper = {Real(0.5), Real(0.4), Real(0.3)}, kLower = {1, Real(0.9), Real(0.5)};  // half sides

struct Found {
    dContactGeom at[4];
    int count = 0;
    Found(dGeomID a, dGeomID b, Real margin)
    {
        std::memset(at, 0, sizeof at);
        ContactArray out{at, int(sizeof(dContactGeom)), 4, false};
        out.margin = margin;
        collide(*from_handle<Geom>(a), *from_handle<Geom>(b), out);
        count = out.count;
    }
    int touching() const
    {
        return int(std::count_if(at, at + count, [](const dContactGeom& c) { return c.depth >= 0; }));
    }
};

dGeomID make_box(Vec3 half) { return dCreateBox(nullptr, 2 * half.x, 2 * half.y, 2 * half.z); }

dGeomID make_hull(Vec3 half)
{
    dReal corners[24];
    for (int i = 0; i < 24; ++i) corners[i] = (i / 3 >> i % 3 & 1) ? half[i % 3] : -half[i % 3];
    return dCreateConvexHull(nullptr, corners, 8, 8);
}

// The lower surface is level with the origin, however it is turned.
dGeomID make_plane(Vec3) { return dCreatePlane(nullptr, 0, 0, 1, 0); }

using Make = dGeomID (*)(Vec3 half);
struct Kind {
    const char* name;
    Make upper, lower;
};

class Margin : public testing::TestWithParam<Kind> {
  protected:
    Margin()
    {
        dInitODE();
        upper = GetParam().upper(kUpper), lower = GetParam().lower(kLower);
    }
    ~Margin() override
    {
        dGeomDestroy(upper), dGeomDestroy(lower);
        dCloseODE();
    }
    bool on_plane() const { return dGeomGetClass(lower) == dPlaneClass; }
    Real between(Real lo, Real hi) { return lo + (hi - lo) * Real(double(engine() >> 11) * 0x1p-53); }

    // The upper one over the lower one, its lowest corner a little below the top, turned by up to `tilt`.
    void drop(Real tilt)
    {
        dQuaternion q = {1, between(-tilt, tilt), between(-tilt, tilt), between(-1, 1)};
        dGeomSetQuaternion(upper, q);
        const dReal* R = dGeomGetRotation(upper);
        Real down = 0;
        for (int k = 0; k < 3; ++k) down += std::fabs(R[8 + k]) * kUpper[k];
        // Each draw is a statement of its own: compilers differ in the order in which arguments are evaluated.
        const Real z = (on_plane() ? Real(0) : kLower.z) + down - between(Real(0.001), Real(0.02));
        const Real y = between(Real(-0.8), Real(0.8)), x = between(Real(-0.8), Real(0.8));
        dGeomSetPosition(upper, x, y, z);
    }
    // Of a point from the surface of one of the two; less than nothing inside.
    Real distance(dGeomID geom, Vec3 half, Vec3 p) const
    {
        if (geom == lower && on_plane()) return p.z;
        const dReal *x = dGeomGetPosition(geom), *R = dGeomGetRotation(geom);
        Real largest = -kInf, outside = 0;
        for (int k = 0; k < 3; ++k) {
            Real along = 0;
            for (int i = 0; i < 3; ++i) along += R[4 * i + k] * (p[i] - x[i]);
            const Real d = std::fabs(along) - half[k];
            largest = std::max(largest, d);
            if (d > 0) outside += d * d;
        }
        return largest > 0 ? std::sqrt(outside) : largest;
    }

    std::mt19937_64 engine{7};
    dGeomID upper, lower;
};

// Each lies on one of the two, and its gap away on the other. Where the normal is that of two edges, which is
// nearly a face's, corners are off by as much as it leans.
TEST_P(Margin, corners_over_a_face_are_reported_with_their_gap)
{
    int near = 0;
    for (int i = 0; i < 500; ++i) {
        drop(Real(0.1));
        const Found found(upper, lower, kMargin);
        for (const dContactGeom& c : std::span(found.at).first(std::size_t(found.count))) {
            EXPECT_GE(c.depth, -kMargin);
            if (c.depth >= 0) continue;
            ++near;
            const Vec3 p = load(c.pos), n = load(c.normal);
            const dReal* R = dGeomGetRotation(upper);
            const Real lean = std::min(length(n - Vec3{0, 0, 1}), length(n - Vec3{R[2], R[6], R[10]}));
            const Real on_upper = std::fabs(distance(upper, kUpper, p)),
                       on_lower = std::fabs(distance(lower, kLower, p));
            EXPECT_LT(std::min(on_upper, on_lower), kTight) << i;
            const Vec3 there = on_upper < on_lower ? p + c.depth * n : p - c.depth * n;
            EXPECT_LT(std::fabs(distance(on_upper < on_lower ? lower : upper,
                                         on_upper < on_lower ? kLower : kUpper, there)),
                      kTight - c.depth * lean)
                << i;
        }
    }
    EXPECT_GT(near, 500);
}

TEST_P(Margin, who_lands_on_one_corner_flatly_has_four_points)
{
    for (int i = 0; i < 500; ++i) {
        drop(Real(0.02));
        const dReal* x = dGeomGetPosition(upper);
        if (!on_plane() && std::max(std::fabs(x[0]), std::fabs(x[1])) > Real(0.2)) continue;
        EXPECT_EQ(Found(upper, lower, kMargin).count, 4) << i;
    }
}

TEST_P(Margin, what_touches_is_what_touches_without)
{
    int four = 0, alike = 0, all = 0;
    for (int i = 0; i < 1000; ++i) {
        drop(i % 2 ? Real(0.02) : 3);
        const Found without(upper, lower, 0), with(upper, lower, kMargin);
        EXPECT_EQ(without.count > 0, with.touching() > 0) << i;
        EXPECT_EQ(without.count, without.touching());
        if (without.count == 4) {
            ++four;
            EXPECT_EQ(std::memcmp(without.at, with.at, sizeof with.at), 0);
        } else if (without.count > 0) {
            ++all;
            EXPECT_GT(dot(load(without.at[0].normal), load(with.at[0].normal)), Real(0.995));
            alike += with.touching() == without.count;
        }
    }
    EXPECT_GT(four, 5);
    EXPECT_GT(alike, Real(0.8) * all);  // others are edges that became faces
}

INSTANTIATE_TEST_SUITE_P(
    Polyhedra, Margin,
    testing::Values(Kind{"box_box", make_box, make_box}, Kind{"box_hull", make_box, make_hull},
                    Kind{"hull_box", make_hull, make_box}, Kind{"hull_hull", make_hull, make_hull},
                    Kind{"box_plane", make_box, make_plane}, Kind{"hull_plane", make_hull, make_plane}),
    [](const auto& kind) { return std::string(kind.param.name); });

TEST(MarginOfOthers, changes_nothing)
{
    dInitODE();
    const auto made = [](int kind) {
        return kind == 0   ? dCreateSphere(nullptr, Real(0.5))
               : kind == 1 ? dCreateCapsule(nullptr, Real(0.4), 1)
               : kind == 2 ? dCreateCylinder(nullptr, Real(0.4), 1)
                           : make_box(kUpper);
    };
    std::mt19937_64 engine{3};
    const auto between = [&](Real lo, Real hi) {
        return lo + (hi - lo) * Real(double(engine() >> 11) * 0x1p-53);
    };
    int hits = 0;
    for (int first = 0; first < 3; ++first)
        for (int second = 0; second < (first < 2 ? 4 : 2); ++second)  // cylinders have faces
            for (int i = 0; i < 120; ++i) {
                const dGeomID a = made(first), b = made(second);
                for (const dGeomID geom : {a, b}) {
                    const dQuaternion q = {between(Real(0.1), 1), between(-1, 1), between(-1, 1),
                                           between(-1, 1)};
                    dGeomSetQuaternion(geom, q);
                }
                dGeomSetPosition(b, between(-1, 1), between(-1, 1), between(-1, 1));
                const Found without(a, b, 0), with(a, b, kMargin);
                EXPECT_EQ(without.count, with.count);
                for (int k = 0; k < without.count; ++k) {
                    ++hits;
                    EXPECT_EQ(without.at[k].depth, with.at[k].depth);
                    EXPECT_EQ(load(without.at[k].pos), load(with.at[k].pos));
                }
                dGeomDestroy(a), dGeomDestroy(b);
            }
    EXPECT_GT(hits, 400);
    dCloseODE();
}

}  // namespace
}  // namespace epode::test
