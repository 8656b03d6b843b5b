/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * A ball falls freely for n steps of h: with the semi-implicit rule it falls g h^2 n (n + 1) / 2. A program and
 * a library of different precisions would read each other's numbers wrongly.
 */
#include <ode/ode.h>

int main(void)
{
    const double wanted = -9.81 * 0.01 * 0.01 * 100 * 101 / 2;
    const char* precision = sizeof(dReal) == 8 ? "ODE_double_precision" : "ODE_single_precision";
    dWorldID world;
    dBodyID ball;
    double height;
    int i;

    dInitODE2(0);
    world = dWorldCreate();
    dWorldSetGravity(world, 0, 0, REAL(-9.81));
    ball = dBodyCreate(world);
    for (i = 0; i < 100; i++) dWorldStep(world, REAL(0.01));
    height = dBodyGetPosition(ball)[2];
    dWorldDestroy(world);
    dCloseODE();

    printf("fall: %.9g, wanted %.9g, %s\n", height, wanted, precision);
    if (!dCheckConfiguration(precision)) return 1;
    return fabs(height - wanted) < (sizeof(dReal) == 8 ? 1e-12 : 1e-4) ? 0 : 1;
}
