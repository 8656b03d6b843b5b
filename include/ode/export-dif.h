/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * Writing a world down as text, for looking at it or for reading it elsewhere. */
#ifndef _ODE_EXPORT_DIF_
#define _ODE_EXPORT_DIF_

#include <ode/common.h>

#ifdef __cplusplus
extern "C" {
#endif

/** @chapter export Worlds as text

    Refused: a world that is 0 or destroyed; a file that is NULL; a call during a step. Nothing is written
    then. */

/** Write the world w to the open text file as "Dynamics Interchange Format v0.1", tables in the syntax of
    Lua: Nworld, then Nbody[i] (pose, velocities, mass, flags, geoms) and Njoint[i] (bodies,
    anchors and axes in their frames, stops, motors), newest first, i from 0. world_name: N, the prefix of the
    global names, printed as it is; NULL for none. SI units; thresholds of automatic disabling are squared, as
    they are compared. Not written: geom offsets, damping, callbacks, the contents of meshes and height fields.
    Numbers have 15 significant digits (9 in single precision) whatever the locale. [0.16] */
ODE_API void dWorldExportDIF(dWorldID w, FILE* file, const char* world_name);

#ifdef __cplusplus
}
#endif

#endif
