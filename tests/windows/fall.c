/* SPDX-License-Identifier: BSD-3-Clause
   Copyright (c) 2026 The Epode authors

   The program of the README, for tests/windows/run.sh. */
#include <ode/ode.h>
#include <stdio.h>

int main(void)
{
    dInitODE2(0);
    dWorldID world = dWorldCreate();
    dWorldSetGravity(world, 0, 0, -9.81);
    dBodyID ball = dBodyCreate(world);
    for (int i = 0; i < 100; ++i) dWorldStep(world, 0.01);
    printf("%g\n", dBodyGetPosition(ball)[2]);
    dWorldDestroy(world);
    dCloseODE();
    return 0;
}
