// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See wrap.h. In the plane, with p at the distance D from the circle's centre, lines through p touch a circle of radius r at
// (r^2 p +- r sqrt(D^2 - r^2) p') / D^2, p' being p turned by a quarter.
#include "robots/wrap.h"

#include <algorithm>

namespace epode::robots {

namespace {

constexpr double kLeast = 1e-15;

struct Flat {
    double x = 0, y = 0;
};

Flat operator+(Flat a, Flat b) { return {a.x + b.x, a.y + b.y}; }
Flat operator-(Flat a, Flat b) { return {a.x - b.x, a.y - b.y}; }
Flat operator*(double s, Flat a) { return {s * a.x, s * a.y}; }
double dot(Flat a, Flat b) { return a.x * b.x + a.y * b.y; }
double cross(Flat a, Flat b) { return a.x * b.y - a.y * b.x; }
double length(Flat a) { return std::sqrt(dot(a, a)); }
Flat unit(Flat a) { return (1 / std::max(length(a), kLeast)) * a; }
Flat quarter(Flat a) { return {-a.y, a.x}; }

// Where the string meets the circle and leaves it, and by how much it turns in between.
struct Bend {
    bool touches = false;
    Flat first, last;
    double angle = 0;
};

// From a to b, 0 ... 2 pi, in the sense of turning (1: left).
double angle_between(Flat a, Flat b, double sense)
{
    const Flat u = unit(a), v = unit(b);
    const double sine = sense * cross(u, v);
    const double angle = angle_of(normalised({1 + dot(u, v), 0, 0, sine}));
    return sine < 0 ? 2 * kPi - angle : angle;
}

Flat touching_point(Flat p, double r, double sense)
{
    const double d2 = dot(p, p);
    return (r * r / d2) * p + (sense * r * std::sqrt(std::max(0.0, d2 - r * r)) / d2) * quarter(p);
}

Bend around(Flat a, Flat b, double r, double sense)
{
    Bend out{true, touching_point(a, r, sense), touching_point(b, r, -sense), 0};
    out.angle = angle_between(out.first, out.last, sense);
    return out;
}

Flat nearest_on_line(Flat a, Flat b)
{
    const Flat way = b - a;
    const double share = std::clamp(-dot(a, way) / std::max(dot(way, way), kLeast), 0.0, 1.0);
    return a + share * way;
}

// By the smaller angle between a and b where the straight way meets the circle; by the larger one where the side is in the part of
// the plane that this angle has opposite to it.
Bend outside(Flat a, Flat b, double r, const Flat* side)
{
    const double sense = cross(a, b) >= 0 ? 1 : -1;
    if (side && sense * cross(a, *side) < 0 && sense * cross(*side, b) < 0) return around(a, b, r, -sense);
    return length(nearest_on_line(a, b)) > r ? Bend{} : around(a, b, r, sense);
}

// Between a and b on the smaller arc the way over the circle's point is shortest where both parts meet it at the same angle.
Bend inside(Flat a, Flat b, double r)
{
    if (length(nearest_on_line(a, b)) < r) return {};
    const double sense = cross(a, b) >= 0 ? 1 : -1;
    Flat low = touching_point(b, r, -sense), high = touching_point(a, r, sense);
    if (sense * cross(a, low) < 0) low = r * unit(a);
    if (sense * cross(high, b) < 0) high = r * unit(b);
    Flat middle = low;
    for (int i = 0; i < 60; ++i) {
        middle = r * unit(low + high);
        const Flat along = sense * quarter(middle);
        const bool beyond = dot(unit(a - middle) + unit(b - middle), along) < 0;
        (beyond ? high : low) = middle;
    }
    return {true, middle, middle, 0};
}

Bend bend(Flat a, Flat b, const Surface& surface, Flat side)
{
    const double r = surface.radius;
    if (length(a) < r || length(b) < r || length(b - a) < kLeast) return {};
    if (surface.has_side && length(surface.side) < r) return inside(a, b, r);
    return outside(a, b, r, surface.has_side ? &side : nullptr);
}

Vec perpendicular_to(Vec v)
{
    const Vec other = std::fabs(v.x) < 0.6 * length(v) ? Vec{1, 0, 0} : Vec{0, 1, 0};
    return cross(v, other);
}

Wrap around_sphere(const Surface& surface, Vec from, Vec to)
{
    if (length(from) < kLeast || length(to) < kLeast) return {};
    Vec normal = cross(from, to);
    if (length(normal) < 1e-12 * length(from) * length(to))
        normal = surface.has_side && length(cross(from, surface.side)) > kLeast ? cross(from, surface.side)
                                                                                : perpendicular_to(from);
    const Vec x = (1 / length(from)) * from, y = cross((1 / length(normal)) * normal, x);
    const auto flat = [&](Vec v) { return Flat{dot(v, x), dot(v, y)}; };
    const auto full = [&](Flat v) { return v.x * x + v.y * y; };
    const Bend its = bend(flat(from), flat(to), surface, flat(surface.side));
    if (!its.touches) return {};
    return {true, full(its.first), full(its.last), surface.radius * its.angle};
}

Wrap around_cylinder(const Surface& surface, Vec from, Vec to)
{
    const Flat a{from.x, from.y}, b{to.x, to.y};
    const Bend its = bend(a, b, surface, {surface.side.x, surface.side.y});
    if (!its.touches) return {};
    const double before = length(its.first - a), arc = surface.radius * its.angle,
                 after = length(b - its.last);
    const double slope = (to.z - from.z) / std::max(before + arc + after, kLeast);
    return {true,
            {its.first.x, its.first.y, from.z + slope * before},
            {its.last.x, its.last.y, from.z + slope * (before + arc)},
            arc * std::sqrt(1 + slope * slope)};
}

}  // namespace

Wrap wrap_around(const Surface& surface, Vec from, Vec to)
{
    return surface.is_cylinder ? around_cylinder(surface, from, to) : around_sphere(surface, from, to);
}

}  // namespace epode::robots
