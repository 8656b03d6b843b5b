// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Mass, centre of mass and inertia of solids of uniform density, and how they move, turn and add up.
// As in dMass, `inertia` is taken about the ORIGIN of the frame, not about the centre, in kg m^2:
//   I = integral of (|x|^2 1 - x x^T) dm.
// Negative masses are let through: subtracting a solid is how clients make hollow ones.
#pragma once

#include "math/mat.h"

namespace epode {

struct MassProperties {
    Real mass = 0;
    Vec3 center;
    Sym3 inertia;
};

Real sphere_volume(Real radius);
Real box_volume(Vec3 sides);
Real cylinder_volume(Real radius, Real length);
Real capsule_volume(Real radius, Real length);  // `length` without the caps

// Solids centred at the origin. `axis` is 0, 1, 2 for x, y, z.
MassProperties solid_sphere(Real mass, Real radius);
MassProperties solid_box(Real mass, Vec3 sides);
MassProperties solid_cylinder(Real mass, int axis, Real radius, Real length);
MassProperties solid_capsule(Real mass, int axis, Real radius, Real length);

// The same solid with its mass scaled, moved by `offset`, or turned by R about the origin.
MassProperties with_mass(const MassProperties& p, Real mass);
MassProperties translated(const MassProperties& p, Vec3 offset);
MassProperties rotated(const MassProperties& p, const Mat3& R);

// Both solids together; they must be given in one frame. Two zero masses make a zero mass at p's centre.
MassProperties united(const MassProperties& p, const MassProperties& q);

enum class MassFault { kNone, kMass, kInertia, kCenter };

// What keeps these numbers from belonging to a rigid body: a mass that is not positive, an inertia that is
// not positive definite about the origin, or not about the centre.
MassFault mass_fault(const MassProperties& p);

// Every number finite and of sane size (base/check.h).
bool usable(const MassProperties& p);

// Volume integrals of a closed triangle mesh, vertices counter-clockwise seen from outside.
class MeshMoments {
  public:
    void add_triangle(Vec3 a, Vec3 b, Vec3 c);
    Real volume() const { return volume_; }  // negative for a mesh turned inside out
    MassProperties properties(Real density) const;

  private:
    bool started_ = false;
    Vec3 reference_;   // the integrals are taken about the first vertex
    Real volume_ = 0;  // integral of 1
    Vec3 first_;       // integral of x
    Sym3 second_;      // integral of x x^T
};

}  // namespace epode
