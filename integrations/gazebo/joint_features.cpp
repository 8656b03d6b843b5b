// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See joint_features.h.
#include "integrations/gazebo/joint_features.h"

#include "integrations/gazebo/convert.h"
#include "integrations/gazebo/joints.h"
#include "integrations/gazebo/links.h"

namespace epode::gazebo {

Joint* Joints::joint_with(const Identity& joint, std::size_t degree) const
{
    Joint* const found = get<Joint>(joint);
    if (!found || degree < degrees_of(*found)) return found;
    EPODE_GAZEBO_ERROR << "joint '" << found->name << "': degree of freedom " << degree
                       << " was refused; it has " << degrees_of(*found) << "\n";
    return nullptr;
}

Joint* Joints::joint_with(const Identity& joint, std::size_t degree, double value) const
{
    Joint* const found = joint_with(joint, degree);
    if (!found || std::isfinite(value)) return found;
    EPODE_GAZEBO_ERROR << "joint '" << found->name << "': the value " << value
                       << " was refused; it must be finite\n";
    return nullptr;
}

double Joints::GetJointPosition(const Identity& joint, std::size_t degree) const
{
    const Joint* const found = joint_with(joint, degree);
    return found ? position_of(*found, degree) : NAN;
}
double Joints::GetJointVelocity(const Identity& joint, std::size_t degree) const
{
    const Joint* const found = joint_with(joint, degree);
    return found ? velocity_of(*found, degree) : NAN;
}
double Joints::GetJointAcceleration(const Identity& joint, std::size_t degree) const
{
    const Joint* const found = joint_with(joint, degree);
    return found ? found->axis[degree].acceleration : NAN;
}
double Joints::GetJointForce(const Identity& joint, std::size_t degree) const
{
    const Joint* const found = joint_with(joint, degree);
    if (!found) return NAN;
    const Joint::Axis& its = found->axis[degree];
    return its.force != 0 ? its.force : its.exerted;
}
Joints::Pose3 Joints::GetJointTransform(const Identity& joint) const
{
    const Joint* const found = get<Joint>(joint);
    if (!found) return Pose3::Identity();
    const robots::Pose parent = found->parent ? pose_of(*found->parent) : robots::Pose{};
    return eigen_of(inverse(parent) * pose_of(*found->child));
}

void Joints::SetJointPosition(const Identity& joint, std::size_t degree, double value)
{
    if (Joint* const found = joint_with(joint, degree, value)) set_position(*found, degree, value);
}
void Joints::SetJointVelocity(const Identity& joint, std::size_t degree, double value)
{
    if (Joint* const found = joint_with(joint, degree, value)) set_velocity(*found, degree, value);
}
void Joints::SetJointAcceleration(const Identity& joint, std::size_t, double)
{
    if (const Joint* const found = get<Joint>(joint))
        EPODE_GAZEBO_WARNING << "joint '" << found->name << "': an acceleration was refused; set a force\n";
}
void Joints::SetJointForce(const Identity& joint, std::size_t degree, double value)
{
    if (Joint* const found = joint_with(joint, degree, value)) set_force(*found, degree, value);
}
void Joints::SetJointVelocityCommand(const Identity& joint, std::size_t degree, double value)
{
    if (Joint* const found = joint_with(joint, degree, value)) set_velocity_command(*found, degree, value);
}

std::size_t Joints::GetJointDegreesOfFreedom(const Identity& joint) const
{
    const Joint* const found = get<Joint>(joint);
    return found ? degrees_of(*found) : 0;
}
Joints::Pose3 Joints::GetJointTransformFromParent(const Identity& joint) const
{
    const Joint* const found = get<Joint>(joint);
    return found ? eigen_of(found->from_parent) : Pose3::Identity();
}
Joints::Pose3 Joints::GetJointTransformToChild(const Identity& joint) const
{
    const Joint* const found = get<Joint>(joint);
    return found ? eigen_of(found->to_child) : Pose3::Identity();
}
void Joints::SetJointTransformFromParent(const Identity& joint, const Pose3& pose)
{
    set_frame(joint, &Joint::from_parent, pose);
}
void Joints::SetJointTransformToChild(const Identity& joint, const Pose3& pose)
{
    set_frame(joint, &Joint::to_child, pose);
}
void Joints::set_frame(const Identity& joint, robots::Pose Joint::*frame, const Pose3& pose)
{
    Joint* const found = get<Joint>(joint);
    if (!found || !pose.matrix().allFinite()) return;
    found->*frame = pose_of(pose);
    make_again(*found);
}

void Joints::SetJointMinPosition(const Identity& joint, std::size_t degree, double value)
{
    set_limit(joint, degree, &Joint::Axis::low, value);
}
void Joints::SetJointMaxPosition(const Identity& joint, std::size_t degree, double value)
{
    set_limit(joint, degree, &Joint::Axis::high, value);
}
void Joints::SetJointMinVelocity(const Identity& joint, std::size_t degree, double value)
{
    set_limit(joint, degree, &Joint::Axis::min_velocity, value);
}
void Joints::SetJointMaxVelocity(const Identity& joint, std::size_t degree, double value)
{
    set_limit(joint, degree, &Joint::Axis::max_velocity, value);
}
void Joints::SetJointMinEffort(const Identity& joint, std::size_t degree, double value)
{
    set_limit(joint, degree, &Joint::Axis::min_effort, value);
}
void Joints::SetJointMaxEffort(const Identity& joint, std::size_t degree, double value)
{
    set_limit(joint, degree, &Joint::Axis::max_effort, value);
}

// Infinite ones are none. One at a time may be on the wrong side of the other, which counts once they agree.
void Joints::set_limit(const Identity& joint, std::size_t degree, double Joint::Axis::*limit, double value)
{
    Joint* const found = joint_with(joint, degree);
    if (!found) return;
    if (std::isnan(value)) {
        EPODE_GAZEBO_ERROR << "joint '" << found->name << "': a limit that is not a number was refused\n";
        return;
    }
    found->axis[degree].*limit = value;
    put_limits(*found, degree);
}

void Joints::DetachJoint(const Identity& joint)
{
    if (Joint* const found = get<Joint>(joint)) remove_joint(*found);
}

gz::physics::Wrench3d Joints::GetJointTransmittedWrenchInJointFrame(const Identity& joint) const
{
    gz::physics::Wrench3d out;
    const Joint* const found = get<Joint>(joint);
    const JointWrench wrench = found ? transmitted_wrench(*found) : JointWrench{};
    out.force = eigen_of(wrench.force), out.torque = eigen_of(wrench.torque);
    return out;
}

Identity Joints::cast(const Identity& joint, JointKind kind) const
{
    const Joint* const found = get<Joint>(joint);
    return identity_of(found && found->kind == kind ? found : nullptr);
}

// Both links stay where they are; the joint's frame is the child's.
Identity Joints::attach_to(const Identity& child, const Parent& parent, const std::string& name,
                           JointKind kind, const Vec3& axis)
{
    Link* const its = get<Link>(child);
    Link* const outer = parent ? get<Link>(parent->FullIdentity()) : nullptr;
    if (!its || (parent && !outer)) return GenerateInvalidId();
    const auto made = attach(*its->model, name, kind, outer, *its, pose_of(*its));
    if (!made) return GenerateInvalidId();
    const Vec along = vec_of(axis);
    made->axes[0] = length(along) > 0 ? (1 / length(along)) * along : Vec{0, 0, 1};
    return finish(made) ? identity_of(made.get()) : GenerateInvalidId();
}

void Joints::set_axis(const Identity& joint, const Vec3& axis)
{
    Joint* const found = get<Joint>(joint);
    const Vec along = vec_of(axis);
    if (!found || !robots::is_finite(along) || !(length(along) > 0)) return;
    found->axes[0] = (1 / length(along)) * along;
    make_again(*found);
}

Identity Joints::CastToRevoluteJoint(const Identity& joint) const
{
    return cast(joint, JointKind::kRevolute);
}
Joints::Vec3 Joints::GetRevoluteJointAxis(const Identity& joint) const
{
    const Joint* const found = get<Joint>(joint);
    return found ? eigen_of(found->axes[0]) : Vec3::Zero();
}
void Joints::SetRevoluteJointAxis(const Identity& joint, const Vec3& axis) { set_axis(joint, axis); }
Identity Joints::AttachRevoluteJoint(const Identity& child, const Parent& parent, const std::string& name,
                                     const Vec3& axis)
{
    return attach_to(child, parent, name, JointKind::kRevolute, axis);
}

Identity Joints::CastToPrismaticJoint(const Identity& joint) const
{
    return cast(joint, JointKind::kPrismatic);
}
Joints::Vec3 Joints::GetPrismaticJointAxis(const Identity& joint) const
{
    return GetRevoluteJointAxis(joint);
}
void Joints::SetPrismaticJointAxis(const Identity& joint, const Vec3& axis) { set_axis(joint, axis); }
Identity Joints::AttachPrismaticJoint(const Identity& child, const Parent& parent, const std::string& name,
                                      const Vec3& axis)
{
    return attach_to(child, parent, name, JointKind::kPrismatic, axis);
}

Identity Joints::CastToFixedJoint(const Identity& joint) const { return cast(joint, JointKind::kFixed); }
Identity Joints::AttachFixedJoint(const Identity& child, const Parent& parent, const std::string& name)
{
    return attach_to(child, parent, name, JointKind::kFixed, Vec3::UnitZ());
}

}  // namespace epode::gazebo
