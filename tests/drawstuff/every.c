/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * A program that uses every function of drawstuff, written as such programs are: in C, and (every.cpp) in C++. It
 * draws the board of board.h; pictures_test.cpp knows what must be where.
 *   stop N   ends by dsStop in frame N
 * Key q ends it too; every printable key is printed on stdout. */
#include <drawstuff/drawstuff.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "board.h"

/* In C++ names without D take doubles too, and every.cpp wants to see it. */
#ifndef __cplusplus
#define WITH_D(name) name##D
#else
#define WITH_D(name) name
#endif

static int frames = 0, stop_after = -1, simulated = 0;
static double seconds = 0;

/* Two triangles that make a square of one metre; a pyramid; a rotation that lays local z along y. */
static const float square[18] = {-0.5f, -0.5f, 0, 0.5f, -0.5f, 0, 0.5f,  0.5f, 0,
                                 -0.5f, -0.5f, 0, 0.5f, 0.5f,  0, -0.5f, 0.5f, 0};
static const float points[15] = {-0.5f, -0.5f, 0, 0.5f, -0.5f, 0, 0.5f, 0.5f, 0, -0.5f, 0.5f, 0, 0, 0, 0.8f};
static const float planes[20] = {0,     0, -1,    0,     0, -0.85f, 0.53f, 0.42f, 0.85f, 0,
                                 0.53f, 0.42f, 0, 0.85f, 0.53f, 0.42f, -0.85f, 0, 0.53f, 0.42f};
static const unsigned int polygons[21] = {4, 0, 3, 2, 1, 3, 0, 1, 4, 3, 1, 2, 4, 3, 2, 3, 4, 3, 3, 0, 4};
static const float upright[12] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
static const float lying[12] = {1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0};
static const float cube[3] = {1, 1, 1};

static float cell_place[3];
static const float* cell(int column, int row)
{
    cell_place[0] = BOARD_X(row);
    cell_place[1] = BOARD_Y(column);
    cell_place[2] = 1;
    return cell_place;
}

static double wide_place[3];
static const double* wide_cell(int column, int row)
{
    int i;
    cell(column, row);
    for (i = 0; i < 3; ++i) wide_place[i] = cell_place[i];
    return wide_place;
}

static void widen(const float* from, double* to, int count)
{
    int i;
    for (i = 0; i < count; ++i) to[i] = from[i];
}

static void start(void)
{
    float xyz[3] = BOARD_EYE, hpr[3] = BOARD_LOOK, xyz_back[3], hpr_back[3];
    dsGetViewpoint(xyz_back, hpr_back);
    if (xyz_back[0] != 2 || xyz_back[1] != 0 || xyz_back[2] != 1 || fabsf(hpr_back[0]) != 180 || hpr_back[1] != 0)
        dsError("the first viewpoint is %g %g %g", xyz_back[0], xyz_back[1], xyz_back[2]);
    dsSetViewpoint(xyz, 0);
    dsSetViewpoint(0, hpr);
    dsGetViewpoint(xyz_back, 0);
    dsGetViewpoint(0, hpr_back);
    if (memcmp(xyz, xyz_back, sizeof xyz) != 0 || memcmp(hpr, hpr_back, sizeof hpr) != 0)
        dsError("the viewpoint does not come back");
}

static void draw_floats(void)
{
    float from[3] = {BOARD_X(0) - 0.7f, BOARD_Y(7), 1}, to[3] = {BOARD_X(0) + 0.7f, BOARD_Y(7), 1};
    dsSetColor(1, 0, 0);
    dsDrawBox(cell(0, 0), upright, cube);
    dsSetColor(0, 1, 0);
    dsDrawSphere(cell(1, 0), upright, 0.5f);
    dsSetColor(0, 0, 1);
    dsDrawCylinder(cell(2, 0), upright, 1, 0.5f);
    dsSetColor(1, 0, 1);
    dsDrawCapsule(cell(3, 0), lying, 0.8f, 0.3f);
    dsSetColor(1, 1, 0);
    dsDrawTriangle(cell(4, 0), upright, square, square + 3, square + 6, 1);
    dsSetColor(0, 1, 1);
    dsDrawTriangles(cell(5, 0), upright, square, 2, 1);
    dsSetColor(1, 0.5f, 0);
    dsDrawConvex(cell(6, 0), upright, planes, 5, points, 5, polygons);
    dsSetColor(1, 0, 0);
    dsDrawLine(from, to);
}

