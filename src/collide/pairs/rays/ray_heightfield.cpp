// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A ray against a height field: the ray's shadow walks over the grid from cell to cell (Amanatides and Woo
// 1987), and over the diagonal of each cell, so that it is always over one facet. Its height above that facet
// is linear on the way, and a change of sign is a hit. The sign is carried from facet to facet, hence no ray
// slips through an edge and none hits one twice. All hits are reported, the nearest first, as far as the room
// goes; normals point up out of the ground, from whichever side the ray comes. A field without end is walked
// for kMaxCells at most.
#include "collide/pairs/surfaces/on_surface.h"
#include "collide/surfaces/heightfield.h"

namespace epode {

namespace {

constexpr int kMaxCells = 1 << 22;

struct Walk {
    const Terrain& terrain;
    Vec3 o, d;          // in the field's frame
    Real u, v, du, dv;  // place and speed of the shadow, in cells
    Real from, to;      // of the ray's parameter
    Real steepness;     // of a facet, per difference of its heights, at most
    Real hair;          // rounding of a height above a level facet
    Vec3 at(Real t) const { return o + t * d; }
};

void cut(Real o, Real d, Real lo, Real hi, Real& from, Real& to)
{
    if (d == 0) {
        if (o < lo || o > hi) to = -kInf;
        return;
    }
    const Real a = (lo - o) / d, b = (hi - o) / d;
    const Real first = a < b ? a : b, last = a < b ? b : a;
    from = first > from ? first : from;
    to = last < to ? last : to;
}

int sign(Real x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }

struct Crossing {
    int side = 0;  // above, on or below the surface at the last place
    bool started = false;
};

// The stretch ta..tb lies over the facet. False when the sink is full.
bool cross_facet(const Walk& w, const Facet& f, Real ta, Real tb, Crossing& c, ContactSink& sink)
{
    Real ga = f.height(w.at(ta));
    const Real gb = f.height(w.at(tb));
    if (!c.started) {
        c.started = true;
        c.side = sign(ga);
        if (c.side == 0 && !sink.add({w.at(ta), f.n, ta})) return false;
    }
    const bool hit = (c.side > 0 && gb <= 0) || (c.side < 0 && gb >= 0);
    if (hit) {
        if (sign(ga) != c.side) ga = 0;  // rounding at the edge between two facets
        const Real t = ga != gb ? ta + (tb - ta) * (ga / (ga - gb)) : ta;
        sink.add({w.at(t), f.n, t});
    }
    c.side = sign(gb);
    return !sink.full();
}

// The ray crosses, at t, the side `edge` of a facet beyond which there is a hole.
void cross_wall(const Walk& w, const Facet& f, int edge, Real t, ContactSink& sink)
{
    const Vec3 p = w.at(t), v = f.v[edge], e = f.edge(edge);
    const int along = 2 - f.out_axis(edge);
    const Real top = v.y + (p[along] - v[along]) / e[along] * e.y;
    if (p.y <= top && p.y >= top - w.terrain.thickness()) sink.add({p, f.out(edge), t});
}

// On which side of all of the cell the stretch surely is: most cells need no planes of their facets.
int sure_side(const Walk& w, const Terrain::BareCell& cell, Real ta, Real tb)
{
    const Real a = w.o.y + ta * w.d.y, b = w.o.y + tb * w.d.y;
    const Real slack = w.hair * (1 + (cell.highest - cell.lowest) * w.steepness);
    if (a > cell.highest + slack && b > cell.highest + slack) return 1;
    return a < cell.lowest - slack && b < cell.lowest - slack ? -1 : 0;
}

// What the ray meets of cell (i, j) from ta to tb; false when the sink is full.
bool cross_cell(const Walk& w, int i, int j, Real ta, Real tb, Crossing& crossing, ContactSink& sink)
{
    Terrain::BareCell cell = w.terrain.bare_cell(i, j);
    const int side = sure_side(w, cell, ta, tb);
    if (side != 0 && (!crossing.started || crossing.side == side)) {
        crossing = {side, true};
        return true;
    }
    // Where the shadow crosses the diagonal, if it does so here.
    const Real across = w.du + w.dv;
    const Real diagonal = across != 0 ? (Real(i) + Real(j) + 1 - w.u - w.v) / across : kInf;
    const bool split = diagonal > ta && diagonal < tb;
    const auto upper = [&](Real a, Real b) {
        const Real middle = Real(0.5) * (a + b);
        return w.u + w.v + middle * across - Real(i) - Real(j) > 1;
    };
    const auto cross = [&](Real a, Real b) {
        Facet& f = cell.facets[upper(a, b)];
        finish(f);
        return cross_facet(w, f, a, b, crossing, sink);
    };
    return split ? cross(ta, diagonal) && cross(diagonal, tb) : cross(ta, tb);
}

int start_cell(Real place, int count, bool endless)
{
    const int i = int(std::floor(place));
    return endless ? i : i < 0 ? 0 : i < count ? i : count - 1;
}

Real next_line(int i, Real place, Real speed)
{
    return speed > 0 ? (Real(i + 1) - place) / speed : speed < 0 ? (Real(i) - place) / speed : kInf;
}

void walk(const Walk& w, ContactSink& sink)
{
    const Terrain& terrain = w.terrain;
    const Real u = w.u + w.from * w.du, v = w.v + w.from * w.dv;
    if (!(std::fabs(u) < Real(1e9) && std::fabs(v) < Real(1e9))) return;
    int i = start_cell(u, terrain.cells_x(), terrain.endless()),
        j = start_cell(v, terrain.cells_z(), terrain.endless());
    Crossing crossing;
    Real t = w.from;
    for (int step = 0; step < kMaxCells; ++step) {
        const Real tu = next_line(i, w.u, w.du), tv = next_line(j, w.v, w.dv);
        Real end = tu < tv ? tu : tv;
        end = end > w.to ? w.to : end > t ? end : t;
        const bool hole = terrain.hole(i, j);
        if (hole)
            crossing = {};
        else if (!cross_cell(w, i, j, t, end, crossing, sink))
            return;
        if (end >= w.to) return;
        t = end;
        const bool by_x = tu<tv, onward = (by_x ? w.du : w.dv)> 0;
        const int from_i = i, from_j = j;
        (by_x ? i : j) += onward ? 1 : -1;
        if (terrain.holed() && hole != terrain.hole(i, j)) {
            // Out of the ground by the side ahead, or into it by the side that is behind then.
            const Facet adjacent =
                hole ? terrain.facet(i, j, !onward) : terrain.facet(from_i, from_j, onward);
            const int edge = by_x ? 0 : 2;
            if (terrain.hole_beyond(adjacent, edge)) cross_wall(w, adjacent, edge, t, sink);
            if (sink.full()) return;
        }
        if (!terrain.endless() && (i < 0 || j < 0 || i >= terrain.cells_x() || j >= terrain.cells_z()))
            return;
    }
}

}  // namespace

void ray_heightfield(const Ray& a, const Pose& A, const Heightfield& b, const Pose& B, ContactSink& sink)
{
    const HeightfieldData* data = b.field();
    if (!data || !(a.length >= 0)) return;
    const Terrain terrain(*data);
    const Vec3 corner = terrain.low_corner(), cell = terrain.cell();
    Walk w{.terrain = terrain,
           .o = B.to_local(A.p),
           .d = transposed_times(B.R, A.R.column(2)),
           .u = 0,
           .v = 0,
           .du = 0,
           .dv = 0,
           .from = 0,
           .to = a.length,
           .steepness = 2 / cell.x + 2 / cell.z,
           .hair = 0};
    w.hair = 64 * kEpsilon * (std::fabs(w.o.x) + std::fabs(w.o.y) + std::fabs(w.o.z) + a.length);
    w.u = (w.o.x - corner.x) / cell.x, w.v = (w.o.z - corner.z) / cell.z;
    w.du = w.d.x / cell.x, w.dv = w.d.z / cell.z;
    if (data->wrap) {
        cut(w.o.y, w.d.y, data->lowest, data->highest, w.from, w.to);
    } else {
        cut(w.o.x, w.d.x, corner.x, -corner.x, w.from, w.to);
        cut(w.o.z, w.d.z, corner.z, -corner.z, w.from, w.to);
    }
    if (!(w.from <= w.to)) return;
    const int before = sink.count();
    walk(w, sink);
    to_world(B, sink, before);
}

}  // namespace epode
