// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "assemblies/rope_shape.h"

#include "base/config.h"
#include "math/trig.h"

namespace epode {
namespace {

// The turn of n links whose chord is `share` of their length.
Real turn_of_arc(int n, Real share)
{
    Real low = 0, high = 2 * kPi / Real(n);
    for (int i = 0; i < 60; ++i) {
        const Real t = (low + high) / 2;
        (sin(Real(n) * t / 2) > share * Real(n) * sin(t / 2) ? low : high) = t;
    }
    return (low + high) / 2;
}

}  // namespace

RopeShape::RopeShape(Vec3 from, Vec3 to, int links, Real length, Vec3 down)
    : links_(links), link_(length / Real(links))
{
    const Vec3 way = to - from;
    const Real distance = epode::length(way);
    Vec3 p, q;
    plane_space(down, p, q);
    along_ = normalized_or(way, p);
    across_ = cross(along_, down);
    if (epode::length(across_) < Real(1e-6)) across_ = p;
    across_ = normalized_or(across_, p);
    up_ = cross(along_, across_);
    if (dot(up_, down) > 0) up_ = -up_;
    if (distance < length) turn_ = turn_of_arc(links, distance / length);
}

Vec3 RopeShape::direction(int i) const
{
    const Real angle = (Real(i) - Real(links_ - 1) / 2) * turn_;
    return cos(angle) * along_ + sin(angle) * up_;
}

}  // namespace epode
