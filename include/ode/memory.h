/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * Memory of the library. Objects (worlds, bodies, joints, geoms, spaces) come from dAlloc and go
 * to dFree with the size they were asked with, so a program can place or count them.
 * Set handlers before the first object exists: memory must be freed by the partner of what gave it.
 * Handlers may be called from inside any function; what they call themselves must leave objects alone. */
#ifndef _ODE_MEMORY_H_
#define _ODE_MEMORY_H_

#include <ode/odeconfig.h>

#ifdef __cplusplus
extern "C" {
#endif

/** @chapter memory Memory

    Refused: nothing. */

/** Gives `size` bytes aligned for any type, or NULL. */
typedef void* dAllocFunction(dsizeint size);
/** Resizes a block from oldsize to newsize bytes, keeping the common part. */
typedef void* dReallocFunction(void* ptr, dsizeint oldsize, dsizeint newsize);
/** Takes back a block of `size` bytes. */
typedef void dFreeFunction(void* ptr, dsizeint size);

/** Process-wide. NULL brings the default back.
    - dSetAllocHandler: Install the function fn that gives memory in place of malloc.
    - dSetReallocHandler: Install the function fn that changes the size of a block in place of realloc.
    - dSetFreeHandler: Install the function fn that takes memory back in place of free. [0.16] */
ODE_API void dSetAllocHandler(dAllocFunction* fn);
ODE_API void dSetReallocHandler(dReallocFunction* fn);
ODE_API void dSetFreeHandler(dFreeFunction* fn);

/** - dGetAllocHandler: The function that dSetAllocHandler has installed, or NULL if it is the default one.
    - dGetReallocHandler: The function that dSetReallocHandler has installed, or NULL if it is the default
      one.
    - dGetFreeHandler: The function that dSetFreeHandler has installed, or NULL if it is the default one.
      [0.16] */
ODE_API dAllocFunction* dGetAllocHandler(void);
ODE_API dReallocFunction* dGetReallocHandler(void);
ODE_API dFreeFunction* dGetFreeHandler(void);

/** Uses the handler that the program has installed, or the default one.
    - dAlloc: A block of size bytes; NULL if there is no memory.
    - dRealloc: Change the block ptr from oldsize to newsize bytes, keeping what fits; returns where it is
    now, or NULL if there is no memory.
    - dFree: Take the block ptr of size bytes back. A NULL ptr does nothing and calls no handler. [0.16] */
ODE_API void* dAlloc(dsizeint size);
ODE_API void* dRealloc(void* ptr, dsizeint oldsize, dsizeint newsize);
ODE_API void dFree(void* ptr, dsizeint size);

#ifdef __cplusplus
}
#endif

#endif
