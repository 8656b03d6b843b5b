/* SPDX-License-Identifier: BSD-3-Clause */
/* Copyright (c) 2026 The Epode authors */
/* Which parameters each type of joint takes, and what they are at first: a line "Type name default" for each,
   to be compared with docs/guide/joint_parameters.md (joint_parameters.py). ERP and CFM of the world are
   numbers that nothing else has. */
#include <ode/ode.h>
#include <stdio.h>

#define TYPE(T)                                                       \
    {                                                                 \
#T, dJointCreate##T, dJointSet##T##Param, dJointGet##T##Param \
    }

static const struct {
    const char* name;
    dJointID (*create)(dWorldID, dJointGroupID);
    void (*set)(dJointID, int, dReal);
    dReal (*get)(dJointID, int);
} kTypes[] = {TYPE(Ball),   TYPE(Hinge),  TYPE(Slider), TYPE(Hinge2),      TYPE(Universal),
              TYPE(Fixed),  TYPE(AMotor), TYPE(LMotor), TYPE(PR),          TYPE(PU),
              TYPE(Piston), TYPE(DBall),  TYPE(DHinge), TYPE(Transmission)};

static const char* const kNames[] = {"LoStop",  "HiStop",        "Vel",           "LoVel", "HiVel",
                                     "FMax",    "FudgeFactor",   "Bounce",        "CFM",   "StopERP",
                                     "StopCFM", "SuspensionERP", "SuspensionCFM", "ERP"};

int main(void)
{
    dInitODE2(0);
    dWorldID world = dWorldCreate();
    dWorldSetERP(world, 0.375);
    dWorldSetCFM(world, 0.0625);
    for (size_t i = 0; i < sizeof kTypes / sizeof kTypes[0]; ++i) {
        dJointID joint = kTypes[i].create(world, 0);
        dJointAttach(joint, dBodyCreate(world), dBodyCreate(world));
        if (kTypes[i].create == dJointCreateAMotor) dJointSetAMotorNumAxes(joint, 3);
        for (int group = 0; group < 3; ++group) {
            for (int k = 0; k < (int)(sizeof kNames / sizeof kNames[0]); ++k) {
                const int number = group * dParamGroup + k;
                const dReal first = kTypes[i].get(joint, number);
                kTypes[i].set(joint, number, 0.125);
                if (kTypes[i].get(joint, number) == 0.125)
                    printf("%s dParam%s%s %g\n", kTypes[i].name, kNames[k],
                           group == 0   ? ""
                           : group == 1 ? "2"
                                        : "3",
                           first);
                kTypes[i].set(joint, number, first);
            }
        }
    }
    dWorldDestroy(world);
    dCloseODE();
    return 0;
}
