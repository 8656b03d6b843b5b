// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "step/island/problem/slip_friction.h"

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

SlipFriction::SlipFriction(const StepInfo& info, const Island& island, const ContactManifold& manifold)
    : manifold_(manifold),
      body1_(body_of(island, manifold.body1)),
      body2_(body_of(island, manifold.body2)),
      n_(widen(manifold.normal)),
      mu_(manifold.mu)
{
    plane_space(n_, shared_.t[0], shared_.t[1]);
    shared_.mu2 = mu_;
    if (!info.friction_along_slip || !(manifold.mu > 0)) return;
    pushed_ = push_of(body1_, info.h) - push_of(body2_, info.h);
    inv_mass_ = (body1_ ? body1_->inv_mass : 0) + (body2_ ? body2_->inv_mass : 0);
    find_shared();
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
    Friction out{{}, mu_};
    plane_space(n_, out.t[0], out.t[1]);
    const Vec3 u = slip_at(r1, r2), free = u + pushed_;
    Vec3 direction = tangential(free);
    constexpr Real kStraight = Real(1e-6);  // of the velocity: less is rounding
    if (!(length2(direction) > kStraight * kStraight * length2(free)) || !normalize(direction)) return out;
    out.t[0] = direction, out.t[1] = cross(n_, direction);
    if (manifold_.rolling_friction > 0) return out;
    constexpr Real kReach = 8;
    const Real dv = kReach * mu_ * p * inv_mass_, speed = length(tangential(u));
    if (dv > 0 && dv < speed) out.mu2 *= dv / speed;
    return out;
}

}  // namespace epode
