/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * What a step did: sums over the world, and island by island. Included by ode/ext.h. */
#ifndef _ODE_REPORT_H_
#define _ODE_REPORT_H_

#include <ode/common.h>

#ifdef __cplusplus
extern "C" {
#endif

/** @chapter report Step reports

    A report begins with struct_size, which the caller sets to sizeof of its structure. As many bytes are
    written, so a program keeps working when a later library has more fields: those of an older, shorter
    structure are filled and nothing behind them.

    Arguments:
    - world: the world.

    Refused: a world that is 0 or destroyed; null pointers; [dWorldGet] a struct_size that is smaller than
    the structure's first field or larger than this library's structure; what each function names. Nothing
    changes then, and the answer is 0. */

/** What the last step of a world did. Sums and worst values over its islands. Lengths in m, angles in rad,
    energies in J. */
typedef struct dWorldStepReport {
    unsigned struct_size;     /**< sizeof(dWorldStepReport), set by the caller */
    int islands;              /**< islands that were simulated */
    int bodies;               /**< bodies in them */
    int joints;               /**< joints in them that gave at least one row */
    int rows;                 /**< constraint rows, all islands together */
    double residual;          /**< worst natural residual over the islands, relative; 0 = solved exactly */
    int iterations;           /**< solver iterations, or pivots of the exact solver, summed over islands */
    int fallbacks;            /**< islands that needed a more careful method than the first one */
    int contained_islands;    /**< islands kept from spreading bad numbers: velocities kept, forces zero */
    int factorisations;       /**< sparse factorisations, summed over islands */
    double joint_error;       /**< worst distance that a joint should hold at zero, at the step's beginning */
    double joint_angle_error; /**< the same for angles, rad */
    double penetration;       /**< deepest contact beyond the surface layer, at the step's beginning */
    double energy_before;     /**< kinetic energy plus that of weight, at the step's beginning */
    double energy_after;      /**< the same at its end, before the bodies' own damping */
    int projection_iterations;   /**< Newton steps of dWorldSetStepProjection, summed over islands */
    int projections_unconverged; /**< islands that they left above the tolerance */
    double projection_error;     /**< worst error that they left, in the unit of the tolerance */
    int stopped_bodies;          /**< bodies that continuous collision (dGeomSetContinuous) has stopped */
    double friction_error;       /**< what friction is off Coulomb's, relative; dWorldStep with a cone */
    int raised_bodies; /**< light links whose inertia the step has raised, since it is too long for their loads */
    double
        raised_residual; /**< natural residual with the inertias as they are; `residual` if none is raised */
    dJointID unsolved_joint; /**< the worst joint that contradicts others; it may be gone since. 0: none */
    int unsolved_joints;     /**< how many do; dWorldStep and exact hybrid islands */
} dWorldStepReport;

/** How an island was solved. */
typedef enum {
    dIslandMethodNone,                /**< nothing to solve */
    dIslandMethodDense,               /**< exact: active set on the dense matrix of a small island */
    dIslandMethodActiveSet,           /**< exact: active set on the sparse matrix */
    dIslandMethodInteriorPoint,       /**< exact: interior point, then the active set from its answer */
    dIslandMethodSweeps,              /**< dWorldQuickStep */
    dIslandMethodSubsteps,            /**< dWorldStepFast1 */
    dIslandMethodSubstepsExactJoints, /**< substeps with all joints solved together */
    dIslandMethodJointCoordinates     /**< exact: in joint coordinates (dWorldSetJointCoordinates) */
} dIslandMethod;

/** What the last step did with one island. Fields as in dWorldStepReport. */
typedef struct dIslandStepReport {
    unsigned struct_size;       /**< sizeof(dIslandStepReport), set by the caller */
    int method;                 /**< one of dIslandMethod */
    dBodyID body;               /**< a body of the island; it may have been destroyed since the step */
    int bodies;                 /**< its bodies */
    int joints;                 /**< its joints that gave at least one row */
    int rows;                   /**< its constraint rows */
    int iterations;             /**< as in dWorldStepReport, as are those below without a text of their own */
    int factorisations;         /**< see dWorldStepReport */
    int fallback;               /**< 1: needed a more careful method than the first one */
    int contained;              /**< 1: kept from spreading bad numbers */
    double residual;            /**< see dWorldStepReport */
    double joint_error;         /**< see dWorldStepReport */
    double joint_angle_error;   /**< see dWorldStepReport */
    double penetration;         /**< see dWorldStepReport */
    double energy_before;       /**< see dWorldStepReport */
    double energy_after;        /**< see dWorldStepReport */
    int projection_iterations;  /**< see dWorldStepReport */
    int projection_unconverged; /**< 1: left above the tolerance */
    double projection_error;    /**< see dWorldStepReport */
    int stopped_bodies;         /**< see dWorldStepReport */
    double friction_error;      /**< see dWorldStepReport */
    int raised_bodies;          /**< see dWorldStepReport */
    double raised_residual;     /**< see dWorldStepReport */
    dJointID unsolved_joint;    /**< see dWorldStepReport */
    int unsolved_joints;        /**< see dWorldStepReport */
} dIslandStepReport;

/** - dWorldSetStepReportMode: Switch the report of steps on (mode 1) or off (0, the default). A report
      costs one more evaluation of the residual per step. Other values are refused.
    - dWorldGetStepReportMode: 1 if steps are reported, else 0. [ours] */
ODE_API void dWorldSetStepReportMode(dWorldID world, int mode);
ODE_API int dWorldGetStepReportMode(dWorldID world);

/** Copies the report of the world's last step to *report. Returns 1; 0 while the mode is off and before the
    first step since it was switched on. [ours] */
ODE_API int dWorldGetStepReport(dWorldID world, dWorldStepReport* report);

/** Copies to *report what the last step did in one island, 0 <= island < dWorldStepReport::islands. Islands
    are in the order in which ODE finds them, from the youngest body on. Returns as dWorldGetStepReport
    does. Refused: another index. [ours] */
ODE_API int dWorldGetIslandStepReport(dWorldID world, int island, dIslandStepReport* report);

/** @chapter ledger Energy ledger

    A world with an energy ledger splits what each step does to its energy into shares:

        kinetic_after - kinetic_before = gravity + forces + drives + friction + impacts + joints + damping
                                       + correction + integration
        potential_after - potential_before = -gravity

    to rounding. docs/guide/energy.md says what each share means and what it is for.

    Arguments:
    - world: the world.
    - mode: 1: steps keep the ledger; 0, the default: not, at no cost.
    - ledger: where to copy it, with struct_size set, as for reports.
    - island: as for dWorldGetIslandStepReport.

    Refused: a world that is 0 or destroyed; null pointers; [dWorldSet] other modes, no memory;
    [dWorldGet] a struct_size that is smaller than the structure's first field or larger than this
    library's structure; another island. Nothing changes then, and the answer is 0. */

/** What the last step did to the energy of a world or an island, J. Bodies that sleep and kinematic ones have
    none. Shares are above 0 where they add kinetic energy. */
typedef struct dEnergyLedger {
    unsigned struct_size;    /**< sizeof(dEnergyLedger), set by the caller */
    int islands;             /**< islands of the last step; 1 in that of an island */
    dBodyID body;            /**< a body of the island; it may have been destroyed since the step. World: 0 */
    double kinetic_before;   /**< kinetic energy at the step's beginning */
    double kinetic_after;    /**< at its end, after damping */
    double potential_before; /**< -sum m g.x over the bodies that gravity acts on, at the step's beginning */
    double potential_after;  /**< the same at its end */
    double gravity;          /**< work of gravity along the path */
    double forces;           /**< work of the program's forces and torques */
    double drives; /**< of drives, motors, springs, all that is soft, moving surfaces and kinematic bodies */
    double friction;    /**< of friction in contacts and axes: never above 0 */
    double impacts;     /**< of normal forces of contacts and stops, also against friction: what restitution
                             leaves of an impact */
    double joints;      /**< of rigid joints: 0 but for errors of first order in the step, and for what a
                             joint takes when it seizes bodies in relative motion */
    double damping;     /**< of dBodySetLinearDamping and its like */
    double correction;  /**< of the correction of positions: penetrations and joint errors */
    double integration; /**< what none of these explains: the error of the integration, of first order in
                             the step, and rounding */
} dEnergyLedger;

/** - dWorldSetEnergyLedgerMode: Let steps keep an account of energy. Returns 1.
    - dWorldGetEnergyLedgerMode: 1 if steps keep one, else 0. [ours] */
ODE_API int dWorldSetEnergyLedgerMode(dWorldID world, int mode);
ODE_API int dWorldGetEnergyLedgerMode(dWorldID world);

/** - dWorldGetEnergyLedger: Copy the ledger of the world's last step to *ledger.
    - dWorldGetIslandEnergyLedger: Copy that of one island to *ledger, 0 <= island <
      dEnergyLedger::islands.

    Both return 1; 0 while the mode is off and before the first step since it was switched on. [ours] */
ODE_API int dWorldGetEnergyLedger(dWorldID world, dEnergyLedger* ledger);
ODE_API int dWorldGetIslandEnergyLedger(dWorldID world, int island, dEnergyLedger* ledger);

#ifdef __cplusplus
}
#endif

#endif
