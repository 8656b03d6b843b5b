/* SPDX-License-Identifier: BSD-3-Clause */
/* Copyright (c) 2026 The Epode authors
 *
 * What a random sequence does in more than one call. Plain C: the text of this file stands at the head of
 * every program that a failed sequence is written down as, so that the program needs nothing else. */
#include <ode/ext.h>
#include <ode/ode.h>
#include <string.h>

#ifdef __cplusplus
#define TOOL inline
#else
#define TOOL static
#endif

enum { kMaxMade = 16, kMaxFeedback = 64 };
TOOL dJointID made[kMaxMade]; /* by the last call of meet() */
TOOL int made_count;
TOOL dJointFeedback feedback[kMaxFeedback];
TOOL const double kHeights[16] = {0, 0.3, 0.1, 0, 0.2, 0.5, 0.4, 0.1, 0, 0.6, 0.2, 0.3, 0.1, 0, 0.2, 0};

/* Contacts of two geoms become joints between their bodies, where these belong to `w`. */
TOOL void meet(dWorldID w, dJointGroupID group, dGeomID a, dGeomID b, int capacity, int mode)
{
    dContact contact[kMaxMade];
    dBodyID b1 = dGeomGetBody(a), b2 = dGeomGetBody(b);
    int i, n = dCollide(a, b, capacity < kMaxMade ? capacity : (int)kMaxMade, &contact[0].geom,
                        sizeof contact[0]);
    made_count = 0;
    if ((b1 && dBodyGetWorld(b1) != w) || (b2 && dBodyGetWorld(b2) != w) || b1 == b2) return;
    for (i = 0; i < n; ++i) {
        memset(&contact[i].surface, 0, sizeof contact[i].surface);
        contact[i].surface.mode = mode;
        contact[i].surface.mu = (dReal)0.5;
        contact[i].surface.bounce = (dReal)0.3;
        contact[i].surface.soft_erp = (dReal)0.5;
        contact[i].surface.soft_cfm = (dReal)1e-4;
        made[made_count] = dJointCreateContact(w, group, &contact[i]);
        if (!made[made_count]) return;
        dJointAttach(made[made_count], b1, b2);
        ++made_count;
    }
}

TOOL void set_mass(dBodyID body, dReal density, dReal x, dReal y, dReal z)
{
    dMass m;
    dMassSetBox(&m, density, x, y, z);
    dBodySetMass(body, &m);
}

TOOL void build_heights(dHeightfieldDataID data, int copy, dReal width, int wrap)
{
    dGeomHeightfieldDataBuildDouble(data, kHeights, copy, width, width, 4, 4, 1, 0, 1, wrap);
}

/* A roof of three by three corners, a tetrahedron, and what no mesh should be: flat, doubled, torn. */
enum { kMeshes = 3, kCorners = 9 };
TOOL dReal corners[kMeshes][kCorners][3] = {
    {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 1, 1}, {2, 1, 0}, {0, 2, 0}, {1, 2, 0}, {2, 2, 0}},
    {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
    {{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 2, 2}}};
TOOL const dTriIndex triangles[kMeshes][8][3] = {
    {{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}, {3, 4, 7}, {3, 7, 6}, {4, 5, 8}, {4, 8, 7}},
    {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}},
    {{0, 1, 3}, {0, 1, 2}, {3, 1, 0}, {0, 0, 0}, {0, 2, 4}}};

TOOL void build_mesh(dTriMeshDataID data, int which)
{
    static const int vertex_count[kMeshes] = {9, 4, 5}, triangle_count[kMeshes] = {8, 4, 5};
    if (sizeof(dReal) == sizeof(double))
        dGeomTriMeshDataBuildDouble(data, corners[which], sizeof corners[0][0], vertex_count[which],
                                    triangles[which], 3 * triangle_count[which], sizeof triangles[0][0]);
    else
        dGeomTriMeshDataBuildSingle(data, corners[which], sizeof corners[0][0], vertex_count[which],
                                    triangles[which], 3 * triangle_count[which], sizeof triangles[0][0]);
}

/* Moves a corner of all meshes that were built of this shape; each shows it at its next update. */
TOOL void move_corner(int which, int corner, double x, double y, double z)
{
    corners[which][corner][0] = (dReal)x;
    corners[which][corner][1] = (dReal)y;
    corners[which][corner][2] = (dReal)z;
}

/* A wedge, as the faces of a convex geom or by its points alone. */
TOOL const dReal kWedge[6][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {0, 1, 1}};
TOOL const dReal kWedgePlanes[5][4] = {
    {0, 0, -1, 0},
    {-1, 0, 0, 0},
    {0, -1, 0, 0},
    {0, 1, 0, 1},
    {(dReal)0.70710678118654752, 0, (dReal)0.70710678118654752, (dReal)0.70710678118654752}};
TOOL const unsigned kWedgeFaces[] = {4, 0, 3, 2, 1, 4, 0, 4, 5, 3, 3, 0, 1, 4, 3, 2, 3, 5, 4, 1, 2, 5, 4};

TOOL dGeomID create_wedge(dSpaceID space)
{
    return dCreateConvex(space, kWedgePlanes[0], 5, kWedge[0], 6, kWedgeFaces);
}

TOOL dGeomID create_hull(dSpaceID space, int points)
{
    return dCreateConvexHull(space, kWedge[0], (unsigned)points, 0);
}

TOOL void set_hull(dGeomID convex, int points) { dGeomSetConvexHull(convex, kWedge[0], (unsigned)points, 0); }

TOOL void watch(dJointID joint, int index) { dJointSetFeedback(joint, index < 0 ? 0 : &feedback[index]); }
