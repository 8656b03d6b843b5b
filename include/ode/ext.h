// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What this library adds to ODE's interface. Not included by ode/ode.h: a program that includes
// this file has decided to depend on this library and not on the original one.
#ifndef _ODE_EXT_H_
#define _ODE_EXT_H_

#include <ode/common.h>

#ifdef __cplusplus
extern "C" {
#endif

/** What the last step of a world did. */
typedef struct dWorldStepReport {
    unsigned struct_size;  /**< sizeof(dWorldStepReport), set by the caller */
    int islands;           /**< islands that were simulated */
    int bodies;            /**< bodies in them */
    int joints;            /**< joints in them that gave at least one row */
    int rows;              /**< constraint rows, all islands together */
    double residual;       /**< worst natural residual over the islands, relative; 0 = solved exactly */
    int iterations;        /**< solver iterations, or pivots of the exact solver, summed over islands */
    int fallbacks;         /**< islands that needed a more careful method than the first one */
    int contained_islands; /**< islands kept from spreading bad numbers: velocities kept, forces zero */
} dWorldStepReport;

/** Switch the report on (1) or off (0, the default). Off costs nothing; on costs one more evaluation
    of the residual per step. Other values are refused. */
ODE_API void dWorldSetStepReportMode(dWorldID world, int mode);
ODE_API int dWorldGetStepReportMode(dWorldID world);

/** Copy the report of the last step. The caller sets report->struct_size; as many bytes as that
    are written, so an older program keeps working with a newer library. Returns 1, or 0 when the
    mode is off, no step has been made since it was switched on, or the call is refused (null
    argument, struct_size smaller than itself). */
ODE_API int dWorldGetStepReport(dWorldID world, dWorldStepReport* report);

/** How far a step starts from the constraint forces of the last one, as a factor 0 ... 1 on each stepper's
    usual share; default 1, 0 starts from nothing as the original does. Contacts find their forces again
    although they are new joints in every step. The answer of dWorldStep does not depend on it, only the time
    it takes. Values outside 0 ... 1 are refused. */
ODE_API void dWorldSetQuickStepWarmStarting(dWorldID world, dReal factor);
ODE_API dReal dWorldGetQuickStepWarmStarting(dWorldID world);

#ifdef __cplusplus
}
#endif

#endif
