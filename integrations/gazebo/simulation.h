// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The step: poses of all links and of those that have moved, points of contact, and a host's say in how surfaces act.
#pragma once

#include "integrations/gazebo/store.h"

namespace epode::gazebo {

struct SimulationFeatures
    : gz::physics::FeatureList<gz::physics::ForwardStep, gz::physics::GetContactsFromLastStepFeature,
                               gz::physics::SetContactPropertiesCallbackFeature> {};

class Simulation : public virtual Store, public virtual gz::physics::Implements3d<SimulationFeatures> {
  public:
    // The step's size is a std::chrono::steady_clock::duration in the input, or its TimeStep; 1 ms without one.
    void WorldForwardStep(const Identity& world, gz::physics::ForwardStep::Output& output,
                          gz::physics::ForwardStep::State& state,
                          const gz::physics::ForwardStep::Input& input) override;
    std::vector<ContactInternal> GetContactsFromLastStep(const Identity& world) const override;

    // Called once for each pair of shapes that touch, in their order, before each step: with its deepest point and how many there are.
    void AddContactPropertiesCallback(const Identity& world, const std::string& name,
                                      SurfaceParamsCallback callback) override;
    bool RemoveContactPropertiesCallback(const Identity& world, const std::string& name) override;

  private:
    struct Callbacks {
        const Simulation* simulation;
        std::map<std::string, SurfaceParamsCallback> functions;
    };
    static void see_manifold(void* callbacks, dManifold* manifold);
    void apply(const Callbacks& callbacks, dManifold& manifold) const;
    std::map<const World*, Callbacks> callbacks_;
};

}  // namespace epode::gazebo
