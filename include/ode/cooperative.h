// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What the cooperative functions (ode/matrix_coop.h) need before they are called: who helps, how much is to
// be done at most, and the means for it, acquired once and used for many calls.
//     cooperative  = dCooperativeCreate(functions, impl);
//     requirements = dResourceRequirementsCreate(cooperative);
//     dEstimateCooperativelyFactorLDLTResourceRequirements(requirements, 0, 500);
//     resources    = dResourceContainerAcquire(requirements);
//     dCooperativelyFactorLDLT(resources, 0, A, d, 500, 504);
// The four kinds of object copy what they need of one another and may be destroyed in any order; the
// threading implementation goes last.
#ifndef _ODE_COOPERATIVE_H_
#define _ODE_COOPERATIVE_H_

#include <ode/common.h>
#include <ode/threading.h>

#ifdef __cplusplus
extern "C" {
#endif

struct dxCooperative;
struct dxResourceRequirements;
struct dxResourceContainer;

typedef struct dxCooperative* dCooperativeID;
typedef struct dxResourceRequirements* dResourceRequirementsID;
typedef struct dxResourceContainer* dResourceContainerID;

/** Threads for cooperative functions: those of an implementation, given by its table (which is copied) and
   its handle; both NULL: the calling thread alone. Refused with one of the two NULL, struct_size too small or
    a function missing. Returns NULL when refused or out of memory. */
ODE_API dCooperativeID dCooperativeCreate(const dThreadingFunctionsInfo* functionInfo,
                                          dThreadingImplementationID threadingImpl);

/** NULL is ignored, here and in the other two functions that destroy. */
ODE_API void dCooperativeDestroy(dCooperativeID cooperative);

/** New requirements: none. Returns NULL when refused or out of memory. */
ODE_API dResourceRequirementsID dResourceRequirementsCreate(dCooperativeID cooperative);
ODE_API void dResourceRequirementsDestroy(dResourceRequirementsID requirements);

/** A copy that goes its own way. Returns NULL when refused or out of memory. */
ODE_API dResourceRequirementsID dResourceRequirementsClone(dResourceRequirementsID requirements);

/** Raise the first to what satisfies both. Refused if they were made for different threading implementations.
 */
ODE_API void dResourceRequirementsMergeIn(dResourceRequirementsID summaryRequirements,
                                          dResourceRequirementsID extraRequirements);

/** The means for what has been estimated so far. One container serves one call at a time (a second one is
    refused). Returns NULL when refused, out of memory, or if the threading implementation cannot
    prepare. */
ODE_API dResourceContainerID dResourceContainerAcquire(dResourceRequirementsID requirements);

/** Refused while a call uses the container. */
ODE_API void dResourceContainerDestroy(dResourceContainerID resources);

#ifdef __cplusplus
}
#endif

#endif
