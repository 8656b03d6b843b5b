// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "vehicles/tyre.h"

#include <algorithm>
#include <cmath>

namespace epode {
namespace {

constexpr Real kLeastFactor = Real(0.1);

}  // namespace

Real tyre_secant(Real z, Real sliding)
{
    if (z <= 1) return 1 - z + z * z / 3;
    const Real beyond = (z - 1) / kFallWidth;
    return (sliding + (1 - sliding) / (1 + beyond * beyond)) / (3 * z);
}

Real tyre_secant_slope(Real z, Real sliding)
{
    if (z <= 1) return -1 + z * 2 / 3;
    const Real beyond = (z - 1) / kFallWidth, falls = 1 / (1 + beyond * beyond);
    const Real slope = -2 * (1 - sliding) * beyond * falls * falls / kFallWidth;
    return (slope - (sliding + (1 - sliding) * falls) / z) / (3 * z);
}

Real load_factor(const dVehicleWheel& of, Real load)
{
    return std::max(1 - of.load_sensitivity * (load / of.nominal_load - 1), kLeastFactor);
}

Real load_factor_slope(const dVehicleWheel& of, Real load)
{
    return load_factor(of, load) > kLeastFactor ? -of.load_sensitivity / of.nominal_load : Real(0);
}

Real Tyre::gain(Real h) const
{
    const Real L = of.relaxation, tau = damping();
    return ((1 - tau * rolling / L) * h / (1 + h * rolling / L) + tau) / L;
}

Real Tyre::start(Real bristle, Real h) const
{
    const Real L = of.relaxation;
    return (1 - damping() * rolling / L) * bristle / ((1 + h * rolling / L) * L);
}

Real Tyre::strain(Real bristle_x, Real bristle_y) const
{
    const Real zx = scale_x() * bristle_x / of.relaxation, zy = scale_y() * bristle_y / of.relaxation;
    return std::sqrt(zx * zx + zy * zy);
}

void Tyre::roll(Real& bristle_x, Real& bristle_y, Real slip_x, Real slip_y, Real h) const
{
    const Real before = strain(bristle_x, bristle_y);
    if (before > 1 && rolling < kStandstill && slip_x * bristle_x + slip_y * bristle_y < 0)
        bristle_x *= kGivenBack / before, bristle_y *= kGivenBack / before;
    const Real k = 1 / (1 + h * rolling / of.relaxation);
    const Real x = k * (bristle_x + h * slip_x), y = k * (bristle_y + h * slip_y);
    const Real z = strain(x, y), kept = z > kMostStored ? kMostStored / z : Real(1);
    bristle_x = kept * x, bristle_y = kept * y;
}

}  // namespace epode
