/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * drawstuff: a window, a camera and a dozen shapes, for programs that show what ODE computes.
 * Source-compatible with the library of that name, so programs written for it compile unchanged from C and
 * C++; drawn by OpenGL 3.3 with shadows and antialiasing. */
#ifndef EPODE_DRAWSTUFF_H
#define EPODE_DRAWSTUFF_H

#include <drawstuff/version.h>

/** Before every function of drawstuff's. */
#define DS_API

#ifdef __cplusplus
extern "C" {
#endif

/** @chapter ds_loop The window and its loop

    World: metres, right-handed, z up, a floor of 200 m by 200 m at z = 0. Nine small pyramids mark the points
    whose x and y are -1, 0 or 1; the one at x = 1 is red, the one at y = 1 blue. The sun stands towards (1,
    0.4, 1).

    Keys: Ctrl and P pause or go on, O one step while paused, T textures, S shadows, V print the viewpoint, W
    begin or end writing frames (frame/frame0001.ppm and so on, of those that simulate), X end. Mouse: the
   left button turns the view, the right one moves it forwards and sideways, the middle one or both move it up
   and sideways.

    Without a screen (no DISPLAY and no WAYLAND_DISPLAY, or EPODE_GL=egl) frames become files, as fast as they
    can be drawn, and time is counted in frames of 1/60 s, so that every run gives the same pictures.
   Variables of the environment: EPODE_FRAMES, the folder (default "frame", made if need be; empty: no
   pictures, the program runs as ever); EPODE_FRAME_COUNT, after how many frames the loop ends as by Ctrl-X
   (default 300; 0: never); EPODE_FRAME_EVERY, only every so manieth frame becomes a file (default 1);
   EPODE_LOOK=fine, soft shadows of the whole sky, about a second each without a GPU; EPODE_GL=egl or window,
   files or a window, whatever the surroundings say.

    Refused: what each function says; [dsSetViewpoint, dsGetViewpoint] a call outside the loop, which ends
    the program by dsError. */

/** What the program does when. Functions may be null. */
typedef struct dsFunctions {
    int version;                  /**< DS_VERSION */
    void (*start)(void);          /**< once, when the window is there: the place for dsSetViewpoint */
    void (*step)(int pause);      /**< every frame: draw; simulate only if pause is 0 */
    void (*command)(int cmd);     /**< a printable key, 32 to 126, pressed without Ctrl */
    void (*stop)(void);           /**< once, when the loop has ended */
    const char* path_to_textures; /**< folder with sky.ppm, ground.ppm, wood.ppm and checkered.ppm (binary,
                                     P6), read if version is at least 2; where one is missing, all are of
                                     drawstuff's own making and a message says so. Null: of its own making */
} dsFunctions;

/** Opens a window of window_width by window_height pixels, calls fn->start, then fn->step in every frame (at
    most 60 a second) until the window is closed, Ctrl-X is pressed or dsStop called, then fn->stop. May be
   called again when it has returned. argc and argv are those of main; known are -notex, -noshadow or
   -noshadows, -pause and -texturepath DIR, all else is for the program. Refused: a call inside itself, or
   nothing to draw with (by dsError); a version newer than DS_VERSION, a null fn, a size that is not positive
   (by dsDebug). [0.16] */
DS_API void dsSimulationLoop(int argc, char** argv, int window_width, int window_height,
                             struct dsFunctions* fn);

/** Puts the camera somewhere: xyz, the eye's place, 3 numbers in metres; hpr, 3 numbers in degrees, wrapped
   to -180..180: heading 0 looks along +x and grows counter-clockwise seen from above, pitch is positive
   upwards, roll is positive to the right. Either may be null: that part stays as it is. In start it is (2, 0,
   1), (180, 0, 0). Refused: numbers that are not finite. [0.16] */
DS_API void dsSetViewpoint(const float xyz[3], const float hpr[3]);

/** The camera as dsSetViewpoint or the mouse left it, into those of xyz and hpr that are not null. [0.16] */
DS_API void dsGetViewpoint(float xyz[3], float hpr[3]);

/** The loop ends when this frame is done. Nothing outside the loop. [0.16] */
DS_API void dsStop(void);

/** Seconds since it was last called, at least 1e-16 and at most 1: the program's own step, if it is to keep
    pace with the clock. Without a screen, 1/60 s per frame. [0.16] */
DS_API double dsElapsedTime(void);

/** @chapter ds_messages Messages

    Arguments:
    - msg: format of the message, as printf takes it, with its values behind it

    Refused: nothing. */

/** Ends the program with exit code 1 and prints the message after "Error: " on stderr. [0.16] */
DS_API void dsError(const char* msg, ...);

/** Ends the program by abort and prints the message after "INTERNAL ERROR: " on stderr: for what should not
   be possible. [0.16] */
DS_API void dsDebug(const char* msg, ...);

/** printf: adds no newline. [0.16] */
DS_API void dsPrint(const char* msg, ...);

/** @chapter ds_style How shapes look

    Refused: numbers that are not finite. */

/** For dsSetTexture. */
typedef enum {
    DS_NONE = 0,      /**< the plain colour */
    DS_WOOD = 1,      /**< planks */
    DS_CHECKERED = 2, /**< squares */
    DS_GROUND = 3,    /**< what the floor has */
    DS_SKY = 4        /**< what the sky has */
} DS_TEXTURE_NUMBER;

/** Surfaces, for dsSetDrawMode. */
#define DS_POLYFILL 0

/** The edges of triangles, for dsSetDrawMode. */
#define DS_WIREFRAME 1

/** The texture, texture_number, of shapes drawn from here to the end of the frame; frames begin with DS_NONE.
   A number that is none of DS_TEXTURE_NUMBER means none. [0.16] */
DS_API void dsSetTexture(int texture_number);

/** The colour holds for what is drawn from here to the end of the frame: red, green and blue, sRGB, 0 to 1
    each, with textures multiplied by them; frames begin white. Numbers beyond 0 ... 1 are brought into it.
    - dsSetColor: Draw in this colour, opaque.
    - dsSetColorAlpha: Draw in this colour, mixed with what lies behind: alpha 0 is not seen, 1 is opaque,
      below 0.5 there is no shadow. Lines are opaque always. [0.16] */
DS_API void dsSetColor(float red, float green, float blue);
DS_API void dsSetColorAlpha(float red, float green, float blue, float alpha);

/** Surfaces (mode DS_POLYFILL) or the edges of their triangles (DS_WIREFRAME) from here on, in later frames
    too. [0.16] */
DS_API void dsSetDrawMode(int mode);

/** It holds from here on, in later frames too. Surfaces look round from 1 on; wireframes show the
    difference. More than 15 is 15. Refused: n below 1.
    - dsSetSphereQuality: Set how finely (n) spheres are cut into triangles; default 1.
    - dsSetCapsuleQuality: Set how finely (n) capsules are cut into triangles; default 3. [0.16] */
DS_API void dsSetSphereQuality(int n);
DS_API void dsSetCapsuleQuality(int n);

/** @chapter ds_shapes Shapes

    Functions named ...D take doubles where the others take floats; single numbers are floats in both. In C++
   the names without D take doubles too (drawstuff/doubles.h). In C, programs whose dReal is double write
   `#define dsDrawBox dsDrawBoxD` and so on, as ever, or define DS_DREAL_NAMES before this header and after
   ode/ode.h, and the names without D take dReals.

    Arguments:
    - pos: 3 numbers, where the shape's origin is, m
    - R: 12 numbers, its rotation: three rows of four, the fourth of each unused (ODE's dMatrix3)
    - radius: its radius, m
    - solid: 0: the edges of triangles as lines, else their surfaces, seen from both sides

    Refused: what cannot be drawn, as what is not finite: it is left out of the frame and all else is drawn.
 */

/** sides: 3 numbers, its lengths along its own x, y and z.
    - dsDrawBox: Draw a box, from floats.
    - dsDrawBoxD: Draw a box, from doubles. [0.16] */
DS_API void dsDrawBox(const float pos[3], const float R[12], const float sides[3]);
DS_API void dsDrawBoxD(const double pos[3], const double R[12], const double sides[3]);

/** - dsDrawSphere: Draw a sphere, from floats.
    - dsDrawSphereD: Draw a sphere, from doubles. [0.16] */
DS_API void dsDrawSphere(const float pos[3], const float R[12], float radius);
DS_API void dsDrawSphereD(const double pos[3], const double R[12], float radius);

/** length is that between the ends, m. Mind the order: length before radius.
    - dsDrawCylinder: Draw a cylinder with flat ends along its own z, from floats.
    - dsDrawCylinderD: Draw a cylinder with flat ends along its own z, from doubles. [0.16] */
DS_API void dsDrawCylinder(const float pos[3], const float R[12], float length, float radius);
DS_API void dsDrawCylinderD(const double pos[3], const double R[12], float length, float radius);

/** length, without the half spheres as in ODE, may be 0. Mind the order: length before radius.
    - dsDrawCapsule: Draw a cylinder with half spheres for ends, along its own z, from floats.
    - dsDrawCapsuleD: Draw a cylinder with half spheres for ends, along its own z, from doubles. [0.16] */
DS_API void dsDrawCapsule(const float pos[3], const float R[12], float length, float radius);
DS_API void dsDrawCapsuleD(const double pos[3], const double R[12], float length, float radius);

/** v0, v1 and v2: its corners, 3 numbers each, in its own frame.
    - dsDrawTriangle: Draw a triangle, from floats.
    - dsDrawTriangleD: Draw a triangle, from doubles. [0.16] */
DS_API void dsDrawTriangle(const float pos[3], const float R[12], const float* v0, const float* v1,
                           const float* v2, int solid);
DS_API void dsDrawTriangleD(const double pos[3], const double R[12], const double* v0, const double* v1,
                            const double* v2, int solid);

/** v: 9 n numbers, three corners after three corners.
    - dsDrawTriangles: Draw n triangles, from floats.
    - dsDrawTrianglesD: Draw n triangles, from doubles. [0.16] */
DS_API void dsDrawTriangles(const float pos[3], const float R[12], const float* v, int n, int solid);
DS_API void dsDrawTrianglesD(const double pos[3], const double R[12], const double* v, int n, int solid);

/** Each end has 3 numbers. What stands before the line hides it.
    - dsDrawLine: Draw a line in the world from pos1 to pos2, from floats.
    - dsDrawLineD: Draw a line in the world from pos1 to pos2, from doubles. [0.16] */
DS_API void dsDrawLine(const float pos1[3], const float pos2[3]);
DS_API void dsDrawLineD(const double pos1[3], const double pos2[3]);

/** It is given as for dGeomSetConvex: _planecount faces and _planes, their normals and distances, 4 numbers
    each (not read: the polygons say it all); _pointcount corners and _points, 3 numbers each, in the solid's
    frame; _polygons, for each face the number of its corners, then their indices, counter-clockwise from
    outside. A polygon with a corner that does not exist is left out.
    - dsDrawConvex: Draw a convex solid, from floats.
    - dsDrawConvexD: Draw a convex solid, from doubles. [0.16] */
DS_API void dsDrawConvex(const float pos[3], const float R[12], const float* _planes,
                         unsigned int _planecount, const float* _points, unsigned int _pointcount,
                         const unsigned int* _polygons);
DS_API void dsDrawConvexD(const double pos[3], const double R[12], const double* _planes,
                          unsigned int _planecount, const double* _points, unsigned int _pointcount,
                          const unsigned int* _polygons);

/** A name that capsules had before. */
#define dsDrawCappedCylinder dsDrawCapsule
#define dsDrawCappedCylinderD dsDrawCapsuleD
#define dsSetCappedCylinderQuality dsSetCapsuleQuality

#ifdef __cplusplus
}

#include <drawstuff/doubles.h>
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
