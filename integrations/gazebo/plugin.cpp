// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The plugin that gz-physics loads: all features in one class.
#include "integrations/gazebo/joint_features.h"
#include "integrations/gazebo/kinematics.h"
#include "integrations/gazebo/shape_features.h"
#include "integrations/gazebo/simulation.h"
#include "integrations/gazebo/world_options.h"

// clang-format would put spaces into the path.
// clang-format off
#include GZ_HEADER(physics/Register.hh)
// clang-format on

namespace epode::gazebo {

struct PluginFeatures
    : gz::physics::FeatureList<EntityAccessFeatures, ConstructFeatures, ShapeFeatures, JointFeatures,
                               KinematicsFeatures, SimulationFeatures, WorldOptionFeatures> {};

class Plugin : public virtual EntityAccess,
               public virtual Construct,
               public virtual Shapes,
               public virtual Joints,
               public virtual Kinematics,
               public virtual Simulation,
               public virtual WorldOptions,
               public virtual gz::physics::Implements3d<PluginFeatures> {};

GZ_PHYSICS_ADD_PLUGIN(Plugin, gz::physics::FeaturePolicy3d, PluginFeatures)

}  // namespace epode::gazebo
