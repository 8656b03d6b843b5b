// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The force of a tyre. It stands on bristles, whose deflection u (m, forward and left) follows the velocity V
// with which the tread slips over the ground, and which rolling with the speed D lets go over the relaxation
// length L:
//   u' = V - (D / L) u,    D = max(|v_x|, |w R|)          V = (w R - v_x, -v_y)
//   s  = (u + tau u') / L                                 slip: in steady motion V / D
// so that a wheel that rolls has the slips of the books, kappa = s_x and tan alpha = -s_y, and one that stands
// is a spring, which holds a car on a slope without creeping. tau is the damping of the tread.
//   z_x = c_x s_x / (3 mu_x),   z_y = c_y s_y / (3 mu_y),   z = |(z_x, z_y)|
//   F_x = mu_x N y(z) z_x / z,  F_y = mu_y N y(z) z_y / z
//   y(z) = 3 z - 3 z^2 + z^3                              z <= 1
//   y(z) = k + (1 - k) / (1 + ((z - 1) / b)^2)            z > 1
//   mu   = mu_0 (1 - e (N / N_0 - 1)),   at least mu_0 / 10
// y is the brush model with a parabolic pressure (Fiala 1954; Rajamani, Vehicle Dynamics and Control, ch. 13)
// up to z = 1, where the whole contact slides; beyond, friction falls to the share k, with the slope 0 at z =
// 1, as measured curves do (Pacejka, Tire and Vehicle Dynamics, ch. 4). c: stiffness over load; near zero
// F_x = c_x N s_x. One z for both directions is the friction ellipse.
// A tread that has slid to a standstill gives back less than it took: where V turns against u with z > 1, u falls to
// where a brush unloads to by Masing's rule, y(z / 2) = 1/2. A car that has braked with locked wheels rocks back; with
// all of u it was thrown back. Where the wheel rolls, rolling lets u go.
// A step is implicit in V, which the force changes: s = s_0 + b V at its end, and F = N g(z) c s with the
// secant g(z) = y(z) / (3 z), which the solver takes from the last iteration.
#pragma once

#include "dynamics/forces/vehicle.h"

namespace epode {

inline constexpr Real kTreadDamping = Real(0.02);  // tau, s, of a tyre that does not roll
inline constexpr Real kFallWidth = Real(0.7);      // b
inline constexpr Real kMostStored = 3;             // z of the deflection that is kept
inline constexpr Real kStandstill = Real(0.5);     // D, m/s
inline constexpr Real kGivenBack =
    Real(0.41259894803180064);  // 2 - 2^(2/3): z of what a tread that slides gives back

// y(z) / (3 z): 1 at z = 0. And its derivative.
Real tyre_secant(Real z, Real sliding);
Real tyre_secant_slope(Real z, Real sliding);

struct Tyre {
    const dVehicleWheel& of;
    Real rolling;  // D

    // s at the end of a step of size h, for the velocity V of the slip then: start + gain V.
    Real gain(Real h) const;
    Real start(Real bristle, Real h) const;
    Real scale_x() const { return of.stiffness_x / (3 * of.friction_x); }
    Real scale_y() const { return of.stiffness_y / (3 * of.friction_y); }

    // u after h with the velocity V, and no more than kMostStored, or kGivenBack.
    void roll(Real& bristle_x, Real& bristle_y, Real slip_x, Real slip_y, Real h) const;

  private:
    Real strain(Real bristle_x, Real bristle_y) const;  // z of a deflection
    Real damping() const { return kTreadDamping / (1 + kTreadDamping * rolling / of.relaxation); }
};

// mu / mu_0 under a load. And its derivative.
Real load_factor(const dVehicleWheel& of, Real load);
Real load_factor_slope(const dVehicleWheel& of, Real load);  // 1/N

}  // namespace epode
