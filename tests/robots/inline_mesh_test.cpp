// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// MJCF: meshes whose vertices stand in the file, also as several hulls; equalities of tendons; contacts switched off; bodies
// that gravity does not pull.
#include <gtest/gtest.h>
#include <ode/ode.h>

#include "robots/build.h"
#include "robots/constraints.h"
#include "robots/load.h"
#include "robots/write/write.h"

using namespace epode::robots;

namespace {

// An L: 4 long, 3 high, plates 1 thick, 2 deep; its volume is 12, its hull's 16.5 less than a box's 24.
const std::string kBracket =
    "vertex='1 1 0  1 3 0  0 3 0  0 0 0  4 0 0  4 1 0  1 1 2  1 3 2  0 3 2  0 0 2  4 0 2  4 1 2' face='";

std::string bracket_faces()
{
    std::string out;
    const auto add = [&](int a, int b, int c) {
        out += std::to_string(a) + " " + std::to_string(b) + " " + std::to_string(c) + "  ";
    };
    for (int i = 0; i < 6; ++i) {
        const int next = (i + 1) % 6;
        add(i, next, 6 + next), add(i, 6 + next, 6 + i);
    }
    for (int i = 1; i < 5; ++i) add(0, i + 1, i), add(6, 6 + i, 6 + i + 1);
    return out + "'";
}

std::string with_mesh(const std::string& attributes)
{
    return "<mujoco><asset><mesh name='m' inertia='exact' " + attributes +
           "/></asset><worldbody><body name='b'><freejoint/><geom type='mesh' mesh='m' "
           "density='10'/></body></worldbody></mujoco>";
}

RobotModel read(const std::string& text, const LoadOptions& options = {})
{
    return load_robot_text("robot.xml", text, options);
}

TEST(InlineMesh, has_the_mass_of_its_solid)
{
    const RobotModel model = read(with_mesh(kBracket + bracket_faces()));
    ASSERT_FALSE(model.has_errors()) << model.report[0].text;
    EXPECT_NEAR(model.links[1].mass, 120, 1e-9);
    EXPECT_NEAR(model.links[1].centre.x, (60 * 0.5 + 60 * 2.5) / 120, 1e-9);  // of the plates 1 x 3 and 3 x 1
    EXPECT_NEAR(model.links[1].centre.z, 1, 1e-9);
}

TEST(InlineMesh, without_faces_is_the_hull_of_its_vertices)
{
    const RobotModel model = read(with_mesh("vertex='0 0 0 1 0 0 0 1 0 0 0 1 0.1 0.1 0.1' scale='2 1 -1'"));
    ASSERT_FALSE(model.has_errors());
    EXPECT_NEAR(model.links[1].mass, 10 * 2 / 6.0, 1e-5);
    EXPECT_EQ(model.meshes[0].vertices.size(), 4u);
}

TEST(InlineMesh, is_written_and_read_again)
{
    const RobotModel model = read(with_mesh(kBracket + bracket_faces()));
    const RobotModel again = read(write_mjcf(model, ".").text);
    ASSERT_FALSE(again.has_errors());
    EXPECT_EQ(again.meshes[0].triangles, model.meshes[0].triangles);
    EXPECT_NEAR(again.links[1].mass, 120, 1e-9);
    EXPECT_TRUE(read(with_mesh("vertex='0 0 0 1 0 0 0 1 0 0 0 1'")).report.empty());
}

TEST(InlineMesh, what_is_no_mesh_is_an_error_with_its_name)
{
    const std::pair<const char*, const char*> broken[] = {
        {"vertex='0 0 0 1 0 0 0 1 0'", "vertex"},
        {"vertex='0 0 0 1 0 0 0 1 0 0 0 1 2'", "other than three numbers"},
        {"vertex='0 0 0 1 0 0 0 1 0 1 1 0'", "in one plane"},
        {"vertex='0 0 0 1 0 0 0 1 0 0 0 1' face='0 1 4'", "no vertex"},
        {"vertex='0 0 0 1 0 0 0 1 0 0 0 1' face='0 1 1.5'", "no vertex"},
        {"vertex='0 0 0 1 0 0 0 1 0 0 0 1' face='0 1 -1'", "no vertex"},
        {"vertex='0 0 0 1 0 0 0 1 0 0 0 nan' face='0 1 2'", "vertex"},
        {"", "no file and no vertices"}};
    for (const auto& [attributes, text] : broken) {
        const RobotModel model = read(with_mesh(attributes));
        ASSERT_TRUE(model.has_errors()) << attributes;
        EXPECT_NE(model.report[0].text.find(text), std::string::npos) << model.report[0].text;
    }
}

TEST(InlineMesh, collides_as_one_hull_or_as_its_parts)
{
    dInitODE2(0);
    const auto count = [](const LoadOptions& options) {
        const dWorldID world = dWorldCreate();
        const dSpaceID space = dHashSpaceCreate(nullptr);
        size_t geoms = 0;
        {
            const Robot robot(
                std::make_shared<const Prepared>(read(with_mesh(kBracket + bracket_faces()), options)), world,
                space, {}, {});
            geoms = robot.geoms().size();
        }
        dSpaceDestroy(space);
        dWorldDestroy(world);
        return geoms;
    };
    LoadOptions parts;
    parts.meshes_as_parts = true;
    EXPECT_EQ(count({}), 1u);
    EXPECT_EQ(count(parts), 2u);
    parts.parts.max_parts = 1;
    EXPECT_EQ(count(parts), 1u);
    dCloseODE();
}

TEST(Mjcf, contacts_switched_off_leave_looks)
{
    const RobotModel model = read(
        "<mujoco><option><flag contact='disable'/></option><worldbody><body><freejoint/><geom "
        "size='0.1'/></body></worldbody></mujoco>");
    EXPECT_TRUE(model.links[1].shapes.empty());
    EXPECT_EQ(model.links[1].visuals.size(), 1u);
    EXPECT_GT(model.links[1].mass, 0);
}

// L1 - L1_0 = c0 + c1 (L2 - L2_0), with lengths that are sums of coordinates.
TEST(Mjcf, an_equality_of_tendons_is_a_coupling)
{
    const RobotModel model = read(
        "<mujoco><compiler angle='radian'/><worldbody>"
        "<body><joint name='a' type='slide' ref='0.2'/><geom size='0.1'/><body><joint name='b'/><geom "
        "size='0.1' pos='1 0 0'/>"
        "<body><joint name='c'/><geom size='0.1' pos='1 0 0'/></body></body></body></worldbody>"
        "<tendon><fixed name='s'><joint joint='a' coef='2'/><joint joint='b' coef='1'/></fixed>"
        "<fixed name='t'><joint joint='c' coef='3'/></fixed></tendon>"
        "<equality><tendon tendon1='s' tendon2='t' polycoef='0.1 0.5 0 0 0'/></equality></mujoco>");
    ASSERT_FALSE(model.has_errors());
    ASSERT_EQ(model.couplings.size(), 1u);
    // 2 (a - 0.2) + b = 0.1 + 0.5 * 3 c
    const double b = 0.3, c = -0.4, a = 0.2 + (0.1 + 1.5 * c - b) / 2;
    EXPECT_NEAR(constraint_errors(model, {a, b, c})[0], 0, 1e-12);
    EXPECT_NEAR(constraint_errors(model, {a + 1, b, c})[0], 2, 1e-12);
    EXPECT_TRUE(model.report.empty());
}

TEST(Mjcf, full_gravity_compensation_is_no_gravity)
{
    const auto gravcomp = [](const char* share) {
        return read(std::string("<mujoco><worldbody><body gravcomp='") + share +
                    "'><freejoint/><geom size='0.1'/></body></worldbody></mujoco>");
    };
    EXPECT_TRUE(gravcomp("1").links[1].is_weightless);
    EXPECT_TRUE(gravcomp("1").report.empty());
    EXPECT_FALSE(gravcomp("0.5").links[1].is_weightless);
    EXPECT_EQ(gravcomp("0.5").report.size(), 1u);
    EXPECT_FALSE(gravcomp("0").links[1].is_weightless);
}

}  // namespace
