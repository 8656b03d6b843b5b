// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See rim_distance.h. In doubles, as GJK's simplex.
#include "geometry/overlap/rim_distance.h"

#include <algorithm>
#include <bit>

#include "simd/pack_algebra.h"

namespace epode {

namespace {

using Exact = Vec3Of<double>;

constexpr int kSteps = 6;
constexpr double kLastStep2 = 1e-10;  // squared: the next one is about its square
constexpr double kAtEnd = 0.01;       // squared sine from a cylinder's axis, below which its end is tried
constexpr double kRounding = 16 * 2.3e-16;

Exact exact_of(Vec3 v) { return {v.x, v.y, v.z}; }
Vec3 rounded_of(const Exact& v) { return {Real(v.x), Real(v.y), Real(v.z)}; }
double square(const Exact& v) { return dot(v, v); }

struct RimSolid {
    Exact centre, axis[3] = {};
    double half[3] = {}, rim = 0;
    int axes = 0;
    unsigned loose = 0;  // the axes along which the feature extends, a bit for each
    bool at_end = false;

    explicit RimSolid(const ConvexView& v) : centre(exact_of(v.pose.p))
    {
        if (v.kind == SolidKind::kBox)
            for (int i = 0; i < 3; ++i) add(v, i, static_cast<const Box*>(v.shape)->half[i]);
        if (v.kind == SolidKind::kSegment) add(v, 2, static_cast<const Capsule*>(v.shape)->half_length);
        if (v.kind != SolidKind::kCylinder) return;
        const Cylinder& cylinder = *static_cast<const Cylinder*>(v.shape);
        add(v, 2, cylinder.half_length);
        rim = cylinder.radius;
    }
    void add(const ConvexView& v, int column, Real length)
    {
        axis[axes] = exact_of(v.pose.R.column(column)), half[axes++] = length;
    }

    double reach(const Exact& n) const
    {
        double h = 0;
        for (int i = 0; i < axes; ++i) h += half[i] * std::fabs(dot(n, axis[i]));
        return rim > 0 ? h + rim * std::sqrt(square(across(n))) : h;
    }
    Exact across(const Exact& n) const { return n - dot(n, axis[0]) * axis[0]; }

    // The middle of what looks along n, from the centre.
    Exact middle(const Exact& n) const
    {
        Exact m{};
        for (int i = 0; i < axes; ++i)
            if (!(loose >> i & 1)) m = m + std::copysign(half[i], dot(n, axis[i])) * axis[i];
        if (!(rim > 0) || at_end) return m;
        const Exact q = across(n);
        const double rho2 = square(q);
        return rho2 > 0 ? m + (rim / std::sqrt(rho2)) * q : m;
    }

    // How curved it is along a tangent.
    Exact turn(const Exact& n, double& curvature) const
    {
        curvature = 0;
        if (!(rim > 0) || at_end) return {};
        const Exact q = across(n);
        const double rho2 = square(q);
        if (!(rho2 > 1e-12)) return {};
        curvature = rim / (rho2 * std::sqrt(rho2));
        return cross(axis[0], q);
    }

    // Points on both sides of the middle.
    void loosen(int i, double from, double to)
    {
        if (to - from > half[i] || std::fabs(from + to) < 0.5 * half[i]) loose |= 1u << i;
    }
    int freedom() const { return at_end ? 2 : int((loose & 1) + (loose >> 1 & 1) + (loose >> 2)); }
    Exact loose_axis() const { return axis[std::countr_zero(loose)]; }
    double loose_half() const { return half[std::countr_zero(loose)]; }

    // Whether the feature reaches so far aside from its middle.
    bool holds(const Exact& aside) const
    {
        if (at_end) return square(aside) <= rim * rim;
        for (int i = 0; i < axes; ++i)
            if ((loose >> i & 1) && std::fabs(dot(aside, axis[i])) > half[i]) return false;
        return true;
    }
};

class RimSearch {
  public:
    RimSearch(const ConvexView& a, const ConvexView& b, std::span<const NearPoints> near) : a_(a), b_(b)
    {
        for (int i = 0; i < a_.axes; ++i) loosen(a_, i, near, &NearPoints::on_a);
        for (int i = 0; i < b_.axes; ++i) loosen(b_, i, near, &NearPoints::on_b);
    }

    // With the end of a cylinder that looks nearly along n, or without.
    bool try_ends(const Exact& n)
    {
        for (RimSolid* s : {&a_, &b_}) {
            if (!(s->rim > 0) || s->loose || square(s->across(n)) > kAtEnd) continue;
            s->at_end = true;
            const double side = dot(n, s->axis[0]) < 0 ? -1 : 1;
            if (search(side * s->axis[0])) return true;
            s->at_end = false;
        }
        return false;
    }
    bool search(const Exact& start)
    {
        n_ = start;
        return a_.freedom() + b_.freedom() <= 2 && hold() && turn() && slide();
    }

    bool is_least(Real tolerance, Distance& out) const
    {
        const double d = std::sqrt(square(v_));
        if (!(d > 0)) return false;
        const Exact n = (1 / d) * v_, apart = a_.centre - b_.centre;
        const double bound = dot(n, apart) - a_.reach(n) - b_.reach(n);
        const double size = std::sqrt(square(apart)) + d;
        if (!(d - bound <= double(tolerance) * d + kRounding * size)) return false;
        out.distance = Real(d), out.normal = rounded_of(n);
        out.on_a = rounded_of(x_), out.on_b = rounded_of(y_);
        return true;
    }

