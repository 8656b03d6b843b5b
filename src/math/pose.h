// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Unit quaternions (w, x, y, z), rotations and rigid poses, in ODE's conventions: R maps body to world,
// p_world = position + R p_body, and q1 q2 rotates by q2 first.
#pragma once

#include <initializer_list>
#include <limits>

#include "math/mat.h"

namespace epode {

// Rounding of a gyroscopic torque turns w by some eps h |w| of itself: there is none from an angle of 1e-4 / eps in a step on,
// or where the determinant of its equations is this times that of the inertia's diagonal, which is about the angle's square.
inline constexpr Real kMaxGyroscopicRatio =
    Real(1e-8) / (std::numeric_limits<Real>::epsilon() * std::numeric_limits<Real>::epsilon());

struct Quat {
    Real w = 1, x = 0, y = 0, z = 0;
    constexpr Vec3 vec() const { return {x, y, z}; }
};

constexpr bool operator==(Quat a, Quat b) { return a.w == b.w && a.vec() == b.vec(); }
inline Quat load_quat(const Real* p) { return {p[0], p[1], p[2], p[3]}; }
inline void store_quat(Real* p, Quat q) { p[0] = q.w, p[1] = q.x, p[2] = q.y, p[3] = q.z; }

constexpr Quat conjugate(Quat q) { return {q.w, -q.x, -q.y, -q.z}; }
constexpr Quat operator*(Quat a, Quat b)
{
    return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
            a.w * b.y + a.y * b.w + a.z * b.x - a.x * b.z, a.w * b.z + a.z * b.w + a.x * b.y - a.y * b.x};
}

// False and unchanged for a zero or non-finite quaternion.
inline bool normalize(Quat& q)
{
    // In double, since near 1 a float's k is 1 and leaves an error of the length that adds up over the steps.
    const double w = q.w, x = q.x, y = q.y, z = q.z, n2 = w * w + x * x + y * y + z * z;
    if (n2 > 0.25 && n2 < 4) {  // a turned unit quaternion, as nearly always
        const double k = 1 / std::sqrt(n2);
        q = {Real(w * k), Real(x * k), Real(y * k), Real(z * k)};
        return true;
    }
    Real m = std::fabs(q.w);
    for (Real c : {q.x, q.y, q.z})
        if (!(std::fabs(c) <= m)) m = std::fabs(c);
    if (!(m > 0) || !(m < kInf)) return false;
    const Quat u = {q.w / m, q.x / m, q.y / m, q.z / m};
    const Real n = std::sqrt(u.w * u.w + u.x * u.x + u.y * u.y + u.z * u.z);
    if (!(n > 0)) return false;  // a NaN that the comparisons above have passed over
    const Real k = Real(1) / n;
    q = {u.w * k, u.x * k, u.y * k, u.z * k};
    return true;
}

// Rotation matrix of q; q is not normalised here (dRfromQ).
constexpr Mat3 to_matrix(Quat q)
{
    const Real xx = 2 * q.x * q.x, yy = 2 * q.y * q.y, zz = 2 * q.z * q.z;
    return {{1 - yy - zz, 2 * (q.x * q.y - q.w * q.z), 2 * (q.x * q.z + q.w * q.y)},
            {2 * (q.x * q.y + q.w * q.z), 1 - xx - zz, 2 * (q.y * q.z - q.w * q.x)},
            {2 * (q.x * q.z - q.w * q.y), 2 * (q.y * q.z + q.w * q.x), 1 - xx - yy}};
}

// Quaternion of a rotation matrix, by the largest of trace and diagonal (dQfromR); not normalised.
inline Quat to_quat(const Mat3& R)
{
    const Real trace = R.row0.x + R.row1.y + R.row2.z;
    if (trace >= 0) {
        const Real s = std::sqrt(trace + 1), k = Real(0.5) / s;
        return {Real(0.5) * s, (R.row2.y - R.row1.z) * k, (R.row0.z - R.row2.x) * k,
                (R.row1.x - R.row0.y) * k};
    }
    int i = R.row1.y > R.row0.x ? 1 : 0;
    if (R.row2.z > R.row(i)[i]) i = 2;
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const Real s = std::sqrt(R.row(i)[i] - R.row(j)[j] - R.row(k)[k] + 1), t = Real(0.5) / s;
    Vec3 v;
    v.set(i, Real(0.5) * s);
    v.set(j, (R.row(i)[j] + R.row(j)[i]) * t);
    v.set(k, (R.row(k)[i] + R.row(i)[k]) * t);
    return {(R.row(k)[j] - R.row(j)[k]) * t, v.x, v.y, v.z};
}

struct Pose {
    Vec3 p;
    Mat3 R = Mat3::identity();
    constexpr Vec3 to_world(Vec3 local) const { return p + R * local; }
    constexpr Vec3 to_local(Vec3 world) const { return transposed_times(R, world - p); }
};

// The pose of b's frame when b is given in a's frame, and the inverse operation.
constexpr Pose operator*(const Pose& a, const Pose& b) { return {a.to_world(b.p), a.R * b.R}; }
constexpr Pose inverse_times(const Pose& a, const Pose& b) { return {a.to_local(b.p), transpose(a.R) * b.R}; }

inline Pose load_pose(const Real* position, const Real* rotation)
{
    return {load(position), load_mat(rotation)};
}

}  // namespace epode
