/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * Functions of ode/matrix.h whose work several threads share (ode/cooperative.h). */
#ifndef _ODE_MATRIX_COOP_H_
#define _ODE_MATRIX_COOP_H_

#include <ode/common.h>
#include <ode/cooperative.h>
#include <ode/threading.h>

#ifdef __cplusplus
extern "C" {
#endif

/** @chapter cooperative_matrices Matrices, by several threads

    Functions of @ref matrices "matrices" whose work several threads share, with the means that a container of
    @ref cooperative "cooperative work" holds. They compute the same numbers as the functions they are named
    after, to the last bit, on any number of threads; small problems, which would only suffer, stay on the
    calling thread. Each returns when it is done. rowCount or elementCount 0 does nothing.

    Arguments:
    - requirements: what an estimate raises, so that it is enough for calls within its limits.
    - maximalAllowedThreadCount, maximalRowCount, maximalElementCount: those limits. 0 threads are no limit.
      The estimates of the four triangular functions are good for each other.
    - resources: a container acquired after the estimate.
    - allowedThreadCount: the most threads that may work on this call; 0: all that there are.
    - rowCount: the number of rows and columns, or of elements of a vector beside a matrix.
    - rowSkip: how many reals a row of the array has.

    Refused: null pointers; requirements or resources that are 0 or destroyed; a problem larger than was
    estimated; a container that another call uses; rowSkip < rowCount. Nothing changes then. */

/** What dCooperativelyFactorLDLT will need. [0.16] */
ODE_API void dEstimateCooperativelyFactorLDLTResourceRequirements(dResourceRequirementsID requirements,
                                                                  unsigned maximalAllowedThreadCount,
                                                                  unsigned maximalRowCount);

/** dFactorLDLT: A = L D L^T in place, for symmetric A of rowCount rows, rowSkip reals apart, of which the
    lower triangle is read. L goes to the strict lower triangle, 1/D to d. [0.16] */
ODE_API void dCooperativelyFactorLDLT(dResourceContainerID resources, unsigned allowedThreadCount, dReal* A,
                                      dReal* d, unsigned rowCount, unsigned rowSkip);

/** What dCooperativelySolveLDLT will need. [0.16] */
ODE_API void dEstimateCooperativelySolveLDLTResourceRequirements(dResourceRequirementsID requirements,
                                                                 unsigned maximalAllowedThreadCount,
                                                                 unsigned maximalRowCount);

/** dSolveLDLT: L D L^T x = b in place of b, with L and d (1/D) of the factorisation. [0.16] */
ODE_API void dCooperativelySolveLDLT(dResourceContainerID resources, unsigned allowedThreadCount,
                                     const dReal* L, const dReal* d, dReal* b, unsigned rowCount,
                                     unsigned rowSkip);

/** What dCooperativelySolveL1Straight will need. [0.16] */
ODE_API void dEstimateCooperativelySolveL1StraightResourceRequirements(dResourceRequirementsID requirements,
                                                                       unsigned maximalAllowedThreadCount,
                                                                       unsigned maximalRowCount);

/** dSolveL1: L x = b in place of b, L unit lower triangular (its diagonal is not read). [0.16] */
ODE_API void dCooperativelySolveL1Straight(dResourceContainerID resources, unsigned allowedThreadCount,
                                           const dReal* L, dReal* b, unsigned rowCount, unsigned rowSkip);

/** What dCooperativelySolveL1Transposed will need. [0.16] */
ODE_API void dEstimateCooperativelySolveL1TransposedResourceRequirements(dResourceRequirementsID requirements,
                                                                         unsigned maximalAllowedThreadCount,
                                                                         unsigned maximalRowCount);

/** dSolveL1T: L^T x = b in place of b. [0.16] */
ODE_API void dCooperativelySolveL1Transposed(dResourceContainerID resources, unsigned allowedThreadCount,
                                             const dReal* L, dReal* b, unsigned rowCount, unsigned rowSkip);

/** What dCooperativelyScaleVector will need. [0.16] */
ODE_API void dEstimateCooperativelyScaleVectorResourceRequirements(dResourceRequirementsID requirements,
                                                                   unsigned maximalAllowedThreadCount,
                                                                   unsigned maximalElementCount);

/** dScaleVector: dataVector[i] *= scaleVector[i] for elementCount elements. [0.16] */
ODE_API void dCooperativelyScaleVector(dResourceContainerID resources, unsigned allowedThreadCount,
                                       dReal* dataVector, const dReal* scaleVector, unsigned elementCount);

#ifdef __cplusplus
}
#endif

#endif
