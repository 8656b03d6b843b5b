// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What SDF's objects say, with and without the rest of their file.
#pragma once

#include <sdf/Collision.hh>
#include <sdf/Element.hh>
#include <sdf/Joint.hh>
#include <sdf/JointAxis.hh>
#include <sdf/World.hh>

#include "integrations/gazebo/convert.h"
#include "integrations/gazebo/entities.h"

namespace epode::gazebo {

// The pose of an object in a frame of its file; its raw pose where the file is not there.
template <class Posed>
Pose pose_in(const Posed& object, const std::string& frame)
{
    gz::math::Pose3d pose;
    return pose_of(object.SemanticPose().Resolve(pose, frame).empty() ? pose : object.RawPose());
}

// sdformat 13 renamed these two.
template <class JointT>
std::string parent_name(const JointT& joint)
{
    std::string name;
    if (joint.ResolveParentLink(name).empty()) return name;
    if constexpr (requires { joint.ParentName(); })
        return joint.ParentName();
    else
        return joint.ParentLinkName();
}
template <class JointT>
std::string child_name(const JointT& joint)
{
    std::string name;
    if (joint.ResolveChildLink(name).empty()) return name;
    if constexpr (requires { joint.ChildName(); })
        return joint.ChildName();
    else
        return joint.ChildLinkName();
}
template <class JointT>
Pose frame_in_child(const JointT& joint)
{
    if constexpr (requires { joint.ChildName(); })
        return pose_in(joint, joint.ChildName());
    else
        return pose_in(joint, joint.ChildLinkName());
}

// The element at the end of a path of names; null where there is none.
::sdf::ElementPtr element_at(::sdf::ElementPtr from, std::initializer_list<const char*> path);
// A finite number in a child of that name, or else the value.
double number_in(const ::sdf::ElementPtr& element, const char* name, double value);

// <surface> of a collision: friction, bounce, springs and bits.
void read_surface(const ::sdf::Collision& collision, Shape& shape);
// <ode> in <physics>, and the solver that it names.
void read_physics(const ::sdf::World& from, World& world);

}  // namespace epode::gazebo
