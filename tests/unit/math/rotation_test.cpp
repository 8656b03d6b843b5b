// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Identities of vectors, matrices, quaternions and poses over random arguments.
#include "math/rotation.h"

#include <gtest/gtest.h>

#include "math/cholesky.h"
#include "random_numbers.h"

namespace epode {
namespace {

constexpr Real kTight = 16 * kEpsilon;
constexpr int kRounds = 2000;

void expect_near(Vec3 a, Vec3 b, Real tolerance)
{
    EXPECT_NEAR(a.x, b.x, tolerance);
    EXPECT_NEAR(a.y, b.y, tolerance);
    EXPECT_NEAR(a.z, b.z, tolerance);
}

void expect_near(const Mat3& a, const Mat3& b, Real tolerance)
{
    expect_near(a.row0, b.row0, tolerance);
    expect_near(a.row1, b.row1, tolerance);
    expect_near(a.row2, b.row2, tolerance);
}

void expect_rotation(const Mat3& R)
{
    expect_near(R * transpose(R), Mat3::identity(), kTight);
    EXPECT_NEAR(determinant(R), 1, kTight);
}

TEST(Vec, cross_and_dot_obey_lagrange)
{
    RandomNumbers random(1);
    for (int i = 0; i < kRounds; ++i) {
        const Vec3 a = random.vec(), b = random.vec(), c = random.vec();
        EXPECT_NEAR(dot(cross(a, b), a), 0, kTight);
        EXPECT_NEAR(length2(cross(a, b)), length2(a) * length2(b) - dot(a, b) * dot(a, b), kTight);
        expect_near(cross(a, cross(b, c)), dot(a, c) * b - dot(a, b) * c, kTight);
        expect_near(skew(a) * b, cross(a, b), kTight);
    }
}

TEST(Vec, normalize_keeps_the_direction_at_any_size)
{
    RandomNumbers random(2);
    for (int i = 0; i < kRounds; ++i) {
        const Vec3 u = random.direction();
        Vec3 v = random.signed_power(kSingle ? 36 : 300) * u;
        const Real sign = dot(u, v) < 0 ? Real(-1) : Real(1);
        ASSERT_TRUE(normalize(v));
        expect_near(v, sign * u, kTight);
    }
    Vec3 zero, infinite = {1, kInf, 0};
    EXPECT_FALSE(normalize(zero));
    EXPECT_FALSE(normalize(infinite));
    EXPECT_EQ(infinite, (Vec3{1, kInf, 0}));
    EXPECT_EQ(zero, Vec3{});
}

TEST(Vec, normalize_refuses_a_nan_in_any_place_and_changes_nothing)
{
    const Real nan = std::numeric_limits<Real>::quiet_NaN();
    for (int i = 0; i < 4; ++i) {
        Real numbers[4] = {1, 2, 3, 4};
        numbers[i] = nan;
        Quat q = load_quat(numbers);
        EXPECT_FALSE(normalize(q));
        EXPECT_EQ(i == 3 ? q.w : q.z, i == 3 ? 1 : 4);
        if (i == 3) continue;
        Vec3 v = load(numbers);
        EXPECT_FALSE(normalize(v));
        EXPECT_EQ(i == 2 ? v.x : v.z, i == 2 ? 1 : 3);
    }
}

TEST(Vec, plane_space_completes_a_right_handed_frame)
{
    RandomNumbers random(3);
    for (int i = 0; i < kRounds; ++i) {
        const Vec3 n = random.direction();
        Vec3 p, q;
        plane_space(n, p, q);
        expect_rotation(from_columns(n, p, q));
        EXPECT_EQ(std::fabs(n.z) > Real(0.70710678) ? p.x : p.z, 0) << "ODE's choice of the first tangent";
    }
}

TEST(Mat, inverse_and_transpose)
{
    RandomNumbers random(4);
    for (int i = 0; i < kRounds; ++i) {
        const Mat3 m = {random.vec(), random.vec(), random.vec()};
        Mat3 inverse;
        ASSERT_TRUE(invert(m, inverse));
        if (std::fabs(determinant(m)) > Real(0.1)) {
            expect_near(m * inverse, Mat3::identity(), 100 * kTight);
        }
        const Vec3 v = random.vec();
        expect_near(transposed_times(m, v), transpose(m) * v, kTight);
    }
    Mat3 out;
    EXPECT_FALSE(invert(Mat3{{1, 2, 3}, {2, 4, 6}, {0, 0, 1}}, out));
}

TEST(Mat, a_rotated_tensor_is_r_s_rt)
{
    RandomNumbers random(5);
    for (int i = 0; i < kRounds; ++i) {
        const Mat3 R = to_matrix(random.rotation());
        const Sym3 s = {random.in(-1, 1), random.in(-1, 1), random.in(-1, 1),
                        random.in(-1, 1), random.in(-1, 1), random.in(-1, 1)};
        expect_near(full(rotate(R, s)), R * full(s) * transpose(R), kTight);
        const Vec3 v = random.vec();
        expect_near(s * v, full(s) * v, kTight);
    }
}

TEST(Quat, products_and_matrices_agree)
{
    RandomNumbers random(6);
    for (int i = 0; i < kRounds; ++i) {
        const Quat a = random.rotation(), b = random.rotation();
        expect_rotation(to_matrix(a));
        expect_near(to_matrix(a * b), to_matrix(a) * to_matrix(b), kTight);
        expect_near(to_matrix(conjugate(a)), transpose(to_matrix(a)), kTight);
    }
}

TEST(Quat, comes_back_from_its_matrix_in_every_branch)
{
    RandomNumbers random(7);
    int branch[4] = {};
    for (int i = 0; i < kRounds; ++i) {
        Quat q = random.rotation();
        const Mat3 R = to_matrix(q);
        const Quat back = to_quat(R);
        if (q.w * back.w + dot(q.vec(), back.vec()) < 0) q = {-q.w, -q.x, -q.y, -q.z};
        EXPECT_NEAR(back.w, q.w, kTight);
        expect_near(back.vec(), q.vec(), kTight);
        const Vec3 diagonal = {R.row0.x, R.row1.y, R.row2.z};
        const Real trace = diagonal.x + diagonal.y + diagonal.z;
        ++branch[trace >= 0                              ? 3
                 : diagonal.x == max_component(diagonal) ? 0
                 : diagonal.y == max_component(diagonal) ? 1
                                                         : 2];
    }
    for (int count : branch) EXPECT_GT(count, 100);
}

TEST(Pose, to_local_undoes_to_world_and_poses_compose)
{
    RandomNumbers random(8);
    for (int i = 0; i < kRounds; ++i) {
        const Pose a = {random.vec(), to_matrix(random.rotation())};
        const Pose b = {random.vec(), to_matrix(random.rotation())};
        const Vec3 x = random.vec();
        expect_near(a.to_local(a.to_world(x)), x, kTight);
        expect_near((a * b).to_world(x), a.to_world(b.to_world(x)), kTight);
        expect_near(inverse_times(a, b).to_world(x), a.to_local(b.to_world(x)), kTight);
    }
}

TEST(Rotation, about_an_axis_leaves_it_and_turns_the_rest_by_the_angle)
{
    RandomNumbers random(9);
    for (int i = 0; i < kRounds; ++i) {
        const Vec3 n = random.direction();
        const Real angle = random.in(-6, 6);
        const Mat3 R = to_matrix(rotation_about(random.in(Real(0.1), 50) * n, angle));
        expect_rotation(R);
        expect_near(R * n, n, kTight);
        Vec3 p, q;
        plane_space(n, p, q);
        expect_near(R * p, std::cos(angle) * p + std::sin(angle) * q, 2 * kTight);
    }
    EXPECT_EQ(rotation_about({}, 1).w, 1);
}

TEST(Rotation, euler_angles_are_three_turns_about_the_axes)
{
    RandomNumbers random(10);
    for (int i = 0; i < kRounds; ++i) {
        const Real phi = random.in(-4, 4), theta = random.in(-4, 4), psi = random.in(-4, 4);
        const Mat3 X = to_matrix(rotation_about({1, 0, 0}, phi));
        const Mat3 Y = to_matrix(rotation_about({0, 1, 0}, theta));
        const Mat3 Z = to_matrix(rotation_about({0, 0, 1}, psi));
        expect_near(rotation_from_euler(phi, theta, psi), transpose(Z * Y * X), kTight);
    }
}

TEST(Rotation, from_axes_spans_their_plane)
{
    RandomNumbers random(11);
    for (int i = 0; i < kRounds; ++i) {
        const Vec3 a = random.direction(), b = random.direction();
        if (length(cross(a, b)) < Real(0.01)) continue;
        Mat3 R;
        ASSERT_TRUE(rotation_from_axes(random.in(1, 9) * a, random.in(1, 9) * b, R));
        expect_rotation(R);
        expect_near(R.column(0), a, kTight);
        EXPECT_GT(dot(R.column(1), b), 0);
        EXPECT_NEAR(dot(R.column(2), b), 0, kTight);
        ASSERT_TRUE(rotation_from_z_axis(Real(3) * a, R));
        expect_rotation(R);
        expect_near(R.column(2), a, kTight);
    }
}

TEST(Rotation, from_axes_refuses_what_spans_no_plane)
{
    const Mat3 before = {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}};
    Mat3 R = before;
    EXPECT_FALSE(rotation_from_axes({}, {1, 0, 0}, R));
    EXPECT_FALSE(rotation_from_axes({1, 0, 0}, {}, R));
    EXPECT_FALSE(rotation_from_axes({1, 2, 3}, {2, 4, 6}, R));
    EXPECT_FALSE(rotation_from_axes({Real(0.1), Real(0.2), Real(0.3)}, {-7, -14, -21}, R));
    EXPECT_FALSE(rotation_from_z_axis({}, R));
    expect_near(R, before, 0);
}

TEST(Rotation, orthonormalize_repairs_every_row_and_is_idempotent)
{
    RandomNumbers random(12);
    for (int i = 0; i < kRounds; ++i) {
        Mat3 m = {random.direction(), random.direction(), random.vec()};
        if (length(cross(m.row0, m.row1)) < Real(1e-3)) continue;
        const Vec3 first = m.row0, second = m.row1;
        ASSERT_TRUE(orthonormalize(m));
        expect_rotation(m);
        expect_near(m.row0, first, kTight);
        EXPECT_GT(dot(m.row1, second), 0);
        const Mat3 once = m;
        ASSERT_TRUE(orthonormalize(m));
        expect_near(m, once, 2 * kEpsilon);
    }
    Mat3 flat = {{1, 0, 0}, {2, 0, 0}, {0, 0, 1}};
    EXPECT_FALSE(orthonormalize(flat));
    EXPECT_EQ(flat.row1, (Vec3{2, 0, 0}));
}

TEST(Rotation, rate_matches_a_small_turn)
{
    RandomNumbers random(13);
    for (int i = 0; i < kRounds; ++i) {
        const Quat q = random.rotation();
        const Vec3 w = random.vec();
        const Real h = std::cbrt(kEpsilon);
        // Central difference of q(t) = rotation_about(w, |w| t) q.
        const Quat ahead = rotation_about(w, length(w) * h) * q,
                   behind = rotation_about(w, -length(w) * h) * q;
        const Quat rate = rate_of(q, w);
        EXPECT_NEAR((ahead.w - behind.w) / (2 * h), rate.w, 10 * h * h);
        expect_near((ahead.vec() - behind.vec()) / (2 * h), rate.vec(), 10 * h * h);
    }
}

TEST(Sym3, inverse_of_a_positive_tensor)
{
    RandomNumbers random(14);
    for (int i = 0; i < kRounds; ++i) {
        const Sym3 principal = {
            random.in(Real(0.1), 9), random.in(Real(0.1), 9), random.in(Real(0.1), 9), 0, 0, 0};
        const Sym3 s = rotate(to_matrix(random.rotation()), principal);
        Sym3 inverse;
        ASSERT_TRUE(invert_positive_definite(s, inverse));
        expect_near(full(s) * full(inverse), Mat3::identity(), 200 * kTight);
    }
    Sym3 untouched = {1, 2, 3, 4, 5, 6};
    EXPECT_FALSE(invert_positive_definite({1, 1, 1, 2, 0, 0}, untouched));
    EXPECT_EQ(untouched.yz, 6);
    EXPECT_FALSE(positive_definite({0, 1, 1, 0, 0, 0}));
    EXPECT_FALSE(positive_definite({1, 1, -1, 0, 0, 0}));
    EXPECT_FALSE(positive_definite({std::numeric_limits<Real>::quiet_NaN(), 1, 1, 0, 0, 0}));
}

}  // namespace
}  // namespace epode
