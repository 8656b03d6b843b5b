/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * Convex decomposition of meshes into geoms that the program owns. Link with libepode_robots; docs/guide/shapes.md says when
 * hulls are better than triangles. */
#ifndef _EPODE_DECOMPOSITION_H_
#define _EPODE_DECOMPOSITION_H_

#include <ode/ode.h>

#ifdef __cplusplus
extern "C" {
#endif

/** @chapter decomposition Convex decomposition

    A solid of any form as a few convex hulls, which move, roll and stack like all convex shapes. Their union
    holds the solid, and none of its measured points is farther from it than a tolerance.

    Arguments:
    - struct_size: the size of the structure, for versions of it.

    Refused: null pointers; numbers that are not finite; structures of another size; what each function names.
    Nothing changes then, and the answer is 0. */

/** How well hulls are to fit. Start from dDecompositionOptionsInit. */
typedef struct dDecompositionOptions {
    unsigned struct_size; /**< sizeof(dDecompositionOptions), which dDecompositionOptionsInit sets */
    int max_vertices;     /**< of a hull, 4 or more, 0: as many as it has; 64 */
    dReal tolerance;      /**< how far from the solid a hull may reach, m; 0: 2.5 % of its longest side; 0 */
} dDecompositionOptions;

/** What a decomposition came to. Set struct_size before. */
typedef struct dDecompositionReport {
    unsigned struct_size; /**< sizeof(dDecompositionReport), set by the caller */
    int is_closed;        /**< 0: the mesh has edges without a second triangle, or wound the other way */
    dReal tolerance;      /**< that was searched for, m */
    dReal surplus;        /**< how far from the solid a measured point of a hull is at most, m */
    dReal uncovered; /**< how far outside the hulls a point of the solid is at most, m: for max_vertices */
    dReal cell;      /**< distance of the measured points, m */
} dDecompositionReport;

/** Fills *options with the defaults. Returns 1. Refused: a struct_size other than
    sizeof(dDecompositionOptions). [ours] */
ODE_API int dDecompositionOptionsInit(dDecompositionOptions* options, unsigned struct_size);

/** Creates convex geoms in the space, or (0) in none, that together fill a mesh of vertex_count vertices,
    3 reals each, m, and triangle_count triangles, 3 indices each, and writes them to geoms: at most capacity,
    1 ... 256. options: NULL for the defaults; report: NULL for none. A mesh with holes wider than a cell is its
    surface alone. The same arguments give the same bits. Returns how many there are. Refused: indices beyond
    the vertices; vertices in one plane; more than 6 million of either. [ours] */
ODE_API int dCreateConvexDecomposition(dSpaceID space, const dReal* vertices, int vertex_count,
                                       const unsigned* triangles, int triangle_count,
                                       const dDecompositionOptions* options, dGeomID* geoms, int capacity,
                                       dDecompositionReport* report);

#ifdef __cplusplus
}
#endif

#endif
