// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See triangle_rim.h. Places on the arc are points (x, y), not of unit length between samples: the slope
// along the arc has the same sign.
#include "geometry/triangle_rim.h"

#include "geometry/root.h"

namespace epode {

namespace {

struct Place {
    Real x, y;
};

// Half a turn in eight steps.
constexpr int kSteps = 8;
constexpr Real kStep = Real(0.39269908169872414);
constexpr Real kC1 = Real(0.92387953251128674), kC2 = Real(0.70710678118654752),
               kC3 = Real(0.38268343236508977);
constexpr Place kPlaces[kSteps + 1] = {{1, 0},      {kC1, kC3},  {kC2, kC2},  {kC3, kC1}, {0, 1},
                                       {-kC3, kC1}, {-kC2, kC2}, {-kC1, kC3}, {-1, 0}};

struct Sample {
    Real g, slope;
};

struct Arc : RimArc {
    Real along(Place p) const { return p.x * dn + p.y * dd; }
    Real overlap(Place p) const
    {
        const Real b = along(p), across2 = p.x * p.x + p.y * p.y - b * b;
        return p.x * wn + p.y * wo + h * std::fabs(b) + r * std::sqrt(across2 > 0 ? across2 : Real(0));
    }
    // Both at a place of unit length.
    Sample at(Place p) const
    {
        const Real b = along(p), turned = p.x * dd - p.y * dn, across2 = 1 - b * b;
        const Real across = std::sqrt(across2 > 0 ? across2 : Real(0)), end = b >= 0 ? h : -h;
        return {p.x * wn + p.y * wo + end * b + r * across,
                p.x * wo - p.y * wn + end * turned - (across > 0 ? r * b * turned / across : Real(0))};
    }
    // Along the arc, as if n . d had the sign `up`.
    Real slope(Place p, Real up) const
    {
        const Real b = along(p), turned = p.x * dd - p.y * dn;
        const Real across2 = p.x * p.x + p.y * p.y - b * b;
        const Real rim = across2 > 0 ? b * turned / std::sqrt(across2) : Real(0);
        return p.x * wo - p.y * wn + up * h * turned - r * rim;
    }
};

Place between(Place p, Place q, Real t) { return {p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)}; }

// Between p, where g falls, and q, where it rises.
Place turn_between(const Arc& arc, Place p, Real at_p, Place q, Real at_q)
{
    Real from = 0, to = 1;
    const Real bp = arc.along(p), bq = arc.along(q);
    Real up = bp >= 0 ? Real(1) : Real(-1);
    if ((bp < 0) != (bq < 0) && bp != bq) {  // a kink: one end of the cylinder gives way to the other
        const Real t = bp / (bp - bq);
        const Place kink = between(p, q, t);
        const Real before = arc.slope(kink, up), behind = arc.slope(kink, -up);
        if (before <= 0 && behind >= 0) return kink;
        if (before > 0)
            to = t, at_q = before;
        else
            from = t, at_p = behind, up = -up;
    }
    const auto slope = [&](Real t) { return arc.slope(between(p, q, t), up); };
    return between(p, q, rising_root(slope, from, at_p, to, at_q));
}

// What g cannot be less than between two samples: where the tangents meet, less what g can bend down.
Real floor_between(Sample a, Sample b)
{
    const Real meet = (b.g - a.g - b.slope * kStep) / (a.slope - b.slope);
    const Real largest = a.g > b.g ? a.g : b.g;
    return a.g + a.slope * meet - (largest > 0 ? Real(0.1) * largest : Real(0));
}

// Whether g stays above `worth` on the quarter from a to b: the tangents at both are bounds from below, as
// g cos + g' sin, for g + g'' >= 0; where they meet they are (a.g b.g + a.slope b.slope) / |(b.g - a.slope,
// a.g + b.slope)|.
bool remains_above(Sample a, Sample b, Real worth)
{
    const Real x = b.g - a.slope, y = a.g + b.slope;
    if (!(worth >= 0 && a.g >= worth && b.g >= worth)) return false;
    if (x <= 0 || y <= 0) return true;  // one of the tangents is above the other all the way
    const Real meet = a.g * b.g + a.slope * b.slope;
    return meet > 0 && meet * meet >= worth * worth * (x * x + y * y);
}

constexpr Real kNarrow = Real(0.95);  // cosine of the angle within which a rise is not undone

}  // namespace

RimArc::RimArc(const Cylinder& cylinder, const Pose& pose, const Triangle& f, int edge)
    : normal(f.n), h(cylinder.half_length), r(cylinder.radius)
{
    const Vec3 out = cross(f.edge(edge), f.n), d = pose.R.column(2), w = f.v[edge] - pose.p;
    const Real size = length(out);
    outward = size > 0 ? out / size : Vec3{};
    wn = dot(w, f.n), wo = dot(w, outward), dn = dot(d, f.n), dd = dot(d, outward);
}

bool rim_turns_before(const RimArc& edge, Vec3 neighbour)
{
    const Place last{dot(neighbour, edge.normal), dot(neighbour, edge.outward)};
    if (last.x < kNarrow) return true;
    const Arc arc{edge};
    return arc.at(kPlaces[0]).slope < 0 && arc.at(last).slope > 0;
}

int rim_minima(const RimArc& edge, Real worth, RimMinimum* out)
{
    const Arc arc{edge};
    int found = 0;
    constexpr int kQuarter = kSteps / 2;
    const Sample at_quarter[3] = {arc.at(kPlaces[0]), arc.at(kPlaces[kQuarter]), arc.at(kPlaces[kSteps])};
    Sample a = at_quarter[0];
    for (int i = 0; i < kSteps; ++i) {
        if (i % kQuarter == 0) {
            const Sample &from = at_quarter[i / kQuarter], &to = at_quarter[i / kQuarter + 1];
            a = from;
            if (remains_above(from, to, worth)) {
                i += kQuarter - 1;
                continue;
            }
        }
        const Place p = kPlaces[i], q = kPlaces[i + 1];
        const Sample b = (i + 1) % kQuarter ? arc.at(q) : at_quarter[(i + 1) / kQuarter];
        if (a.slope < 0 && b.slope > 0 && floor_between(a, b) < worth && found < kMostRimMinima) {
            const Place least = turn_between(arc, p, a.slope, q, b.slope);
            const Real per = 1 / std::sqrt(least.x * least.x + least.y * least.y);
            const Real overlap = per * arc.overlap(least);
            if (overlap < worth)
                out[found++] = {per * (least.x * arc.normal + least.y * arc.outward), overlap};
        }
        a = b;
    }
    return found;
}

}  // namespace epode
