// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Rotation and vector functions through the public interface: ODE's layouts and conventions, overlapping
// arguments, refusals. The mathematics is tested in unit/math.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "message_recorder.h"

namespace {

constexpr dReal kNan = std::numeric_limits<dReal>::quiet_NaN();
constexpr dReal kInfinite = std::numeric_limits<dReal>::infinity();
constexpr dReal kTolerance = 16 * std::numeric_limits<dReal>::epsilon();

void expect_numbers(const dReal* got, std::initializer_list<double> expected)
{
    int i = 0;
    for (double x : expected) EXPECT_NEAR(got[i++], x, kTolerance) << "element " << i - 1;
}

TEST(RotationApi, layouts_and_the_right_hand_rule)
{
    dMatrix3 R;
    dRSetIdentity(R);
    expect_numbers(R, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0});
    dRFromAxisAndAngle(R, 0, 0, 2, 1);
    const double c = std::cos(1.0), s = std::sin(1.0);
    expect_numbers(R, {c, -s, 0, 0, s, c, 0, 0, 0, 0, 1, 0});
    dQuaternion q;
    dQSetIdentity(q);
    expect_numbers(q, {1, 0, 0, 0});
    dQFromAxisAndAngle(q, 0, 3, 0, 1);
    expect_numbers(q, {std::cos(0.5), 0, std::sin(0.5), 0});
    dQFromAxisAndAngle(q, 0, 0, 0, 1);
    expect_numbers(q, {1, 0, 0, 0});
    const dQuaternion unnormalised = {2, 0, 1, 0};
    dRfromQ(R, unnormalised);
    expect_numbers(R, {-1, 0, 4, 0, 0, 1, 0, 0, -4, 0, -1, 0});
}

TEST(RotationApi, euler_angles_and_frames_as_ode_defines_them)
{
    dMatrix3 R;
    dRFromEulerAngles(R, 1, 2, 3);
    const double c1 = std::cos(1.0), s1 = std::sin(1.0), c2 = std::cos(2.0), s2 = std::sin(2.0);
    EXPECT_NEAR(R[0], std::cos(3.0) * c2, kTolerance);
    EXPECT_NEAR(R[1], std::sin(3.0) * c2, kTolerance);
    EXPECT_NEAR(R[2], -s2, kTolerance);
    EXPECT_NEAR(R[6], c2 * s1, kTolerance);
    EXPECT_NEAR(R[10], c1 * c2, kTolerance);
    dRFrom2Axes(R, 2, 0, 0, 5, 3, 0);
    expect_numbers(R, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0});
    dRFromZAxis(R, 0, 0, -4);
    expect_numbers(R, {0, 1, 0, 0, 1, 0, 0, 0, 0, 0, -1, 0});
    const dVector3 z = {0, 0, 1};
    dVector3 p = {9, 9, 9, 9}, q = {9, 9, 9, 9};
    dPlaneSpace(z, p, q);
    expect_numbers(p, {0, -1, 0, 9});
    expect_numbers(q, {1, 0, 0, 9});
}

TEST(RotationApi, quaternion_products_conjugate_and_may_overlap)
{
    const dQuaternion b = {1, 2, 3, 4}, c = {5, 6, 7, 8};
    dQuaternion a;
    dQMultiply0(a, b, c);
    expect_numbers(a, {-60, 12, 30, 24});
    dQMultiply1(a, b, c);
    expect_numbers(a, {70, 0, -16, -8});
    dQMultiply2(a, b, c);
    expect_numbers(a, {70, 8, 0, 16});
    dQMultiply3(a, b, c);
    expect_numbers(a, {-60, -20, -14, -32});
    dQuaternion overlap = {1, 2, 3, 4};
    dQMultiply0(overlap, overlap, c);
    expect_numbers(overlap, {-60, 12, 30, 24});
    const dVector3 w = {1, 0, 0};
    dDQfromW(a, w, b);
    expect_numbers(a, {-1, 0.5, -2, 1.5});
}

TEST(RotationApi, quaternion_of_half_turns)
{
    dQuaternion q;
    const dMatrix3 about_y = {-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0};
    dQfromR(q, about_y);
    expect_numbers(q, {0, 0, 1, 0});
    const dMatrix3 about_z = {-1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1, 0};
    dQfromR(q, about_z);
    expect_numbers(q, {0, 0, 0, 1});
}

TEST(VectorApi, normalising_is_safe_at_both_ends_of_the_range)
{
    MessageRecorder messages;
    for (dReal size : {std::numeric_limits<dReal>::min(), dReal(1), std::numeric_limits<dReal>::max() / 8}) {
        dVector3 v = {3 * size, 0, 4 * size, 7};
        dNormalize3(v);
        expect_numbers(v, {0.6, 0, 0.8, 7});
        dVector4 u = {0, -3 * size, 0, 4 * size};
        EXPECT_EQ(dSafeNormalize4(u), 1);
        expect_numbers(u, {0, -0.6, 0, 0.8});
    }
    EXPECT_EQ(messages.take(), "");
}

