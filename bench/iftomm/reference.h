// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The motions of the benchmark problems A01 to A05 in minimal coordinates (A03: in all coordinates of the
// plane, projected in every step), integrated by the classical Runge-Kutta method with steps so small that
// halving them changes nothing above 1e-8. Independent of the engine.
#pragma once

#include <vector>

namespace epode::iftomm {

// Samples at equal distances, the first at t = 0; one sample is the outputs of the problem in a row.
using Motion = std::vector<std::vector<double>>;

constexpr double kGravity = 9.81;

Motion pendulum_reference(double inertia, double duration, int samples);  // x, y of the mass
Motion four_bars_reference(int windows, double duration, int samples);    // x, y and their rates of B0
Motion squeezer_reference(double duration, int samples, double substep);  // x, y of F
Motion bricard_reference(double duration, int samples);                   // x, y, z of P3
Motion governor_reference(double duration, int samples, double substep);  // s

// The seven angles of Andrews' mechanism at `time`, in the order of the test set of DAE solvers: to compare
// with its published figures.
std::vector<double> squeezer_angles(double time, double substep);

}  // namespace epode::iftomm
