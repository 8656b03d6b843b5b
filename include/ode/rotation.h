/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * Rotations as matrices and as quaternions.
 * A rotation matrix R has 3 rows of 4 reals and maps body to world coordinates; a quaternion is
 * (w, x, y, z) with w = cos(angle/2). Angles in radians, right-handed: a turn by a positive angle
 * about z takes x towards y. Functions write the padding of R as 0. */
#ifndef _ODE_ROTATION_H_
#define _ODE_ROTATION_H_

#include <ode/common.h>
#include <ode/compatibility.h>

#ifdef __cplusplus
extern "C" {
#endif

/** @chapter rotation Rotations

    Arguments:
    - R: a rotation matrix, 3 rows of 4 reals.
    - q: a quaternion (w, x, y, z).
    - angle: rad.
    - ax, ay, az: an axis, of any length.

    Refused: null pointers; numbers that are not finite. Nothing is written then. */

/** Set R to no rotation, the identity. [guide] */
ODE_API void dRSetIdentity(dMatrix3 R);

/** A turn by `angle` about the axis (ax, ay, az), which need not be a unit vector; a zero axis gives the
    identity. [0.16] */
ODE_API void dRFromAxisAndAngle(dMatrix3 R, dReal ax, dReal ay, dReal az, dReal angle);

/** From Euler angles, rad: R = (Rz(psi) Ry(theta) Rx(phi))^T: first row (cos psi cos theta, sin psi cos
    theta, -sin theta). Note the transpose: it maps world to body in the usual aeronautical reading.
    [0.16] */
ODE_API void dRFromEulerAngles(dMatrix3 R, dReal phi, dReal theta, dReal psi);

/** Columns of R: a = (ax, ay, az) normalised, the part of b = (bx, by, bz) perpendicular to a normalised,
    and their cross product. When a or b is zero or they are parallel, R is left as it is and a message is
    sent. [0.16] */
ODE_API void dRFrom2Axes(dMatrix3 R, dReal ax, dReal ay, dReal az, dReal bx, dReal by, dReal bz);

/** A rotation that takes the z axis to (ax, ay, az), normalised; the other two columns are those of
    dPlaneSpace. A zero vector is refused. [0.16] */
ODE_API void dRFromZAxis(dMatrix3 R, dReal ax, dReal ay, dReal az);

/** Set q to no rotation: (1, 0, 0, 0). [guide] */
ODE_API void dQSetIdentity(dQuaternion q);

/** The quaternion of a turn by angle about the axis (ax, ay, az), as dRFromAxisAndAngle. [0.16] */
ODE_API void dQFromAxisAndAngle(dQuaternion q, dReal ax, dReal ay, dReal az, dReal angle);

/** ' means the conjugate, which is the inverse of a unit quaternion. For rotations qb qc is "first qc, then
    qb". qa must be neither qb nor qc.
    - dQMultiply0: qa = qb qc.
    - dQMultiply1: qa = qb' qc.
    - dQMultiply2: qa = qb qc'.
    - dQMultiply3: qa = qb' qc'. [guide] */
ODE_API void dQMultiply0(dQuaternion qa, const dQuaternion qb, const dQuaternion qc);
ODE_API void dQMultiply1(dQuaternion qa, const dQuaternion qb, const dQuaternion qc);
ODE_API void dQMultiply2(dQuaternion qa, const dQuaternion qb, const dQuaternion qc);
ODE_API void dQMultiply3(dQuaternion qa, const dQuaternion qb, const dQuaternion qc);

/** The matrix R of a quaternion. q is taken as a unit quaternion and is not normalised here. [0.16] */
ODE_API void dRfromQ(dMatrix3 R, const dQuaternion q);

/** The quaternion q of a rotation matrix R. The component computed first (w when the trace is not
    negative, else that of the largest diagonal element) comes out positive. [0.16] */
ODE_API void dQfromR(dQuaternion q, const dMatrix3 R);

/** Time derivative of a quaternion under the angular velocity w (world frame, rad/s): dq = 1/2 (0, w) q.
    [0.16] */
ODE_API void dDQfromW(dReal dq[4], const dVector3 w, const dQuaternion q);

#ifdef __cplusplus
}
#endif

#endif