TEST(VectorApi, what_has_no_direction_is_left_alone)
{
    MessageRecorder messages;
    for (dReal bad : {dReal(0), kNan, kInfinite})
        for (int where = 0; where < 4; ++where) {
            dVector4 v = {};
            v[where] = bad;
            const dVector4 before = {v[0], v[1], v[2], v[3]};
            if (where < 3) {
                EXPECT_EQ(dSafeNormalize3(v), 0);
                EXPECT_EQ(messages.take(), "");
                dNormalize3(v);
                EXPECT_EQ(messages.take(), "2: Bad argument(s) in dNormalize3()");
            }
            EXPECT_EQ(dSafeNormalize4(v), 0);
            EXPECT_EQ(messages.take(), "");
            dNormalize4(v);
            EXPECT_EQ(messages.take(), "2: Bad argument(s) in dNormalize4()");
            for (int i = 0; i < 4; ++i)
                EXPECT_TRUE(v[i] == before[i] || (std::isnan(v[i]) && i == where)) << where;
        }
}

TEST(VectorApi, orthogonalize_repairs_a_drifted_matrix_completely)
{
    dMatrix3 R = {2, 0, 0, 5, dReal(0.1), 3, 0, 5, 0, 0, -1, 5};
    EXPECT_EQ(dOrthogonalizeR(R), 1);
    expect_numbers(R, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0});
    dMatrix3 flat = {1, 0, 0, 5, 2, 0, 0, 5, 0, 0, 1, 5};
    EXPECT_EQ(dOrthogonalizeR(flat), 0);
    expect_numbers(flat, {1, 0, 0, 5, 2, 0, 0, 5, 0, 0, 1, 5});
}

TEST(RotationApi, bad_arguments_are_refused_once_and_change_nothing)
{
    MessageRecorder messages;
    const std::vector<std::pair<std::string, std::function<void(dReal*)>>> calls = {
        {"dRFromAxisAndAngle", [](dReal* out) { dRFromAxisAndAngle(out, 1, 0, kNan, 1); }},
        {"dRFromAxisAndAngle", [](dReal* out) { dRFromAxisAndAngle(out, 1, 0, 0, kInfinite); }},
        {"dQFromAxisAndAngle", [](dReal* out) { dQFromAxisAndAngle(out, 1, 0, 0, kNan); }},
        {"dRFromEulerAngles", [](dReal* out) { dRFromEulerAngles(out, 0, kNan, 0); }},
        {"dRFrom2Axes", [](dReal* out) { dRFrom2Axes(out, 0, kNan, 0, 1, 0, 0); }},
        {"dRFromZAxis", [](dReal* out) { dRFromZAxis(out, 0, 0, 0); }},
        {"dRFromZAxis", [](dReal* out) { dRFromZAxis(out, 0, kNan, 0); }},
        {"dRfromQ", [](dReal* out) { dRfromQ(out, nullptr); }},
        {"dQfromR", [](dReal* out) { dQfromR(out, nullptr); }},
        {"dQMultiply0", [](dReal* out) { dQMultiply0(out, nullptr, out); }},
        {"dQMultiply1", [](dReal* out) { dQMultiply1(out, nullptr, out); }},
        {"dQMultiply2", [](dReal* out) { dQMultiply2(out, out, nullptr); }},
        {"dQMultiply3", [](dReal* out) { dQMultiply3(out, nullptr, nullptr); }},
        {"dDQfromW", [](dReal* out) { dDQfromW(out, nullptr, out); }},
    };
    for (const auto& [name, call] : calls) {
        dMatrix3 out = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};
        call(out);
        EXPECT_EQ(messages.take(), "2: Bad argument(s) in " + name + "()");
        for (int i = 0; i < 12; ++i) EXPECT_EQ(out[i], i + 1) << name;
        call(nullptr);
        EXPECT_EQ(messages.take(), "2: Bad argument(s) in " + name + "()") << "null";
    }
    dMatrix3 R = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};
    dRFrom2Axes(R, 1, 2, 3, 2, 4, 6);
    EXPECT_EQ(messages.take(), "2: zero length vector in dRFrom2Axes()");
    for (int i = 0; i < 12; ++i) EXPECT_EQ(R[i], i + 1);
    const dVector3 zero = {};
    dVector3 p = {9, 9, 9}, q = {9, 9, 9};
    dPlaneSpace(zero, p, q);
    EXPECT_EQ(messages.take(), "2: Bad argument(s) in dPlaneSpace()");
    EXPECT_EQ(p[0], 9);
    dRSetIdentity(nullptr);
    dQSetIdentity(nullptr);
    EXPECT_EQ(dOrthogonalizeR(nullptr), 0);
    EXPECT_EQ(dSafeNormalize3(nullptr), 0);
    EXPECT_EQ(messages.take(),
              "2: Bad argument(s) in dRSetIdentity()|2: Bad argument(s) in dQSetIdentity()|"
              "2: Bad argument(s) in dOrthogonalizeR()|2: Bad argument(s) in dSafeNormalize3()");
}

TEST(VectorApi, plane_space_of_a_vector_that_is_not_a_unit_one_stays_finite)
{
    for (dReal size : {std::numeric_limits<dReal>::min(), dReal(0.5), dReal(1e15)}) {
        const dVector3 n = {0, 0, size};
        dVector3 p, q;
        dPlaneSpace(n, p, q);
        for (int i = 0; i < 3; ++i) EXPECT_TRUE(std::isfinite(p[i]) && std::isfinite(q[i])) << size;
        EXPECT_NEAR(std::fabs(p[0] * q[1] - p[1] * q[0]), std::hypot(p[0], p[1]) * std::hypot(q[0], q[1]),
                    kTolerance);
    }
}

}  // namespace
