/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * For C++, included by drawstuff.h: the names without D for doubles, each of which calls the one with D. */
#ifndef EPODE_DRAWSTUFF_DOUBLES_H
#define EPODE_DRAWSTUFF_DOUBLES_H

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

#endif
