// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// One triangle of a mesh as contacts see it, in the mesh's frame, and which contact normals it may give.
//   own      n, the triangle's normal, on the side that it is met from
//   crest    m, where the surface stays below the plane across m at what the triangle shows along m: at an
//            edge with w pointing into the neighbour, m . w <= 0; at a corner, for all edges that leave it.
//            So m lies in the Voronoi region of the edge or corner.
// Flat and concave edges have no crest, so a solid that slides over them meets no bumps.
// Seams are edges so flat that a manifold continues beyond them: they end no manifold.
// A triangle that the program refuses is not there: the edges towards it are borders.
#pragma once

#include "collide/pairs/contact_collector.h"
#include "collide/pairs/polyhedra/placed_hull.h"
#include "collide/pairs/surfaces/on_surface.h"
#include "collide/surfaces/triangle_list.h"
#include "geometry/triangle.h"
#include "geometry/triangle_mesh.h"

namespace epode {

struct MeshFacet : Triangle, MeshRims {
    Vec3 beyond[3];       // unit normal of the neighbour over edge k; not known at seams
    bool behind = false;  // met from the back: everything is turned round
    int index = -1;

    bool has_crest() const { return sharp[0] || sharp[1] || sharp[2]; }
    // Across edge k into the neighbour, along its surface; as long as the edge.
    Vec3 into(int k) const { return cross(edge(k), beyond[k]); }
};

// Of a triangle that is not degenerate. `refused`: triangles that are not there, in order, or null.
MeshFacet facet_of(const TriangleMesh& mesh, int triangle, const TriangleList* refused = nullptr);
MeshRims rims_of(const TriangleMesh& mesh, int triangle, const TriangleList* refused);

// The same triangle from its back.
MeshFacet turned(const MeshFacet& facet);

// One solid and one mesh while its triangles are visited.
struct MeshPair {
    const TriangleMesh& mesh;
    const ConvexView& solid;  // in the mesh's frame
    Real slack;               // slack_of(solid)
    bool two_sided;           // else only the fronts of triangles have contacts
    bool whole;   // memory has sufficed; else seams end manifolds, their neighbours may be missing
    bool as_ode;  // of a ball: its place on the mesh, and a contact for each triangle under it
    ContactCollector& out;
    PlacedHull* hull = nullptr;  // the solid, if it is a polyhedron
    const TriangleList* refused = nullptr;

    MeshFacet facet(int triangle) const { return facet_of(mesh, triangle, refused); }
    bool seam(const MeshFacet& f, int edge) const { return whole && f.rim[edge] == Rim::kSeam; }
};

inline constexpr Real kLevel = kSingle ? Real(1e-4) : Real(1e-6);  // sine of an angle that counts as flat

struct Crest {
    bool stands = false;
    bool border = false;
};

Crest crest_at_edge(const MeshFacet& facet, int edge, Vec3 normal);
Crest crest_at_corner(const TriangleMesh& mesh, const MeshFacet& facet, int corner, Vec3 normal,
                      const TriangleList* refused = nullptr);

Shows shown_along(const MeshFacet& facet, Vec3 direction);

// Of a border's neighbourhood: so near under the surface, as a part of the solid's size, the border is not
// felt and the surface's own normal stands, so that meshes laid edge to edge are one floor.
inline constexpr Real kLip = Real(0.01);

// Capsules.
void round_on(const RoundSolid& core, const MeshFacet& facet, MeshPair& pair);

// A sphere, as round_on(); of the triangle only what is needed is looked up.
void ball_on(Vec3 centre, Real radius, int triangle, MeshPair& pair);

// Any other solid, by the view in `pair`.
void solid_on(const MeshFacet& facet, MeshPair& pair);

// Whether the least overlap is at a crest of the triangle; if it is, adds the contacts there.
bool add_crest_if_least(const MeshFacet& facet, MeshPair& pair);

}  // namespace epode
