// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Joints: states, commands, limits, frames and wrenches; joints that a host attaches to links and detaches.
#pragma once

#include "integrations/gazebo/construct.h"
#include "integrations/gazebo/entity_access.h"

namespace epode::gazebo {

struct JointFeatures
    : gz::physics::FeatureList<
          gz::physics::GetBasicJointState, gz::physics::SetBasicJointState,
          gz::physics::GetBasicJointProperties, gz::physics::SetJointTransformFromParentFeature,
          gz::physics::SetJointTransformToChildFeature, gz::physics::SetJointVelocityCommandFeature,
          gz::physics::SetJointPositionLimitsFeature, gz::physics::SetJointVelocityLimitsFeature,
          gz::physics::SetJointEffortLimitsFeature, gz::physics::DetachJointFeature,
          gz::physics::GetJointTransmittedWrench, gz::physics::RevoluteJointCast,
          gz::physics::GetRevoluteJointProperties, gz::physics::SetRevoluteJointProperties,
          gz::physics::AttachRevoluteJointFeature, gz::physics::PrismaticJointCast,
          gz::physics::GetPrismaticJointProperties, gz::physics::SetPrismaticJointProperties,
          gz::physics::AttachPrismaticJointFeature, gz::physics::FixedJointCast,
          gz::physics::AttachFixedJointFeature> {};

class Joints : public virtual Construct,
               public virtual EntityAccess,
               public virtual gz::physics::Implements3d<JointFeatures> {
  public:
    using Pose3 = gz::physics::Pose3d;
    using Vec3 = Eigen::Vector3d;
    using Parent = gz::physics::BaseLinkPtr<gz::physics::FeaturePolicy3d>;

    double GetJointPosition(const Identity& joint, std::size_t degree) const override;
    double GetJointVelocity(const Identity& joint, std::size_t degree) const override;
    // Of the last step, as the difference of its velocities.
    double GetJointAcceleration(const Identity& joint, std::size_t degree) const override;
    // What is set for the next step, else what has been exerted in the last one.
    double GetJointForce(const Identity& joint, std::size_t degree) const override;
    Pose3 GetJointTransform(const Identity& joint) const override;

    void SetJointPosition(const Identity& joint, std::size_t degree, double value) override;
    void SetJointVelocity(const Identity& joint, std::size_t degree, double value) override;
    // Refused with a message: accelerations follow from forces.
    void SetJointAcceleration(const Identity& joint, std::size_t degree, double value) override;
    void SetJointForce(const Identity& joint, std::size_t degree, double value) override;
    void SetJointVelocityCommand(const Identity& joint, std::size_t degree, double value) override;

    std::size_t GetJointDegreesOfFreedom(const Identity& joint) const override;
    Pose3 GetJointTransformFromParent(const Identity& joint) const override;
    Pose3 GetJointTransformToChild(const Identity& joint) const override;
    void SetJointTransformFromParent(const Identity& joint, const Pose3& pose) override;
    void SetJointTransformToChild(const Identity& joint, const Pose3& pose) override;

    void SetJointMinPosition(const Identity& joint, std::size_t degree, double value) override;
    void SetJointMaxPosition(const Identity& joint, std::size_t degree, double value) override;
    void SetJointMinVelocity(const Identity& joint, std::size_t degree, double value) override;
    void SetJointMaxVelocity(const Identity& joint, std::size_t degree, double value) override;
    void SetJointMinEffort(const Identity& joint, std::size_t degree, double value) override;
    void SetJointMaxEffort(const Identity& joint, std::size_t degree, double value) override;

    void DetachJoint(const Identity& joint) override;
    gz::physics::Wrench3d GetJointTransmittedWrenchInJointFrame(const Identity& joint) const override;

    Identity CastToRevoluteJoint(const Identity& joint) const override;
    Vec3 GetRevoluteJointAxis(const Identity& joint) const override;
    void SetRevoluteJointAxis(const Identity& joint, const Vec3& axis) override;
    Identity AttachRevoluteJoint(const Identity& child, const Parent& parent, const std::string& name,
                                 const Vec3& axis) override;
    Identity CastToPrismaticJoint(const Identity& joint) const override;
    Vec3 GetPrismaticJointAxis(const Identity& joint) const override;
    void SetPrismaticJointAxis(const Identity& joint, const Vec3& axis) override;
    Identity AttachPrismaticJoint(const Identity& child, const Parent& parent, const std::string& name,
                                  const Vec3& axis) override;
    Identity CastToFixedJoint(const Identity& joint) const override;
    Identity AttachFixedJoint(const Identity& child, const Parent& parent, const std::string& name) override;

  private:
    // Null, with a message, of a joint that has no such degree of freedom.
    Joint* joint_with(const Identity& joint, std::size_t degree) const;
    Joint* joint_with(const Identity& joint, std::size_t degree, double value) const;
    Identity cast(const Identity& joint, JointKind kind) const;
    Identity attach_to(const Identity& child, const Parent& parent, const std::string& name, JointKind kind,
                       const Vec3& axis);
    void set_axis(const Identity& joint, const Vec3& axis);
    void set_frame(const Identity& joint, robots::Pose Joint::*frame, const Pose3& pose);
    void set_limit(const Identity& joint, std::size_t degree, double Joint::Axis::*limit, double value);
};

}  // namespace epode::gazebo
