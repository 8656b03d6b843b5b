/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * Vehicles: bodies on wheels with suspension, tyres, engine and gears. Included by ode/ext.h. */
#ifndef _ODE_VEHICLE_H_
#define _ODE_VEHICLE_H_

#include <ode/common.h>
#include <ode/queries.h>

#ifdef __cplusplus
extern "C" {
#endif

/** @chapter vehicle Vehicles

    A vehicle is a body, the chassis, with wheels that are no bodies: a ray or a shape finds what each stands
    on, and dVehicleUpdate gives the chassis, and what is under it, the forces of suspensions and tyres. It
    stays a body like any other, with geoms, joints and contacts; dBodyDestroy ends it. What wheels, engine
    and gears do is part of states, histories, clones and files of worlds (state, world_file), also the
    settings in the last two. docs/guide/howto/vehicles.md explains, src/vehicles has the equations.

    Arguments:
    - vehicle: the body that dVehicleCreate has made a vehicle. Its frame is that of the body; left is up x
      forward. Its wheels look in the space of the world's contacts, or if there is none in the outermost
      space of its geoms, for geoms whose bits agree, but for its own geoms, sensors and rays.
    - wheel: the number of a wheel, 0 for the first that was added.
    - h: the size of the step, s, above 0 and at most 1.

    Refused: what is no vehicle; a wheel that it does not have; null pointers; numbers that are not finite;
    structures of a size below that of their first two fields or above this library's, or with a field
    outside what it says; [dVehicleUpdate, dVehicleCreate, dVehicleSet, dVehicleAddWheel] a call during a
    step; [dVehicleUpdate] a space that is being collided; what each function names. Nothing changes then, and
    the answer is 0. */

/** How a vehicle is driven and steered. */
typedef enum {
    dVehicleCar = 1,    /**< by the angles of its wheels */
    dVehicleBike = 2,   /**< likewise, and it leans into curves by itself */
    dVehicleTracked = 3 /**< the wheels of each side turn together; the sides turn differently to steer */
} dVehicleKind;

/** How a wheel finds what it stands on. */
typedef enum {
    dWheelRay = 1,     /**< a ray through its hub: a disc on a plane. The cheapest */
    dWheelSphere = 2,  /**< a sphere of its radius: rolls over edges and kerbs */
    dWheelCylinder = 3 /**< a cylinder of its radius and width: likewise, with its true outline */
} dWheelCast;

/** How a differential divides: between the two wheels of an axle, or between axles. */
typedef enum {
    dDifferentialOpen = 1,    /**< the same torque at any difference of speeds */
    dDifferentialLimited = 2, /**< a clutch with at most the lock torque works against a difference */
    dDifferentialLocked = 3   /**< one speed */
} dDifferential;

/** Capacities of dVehicleSettings, and how many wheels a vehicle may have. */
enum { dVehicleMaxTorquePoints = 16, dVehicleMaxGears = 10, dVehicleMaxWheels = 32 };

/** What a vehicle is, but for its wheels. Each field ends with its default. */
typedef struct dVehicleSettings {
    unsigned struct_size; /**< sizeof(dVehicleSettings), set by the caller or dVehicleSettingsInit */
    int kind;             /**< a dVehicleKind. dVehicleCar */
    dVector3 forward;     /**< in the body's frame, of any length but 0, not along up. (1, 0, 0) */
    dVector3 up;          /**< likewise; the suspensions work along it. (0, 0, 1) */
    int torque_points;    /**< of the engine's curve at full throttle, 2 ... 16; straight between them. 5 */
    dReal engine_speeds[16];  /**< rad/s, each above the one before, the first 0 or more;
        the last is the limiter's. 0, 150, 350, 550, 650 */
    dReal engine_torques[16]; /**< N m, 0 or more. 120, 220, 300, 280, 240 */
    dReal engine_inertia;     /**< kg m^2, above 0. 0.2 */
    dReal engine_drag;        /**< N m at the limiter with closed throttle, in proportion to speed. 60 */
    dReal idle_speed;         /**< rad/s, that the engine keeps by itself, 0 or more. 90 */
    int automatic;           /**< 1: it shifts by itself between forward gears; 0: dVehicleSetGear alone. 1 */
    int gears;               /**< forward, 1 ... 10. 5 */
    dReal gear_ratios[10];   /**< engine over shaft, above 0. 3.5, 2.1, 1.45, 1.1, 0.9 */
    dReal reverse_ratio;     /**< above 0. 3.3 */
    dReal final_ratio;       /**< shaft over wheels, above 0. 3.8 */
    dReal shift_time;        /**< s without drive while it shifts, 0 or more. 0.2 */
    dReal shift_up_speed;    /**< of the engine, rad/s: the automatic gearbox shifts up above it. 580 */
    dReal shift_down_speed;  /**< and down below it; it does not shift up to less. 230 */
    dReal clutch_torque;     /**< the greatest, N m, 0 or more. 700 */
    int differential;        /**< a dDifferential, of each axle; of dVehicleTracked, of the sides. Open */
    dReal lock_torque;       /**< of a limited one, N m, 0 or more. 200 */
    int centre_differential; /**< a dDifferential, between driven axles. Open */
    dReal centre_lock_torque; /**< of a limited one, N m, 0 or more. 200 */
    dReal max_steer;          /**< rad, of a wheel in the middle with steer 1, 0 ... 1.4. 0.6 */
    dReal steer_speed;        /**< rad/s, that it turns with at most, above 0. 2 */
    dReal ackermann;          /**< 1: all axles point to one centre; 0: wheels of an axle are parallel. 1 */
    dReal drag;               /**< N s^2/m^2: the air's force over the square of the speed, 0 or more. 0.4 */
    dReal downforce;          /**< N s^2/m^2, along minus up at the centre of mass, 0 or more. 0 */
    int abs;                  /**< 1: brakes, not the handbrake, keep below locking. 0 */
    dReal lean_frequency;     /**< rad/s, of dVehicleBike: how fast it leans; 0: it does not hold itself. 8 */
    dReal lean_limit;         /**< rad, 0 ... 1.4. 0.9 */
    unsigned long category_bits; /**< its wheels meet geoms whose collide bits have one of these ... ~0ul */
    unsigned long collide_bits;  /**< ... or whose category bits have one of these. ~0ul */
} dVehicleSettings;

/** A wheel with suspension, tyre and brakes. Each field ends with its default. */
typedef struct dVehicleWheel {
    unsigned struct_size; /**< sizeof(dVehicleWheel), set by the caller or dVehicleWheelInit */
    int cast;             /**< a dWheelCast. dWheelRay */
    dVector3 position;    /**< of the hub when the suspension hangs free, in the body's frame, m. (0, 0, 0) */
    dReal radius;         /**< m, above 0. 0.33 */
    dReal width;          /**< m, above 0. 0.2 */
    dReal inertia;        /**< about its axle, with its brake and shaft, kg m^2, above 0. 1 */
    int axle;             /**< the two wheels with one number are a pair, 0 ... 31. 0 */
    dReal travel;         /**< of the suspension, m, 0 or more. 0.25 */
    dReal preload;        /**< N, of the spring that hangs free, 0 or more. 0 */
    dReal stiffness;      /**< N/m, 0 or more. 30000 */
    dReal bump_damping;   /**< N s/m, where it is compressed, 0 or more. 3000 */
    dReal rebound_damping;    /**< N s/m, where it extends, 0 or more. 3000 */
    dReal stop_stiffness;     /**< N/m, beyond the travel, 0 or more. 300000 */
    dReal anti_roll;          /**< N/m, times the difference of the pair's compressions, 0 or more. 0 */
    dReal roll_centre;        /**< m above what it stands on, where lateral forces act on the chassis. 0 */
    dReal friction_x;         /**< mu forward at the nominal load, above 0. 1.1 */
    dReal friction_y;         /**< mu sideways, likewise. 1 */
    dReal stiffness_x;        /**< force over load for a small slip ratio, above 0. 18 */
    dReal stiffness_y;        /**< force over load for a small slip angle (rad), above 0. 14 */
    dReal sliding;            /**< what is left of mu in full slip, 0 ... 1. 0.8 */
    dReal nominal_load;       /**< N, above 0. 4000 */
    dReal load_sensitivity;   /**< mu falls by this share where the load doubles, 0 ... 1. 0.05 */
    dReal relaxation;         /**< m, that it rolls while its force builds up, above 0. 0.3 */
    dReal rolling_resistance; /**< force over load, 0 or more. 0.012 */
    dReal steer;              /**< times the vehicle's angle, -1 ... 1. 0 */
    dReal drive;              /**< its share of the torque, of all shares, 0 or more. 0 */
    dReal brake_torque;       /**< N m at brake 1, 0 or more. 1500 */
    dReal handbrake_torque;   /**< N m at handbrake 1, 0 or more. 0 */
} dVehicleWheel;

/** What the driver does. Each field ends with its default. */
typedef struct dVehicleControls {
    unsigned struct_size; /**< sizeof(dVehicleControls), set by the caller */
    dReal throttle;       /**< 0 ... 1. 0 */
    dReal brake;          /**< 0 ... 1. 0 */
    dReal handbrake;      /**< 0 ... 1. 0 */
    dReal steer;          /**< -1 ... 1, above 0 to the left. 0 */
    dReal clutch;         /**< 0 ... 1: pressed, nothing is driven; an automatic clutch works besides. 0 */
} dVehicleControls;

/** What the last update has done. */
typedef struct dVehicleReport {
    unsigned struct_size; /**< sizeof(dVehicleReport), set by the caller */
    int gear;             /**< -1 reverse, 0 neutral, 1 ... ; while it shifts the next */
    dReal speed;          /**< of the chassis along forward, m/s */
    dReal engine_speed;   /**< rad/s */
    dReal engine_torque;  /**< N m */
    dReal clutch_torque;  /**< N m, that the engine gives to the gearbox */
    int is_shifting;      /**< 1: no drive, for it shifts */
    int wheels_on_ground; /**< how many stand on something */
    dReal steer;          /**< the angle that it steers, rad */
    dReal lean;           /**< rad, about forward, above 0 to the right */
    dReal curvature;      /**< of the path that it steers, 1/m, above 0 to the left */
} dVehicleReport;

/** What the last update has done at a wheel. Without ground, its fields are 0. */
typedef struct dVehicleWheelReport {
    unsigned struct_size;   /**< sizeof(dVehicleWheelReport), set by the caller */
    int on_ground;          /**< 1: it stands on something */
    dGeomID ground;         /**< the geom; 0: none, or it is destroyed */
    int ground_side;        /**< its triangle if it is a mesh, else -1 */
    dVector3 ground_pos;    /**< where */
    dVector3 ground_normal; /**< unit */
    dVector3 hub;           /**< the middle of the wheel, to draw it, with or without ground, m */
    dReal steer;            /**< rad about up, above 0 to the left */
    dReal angle;            /**< that it has turned, rad, 0 ... 2 pi */
    dReal spin;             /**< rad/s, above 0 forward */
    dReal compression;      /**< of the suspension, m */
    dReal load;             /**< N along the normal */
    dReal force_x;          /**< N, forward along the ground, on the vehicle */
    dReal force_y;          /**< N, to the left */
    dReal slip_ratio;       /**< of its speed over the ground: above 0 it drives */
    dReal slip_angle;       /**< rad, from where it points to where it moves, above 0 to the left */
    dReal slip;             /**< both together: from 1 on it slides. */
} dVehicleWheelReport;

/** Fills *settings with the default of every field and writes struct_size, which is sizeof(dVehicleSettings),
    to it: dVehicleSettingsInit(&settings, sizeof settings). Returns 1. [ours] */
ODE_API int dVehicleSettingsInit(dVehicleSettings* settings, unsigned struct_size);

/** Fills *wheel with the default of every field and writes struct_size, which is sizeof(dVehicleWheel), to
    it: dVehicleWheelInit(&wheel, sizeof wheel). Returns 1. [ours] */
ODE_API int dVehicleWheelInit(dVehicleWheel* wheel, unsigned struct_size);

/** Make the body a `vehicle` without wheels, in its first `gear`, the engine at idle; null settings are the defaults.
    A history (dWorldSetHistory) cannot take it back to before. Returns 1. Refused: a body that is a `vehicle`
    already. [ours] */
ODE_API int dVehicleCreate(dBodyID body, const dVehicleSettings* settings);

/** Returns 1 if the body is a `vehicle`, else 0. [ours] */
ODE_API int dBodyIsVehicle(dBodyID body);

/** The settings.
    - dVehicleSetSettings: Give the vehicle other settings; a `gear` that it does not have any more becomes the
      highest. Returns 1. Refused: what dVehicleCreate refuses.
    - dVehicleGetSettings: Write the settings to *settings, whose struct_size the caller has set. Returns 1.
      [ours] */
ODE_API int dVehicleSetSettings(dBodyID vehicle, const dVehicleSettings* settings);
ODE_API int dVehicleGetSettings(dBodyID vehicle, dVehicleSettings* settings);

/** The wheels.
    - dVehicleAddWheel: Add a wheel that does not turn; a null wheel is the default. Returns how many it has
      now: the number of the new one plus 1. Refused: more than dVehicleMaxWheels; a third wheel of an axle of
      a dVehicleCar.
    - dVehicleGetNumWheels: Return how many it has.
    - dVehicleSetWheel: Give one other settings; it keeps its speed. Returns 1.
    - dVehicleGetWheel: Write one to *out, whose struct_size the caller has set. Returns 1. [ours] */
ODE_API int dVehicleAddWheel(dBodyID vehicle, const dVehicleWheel* wheel);
ODE_API int dVehicleGetNumWheels(dBodyID vehicle);
ODE_API int dVehicleSetWheel(dBodyID vehicle, int wheel, const dVehicleWheel* settings);
ODE_API int dVehicleGetWheel(dBodyID vehicle, int wheel, dVehicleWheel* out);

/** What the driver does, until it is changed.
    - dVehicleSetControls: Set it; a change wakes a vehicle that has fallen asleep. Returns 1.
    - dVehicleGetControls: Write it to *controls, whose struct_size the caller has set. Returns 1. [ours] */
ODE_API int dVehicleSetControls(dBodyID vehicle, const dVehicleControls* controls);
ODE_API int dVehicleGetControls(dBodyID vehicle, dVehicleControls* controls);

/** Shift: -1 reverse, 0 neutral, 1 ... forward. It takes the shift time. An automatic gearbox goes on from
    there, and never leaves reverse or neutral by itself. Returns 1. Refused: a gear that it does not
    have. [ours] */
ODE_API int dVehicleSetGear(dBodyID vehicle, int gear);

/** Let wheels, engine and gears act for a step of h seconds: their forces join those of the program on the
    chassis and on the bodies under it, for the next step of the world. Call it once for each dWorldStep,
    before it, after the program's own forces on the chassis. A vehicle that sleeps costs nothing; it wakes when the
    throttle is open in a `gear` or what it stands on moves. Returns how many wheels stand on something.
    [ours] */
ODE_API int dVehicleUpdate(dBodyID vehicle, dReal h);

/** Write what the last update has done to *report, whose struct_size the caller has set. Return 1.
    - dVehicleGetReport: The vehicle.
    - dVehicleGetWheelReport: One of its wheels. [ours] */
ODE_API int dVehicleGetReport(dBodyID vehicle, dVehicleReport* report);
ODE_API int dVehicleGetWheelReport(dBodyID vehicle, int wheel, dVehicleWheelReport* report);

#ifdef __cplusplus
}
#endif

#endif
