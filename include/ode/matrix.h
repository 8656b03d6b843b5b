/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * Dense linear algebra on matrices of any size. An n x m matrix is stored by rows, each row dPAD(m)
 * reals long; `nskip` arguments give that row length explicitly. Padding is ignored on input.
 * Null pointers, n <= 0 and nskip < n are refused.
 * Factorisations: Cholesky A = L L^T, and A = L D L^T with unit lower triangular L, where the vector
 * d holds the RECIPROCALS of the diagonal of D. */
#ifndef _ODE_MATRIX_H_
#define _ODE_MATRIX_H_

#include <ode/common.h>

#ifdef __cplusplus
extern "C" {
#endif

/** @chapter matrices Matrices and vectors of any size

    Arguments:
    - n: the number of elements, or of rows and columns.
    - nskip: how many reals a row of the array has.

    Refused: null pointers; n that is not positive (0 does nothing where vectors are meant); nskip < n.
    Nothing changes then, and the answer is 0. */

/** - dSetZero: Set the n reals at a to zero.
    - dSetValue: Set the n reals at a to value. [0.16] */
ODE_API void dSetZero(dReal* a, int n);
ODE_API void dSetValue(dReal* a, int n, dReal value);

/** Inner product of two vectors a and b of n reals. [0.16] */
ODE_API dReal dDot(const dReal* a, const dReal* b, int n);

/** A is p x r and must not overlap B or C.
    - dMultiply0: A = B C, with B p x q and C q x r.
    - dMultiply1: A = B^T C, with B q x p and C q x r.
    - dMultiply2: A = B C^T, with B p x q and C r x q. [0.16] */
ODE_API void dMultiply0(dReal* A, const dReal* B, const dReal* C, int p, int q, int r);
ODE_API void dMultiply1(dReal* A, const dReal* B, const dReal* C, int p, int q, int r);
ODE_API void dMultiply2(dReal* A, const dReal* B, const dReal* C, int p, int q, int r);

/** Replace the lower triangle of the symmetric n x n matrix A by its Cholesky factor L; the upper
    triangle is neither read nor written. Returns 1, or 0 when A is not positive definite (the lower
    triangle is then partly overwritten). [0.16] */
ODE_API int dFactorCholesky(dReal* A, int n);

/** Solve L L^T x = b in place, L from dFactorCholesky. [0.16] */
ODE_API void dSolveCholesky(const dReal* L, dReal* b, int n);

/** Ainv = A^-1 of a symmetric positive definite A (its lower triangle is used). Returns 1, or 0
    when A is not positive definite. [0.16] */
ODE_API int dInvertPDMatrix(const dReal* A, dReal* Ainv, int n);

/** 1 when the symmetric matrix A (lower triangle) is positive definite, else 0. A is kept. [0.16] */
ODE_API int dIsPositiveDefinite(const dReal* A, int n);

/** A = L D L^T in place: L goes to the strict lower triangle, 1/D to d (n reals). [0.16] */
ODE_API void dFactorLDLT(dReal* A, dReal* d, int n, int nskip);

/** L is unit lower triangular, n x n with rows of nskip reals; the solution takes the place of b.
    - dSolveL1: Solve L x = b for x.
    - dSolveL1T: Solve L^T x = b for x. [0.16] */
ODE_API void dSolveL1(const dReal* L, dReal* b, int n, int nskip);
ODE_API void dSolveL1T(const dReal* L, dReal* b, int n, int nskip);

/** - dScaleVector: a[i] *= d[i] for n elements.
    - dVectorScale: Old name of dScaleVector: a[i] *= d[i] for n elements. [0.16] */
ODE_API void dScaleVector(dReal* a, const dReal* d, int n);
ODE_API_DEPRECATED ODE_API void dVectorScale(dReal* a, const dReal* d, int n);

/** Solve L D L^T x = b in place, with L and d from dFactorLDLT. [0.16] */
ODE_API void dSolveLDLT(const dReal* L, const dReal* d, dReal* b, int n, int nskip);

/** Update the factors for A + E, where E has a as its first row and first column and is zero
    elsewhere. Rows 1 ... n-1 of L (columns 1 and on) and d[1 ... n-1] are brought up to date, the
    first column of L and d[0] are not: the function serves to take row and column 0 out. [0.16] */
ODE_API void dLDLTAddTL(dReal* L, dReal* d, const dReal* a, int n, int nskip);

/** Take row and column r out of a factorisation. A: n1 row pointers of a symmetric matrix (lower
    triangle used); p: n2 indices, L and d factor the n2 x n2 matrix A(p, p). Afterwards the leading
    n2-1 part of L and d factors it without index p[r]. p is not changed. [0.16] */
ODE_API void dLDLTRemove(dReal** A, const int* p, dReal* L, dReal* d, int n1, int n2, int r, int nskip);

/** Delete row and column r of the n x n matrix A in place, closing up; the row length stays nskip. [0.16] */
ODE_API void dRemoveRowCol(dReal* A, int n, int nskip, int r);

#ifdef __cplusplus
}
#endif

#endif
