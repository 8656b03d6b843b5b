// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See gear_mesh.h. Elementary geometry; points are taken relative to the first centre, so that wheels far
// from the world's origin lose no digits.
#include "joints/types/gear_mesh.h"

#include <algorithm>

namespace epode {
namespace {

// Shorter lengths and sines have no direction.
constexpr Real kNothing = sizeof(Real) == 8 ? Real(1e-12) : Real(1e-6);

Vec3 mean_axis(const Wheel (&wheel)[2])
{
    return normalized_or(wheel[0].axis + wheel[1].axis, wheel[0].axis);
}

Vec3 across(Vec3 n, Vec3 v) { return v - dot(n, v) * n; }

}  // namespace

bool mesh_parallel(const Wheel (&wheel)[2], Real ratio, GearMesh& mesh)
{
    const Vec3 n = mean_axis(wheel), gap = wheel[1].centre - wheel[0].centre, d = across(n, gap);
    if (!(length(d) > kNothing)) return false;
    mesh.line = normalized_or(cross(d, n), {});
    mesh.contact[0] = mesh.contact[1] = wheel[0].centre + (ratio / (1 + ratio)) * gap;
    return true;
}

bool mesh_intersecting(const Wheel (&wheel)[2], GearMesh& mesh)
{
    const Vec3 n1 = wheel[0].axis, n2 = wheel[1].axis, l = cross(n1, n2);
    if (!(length(l) > kNothing)) return false;
    // The point o of the line with l.o = 0:  n1.o = 0,  n2.o = n2.(a2 - a1).
    const Vec3 gap = wheel[1].centre - wheel[0].centre;
    const Vec3 o = (dot(n2, gap) / length2(l)) * cross(l, n1);
    mesh.line = normalized_or(l, {});
    mesh.contact[0] = wheel[0].centre + o;
    mesh.contact[1] = mesh.contact[0] + dot(mesh.line, gap) * mesh.line;
    return true;
}

bool mesh_chain(const Wheel (&wheel)[2], const Real (&radius)[2], bool mirrored, GearMesh& mesh)
{
    const Vec3 n = mean_axis(wheel), gap = wheel[1].centre - wheel[0].centre;
    const Real height = dot(n, gap);
    Vec3 d = gap - height * n;
    const Real distance = length(d);
    if (!(distance > kNothing) || !(radius[0] + radius[1] > 0)) return false;
    d = d / distance;
    const Real c = std::clamp((radius[0] - radius[1]) / distance, Real(-1), Real(1));
    const Real s = std::sqrt(1 - c * c);
    const Vec3 u = c * d + (mirrored ? -s : s) * cross(n, d);
    mesh.line = normalized_or(cross(u, n), {});
    mesh.contact[0] = wheel[0].centre + radius[0] * u + (height / 2) * n;
    mesh.contact[1] = wheel[1].centre + radius[1] * u - (height / 2) * n;
    return true;
}

}  // namespace epode
