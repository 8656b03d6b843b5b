// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See rectangle_cut.h. A lane is a side of the parallelogram, p + t d with t from 0 to 1, p being its first
// corner; then a corner of the rectangle.
#include "geometry/rectangle_cut.h"

#include "simd/quad.h"

namespace epode {

namespace {

// Signs by which the corners of parallelogram and rectangle are made, in turn.
EPODE_LANEWISE Quad first_sign(Real a) { return quad(a, -a, -a, a); }
EPODE_LANEWISE Quad second_sign(Real a) { return quad(a, a, -a, -a); }
EPODE_LANEWISE Quad next(const Quad& a) { return quad(lane(a, 1), lane(a, 2), lane(a, 3), lane(a, 0)); }

EPODE_LANEWISE Quad corners(Real centre, Real u, Real v)
{
    return quad(centre) + first_sign(u) + second_sign(v);
}

// The stretches of the sides between -half and half. Where a side runs along one of these two, the quotient
// is no number and says nothing.
EPODE_LANEWISE void cut(const Quad& p, const Quad& d, Real half, Quad& from, Quad& to)
{
    const Quad inverse = quad(1) / d;
    const Quad a = (quad(-half) - p) * inverse, b = (quad(half) - p) * inverse;
    from = larger(smaller(a, b), from);
    to = smaller(larger(a, b), to);
}

EPODE_LANEWISE void put(CutPoints& out, int at, const Quad& x, const Quad& y, const Quad& z)
{
    store_quad(out.at[0] + at, x), store_quad(out.at[1] + at, y), store_quad(out.at[2] + at, z);
}

EPODE_LANEWISE Real larger_of(Real a, Real b) { return a > b ? a : b; }

// Corners of the rectangle over the parallelogram, at the heights of that.
EPODE_LANEWISE unsigned cover(const Parallelogram& f, Real half_x, Real half_y, Real slack, CutPoints& out)
{
    const Quad x = first_sign(half_x), y = second_sign(half_y);
    const Quad dx = x - quad(f.centre.x), dy = y - quad(f.centre.y);
    const Real area = f.u.x * f.v.y - f.u.y * f.v.x, per = 1 / area;
    const Quad s = (dx * quad(f.v.y) - dy * quad(f.v.x)) * quad(per);
    const Quad t = (dy * quad(f.u.x) - dx * quad(f.u.y)) * quad(per);
    put(out, 8, x, y, quad(f.centre.z) + s * quad(f.u.z) + t * quad(f.v.z));
    const Quad farther = larger(magnitude(s), magnitude(t));
    const unsigned over = bits(farther <= quad(1 + 4 * kEpsilon));
    // A way of `slack` is no more of s or t than this.
    const Real length = larger_of(std::fabs(f.u.x) + std::fabs(f.u.y), std::fabs(f.v.x) + std::fabs(f.v.y));
    const Real margin = slack * length * std::fabs(per);
    out.may_repeat |= (bits(farther > quad(1 - margin)) & over) != 0;
    return over;
}

}  // namespace

void cut_by_rectangle(const Parallelogram& f, Real half_x, Real half_y, Real slack, CutPoints& out)
{
    const Quad x = corners(f.centre.x, f.u.x, f.v.x), y = corners(f.centre.y, f.u.y, f.v.y),
               z = corners(f.centre.z, f.u.z, f.v.z);
    put(out, 0, x, y, z);
    const Quad beyond = larger(magnitude(x) - quad(half_x), magnitude(y) - quad(half_y));
    const unsigned inside = bits(beyond <= quad(0));
    if (inside == 15) {
        out.there = inside;
        return;
    }
    const Quad dx = next(x) - x, dy = next(y) - y, dz = next(z) - z;
    Quad from = quad(0), to = quad(1);
    cut(x, dx, half_x, from, to);
    cut(y, dy, half_y, from, to);
    put(out, 0, x + from * dx, y + from * dy, z + from * dz);
    put(out, 4, x + to * dx, y + to * dy, z + to * dz);
    const unsigned over = bits(from <= to), next_inside = inside >> 1 | (inside & 1) << 3;
    out.may_repeat = (bits(beyond > quad(-slack)) & inside) != 0;
    out.there = inside | over | (over & ~next_inside) << 4 | cover(f, half_x, half_y, slack, out) << 8;
}

}  // namespace epode
