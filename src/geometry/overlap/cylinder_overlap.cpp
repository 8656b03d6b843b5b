// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Two cylinders: see flat_overlap.h. With the axes u and w, radii R and r, half heights H and l, and c from
// a's middle to b's,
//   h(n) = n.c + R |n - (n.u) u| + H |n.u| + r |n - (n.w) w| + l |n.w|,
// and since h(-n) = h(n) - 2 n.c only normals against c need be tried. Where both rims touch h is smooth; its
// gradient is the support point s less its part along n, its second derivative
//   R / |n - (n.u) u|  p p^T + r / |n - (n.w) w|  q q^T - h,   p and q the units along u x n and w x n.
// The best of the normals halfway between the others are followed down by Newton's steps, or where h is
// not cupped by the gradient, each shortened until it descends.
#include "geometry/overlap/flat_overlap.h"
#include "geometry/overlap/overlap_arc.h"

namespace epode {

namespace {

constexpr Real kNearEnd = Real(0.05);  // of the size: how much lower a narrow valley may be
constexpr Vec3 kAxis = {0, 0, 1};

Vec3 across(Vec3 v, Vec3 unit) { return v - dot(unit, v) * unit; }
Vec3 against(Vec3 n, Vec3 c) { return dot(n, c) > 0 ? -n : n; }

// Adds the rim's part of the second derivative in the basis (u, v).
bool add_rim(Vec3 axis, Real radius, Vec3 n, Vec3 u, Vec3 v, Real& uu, Real& uv, Real& vv)
{
    const Vec3 w = cross(axis, n);
    const Real size = length(w);
    if (!(size > Real(1e-9))) return false;
    const Real k = radius / (size * size * size), wu = dot(w, u), wv = dot(w, v);
    uu += k * wu * wu, uv += k * wu * wv, vv += k * wv * wv;
    return true;
}

}  // namespace

CylinderPair::CylinderPair(const ConvexView& a, const ConvexView& b)
    : a_(a),
      b_(b),
      one_(a),
      two_(b),
      b_in_a_(inverse_times(a.pose, b.pose)),
      axis_(b_in_a_.R.column(2)),
      handicap_(kPreference * (a.size + b.size)),
      size_(a.size + b.size)
{}

// h(n) of a unit vector and the support point.
Real CylinderPair::overlap(Vec3 n, Vec3& point) const
{
    const Real along = dot(axis_, n);
    const Vec3 aside = n - along * axis_;
    const Real rho = std::sqrt(n.x * n.x + n.y * n.y), sigma = length(aside);
    point = b_in_a_.p;
    // An axis that rounding has made longer than one leaves some of itself in `aside`.
    constexpr Real kHair = 256 * kEpsilon;
    if (rho > kHair) point += Vec3{one_.radius * n.x / rho, one_.radius * n.y / rho, 0};
    if (sigma > kHair) point += (two_.radius / sigma) * aside;
    point += (n.z < 0 ? -one_.half_length : one_.half_length) * kAxis;
    point += (along < 0 ? -two_.half_length : two_.half_length) * axis_;
    return dot(n, point);
}

void CylinderPair::offer(Vec3 n, Real depth, Real handicap)
{
    if (!(depth + handicap < best.depth)) return;
    best.depth = depth, normal_ = n;
    end_of_a_ = end_of_b_ = false;
}

void CylinderPair::try_faces(Real enough)
{
    const Vec3 c = b_in_a_.p, u = against(kAxis, c), w = against(axis_, c);
    offer(u, overlap(u), 0);
    end_of_a_ = true;
    if (best.depth >= enough) {
        const Real before = best.depth;
        offer(w, overlap(w), handicap_);
        end_of_b_ = best.depth < before;
    }
    Vec3 n = against(cross(kAxis, axis_), c);
    if (best.depth >= enough && length2(n) > Real(1e-6) && normalize(n))
        offer(n, one_.radius + two_.radius + dot(n, c), 2 * handicap_);
    n = -across(c, kAxis);
    if (best.depth >= enough && length2(cross(kAxis, axis_)) <= Real(1e-3) && normalize(n))
        offer(n, overlap(n), 2 * handicap_);
    best.normal = a_.pose.R * normal_;
}

// Against an end: the middle of what the other shows, if that is level, else its lowest point.
bool CylinderPair::proven() const
{
    if (!end_of_a_ && !end_of_b_) return false;
    const Real enough = best.depth - 2 * handicap_;
    const RoundCore& end = end_of_a_ ? one_ : two_;
    const RoundCore& other = end_of_a_ ? two_ : one_;
    const Pose other_in_end = end_of_a_ ? b_in_a_ : inverse_times(b_.pose, a_.pose);
    const Vec3 n = end_of_a_ ? normal_ : -transposed_times(b_in_a_.R, normal_);
    Vec3 d = transposed_times(other_in_end.R, n);
    const Real rho = std::sqrt(d.x * d.x + d.y * d.y);
    if (other.half_length * std::fabs(d.z) <= handicap_ && rho > 0)
        return end.within(other_in_end.to_world({other.radius * d.x / rho, other.radius * d.y / rho, 0}),
                          0) >= enough;
    if (other.radius * rho > handicap_)
        return end.within(other_in_end.to_world(other.support(d)), 0) >= enough;
    // Discs: the middle of the lens that they share.
    const Vec3 p = other_in_end.to_world({0, 0, d.z < 0 ? -other.half_length : other.half_length});
    const Real distance = std::sqrt(p.x * p.x + p.y * p.y);
    if (!(distance > 0)) return end.within(p, 0) >= enough;
    const Real lo = std::fmax(-end.radius, distance - other.radius),
               hi = std::fmin(end.radius, distance + other.radius), x = Real(0.5) * (lo + hi) / distance;
    return lo < hi && end.within({x * p.x, x * p.y, p.z}, 0) >= enough;
}

bool CylinderPair::proven_at(Vec3 point) const
{
    const Real one = one_.within(a_.pose.to_local(point), 0), two = two_.within(b_.pose.to_local(point), 0);
    return one >= -handicap_ && two >= -handicap_ && one + two >= best.depth - 2 * handicap_;
}

// The side of one against the rim of the other.
void CylinderPair::turn_about(bool first, Real enough)
{
    const Pose& place = first ? b_.pose : a_.pose;
    const RoundCore &side = first ? one_ : two_, &rim = first ? two_ : one_;
    // In the frame of the one whose rim touches, n outward from the other.
    const Vec3 e = transposed_times(place.R, (first ? a_ : b_).pose.R.column(2));
    const Vec3 c = transposed_times(place.R, (first ? a_ : b_).pose.p - place.p);
    Vec3 m = -across(c, e);
    if (!(best.depth >= enough) || !normalize(m)) return;
    const Arc arc = {c, m, cross(e, m), rim.radius, rim.half_length};
    try_arc(arc, Real(1e4), [&](Vec3 n, Real h) {
        if (!(h + side.radius + 2 * handicap_ < best.depth) || !normalize(n)) return;
        const Vec3 world = place.R * n;
        offer(transposed_times(a_.pose.R, first ? -world : world), h + side.radius, 2 * handicap_);
    });
}

void CylinderPair::descend(Vec3 n)
{
    Vec3 s;
    Real h = overlap(n, s);
    for (int i = 0; i < 24; ++i) {
        Vec3 u, v;
        plane_space(n, u, v);
        const Real gu = dot(u, s), gv = dot(v, s);
        Real uu = -h, uv = 0, vv = -h;
        const bool smooth = add_rim(kAxis, one_.radius, n, u, v, uu, uv, vv) &&
                            add_rim(axis_, two_.radius, n, u, v, uu, uv, vv);
        const Real det = uu * vv - uv * uv;
        const Real down = Real(1) / size_;
        Real su = -down * gu, sv = -down * gv;
        if (smooth && det > 0 && uu > 0) su = (uv * gv - vv * gu) / det, sv = (uv * gu - uu * gv) / det;
        const Real far = std::sqrt(su * su + sv * sv);
        if (!(far > 16 * kEpsilon)) break;
        Real part = far > Real(0.5) ? Real(0.5) / far : Real(1);
        bool better = false;
        for (int k = 0; k < 5 && !better; ++k, part *= Real(0.25)) {
            Vec3 m = n + part * (su * u + sv * v), at;
            if (!normalize(m)) break;
            const Real lower = overlap(m, at);
            if (lower < h) better = true, h = lower, n = m, s = at;
        }
        if (!better) break;
    }
    offer(n, h, 2 * handicap_);
}

// Near the axis h is a cone that leans: where it leans more than it opens there is a valley, often narrow.
void CylinderPair::leave_end(Vec3 axis, Real radius)
{
    const Vec3 end = against(axis, b_in_a_.p);
    Vec3 s;
    const Real h = overlap(end, s);
    const Vec3 lean = across(s, end);
    const Real steep = length(lean);
    if (!(steep > radius) || h > best.depth + kNearEnd * size_) return;
    descend(normalized_or(end - (Real(1e-3) / steep) * lean, end));
}

void CylinderPair::try_rest(Real enough)
{
    const Vec3 c = b_in_a_.p;
    turn_about(true, enough);
    turn_about(false, enough);
    if (best.depth >= enough) {
        const Vec3 from[] = {against(kAxis, c),
                             against(axis_, c),
                             normalized_or(-c, kAxis),
                             normalized_or(-across(c, kAxis), kAxis),
                             normalized_or(-across(c, axis_), axis_),
                             normal_};
        constexpr Real kSameValley = Real(0.85);
        Vec3 middle[15], start = normal_;
        Real height[15], least = kInf;
        int count = 0;
        for (int i = 0; i < 6; ++i)
            for (int j = 0; j < i; ++j) {
                Vec3 n = from[i] + from[j];
                if (length2(n) < Real(0.01) || !normalize(n)) continue;
                middle[count] = n, height[count] = overlap(n);
                if (height[count] < least) least = height[count], start = n;
                ++count;
            }
        Vec3 other = start;
        least = kInf;
        for (int i = 0; i < count; ++i)
            if (height[i] < least && dot(middle[i], start) < kSameValley)
                least = height[i], other = middle[i];
        descend(start);
        if (least < kInf) descend(other);
        leave_end(kAxis, one_.radius), leave_end(axis_, two_.radius);
    }
    best.normal = a_.pose.R * normal_;
}

}  // namespace epode
