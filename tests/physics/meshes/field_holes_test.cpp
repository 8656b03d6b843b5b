// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Bodies and holes in a height field: over a wide hole they fall by the closed form, over a narrow one they
// come to rest on its rims as on those of the mesh of the same triangles, along one they roll bit for bit as
// on the whole field, and what is thrown about in a shaft stays in it.
#include <array>

#include "rig.h"

namespace epode::physics {
namespace {

constexpr int kCells = 16;  // of one metre, about the origin; y is up

struct Field {
    std::vector<double> heights;
    dHeightfieldDataID data = dGeomHeightfieldDataCreate();

    template <typename Height, typename Missing>
    Field(Sim& sim, const Height& height, const Missing& missing)
    {
        sim.gravity(0, -9.81, 0);
        for (int j = 0; j <= kCells; ++j)
            for (int i = 0; i <= kCells; ++i) heights.push_back(height(i, j));
        dGeomHeightfieldDataBuildDouble(data, heights.data(), 0, kCells, kCells, kCells + 1, kCells + 1, 1, 0,
                                        1, 0);
        for (int j = 0; j < kCells; ++j)
            for (int i = 0; i < kCells; ++i) dGeomHeightfieldDataSetHole(data, i, j, missing(i, j));
        dCreateHeightfield(sim.space, data, 1);
    }
    ~Field() { dGeomHeightfieldDataDestroy(data); }
    Field(const Field&) = delete;
    Field& operator=(const Field&) = delete;
};

double flat(int, int) { return 0; }
double hills(int i, int j) { return 0.3 * std::sin(1.3 * i) + 0.2 * std::cos(0.9 * j + 0.1 * i); }

// Half a size wide and high, about.
struct Bodies {
    std::vector<dReal> corners;
    std::vector<dTriIndex> sides;
    dTriMeshDataID block = dGeomTriMeshDataCreate();
    std::vector<dBodyID> all;

