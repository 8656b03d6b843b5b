// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// How the friction of a manifold is bounded in dWorldStep, by two limits instead of a cone: along the slip s and
// across it. Between two fixed directions it would be up to sqrt(2) times as large as along them. Along s what slides is
// braked by Coulomb's mu N, straight on, in every direction, and what is pushed gives way at mu N. Across s, Coulomb's
// friction is mu N times the sine of the angle by which s turns during the step: at most dv/|s|,
//   dv = a few times mu p (1/m1 + 1/m2),   p: normal impulse of the last step,
// being what friction can change in a step (a few times, because bodies also turn). What sticks has both limits.
//   Of a surface with a friction axis all this is so for the scaled tangents of its ellipse (FrictionAxes), where slip and
// friction are those of an isotropic surface.
//   Points share their directions as long as their slips are alike, and have fixed ones while what pushes is far
// from moving them: solvers start from the last step's impulses.
#pragma once

#include "dynamics/island.h"
#include "rows/contact_manifold.h"
#include "rows/row_writer.h"

namespace epode {

// Each direction has its limit, in units of its length.
struct Friction {
    Vec3 t[2];
    Real mu[2];
};

class SlipFriction {
  public:
    // Of a manifold with points, between bodies that have their forces. Not along the slip if `info` does not say so.
    // `cone`: the two directions are bounded together.
    SlipFriction(const StepInfo& info, const Island& island, const ContactManifold& manifold, bool cone);

    Friction at(const ManifoldPoint& point) const
    {
        return shares_ ? shared_ : along(widen(point.r1), widen(point.r2), Real(point.normal_impulse));
    }

  private:
    Friction fixed() const;
    bool is_line() const;
    void find_shared();
    Friction along(Vec3 r1, Vec3 r2, Real p) const;
    Friction along_scaled(Vec3 free, Real dv, Real speed) const;
    Vec3 slip_at(Vec3 r1, Vec3 r2) const;
    Vec3 tangential(Vec3 u) const { return u - dot(n_, u) * n_; }

    const ContactManifold& manifold_;
    const Body *body1_, *body2_;
    Vec3 n_, pushed_;  // what forces on the bodies change in the step
    FrictionAxes axes_;
    Real mu_, inv_mass_ = 0;  // the larger coefficient
    bool cone_;
    Friction shared_;
    bool shares_ = true;
};

}  // namespace epode
