// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Inertia of solids against sums over a fine grid of points, and of meshes against the closed forms.
#include "geometry/inertia.h"

#include <gtest/gtest.h>

#include <functional>

#include "../math/random_numbers.h"

namespace epode {
namespace {

// Unit density, by midpoints of a grid over the cube [-h, h]^3.
MassProperties sampled(double h, const std::function<bool(double, double, double)>& inside)
{
    constexpr int kCells = 160;
    const double cell = 2 * h / kCells;
    double m = 0, xx = 0, yy = 0, zz = 0;
    for (int i = 0; i < kCells; ++i)
        for (int j = 0; j < kCells; ++j)
            for (int k = 0; k < kCells; ++k) {
                const double x = -h + (i + 0.5) * cell, y = -h + (j + 0.5) * cell, z = -h + (k + 0.5) * cell;
                if (!inside(x, y, z)) continue;
                m += 1, xx += x * x, yy += y * y, zz += z * z;
            }
    const double v = cell * cell * cell;
    return {Real(m * v), {}, {Real((yy + zz) * v), Real((xx + zz) * v), Real((xx + yy) * v), 0, 0, 0}};
}

void expect_close(const MassProperties& a, const MassProperties& b, Real relative)
{
    EXPECT_NEAR(a.mass, b.mass, relative * std::fabs(b.mass));
    const Real size = b.inertia.xx + b.inertia.yy + b.inertia.zz;
    EXPECT_NEAR(a.inertia.xx, b.inertia.xx, relative * size);
    EXPECT_NEAR(a.inertia.yy, b.inertia.yy, relative * size);
    EXPECT_NEAR(a.inertia.zz, b.inertia.zz, relative * size);
    EXPECT_NEAR(a.inertia.xy, b.inertia.xy, relative * size);
    EXPECT_NEAR(a.inertia.xz, b.inertia.xz, relative * size);
    EXPECT_NEAR(a.inertia.yz, b.inertia.yz, relative * size);
    EXPECT_NEAR(length(a.center - b.center), 0, relative * (1 + length(b.center)));
}

constexpr Real kGrid = Real(4e-3);  // what 160 cells resolve
constexpr Real kTight = 200 * kEpsilon;

TEST(Inertia, sphere_and_box_agree_with_sums_over_points)
{
    expect_close(solid_sphere(sphere_volume(Real(0.9)), Real(0.9)),
                 sampled(1, [](double x, double y, double z) { return x * x + y * y + z * z < 0.81; }),
                 kGrid);
    const Vec3 sides = {Real(0.75), Real(1.25), 2};  // on the grid's lines
    expect_close(
        solid_box(box_volume(sides), sides),
        sampled(1, [](double x, double y, double) { return std::fabs(x) < 0.375 && std::fabs(y) < 0.625; }),
        kGrid);
}

TEST(Inertia, round_bars_agree_with_sums_over_points_along_every_axis)
{
    const double r = 0.4, l = 1.1;
    for (int axis = 0; axis < 3; ++axis) {
        const auto split = [axis](double x, double y, double z, double& along) {
            along = std::fabs(axis == 0 ? x : axis == 1 ? y : z);
            return x * x + y * y + z * z - along * along;
        };
        expect_close(solid_cylinder(cylinder_volume(Real(r), Real(l)), axis, Real(r), Real(l)),
                     sampled(1,
                             [&](double x, double y, double z) {
                                 double along;
                                 return split(x, y, z, along) < r * r && along < l / 2;
                             }),
                     3 * kGrid);
        expect_close(solid_capsule(capsule_volume(Real(r), Real(l)), axis, Real(r), Real(l)),
                     sampled(1,
                             [&](double x, double y, double z) {
                                 double along;
                                 const double off = split(x, y, z, along), beyond = along - l / 2;
                                 return beyond < 0 ? off < r * r : off + beyond * beyond < r * r;
                             }),
                     kGrid);
    }
}

TEST(Inertia, a_capsule_without_length_is_a_sphere)
{
    expect_close(solid_capsule(3, 2, Real(0.5), 0), solid_sphere(3, Real(0.5)), kTight);
}

TEST(Inertia, translation_follows_steiner_and_comes_back)
{
    RandomNumbers random(1);
    for (int i = 0; i < 500; ++i) {
        const MassProperties box = rotated(solid_box(2, {1, 2, 3}), to_matrix(random.rotation()));
        const Vec3 a = Real(3) * random.vec();
        const MassProperties moved = translated(box, a);
        EXPECT_NEAR(moved.inertia.xx, box.inertia.xx + 2 * (a.y * a.y + a.z * a.z), kTight * 10);
        EXPECT_NEAR(moved.inertia.yz, box.inertia.yz - 2 * a.y * a.z, kTight * 10);
        expect_close(translated(moved, -a), box, kTight * 10);
    }
}

TEST(Inertia, kinetic_energy_does_not_depend_on_the_frame)
{
    RandomNumbers random(2);
    for (int i = 0; i < 500; ++i) {
        const MassProperties p = translated(solid_box(2, {1, 2, 3}), random.vec());
        const Mat3 R = to_matrix(random.rotation());
        const Vec3 w = random.vec();
        EXPECT_NEAR(dot(w, p.inertia * w), dot(R * w, rotated(p, R).inertia * (R * w)), kTight * 10);
    }
}

TEST(Inertia, two_half_boxes_make_a_whole_one)
{
    const MassProperties half = solid_box(1, {1, 2, 3});
    const MassProperties whole =
        united(translated(half, {Real(-0.5), 0, 0}), translated(half, {Real(0.5), 0, 0}));
    expect_close(whole, solid_box(2, {2, 2, 3}), kTight);
}

TEST(Inertia, uniting_with_nothing_changes_nothing)
{
    const MassProperties p = translated(solid_sphere(2, 1), {1, 2, 3});
    expect_close(united({}, p), p, kTight);
    expect_close(united(p, {}), p, kTight);
    const MassProperties nothing = united({}, {});
    EXPECT_TRUE(usable(nothing));
    EXPECT_EQ(nothing.mass, 0);
    EXPECT_FALSE(usable(united(p, with_mass(p, -2)))) << "zero mass with a moment has no centre";
}

TEST(Inertia, faults_have_their_own_messages)
{
    EXPECT_EQ(mass_fault(solid_sphere(1, 1)), MassFault::kNone);
    EXPECT_EQ(mass_fault(translated(solid_box(1, {1, 2, 3}), {5, -6, 7})), MassFault::kNone);
    EXPECT_EQ(mass_fault(solid_sphere(0, 1)), MassFault::kMass);
    EXPECT_EQ(mass_fault(solid_sphere(-1, 1)), MassFault::kMass);
    EXPECT_EQ(mass_fault({1, {}, {1, 1, 1, 2, 0, 0}}), MassFault::kInertia);
    EXPECT_EQ(mass_fault({1, {1, 0, 0}, {1, 1, 1, 0, 0, 0}}), MassFault::kCenter);
}

// The surface of an axis-parallel box as 12 triangles, turned and moved.
MeshMoments box_mesh(Vec3 sides, const Pose& pose, bool inside_out)
{
    MeshMoments mesh;
    for (int axis = 0; axis < 3; ++axis)
        for (int side : {-1, 1}) {
            Vec3 corner[4];
            for (int k = 0; k < 4; ++k) {
                const int u = k == 1 || k == 2 ? 1 : -1, v = k >= 2 ? 1 : -1;
                corner[k].set(axis, Real(0.5 * side) * sides[axis]);
                corner[k].set((axis + 1) % 3, Real(0.5 * u) * sides[(axis + 1) % 3]);
                corner[k].set((axis + 2) % 3, Real(0.5 * v) * sides[(axis + 2) % 3]);
                corner[k] = pose.to_world(corner[k]);
            }
            const bool flip = (side < 0) != inside_out;
            mesh.add_triangle(corner[0], corner[flip ? 2 : 1], corner[flip ? 1 : 2]);
            mesh.add_triangle(corner[0], corner[flip ? 3 : 2], corner[flip ? 2 : 3]);
        }
    return mesh;
}

TEST(MeshMoments, of_a_box_anywhere_are_the_closed_form)
{
    RandomNumbers random(3);
    for (int i = 0; i < 200; ++i) {
        const Vec3 sides = {random.in(Real(0.2), 3), random.in(Real(0.2), 3), random.in(Real(0.2), 3)};
        const Pose pose = {Real(5) * random.vec(), to_matrix(random.rotation())};
        const MeshMoments mesh = box_mesh(sides, pose, false);
        EXPECT_NEAR(mesh.volume(), box_volume(sides), kTight * box_volume(sides) + kTight);
        const MassProperties box = solid_box(7 * box_volume(sides), sides);
        expect_close(mesh.properties(7), translated(rotated(box, pose.R), pose.p), 20 * kTight);
        EXPECT_NEAR(box_mesh(sides, pose, true).volume(), -box_volume(sides), kTight * 30);
    }
}

TEST(MeshMoments, keep_the_inertia_of_a_small_mesh_far_away)
{
    // About the centre it must survive a shift of 1000 edge lengths; integrals about the origin would lose
    // it.
    const Vec3 far = {1000, -1000, 500};
    const MassProperties p =
        translated(box_mesh({1, 1, 1}, {far, Mat3::identity()}, false).properties(1), -far);
    EXPECT_NEAR(length(p.center), 0, 4000 * kEpsilon);
    EXPECT_NEAR(p.inertia.xx, Real(1.0 / 6), kSingle ? Real(2) : Real(1e-8));
    EXPECT_EQ(MeshMoments{}.properties(1).mass, 0);
}

}  // namespace
}  // namespace epode
