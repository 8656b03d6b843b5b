/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * Cooperative work: who helps, how much is to be done at most, and the means for it. */
#ifndef _ODE_COOPERATIVE_H_
#define _ODE_COOPERATIVE_H_

#include <ode/common.h>
#include <ode/threading.h>

#ifdef __cplusplus
extern "C" {
#endif

/** @chapter cooperative Cooperative work

    What the functions of @ref cooperative_matrices "matrices by several threads" need before they are called:
    who helps, how much is to be done at most, and the means for it, acquired once for many calls.

        cooperative  = dCooperativeCreate(functions, impl);
        requirements = dResourceRequirementsCreate(cooperative);
        dEstimateCooperativelyFactorLDLTResourceRequirements(requirements, 0, 500);
        resources    = dResourceContainerAcquire(requirements);
        dCooperativelyFactorLDLT(resources, 0, A, d, 500, 504);

    The objects copy what they need of one another and may be destroyed in any order; the threading
    implementation goes last. What is created is 0 when refused or out of memory.

    Arguments:
    - cooperative, requirements, resources: the object; 0 is ignored where one is destroyed.

    Refused: an object that is 0 or destroyed; what each function says. */

struct dxCooperative;
struct dxResourceRequirements;
struct dxResourceContainer;

typedef struct dxCooperative* dCooperativeID;                   /**< Threads at work on one task. */
typedef struct dxResourceRequirements* dResourceRequirementsID; /**< Memory that calls will need. */
typedef struct dxResourceContainer* dResourceContainerID;       /**< That memory, acquired. */

/** Threads for cooperative functions: those of a threading implementation, given by its table functionInfo
    (which is copied) and its handle threadingImpl; both NULL: the calling thread alone. Refused with one of
    the two NULL, struct_size too small or a function missing. [0.16] */
ODE_API dCooperativeID dCooperativeCreate(const dThreadingFunctionsInfo* functionInfo,
                                          dThreadingImplementationID threadingImpl);

/** The requirements and containers made for it stay. [0.16] */
ODE_API void dCooperativeDestroy(dCooperativeID cooperative);

/** - dResourceRequirementsCreate: New requirements for calls with the container cooperative: at first for
      nothing.
    - dResourceRequirementsDestroy: Destroy the requirements. [0.16] */
ODE_API dResourceRequirementsID dResourceRequirementsCreate(dCooperativeID cooperative);
ODE_API void dResourceRequirementsDestroy(dResourceRequirementsID requirements);

/** A copy that goes its own way. [0.16] */
ODE_API dResourceRequirementsID dResourceRequirementsClone(dResourceRequirementsID requirements);

/** Raise summaryRequirements to what satisfies extraRequirements too. Refused if they were made for
    different threading implementations. [0.16] */
ODE_API void dResourceRequirementsMergeIn(dResourceRequirementsID summaryRequirements,
                                          dResourceRequirementsID extraRequirements);

/** The means for what has been estimated so far. One container serves one call at a time. 0 also if the
    threading implementation cannot prepare. [0.16] */
ODE_API dResourceContainerID dResourceContainerAcquire(dResourceRequirementsID requirements);

/** Refused while a call uses the container. [0.16] */
ODE_API void dResourceContainerDestroy(dResourceContainerID resources);

#ifdef __cplusplus
}
#endif

#endif
