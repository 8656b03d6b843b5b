// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Rays of batches: in closed form, and as ordinary worlds cast them.
#include "models.h"

#include <epode/robot_sensors.h>
#include <ode/ext.h>

namespace epode::tests {
namespace {

struct Cast {
    std::vector<double> ranges;
    std::vector<int> shapes;
};

Cast cast(const Copies<double>& copies, int count, int link, dBatchRayAxes axes,
          const std::vector<dReal>& origins, const std::vector<dReal>& directions, dReal reach = dInfinity)
{
    const int rays = int(directions.size() / 3);
    Cast out{std::vector<double>(size_t(count * rays)), std::vector<int>(size_t(count * rays))};
    EXPECT_EQ(dBatchCastRays(copies.id, link, axes, rays, origins.empty() ? nullptr : origins.data(),
                             directions.data(), reach, 0, count, out.ranges.data(), out.shapes.data()),
              1);
    return out;
}

// A ball at a height h above the floor, turned anyhow, and a wall at x = 3.
TEST(BatchRays, measure_heights_and_walls)
{
    const dRobotModelID model = model_of(
        R"(<mujoco><worldbody><geom type="plane" size="9 9 1"/><geom type="box" pos="4 0 0" size="1 9 9"/>
<body pos="0 0 1"><freejoint/><geom size=".1" mass="1"/></body></worldbody></mujoco>)");
    Copies<double> copies(model, 5, dReal(0.002), 0, 2);
    const double half = std::sqrt(0.5);
    for (int i = 0; i < 5; ++i)
        copies.write_one(dBatchPositions, i, {0.1 * i, 0, 1 + 0.3 * i, half, 0, 0, half});  // heads along y
    const Cast down = cast(copies, 5, 1, dBatchRaysUpright, {0, 0, 0, 0.5, 0, 0.2}, {0, 0, -1, 0, 0, -7});
    const Cast ahead = cast(copies, 5, 1, dBatchRaysOfWorld, {}, {1, 0, 0, -1, 0, 0});
    const Cast aside = cast(copies, 5, 1, dBatchRaysOfLink, {}, {0, -2, 0});  // the world's x
    for (size_t i = 0; i < 5; ++i) {
        EXPECT_NEAR(down.ranges[2 * i], 1 + 0.3 * double(i), 1e-12);
        EXPECT_NEAR(down.ranges[2 * i + 1], 1.2 + 0.3 * double(i), 1e-12);
        EXPECT_EQ(down.shapes[2 * i], 0);
        EXPECT_NEAR(ahead.ranges[2 * i], 3 - 0.1 * double(i), 1e-12);
        EXPECT_EQ(ahead.shapes[2 * i], 1);
        EXPECT_TRUE(std::isinf(ahead.ranges[2 * i + 1]));
        EXPECT_EQ(ahead.shapes[2 * i + 1], -1);
        EXPECT_NEAR(aside.ranges[i], 3 - 0.1 * double(i), 1e-12);
    }
    const Cast near = cast(copies, 1, 1, dBatchRaysOfWorld, {}, {1, 0, 0}, 2);
    EXPECT_TRUE(std::isinf(near.ranges[0]));
    dRobotModelDestroy(model);
}

// The same landscape under each copy, shifted: balls fall onto it where it is there, and rays meet it.
TEST(BatchRays, and_contacts_meet_the_terrain_of_their_copy)
{
    const dRobotModelID model = model_of(
        R"(<mujoco><asset><hfield name="hills" nrow="2" ncol="3" size="8 8 2 1" elevation="0 0 1 0 0 1"/></asset><worldbody>
<geom type="hfield" hfield="hills"/><body pos="-4 0 1.1"><freejoint/><geom size=".1" mass="1"/></body></worldbody></mujoco>)");
    Copies<double> copies(model, 4, dReal(0.002));
    // Flat at x below 0, from there on a slope of 2 in 8.
    const double shift[] = {0, 0, 0, 0, 0, -0.5, -8, 0, 0, 2, 3, 0.25};
    EXPECT_EQ(dBatchWriteParameter(copies.id, dBatchTerrain, 0, 4, shift), 1);
    const Cast down = cast(copies, 4, 1, dBatchRaysUpright, {}, {0, 0, -1});
    const double ground[] = {0, -0.5, 1, 0.25};
    for (size_t i = 0; i < 4; ++i) EXPECT_NEAR(down.ranges[i], 1.1 - ground[i], 1e-9) << i;
    copies.write_one(dBatchPositions, 2, {-4, 0, 1.5, 1, 0, 0, 0});
    dBatchStep(copies.id, 1000);
    const auto q = copies.read(dBatchPositions);
    for (const size_t i : {0, 1, 3}) EXPECT_NEAR(q[7 * i + 2], ground[i] + 0.1, 1e-3) << i;
    EXPECT_LT(q[14], -4.1);  // down its slope
    dRobotModelDestroy(model);
}

// From every link of a walker in any pose: what dRobotCastRays measures in a world of its own.
TEST(BatchRays, measure_as_in_worlds)
{
    dInitODE2(0);
    const dRobotModelID model = model_of(kWalker);
    Dice dice(5);
    constexpr int kRays = 40, kCopies = 9;
    const std::vector<dReal> directions = reals_of(dice.many(3 * kRays, -1, 1));
    // Not where links begin, which is on their parents' surfaces.
    const dReal frame[7] = {dReal(0.013), dReal(0.021), dReal(0.017), 1, 0, 0, 0};
    std::vector<dReal> origins;
    for (int i = 0; i < kRays; ++i) origins.insert(origins.end(), frame, frame + 3);
    Copies<double> copies(model, kCopies, dReal(0.002), 0, 3);
    std::vector<double> all;
    for (int i = 0; i < kCopies; ++i)
        for (const double x : any_positions(model, dice)) all.push_back(x);
    copies.write(dBatchPositions, all);
    const dWorldID world = dWorldCreate();
    const dSpaceID space = dSimpleSpaceCreate(nullptr);
    const dRobotID robot = dRobotCreate(world, space, model, nullptr, nullptr);
    const int links = dRobotModelGetLinks(model, nullptr, 0), positions = dRobotModelGetNumPositions(model);
    int hits = 0;
    for (int link = 0; link < links; ++link) {
        const Cast got = cast(copies, kCopies, link, dBatchRaysOfLink, origins, directions);
        for (int i = 0; i < kCopies; ++i) {
            const std::vector<double> its(all.begin() + i * positions, all.begin() + (i + 1) * positions);
            dRobotSetPositions(robot, reals_of(its).data(), positions);
            std::vector<dReal> want(kRays);
            hits += dRobotCastRays(robot, link, frame, space, kRays, directions.data(), dInfinity,
                                   want.data(), nullptr);
            for (int k = 0; k < kRays; ++k) {
                const double range = got.ranges[size_t(i * kRays + k)], wanted = double(want[size_t(k)]);
                EXPECT_TRUE(range == wanted || std::fabs(range - wanted) < (sizeof(dReal) == 8 ? 1e-9 : 1e-4))
                    << link << " " << i << " " << k << ": " << range << " " << wanted;
            }
        }
    }
    EXPECT_GT(hits, 1000);
    dRobotDestroy(robot), dSpaceDestroy(space), dWorldDestroy(world), dRobotModelDestroy(model);
    dCloseODE();
}

TEST(BatchRays, are_refused_where_they_cannot_be)
{
    dSetMessageHandler([](int, const char*, va_list) {});
    const dRobotModelID model = model_of(kWalker);
    Copies<float> copies(model, 2, dReal(0.004));
    const dReal good[3] = {0, 0, -1}, none[3] = {0, 0, 0};
    std::vector<float> ranges(2, 7);
    EXPECT_EQ(dBatchCastRays(copies.id, 99, 0, 1, nullptr, good, 1, 0, 2, ranges.data(), nullptr), 0);
    EXPECT_EQ(dBatchCastRays(copies.id, 1, 3, 1, nullptr, good, 1, 0, 2, ranges.data(), nullptr), 0);
    EXPECT_EQ(dBatchCastRays(copies.id, 1, 0, 1, nullptr, none, 1, 0, 2, ranges.data(), nullptr), 0);
    EXPECT_EQ(dBatchCastRays(copies.id, 1, 0, 1, nullptr, good, -1, 0, 2, ranges.data(), nullptr), 0);
    EXPECT_EQ(dBatchCastRays(copies.id, 1, 0, 1, nullptr, good, 1, 1, 2, ranges.data(), nullptr), 0);
    EXPECT_EQ(dBatchCastRays(copies.id, 1, 0, 1, nullptr, good, 1, 0, 2, nullptr, nullptr), 0);
    EXPECT_EQ(ranges, (std::vector<float>{7, 7}));
    EXPECT_EQ(dBatchCastRays(copies.id, 1, 0, 1, nullptr, good, 1, 0, 2, ranges.data(), nullptr), 1);
    EXPECT_EQ(ranges[0], ranges[1]);
    dSetMessageHandler(nullptr);
    dRobotModelDestroy(model);
}

}  // namespace
}  // namespace epode::tests
