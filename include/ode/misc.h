/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * Random numbers and helpers for looking at and comparing matrices.
 * The generator is s = 1664525 s + 1013904223 mod 2^32 (the constants of Numerical Recipes), one
 * state for the process, starting at 0: fine for repeatable test scenes, not for statistics. Matrices are
 * padded as in matrix.h. */
#ifndef _ODE_MISC_H_
#define _ODE_MISC_H_

#include <ode/common.h>

#ifdef __cplusplus
extern "C" {
#endif

/** @chapter random Random numbers and test matrices

    Refused: null pointers. Nothing changes then, and the answer is 0. Sizes that are not positive are those
    of nothing. */

/** 1 when the generator gives its known first numbers. The state is kept. [0.16] */
ODE_API int dTestRand(void);

/** The result is written to the standard output. Takes some hundredths of a second; dRand is not disturbed.
    - dTestDataStructures: Check the library's containers against plain arrays.
    - dTestSolveLCP: Check the solvers of dWorldStep on random linear complementarity problems. Returns 1 if
      all were solved to rounding, else 0. [0.16] */
ODE_API void dTestDataStructures(void);
ODE_API int dTestSolveLCP(void);

/** The next number, 0 ... 2^32 - 1. [0.16] */
ODE_API unsigned long dRand(void);

/** - dRandGetSeed: The state of the generator behind dRand.
    - dRandSetSeed: Set the state of the generator behind dRand to s, so that what follows can be repeated.
      [0.16] */
ODE_API unsigned long dRandGetSeed(void);
ODE_API void dRandSetSeed(unsigned long s);

/** An integer 0 ... n-1 from one draw of dRand; 0 when n <= 1. [0.16] */
ODE_API int dRandInt(int n);

/** A real in [0, 1] from one draw of dRand; both ends can occur. [0.16] */
ODE_API dReal dRandReal(void);

/** Print the n x m matrix A to the file f, each element with the printf format fmt, a line per row. [0.16] */
ODE_API void dPrintMatrix(const dReal* A, int n, int m, const char* fmt, FILE* f);

/** - dMakeRandomVector: Fill the vector A of n reals with numbers from -range ... range.
    - dMakeRandomMatrix: Fill the n x m matrix A row by row with numbers from -range ... range; its padding
      is not written. [0.16] */
ODE_API void dMakeRandomVector(dReal* A, int n, dReal range);
ODE_API void dMakeRandomMatrix(dReal* A, int n, int m, dReal range);

/** Zero the elements above the diagonal of the n x n matrix A. [0.16] */
ODE_API void dClearUpperTriangle(dReal* A, int n);

/** - dMaxDifference: The largest absolute difference of two n x m matrices A and B.
    - dMaxDifferenceLowerTriangle: The largest absolute difference of the lower triangles, diagonal included,
      of two n x n matrices A and B. [0.16] */
ODE_API dReal dMaxDifference(const dReal* A, const dReal* B, int n, int m);
ODE_API dReal dMaxDifferenceLowerTriangle(const dReal* A, const dReal* B, int n);

#ifdef __cplusplus
}
#endif

#ifdef __cplusplus
/** dPrintMatrix to the standard output. */
static inline void dPrintMatrix(const dReal* A, int n, int m, const char* fmt = "%10.4f ")
{
    dPrintMatrix(A, n, m, fmt, stdout);
}
#endif

#endif
