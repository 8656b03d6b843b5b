/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * Why a simulation goes wrong: causes with the objects to blame. Included by ode/ext.h. */
#ifndef _ODE_DIAGNOSIS_H_
#define _ODE_DIAGNOSIS_H_

#include <ode/common.h>

#ifdef __cplusplus
extern "C" {
#endif

/** @chapter diagnosis Diagnosis

    A world that is diagnosed looks at each step for what makes simulations fail, and keeps what it has found.
    docs/guide/diagnosis.md has the causes and their remedies.

    Arguments:
    - world: the world.

    Refused: a world that is 0 or destroyed; null pointers; what each function names. Nothing changes then,
    and the answer is 0. */

/** Causes of failure. `figure` and `threshold` of a dDiagnosis are in the unit that is named here. */
typedef enum {
    dDiagnosisInput,         /**< the program set a huge velocity or force: m/s that it set or adds in a step;
                            or a call was refused: refusals before a step */
    dDiagnosisInertia,       /**< inertia far from the shapes': its radius over theirs; or not that of a body:
                            largest moment over the sum of the others */
    dDiagnosisOverlap,       /**< geoms started in each other: depth over the thinner one's half thickness */
    dDiagnosisContradiction, /**< joints that cannot hold together: error that stays, m or rad */
    dDiagnosisStiffSpring,   /**< the program's force overshoots in each step: h^2 k/m; 4 is unstable */
    dDiagnosisStepTooLong,   /**< the body rotates, or would swing under its load, too far in a step: rad */
    dDiagnosisMassRatio,     /**< a light body carries heavy ones: mass over mass */
    dDiagnosisTunnelling,    /**< a body has passed through a geom: distance over its half thickness */
    dDiagnosisImpact,        /**< contact so fast that it is found too late: travel over half thickness */
    dDiagnosisEnergy         /**< energy from nowhere: J gained over J there was */
} dDiagnosisKind;

/** How sure it is that this is harmful. */
typedef enum {
    dSeverityNote,    /**< worth knowing if something looks wrong */
    dSeverityWarning, /**< likely to be seen */
    dSeverityError    /**< the simulation is wrong */
} dSeverity;

/** One cause. Elements of arrays, such as this, have no struct_size. Objects may have been destroyed since;
    those that the cause does not concern are 0. */
typedef struct dDiagnosis {
    int kind;         /**< which cause: one of dDiagnosisKind */
    int severity;     /**< how harmful: one of dSeverity */
    dBodyID body;     /**< the body to blame */
    dBodyID other;    /**< the other one */
    dJointID joint;   /**< the joint to blame */
    dGeomID geom;     /**< the geom that was met */
    double figure;    /**< worst value, see dDiagnosisKind */
    double threshold; /**< what it should stay below */
    int first_step;   /**< step in which it was seen first, 1: the first one since the mode is on */
    int steps;        /**< in how many steps it was seen */
    int call;         /**< the function that was refused, a number for dDiagnosisText; 0: none was */
} dDiagnosis;

/** - dWorldSetDiagnosisMode: Switch the diagnosis of steps on (mode 1) or off (0, the default), which forgets
      what has been found. While it is on a step takes longer; its results are the same bits. Other values are
      refused, as is a call during a step and one that finds no memory.
    - dWorldGetDiagnosisMode: 1 if steps are diagnosed, else 0. [ours] */
ODE_API void dWorldSetDiagnosisMode(dWorldID world, int mode);
ODE_API int dWorldGetDiagnosisMode(dWorldID world);

/** Copies the causes found since the mode was switched on, at most capacity of them, to causes: the most severe
    first, of equal ones what was seen first. Returns how many there are, at most 64. Refused: a capacity below
    0; a call during a step. [ours] */
ODE_API int dWorldDiagnose(dWorldID world, dDiagnosis* causes, int capacity);

/** Writes to text, which has size bytes, what the cause means and how to cure it: one line that ends with a
    zero byte, cut off where it does not fit. Returns the length of the whole line. Refused: a kind, severity or
    call that is none. [ours] */
ODE_API int dDiagnosisText(const dDiagnosis* cause, char* text, int size);

#ifdef __cplusplus
}
#endif

#endif
