// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Which worlds, models, links, joints and shapes there are, by number and by name; and their removal.
#pragma once

#include "integrations/gazebo/store.h"

namespace epode::gazebo {

struct EntityAccessFeatures
    : gz::physics::FeatureList<gz::physics::GetEntities, gz::physics::RemoveEntities> {};

class EntityAccess : public virtual Store, public virtual gz::physics::Implements3d<EntityAccessFeatures> {
  public:
    const std::string& GetEngineName(const Identity&) const override;
    std::size_t GetEngineIndex(const Identity&) const override { return 0; }

    std::size_t GetWorldCount(const Identity&) const override { return worlds_.size(); }
    Identity GetWorld(const Identity&, std::size_t index) const override;
    Identity GetWorld(const Identity&, const std::string& name) const override;
    const std::string& GetWorldName(const Identity& world) const override;
    std::size_t GetWorldIndex(const Identity& world) const override;
    Identity GetEngineOfWorld(const Identity&) const override { return GenerateIdentity(0); }

    std::size_t GetModelCount(const Identity& world) const override;
    Identity GetModel(const Identity& world, std::size_t index) const override;
    Identity GetModel(const Identity& world, const std::string& name) const override;
    const std::string& GetModelName(const Identity& model) const override;
    std::size_t GetModelIndex(const Identity& model) const override;
    Identity GetWorldOfModel(const Identity& model) const override;

    std::size_t GetNestedModelCount(const Identity& model) const override;
    Identity GetNestedModel(const Identity& model, std::size_t index) const override;
    Identity GetNestedModel(const Identity& model, const std::string& name) const override;

    std::size_t GetLinkCount(const Identity& model) const override;
    Identity GetLink(const Identity& model, std::size_t index) const override;
    Identity GetLink(const Identity& model, const std::string& name) const override;
    const std::string& GetLinkName(const Identity& link) const override;
    std::size_t GetLinkIndex(const Identity& link) const override;
    Identity GetModelOfLink(const Identity& link) const override;

    std::size_t GetJointCount(const Identity& model) const override;
    Identity GetJoint(const Identity& model, std::size_t index) const override;
    Identity GetJoint(const Identity& model, const std::string& name) const override;
    const std::string& GetJointName(const Identity& joint) const override;
    std::size_t GetJointIndex(const Identity& joint) const override;
    Identity GetModelOfJoint(const Identity& joint) const override;

    std::size_t GetShapeCount(const Identity& link) const override;
    Identity GetShape(const Identity& link, std::size_t index) const override;
    Identity GetShape(const Identity& link, const std::string& name) const override;
    const std::string& GetShapeName(const Identity& shape) const override;
    std::size_t GetShapeIndex(const Identity& shape) const override;
    Identity GetLinkOfShape(const Identity& shape) const override;

    bool RemoveModelByIndex(const Identity& world, std::size_t index) override;
    bool RemoveModelByName(const Identity& world, const std::string& name) override;
    bool RemoveModel(const Identity& model) override;
    bool ModelRemoved(const Identity& model) const override;
    bool RemoveNestedModelByIndex(const Identity& model, std::size_t index) override;
    bool RemoveNestedModelByName(const Identity& model, const std::string& name) override;

  protected:
    // Takes a joint out of its model and the world; what it was attached to is free.
    void remove_joint(Joint& joint);

  private:
    template <class T, class List>
    Identity by(const Identity& owner, List T::*list, std::size_t index) const;
    template <class T, class List>
    Identity by(const Identity& owner, List T::*list, const std::string& name) const;
    template <class T>
    const std::string& name_of(const Identity& identity) const;
    bool remove(Model* model);
    void remove_all_of(Model& model);
    void remove_link(Link& link);
};

}  // namespace epode::gazebo
