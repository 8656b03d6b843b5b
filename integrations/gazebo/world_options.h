// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Gravity, the solver and the collision detector of a world.
//   hybrid    each island in its own way, the default            world, exact   as dWorldStep
//   quick     sweeps over rows, as dWorldQuickStep                substeps       as dWorldStepFast1
// The names of dartsim's solvers, dantzig and pgs, are exact and quick here. There is one collision detector.
#pragma once

#include "integrations/gazebo/store.h"

namespace epode::gazebo {

struct WorldOptionFeatures
    : gz::physics::FeatureList<gz::physics::Gravity, gz::physics::Solver, gz::physics::CollisionDetector> {};

// False, with a message, of a name that is none.
bool choose_solver(World& world, const std::string& name);

class WorldOptions : public virtual Store, public virtual gz::physics::Implements3d<WorldOptionFeatures> {
  public:
    void SetWorldGravity(const Identity& world, const Eigen::Vector3d& gravity) override;
    Eigen::Vector3d GetWorldGravity(const Identity& world) const override;
    void SetWorldSolver(const Identity& world, const std::string& name) override;
    const std::string& GetWorldSolver(const Identity& world) const override;
    void SetWorldCollisionDetector(const Identity& world, const std::string& name) override;
    const std::string& GetWorldCollisionDetector(const Identity& world) const override;
};

}  // namespace epode::gazebo
