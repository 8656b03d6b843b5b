// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// 3x3 matrices, row-major without padding, and symmetric ones as six numbers. `load_mat`/`store_mat`
// translate to ODE's dMatrix3 (three rows of four).
#pragma once

#include "math/vec.h"

namespace epode {

struct Mat3 {
    Vec3 row0, row1, row2;
    static constexpr Mat3 identity() { return {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}; }
    constexpr Vec3 column(int i) const { return {row0[i], row1[i], row2[i]}; }
    constexpr Vec3 row(int i) const { return i == 0 ? row0 : i == 1 ? row1 : row2; }
};

constexpr bool operator==(const Mat3& a, const Mat3& b)
{
    return a.row0 == b.row0 && a.row1 == b.row1 && a.row2 == b.row2;
}
constexpr Mat3 from_columns(Vec3 a, Vec3 b, Vec3 c)
{
    return {{a.x, b.x, c.x}, {a.y, b.y, c.y}, {a.z, b.z, c.z}};
}
constexpr Mat3 transpose(const Mat3& m) { return from_columns(m.row0, m.row1, m.row2); }
constexpr Vec3 operator*(const Mat3& m, Vec3 a) { return {dot(m.row0, a), dot(m.row1, a), dot(m.row2, a)}; }
// m^T a
constexpr Vec3 transposed_times(const Mat3& m, Vec3 a)
{
    return {m.row0.x * a.x + m.row1.x * a.y + m.row2.x * a.z,
            m.row0.y * a.x + m.row1.y * a.y + m.row2.y * a.z,
            m.row0.z * a.x + m.row1.z * a.y + m.row2.z * a.z};
}
constexpr Mat3 operator*(const Mat3& a, const Mat3& b)
{
    return {transposed_times(b, a.row0), transposed_times(b, a.row1), transposed_times(b, a.row2)};
}
constexpr Mat3 operator+(const Mat3& a, const Mat3& b)
{
    return {a.row0 + b.row0, a.row1 + b.row1, a.row2 + b.row2};
}
constexpr Mat3 operator-(const Mat3& a, const Mat3& b)
{
    return {a.row0 - b.row0, a.row1 - b.row1, a.row2 - b.row2};
}
constexpr Mat3 operator*(Real s, const Mat3& a) { return {s * a.row0, s * a.row1, s * a.row2}; }
constexpr Mat3 skew(Vec3 a) { return {{0, -a.z, a.y}, {a.z, 0, -a.x}, {-a.y, a.x, 0}}; }
constexpr Real determinant(const Mat3& m) { return dot(m.row0, cross(m.row1, m.row2)); }

// The inverse by cofactors; false when the determinant is zero or not finite.
constexpr bool invert(const Mat3& m, Mat3& out)
{
    const Vec3 c0 = cross(m.row1, m.row2), c1 = cross(m.row2, m.row0), c2 = cross(m.row0, m.row1);
    const Real d = dot(m.row0, c0);
    const Real k = Real(1) / d;
    if (d == 0 || !(k > -kInf && k < kInf)) return false;
    out = from_columns(k * c0, k * c1, k * c2);
    return true;
}

inline Mat3 load_mat(const Real* p) { return {load(p), load(p + 4), load(p + 8)}; }
inline void store_mat(Real* p, const Mat3& m)
{
    store(p, m.row0), store(p + 4, m.row1), store(p + 8, m.row2);
    p[3] = p[7] = p[11] = 0;
}

// Symmetric: xx, yy, zz, xy, xz, yz.
struct Sym3 {
    Real xx = 0, yy = 0, zz = 0, xy = 0, xz = 0, yz = 0;
};

// The same in all frames, as that of a sphere or cube; a NaN answers no.
constexpr bool isotropic(const Sym3& s)
{
    return s.xx == s.yy && s.yy == s.zz && s.xy == 0 && s.xz == 0 && s.yz == 0;
}

constexpr Vec3 operator*(const Sym3& s, Vec3 a)
{
    return {s.xx * a.x + s.xy * a.y + s.xz * a.z, s.xy * a.x + s.yy * a.y + s.yz * a.z,
            s.xz * a.x + s.yz * a.y + s.zz * a.z};
}
constexpr Sym3 symmetric_part(const Mat3& m)  // upper triangle
{
    return {m.row0.x, m.row1.y, m.row2.z, m.row0.y, m.row0.z, m.row1.z};
}
constexpr Mat3 full(const Sym3& s) { return {{s.xx, s.xy, s.xz}, {s.xy, s.yy, s.yz}, {s.xz, s.yz, s.zz}}; }
// R S R^T: a body-frame tensor seen in the world.
constexpr Sym3 rotate(const Mat3& R, const Sym3& s)
{
    const Mat3 RS = {s * R.row0, s * R.row1, s * R.row2};  // rows of R S, S being symmetric
    return {dot(RS.row0, R.row0), dot(RS.row1, R.row1), dot(RS.row2, R.row2),
            dot(RS.row0, R.row1), dot(RS.row0, R.row2), dot(RS.row1, R.row2)};
}

}  // namespace epode
