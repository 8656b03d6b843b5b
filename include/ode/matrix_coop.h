// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Functions of ode/matrix.h whose work several threads share (ode/cooperative.h). They compute the same
// numbers as the functions they are named after, to the last bit, on any number of threads; small problems,
// which would only suffer, stay on the calling thread. Each returns when it is done.
//
// Each has an estimate, which raises requirements to what calls with up to so many threads and rows (or
// elements) need. Estimates for the four triangular functions are good for each other. Thread counts: 0 is
// no limit. Refused: null arguments, a problem larger than was estimated before the container was acquired, a
// container in use, rowSkip < rowCount. rowCount or elementCount 0 does nothing.
#ifndef _ODE_MATRIX_COOP_H_
#define _ODE_MATRIX_COOP_H_

#include <ode/common.h>
#include <ode/cooperative.h>
#include <ode/threading.h>

#ifdef __cplusplus
extern "C" {
#endif

ODE_API void dEstimateCooperativelyFactorLDLTResourceRequirements(dResourceRequirementsID requirements,
                                                                  unsigned maximalAllowedThreadCount,
                                                                  unsigned maximalRowCount);

/** dFactorLDLT: A = L D L^T in place, for symmetric A of rowCount rows, rowSkip reals apart, of which the
   lower triangle is read. L goes to the strict lower triangle, 1/D to d. */
ODE_API void dCooperativelyFactorLDLT(dResourceContainerID resources, unsigned allowedThreadCount, dReal* A,
                                      dReal* d, unsigned rowCount, unsigned rowSkip);

ODE_API void dEstimateCooperativelySolveLDLTResourceRequirements(dResourceRequirementsID requirements,
                                                                 unsigned maximalAllowedThreadCount,
                                                                 unsigned maximalRowCount);

/** dSolveLDLT: L D L^T x = b in place of b, with L and d (1/D) of the factorisation. */
ODE_API void dCooperativelySolveLDLT(dResourceContainerID resources, unsigned allowedThreadCount,
                                     const dReal* L, const dReal* d, dReal* b, unsigned rowCount,
                                     unsigned rowSkip);

ODE_API void dEstimateCooperativelySolveL1StraightResourceRequirements(dResourceRequirementsID requirements,
                                                                       unsigned maximalAllowedThreadCount,
                                                                       unsigned maximalRowCount);

/** dSolveL1: L x = b in place of b, L unit lower triangular (its diagonal is not read). */
ODE_API void dCooperativelySolveL1Straight(dResourceContainerID resources, unsigned allowedThreadCount,
                                           const dReal* L, dReal* b, unsigned rowCount, unsigned rowSkip);

ODE_API void dEstimateCooperativelySolveL1TransposedResourceRequirements(dResourceRequirementsID requirements,
                                                                         unsigned maximalAllowedThreadCount,
                                                                         unsigned maximalRowCount);

/** dSolveL1T: L^T x = b in place of b. */
ODE_API void dCooperativelySolveL1Transposed(dResourceContainerID resources, unsigned allowedThreadCount,
                                             const dReal* L, dReal* b, unsigned rowCount, unsigned rowSkip);

ODE_API void dEstimateCooperativelyScaleVectorResourceRequirements(dResourceRequirementsID requirements,
                                                                   unsigned maximalAllowedThreadCount,
                                                                   unsigned maximalElementCount);

/** dScaleVector: dataVector[i] *= scaleVector[i]. */
ODE_API void dCooperativelyScaleVector(dResourceContainerID resources, unsigned allowedThreadCount,
                                       dReal* dataVector, const dReal* scaleVector, unsigned elementCount);

#ifdef __cplusplus
}
#endif

#endif
