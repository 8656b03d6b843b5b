// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Three-vectors. The sums are written left to right, so that every compiler makes the same bits.
// ODE's dVector3 has a fourth, unused number; `load`/`store` translate and never touch it.
#pragma once

#include <cmath>

#include "base/config.h"

namespace epode {

struct Vec3 {
    Real x = 0, y = 0, z = 0;
    constexpr Real operator[](int i) const { return i == 0 ? x : i == 1 ? y : z; }
    constexpr void set(int i, Real value) { (i == 0 ? x : i == 1 ? y : z) = value; }
};

constexpr Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
constexpr Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
constexpr Vec3 operator-(Vec3 a) { return {-a.x, -a.y, -a.z}; }
constexpr Vec3 operator*(Real s, Vec3 a) { return {s * a.x, s * a.y, s * a.z}; }
constexpr Vec3 operator*(Vec3 a, Real s) { return {s * a.x, s * a.y, s * a.z}; }
constexpr Vec3 operator/(Vec3 a, Real s) { return {a.x / s, a.y / s, a.z / s}; }
constexpr Vec3& operator+=(Vec3& a, Vec3 b) { return a = a + b; }
constexpr Vec3& operator-=(Vec3& a, Vec3 b) { return a = a - b; }
constexpr Vec3& operator*=(Vec3& a, Real s) { return a = s * a; }
constexpr bool operator==(Vec3 a, Vec3 b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

constexpr Real dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
constexpr Vec3 cross(Vec3 a, Vec3 b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
constexpr Vec3 scale(Vec3 a, Vec3 b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
constexpr Real length2(Vec3 a) { return dot(a, a); }
inline Real length(Vec3 a) { return std::sqrt(dot(a, a)); }
inline Vec3 abs(Vec3 a) { return {std::fabs(a.x), std::fabs(a.y), std::fabs(a.z)}; }
constexpr Vec3 min(Vec3 a, Vec3 b)
{
    return {a.x < b.x ? a.x : b.x, a.y < b.y ? a.y : b.y, a.z < b.z ? a.z : b.z};
}
constexpr Vec3 max(Vec3 a, Vec3 b)
{
    return {a.x > b.x ? a.x : b.x, a.y > b.y ? a.y : b.y, a.z > b.z ? a.z : b.z};
}
constexpr Real max_component(Vec3 a)
{
    const Real m = a.x > a.y ? a.x : a.y;
    return m > a.z ? m : a.z;
}

inline Vec3 load(const Real* p) { return {p[0], p[1], p[2]}; }
inline void store(Real* p, Vec3 a) { p[0] = a.x, p[1] = a.y, p[2] = a.z; }

// Scales `a` to length one; false and unchanged when it is zero or not finite. The largest component is
// taken out first, so neither tiny nor huge vectors lose their direction.
inline bool normalize(Vec3& a)
{
    const Real m = max_component(abs(a));
    if (!(m > 0) || !(m < kInf)) return false;
    const Vec3 b = a / m;
    const Real n = length(b);
    if (!(n > 0)) return false;  // a NaN that the comparisons above have passed over
    a = b / n;
    return true;
}

inline Vec3 normalized_or(Vec3 a, Vec3 fallback) { return normalize(a) ? a : fallback; }

// Unit p and q such that (n, p, q) is right-handed, n being a unit vector. This very choice is part of
// ODE's contract: contact tangents and joint rows are expressed in it (dPlaneSpace).
inline void plane_space(Vec3 n, Vec3& p, Vec3& q)
{
    constexpr Real kSqrtHalf = Real(0.7071067811865475244);
    if (std::fabs(n.z) > kSqrtHalf) {
        const Real a = n.y * n.y + n.z * n.z;
        const Real k = Real(1) / std::sqrt(a);
        p = {0, -n.z * k, n.y * k};
        q = {a * k, -n.x * p.z, n.x * p.y};
    } else {
        const Real a = n.x * n.x + n.y * n.y;
        const Real k = Real(1) / std::sqrt(a);
        p = {-n.y * k, n.x * k, 0};
        q = {-n.z * p.y, n.z * p.x, a * k};
    }
}

}  // namespace epode
