// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// How the friction of a manifold is bounded in dWorldStep, by two limits instead of a cone: along the slip s and
// across it. Between two fixed directions it would be up to sqrt(2) times as large as along them. Along s what slides is
// braked by Coulomb's mu N, straight on, in every direction, and what is pushed gives way at mu N. Across s, Coulomb's
// friction is mu N times the sine of the angle by which s turns during the step: at most dv/|s|,
//   dv = a few times mu p (1/m1 + 1/m2),   p: normal impulse of the last step,
// being what friction can change in a step (a few times, because bodies also turn). What sticks has both limits.
//   Points share their directions as long as their slips are alike, and have fixed ones while what pushes is far
// from moving them: solvers start from the last step's impulses.
#pragma once

#include "dynamics/island.h"
#include "rows/contact_manifold.h"
#include "rows/row_writer.h"

namespace epode {

// The second direction may have a lower limit than mu.
struct Friction {
    Vec3 t[2];
    Real mu2;
};

class SlipFriction {
  public:
    // Of a manifold with points, between bodies that have their forces. Not along the slip if `info` does not say so.
    SlipFriction(const StepInfo& info, const Island& island, const ContactManifold& manifold);

    Friction at(const ManifoldPoint& point) const
    {
        return shares_ ? shared_ : along(widen(point.r1), widen(point.r2), Real(point.normal_impulse));
    }

  private:
    void find_shared();
    Friction along(Vec3 r1, Vec3 r2, Real p) const;
    Vec3 slip_at(Vec3 r1, Vec3 r2) const;
    Vec3 tangential(Vec3 u) const { return u - dot(n_, u) * n_; }

    const ContactManifold& manifold_;
    const Body *body1_, *body2_;
    Vec3 n_, pushed_;  // what forces on the bodies change in the step
    Real mu_, inv_mass_ = 0;
    Friction shared_;
    bool shares_ = true;
};

}  // namespace epode
