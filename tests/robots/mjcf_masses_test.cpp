// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Masses of MJCF's geoms and meshes: sizes of fromto, shells, hulls, meshes in a frame of their own, bounds of inertias. MuJoCo
// 4.0 compiles the same values.
#include <gtest/gtest.h>
#include <ode/ode.h>

#include <string>

#include "robots/load.h"

using namespace epode::robots;

namespace {

Link link_of(const std::string& inside, const std::string& before = "")
{
    const RobotModel model = load_robot_text(
        "robot.xml",
        "<mujoco>" + before + "<worldbody><body><freejoint/>" + inside + "</body></worldbody></mujoco>", {});
    EXPECT_FALSE(model.has_errors()) << (model.report.empty() ? "" : model.report[0].text);
    return model.links.size() > 1 ? model.links[1] : Link{};
}

std::string geom(const std::string& type, double x, double y, double z, const std::string& more)
{
    return "<geom type='" + type + "' size='" + std::to_string(x) + " " + std::to_string(y) + " " +
           std::to_string(z) + "' " + more + "/>";
}

void expect_moments(const Link& link, double x, double y, double z, double tolerance)
{
    EXPECT_NEAR(link.inertia[0][0], x, tolerance);
    EXPECT_NEAR(link.inertia[1][1], y, tolerance);
    EXPECT_NEAR(link.inertia[2][2], z, tolerance);
}

TEST(MjcfMasses, across_fromto_a_shape_has_its_first_size)
{
    const std::string ends = " size='0.1 0.2' fromto='0 0 0 0 0 0.6'";
    EXPECT_NEAR(link_of("<geom type='box'" + ends + "/>").mass, 8000 * 0.1 * 0.1 * 0.3, 1e-9);
    EXPECT_NEAR(link_of("<geom type='ellipsoid'" + ends + "/>").mass, 4000 * kPi / 3 * 0.1 * 0.1 * 0.3, 1e-9);
    EXPECT_NEAR(link_of("<geom type='cylinder'" + ends + "/>").mass, 2000 * kPi * 0.1 * 0.1 * 0.3, 1e-9);
}

// A shell is what a solid gains by growing: its surface moves out by e.
TEST(MjcfMasses, a_shell_is_what_a_solid_gains)
{
    const double e = 1e-4;
    const struct {
        const char* type;
        double x, y, z;     // sizes
        double dx, dy, dz;  // growth
    } cases[] = {{"sphere", 0.2, 0, 0, e, 0, 0},
                 {"box", 0.1, 0.2, 0.3, e, e, e},
                 {"cylinder", 0.1, 0.2, 0, e, e, 0},
                 {"capsule", 0.1, 0.2, 0, e, 0, 0},
                 {"ellipsoid", 0.1, 0.2, 0.3, e, e, e}};
    for (const auto& c : cases) {
        SCOPED_TRACE(c.type);
        const Link shell = link_of(geom(c.type, c.x, c.y, c.z, "shellinertia='true' density='1'"));
        const Link more = link_of(geom(c.type, c.x + c.dx, c.y + c.dy, c.z + c.dz, "density='1'"));
        const Link less = link_of(geom(c.type, c.x - c.dx, c.y - c.dy, c.z - c.dz, "density='1'"));
        const double gained = (more.mass - less.mass) / (2 * e);
        // An ellipsoid's growth is not even; its area by quadrature is 0.48882.
        const bool is_even = std::string(c.type) != "ellipsoid";
        EXPECT_NEAR(shell.mass, is_even ? gained : 0.48882, is_even ? 1e-5 * gained : 0.011 * 0.48882);
        const double share = shell.mass / gained / (2 * e);
        expect_moments(shell, share * (more.inertia[0][0] - less.inertia[0][0]),
                       share * (more.inertia[1][1] - less.inertia[1][1]),
                       share * (more.inertia[2][2] - less.inertia[2][2]), 1e-5 * shell.mass);
    }
}

// Hulls are made in the library's numbers.
constexpr double kOfHulls = sizeof(dReal) == 8 ? 1e-9 : 1e-3;

const std::string kBox =
    "vertex='-.1 -.2 -.3  .1 -.2 -.3  -.1 .2 -.3  .1 .2 -.3  -.1 -.2 .3  .1 -.2 .3  -.1 .2 .3  .1 .2 .3'";

TEST(MjcfMasses, a_mesh_may_be_a_shell)
{
    const Link box = link_of(geom("box", 0.1, 0.2, 0.3, "shellinertia='true'"));
    const Link mesh = link_of("<geom type='mesh' mesh='m'/>",
                              "<asset><mesh name='m' inertia='shell' " + kBox + "/></asset>");
    EXPECT_NEAR(box.mass, 880, 1e-9);
    EXPECT_NEAR(mesh.mass, box.mass, kOfHulls);
    expect_moments(mesh, box.inertia[0][0], box.inertia[1][1], box.inertia[2][2], kOfHulls);
}

// Two tetrahedra of 1/6 m^3 in one mesh; the hull of both is a pyramid over a square with the diagonals 2.
TEST(MjcfMasses, a_convex_mesh_is_its_hull)
{
    const std::string two =
        "vertex='0 0 0 1 0 0 0 1 0 0 0 1 -1 0 0 0 -1 0' "
        "face='0 2 1 0 1 3 0 3 2 1 2 3  0 5 4 0 4 3 0 3 5 4 5 3'";
    const auto mass = [&](const std::string& inertia) {
        return link_of("<geom type='mesh' mesh='m' density='1'/>",
                       "<asset><mesh name='m' inertia='" + inertia + "' " + two + "/></asset>")
            .mass;
    };
    EXPECT_NEAR(mass("exact"), 1.0 / 3, 1e-12);
    EXPECT_NEAR(mass("convex"), 2.0 / 3, 1e-12);
}

// A vertex v becomes S R^T (v - p).
TEST(MjcfMasses, a_mesh_is_scaled_in_its_own_frame)
{
    const auto at = [](const std::string& more) {
        return link_of("<geom type='mesh' mesh='m'/>",
                       "<asset><mesh name='m' vertex='0 0 0 4 0 0 0 4 0 0 0 4' " + more + "/></asset>");
    };
    Vec centre = at("refpos='.1 .2 .3' scale='1 -2 .5'").centre;
    EXPECT_NEAR(centre.x, 0.9, 1e-12);
    EXPECT_NEAR(centre.y, -1.6, 1e-12);
    EXPECT_NEAR(centre.z, 0.35, 1e-12);
    for (const bool uniform : {true, false}) {  // R^T (x, y, z) = (x, z, -y)
        SCOPED_TRACE(uniform);
        const Link link = at(std::string("refpos='.1 .2 .3' refquat='1 1 0 0' scale='") +
                             (uniform ? "2 2 2'" : "1 -2 .5'"));
        EXPECT_NEAR(link.centre.x, uniform ? 1.8 : 0.9, 1e-12);
        EXPECT_NEAR(link.centre.y, uniform ? 1.4 : -1.4, 1e-12);
        EXPECT_NEAR(link.centre.z, uniform ? -1.6 : -0.4, 1e-12);
        EXPECT_NEAR(link.mass, 1000 * 64.0 / 6 * (uniform ? 8 : 1), 1e-8);
    }
}

TEST(MjcfMasses, a_bound_raises_each_moment_and_comes_before_the_balance)
{
    const auto with = [](const std::string& moments, const std::string& compiler) {
        return link_of("<inertial pos='0 0 0' mass='2' diaginertia='" + moments + "'/>",
                       "<compiler " + compiler + "/>");
    };
    expect_moments(with("0.1 0.12 0.15", "boundinertia='0.13'"), 0.13, 0.13, 0.15, 1e-15);
    expect_moments(with("0.05 0.01 0.02", "boundinertia='0.03' balanceinertia='true'"), 0.05, 0.03, 0.03,
                   1e-15);
    const Link turned = link_of("<inertial pos='0 0 0' mass='2' euler='0 0 90' diaginertia='0.1 0.12 0.15'/>",
                                "<compiler boundinertia='0.11'/>");
    expect_moments(turned, 0.12, 0.11, 0.15, 1e-15);
}

}  // namespace