    Bodies(Sim& sim, double s)
    {
        for (int k = 0; k < 8; ++k)
            for (const double x : {k & 1 ? s : -s, k & 2 ? s : -s, k & 4 ? s : -s})
                corners.push_back(real(x));
        for (const int i : {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                            2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5})
            sides.push_back(dTriIndex(i));
        std::vector<dReal> padded;
        for (int k = 0; k < 8; ++k)
            for (int x = 0; x < 4; ++x) padded.push_back(x < 3 ? corners[std::size_t(3 * k + x)] : dReal(0));
        dGeomTriMeshDataBuildSimple(block, padded.data(), 8, sides.data(), int(sides.size()));
        all = {sim.sphere({}, s, 1),
               sim.box({}, {2 * s, s, 2 * s}, 1),
               sim.capsule({}, 0.5 * s, 2 * s, 1),
               sim.cylinder({}, 0.6 * s, 2 * s, 1),
               sim.body({}),
               sim.body({})};
        dGeomSetBody(dCreateConvexHull(sim.space, corners.data(), 8, 0), all[4]);
        dGeomSetBody(dCreateTriMesh(sim.space, block, nullptr, nullptr, nullptr), all[5]);
    }
    ~Bodies() { dGeomTriMeshDataDestroy(block); }
    Bodies(const Bodies&) = delete;
    Bodies& operator=(const Bodies&) = delete;
};

void lay_along_x(dBodyID body)
{
    dMatrix3 R;
    dRFromAxisAndAngle(R, 0, 1, 0, real(kPi / 2));
    dBodySetRotation(body, R);
}

TEST(FieldHoles, over_a_wide_hole_everything_falls_freely)
{
    constexpr double h = 0.005;
    constexpr int n = 300;
    for (int which = 0; which < 6; ++which) {
        Sim sim;
        const Field field(sim, hills, [](int i, int j) { return i >= 5 && i < 11 && j >= 5 && j < 11; });
        const Bodies bodies(sim, 0.5);
        for (const dBodyID b : bodies.all)
            if (b != bodies.all[std::size_t(which)]) dBodyDisable(b), dBodySetPosition(b, 0, 100, 0);
        const dBodyID body = bodies.all[std::size_t(which)];
        dBodySetPosition(body, real(1.2), 2, real(-1.1));
        dBodySetAngularVel(body, 1, 2, 3);
        sim.steps(n, h);
        const V3 at = vec(dBodyGetPosition(body));
        EXPECT_NEAR(at.y, 2 - 9.81 * h * h * n * (n + 1) / 2, tol(1e-9, 1e-3)) << which;
        EXPECT_NEAR(at.x, 1.2, tol(1e-12, 1e-6)) << which;
        EXPECT_NEAR(at.z, -1.1, tol(1e-12, 1e-6)) << which;
    }
}

TEST(FieldHoles, across_a_narrow_hole_everything_rests_on_the_rims)
{
    for (int which = 0; which < 6; ++which) {
        Sim sim;
        const Field field(sim, flat, [](int i, int j) { return i == 8 && (j == 8 || j == 7); });
        const Bodies bodies(sim, 1.25);
        for (const dBodyID b : bodies.all)
            if (b != bodies.all[std::size_t(which)]) dBodyDisable(b), dBodySetPosition(b, 0, 100, 0);
        const dBodyID body = bodies.all[std::size_t(which)];
        if (which == 2 || which == 3) lay_along_x(body);
        const double height[] = {std::sqrt(1.25 * 1.25 - 0.25), 0.625, 0.625, 0.75, 1.25, 1.25};
        dBodySetPosition(body, real(0.5), real(height[which] + 0.001), 0);
        sim.steps(400, 0.005);
        const V3 settled = vec(dBodyGetPosition(body));
        EXPECT_NEAR(settled.y, height[which], 2e-3) << which;
        sim.steps(400, 0.005);
        EXPECT_LT(length(vec(dBodyGetPosition(body)) - settled), tol(1e-4, 1e-3)) << which;
        EXPECT_LT(length(vec(dBodyGetLinearVel(body))), tol(1e-4, 2e-3)) << which;
    }
}

TEST(FieldHoles, rolling_along_a_hole_is_rolling_on_the_whole_field_bit_for_bit)
{
    for (const auto& height : {flat, hills})
        for (const bool wheel : {false, true}) {
            std::array<std::vector<dReal>, 2> paths;
            for (const int holed : {0, 1}) {
                Sim sim;
                sim.surface.mu = 1;
                const Field field(sim, height, [&](int, int j) { return holed && j >= 10; });
                const dBodyID body =
                    wheel ? sim.cylinder({-5, 1, 0.4}, 0.4, 0.3, 1) : sim.sphere({-5, 1, 0.4}, 0.4, 1);
                dBodySetLinearVel(body, 2, 0, 0);
                for (int i = 0; i < 400; ++i) {
                    sim.step(0.005);
                    if (dBodyGetPosition(body)[2] > real(1.4)) break;
                    paths[std::size_t(holed)].insert(paths[std::size_t(holed)].end(), dBodyGetPosition(body),
                                                     dBodyGetPosition(body) + 3);
                }
            }
            EXPECT_GT(paths[0].size(), 300u);
            EXPECT_EQ(paths[0], paths[1]) << wheel;
        }
}

TEST(FieldHoles, what_is_thrown_about_in_a_shaft_stays_in_it)
{
    Random random(5);
    for (int which = 0; which < 5; ++which)
        for (int throwing = 0; throwing < 4; ++throwing) {
            Sim sim;
            const Field field(sim, hills, [](int i, int j) { return i >= 6 && i < 10 && j >= 6 && j < 10; });
            const Bodies bodies(sim, 0.3);
            for (const dBodyID b : bodies.all)
                if (b != bodies.all[std::size_t(which)]) dBodyDisable(b), dBodySetPosition(b, 0, 100, 0);
            sim.gravity(0, 0, 0);
            const dBodyID body = bodies.all[std::size_t(which)];
            const double turn = random.uniform(0, 2 * kPi), speed = 4;
            dBodySetPosition(body, 0, real(-0.4), 0);
            dBodySetLinearVel(body, real(speed * std::cos(turn)), 0, real(speed * std::sin(turn)));
            int bounces = 0;
            V3 before = vec(dBodyGetLinearVel(body));
            for (int i = 0; i < 400; ++i) {
                sim.step(0.005);
                const V3 at = vec(dBodyGetPosition(body)), now = vec(dBodyGetLinearVel(body));
                bounces += length(now - before) > 1;
                before = now;
                ASSERT_LT(std::fabs(at.x), 2.0) << which << " step " << i;
                ASSERT_LT(std::fabs(at.z), 2.0) << which << " step " << i;
                if (at.y > -0.2 || at.y < -0.6) break;  // out by the top, or low enough to pass below
            }
            EXPECT_GT(bounces, 0) << which;
        }
}

}  // namespace
}  // namespace epode::physics
