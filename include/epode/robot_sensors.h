/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * What the sensors of a robot in a world read: joints, accelerations, forces in joints, touch, distances, pictures with
 * depth. docs/guide/sensors.md says more. */
#ifndef _EPODE_ROBOT_SENSORS_H_
#define _EPODE_ROBOT_SENSORS_H_

#include <epode/robots.h>

#ifdef __cplusplus
extern "C" {
#endif

/** @chapter robot_sensors Sensors of robots

    Readings are of the last step: where the bodies are, the contacts that the world has found, the forces that
    its joints have borne. A sensor is anywhere on a link; dRobotModelFindFrame has the links and poses of sites
    and merged links.

    Arguments:
    - robot: a robot that dRobotCreate has returned.
    - model: a model.
    - link: number of a link of the model; 0 is the world.
    - frame: the sensor's pose in the link's frame, 7 reals, position (m) and quaternion; NULL: the link's own.
    - space: what rays meet.
    - capacity: how many elements the array has, 0 or more; 0 to ask for the number alone, the array may then
      be null.

    Refused: a robot or model that is 0 or destroyed; a link that there is not; null pointers; numbers that are
    not finite or beyond 1e30 (1e9 in floats); a quaternion that is 0; a negative capacity; what each function
    names. Nothing changes then, and the answer is 0. */

/** Notes how all bodies of the robot move, so that dRobotGetImu knows their accelerations: call it after every
    step, with its size, s. Returns 1. Refused: a stepsize that is not positive. [ours] */
ODE_API int dRobotUpdateSensors(dRobotID robot, dReal stepsize);

/** Copies what springs, dampers and actuators of the joints have exerted, the mean over the last step, to
    forces: a number, N or N m, for each velocity; 0 of balls and free joints. Returns how many there are. [ours]
 */
ODE_API int dRobotGetDriveForces(dRobotID robot, dReal* forces, int capacity);

/** Reads an inertial measurement unit, in its own axes: specific_force, m/s^2, is acceleration minus gravity,
    the mean over the last step (at rest: 9.81 upwards), and angular_velocity, rad/s, the present one. Either may
    be NULL. Returns 1. Refused: a robot without dRobotUpdateSensors after its first step. [ours] */
ODE_API int dRobotGetImu(dRobotID robot, int link, const dReal* frame, dReal* specific_force,
                         dReal* angular_velocity);

/** - dRobotSetForceSensor: Lets steps write down (mode 1) what the joint between the link and its parent bears,
      or no longer (0). Returns 1, or 0 when refused: another mode, a link that no joint holds.
    - dRobotGetForceTorque: Reads what the link has exerted on its parent through that joint in the last step,
      in the frame's axes: force, N, and torque about its origin, N m. Either may be NULL. Returns 1. Refused:
      a link without dRobotSetForceSensor. [ours] */
ODE_API int dRobotSetForceSensor(dRobotID robot, int link, int mode);
ODE_API int dRobotGetForceTorque(dRobotID robot, int link, const dReal* frame, dReal* force, dReal* torque);

/** What touches a link. */
typedef struct dRobotTouch {
    unsigned struct_size; /**< sizeof(dRobotTouch), set by the caller */
    int points;           /**< of contact that bear something */
    dReal normal_force;   /**< sum of all normal forces, N */
    dVector3 force;       /**< on the link, friction included, in the world's axes, N */
    dVector3 centre;      /**< of pressure, in the world, m */
} dRobotTouch;

/** Sums the contacts of a link in the last step: those that the world manages (dWorldSetContactSpace). Set
    touch->struct_size, sizeof(dRobotTouch), before; another one is refused. Returns 1. [ours] */
ODE_API int dRobotGetTouch(dRobotID robot, int link, dRobotTouch* touch);

/** Casts count rays from the frame's origin, as a rangefinder or lidar does. directions: 3 reals each, of any
    length, in the frame's axes. ranges gets the distances to the nearest geoms that are not the link's, m, dInfinity
    beyond max_distance; geoms may be NULL and gets what was hit, or 0. Returns how many rays hit something.
    Refused: a direction of length 0; a count or max_distance below 0. [ours] */
ODE_API int dRobotCastRays(dRobotID robot, int link, const dReal* frame, dSpaceID space, int count,
                           const dReal* directions, dReal max_distance, dReal* ranges, dGeomID* geoms);

/** A pinhole camera. It looks along its -z axis, x to the right, y up. Start from dRobotCameraInit. */
typedef struct dRobotCamera {
    unsigned struct_size; /**< sizeof(dRobotCamera), set by the caller */
    int width;            /**< pixels of a row, 1 ... 8192; 320 */
    int height;           /**< rows, 1 ... 8192; 240 */
    dReal field;          /**< of view, from the lowest to the highest row, rad; 0.8 */
    dReal max_distance;   /**< what is farther is not seen, m; 100 */
    int threads;          /**< that work on it, 0: one for each processor; 1 */
} dRobotCamera;

/** Fills *camera with the defaults. Returns 1. Refused: a struct_size other than sizeof(dRobotCamera). [ours] */
ODE_API int dRobotCameraInit(dRobotCamera* camera, unsigned struct_size);

/** Takes a picture by a ray for each pixel, row by row from the top, without a display or graphics card. The
    link's own geoms are not seen. depth: distances along the view axis, m, dInfinity of nothing. geoms: what is
    seen, 0 of nothing. color: red, green and blue, 0 ... 255, lit from above. Each may be NULL. Returns how many
    pixels see something. Refused: a camera outside its limits or of another size. [ours] */
ODE_API int dRobotTakePicture(dRobotID robot, int link, const dReal* frame, dSpaceID space,
                              const dRobotCamera* camera, dReal* depth, dGeomID* geoms, unsigned char* color);

/** A sensor that a file names. The texts live as long as the model. */
typedef struct dRobotSensor {
    const char* name;   /**< as in the file */
    const char* kind;   /**< as in the file: accelerometer, gyro, force, torque, touch ... */
    const char* object; /**< on what it sits */
    int values;         /**< that dRobotReadSensor reads, 0: it is not computed */
} dRobotSensor;

/** Copies up to capacity sensors that the file of the model names to sensors. Returns how many there are. [ours]
 */
ODE_API int dRobotModelGetSensors(dRobotModelID model, dRobotSensor* sensors, int capacity);

/** Reads a sensor of the file, by its number: at most capacity numbers are written to values. Returns how many
    there are. space is what rangefinders meet, 0 where there are none. Refused: no such sensor; one that is not
    computed; what it cannot read yet. [ours] */
ODE_API int dRobotReadSensor(dRobotID robot, int sensor, dSpaceID space, dReal* values, int capacity);

#ifdef __cplusplus
}
#endif

#endif
