// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "geometry/immersion/revolved_solid.h"

#include <algorithm>
#include <cmath>

#include "math/trig.h"

namespace epode {
namespace {

// Gauss' rule with 20 places x in phi = (pi/2) x: sin(phi) and the weights of the integral over sin(phi), of one sign.
constexpr struct {
    Real place, weight;
} kRule[] = {
    {Real(0.11991829023606818), Real(0.23821296375836262)},
    {Real(0.35021925974299639), Real(0.21948034189864915)},
    {Real(0.55387914871847443), Real(0.18583903621000933)},
    {Real(0.71907338364732309), Real(0.14375131849091247)},
    {Real(0.84099020745769304), Real(0.10045115552372588)},
    {Real(0.92165925291091377), Real(0.062123291332679728)},
    {Real(0.96823728234431905), Real(0.032707033439244762)},
    {Real(0.99051209830604958), Real(0.013528861945508919)},
    {Real(0.99839905686709807), Real(0.0036073664814086602)},
    {Real(0.99994174997632679), Real(0.00029863091950081748)},
};

Real rho2(const RevolutionPart& p, Real z) { return std::max(Real(0), p.c0 + z * (p.c1 + z * p.c2)); }

// Of the whole discs between two heights: pi rho^2, and z times that, which a rule of three places integrates exactly.
Immersed discs(const RevolutionPart& p, Real from, Real to)
{
    constexpr Real kPlace = Real(0.77459666924148337704);  // sqrt(3 / 5)
    const Real middle = (from + to) / 2, half = (to - from) / 2;
    Immersed out;
    for (const Real x : {-kPlace, Real(0), kPlace}) {
        const Real z = middle + x * half;
        const Real part = kPi * half * (x == 0 ? Real(8) : Real(5)) / 9 * rho2(p, z);
        out.volume += part, out.moment.z += part * z;
    }
    return out;
}

// A plane a x + c z <= d, a > 0, of the half plane through the axis and the normal.
struct Slant {
    Real a, c, d;
    Real cut(Real z) const { return (d - c * z) / a; }
};

void add_slice(const RevolutionPart& p, const Slant& n, Real z, Real weight, Immersed& out)
{
    const Real r2 = rho2(p, z), r = std::sqrt(r2), s = std::clamp(n.cut(z), -r, r);
    const Real w2 = std::max(Real(0), r2 - s * s), w = std::sqrt(w2);
    const Real area = s * w + r2 * (kPi / 2 + atan2(s, w));
    out.volume += weight * area;
    out.moment.x -= weight * Real(2) / 3 * w * w2;
    out.moment.z += weight * area * z;
}

// Between two heights where the plane meets all discs, or no rim of any.
Immersed slices(const RevolutionPart& p, const Slant& n, Real from, Real to)
{
    const Real middle = (from + to) / 2, half = (to - from) / 2, s = n.cut(middle);
    if (!(half > 0)) return {};
    if (s * s >= rho2(p, middle)) return s > 0 ? discs(p, from, to) : Immersed{};
    Immersed out;
    for (const auto& rule : kRule) {
        add_slice(p, n, middle - rule.place * half, rule.weight * half, out);
        add_slice(p, n, middle + rule.place * half, rule.weight * half, out);
    }
    return out;
}

// Where (d - c z)^2 = a^2 rho^2(z), in order; as many as there are.
int rim_heights(const RevolutionPart& p, const Slant& n, Real (&out)[2])
{
    const Real a2 = n.a * n.a;
    const Real A = n.c * n.c - a2 * p.c2, B = -2 * n.c * n.d - a2 * p.c1, C = n.d * n.d - a2 * p.c0;
    const Real D = B * B - 4 * A * C;
    if (!(D >= 0)) return 0;
    const Real q = Real(-0.5) * (B + std::copysign(std::sqrt(D), B));
    int count = 0;
    if (A != 0) out[count++] = q / A;
    if (q != 0) out[count++] = C / q;
    if (count == 2 && out[0] > out[1]) std::swap(out[0], out[1]);
    return count;
}

Immersed cut_part(const RevolutionPart& p, const Slant& n)
{
    Real rims[2];
    const int count = rim_heights(p, n, rims);
    Immersed out;
    Real from = p.from;
    for (int i = 0; i < count; ++i) {
        if (!(rims[i] > from && rims[i] < p.to)) continue;
        out.add(slices(p, n, from, rims[i]));
        from = rims[i];
    }
    out.add(slices(p, n, from, p.to));
    return out;
}

// Of a plane across the axis.
Immersed level_part(const RevolutionPart& p, Real up, Real d)
{
    const Real from = up > 0 ? p.from : std::max(p.from, -d), to = up > 0 ? std::min(p.to, d) : p.to;
    return to > from ? discs(p, from, to) : Immersed{};
}

}  // namespace

RevolvedSolid RevolvedSolid::ellipsoid(Vec3 radii)
{
    RevolvedSolid out;
    out.is_ellipsoid_ = true, out.radii_ = radii;
    return out;
}

void RevolvedSolid::add(const RevolutionPart& part)
{
    if (part.to > part.from && count_ < 3) parts_[count_++] = part;
}

void RevolvedSolid::add_cylinder(Real from, Real to, Real radius) { add({from, to, radius * radius, 0, 0}); }

void RevolvedSolid::add_frustum(Real from, Real to, Real radius_from, Real radius_to)
{
    if (!(to > from)) return;
    const Real k = (radius_to - radius_from) / (to - from), at0 = radius_from - k * from;
    add({from, to, at0 * at0, 2 * k * at0, k * k});
}

void RevolvedSolid::add_ball(Real from, Real to, Real centre, Real radius)
{
    add({from, to, radius * radius - centre * centre, 2 * centre, -1});
}

Immersed RevolvedSolid::whole() const
{
    if (is_ellipsoid_) return {Real(4) / 3 * kPi * radii_.x * radii_.y * radii_.z, {}};
    Immersed out;
    for (int i = 0; i < count_; ++i) out.add(discs(parts_[i], parts_[i].from, parts_[i].to));
    return out;
}

Immersed RevolvedSolid::under(const WaterPlane& half) const
{
    if (is_ellipsoid_) {
        const Vec3 m = scale(radii_, half.normal);
        const Real reach = length(m);
        const Real t = reach > 0          ? std::clamp(half.offset / reach, Real(-1), Real(1))
                       : half.offset >= 0 ? Real(1)
                                          : Real(-1);
        const Real k = radii_.x * radii_.y * radii_.z * kPi, u = 1 - t * t;
        const Vec3 n = reach > 0 ? m / reach : Vec3{};
        return {k * (1 + t) * (1 + t) * (2 - t) / 3, (-k / 4 * u * u) * scale(radii_, n)};
    }
    const Vec3 n = half.normal;
    const Real a = std::sqrt(n.x * n.x + n.y * n.y);
    Immersed out;
    if (!(a > 4 * kEpsilon)) {
        for (int i = 0; i < count_; ++i) out.add(level_part(parts_[i], n.z, half.offset));
        return out;
    }
    for (int i = 0; i < count_; ++i) out.add(cut_part(parts_[i], {a, n.z, half.offset}));
    out.moment = {out.moment.x * n.x / a, out.moment.x * n.y / a, out.moment.z};
    return out;
}

// The largest rho.
Real RevolvedSolid::widest() const
{
    Real r2 = 0;
    for (int i = 0; i < count_; ++i) {
        const RevolutionPart& p = parts_[i];
        r2 = std::max({r2, rho2(p, p.from), rho2(p, p.to)});
        if (p.c2 < 0) r2 = std::max(r2, rho2(p, std::clamp(-p.c1 / (2 * p.c2), p.from, p.to)));
    }
    return std::sqrt(r2);
}

Vec3 RevolvedSolid::half_extent() const
{
    if (is_ellipsoid_) return radii_;
    const Real r = widest();
    return {r, r, count_ > 0 ? (parts_[count_ - 1].to - parts_[0].from) / 2 : Real(0)};
}

Vec3 RevolvedSolid::middle() const
{
    if (is_ellipsoid_ || count_ == 0) return {};
    return {0, 0, (parts_[count_ - 1].to + parts_[0].from) / 2};
}

// Flat ends, half of their sum, show as |u_z|; the rest like an ellipsoid between what is seen along the axis and across it.
Real RevolvedSolid::shadow(Vec3 u) const
{
    if (is_ellipsoid_) {
        const Vec3 r = radii_;
        return kPi * length({r.y * r.z * u.x, r.z * r.x * u.y, r.x * r.y * u.z});
    }
    if (count_ == 0) return 0;
    const Real r = widest(), ends = kPi * r * r;
    const RevolutionPart &low = parts_[0], &high = parts_[count_ - 1];
    const Real flat = kPi / 2 * (rho2(low, low.from) + rho2(high, high.to));
    Real side = 0;
    for (int i = 0; i < count_; ++i) {
        const Real middle = (parts_[i].from + parts_[i].to) / 2, half = (parts_[i].to - parts_[i].from) / 2;
        for (const auto& rule : kRule)
            for (const Real sign : {Real(-1), Real(1)})
                side +=
                    2 * rule.weight * half * std::sqrt(rho2(parts_[i], middle + sign * rule.place * half));
    }
    const Real c = std::fabs(u.z), s = std::sqrt(std::max(Real(0), 1 - u.z * u.z)), round = (ends - flat) * c;
    return flat * c + std::sqrt(round * round + side * s * side * s);
}

}  // namespace epode
