// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What the fluids of a world exert on a body. Of each geom with submerged volume V and centre c, n the surface's normal, u = v + w x r - current
// the velocity at c = x + r, R the geom's frame, A its shadow along u, s its submerged share, d its extents:
//
//   buoyancy   rho V (-g . n) n at c: the gradient of a potential while the surface is at rest, whatever its slope
//   drag       -k J^T u,  J = (1, -[r]),  k = (rho/2 drag |u| + linear_drag) s A
//   turning    -R diag(k_i) R^T w,  k_i = angular_drag s d_i (rho/64 (d_j^4 + d_k^4) |w_i| + linear_drag/12 (d_j^3 + d_k^3)):
//              pressure on the faces of a box that turns about its axis i
//
// All k are those of the beginning of the step, the velocities those of its end, so drag is a matrix C >= 0 and
//
//   (M + h C + h^2 beta K) v+ = M v + h (p + B) + h C u_fluid
//
// with p the weight and the program's force. Drag never reverses a velocity and never gives energy, however large; a falling body
// ends at exactly the velocity where C v = p + B. The fluid's force is M (v+ - v) / h - p.
// K >= 0 is a bound of the stiffness of the waterplane. Semi-implicit Euler, which a step is for forces, is stable while w h < 2 for the
// frequencies w^2 of M^-1 K; from (w h)^2 = 2 on beta = 1 - 2 / (w h)^2 makes it implicit, which damps what the step cannot follow. It is 0
// for all but small or thin bodies.
// What something holds (joints, contacts) does not move as p says: there the buoyancy is exact and drag acts on v alone.
// Added mass is not modelled: to be stable it must be part of M, and contacts and joints would have to know.
#pragma once

#include "dynamics/world.h"

namespace epode {

// By all fluids, in a step of length h of the body as it is. Calls functions of the program if a fluid has any.
BodyInFluid fluid_forces(const World& world, const Body& body, Real h);

}  // namespace epode
