// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "vehicles/steering.h"

#include <algorithm>

#include "math/trig.h"

namespace epode {
namespace {

struct SteerAxes {
    Vec3 forward, left;
};

SteerAxes axes_of(const dVehicleSettings& s)
{
    const Vec3 up = normalized_or(load(s.up), {0, 0, 1});
    const Vec3 left = normalized_or(cross(up, load(s.forward)), {0, 1, 0});
    return {cross(left, up), left};
}

struct ShareLine {
    Real slope = 0, root = 0;
};

ShareLine line_through_shares(const Vehicle& vehicle, Vec3 forward)
{
    Real n = 0, sx = 0, sf = 0, sxx = 0, sxf = 0;
    for (const VehicleWheel& wheel : vehicle.all_wheels()) {
        const Real x = dot(load(wheel.settings.position), forward), f = wheel.settings.steer;
        n += 1, sx += x, sf += f, sxx += x * x, sxf += x * f;
    }
    const Real spread = n * sxx - sx * sx, slope = spread > 0 ? (n * sxf - sx * sf) / spread : Real(0);
    if (!(std::fabs(slope) > Real(1e-6))) return {};
    return {slope, (sx - sf / slope) / n};
}

Real tangent(Real angle) { return sin(angle) / cos(angle); }

}  // namespace

void steer(Vehicle& vehicle, Real h)
{
    const dVehicleSettings& s = vehicle.settings;
    const Real wanted = vehicle.controls.steer * s.max_steer, change = s.steer_speed * h;
    vehicle.steer += std::clamp(wanted - vehicle.steer, -change, change);
    vehicle.curvature = 0;
    if (s.kind == dVehicleTracked) return;
    const SteerAxes axes = axes_of(s);
    const ShareLine line = line_through_shares(vehicle, axes.forward);
    vehicle.curvature = line.slope * tangent(vehicle.steer);
    for (VehicleWheel& wheel : vehicle.all_wheels()) {
        const dVehicleWheel& w = wheel.settings;
        const Vec3 at = load(w.position);
        const Real ahead = vehicle.curvature * (dot(at, axes.forward) - line.root);
        const Real across = 1 - s.ackermann * vehicle.curvature * dot(at, axes.left);
        if (w.steer == 0)
            wheel.steer = 0;
        else if (line.slope == 0)
            wheel.steer = w.steer * vehicle.steer;
        else
            wheel.steer = across > 0 ? atan2(ahead, across) : atan2(ahead, 1);
    }
}

}  // namespace epode
