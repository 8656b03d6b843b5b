/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * Joint coordinates of any type through one pair of functions, and drives on them: springs, dampers, servos,
 * rotors and dry friction, implicit in the step. Included by ode/ext.h. */
#ifndef _ODE_DRIVES_H_
#define _ODE_DRIVES_H_

#include <ode/common.h>

#ifdef __cplusplus
extern "C" {
#endif

/** @chapter drives Joint coordinates and drives

    A joint of most types has axes: directions in which it leaves its bodies free, each with a position q (m or
    rad) and a rate, which is the position's derivative:

    | type | axis 0 | axis 1 | axis 2 |
    |---|---|---|---|
    | hinge | angle | | |
    | slider | position | | |
    | universal | angle 1 | angle 2 | |
    | hinge-2 | angle 1 (steering) | angle 2 of the wheel, with the sign of its rate | |
    | piston, PR | position | angle | |
    | PU | angle 1 | angle 2 | position |
    | AMotor | angle of axis 0 | of axis 1 | of axis 2 |
    | LMotor | distance of the centres along axis 0 | along axis 1 | along axis 2 |

    Positions have the sign of the type's own functions (dJointGetHingeAngle and so on), except a hinge-2's
    second, whose angle and rate run against each other there. An AMotor in user mode has the angles that the
    program gives it. Types that are not named have no axes. A ball joint is driven by an AMotor in Euler mode
    on the same bodies.

    Arguments:
    - joint: the joint.
    - axis: number of one of its axes, 0 ... dJointGetNumAxes - 1.
    - world: the world.

    Refused: a joint or world that is 0 or destroyed; an axis that the joint does not have; null pointers;
    what each function names; [dJointSet] a call during a step. Nothing changes then, and the answer is 0. */

/** Returns how many axes the joint has: 0 ... 3, by its type; an AMotor and an LMotor have those that the
    program has given them. [ours] */
ODE_API int dJointGetNumAxes(dJointID joint);

/** - dJointGetAxisPosition: Returns the joint's position along or about one of its axes, m or rad. Angles are
      in -pi ... pi, or count turns: with stops, and after dJointSetAxisContinuous. A joint without bodies
      answers 0.
    - dJointGetAxisRate: Returns the derivative of dJointGetAxisPosition, m/s or rad/s. Unlike some of the
      types' own functions it is exact also where the bodies turn together. [ours] */
ODE_API dReal dJointGetAxisPosition(dJointID joint, int axis);
ODE_API dReal dJointGetAxisRate(dJointID joint, int axis);

/** - dJointSetAxisContinuous: Let the angle of an axis count turns always, mode 1, from where it is now, or only
      while it has stops, mode 0, the default. Turns are counted in steps: an axis may turn by less than pi in
      each. Stops compare the position: they may lie beyond half a turn. (With dBehaviour016 and mode 0 they
      compare angles in -pi ... pi.) Axes that are no angles do not change. Returns 1. Another mode is refused.
    - dJointGetAxisContinuous: Returns the mode that dJointSetAxisContinuous has set, 0 at first.
    - dJointSetAxisTurn: Say in which turn an angle is that counts turns: in the one where it is nearest to
      position, rad. Otherwise, where the program places the bodies, it is the one nearest to the middle of its
      stops, or, where these are a turn or more apart, nearest to the last. Returns 1. Refused: a position
      that is not finite. [ours] */
ODE_API int dJointSetAxisContinuous(dJointID joint, int axis, int mode);
ODE_API int dJointGetAxisContinuous(dJointID joint, int axis);
ODE_API int dJointSetAxisTurn(dJointID joint, int axis, dReal position);

/** A drive on one axis of a joint: a spring and damper towards a target, a given force, a rotor and dry
    friction. With position q and rate w it exerts

        force + stiffness (target - q) + damping (target_velocity - w),   at most force_limit,

    and besides armature times the deceleration of w, and up to friction against w. All of it is implicit:
    stiff springs stay stable at any step. Start from zeros: what is 0 is not there. */
typedef struct dDrive {
    unsigned struct_size;  /**< sizeof(dDrive), set by the caller or dDriveInit */
    dReal stiffness;       /**< N/m or N m/rad, 0 or more */
    dReal damping;         /**< N s/m or N m s/rad, 0 or more */
    dReal armature;        /**< rotor inertia times the gear ratio squared, kg or kg m^2, 0 or more */
    dReal friction;        /**< dry friction, N or N m, 0 or more */
    dReal target;          /**< position that the spring pulls to, m or rad */
    dReal target_velocity; /**< rate that the damper pulls to, m/s or rad/s */
    dReal force;           /**< feed-forward along the axis, N or N m: of a plain motor, all it does */
    dReal force_limit;     /**< of spring, damper and force together, N or N m; 0, dInfinity: none */
} dDrive;

/** Fills *drive with zeros, and writes struct_size, which is sizeof(dDrive), to it: dDriveInit(&drive, sizeof
    drive). Returns 1. Refused: what dJointSetDrive refuses as too small or too large. [ours] */
ODE_API int dDriveInit(dDrive* drive, unsigned struct_size);

/** - dJointSetDrive: Put a drive on an axis, in place of the one it has; drive NULL takes it away. It acts
      together with the axis's stops and the motor of dParamVel and dParamFMax, in every stepper and in each
      substep, until changed. An angle's target is taken modulo a turn, the shorter way, unless the axis counts
      turns (dJointGetAxisPosition). A change wakes the joint's bodies. Returns 1, or 0 when refused
      (numbers that are negative or not finite, a structure of a wrong size) or out of memory.
    - dJointGetDrive: Write to *drive, whose size the caller has set, what dJointSetDrive has set, or zeros.
      Returns 1 if the axis has a drive, else 0.
    - dJointGetDriveForce: Returns what spring, damper and feed-forward of an axis have exerted, N or N m, the
      mean over the last step; armature and friction are not in it. 0 where there are none. [ours] */
ODE_API int dJointSetDrive(dJointID joint, int axis, const dDrive* drive);
ODE_API int dJointGetDrive(dJointID joint, int axis, dDrive* drive);
ODE_API dReal dJointGetDriveForce(dJointID joint, int axis);

/** - dJointSetStopSpring: Let the stops of an axis be springs with dampers, N/m and N s/m or N m/rad and
      N m s/rad, that push back what is beyond them; with equal stops, in both directions. They hold in every
      step and substep, whatever its size, in place of dParamStopERP, dParamStopCFM and dParamBounce. Axes are
      numbered as groups of parameters are (dParamLoStop2 is a stop of axis 1). stiffness and damping, both 0:
      ERP and CFM count again. Returns 1, or 0 when refused: negative numbers; an axis without stops.
    - dJointGetStopSpring: Write to *stiffness and *damping what dJointSetStopSpring has set, zeros at first.
      Returns 1 if the axis's stops are springs, else 0. [ours] */
ODE_API int dJointSetStopSpring(dJointID joint, int axis, dReal stiffness, dReal damping);
ODE_API int dJointGetStopSpring(dJointID joint, int axis, dReal* stiffness, dReal* damping);

/** The third mode of an angular motor (dJointSetAMotorMode), next to dAMotorUser and dAMotorEuler: the rotation of body 1
    against body 2 from how they stand when the mode is set, as a vector along its axis, as long as its angle. Its components
    along the axes of body 1 are the positions of three axes, for drives that know no singular pose; the stops of axis 0 hold
    its length, 0 ... pi: the cone of a ball joint. dJointSetAMotorAxis is refused in this mode. */
enum {
    dAMotorTurn = 2 /**< the rotation vector */
};

/** A joint that is made far beyond a stop is pushed back at dParamStopERP / h times the distance: the faster, the
    smaller the step is, and it keeps that speed. A `rate` bounds it in steps that correct by velocities. It does not
    count where poses are corrected instead (dWorldSetStepProjection, dWorldSetContactMaxCorrectingVel).
    - dJointSetStopRate: Let the stops of an axis push back what is beyond them by at most `rate` times the distance,
      per second. Robots of files have 20/s. dInfinity, the default: ERP alone counts. Returns 1, or 0 when
      refused: a `rate` that is not above 0; an axis without stops.
    - dJointGetStopRate: Returns what dJointSetStopRate has set. Refused: an axis without stops. [ours] */
ODE_API int dJointSetStopRate(dJointID joint, int axis, dReal rate);
ODE_API dReal dJointGetStopRate(dJointID joint, int axis);

/** Returns what the stops of an axis have exerted along it, N or N m, the mean over the last step in which the joint acted:
    above 0 where its position is to grow. 0 of an axis within its stops, and after a state was set. Refused: an axis without stops.
    [ours] */
ODE_API dReal dJointGetStopForce(dJointID joint, int axis);

/** - dJointSetSpring: Let the rows that have the joint's own ERP and CFM be springs with dampers, N/m and
      N s/m: the anchor of a ball, the place of a fixed joint, the rod of a double ball or double hinge, the
      suspension of a hinge-2 (there dParamSuspensionERP and CFM), in every step and substep, whatever its
      size. stiffness and damping, both 0: ERP and CFM count again. Returns 1, or 0 when refused: negative
      numbers; a type without ERP and CFM of its own.
    - dJointGetSpring: Write to *stiffness and *damping what dJointSetSpring has set, zeros at first. Returns
      1 if there is such a spring, else 0. [ours] */
ODE_API int dJointSetSpring(dJointID joint, dReal stiffness, dReal damping);
ODE_API int dJointGetSpring(dJointID joint, dReal* stiffness, dReal* damping);

/** Write to *stiffness and *damping the spring and damper on which mass, kg or kg m^2, swings at so many
    hertz with this damping_ratio (1: just without overshooting): stiffness = mass w^2 and damping = 2
    damping_ratio mass w with w = 2 pi hertz. Returns 1, or 0 when refused: numbers below 0, hertz or mass of
    0. [ours] */
ODE_API int dSpringFromFrequency(dReal mass, dReal hertz, dReal damping_ratio, dReal* stiffness,
                                 dReal* damping);

/** - dJointSetBreakLimits: Let the joint break when it has exerted more than this force, N, or torque, N m,
      as the mean over a step; 0 or dInfinity: no limit, the default. Force and torque are those on body 1,
      drives and motors included, the torque about the anchor of a ball, hinge, universal, hinge-2 or fixed
      joint, else about the body's centre. A joint that breaks has acted in the whole step and is disabled at
      its end; dJointEnable mends it. Returns 1, or 0 when refused (negative numbers, a contact joint) or out
    of memory.
    - dJointGetBreakLimits: Write to *force and *torque what dJointSetBreakLimits has set, dInfinity for none.
      Returns 1 if the joint has a limit, else 0.
    - dJointIsBroken: Returns 1 if the joint has broken and has not been enabled since, else 0. [ours] */
ODE_API int dJointSetBreakLimits(dJointID joint, dReal force, dReal torque);
ODE_API int dJointGetBreakLimits(dJointID joint, dReal* force, dReal* torque);
ODE_API int dJointIsBroken(dJointID joint);

/** Write to *joints those that broke in the last step of the world, as many as capacity, the youngest first.
    joints may be NULL where capacity is 0. Returns how many broke. Negative capacities are refused. [ours] */
ODE_API int dWorldGetBrokenJoints(dWorldID world, dJointID* joints, int capacity);

#ifdef __cplusplus
}
#endif

#endif
