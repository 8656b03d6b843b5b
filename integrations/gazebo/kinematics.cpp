// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See kinematics.h.
#include "integrations/gazebo/kinematics.h"

#include <algorithm>
#include <set>

#include "integrations/gazebo/convert.h"
#include "integrations/gazebo/joints.h"
#include "integrations/gazebo/links.h"
#include "integrations/gazebo/shapes.h"

namespace epode::gazebo {

namespace {

gz::physics::FrameData3d frame_data(const Motion& motion)
{
    gz::physics::FrameData3d data;
    data.pose = eigen_of(motion.pose);
    data.linearVelocity = eigen_of(motion.linear), data.angularVelocity = eigen_of(motion.angular);
    data.linearAcceleration = eigen_of(motion.linear_acceleration);
    data.angularAcceleration = eigen_of(motion.angular_acceleration);
    return data;
}

Motion motion_of_entity(const Entity& entity)
{
    if (const auto* link = dynamic_cast<const Link*>(&entity)) return motion_of(*link);
    if (const auto* joint = dynamic_cast<const Joint*>(&entity))
        return moved_frame(motion_of(*joint->child), inverse(joint->to_child));
    if (const auto* shape = dynamic_cast<const Shape*>(&entity))
        return moved_frame(motion_of(*shape->link), shape->pose);
    if (const auto* model = dynamic_cast<const Model*>(&entity)) return motion_of(*model);
    if (const auto* group = dynamic_cast<const FreeGroup*>(&entity)) return motion_of(*group->link);
    return {};
}

bool is_held(const Model& model)
{
    const std::vector<Link*> links = links_of(model);
    return !model.is_static &&
           std::any_of(links.begin(), links.end(), [](Link* link) { return group_of(*link).is_held; });
}

// Those of a model, and what joints connect to them.
std::vector<Link*> links_of(const FreeGroup& group)
{
    if (!group.model) return group_of(*group.link).links;
    std::vector<Link*> links = links_of(*group.model);
    std::set<Link*> known(links.begin(), links.end());
    for (std::size_t i = 0; i < links.size(); ++i)
        for (Link* other : group_of(*links[i]).links)
            if (known.insert(other).second) links.push_back(other);
    return links;
}

bool is_finite(const Eigen::Vector3d& v) { return v.allFinite(); }

}  // namespace

gz::physics::FrameData3d Kinematics::FrameDataRelativeToWorld(const gz::physics::FrameID& frame) const
{
    if (frame.IsWorld()) return {};
    const Entity* const entity = find(frame.ID());
    if (!entity) EPODE_GAZEBO_ERROR << "frame " << frame.ID() << " is none, or has been removed\n";
    return entity ? frame_data(motion_of_entity(*entity)) : gz::physics::FrameData3d{};
}

// Made once for each model and link. What features hand out is const; entities are not.
Identity Kinematics::group_identity(std::shared_ptr<FreeGroup>& group, Model* model, Link* link) const
{
    if (!group) group = const_cast<Kinematics*>(this)->make<FreeGroup>(link->name);
    group->model = model, group->link = link;
    return identity_of(group.get());
}

Identity Kinematics::FindFreeGroupForModel(const Identity& model) const
{
    Model* const found = get<Model>(model);
    if (!found || !found->root || is_held(*found)) return GenerateInvalidId();
    return group_identity(found->group, found, found->root);
}

Identity Kinematics::FindFreeGroupForLink(const Identity& link) const
{
    Link* const found = get<Link>(link);
    if (!found || group_of(*found).is_held) return GenerateInvalidId();
    return group_identity(found->group, nullptr, found);
}

Identity Kinematics::GetFreeGroupRootLink(const Identity& group) const
{
    const FreeGroup* const found = get<FreeGroup>(group);
    return identity_of(found ? found->link : nullptr);
}

void Kinematics::SetFreeGroupWorldPose(const Identity& group, const gz::physics::Pose3d& pose)
{
    const FreeGroup* const found = get<FreeGroup>(group);
    if (!found) return;
    if (!pose.matrix().allFinite()) {
        EPODE_GAZEBO_ERROR << "a pose of '" << found->name << "' was refused: it is not finite\n";
        return;
    }
    move_all(links_of(*found), pose_of(pose) * inverse(pose_of(*found->link)));
}

void Kinematics::SetFreeGroupWorldLinearVelocity(const Identity& group, const Eigen::Vector3d& velocity)
{
    const FreeGroup* const found = get<FreeGroup>(group);
    if (!found || !is_finite(velocity)) return;
    const Motion root = motion_of(*found->link);
    add_velocity(links_of(*found), root.pose.p, vec_of(velocity) - root.linear, {});
}

void Kinematics::SetFreeGroupWorldAngularVelocity(const Identity& group, const Eigen::Vector3d& velocity)
{
    const FreeGroup* const found = get<FreeGroup>(group);
    if (!found || !is_finite(velocity)) return;
    const Motion root = motion_of(*found->link);
    add_velocity(links_of(*found), root.pose.p, {}, vec_of(velocity) - root.angular);
}

gz::physics::AlignedBox3d Kinematics::GetShapeAxisAlignedBoundingBox(const Identity& shape) const
{
    const Shape* const found = get<Shape>(shape);
    Vec low, high;
    if (!found || !box_of(*found, low, high)) return {};
    return {eigen_of(low), eigen_of(high)};
}

void Kinematics::AddLinkExternalForceInWorld(const Identity& link, const Eigen::Vector3d& force,
                                             const Eigen::Vector3d& position)
{
    const Link* const found = get<Link>(link);
    if (!found || !found->body || !is_finite(force) || !is_finite(position)) return;
    dBodyEnable(found->body);
    dBodyAddForceAtPos(found->body, force.x(), force.y(), force.z(), position.x(), position.y(),
                       position.z());
}

void Kinematics::AddLinkExternalTorqueInWorld(const Identity& link, const Eigen::Vector3d& torque)
{
    const Link* const found = get<Link>(link);
    if (!found || !found->body || !is_finite(torque)) return;
    dBodyEnable(found->body);
    dBodyAddTorque(found->body, torque.x(), torque.y(), torque.z());
}

}  // namespace epode::gazebo
