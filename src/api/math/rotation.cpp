// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// ODE's rotation functions. Null pointers are refused everywhere, non-finite numbers where they come one by
// one; arrays are taken as they are, since nothing outlives the call. Results may overlap arguments.
#include "ode/rotation.h"

#include "base/check.h"
#include "base/messages.h"
#include "math/rotation.h"

using namespace epode;

namespace {

bool usable3(Real x, Real y, Real z) { return usable(x) && usable(y) && usable(z); }

}  // namespace

extern "C" void dRSetIdentity(dMatrix3 R)
{
    EPODE_USER(R);
    store_mat(R, Mat3::identity());
}

extern "C" void dQSetIdentity(dQuaternion q)
{
    EPODE_USER(q);
    store_quat(q, {});
}

extern "C" void dRFromAxisAndAngle(dMatrix3 R, dReal ax, dReal ay, dReal az, dReal angle)
{
    EPODE_USER(R && usable3(ax, ay, az) && usable(angle));
    store_mat(R, to_matrix(rotation_about({ax, ay, az}, angle)));
}

extern "C" void dQFromAxisAndAngle(dQuaternion q, dReal ax, dReal ay, dReal az, dReal angle)
{
    EPODE_USER(q && usable3(ax, ay, az) && usable(angle));
    store_quat(q, rotation_about({ax, ay, az}, angle));
}

extern "C" void dRFromEulerAngles(dMatrix3 R, dReal phi, dReal theta, dReal psi)
{
    EPODE_USER(R && usable3(phi, theta, psi));
    store_mat(R, rotation_from_euler(phi, theta, psi));
}

extern "C" void dRFrom2Axes(dMatrix3 R, dReal ax, dReal ay, dReal az, dReal bx, dReal by, dReal bz)
{
    EPODE_USER(R && usable3(ax, ay, az) && usable3(bx, by, bz));
    Mat3 result;
    if (rotation_from_axes({ax, ay, az}, {bx, by, bz}, result)) {
        store_mat(R, result);
    } else {
        note(d_ERR_UASSERT, "zero length vector in dRFrom2Axes()");
    }
}

extern "C" void dRFromZAxis(dMatrix3 R, dReal ax, dReal ay, dReal az)
{
    Mat3 result;
    EPODE_USER(R && usable3(ax, ay, az) && rotation_from_z_axis({ax, ay, az}, result));
    store_mat(R, result);
}

extern "C" void dQMultiply0(dQuaternion qa, const dQuaternion qb, const dQuaternion qc)
{
    EPODE_USER(qa && qb && qc);
    store_quat(qa, load_quat(qb) * load_quat(qc));
}

extern "C" void dQMultiply1(dQuaternion qa, const dQuaternion qb, const dQuaternion qc)
{
    EPODE_USER(qa && qb && qc);
    store_quat(qa, conjugate(load_quat(qb)) * load_quat(qc));
}

extern "C" void dQMultiply2(dQuaternion qa, const dQuaternion qb, const dQuaternion qc)
{
    EPODE_USER(qa && qb && qc);
    store_quat(qa, load_quat(qb) * conjugate(load_quat(qc)));
}

extern "C" void dQMultiply3(dQuaternion qa, const dQuaternion qb, const dQuaternion qc)
{
    EPODE_USER(qa && qb && qc);
    store_quat(qa, conjugate(load_quat(qb)) * conjugate(load_quat(qc)));
}

extern "C" void dRfromQ(dMatrix3 R, const dQuaternion q)
{
    EPODE_USER(R && q);
    store_mat(R, to_matrix(load_quat(q)));
}

extern "C" void dQfromR(dQuaternion q, const dMatrix3 R)
{
    EPODE_USER(q && R);
    store_quat(q, to_quat(load_mat(R)));
}

extern "C" void dDQfromW(dReal dq[4], const dVector3 w, const dQuaternion q)
{
    EPODE_USER(dq && w && q);
    store_quat(dq, rate_of(load_quat(q), load(w)));
}
