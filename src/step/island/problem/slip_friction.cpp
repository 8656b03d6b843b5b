// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "step/island/problem/slip_friction.h"

#include <algorithm>
#include <cmath>

namespace epode {
namespace {

const Body* body_of(const Island& island, int index)
{
    return index < 0 ? nullptr : island.bodies[std::size_t(index)];
}

Vec3 velocity_of(const Body* body, Vec3 r)
{
    return body ? body->velocity() + cross(body->angular_velocity(), r) : Vec3{};
}

Vec3 push_of(const Body* body, Real h) { return body ? (h * body->inv_mass) * load(body->facc) : Vec3{}; }

}  // namespace

SlipFriction::SlipFriction(const StepInfo& info, const Island& island, const ContactManifold& manifold,
                           bool cone)
    : manifold_(manifold),
      body1_(body_of(island, manifold.body1)),
      body2_(body_of(island, manifold.body2)),
      n_(widen(manifold.normal)),
      axes_(manifold),
      mu_(axes_.mu),
      cone_(cone),
      shared_(fixed())
{
    if (!info.friction_along_slip || !(mu_ > 0)) return;
    pushed_ = push_of(body1_, info.h) - push_of(body2_, info.h);
    inv_mass_ = (body1_ ? body1_->inv_mass : 0) + (body2_ ? body2_->inv_mass : 0);
    find_shared();
}

// A cone of scaled tangents with one coefficient is the ellipse, and its friction that of most power.
Friction SlipFriction::fixed() const
{
    if (cone_ && manifold_.has_friction_axis() && !is_line())
        return {{axes_.scaled(0), axes_.scaled(1)}, {mu_, mu_}};
    return {{axes_.t[0], axes_.t[1]}, {axes_.s[0] * mu_, axes_.s[1] * mu_}};
}

// Where a coefficient is next to nothing the ellipse is a line, which its own directions serve best.
bool SlipFriction::is_line() const
{
    constexpr Real kLine = Real(1e-3);
    return std::min(axes_.s[0], axes_.s[1]) < kLine;
}

void SlipFriction::find_shared()
{
    Vec3 r1, r2;
    Real p = 0;
    for (int i = 0; i < manifold_.count; ++i) {
        const ManifoldPoint& point = manifold_.points[i];
        r1 += widen(point.r1), r2 += widen(point.r2), p += Real(point.normal_impulse);
    }
    const Real share = Real(1) / Real(manifold_.count);
    r1 = share * r1, r2 = share * r2;
    const Vec3 spin =
        (body1_ ? body1_->angular_velocity() : Vec3{}) - (body2_ ? body2_->angular_velocity() : Vec3{});
    const Real reach = length(widen(manifold_.points[0].r1) - r1);
    const Real turning = std::fabs(dot(spin, n_)) * reach;
    const Real slip = length(tangential(pushed_ + slip_at(r1, r2)));
    constexpr Real kFirm = Real(0.3), kAlike = Real(0.2);
    if (slip + turning <= kFirm * mu_ * p * inv_mass_) return;
    const bool alike = turning <= kAlike * slip;
    shares_ = alike;
    if (alike) shared_ = along(r1, r2, share * p);
}

Vec3 SlipFriction::slip_at(Vec3 r1, Vec3 r2) const
{
    return velocity_of(body1_, r1) - velocity_of(body2_, r2) - widen(manifold_.surface_velocity);
}

Friction SlipFriction::along(Vec3 r1, Vec3 r2, Real p) const
{
    constexpr Real kReach = 8;
    const Vec3 u = slip_at(r1, r2), free = u + pushed_;
    const Real dv = kReach * mu_ * p * inv_mass_;
    if (manifold_.has_friction_axis()) return along_scaled(free, dv, length(tangential(u)));
    Friction out = fixed();
    Vec3 direction = tangential(free);
    constexpr Real kStraight = Real(1e-6);  // of the velocity: less is rounding
    if (!(length2(direction) > kStraight * kStraight * length2(free)) || !normalize(direction)) return out;
    out.t[0] = direction, out.t[1] = cross(n_, direction);
    if (manifold_.rolling_friction > 0) return out;
    const Real speed = length(tangential(u));
    if (dv > 0 && dv < speed) out.mu[1] *= dv / speed;
    return out;
}

// With e the direction of the scaled slip (s_1 u_1, s_2 u_2) and g along it, the friction is g (s_1 e_1 t_1 + s_2 e_2 t_2).
Friction SlipFriction::along_scaled(Vec3 free, Real dv, Real speed) const
{
    Friction out = fixed();
    if (is_line()) return out;
    const Vec3 a = axes_.scaled(0), b = axes_.scaled(1);
    Vec3 e{dot(a, free), dot(b, free), 0};
    if (!(dv > 0 && dv < speed) || !normalize(e)) return out;
    out.t[0] = e.x * a + e.y * b, out.t[1] = e.x * b - e.y * a;
    out.mu[0] = mu_, out.mu[1] = mu_ * dv / speed;
    return out;
}

}  // namespace epode
