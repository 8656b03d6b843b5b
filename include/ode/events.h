/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * What happened in a step: contacts with their impact, sensors, joints that broke. Included by ode/ext.h. */
#ifndef _ODE_EVENTS_H_
#define _ODE_EVENTS_H_

#include <ode/common.h>

#ifdef __cplusplus
extern "C" {
#endif

/** @chapter events Events

    A world with event settings lists what happened in each step: which geoms touched and how hard, which
    geoms entered or left a sensor, which joints broke. docs/guide/events.md has examples.

    Contact events need world-managed contacts (ode/contacts.h), of any stepper, and sensors the same space
    (dWorldSetContactSpace). Bodies that sleep have no events. The list is in the order of dEventKind, then of
    the creation of the first and the second geom or of the joint; it is the same on any number of threads.
    After dWorldSetState and dWorldRollBack it is empty, and the next step reports what it would have reported
    then, without the ends of what touched a geom that had been destroyed since the step before: a state does
    not know that geom.

    Arguments:
    - world: the world.
    - geom: the geom.

    Refused: a world or geom that is 0 or destroyed; null pointers; what each function names. Nothing changes
    then, and the answer is 0. */

/** Kinds of events. */
typedef enum {
    dEventContactBegin,   /**< the geoms touch and did not before */
    dEventContactPersist, /**< they touch and did before */
    dEventContactEnd,     /**< they touched before and do not */
    dEventSensorBegin,    /**< a geom overlaps a sensor at the end of the step and did not before */
    dEventSensorEnd,      /**< it did before and does not */
    dEventJointBreak      /**< a joint broke (dJointSetBreakLimits) */
} dEventKind;

/** Which objects of an event no longer exist. Their handles are those that they had: names to compare with,
    which every function refuses. */
typedef enum {
    dEventGoneG1 = 1,   /**< g1 has been destroyed */
    dEventGoneG2 = 2,   /**< g2 has been destroyed */
    dEventGoneJoint = 4 /**< joint has been destroyed */
} dEventGone;

/** One event. Elements of arrays, such as this, have no struct_size. What an event does not concern is 0. */
typedef struct dEvent {
    int kind;       /**< one of dEventKind */
    int gone;       /**< sum of dEventGone: which of the handles below are of destroyed objects */
    dGeomID g1;     /**< contacts: has a body; sensors: the sensor */
    dGeomID g2;     /**< the other geom */
    dJointID joint; /**< the joint that broke */
    dVector3
        pos; /**< contacts: centre of the impulses, where the step has taken it; breaks: body 1's centre, m */
    dVector3 normal; /**< contacts: unit, into g1; breaks: direction of the force on body 1 */
    dReal
        approach_speed; /**< contacts: along the normal at the step's beginning, of the fastest point, m/s */
    dReal impulse;      /**< normal impulse, of a break that of the joint, over the whole step, N s */
} dEvent;

/** Which events a world lists. Each field ends with its default. */
typedef struct dEventSettings {
    unsigned struct_size;     /**< sizeof(dEventSettings), set by the caller or dEventSettingsInit */
    unsigned kinds;           /**< sum of 1 << dEventKind. All but dEventContactPersist */
    int capacity;             /**< events of a step that are kept, 1 ... 1048576. 1024 */
    dReal min_impulse;        /**< begin and persist events of contacts below it are left out, N s. 0 */
    dReal min_approach_speed; /**< the same by their approach speed, m/s. 0 */
} dEventSettings;

/** Fills *settings with the default of every field, and writes struct_size, which is sizeof(dEventSettings), to
    it: dEventSettingsInit(&settings, sizeof settings). Returns 1. [ours] */
ODE_API int dEventSettingsInit(dEventSettings* settings, unsigned struct_size);

/** - dWorldSetEventSettings: List events as *settings says from the next step on; settings 0, the default:
      none, at no cost. The list becomes empty; what overlaps a sensor then begins in the next step, what
      touches has begun already. Returns 1. Refused: settings smaller than `kinds` or larger than this
      library's; settings with bits that are no kind or values out of range; a call during a step; no memory
      for the list.
    - dWorldGetEventSettings: Copy the settings to *settings. Returns 1; 0, and the defaults, if there are
      none. [ours] */
ODE_API int dWorldSetEventSettings(dWorldID world, const dEventSettings* settings);
ODE_API int dWorldGetEventSettings(dWorldID world, dEventSettings* settings);

/** - dWorldGetEvents: Copy the events of the last step, at most capacity of them, to events, which may be 0
      where capacity is 0. Returns how many there are. Refused: a capacity below 0.
    - dWorldGetLostEvents: Returns how many events of the last step did not fit into the list; those that
      persist are the first to go. [ours] */
ODE_API int dWorldGetEvents(dWorldID world, dEvent* events, int capacity);
ODE_API int dWorldGetLostEvents(dWorldID world);

/** - dGeomSetSensor: Make the geom a sensor (mode 1) or an ordinary geom (mode 0, the default). World-managed
      contacts and continuous collision pass through a sensor; sensor events report the geoms that overlap it
      at the end of each step, asleep or not, if their bits agree, they or the sensor have a body of the world or they are characters,
      and they are not of one body. Sensors and rays are not reported. dSpaceCollide, dCollide and queries
      treat it as any geom: a near callback leaves it out by dGeomGetSensor. Refused: a geom that is a space or in
      a space that is being collided; other modes.
    - dGeomGetSensor: 1 if the geom is a sensor, else 0. [ours] */
ODE_API void dGeomSetSensor(dGeomID geom, int mode);
ODE_API int dGeomGetSensor(dGeomID geom);

#ifdef __cplusplus
}
#endif

#endif
