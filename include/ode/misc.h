// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// misc.
#ifndef _ODE_MISC_H_
#define _ODE_MISC_H_

#include <ode/common.h>

#ifdef __cplusplus
extern "C" {
#endif


ODE_API void dClearUpperTriangle(dReal *A, int n);
ODE_API void dMakeRandomMatrix(dReal *A, int n, int m, dReal range);
ODE_API void dMakeRandomVector(dReal *A, int n, dReal range);
ODE_API dReal dMaxDifference(const dReal *A, const dReal *B, int n, int m);
ODE_API dReal dMaxDifferenceLowerTriangle(const dReal *A, const dReal *B, int n);
ODE_API void dPrintMatrix(const dReal *A, int n, int m, const char *fmt, FILE *f);
ODE_API unsigned long dRand(void);
ODE_API unsigned long dRandGetSeed(void);
ODE_API int dRandInt(int n);
ODE_API dReal dRandReal(void);
ODE_API void dRandSetSeed(unsigned long s);
ODE_API int dTestRand(void);

#ifdef __cplusplus
}
#endif

#endif
