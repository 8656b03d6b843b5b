/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * The other end of native_test.mjs: native WORLD STATE loads the file WORLD that JavaScript has written, makes 100 steps, writes the
 * state to the file STATE, and saves the world over WORLD. */
#include <ode/ext.h>
#include <ode/ode.h>
#include <stdio.h>
#include <stdlib.h>

int main(int count, char** arguments)
{
    dSpaceID space;
    dWorldID world;
    size_t size;
    void* state;
    FILE* file;
    int i;
    if (count != 3 || !dInitODE2(0)) return 2;
    world = dWorldLoad(arguments[1], &space);
    if (!world) return 1;
    for (i = 0; i < 100; ++i)
        if (!dWorldStepHybrid(world, 1.0 / 60)) return 1;
    size = dWorldGetStateSize(world);
    state = malloc(size);
    if (!state || !dWorldGetState(world, state, size)) return 1;
    file = fopen(arguments[2], "wb");
    if (!file || fwrite(state, 1, size, file) != size || fclose(file)) return 1;
    free(state);
    if (!dWorldSave(world, space, arguments[1])) return 1;
    dWorldDestroy(world);
    dCloseODE();
    return 0;
}