  private:
    static void loosen(RimSolid& s, int i, std::span<const NearPoints> near, Vec3 NearPoints::*on)
    {
        double from = 1e300, to = -1e300;
        for (const NearPoints& p : near) {
            const double z = dot(s.axis[i], exact_of(p.*on) - s.centre);
            from = std::min(from, z), to = std::max(to, z);
        }
        s.loosen(i, from, to);
    }

    // Makes n upright to the feature of each.
    bool hold()
    {
        if (a_.at_end || b_.at_end) return true;
        Exact held[2];
        int count = 0;
        for (const RimSolid* s : {&a_, &b_})
            for (int i = 0; i < s->axes; ++i)
                if (s->loose >> i & 1) held[count++] = s->axis[i];
        Exact n = n_;
        if (count == 1) n = n - dot(n, held[0]) * held[0], along_ = held[0];
        if (count == 2) n = cross(held[0], held[1]);
        if (!(square(n) > 1e-8)) return false;
        n_ = (std::copysign(1.0, dot(n, n_)) / std::sqrt(square(n))) * n;
        return true;
    }

    // Newton's method in the directions that are free.
    bool turn()
    {
        const int free = 2 - a_.freedom() - b_.freedom();
        for (int i = 0;; ++i) {
            x_ = a_.centre - a_.middle(n_), y_ = b_.centre + b_.middle(n_), v_ = x_ - y_;
            const double apart = dot(v_, n_);
            if (!(apart > 0)) return false;
            if (free == 0 || i == kSteps) return true;
            const Exact step = free == 1 ? step_across(apart) : step_around(apart);
            const Exact next = n_ + step;
            n_ = (1 / std::sqrt(square(next))) * next;
            if (square(step) < kLastStep2) i = kSteps - 1;
        }
    }
    Exact step_across(double apart) const
    {
        const Exact u = cross(along_, n_);
        double of_a, of_b;
        const double s = dot(a_.turn(n_, of_a), u), t = dot(b_.turn(n_, of_b), u);
        return (dot(v_, u) / (apart + of_a * s * s + of_b * t * t)) * u;
    }
    Exact step_around(double apart) const
    {
        const Exact e = std::fabs(n_.x) < 0.6 ? Exact{1, 0, 0} : Exact{0, 1, 0};
        const Exact across = cross(n_, e), u = (1 / std::sqrt(square(across))) * across, w = cross(n_, u);
        double of_a, of_b;
        const Exact s = a_.turn(n_, of_a), t = b_.turn(n_, of_b);
        const double su = dot(s, u), sw = dot(s, w), tu = dot(t, u), tw = dot(t, w);
        const double uu = apart + of_a * su * su + of_b * tu * tu,
                     ww = apart + of_a * sw * sw + of_b * tw * tw;
        const double uw = of_a * su * sw + of_b * tu * tw, vu = dot(v_, u), vw = dot(v_, w);
        const double per = 1 / (uu * ww - uw * uw);
        return (per * (ww * vu - uw * vw)) * u + (per * (uu * vw - uw * vu)) * w;
    }

    // Moves the nearest points along their features. False when one would leave its own.
    bool slide()
    {
        if (a_.freedom() == 1 && b_.freedom() == 1) return slide_both();
        const Exact aside = v_ - dot(v_, n_) * n_;
        const Exact by = a_.freedom() + b_.freedom() == 1 ? dot(v_, along_) * along_ : aside;
        if (a_.freedom() > 0) {
            if (!a_.holds(by)) return false;
            x_ = x_ - by;
        } else if (b_.freedom() > 0) {
            if (!b_.holds(by)) return false;
            y_ = y_ + by;
        }
        v_ = x_ - y_;
        return true;
    }
    bool slide_both()
    {
        const Exact c = a_.loose_axis(), d = b_.loose_axis();
        const double k = dot(c, d), on_c = dot(v_, c), on_d = dot(v_, d), skew = 1 - k * k;
        if (!(skew > 1e-6)) return false;
        const double s = (k * on_d - on_c) / skew, t = on_d + k * s;
        if (std::fabs(s) > a_.loose_half() || std::fabs(t) > b_.loose_half()) return false;
        x_ = x_ + s * c, y_ = y_ + t * d, v_ = x_ - y_;
        return true;
    }

    RimSolid a_, b_;
    Exact n_, along_{};  // and the direction of the one feature that extends
    Exact x_, y_, v_;    // nearest points, x - y
};

bool is_plain(const ConvexView& v)
{
    return v.kind == SolidKind::kPoint || v.kind == SolidKind::kSegment || v.kind == SolidKind::kBox ||
           v.kind == SolidKind::kCylinder;
}

}  // namespace

bool has_rim_distance(const ConvexView& a, const ConvexView& b)
{
    const bool rim = a.kind == SolidKind::kCylinder || b.kind == SolidKind::kCylinder;
    return rim && is_plain(a) && is_plain(b);
}

bool rim_distance(const ConvexView& a, const ConvexView& b, Vec3 n, std::span<const NearPoints> near,
                  Real tolerance, Distance& out)
{
    RimSearch search(a, b, near);
    const Exact start = exact_of(n);
    if (search.try_ends(start) && search.is_least(tolerance, out)) return true;
    RimSearch smooth(a, b, near);
    return smooth.search(start) && smooth.is_least(tolerance, out);
}

}  // namespace epode
