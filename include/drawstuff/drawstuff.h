/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * drawstuff: a window, a camera and a dozen shapes, for programs that show what ODE computes.
 * Source-compatible with the library of that name, so programs written for it compile unchanged from C and
 * C++; drawn by OpenGL 3.3 with shadows and antialiasing.
 *
 * World: metres, right-handed, z up, a floor of 200 m by 200 m at z = 0. Nine small pyramids mark the points
 * whose x and y are -1, 0 or 1; the one at x = 1 is red, the one at y = 1 blue. The sun stands towards (1,
 * 0.4, 1).
 *
 * Arguments that mean the same everywhere:
 *   pos    3 numbers, where the shape's origin is, in metres
 *   R      12 numbers, its rotation: three rows of four, the fourth of each unused (ODE's dMatrix3)
 * What cannot be drawn (a null pointer, a number that is not finite, a size that is not positive) is left out
 * of the frame and all else is drawn. Functions named ...D take doubles where the others take floats; single
 * numbers are floats in both. In C++ the names without D take doubles too. In C, programs whose dReal is
 * double write
 * `#define dsDrawBox dsDrawBoxD` and so on, as ever, or define DS_DREAL_NAMES before this header and after
 * ode/ode.h, and the names without D take dReals.
 *
 * Without a screen (no DISPLAY and no WAYLAND_DISPLAY, or EPODE_GL=egl) frames become files, as fast as they
 * can be drawn, and time is counted in frames of 1/60 s, so that every run gives the same pictures:
 *   EPODE_FRAMES=DIR       where to: DIR/frame0001.png and so on; default "frame"; made if need be; empty: no
 * pictures, the program runs as ever EPODE_FRAME_COUNT=N    after N frames the loop ends as by Ctrl-X;
 * default 300; 0: never EPODE_FRAME_EVERY=K    only every K-th frame becomes a file; default 1
 *   EPODE_LOOK=fine        soft shadows of the whole sky, for pictures; about a second each without a GPU
 *   EPODE_GL=egl|window    files or a window, whatever the surroundings say */
#ifndef EPODE_DRAWSTUFF_H
#define EPODE_DRAWSTUFF_H

#include <drawstuff/version.h>

#ifdef __cplusplus
extern "C" {
#endif

/* For dsSetTexture. */
typedef enum {
    DS_NONE = 0, /* the plain colour */
    DS_WOOD = 1,
    DS_CHECKERED = 2,
    DS_GROUND = 3,
    DS_SKY = 4
} DS_TEXTURE_NUMBER;

/* For dsSetDrawMode. */
#define DS_POLYFILL 0
#define DS_WIREFRAME 1

/* What the program does when. Functions may be null. */
typedef struct dsFunctions {
    int version;                  /* DS_VERSION */
    void (*start)(void);          /* once, when the window is there: the place for dsSetViewpoint */
    void (*step)(int pause);      /* every frame: draw; simulate only if pause is 0 */
    void (*command)(int cmd);     /* a printable key, 32 to 126, pressed without Ctrl */
    void (*stop)(void);           /* once, when the loop has ended */
    const char* path_to_textures; /* folder with sky.ppm, ground.ppm, wood.ppm and checkered.ppm (binary, P6),
                                     read if version is at least 2; where one is missing, all are of
                                     drawstuff's own making and a message says so. Null: of its own making */
} dsFunctions;

/** Opens a window, calls fn->start, then fn->step in every frame (at most 60 a second) until the window is
 * closed, Ctrl-X is pressed or dsStop called, then fn->stop. May be called again when it has returned. argc,
 * argv  those of main; known are -notex, -noshadow or -noshadows, -pause and -texturepath DIR, all else is
 * for the program window_width, window_height  in pixels fn          the program's functions Keys: Ctrl and P
 * pause or go on, O one step while paused, T textures, S shadows, V print the viewpoint, W begin or end
 * writing frames (frame/frame0001.ppm and so on, of those that simulate), X end. Mouse: left button turns the
 * view, right button moves it forwards and sideways, middle button or both move it up and sideways.
 * Ends the program by dsError if it is called inside itself or nothing can be drawn, by dsDebug if
 * fn->version is newer than DS_VERSION, fn is null or a size is not positive. */
void dsSimulationLoop(int argc, char** argv, int window_width, int window_height, struct dsFunctions* fn);

/** Puts the camera somewhere. Either array may be null: that part stays as it is. In start it is (2, 0, 1),
 * (180, 0, 0). Ends the program by dsError before the loop; refuses numbers that are not finite.
 *   xyz  3 numbers, the eye's place in metres
 *   hpr  3 numbers in degrees, wrapped to -180..180: heading 0 looks along +x and grows counter-clockwise
 * seen from above, pitch is positive upwards, roll is positive to the right */
void dsSetViewpoint(const float xyz[3], const float hpr[3]);

/** The camera as dsSetViewpoint or the mouse left it, into those of xyz and hpr that are not null. Ends the
 * program by dsError before the loop. */
void dsGetViewpoint(float xyz[3], float hpr[3]);

/** The loop ends when this frame is done. Nothing outside the loop. */
void dsStop(void);

/** Seconds since it was last called, at least 1e-16 and at most 1: the program's own step, if it is to keep
 * pace with the clock. Without a screen, 1/60 s per frame. */
double dsElapsedTime(void);

/** Ends the program with exit code 1 and prints the message, as printf would, after "Error: " on stderr.
 *   msg  format of the message, with its values behind it */
void dsError(const char* msg, ...);

/** As dsError, after "INTERNAL ERROR: ", and ends by abort: for what should not be possible.
 *   msg  format of the message, with its values behind it */
void dsDebug(const char* msg, ...);

/** printf: adds no newline.
 *   msg  format of the message, with its values behind it */
void dsPrint(const char* msg, ...);

/** The texture of shapes drawn from here to the end of the frame; frames begin with DS_NONE. A number that is
 * not one of the five means none. texture_number  one of DS_TEXTURE_NUMBER */
void dsSetTexture(int texture_number);

/** The colour of what is drawn from here to the end of the frame, sRGB, 0 to 1 each, with textures multiplied
 * by them; frames begin white. dsSetColor is opaque; dsSetColorAlpha mixes it with what lies behind: alpha 0
 * is not seen, 1 is opaque, below 0.5 there is no shadow. Lines are opaque always. Numbers that are not
 * finite are refused, others are brought into 0..1. red, green, blue, alpha  the colour and its opacity */
void dsSetColor(float red, float green, float blue);
void dsSetColorAlpha(float red, float green, float blue, float alpha);

/** Surfaces (DS_POLYFILL) or the edges of their triangles (DS_WIREFRAME) from here on, in later frames too.
 *   mode  one of the two */
void dsSetDrawMode(int mode);

/** How finely spheres (n = 1 unless set) and capsules (3) are cut into triangles, from here on, in later
 * frames too. Surfaces look round from 1 on; in wireframe one sees the difference. More than 15 is 15. n
 * positive */
void dsSetSphereQuality(int n);
void dsSetCapsuleQuality(int n);

/** A box.
 *   sides  3 numbers: its lengths along its own x, y and z */
void dsDrawBox(const float pos[3], const float R[12], const float sides[3]);
void dsDrawBoxD(const double pos[3], const double R[12], const double sides[3]);

/** A sphere. */
void dsDrawSphere(const float pos[3], const float R[12], float radius);
void dsDrawSphereD(const double pos[3], const double R[12], float radius);

/** A cylinder with flat ends along its own z. Mind the order: length before radius.
 *   length  between the ends */
void dsDrawCylinder(const float pos[3], const float R[12], float length, float radius);
void dsDrawCylinderD(const double pos[3], const double R[12], float length, float radius);

/** A cylinder with half spheres for ends, along its own z. Mind the order: length before radius.
 *   length  without the ends, as in ODE; may be 0 */
void dsDrawCapsule(const float pos[3], const float R[12], float length, float radius);
void dsDrawCapsuleD(const double pos[3], const double R[12], float length, float radius);

/** A triangle, seen from both sides.
 *   v0, v1, v2  3 numbers each: its corners in its own frame
 *   solid       0: its edges as lines, else its surface */
void dsDrawTriangle(const float pos[3], const float R[12], const float* v0, const float* v1, const float* v2,
                    int solid);
void dsDrawTriangleD(const double pos[3], const double R[12], const double* v0, const double* v1,
                     const double* v2, int solid);

/** Triangles as dsDrawTriangle draws them.
 *   v      9 n numbers: three corners after three corners
 *   n      how many triangles
 *   solid  0: their edges, else their surfaces */
void dsDrawTriangles(const float pos[3], const float R[12], const float* v, int n, int solid);
void dsDrawTrianglesD(const double pos[3], const double R[12], const double* v, int n, int solid);

/** A line in the world, hidden by what stands before it.
 *   pos1, pos2  3 numbers each: its ends */
void dsDrawLine(const float pos1[3], const float pos2[3]);
void dsDrawLineD(const double pos1[3], const double pos2[3]);

/** A convex solid, given as for dGeomSetConvex. A polygon with a corner that does not exist is left out.
 *   _planes      4 numbers each: the faces' normals and distances (not read: the polygons say it all)
 *   _planecount  how many faces
 *   _points      3 numbers each: the corners in the solid's frame
 *   _pointcount  how many corners
 *   _polygons    for each face the number of its corners, then their indices, counter-clockwise from outside
 */
void dsDrawConvex(const float pos[3], const float R[12], const float* _planes, unsigned int _planecount,
                  const float* _points, unsigned int _pointcount, const unsigned int* _polygons);
void dsDrawConvexD(const double pos[3], const double R[12], const double* _planes, unsigned int _planecount,
                   const double* _points, unsigned int _pointcount, const unsigned int* _polygons);

/* Names that capsules had before. */
#define dsDrawCappedCylinder dsDrawCapsule
#define dsDrawCappedCylinderD dsDrawCapsuleD
#define dsSetCappedCylinderQuality dsSetCapsuleQuality

#ifdef __cplusplus
}

/* The names without D for doubles. */
inline void dsDrawBox(const double* pos, const double* R, const double* sides) { dsDrawBoxD(pos, R, sides); }
inline void dsDrawSphere(const double* pos, const double* R, float radius) { dsDrawSphereD(pos, R, radius); }
inline void dsDrawCylinder(const double* pos, const double* R, float length, float radius)
{
    dsDrawCylinderD(pos, R, length, radius);
}
inline void dsDrawCapsule(const double* pos, const double* R, float length, float radius)
{
    dsDrawCapsuleD(pos, R, length, radius);
}
inline void dsDrawTriangle(const double* pos, const double* R, const double* v0, const double* v1,
                           const double* v2, int solid)
{
    dsDrawTriangleD(pos, R, v0, v1, v2, solid);
}
inline void dsDrawTriangles(const double* pos, const double* R, const double* v, int n, int solid)
{
    dsDrawTrianglesD(pos, R, v, n, solid);
}
inline void dsDrawLine(const double* pos1, const double* pos2) { dsDrawLineD(pos1, pos2); }
inline void dsDrawConvex(const double* pos, const double* R, const double* _planes, unsigned int _planecount,
                         const double* _points, unsigned int _pointcount, const unsigned int* _polygons)
{
    dsDrawConvexD(pos, R, _planes, _planecount, _points, _pointcount, _polygons);
}
#elif defined(DS_DREAL_NAMES) && defined(dDOUBLE)
#define dsDrawBox dsDrawBoxD
#define dsDrawSphere dsDrawSphereD
#define dsDrawCylinder dsDrawCylinderD
#define dsDrawTriangle dsDrawTriangleD
#define dsDrawTriangles dsDrawTrianglesD
#define dsDrawLine dsDrawLineD
#define dsDrawConvex dsDrawConvexD
#undef dsDrawCappedCylinder
#define dsDrawCappedCylinder dsDrawCapsuleD
#define dsDrawCapsule dsDrawCapsuleD
#endif

#endif
