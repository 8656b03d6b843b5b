// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// odemath.
#ifndef _ODE_ODEMATH_H_
#define _ODE_ODEMATH_H_

#include <ode/common.h>

#ifdef __cplusplus
extern "C" {
#endif


ODE_API void dNormalize3(dVector3 a);
ODE_API void dNormalize4(dVector4 a);
ODE_API int dOrthogonalizeR(dMatrix3 m);
ODE_API void dPlaneSpace(const dVector3 n, dVector3 p, dVector3 q);
ODE_API int dSafeNormalize3(dVector3 a);
ODE_API int dSafeNormalize4(dVector4 a);

#ifdef __cplusplus
}
#endif

#endif