static void draw_doubles(void)
{
    double wide_upright[12], wide_lying[12], wide_cube[3], wide_square[18], wide_planes[20], wide_points[15];
    double from[3] = {BOARD_X(1) - 0.7, BOARD_Y(7), 1}, to[3] = {BOARD_X(1) + 0.7, BOARD_Y(7), 1};
    widen(upright, wide_upright, 12);
    widen(lying, wide_lying, 12);
    widen(cube, wide_cube, 3);
    widen(square, wide_square, 18);
    widen(planes, wide_planes, 20);
    widen(points, wide_points, 15);
    dsSetColor(1, 0, 0);
    WITH_D(dsDrawBox)(wide_cell(0, 1), wide_upright, wide_cube);
    dsSetColor(0, 1, 0);
    WITH_D(dsDrawSphere)(wide_cell(1, 1), wide_upright, 0.5f);
    dsSetColor(0, 0, 1);
    WITH_D(dsDrawCylinder)(wide_cell(2, 1), wide_upright, 1, 0.5f);
    dsSetColor(1, 0, 1);
    WITH_D(dsDrawCapsule)(wide_cell(3, 1), wide_lying, 0.8f, 0.3f);
    dsSetColor(1, 1, 0);
    WITH_D(dsDrawTriangle)(wide_cell(4, 1), wide_upright, wide_square, wide_square + 3, wide_square + 6, 1);
    dsSetColor(0, 1, 1);
    WITH_D(dsDrawTriangles)(wide_cell(5, 1), wide_upright, wide_square, 2, 1);
    dsSetColor(1, 0.5f, 0);
    WITH_D(dsDrawConvex)(wide_cell(6, 1), wide_upright, wide_planes, 5, wide_points, 5, polygons);
    dsSetColor(1, 0, 0);
    WITH_D(dsDrawLine)(from, to);
}

/* Textures, opacity, wires, an outline, by old names too. */
static void draw_styles(void)
{
    const float plate[3] = {1.6f, 1.6f, 0.5f};
    float low[3] = {BOARD_X(2), BOARD_Y(4), 0.3f};
    double wide_lying[12];
    int texture;
    dsSetColor(1, 1, 1);
    for (texture = DS_WOOD; texture <= DS_SKY; ++texture) {
        dsSetTexture(texture);
        dsDrawBox(cell(texture - 1, 2), upright, plate);
    }
    dsSetTexture(DS_NONE);
    dsSetColor(1, 0, 0);
    dsDrawBox(low, upright, plate);
    dsSetColorAlpha(0, 0, 1, 0.5f);
    dsDrawSphere(cell(4, 2), upright, 0.4f);
    dsSetDrawMode(DS_WIREFRAME);
    dsSetColor(1, 0, 0);
    dsSetSphereQuality(1);
    dsDrawSphere(cell(5, 2), upright, 0.7f);
    dsSetCapsuleQuality(3);
    dsSetCappedCylinderQuality(1);
    dsDrawCappedCylinder(cell(6, 2), lying, 0.6f, 0.4f);
    dsSetDrawMode(DS_POLYFILL);
    dsSetColor(0, 0, 1);
    widen(lying, wide_lying, 12);
    dsDrawCappedCylinderD(wide_cell(6, 2), wide_lying, 0.6f, 0.1f);
    dsSetColor(1, 1, 0);
    dsDrawTriangles(cell(7, 2), upright, square, 2, 0);
}

/* What cannot be drawn: over the green sphere's cell, where black would be seen. */
static void draw_nonsense(void)
{
    const float nowhere[3] = {NAN, 0, 1}, inside_out[3] = {1, -1, 1}, endless[3] = {INFINITY, 0, 0};
    const unsigned int no_such_corner[4] = {3, 0, 1, 77};
    dsSetColor(0, 0, 0);
    dsSetColor(NAN, 1, 1);
    dsSetTexture(12345);
    dsDrawBox(nowhere, upright, cube);
    dsDrawBox(cell(1, 0), upright, inside_out);
    dsDrawBox(cell(1, 0), 0, cube);
    dsDrawBox(cell(1, 0), upright, 0);
    dsDrawSphere(0, upright, 3);
    dsDrawSphere(cell(1, 0), upright, NAN);
    dsDrawCylinder(cell(1, 0), upright, INFINITY, 1);
    dsDrawCapsule(cell(1, 0), upright, 1, -1);
    dsDrawLine(endless, cell(1, 0));
    dsDrawLine(cell(1, 0), 0);
    dsDrawTriangle(nowhere, upright, square, square + 3, square + 6, 1);
    dsDrawTriangle(cell(1, 0), upright, square, square, square, 1);
    dsDrawTriangles(cell(1, 0), upright, square, -1, 1);
    dsDrawConvex(cell(1, 0), upright, planes, 1, points, 5, no_such_corner);
    dsSetSphereQuality(-1);
    dsSetCapsuleQuality(0);
    dsSetViewpoint(nowhere, nowhere);
}

static void step(int pause)
{
    ++frames;
    if (!pause) {
        ++simulated;
        seconds += dsElapsedTime();
    }
    draw_floats();
    draw_doubles();
    draw_styles();
    draw_nonsense();
    if (frames == stop_after) dsStop();
}

static void command(int key)
{
    if (key == 'q') dsStop();
    dsPrint("command %c\n", key);
}

static void stop(void) { dsPrint("frames %d simulated %d seconds %.3f\n", frames, simulated, seconds); }

int main(int argc, char** argv)
{
    dsFunctions functions;
    int i;
    functions.version = DS_VERSION;
    functions.start = &start;
    functions.step = &step;
    functions.command = &command;
    functions.stop = &stop;
    functions.path_to_textures = 0;
    for (i = 1; i + 1 < argc; ++i) {
        if (strcmp(argv[i], "stop") == 0) stop_after = atoi(argv[i + 1]);
    }
    setvbuf(stdout, 0, _IOLBF, 0);
    dsSimulationLoop(argc, argv, BOARD_WIDTH, BOARD_HEIGHT, &functions);
    return 0;
}
