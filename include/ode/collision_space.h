// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Spaces.
#ifndef _ODE_COLLISION_SPACE_H_
#define _ODE_COLLISION_SPACE_H_

#include <ode/common.h>

#ifdef __cplusplus
extern "C" {
#endif

struct dContactGeom;
typedef void dNearCallback(void *data, dGeomID o1, dGeomID o2);
#define dSAP_AXES_XYZ ((0) | (1 << 2) | (2 << 4))
#define dSAP_AXES_XZY ((0) | (2 << 2) | (1 << 4))
#define dSAP_AXES_YXZ ((1) | (0 << 2) | (2 << 4))
#define dSAP_AXES_YZX ((1) | (2 << 2) | (0 << 4))
#define dSAP_AXES_ZXY ((2) | (0 << 2) | (1 << 4))
#define dSAP_AXES_ZYX ((2) | (1 << 2) | (0 << 4))

ODE_API dSpaceID dHashSpaceCreate(dSpaceID space);
ODE_API void dHashSpaceGetLevels(dSpaceID space, int *minlevel, int *maxlevel);
ODE_API void dHashSpaceSetLevels(dSpaceID space, int minlevel, int maxlevel);
ODE_API dSpaceID dSimpleSpaceCreate(dSpaceID space);
ODE_API void dSpaceAdd(dSpaceID, dGeomID);
ODE_API void dSpaceClean(dSpaceID);
ODE_API void dSpaceDestroy(dSpaceID);
ODE_API int dSpaceGetClass(dSpaceID space);
ODE_API int dSpaceGetCleanup(dSpaceID space);
ODE_API dGeomID dSpaceGetGeom(dSpaceID, int i);
ODE_API int dSpaceGetManualCleanup(dSpaceID space);
ODE_API int dSpaceGetNumGeoms(dSpaceID);
ODE_API int dSpaceGetSublevel(dSpaceID space);
ODE_API int dSpaceQuery(dSpaceID, dGeomID);
ODE_API void dSpaceRemove(dSpaceID, dGeomID);
ODE_API void dSpaceSetCleanup(dSpaceID space, int mode);
ODE_API void dSpaceSetManualCleanup(dSpaceID space, int mode);
ODE_API void dSpaceSetSublevel(dSpaceID space, int sublevel);

#ifdef __cplusplus
}
#endif

#endif
