// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Gram-Schmidt here subtracts twice: one pass leaves an error of eps / sin(angle between the vectors),
// a second one brings it to eps ("twice is enough", Parlett, "The Symmetric Eigenvalue Problem", 6.9).
// The polar decomposition would be the nearest rotation in the Frobenius norm; ODE promises the rows.
#include "math/rotation.h"

#include <algorithm>
#include <cmath>

#include "math/trig.h"

namespace epode {
namespace {

// a := a/|a|, b := the unit vector in the plane of a and b that is perpendicular to a.
bool orthonormal_pair(Vec3& a, Vec3& b)
{
    Vec3 u = a, v = b;
    if (!normalize(u) || !normalize(v)) return false;
    v -= dot(u, v) * u;
    if (!(length2(v) > 64 * kEpsilon * kEpsilon)) return false;  // what is left is rounding
    normalize(v);
    v -= dot(u, v) * u;
    normalize(v);
    a = u, b = v;
    return true;
}

}  // namespace

Quat rotation_about(Vec3 axis, Real angle)
{
    if (!normalize(axis)) return {};
    const Vec3 v = sin(Real(0.5) * angle) * axis;
    return {cos(Real(0.5) * angle), v.x, v.y, v.z};
}

Mat3 rotation_from_euler(Real phi, Real theta, Real psi)
{
    const Real sf = sin(phi), cf = cos(phi), st = sin(theta), ct = cos(theta), sp = sin(psi), cp = cos(psi);
    return {{cp * ct, sp * ct, -st},
            {cp * st * sf - sp * cf, sp * st * sf + cp * cf, ct * sf},
            {cp * st * cf + sp * sf, sp * st * cf - cp * sf, ct * cf}};
}

bool rotation_from_axes(Vec3 a, Vec3 b, Mat3& R)
{
    if (!orthonormal_pair(a, b)) return false;
    R = from_columns(a, b, cross(a, b));
    return true;
}

bool rotation_from_z_axis(Vec3 n, Mat3& R)
{
    if (!normalize(n)) return false;
    Vec3 p, q;
    plane_space(n, p, q);
    R = from_columns(p, q, n);
    return true;
}

bool orthonormalize(Mat3& R)
{
    Vec3 a = R.row0, b = R.row1;
    if (!orthonormal_pair(a, b)) return false;
    R = {a, b, cross(a, b)};
    return true;
}

bool is_rotation(const Mat3& R, Real tolerance)
{
    const Mat3 product = R * transpose(R);
    Real error = 0;
    for (int row = 0; row < 3; ++row)
        for (int k = 0; k < 3; ++k) error = std::max(error, std::fabs(product.row(row)[k] - Real(row == k)));
    return error < tolerance && dot(cross(R.row0, R.row1), R.row2) > 0;
}

bool make_rotation(Mat3& R) { return is_rotation(R, kSingle ? Real(1e-5) : Real(1e-6)) || orthonormalize(R); }

Quat rate_of(Quat q, Vec3 w)
{
    const Quat r = Quat{0, w.x, w.y, w.z} * q;
    return {Real(0.5) * r.w, Real(0.5) * r.x, Real(0.5) * r.y, Real(0.5) * r.z};
}

}  // namespace epode
