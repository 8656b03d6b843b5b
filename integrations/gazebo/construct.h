// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Worlds, models, links, joints and collisions from SDF, whole or piece by piece, and empty ones. A host may give a whole world, or a
// model without links and then one link after the other: an object of a file that has lost the rest of it stands at its raw pose.
#pragma once

#include <sdf/Collision.hh>
#include <sdf/Joint.hh>
#include <sdf/JointAxis.hh>
#include <sdf/Link.hh>
#include <sdf/Model.hh>
#include <sdf/World.hh>

#include "integrations/gazebo/store.h"

namespace epode::gazebo {

struct ConstructFeatures
    : gz::physics::FeatureList<
          gz::physics::sdf::ConstructSdfWorld, gz::physics::sdf::ConstructSdfModel,
          gz::physics::sdf::ConstructSdfNestedModel, gz::physics::sdf::ConstructSdfLink,
          gz::physics::sdf::ConstructSdfJoint, gz::physics::sdf::ConstructSdfCollision,
          gz::physics::ConstructEmptyWorldFeature, gz::physics::ConstructEmptyModelFeature,
          gz::physics::ConstructEmptyNestedModelFeature, gz::physics::ConstructEmptyLinkFeature> {};

class Construct : public virtual Store, public virtual gz::physics::Implements3d<ConstructFeatures> {
  public:
    Identity ConstructSdfWorld(const Identity&, const ::sdf::World& world) override;
    Identity ConstructSdfModel(const Identity& world, const ::sdf::Model& model) override;
    // The owner is a model, or a world.
    Identity ConstructSdfNestedModel(const Identity& owner, const ::sdf::Model& model) override;
    Identity ConstructSdfLink(const Identity& model, const ::sdf::Link& link) override;
    Identity ConstructSdfJoint(const Identity& model, const ::sdf::Joint& joint) override;
    Identity ConstructSdfCollision(const Identity& link, const ::sdf::Collision& collision) override;

    Identity ConstructEmptyWorld(const Identity&, const std::string& name) override;
    Identity ConstructEmptyModel(const Identity& world, const std::string& name) override;
    Identity ConstructEmptyNestedModel(const Identity& model, const std::string& name) override;
    Identity ConstructEmptyLink(const Identity& model, const std::string& name) override;

  protected:
    // A shape of a link that has no geoms yet.
    std::shared_ptr<Shape> new_shape(Link& link, const std::string& name, ShapeKind kind, const Pose& pose);
    // Keeps the shape with its geoms if they could be made.
    Identity keep(const std::shared_ptr<Shape>& shape, bool is_made);
    // Makes the joint of links that are where they are; null, with a message, if it cannot be.
    std::shared_ptr<Joint> attach(Model& model, const std::string& name, JointKind kind, Link* parent,
                                  Link& child, const Pose& frame);
    bool finish(const std::shared_ptr<Joint>& joint);

  private:
    World* add_world(const std::string& name);
    Model* add_model(World& world, Model* parent, const std::string& name, const Pose& pose);
    Link* add_link(Model& model, const std::string& name, const Pose& pose);
    void add_body(Link& link, const dMass& mass);
    Model* read_model(World& world, Model* parent, const ::sdf::Model& from);
    Link* read_link(Model& model, const ::sdf::Link& from);
    Joint* read_joint(Model& model, const ::sdf::Joint& from);
    void read_axis(Joint& joint, std::size_t degree, const ::sdf::JointAxis& from);
    void read_mimic(const std::shared_ptr<Joint>& joint, std::size_t degree, const ::sdf::JointAxis& from);
    void couple_waiting(Model& model);
    void settle_root(Model& model, const Pose& frame);
};

}  // namespace epode::gazebo
