/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * Water and other fluids in which bodies float, sink and drift. Included by ode/ext.h. */
#ifndef _ODE_FLUID_H_
#define _ODE_FLUID_H_

#include <ode/collision.h>
#include <ode/common.h>

#ifdef __cplusplus
extern "C" {
#endif

/** @chapter fluids Fluids

    A fluid fills the side of a surface that its normal points away from. Each step applies its buoyancy and drag to
    every awake body with geoms, before it solves, with every stepper. Solids count: spheres, capsules, boxes, cylinders,
    cones, ellipsoids, tapered capsules, convex hulls and closed meshes; of a body with several geoms, each for itself. Disabled geoms,
    sensors, planes, rays, height fields and transforms do not. Forces of several fluids add.
    docs/guide/howto/water.md has examples, and what is not modelled.

    Arguments:
    - fluid: the fluid.
    - world: the world.
    - body: the body.

    Refused: a fluid that is 0 or destroyed; a world that is 0 or destroyed; a body that is 0 or destroyed; a geom that is 0 or destroyed;
    numbers that are not finite; null pointers where results are written; what each function names; [dFluidCreate, dFluidDestroy, dFluidSet*] a
    call during a step. Nothing changes then, and the answer is 0. */

/** A fluid of a world. */
typedef struct dxFluid* dFluidID;

/** The height of the surface above the fluid's plane at a place of that plane (world frame, m) and a time (s); data is
    the program's. It is called on the caller's thread, in the order of bodies and geoms; it must not change the world. What is not
    finite counts as 0. */
typedef dReal dFluidSurface(void* data, const dVector3 place, dReal time);

/** Writes the velocity (m/s, world) of the fluid at a place (m, world) and a time (s) to velocity; data is the program's. It is called
    like dFluidSurface. It replaces dFluidSettings::current. */
typedef void dFluidCurrent(void* data, const dVector3 place, dReal time, dVector3 velocity);

/** What a fluid exerts. With u the velocity of a solid's submerged part against the fluid and A the shadow of the solid along u
    times its submerged share, the drag is (density/2 drag |u| + linear_drag) A u. Each field ends with its default. */
typedef struct dFluidSettings {
    unsigned struct_size; /**< sizeof(dFluidSettings), set by the caller or dFluidSettingsInit */
    dReal density;        /**< kg/m^3, 0 or more. 1000, water */
    dReal drag;           /**< coefficient of drag by pressure, 0 or more; a ball has about 0.47. 1 */
    dReal
        linear_drag; /**< drag proportional to the velocity, of skin and of waves, N s/m^3, 0 or more. 200 */
    dReal angular_drag; /**< times the drag against turning of a box of the solid's extents, 0 or more. 1 */
    dVector3 current;   /**< velocity of the fluid, m/s, world. 0 */
} dFluidSettings;

/** Fills *settings with the default of every field, and writes struct_size, which is sizeof(dFluidSettings), to it:
    dFluidSettingsInit(&settings, sizeof settings). Returns 1. [ours] */
ODE_API int dFluidSettingsInit(dFluidSettings* settings, unsigned struct_size);

/** - dFluidCreate: Create a fluid in the world, with the default settings: water below z = 0.
    - dFluidDestroy: Destroy the fluid; a world that is destroyed destroys its own. [ours] */
ODE_API dFluidID dFluidCreate(dWorldID world);
ODE_API void dFluidDestroy(dFluidID fluid);

/** - dFluidGetWorld: The world that the fluid is in.
    - dWorldGetNumFluids: How many fluids the world has.
    - dWorldGetFluid: The fluid with that index, 0 ... dWorldGetNumFluids - 1, in the order of creation. Refused: another index. [ours] */
ODE_API dWorldID dFluidGetWorld(dFluidID fluid);
ODE_API int dWorldGetNumFluids(dWorldID world);
ODE_API dFluidID dWorldGetFluid(dWorldID world, int index);

/** - dFluidSetSettings: Give the fluid a copy of *settings. Returns 1. Refused: numbers below 0 that may not be; another struct_size.
    - dFluidGetSettings: Copy the settings to *settings, whose struct_size says how many. Returns 1. [ours] */
ODE_API int dFluidSetSettings(dFluidID fluid, const dFluidSettings* settings);
ODE_API int dFluidGetSettings(dFluidID fluid, dFluidSettings* settings);

/** - dFluidSetPlane: Set the surface at rest, a x + b y + c z = d, (a, b, c) pointing out of the fluid; at first z = 0.
      (a, b, c) need not be of length 1. Refused: (a, b, c) zero.
    - dFluidGetPlane: Write a, b, c (of length 1) and d to plane, 4 reals. [ours] */
ODE_API void dFluidSetPlane(dFluidID fluid, dReal a, dReal b, dReal c, dReal d);
ODE_API void dFluidGetPlane(dFluidID fluid, dVector4 plane);

/** - dFluidSetSurface: Let surface say how high the fluid stands above its plane, with data; surface 0, the default: nowhere.
      A geom sees the plane that fits the heights at four places under its box. Bodies in such a fluid do not fall asleep.
    - dFluidSetCurrentFunction: Let current say how the fluid moves, with data; current 0, the default: as the settings say. [ours] */
ODE_API void dFluidSetSurface(dFluidID fluid, dFluidSurface* surface, void* data);
ODE_API void dFluidSetCurrentFunction(dFluidID fluid, dFluidCurrent* current, void* data);

/** - dFluidSetVolume: Restrict the fluid to a geom, volume (a pool): it acts on geoms the centre of whose submerged part lies in the volume.
      The surface stays that of the fluid. volume 0, the default: no limit; a volume that has been destroyed: the fluid acts nowhere.
      Refused: a volume that is no box, sphere, capsule, cylinder, ellipsoid or convex hull.
    - dFluidGetVolume: The geom that the fluid is restricted to; 0: none, or one that has been destroyed. [ours] */
ODE_API void dFluidSetVolume(dFluidID fluid, dGeomID volume);
ODE_API dGeomID dFluidGetVolume(dFluidID fluid);

/** - dFluidSetTime: Set the time, s, that functions of the fluid get; 0 at first. Each step adds its size.
    - dFluidGetTime: The time of the fluid, s. It is part of a world's state. [ours] */
ODE_API void dFluidSetTime(dFluidID fluid, dReal time);
ODE_API dReal dFluidGetTime(dFluidID fluid);

/** Compute what of a geom or body lies in the fluid now: its volume, m^3, and the centre of that, m, world (3 reals). Either may be 0.
    Returns 1 if anything does; 0, with zeros, if not. Exact for a flat surface: to rounding, for solids of revolution but balls to 1e-8 of the solid.
    - dFluidGetSubmerged: Of one geom, of a body or not.
    - dFluidGetSubmergedBody: Of a body, the sum of its geoms. [ours] */
ODE_API int dFluidGetSubmerged(dFluidID fluid, dGeomID geom, dReal* volume, dVector3 centre);
ODE_API int dFluidGetSubmergedBody(dFluidID fluid, dBodyID body, dReal* volume, dVector3 centre);

/** Write the force, N, and the torque about the centre of mass, N m (3 reals each, world), that all fluids exerted on the body in the last step in
    which it was awake. Either may be 0. Returns 1 if it was in a fluid; 0, with zeros, if not. [ours] */
ODE_API int dBodyGetFluidForce(dBodyID body, dVector3 force, dVector3 torque);

#ifdef __cplusplus
}
#endif

#endif
