// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See terrain_facet.h.
#include "collide/pairs/surfaces/terrain_facet.h"

#include "geometry/mesh_edges.h"

namespace epode {

bool bare_terrain_facet(const Facet& facet, MeshFacet& f)
{
    f.n = lie_of(facet.v, kEpsilon).n;
    if (f.n == Vec3{}) return false;
    for (int k = 0; k < 3; ++k) f.v[k] = facet.v[k];
    f.c = dot(f.n, f.v[0]);
    return true;
}

void find_terrain_rims(const Terrain& terrain, const TerrainPlace& place, MeshFacet& f)
{
    const float tilt = lie_of(f.v, kEpsilon).tilt;
    for (int k = 0; k < 3; ++k) {
        f.sharp[k] = true;  // the walk around the corner decides
        f.rim[k] = Rim::kBorder;
        f.beyond[k] = -f.n;
        const Terrain::Neighbour next = terrain.neighbour(place.facet, k);
        if (!next.there) {
            if (!terrain.hole_beyond(place.facet, k) || !(terrain.thickness() > 0)) continue;
            f.rim[k] = Rim::kConvex;
            f.beyond[k] = place.facet.out(k);
            continue;
        }
        const TriangleLie lie = lie_of(terrain.bare_facet(next.i, next.j, next.upper).v, kEpsilon);
        if (lie.n == Vec3{}) continue;
        const Vec3 edge = f.edge(k);
        const SheetTurn turn = sheet_turn(next.apex, f.v[k], normalized_or(edge, {}), f.n);
        f.beyond[k] = lie.n;
        f.rim[k] = rim_of(f.n, edge, lie.n, turn.convex(flat_sine(tilt, lie.tilt)));
    }
}

bool terrain_walls(const Terrain& terrain, const Facet& facet, int k, MeshFacet (&walls)[2])
{
    Triangle wall[2];
    if (!terrain.hole_beyond(facet, k) || !terrain.wall_below(facet, k, wall)) return false;
    const Vec3 out = facet.out(k), e = facet.edge(k);
    const Vec3 along =
        k == 0 ? Vec3{0, 0, e.z > 0 ? Real(1) : Real(-1)} : Vec3{e.x > 0 ? Real(1) : Real(-1), 0, 0};
    for (int n = 0; n < 2; ++n) {
        MeshFacet& w = walls[n];
        static_cast<Triangle&>(w) = wall[n];
        for (int edge = 0; edge < 3; ++edge)
            w.rim[edge] = Rim::kSeam, w.beyond[edge] = w.n, w.sharp[edge] = false;
        // The upright side: the cells at this end of the rim, in the terrain's row and in the hole's.
        const Vec3 aside = n == 0 ? -along : along;
        const int i = facet.i + int(aside.x), j = facet.j + int(aside.z);
        if (!terrain.has(i, j) || !terrain.has(i + 1, j + 1))
            w.rim[0] = Rim::kFlat;
        else if (terrain.hole(i, j))
            w.rim[0] = Rim::kConvex, w.beyond[0] = aside;
        else if (!terrain.hole(i + int(out.x), j + int(out.z)))
            w.rim[0] = Rim::kHollow, w.beyond[0] = -aside;
    }
    walls[0].rim[2] = Rim::kConvex, walls[0].beyond[2] = lie_of(facet.v, kEpsilon).n;
    walls[1].rim[2] = Rim::kFlat;  // the slab's bottom makes no contacts
    return true;
}

bool terrain_crests_at_corner(const Terrain& terrain, const TerrainPlace& place, int corner, Vec3 n)
{
    if (place.wall || (terrain.holed() && terrain.thickness() > 0 && n.y < 0)) return false;
    return terrain.falls_around(place.facet, corner, n, kLevel);
}

}  // namespace epode
