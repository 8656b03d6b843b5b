// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Where things are and how they move: frames of links, joints, shapes, models and free groups; boxes around shapes; groups that a host
// moves as one, and forces that it puts on links.
#pragma once

#include "integrations/gazebo/store.h"

namespace epode::gazebo {

struct KinematicsFeatures
    : gz::physics::FeatureList<gz::physics::CompleteFrameSemantics, gz::physics::LinkFrameSemantics,
                               gz::physics::JointFrameSemantics, gz::physics::ShapeFrameSemantics,
                               gz::physics::ModelFrameSemantics, gz::physics::FindFreeGroupFeature,
                               gz::physics::FreeGroupFrameSemantics, gz::physics::SetFreeGroupWorldPose,
                               gz::physics::SetFreeGroupWorldVelocity, gz::physics::GetShapeBoundingBox,
                               gz::physics::GetLinkBoundingBox, gz::physics::GetModelBoundingBox,
                               gz::physics::AddLinkExternalForceTorque> {};

class Kinematics : public virtual Store, public virtual gz::physics::Implements3d<KinematicsFeatures> {
  public:
    gz::physics::FrameData3d FrameDataRelativeToWorld(const gz::physics::FrameID& frame) const override;

    // Invalid of what joints hold to the world.
    Identity FindFreeGroupForModel(const Identity& model) const override;
    Identity FindFreeGroupForLink(const Identity& link) const override;
    Identity GetFreeGroupRootLink(const Identity& group) const override;
    // That of the root link; the others keep where they are to it.
    void SetFreeGroupWorldPose(const Identity& group, const gz::physics::Pose3d& pose) override;
    void SetFreeGroupWorldLinearVelocity(const Identity& group, const Eigen::Vector3d& velocity) override;
    void SetFreeGroupWorldAngularVelocity(const Identity& group, const Eigen::Vector3d& velocity) override;

    // In the shape's frame.
    gz::physics::AlignedBox3d GetShapeAxisAlignedBoundingBox(const Identity& shape) const override;

    void AddLinkExternalForceInWorld(const Identity& link, const Eigen::Vector3d& force,
                                     const Eigen::Vector3d& position) override;
    void AddLinkExternalTorqueInWorld(const Identity& link, const Eigen::Vector3d& torque) override;

  private:
    Identity group_identity(std::shared_ptr<FreeGroup>& group, Model* model, Link* link) const;
};

}  // namespace epode::gazebo
