/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * A contact point: where two shapes meet (dContactGeom, written by dCollide) and how the surfaces
 * behave there (dSurfaceParameters, written by the program); together a dContact, from which
 * dJointCreateContact makes a joint for one step. */
#ifndef _ODE_CONTACT_H_
#define _ODE_CONTACT_H_

#include <ode/common.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Bits of dSurfaceParameters.mode: which other members count. A member whose bit is not set is
    never read. */
enum {
    dContactMu2 = 0x001,     /**< mu2 for friction direction 2 (else mu for both) */
    dContactAxisDep = 0x001, /**< same bit; with dContactRolling also rho2 and rhoN */
    dContactFDir1 = 0x002,   /**< fdir1 gives friction direction 1 */
    dContactBounce = 0x004,  /**< bounce and bounce_vel */
    dContactSoftERP = 0x008, /**< soft_erp instead of the world's ERP, normal direction */
    dContactSoftCFM = 0x010, /**< soft_cfm instead of the world's CFM, normal direction */
    dContactMotion1 = 0x020, /**< motion1: the surface moves along direction 1 */
    dContactMotion2 = 0x040, /**< motion2 */
    dContactMotionN = 0x080, /**< motionN: along the normal */
    dContactSlip1 = 0x100,   /**< slip1: force-dependent slip along direction 1 */
    dContactSlip2 = 0x200,   /**< slip2 */
    dContactRolling = 0x400, /**< rho (rho2, rhoN): friction against rolling and spinning */

    dContactApprox0 = 0x0000,   /**< mu is a force in newtons */
    dContactApprox1_1 = 0x1000, /**< mu times the normal force, direction 1 */
    dContactApprox1_2 = 0x2000, /**< the same for direction 2 */
    dContactApprox1_N = 0x4000, /**< the same for spinning about the normal */
    dContactApprox1 = 0x7000    /**< all three */
};

/** How the surfaces behave. mode and mu must always be set. */
typedef struct dSurfaceParameters {
    int mode; /**< dContact... bits */
    dReal
        mu; /**< friction: a force (N), or a coefficient with Approx1; dInfinity never slips; < 0 acts as 0 */

    dReal mu2;  /**< friction along direction 2 */
    dReal rho;  /**< rolling friction about direction 1 (about all three without AxisDep): torque (N m), or a
                   length (m) with Approx1 */
    dReal rho2; /**< rolling friction about direction 2 */
    dReal rhoN; /**< spinning friction about the normal */
    dReal bounce;     /**< restitution, 0 none ... 1 full */
    dReal bounce_vel; /**< least approach speed for a bounce, m/s; negative: never */
    dReal soft_erp;   /**< part of the penetration corrected per step */
    dReal soft_cfm;   /**< softness, (m/s)/N times the step size; with soft_erp a spring and damper */
    dReal motion1;    /**< wanted velocity of body 1 relative to body 2 along direction 1, m/s */
    dReal motion2;    /**< the same along direction 2 */
    dReal motionN;    /**< the same along the normal */
    dReal slip1;      /**< slip velocity per friction force along direction 1, (m/s)/N */
    dReal slip2;      /**< the same along direction 2 */
} dSurfaceParameters;

/** Where the shapes meet. World frame. */
typedef struct dContactGeom {
    dVector3 pos;    /**< contact position, m */
    dVector3 normal; /**< unit vector into g1: moving g1 by depth * normal parts the shapes */
    dReal depth;     /**< penetration along the normal, m, >= 0; for a ray the distance from its start */
    dGeomID g1;      /**< the first shape */
    dGeomID g2;      /**< the second shape */
    int side1;       /**< sub-element of g1 that was hit (triangle number), -1 when there is none */
    int side2;       /**< the same of g2 */
} dContactGeom;

/** Everything about one contact. */
typedef struct dContact {
    dSurfaceParameters surface; /**< how the surfaces behave */
    dContactGeom geom;          /**< where the shapes meet */
    dVector3 fdir1; /**< friction direction 1: unit, perpendicular to the normal, world frame; read with
                       dContactFDir1 only */
} dContact;

#ifdef __cplusplus
}
#endif

#endif
