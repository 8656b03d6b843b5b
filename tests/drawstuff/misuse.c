/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * Misuses drawstuff in the way its argument names; misuse.sh knows how each must end. */
#include <drawstuff/drawstuff.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const float origin[3] = {0, 0, 0};
static const float upright[12] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
static dsFunctions functions;

static void draw_in_start(void) { dsDrawSphere(origin, upright, 1); }

static void nested(int pause)
{
    char* no_arguments[1] = {0};
    (void)pause;
    dsSimulationLoop(0, no_arguments, 10, 10, &functions);
}

static void nothing(int pause) { (void)pause; }

int main(int argc, char** argv)
{
    const char* what = argc > 1 ? argv[1] : "";
    float place[3] = {0, 0, 0};
    functions.version = DS_VERSION;
    functions.step = &nothing;
    printf("before\n");
    if (strcmp(what, "error") == 0) dsError("%d apples", 3);
    if (strcmp(what, "debug") == 0) dsDebug("%s pears", "no");
    if (strcmp(what, "draw-before") == 0) dsDrawLine(origin, origin);
    if (strcmp(what, "view-before") == 0) dsSetViewpoint(place, place);
    if (strcmp(what, "get-before") == 0) dsGetViewpoint(place, place);
    if (strcmp(what, "draw-in-start") == 0) functions.start = &draw_in_start;
    if (strcmp(what, "nested") == 0) functions.step = &nested;
    if (strcmp(what, "version") == 0) functions.version = DS_VERSION + 1;
    if (strcmp(what, "size") == 0) dsSimulationLoop(argc, argv, 0, 10, &functions);
    if (strcmp(what, "null") == 0) dsSimulationLoop(argc, argv, 10, 10, 0);
    if (strcmp(what, "textures") == 0) functions.path_to_textures = "no/such/folder";
    dsStop();
    dsSetColor(1, 0, 0);
    dsSetDrawMode(DS_POLYFILL);
    dsSimulationLoop(argc, argv, 10, 10, &functions);
    dsSimulationLoop(argc, argv, 10, 10, &functions);
    printf("after\n");
    return 0;
}
