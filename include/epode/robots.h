/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * Robots from URDF, MJCF and SDF files: models, worlds made of them, coordinates, drives. Link with libepode_robots and
 * the library in double or single precision that it was built on. docs/guide/robots.md says more. */
#ifndef _EPODE_ROBOTS_H_
#define _EPODE_ROBOTS_H_

#include <ode/ode.h>

#ifdef __cplusplus
extern "C" {
#endif

/** @chapter robot_models Models of robots

    A model is what a file says, as data; robots in worlds are made of it, as many as wanted. Link 0 of a
    model is the world; a link has a smaller number than those that hang on it. Links that are fixed to
    others are merged with them. Positions are the coordinates of all joints in their order: one of a hinge
    (rad) or slider (m), the four of a quaternion of a ball, and seven, position and quaternion, of a free
    joint.

    Arguments:
    - model: a model that dRobotModelLoad or dRobotModelLoadText has returned.
    - capacity: how many elements the array has, 0 or more; 0 to ask for the number alone, the array may then
      be null.
    - name: of a link, joint, actuator or start pose, as in the file.

    Refused: a model that is 0 or destroyed; null pointers; numbers that are not finite or beyond 1e30 (1e9 in
    floats); a negative capacity; what each function names. Nothing changes then, and the answer is 0. */

/** A model. Its handle is never that of another one. */
typedef struct dxRobotModel* dRobotModelID;

/** How a file is read. Start from dRobotOptionsInit. */
typedef struct dRobotOptions {
    unsigned struct_size;    /**< sizeof(dRobotOptions), set by the caller or dRobotOptionsInit */
    int strict;              /**< 1: what is approximated or ignored is an error */
    int keep_fixed;          /**< 1: links that are fixed to others stay links */
    int fixed_base;          /**< 1: the root link of a URDF is fixed to the world */
    int repair;              /**< 1: inertias that no body can have are mended */
    int inertia_from_shapes; /**< 1: moving links without an inertial get that of their shapes, 1000 kg/m^3 */
    int meshes_as_triangles; /**< 1: meshes collide as triangles, 0: as their convex hulls */
    dReal missing_mass; /**< mass of other moving links without an inertial, kg; 0: such a link is an error */
    const char* roots;  /**< more folders that may be read, a colon between two; NULL: none */
    int meshes_as_parts;   /**< 1: meshes that are not convex collide as several hulls each */
    int max_parts;         /**< of a mesh, up to 256; 0: 32 */
    int max_part_vertices; /**< of such a hull, 4 or more; 0: 64 */
    dReal part_tolerance;  /**< how far a hull may reach out of its mesh, m; 0: 2.5 % of its longest side */
} dRobotOptions;

/** Fills *options with zeros, and writes struct_size, which is sizeof(dRobotOptions), to it. Returns 1.
    Refused: another struct_size. [ours] */
ODE_API int dRobotOptionsInit(dRobotOptions* options, unsigned struct_size);

/** Files are read in the folder of path, its parent, its ROS package, the folders of options->roots and
    packages that package:// finds there, in ROS_PACKAGE_PATH, AMENT_PREFIX_PATH or upwards. options may be
    NULL: as dRobotOptionsInit leaves them. The root element says whether it is URDF, MJCF or SDF. A model with
    errors is returned too, for its report; a message tells the first. Destroy it with dRobotModelDestroy.
    - dRobotModelLoad: Read the robot file path.
    - dRobotModelLoadText: Read the size bytes of text as if they were the file path. [ours] */
ODE_API dRobotModelID dRobotModelLoad(const char* path, const dRobotOptions* options);
ODE_API dRobotModelID dRobotModelLoadText(const char* path, const char* text, dsizeint size,
                                          const dRobotOptions* options);

/** Writes the model to the file path: as URDF if it ends in .urdf, as MJCF if in .xml or .mjcf. Paths of meshes
    count from its folder. A message names each thing that the format cannot say. Returns 1, or 0 when
    refused: a model with errors, another ending, a file that cannot be written. [ours] */
ODE_API int dRobotModelSave(dRobotModelID model, const char* path);

/** Destroys the model. Robots that were made of it stay. [ours] */
ODE_API void dRobotModelDestroy(dRobotModelID model);

/** What a line of a report is about. */
typedef enum {
    dRobotChanged,      /**< read as something else with the same motion */
    dRobotApproximated, /**< read as something with nearly the same motion */
    dRobotIgnored,      /**< left out */
    dRobotError         /**< wrong: no robot is made of the model */
} dRobotNote;

/** A line of a model's report. The texts live as long as the model. */
typedef struct dRobotReportLine {
    int note;         /**< a dRobotNote */
    int line;         /**< in the file, 0 where unknown */
    const char* file; /**< its path */
    const char* text; /**< what happened */
} dRobotReportLine;

/** - dRobotModelGetReport: Copies up to capacity lines of the report to lines. Returns how many there are.
    - dRobotModelHasErrors: Returns 1 if the report has an error, else 0. [ours] */
ODE_API int dRobotModelGetReport(dRobotModelID model, dRobotReportLine* lines, int capacity);
ODE_API int dRobotModelHasErrors(dRobotModelID model);

/** A link. The name lives as long as the model. */
typedef struct dRobotLink {
    const char* name; /**< as in the file */
    int parent;       /**< its number, -1 of link 0 */
    int joints;       /**< between it and its parent */
    int shapes;       /**< that touch */
    dReal mass;       /**< kg */
    dVector3 centre;  /**< of mass, in the link's frame, m */
    dMatrix3 inertia; /**< about the centre, in the link's axes, kg m^2 */
} dRobotLink;

/** What a joint of a model leaves free. */
typedef enum {
    dRobotHinge, /**< an angle about the axis */
    dRobotSlide, /**< a distance along the axis */
    dRobotBall,  /**< a turn about the anchor */
    dRobotFree   /**< everything */
} dRobotJointKind;

/** A joint between a link and its parent. The name lives as long as the model. */
typedef struct dRobotJoint {
    const char* name;   /**< as in the file */
    int kind;           /**< a dRobotJointKind */
    int link;           /**< the link that it moves */
    int position;       /**< number of its first coordinate among all */
    dVector3 anchor;    /**< in the link's frame, m */
    dVector3 axis;      /**< in the link's frame, of unit length */
    dReal low;          /**< lower limit of its coordinate, -dInfinity for none */
    dReal high;         /**< upper limit, dInfinity for none */
    dReal max_force;    /**< N or N m, dInfinity for none */
    dReal max_velocity; /**< m/s or rad/s, dInfinity for none */
} dRobotJoint;

/** An actuator. The name lives as long as the model. */
typedef struct dRobotActuator {
    const char* name; /**< as in the file */
    int joint;        /**< that it acts on, -1 of one that acts on a tendon, a site or a link */
    int is_filtered;  /**< 1: its force follows its activation, which follows the control in time */
    dReal low;        /**< least control, -dInfinity for none */
    dReal high;       /**< largest control, dInfinity for none */
} dRobotActuator;

/** - dRobotModelGetLinks: Copies up to capacity links to links. Returns how many there are.
    - dRobotModelGetJoints: Copies up to capacity joints to joints. Returns how many there are.
    - dRobotModelGetActuators: Copies up to capacity actuators to actuators. Returns how many there are.
    - dRobotModelGetNumPositions: Returns how many coordinates the joints have.
    - dRobotModelGetNumActuators: Returns how many actuators the model has.
    - dRobotModelGetNumStarts: Returns how many named start poses the model has. [ours] */
ODE_API int dRobotModelGetLinks(dRobotModelID model, dRobotLink* links, int capacity);
ODE_API int dRobotModelGetJoints(dRobotModelID model, dRobotJoint* joints, int capacity);
ODE_API int dRobotModelGetActuators(dRobotModelID model, dRobotActuator* actuators, int capacity);
ODE_API int dRobotModelGetNumPositions(dRobotModelID model);
ODE_API int dRobotModelGetNumActuators(dRobotModelID model);
ODE_API int dRobotModelGetNumStarts(dRobotModelID model);

/** - dRobotModelFindLink: Returns the number of the link of that name; merged links and sites are those that
      they are part of. -1 if there is none.
    - dRobotModelFindJoint: Returns the number of the joint of that name, or -1.
    - dRobotModelFindActuator: Returns the number of the actuator of that name, or -1. [ours] */
ODE_API int dRobotModelFindLink(dRobotModelID model, const char* name);
ODE_API int dRobotModelFindJoint(dRobotModelID model, const char* name);
ODE_API int dRobotModelFindActuator(dRobotModelID model, const char* name);

/** - dRobotModelGetReference: Copies up to capacity coordinates of the pose in which the file describes the
      robot to positions. Returns how many there are.
    - dRobotModelGetStart: Copies up to capacity coordinates of the start pose of that number to positions.
      Returns how many there are. Refused: a number outside 0 ... dRobotModelGetNumStarts - 1.
    - dRobotModelGetStartName: Returns the name of that start pose, which lives as long as the model. NULL is
      returned where the number is refused. [ours] */
ODE_API int dRobotModelGetReference(dRobotModelID model, dReal* positions, int capacity);
ODE_API int dRobotModelGetStart(dRobotModelID model, int number, dReal* positions, int capacity);
ODE_API const char* dRobotModelGetStartName(dRobotModelID model, int number);

/** Writes the pose of up to capacity links in the model's world to poses, 7 reals each: position, m, and
    quaternion. positions: count coordinates. Returns how many links there are. Refused: a count other than
    dRobotModelGetNumPositions. [ours] */
ODE_API int dRobotModelGetPoses(dRobotModelID model, const dReal* positions, int count, dReal* poses,
                                int capacity);

/** @chapter robot_dynamics Kinematics and dynamics of a model

    What a controller computes of a model, without a world. Couplings and loops do not count, but in inverse
    kinematics; dRobotModelGetConstraints has what they ask of velocities. Velocities are one of a hinge
    (rad/s) or slider (m/s), three of a ball, its angular velocity in the link's axes, and six of a free
    joint: the velocity of the link's origin in the world's axes, then the angular velocity in the link's.

    Arguments:
    - model: a model.
    - positions: as many coordinates as dRobotModelGetNumPositions.
    - capacity: how many elements the array has, 0 or more; 0 to ask for the number alone, the array may then
      be null.

    Refused: a model that is 0, destroyed or has errors; null pointers; numbers that are not finite or beyond
    1e30 (1e9 in floats); a negative capacity; what each function names. Nothing changes then, and the answer
    is 0. */

/** Returns how many velocities the joints of the model have. [ours] */
ODE_API int dRobotModelGetNumVelocities(dRobotModelID model);

/** Writes the Jacobian of a point of a link (in its frame, m; NULL: its origin) to jacobian: six rows, linear
    then angular, in the world's axes, each of as many reals as there are velocities. At most capacity reals
    are written. Returns how many there are. Refused: no such link. [ours] */
ODE_API int dRobotModelGetJacobian(dRobotModelID model, const dReal* positions, int link, const dReal* point,
                                   dReal* jacobian, int capacity);

/** Writes how far couplings and loops are from what they ask, c(positions), to residuals, and C = dc/ds, s being
    the velocities, to jacobian, row by row. A coupling has one row (the sum of its factors times coordinates
    less its offset); a loop three (m, in the world's axes), and three more (rad) if it is welded. Motions that
    keep them have C s = 0: of a frame with the Jacobian J only J N counts, the columns of N being a basis of
    those s. At most capacity rows are written; either array may be NULL. Returns how many rows there are.
    [ours] */
ODE_API int dRobotModelGetConstraints(dRobotModelID model, const dReal* positions, dReal* residuals,
                                      dReal* jacobian, int capacity);

/** Writes the gravity of the file, m/s^2, three reals; steps take that of the world that the robot is built in. Returns 1.
    Refused: a NULL gravity. [ours] */
ODE_API int dRobotModelGetGravity(dRobotModelID model, dReal* gravity);

/** Returns the time of a step that the file asks for (MJCF's timestep, SDF's max_step_size), s; 0 where it does not say. Who
    steps the world decides. [ours] */
ODE_API dReal dRobotModelGetStepsize(dRobotModelID model);

/** Writes the mass matrix to matrix, row by row, rotor inertias on its diagonal. At most capacity reals are
    written. Returns how many there are: the square of the number of velocities. [ours] */
ODE_API int dRobotModelGetMassMatrix(dRobotModelID model, const dReal* positions, dReal* matrix,
                                     int capacity);

/** Writes to forces what gives the accelerations at these velocities, against the file's gravity: a force, N
    or N m, for each velocity. Springs, dampers and friction are not in it. velocities and accelerations may
    be NULL: zeros; both NULL: gravity compensation. At most capacity reals are written. Returns how many
    there are. [ours] */
ODE_API int dRobotModelGetInverseDynamics(dRobotModelID model, const dReal* positions,
                                          const dReal* velocities, const dReal* accelerations, dReal* forces,
                                          int capacity);

/** Writes what the medium of the file exerts at these velocities (MJCF: density, viscosity and wind of its option; the
    inertia model of MuJoCo) to forces: a force, N or N m, for each velocity; zeros without a medium. At most
    capacity reals are written. Returns how many there are. [ours] */
ODE_API int dRobotModelGetFluidForces(dRobotModelID model, const dReal* positions, const dReal* velocities,
                                      dReal* forces, int capacity);

/** - dRobotModelFindTendon: Returns the number of the tendon of that name (MJCF), or -1.
    - dRobotModelGetTendons: Writes the lengths of up to capacity tendons to lengths: of a spatial one that of its way over
      sites and round geoms (m), of a fixed one its sum of coordinates; and their moment arms, the derivatives of the
      lengths by the velocities, to jacobian, row by row. Either array may be NULL. Returns how many tendons there
      are. [ours] */
ODE_API int dRobotModelFindTendon(dRobotModelID model, const char* name);
ODE_API int dRobotModelGetTendons(dRobotModelID model, const dReal* positions, dReal* lengths,
                                  dReal* jacobian, int capacity);

/** Returns the number of the link of that name, or of the link that the merged link or site of that name is
    part of, and writes where it stands in that link's frame to frame: 7 reals, position and quaternion.
    Returns -1 if there is none; frame stays then. [ours] */
ODE_API int dRobotModelFindFrame(dRobotModelID model, const char* name, dReal* frame);

/** Where inverse kinematics is to bring a frame. Start from dRobotTargetInit. */
typedef struct dRobotTarget {
    int link;                 /**< that the frame belongs to */
    dVector3 point;           /**< the frame's origin in the link's frame, m; 0 */
    dQuaternion point_q;      /**< its turn there; none */
    dVector3 position;        /**< where the origin is to be, in the model's world, m */
    dQuaternion q;            /**< how the frame is to be turned; not at all */
    dReal position_weight;    /**< factor of an error of 1 m, 0: any position; 1 */
    dReal orientation_weight; /**< factor of an error of 1 rad, 0: any orientation; 1 */
} dRobotTarget;

/** How inverse kinematics searches. Start from dRobotInverseOptionsInit. */
typedef struct dRobotInverseOptions {
    unsigned struct_size; /**< sizeof(dRobotInverseOptions), which dRobotInverseOptionsInit sets */
    int max_iterations;   /**< of a start, 1 ... 1000; 100 */
    int max_starts;       /**< from the given positions, then farther and farther away, 1 ... 1000; 32 */
    dReal tolerance;      /**< weighted error of a target that is reached; 1e-10, in floats 1e-5 */
    const dReal* weights; /**< of each velocity: 0: it stays, 2: rather than one of 1; NULL: 1 each */
    const dReal* posture; /**< positions to be near where the targets leave a choice; NULL: none */
} dRobotInverseOptions;

/** What inverse kinematics found. Set struct_size before. */
typedef struct dRobotInverseResult {
    unsigned struct_size;    /**< sizeof(dRobotInverseResult), set by the caller */
    int is_reached;          /**< 1: all targets within the tolerance */
    int starts;              /**< that were made */
    int iterations;          /**< of all starts */
    dReal residual;          /**< root of the sum of the squares of all weighted errors */
    dReal position_error;    /**< the largest, m */
    dReal orientation_error; /**< the largest, rad */
} dRobotInverseResult;

/** - dRobotTargetInit: Fills *target with the defaults for that link. Returns 1.
    - dRobotInverseOptionsInit: Fills *options with the defaults. Returns 1. Refused: a struct_size other than
      sizeof(dRobotInverseOptions). [ours] */
ODE_API int dRobotTargetInit(dRobotTarget* target, int link);
ODE_API int dRobotInverseOptionsInit(dRobotInverseOptions* options, unsigned struct_size);

/** Replaces positions by those, within the limits of the joints, at which count targets are reached, or by the
    nearest that it found. Couplings and loops hold, also where targets cannot be reached. Damped least
    squares; the same arguments give the same bits. options may be NULL: the defaults; result may be NULL. Returns 1 if the targets are reached, 2 if not, and 0 when refused:
    targets without a link, weights that are negative, structures of another size. [ours] */
ODE_API int dRobotModelGetInverse(dRobotModelID model, const dRobotTarget* targets, int count,
                                  const dRobotInverseOptions* options, dReal* positions,
                                  dRobotInverseResult* result);

/** @chapter robots Robots in worlds

    A robot is the bodies, joints and geoms that a model became in a world. The program may use all of them
    with ODE's functions; it must not destroy them one by one. Destroy a robot before its world and space.

    Arguments:
    - robot: a robot that dRobotCreate has returned.
    - model: a model.
    - count: how many elements the array has.
    - joint: number of a joint of the model.
    - link: number of a link of the model.

    Refused: a robot or model that is 0 or destroyed; null pointers; numbers that are not finite or beyond 1e30
    (1e9 in floats); what each function names. Nothing changes then, and the answer is 0. */

/** A robot. Its handle is never that of another one. */
typedef struct dxRobot* dRobotID;

/** - dRobotCreate: Makes a robot of the model in the world, with its geoms in the space (NULL: in none).
      position and q place the model's world in the world; either may be NULL: none. It begins at the
      reference position. A message names what is not built. Refused: a model with errors.
    - dRobotDestroy: Destroys the robot's bodies, joints and geoms. [ours] */
ODE_API dRobotID dRobotCreate(dWorldID world, dSpaceID space, dRobotModelID model, const dReal* position,
                              const dReal* q);
ODE_API void dRobotDestroy(dRobotID robot);

/** - dRobotGetBody: Returns the body of a link, 0 of link 0 where it has none. Refused: no such link.
    - dRobotGetJoint: Returns ODE's joint of a joint of the model, whose axis 0 it is; 0 of a free joint, and
      0 with a message of a number that no joint has. [ours] */
ODE_API dBodyID dRobotGetBody(dRobotID robot, int link);
ODE_API dJointID dRobotGetJoint(dRobotID robot, int joint);

/** - dRobotSetPositions: Moves all bodies to where the count coordinates of positions put them, at rest.
      Returns 1. Refused: a count other than dRobotModelGetNumPositions.
    - dRobotGetPositions: Copies up to capacity coordinates to positions (0 to ask for the number alone, the
      array may then be null). Returns how many there are. Refused: a negative capacity. [ours] */
ODE_API int dRobotSetPositions(dRobotID robot, const dReal* positions, int count);
ODE_API int dRobotGetPositions(dRobotID robot, dReal* positions, int capacity);

/** - dRobotSetVelocities: Gives all bodies the velocities that the count velocities of the joints make, where
      they are. Returns 1. Refused: a count other than dRobotModelGetNumVelocities.
    - dRobotGetVelocities: Copies up to capacity velocities to velocities (0 to ask for the number alone, the
      array may then be null). Returns how many there are. Refused: a negative capacity. [ours] */
ODE_API int dRobotSetVelocities(dRobotID robot, const dReal* velocities, int count);
ODE_API int dRobotGetVelocities(dRobotID robot, dReal* velocities, int capacity);

/** - dRobotSetControl: Sets the control of an actuator, by its number in the model, clamped to its range.
      Returns 1. Refused: no such actuator.
    - dRobotGetControl: Returns it, 0 at first. Refused: no such actuator.
    - dRobotSetTarget: Lets a hinge or slider be pulled to the target, m or rad, by a spring of stiffness and
      a damper of damping, at most the joint's max_force, next to the model's own springs and dampers;
      both 0: no longer. Returns 1, or 0 when refused: a negative argument; an index that no hinge or slider
      has. [ours] */
ODE_API int dRobotSetControl(dRobotID robot, int actuator, dReal control);
ODE_API dReal dRobotGetControl(dRobotID robot, int actuator);
ODE_API int dRobotSetTarget(dRobotID robot, int joint, dReal target, dReal stiffness, dReal damping);

/** Adds what the medium of the file exerts to what acts on the robot's bodies until the next step: call it before
    each, with its size, s. What would turn a link's motion round within such a step only stops it (0: it is
    exerted as it is). Returns how many links of the file it acts on: 0 without a medium. Refused: a negative
    stepsize. [ours] */
ODE_API int dRobotAddFluidForces(dRobotID robot, dReal stepsize);

/** Adds all that acts only from step to step: call it before each, with its size, s. It moves the filters of actuators on,
    and adds spatial tendons (springs, dampers, limits, actuators) and what dRobotAddFluidForces adds to what acts on
    the bodies. A tendon that is stiffer than steps of that size can follow is as stiff as
    they can; a limit gives way by the square of the step times the acceleration that it stops. Without calls
    spatial tendons do nothing, and filtered actuators act at once. Returns how many filters, tendons and links
    it acts on. Refused: a stepsize that is not above 0. [ours] */
ODE_API int dRobotAddForces(dRobotID robot, dReal stepsize);

/** What the force of a filtered actuator follows instead of what dRobotSetControl has set; 0 at first.
    - dRobotSetActivation: Sets it to activation, within its range; nothing changes of an actuator without a filter.
      Returns 1.
    - dRobotGetActivation: Returns it, 0 of an actuator without a filter.
    Refused: no such actuator. [ours] */
ODE_API int dRobotSetActivation(dRobotID robot, int actuator, dReal activation);
ODE_API dReal dRobotGetActivation(dRobotID robot, int actuator);

/** Bodies that the program moves (MJCF: mocap): they stand where they have been put, whatever touches them, and pull what is
    welded to them.
    - dRobotModelGetNumMocap: Returns how many there are.
    - dRobotModelGetMocap: Returns the link of the one of that number. Refused: no such number (0 is returned).
    - dRobotSetMocap: Puts such a link at the position, m, and quaternion q in the world; NULL: as it is. Returns 1.
      Refused: a link that is none of them; a quaternion of length 0. [ours] */
ODE_API int dRobotModelGetNumMocap(dRobotModelID model);
ODE_API int dRobotModelGetMocap(dRobotModelID model, int number);
ODE_API int dRobotSetMocap(dRobotID robot, int link, const dReal* position, const dReal* q);

/** What a robot has in addition to its world's state (dWorldGetState): controls, activations and what joints are pulled to. Save both,
    and set this after dWorldSetState; then the robot goes on with the same bits.
    - dRobotGetState: Copies up to capacity `numbers` (0 to ask how many there are, `numbers` may then be null). Returns
      how many there are, as many for all robots of a model. Refused: a negative capacity.
    - dRobotSetState: Sets them, and lets sensors begin again. Returns 1. Refused: another count; `numbers` that no robot
      of this model has returned. [ours] */
ODE_API int dRobotGetState(dRobotID robot, dReal* numbers, int capacity);
ODE_API int dRobotSetState(dRobotID robot, const dReal* numbers, int count);

#ifdef __cplusplus
}
#endif

#endif
