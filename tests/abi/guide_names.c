// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Every function, constant and type that the user guide of release 0.039 names must be known to a program
// that includes only <ode/ode.h>, and every function must be found in the library under its plain C
// name, also by a program that looks it up at run time (as language bindings do).
#define _GNU_SOURCE
#include <dlfcn.h>
#include <stdio.h>

#include <ode/ode.h>

typedef void (*AnyFunction)(void);

typedef struct {
    const char* name;
    AnyFunction address;
} Entry;

#define F(name) {#name, (AnyFunction)name},

static const Entry kGuideFunctions[] = {
#include "guide_names.inc"
};

/* The guide's constants; all that belong to one set must differ from each other. */
static const int kContactBits[] = {
    dContactApprox1_1, dContactApprox1_2, dContactBounce, dContactFDir1,   dContactMotion1, dContactMotion2,
    dContactMu2,       dContactSlip1,     dContactSlip2,  dContactSoftCFM, dContactSoftERP,
};

static const int kParameters[] = {
    dParamLoStop,        dParamHiStop,  dParamVel,      dParamFMax,     dParamFudgeFactor,
    dParamBounce,        dParamCFM,     dParamStopERP,  dParamStopCFM,  dParamSuspensionERP,
    dParamSuspensionCFM, dParamLoStop2, dParamHiStop2,  dParamVel2,     dParamFMax2,
    dParamFudgeFactor2,  dParamBounce2, dParamCFM2,     dParamStopERP2, dParamStopCFM2,
    dParamLoStop3,       dParamHiStop3, dParamVel3,     dParamFMax3,    dParamFudgeFactor3,
    dParamBounce3,       dParamCFM3,    dParamStopERP3, dParamStopCFM3,
};

static const int kJointTypes[] = {
    dJointTypeAMotor, dJointTypeBall,   dJointTypeContact, dJointTypeFixed,
    dJointTypeHinge,  dJointTypeHinge2, dJointTypeSlider,  dJointTypeUniversal,
};

#define COUNT(array) ((int)(sizeof(array) / sizeof((array)[0])))

static int count_missing(void)
{
    int missing = 0;
    for (int i = 0; i < COUNT(kGuideFunctions); ++i) {
        const Entry* entry = &kGuideFunctions[i];
        void* found = dlsym(RTLD_DEFAULT, entry->name);
        if (found == NULL || (AnyFunction)(dintptr)found != entry->address) {
            fprintf(stderr, "%s: not found in the library by name\n", entry->name);
            ++missing;
        }
    }
    return missing;
}

static int count_repeated(const int* values, int count, const char* what)
{
    int repeated = 0;
    for (int i = 0; i < count; ++i)
        for (int j = 0; j < i; ++j) repeated += values[i] == values[j];
    if (repeated) fprintf(stderr, "%s: %d values occur twice\n", what, repeated);
    return repeated;
}

/* The guide's types and the macros that keep its spelling, in the way its text uses them. */
static int use_types_and_macros(void)
{
    dWorldID world = dWorldCreate();
    dBodyID body = dBodyCreate(world);
    dJointGroupID group = dJointGroupCreate(1000000);
    dJointID joint = dJointCreateBall(world, group);
    dJointFeedback feedback;
    dContact contact;
    dSurfaceParameters* surface = &contact.surface;
    dContactGeom* geom = &contact.geom;
    dMass mass;
    dVector3 v = {0, 0, 0, 0};
    dVector4 v4 = {0, 0, 0, 0};
    dMatrix3 R, back;
    dMatrix4 big;
    dQuaternion q;
    dReal worst = 0;

    surface->mode = dContactApprox1 | dContactBounce;
    surface->mu = dInfinity;
    geom->depth = 0;
    big[15] = v4[3] + v[3];
    dMassSetZero(&mass);
    dMassSetCappedCylinder(&mass, 1, 3, REAL(0.5), 1);
    dBodySetMass(body, &mass);
    dJointAttach(joint, body, 0);
    dJointSetFeedback(joint, &feedback);

    dQFromAxisAndAngle(q, 1, 2, 3, REAL(0.7));
    dQtoR(q, R);
    dRtoQ(R, q);
    dQtoR(q, back);
    for (int i = 0; i < 12; ++i) worst = dMax(worst, dFabs(R[i] - back[i]));

    dJointGroupDestroy(group);
    dWorldDestroy(world);
    if (!(worst < 16 * (sizeof(dReal) == 8 ? DBL_EPSILON : FLT_EPSILON))) {
        fprintf(stderr, "dQtoR and dRtoQ disagree by %g\n", (double)worst);
        return 1;
    }
    if (dParamGroup != dParamLoStop2 - dParamLoStop || dParamGroup != dParamLoStop3 - dParamLoStop2) {
        fprintf(stderr, "dParamGroup is not the distance of the axes' parameters\n");
        return 1;
    }
    return big[15] != 0 || dAMotorUser == dAMotorEuler || dContactApprox1_1 == dContactApprox1_2;
}

int main(void)
{
    int wrong = count_missing();
    wrong += count_repeated(kContactBits, COUNT(kContactBits), "contact mode bits");
    wrong += count_repeated(kParameters, COUNT(kParameters), "joint parameters");
    wrong += count_repeated(kJointTypes, COUNT(kJointTypes), "joint types");
    wrong += use_types_and_macros();
    printf("%d functions of the guide, %d wrong\n", COUNT(kGuideFunctions), wrong);
    return wrong != 0;
}
