// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See rectangle_cut.h. Corners are kept or dropped by their own distance, and each edge whose ends differ adds one
// point, unless the end that stays lies on the side already; the order is that of the corners.
#include "geometry/rectangle_cut.h"

#include "simd/quad.h"

namespace epode {

namespace {

struct Corner {
    Real x, y, z;
};

// The distances of the corners from one side, and which of them stay.
struct Side {
    alignas(16) Real distance[CutPolygon::kMax];
    unsigned in = 0;
    bool keeps(int i) const { return in >> i & 1; }
};

int next_of(int i, int count) { return i + 1 < count ? i + 1 : 0; }

EPODE_LANEWISE Corner corner(const CutPolygon& p, int i) { return {p.at[0][i], p.at[1][i], p.at[2][i]}; }
EPODE_LANEWISE void set(CutPolygon& p, int i, Corner c)
{
    p.at[0][i] = c.x, p.at[1][i] = c.y, p.at[2][i] = c.z;
}

// Where the edge from corner i crosses the side; false when its end that stays lies on it.
EPODE_LANEWISE bool crossing(const CutPolygon& p, const Side& s, int i, Corner& out)
{
    const int j = next_of(i, p.count);
    const Real here = s.distance[i], there = s.distance[j], t = here / (here - there);
    const Corner from = corner(p, i), to = corner(p, j);
    out = {from.x + t * (to.x - from.x), from.y + t * (to.y - from.y), from.z + t * (to.z - from.z)};
    return (here < there ? here : there) < 0;
}

void cut_one_by_one(CutPolygon& polygon, const Side& s)
{
    const CutPolygon old = polygon;
    polygon.count = 0;
    for (int i = 0; i < old.count; ++i) {
        if (s.keeps(i) && polygon.count < CutPolygon::kMax) set(polygon, polygon.count++, corner(old, i));
        Corner made;
        if (s.keeps(i) == s.keeps(next_of(i, old.count)) || (old.count == 2 && i == 1)) continue;
        if (crossing(old, s, i, made) && polygon.count < CutPolygon::kMax) set(polygon, polygon.count++, made);
    }
}

// Eight corners at a time, wanted or not.
EPODE_LANEWISE void move_corners(CutPolygon& p, int from, int to)
{
    for (auto& line : p.at) {
        const Quad first = load_quad(line + from), second = load_quad(line + from + 4);
        store_quad(line + to, first), store_quad(line + to + 4, second);
    }
}

// One run of corners goes: the edge from `last` leaves, the edge from `before` comes back.
EPODE_LANEWISE void cut_run(CutPolygon& p, const Side& s, int last, int before)
{
    Corner leaving, coming;
    const bool leaves = crossing(p, s, last, leaving), comes = crossing(p, s, before, coming);
    const int first = last < before ? last + 1 + leaves : 0, tail = first + comes;
    move_corners(p, before + 1, tail);
    if (comes) set(p, first, coming);
    if (last < before) {
        if (leaves) set(p, last + 1, leaving);
        p.count = tail + p.count - before - 1;
    } else {
        p.count = tail + last - before;
        if (leaves) set(p, p.count++, leaving);
    }
}

template <int axis, int sign>
EPODE_LANEWISE void cut(CutPolygon& p, Real half, Real slack)
{
    Side s;
    for (int i = 0; i < p.count; i += 4) {
        const Quad x = load_quad(p.at[axis] + i), d = (sign > 0 ? x : quad(0) - x) - quad(half);
        store_quad(s.distance + i, d);
        s.in |= bits(d <= quad(slack)) << i;
    }
    const unsigned all = (1u << p.count) - 1;
    s.in &= all;
    if (s.in == all) return;
    const unsigned next = s.in >> 1 | (s.in & 1) << (p.count - 1);
    const unsigned leave = s.in & ~next, come = next & ~s.in;
    const bool one_run = leave && (leave & (leave - 1)) == 0 && p.count > 2 && p.count <= 8;
    if (one_run)
        cut_run(p, s, __builtin_ctz(leave), __builtin_ctz(come));
    else
        cut_one_by_one(p, s);
}

}  // namespace

void cut_by_rectangle(CutPolygon& polygon, Real half_x, Real half_y, Real slack)
{
    cut<0, 1>(polygon, half_x, slack);
    cut<0, -1>(polygon, half_x, slack);
    cut<1, 1>(polygon, half_y, slack);
    cut<1, -1>(polygon, half_y, slack);
}

}  // namespace epode
