// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Rotations and quaternions, normalisation, plane bases, and the random number sequences.
#include "case_list.h"

#include <cmath>

namespace parity {
namespace {

PARITY_CASE(math_rotations)
{
    for (int i = 0; i < 100; ++i) {
        out.open_block("t" + std::to_string(i));
        const Vec3 a = rng.in_cube(2), b = rng.in_cube(2);
        dMatrix3 R = {0};
        dQuaternion q = {0, 0, 0, 0};
        dRFromAxisAndAngle(R, a.x, a.y, a.z, b.x);
        out.put_matrix3("r-axis-angle", R);
        dQFromAxisAndAngle(q, a.x, a.y, a.z, b.x);
        out.put("q-axis-angle", q, 4);
        dRFromEulerAngles(R, b.x, b.y, b.z);
        out.put_matrix3("r-euler", R);
        dQfromR(q, R);
        out.put("q-from-r", q, 4);
        dRFrom2Axes(R, a.x, a.y, a.z, b.x, b.y, b.z);
        out.put_matrix3("r-2axes", R);
        dRFromZAxis(R, a.x, a.y, a.z);
        out.put_matrix3("r-zaxis", R);
        const dQuaternion raw = {a.x, a.y, a.z, b.y};
        dRfromQ(R, raw);
        out.put_matrix3("r-from-raw-q", R);
    }
}

// Turns near 180 degrees about and between the axes: every branch of the matrix to quaternion conversion.
PARITY_CASE(math_quaternion_branches)
{
    for (int i = 0; i < 60; ++i) {
        const Vec3 axis{i % 3 == 0 ? 1.0 : rng.range(-1, 1), i % 3 == 1 ? 1.0 : rng.range(-1, 1),
                        i % 3 == 2 ? 1.0 : rng.range(-1, 1)};
        dMatrix3 R = {0};
        dQuaternion q = {0, 0, 0, 0};
        dRFromAxisAndAngle(R, axis.x, axis.y, axis.z, rng.range(2.5, 3.14));
        dQfromR(q, R);
        out.put("q" + std::to_string(i), q, 4);
    }
}

PARITY_CASE(math_quaternions)
{
    for (int i = 0; i < 60; ++i) {
        out.open_block("t" + std::to_string(i));
        const dQuaternion b = {rng.range(-1, 1), rng.range(-1, 1), rng.range(-1, 1), rng.range(-1, 1)};
        const dQuaternion c = {rng.range(-1, 1), rng.range(-1, 1), rng.range(-1, 1), rng.range(-1, 1)};
        const dVector3 w = {rng.range(-5, 5), rng.range(-5, 5), rng.range(-5, 5), 0};
        dQuaternion a = {0, 0, 0, 0};
        dQMultiply0(a, b, c);
        out.put("multiply0", a, 4);
        dQMultiply1(a, b, c);
        out.put("multiply1", a, 4);
        dQMultiply2(a, b, c);
        out.put("multiply2", a, 4);
        dQMultiply3(a, b, c);
        out.put("multiply3", a, 4);
        dDQfromW(a, w, b);
        out.put("derivative", a, 4);
    }
}

PARITY_CASE(math_normalise)
{
    for (int i = 0; i < 60; ++i) {
        out.open_block("t" + std::to_string(i));
        const double scale = std::pow(10.0, rng.range(-200, 200));
        const Vec3 d = rng.direction();
        dVector3 v = {d.x * scale, d.y * scale, d.z * scale, 0};
        out.put("ok3", {static_cast<double>(dSafeNormalize3(v))});
        out.put("unit3", v, 3);
        dVector3 p = {0, 0, 0, 0}, q = {0, 0, 0, 0};
        dPlaneSpace(v, p, q);
        out.put("plane-p", p, 3);
        out.put("plane-q", q, 3);
        dVector4 u = {rng.range(-9, 9), rng.range(-9, 9), rng.range(-9, 9), rng.range(-9, 9)};
        out.put("ok4", {static_cast<double>(dSafeNormalize4(u))});
        out.put("unit4", u, 4);
    }
    out.open_block("zero");
    dVector3 zero3 = {0, 0, 0, 0};
    dVector4 zero4 = {0, 0, 0, 0};
    out.put("ok", {static_cast<double>(dSafeNormalize3(zero3)), static_cast<double>(dSafeNormalize4(zero4))});
}

PARITY_CASE(math_random)
{
    dRandSetSeed(0);
    for (int i = 0; i < 20; ++i) { out.put("rand" + std::to_string(i), {static_cast<double>(dRand())}); }
    static const int limits[] = {1, 2, 3, 4, 5, 16, 17, 100, 256, 257, 1000, 65536, 65537, 1000000};
    for (const int limit : limits) {
        out.open_block("below" + std::to_string(limit));
        dRandSetSeed(12345);
        for (int i = 0; i < 30; ++i) {
            out.put("int" + std::to_string(i), {static_cast<double>(dRandInt(limit))});
        }
        out.put("seed", {static_cast<double>(dRandGetSeed())});
    }
    out.open_block("real");
    for (int i = 0; i < 20; ++i) { out.put("real" + std::to_string(i), {dRandReal()}); }
    dReal vector[5], matrix[12] = {0};
    dMakeRandomVector(vector, 5, 3.0);
    dMakeRandomMatrix(matrix, 3, 4, 2.0);
    out.put("vector", vector, 5);
    out.put("matrix", matrix, 12);
    out.put("test", {static_cast<double>(dTestRand())});
}

}  // namespace
}  // namespace parity
