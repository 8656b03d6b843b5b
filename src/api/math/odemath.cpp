// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The functions of odemath.h that are not inline there. Where ODE asserts (dNormalize of zero) or spreads
// NaN (dPlaneSpace of a vector that is not a unit one), we refuse or normalise.
#include "ode/odemath.h"

#include <cmath>

#include "base/check.h"
#include "math/rotation.h"

using namespace epode;

namespace {

bool normalize3(Real* a)
{
    Vec3 v = load(a);
    if (std::isnan(v.x + v.y + v.z) || !normalize(v)) return false;
    store(a, v);
    return true;
}

bool normalize4(Real* a)
{
    Quat v = load_quat(a);
    if (std::isnan(v.w + v.x + v.y + v.z) || !normalize(v)) return false;
    store_quat(a, v);
    return true;
}

bool finite(Vec3 v) { return usable(v.x) && usable(v.y) && usable(v.z); }

// The plane space of n as it is, or of its direction when n is too far from unit length for the formula.
bool plane_space_of(Vec3 n, Vec3& p, Vec3& q)
{
    if (!finite(n)) return false;
    plane_space(n, p, q);
    if (finite(p) && finite(q)) return true;
    if (!normalize(n)) return false;
    plane_space(n, p, q);
    return true;
}

}  // namespace

extern "C" int dSafeNormalize3(dVector3 a)
{
    EPODE_USER(a, 0);
    return normalize3(a);
}

extern "C" int dSafeNormalize4(dVector4 a)
{
    EPODE_USER(a, 0);
    return normalize4(a);
}

extern "C" void dNormalize3(dVector3 a) { EPODE_USER(a && normalize3(a)); }

extern "C" void dNormalize4(dVector4 a) { EPODE_USER(a && normalize4(a)); }

extern "C" void dPlaneSpace(const dVector3 n, dVector3 p, dVector3 q)
{
    Vec3 first, second;
    EPODE_USER(n && p && q && plane_space_of(load(n), first, second));
    store(p, first);
    store(q, second);
}

extern "C" int dOrthogonalizeR(dMatrix3 m)
{
    EPODE_USER(m, 0);
    Mat3 R = load_mat(m);
    if (!orthonormalize(R)) return 0;
    store_mat(m, R);
    return 1;
}
