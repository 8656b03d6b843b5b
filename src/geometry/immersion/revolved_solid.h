// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Round solids under a plane, each in its own frame: ellipsoids, and solids of revolution about z that consist of parts with
//
//   rho(z)^2 = c0 + c1 z + c2 z^2,   from <= z <= to:   cylinders, cones and their frusta, pieces of balls.
//
// Ellipsoid: x = S y maps the unit ball to it, and the half space n . x <= d to (S n) . y <= d, which cuts off a cap,
//   V = pi (1 + t)^2 (2 - t) / 3,   Q = -pi/4 (1 - t^2)^2 along the normal,   t the height of the plane.
// Revolution: with n = (a, 0, c) the slice at z is a disc of radius rho cut at x <= s = (d - c z) / a,
//   A = s w + rho^2 (pi/2 + atan2(s, w)),   integral of x = -2/3 w^3,   w^2 = rho^2 - s^2.
// Along z these are smooth but where the plane meets the rim of a slice, s^2 = rho^2, a quadratic equation; there they go like the
// power 3/2. Between such places z = m + k sin(phi) makes them analytic, and Gauss' rule in phi leaves less than 1e-8 of the
// solid. Closed forms (of cylinders, of caps by Gauss and Bonnet) were rejected: they divide differences by c^2 where the axis lies
// along the plane.
#pragma once

#include "geometry/immersion/immersed.h"

namespace epode {

struct RevolutionPart {
    Real from, to;
    Real c0, c1, c2;
};

class RevolvedSolid {
  public:
    static RevolvedSolid ellipsoid(Vec3 radii);
    // Parts along z, in order; those without length are left out.
    void add_cylinder(Real from, Real to, Real radius);
    void add_frustum(Real from, Real to, Real radius_from, Real radius_to);
    void add_ball(Real from, Real to, Real centre, Real radius);  // what it has between these heights

    Immersed whole() const;
    Immersed under(const WaterPlane& half) const;
    // Of its shadow along a unit vector; of solids of revolution whose ends are round within 10 %, else exact.
    Real shadow(Vec3 direction) const;
    Vec3 half_extent() const;
    Vec3 middle() const;  // of its box

  private:
    void add(const RevolutionPart& part);
    Real widest() const;

    bool is_ellipsoid_ = false;
    Vec3 radii_;
    int count_ = 0;
    RevolutionPart parts_[3];
};

}  // namespace epode
