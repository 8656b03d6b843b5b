/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * Characters: geoms that walk, climb stairs and ride platforms as the program says. Included by ode/ext.h. */
#ifndef _ODE_CHARACTER_H_
#define _ODE_CHARACTER_H_

#include <ode/common.h>
#include <ode/queries.h>

#ifdef __cplusplus
extern "C" {
#endif

/** @chapter character Characters

    A character is an upright capsule, cylinder or box without a body. The program says how it moves; the
    library lets it collide and slide, climb steps, stick to the ground, ride what it stands on and push
    bodies. It is a geom like any other: it has a data pointer, bits, events and queries, can be disabled, and
    dGeomDestroy destroys it. Steps of the world make no contacts with it, sensors report it. Its velocity and
    its ground are part of states, histories, clones and files of worlds (state, world_file) if it is in the
    space of the world's contacts, or in the space that is copied. docs/guide/howto/characters.md explains.

    Arguments:
    - character: what dCharacterCreate returns. It collides with the other geoms of its space, and of spaces
      in that, whose bits agree with its own and that are no sensors, no rays and no classes of the program.
    - velocity: m/s, in the world's frame.
    - h: the size of the step, s, above 0 and at most 1.

    Positions of characters are those of their feet: on level ground, the ground's. Up is the direction that
    the settings give. All vectors are in the world's frame.

    Refused: what is no character; null pointers; numbers that are not finite; [dCharacterMove] a character in
    no space, in a space that is being collided or on a body; [dCharacterCreate] a space that is 0 or being
    collided; [dCharacterCreate, dCharacterSetSettings] settings outside what each field says, or of a size
    below that of their first two fields or above this library's; what each function names. Nothing changes
    then, and the answer is 0. */

/** Decides whether a character collides with another geom in one move: not if it returns 0. data is that of
    the settings, velocity is what the move was asked for. It is called once for each geom nearby, the one
    that has joined last first, and must not change the space. One-way platforms: answer 1 if the geom is the
    ground of the last report, or if the character comes down with its feet above it. */
typedef int dCharacterFilter(void* data, dGeomID character, dGeomID other, const dVector3 velocity);

/** What a character is and does. Each field ends with its default. */
typedef struct dCharacterSettings {
    unsigned struct_size; /**< sizeof(dCharacterSettings), set by the caller or dCharacterSettingsInit */
    int shape;            /**< dCapsuleClass, dCylinderClass or dBoxClass. dCapsuleClass */
    dReal radius;         /**< m; of a box, half the side of its square base. 0.3 */
    dReal height;         /**< m, from the feet to the top; of a capsule at least 2 radius. 1.8 */
    dVector3 up;          /**< of any length but 0. (0, 0, 1) */
    dReal gravity;        /**< of dCharacterWalk, m/s^2, 0 or more. 9.81 */
    dReal skin;           /**< the gap that it keeps, m, above 0 and at most radius / 4. 0.01 */
    dReal slope_limit;    /**< the steepest ground that it can stand on, rad, 0 ... 1.5. 0.87 (50 degrees) */
    dReal step_height;    /**< of steps that it climbs, m, 0 or more. 0.3 */
    dReal stick_distance; /**< how far down it follows ground that falls away, m, 0 or more. 0.3 */
    dReal mass;           /**< weighs with `gravity` on bodies that it stands on, kg; 0: nothing. 70 */
    dReal max_force;      /**< that it pushes bodies with, N, 0 or more, not infinite. 500 */
    dReal air_acceleration;   /**< of dCharacterWalk, how fast it turns in the air, m/s^2, 0 or more. 10 */
    dCharacterFilter* filter; /**< has the last word; 0: none. 0 */
    void* data;               /**< for the filter. 0 */
} dCharacterSettings;

/** What a character stands on. */
typedef enum {
    dCharacterInAir = 1,   /**< on nothing */
    dCharacterOnSteep = 2, /**< it touches ground steeper than the slope limit, and nothing better */
    dCharacterOnGround = 3 /**< it stands */
} dCharacterState;

/** What the last move has done. Without ground, its fields are 0. */
typedef struct dCharacterReport {
    unsigned struct_size;     /**< sizeof(dCharacterReport), set by the caller */
    int state;                /**< a dCharacterState; 0: it has not moved yet */
    dVector3 velocity;        /**< how it has really moved, m/s, with what carries it */
    dGeomID ground;           /**< the geom that it stands on or slides on; 0: none, or it is destroyed */
    int ground_side;          /**< its triangle if it is a mesh, else -1 */
    dVector3 ground_pos;      /**< where */
    dVector3 ground_normal;   /**< unit, of the surface: of a face, not of its edge */
    dVector3 ground_velocity; /**< of the ground at that point, m/s */
    dReal turn;               /**< angle by which the ground has turned it, about up, rad */
    dReal climbed;            /**< height of the steps that it has climbed, m */
    int hit_wall;             /**< 1: something steep was in its way */
    int hit_ceiling;          /**< 1: something above was */
    dReal overlap;            /**< depth that it could not be freed from, m; 0: none. */
} dCharacterReport;

/** Fills *settings with the default of every field and writes struct_size, which is
    sizeof(dCharacterSettings), to it: dCharacterSettingsInit(&settings, sizeof settings). Returns 1. [ours] */
ODE_API int dCharacterSettingsInit(dCharacterSettings* settings, unsigned struct_size);

/** Create a character in the space with its feet at the origin; null settings are the defaults. Returns its
    geom. [ours] */
ODE_API dGeomID dCharacterCreate(dSpaceID space, const dCharacterSettings* settings);

/** Returns 1 if the geom is a character, else 0. [ours] */
ODE_API int dGeomIsCharacter(dGeomID geom);

/** The settings.
    - dCharacterSetSettings: Give the character other settings. Returns 1. Refused: another shape, radius,
      height or up than it has; what dCharacterCreate refuses.
    - dCharacterGetSettings: Write the settings to *settings, whose struct_size the caller has set. Returns 1.
      [ours] */
ODE_API int dCharacterSetSettings(dGeomID character, const dCharacterSettings* settings);
ODE_API int dCharacterGetSettings(dGeomID character, dCharacterSettings* settings);

/** Change the height (m) while the feet stay where they are: to crouch and to stand up. Returns 1; 0 if there
    is no room above, or no height that the shape can have. [ours] */
ODE_API int dCharacterSetHeight(dGeomID character, dReal height);

/** The position of the feet, m.
    - dCharacterSetPosition: Put the feet at (x, y, z), whatever is there; it stands on nothing then.
    - dCharacterGetPosition: Write the position to feet. Returns 1. [ours] */
ODE_API void dCharacterSetPosition(dGeomID character, dReal x, dReal y, dReal z);
ODE_API int dCharacterGetPosition(dGeomID character, dVector3 feet);

/** Move the character for a step of h seconds with a velocity that the program has worked out, gravity
    included: the ground carries it first, then it collides and slides. On ground it keeps the horizontal part
    of the velocity, uphill and downhill, unless the velocity leads away from the ground. Call it once for each
    dWorldStep, after it: what carries it has moved then. Called before, it lags by the ground's motion in that
    one step. Returns the dCharacterState. Refused: a velocity above 1e4 m/s. [ours] */
ODE_API int dCharacterMove(dGeomID character, const dVector3 velocity, dReal h);

/** Walk: as dCharacterMove, but with gravity, falls and jumps. velocity is how it wants to go, relative to the
    ground; of it the part along up does not count. jump_speed (m/s) above 0 lets it jump if it stands: to the
    height jump_speed^2 / (2 gravity), whatever h. In the air it turns with air_acceleration. Returns the
    dCharacterState. Refused: a jump_speed below 0 or above 1e4. [ours] */
ODE_API int dCharacterWalk(dGeomID character, const dVector3 velocity, dReal jump_speed, dReal h);

/** The velocity.
    - dCharacterSetVelocity: Give it a velocity, as a blow or a spring board does: dCharacterWalk goes on from
      it, and leaves the ground if it leads upward.
    - dCharacterGetVelocity: Write how it has moved in the last move to velocity. Returns 1. [ours] */
ODE_API void dCharacterSetVelocity(dGeomID character, const dVector3 velocity);
ODE_API int dCharacterGetVelocity(dGeomID character, dVector3 velocity);

/** Write what the last move has done to *report, whose struct_size the caller has set. Returns 1. [ours] */
ODE_API int dCharacterGetReport(dGeomID character, dCharacterReport* report);

#ifdef __cplusplus
}
#endif

#endif
