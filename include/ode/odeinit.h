/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * Opening and closing the library. Calls are counted: each successful dInitODE2 / dInitODE wants
 * one dCloseODE, and the last one clears the process-wide state (user geom classes, collider overrides).
 * Worlds, bodies, spaces and geoms can be made before opening; dCollide asks for it first. */
#ifndef _ODE_ODEINIT_H_
#define _ODE_ODEINIT_H_

#include <ode/common.h>

#ifdef __cplusplus
extern "C" {
#endif

/** @chapter init Opening and closing the library

    Refused: as each function says. */

/** Flags of dInitODE2. */
enum dInitODEFlags {
    dInitFlagManualThreadCleanup = 0x00000001 /**< threads call dCleanupODEAllDataForThread themselves */
};

/** Flags of dAllocateODEDataForThread. */
enum dAllocateODEDataFlags {
    dAllocateFlagBasicData = 0,              /**< what every call may need */
    dAllocateFlagCollisionData = 0x00000001, /**< what dCollide may need */
    dAllocateMaskAll = ~0                    /**< everything */
};

/** Same as dInitODE2(0) followed by dAllocateODEDataForThread(dAllocateMaskAll). [0.16] */
ODE_API void dInitODE(void);

/** Open the library. uiInitFlags: bits of dInitODEFlags. Returns non-zero on success, 0 on failure. [0.16] */
ODE_API int dInitODE2(unsigned int uiInitFlags);

/** Prepare the calling thread. uiAllocateFlags: bits of dAllocateODEDataFlags. Returns non-zero on
    success. Refused (0) before the library is opened. This library keeps no data per thread, so the
    call costs nothing; it is there for programs that rightly make it. [0.16] */
ODE_API int dAllocateODEDataForThread(unsigned int uiAllocateFlags);

/** Release what dAllocateODEDataForThread made for the calling thread. Refused before opening. [0.16] */
ODE_API void dCleanupODEAllDataForThread(void);

/** Close the library once. Refused when it is not open. [guide] */
ODE_API void dCloseODE(void);

#ifdef __cplusplus
}
#endif

#endif
