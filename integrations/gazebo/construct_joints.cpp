// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Joints of SDF (construct.h). <mimic> in an axis is read wherever the file has it: older versions of SDF do not know the element and
// keep it as it is. Its leader may come later: it waits in the model.
#include "integrations/gazebo/construct.h"
#include "integrations/gazebo/joints.h"
#include "integrations/gazebo/links.h"
#include "integrations/gazebo/sdf_read.h"

namespace epode::gazebo {

namespace {

constexpr double kUnlimited = 1e16;  // what SDF takes for no limit

bool kind_of(::sdf::JointType type, JointKind& kind)
{
    switch (type) {
        case ::sdf::JointType::REVOLUTE:
        case ::sdf::JointType::CONTINUOUS:
            return kind = JointKind::kRevolute, true;
        case ::sdf::JointType::PRISMATIC:
            return kind = JointKind::kPrismatic, true;
        case ::sdf::JointType::FIXED:
            return kind = JointKind::kFixed, true;
        case ::sdf::JointType::UNIVERSAL:
            return kind = JointKind::kUniversal, true;
        case ::sdf::JointType::REVOLUTE2:
            return kind = JointKind::kRevolute2, true;
        case ::sdf::JointType::BALL:
            return kind = JointKind::kBall, true;
        case ::sdf::JointType::SCREW:
            return kind = JointKind::kScrew, true;
        default:
            return false;
    }
}

double limit(double value, double none) { return std::abs(value) < kUnlimited ? value : none; }

const Joint* find_joint(const Model& model, const std::string& name)
{
    const std::size_t end = name.find("::");
    if (end == std::string::npos) return named(model.joints, name);
    const Model* const inner = named(model.models, name.substr(0, end));
    return inner ? find_joint(*inner, name.substr(end + 2)) : nullptr;
}

void refuse(const Model& model, const std::string& name, const std::string& why)
{
    EPODE_GAZEBO_ERROR << "joint '" << name << "' of model '" << model.name << "' was refused: " << why
                       << "\n";
}

}  // namespace

Identity Construct::ConstructSdfJoint(const Identity& model, const ::sdf::Joint& joint)
{
    Model* const found = get<Model>(model);
    return identity_of(found ? read_joint(*found, joint) : nullptr);
}

std::shared_ptr<Joint> Construct::attach(Model& model, const std::string& name, JointKind kind, Link* parent,
                                         Link& child, const Pose& frame)
{
    if (named(model.joints, name)) return refuse(model, name, "there is one of that name"), nullptr;
    if (parent == &child) return refuse(model, name, "parent and child are the same link"), nullptr;
    if (!is_finite(frame)) return refuse(model, name, "its pose is not finite"), nullptr;
    if (!child.body && (!parent || !parent->body))
        return refuse(model, name, "neither of its links can move"), nullptr;
    const auto joint = make<Joint>(name);
    joint->model = &model, joint->kind = kind, joint->parent = parent, joint->child = &child;
    joint->from_parent = parent ? inverse(pose_of(*parent)) * frame : frame;
    joint->to_child = inverse(frame) * pose_of(child);
    return joint;
}

bool Construct::finish(const std::shared_ptr<Joint>& joint)
{
    if (!make_joint(*joint)) return destroy_joint(*joint), forget(*joint), false;
    for (Link* end : {joint->parent, joint->child}) {
        if (!end) continue;
        end->joints.push_back(joint.get());
        // What a controller moves does not sleep.
        if (end->body) dBodySetAutoDisableFlag(end->body, 0);
    }
    joint->model->joints.push_back(joint);
    return true;
}

Joint* Construct::read_joint(Model& model, const ::sdf::Joint& from)
{
    JointKind kind;
    if (!kind_of(from.Type(), kind))
        return refuse(model, from.Name(),
                      "its type is none of revolute, continuous, prismatic, fixed, "
                      "universal, revolute2, ball and screw"),
               nullptr;
    const std::string parent_link = parent_name(from), child_link = child_name(from);
    Link* const parent = parent_link == "world" ? nullptr : find_link(model, parent_link);
    Link* const child = find_link(model, child_link);
    if (!child || (!parent && parent_link != "world"))
        return refuse(model, from.Name(), "there is no link '" + (child ? parent_link : child_link) + "'"),
               nullptr;
    const auto joint =
        attach(model, from.Name(), kind, parent, *child, pose_of(*child) * frame_in_child(from));
    if (!joint) return nullptr;
    if (from.ThreadPitch() != 0) joint->pitch = -1 / from.ThreadPitch();
    for (unsigned i = 0; i < 2; ++i)
        if (from.Axis(i)) read_axis(*joint, i, *from.Axis(i));
    if (from.Type() == ::sdf::JointType::CONTINUOUS)
        joint->axis[0].low = -HUGE_VAL, joint->axis[0].high = HUGE_VAL;
    if (!finish(joint)) return nullptr;
    for (unsigned i = 0; i < 2; ++i)
        if (from.Axis(i)) read_mimic(joint, i, *from.Axis(i));
    for (Model* outer = &model; outer; outer = outer->parent) couple_waiting(*outer);
    return joint.get();
}

void Construct::read_axis(Joint& joint, std::size_t degree, const ::sdf::JointAxis& from)
{
    gz::math::Vector3d xyz;
    if (!from.ResolveXyz(xyz).empty()) xyz = from.Xyz();
    const Vec axis = vec_of(xyz);
    joint.axes[degree] = length(axis) > 0 ? (1 / length(axis)) * axis : Vec{0, 0, 1};
    Joint::Axis& its = joint.axis[degree];
    its.low = limit(from.Lower(), -HUGE_VAL), its.high = limit(from.Upper(), HUGE_VAL);
    if (its.low > its.high) {
        EPODE_GAZEBO_ERROR << "joint '" << joint.name << "': a lower limit of " << its.low
                           << " above the upper one of " << its.high << "; there are none then\n";
        its.low = -HUGE_VAL, its.high = HUGE_VAL;
    }
    if (from.Effort() >= 0) its.max_effort = limit(from.Effort(), HUGE_VAL), its.min_effort = -its.max_effort;
    if (from.MaxVelocity() >= 0)
        its.max_velocity = limit(from.MaxVelocity(), HUGE_VAL), its.min_velocity = -its.max_velocity;
    its.damping = std::max(0.0, from.Damping()), its.friction = std::max(0.0, from.Friction());
    its.stiffness = std::max(0.0, from.SpringStiffness()), its.spring_reference = from.SpringReference();
}

void Construct::read_mimic(const std::shared_ptr<Joint>& joint, std::size_t degree,
                           const ::sdf::JointAxis& from)
{
    const ::sdf::ElementPtr mimic = element_at(from.Element(), {"mimic"});
    if (!mimic || !mimic->HasAttribute("joint")) return;
    Mimic its;
    its.follower = joint, its.follower_axis = degree;
    its.leader = mimic->GetAttribute("joint")->GetAsString();
    if (mimic->HasAttribute("axis")) its.leader_axis = mimic->GetAttribute("axis")->GetAsString() == "axis2";
    its.multiplier = number_in(mimic, "multiplier", 1);
    its.offset = number_in(mimic, "offset", 0), its.reference = number_in(mimic, "reference", 0);
    joint->model->waiting.push_back(its);
}

void Construct::couple_waiting(Model& model)
{
    std::vector<Mimic> still;
    for (const Mimic& mimic : model.waiting) {
        const auto follower = mimic.follower.lock();
        if (!follower || follower->is_removed) continue;
        const Joint* const leader = find_joint(model, mimic.leader);
        if (!leader)
            still.push_back(mimic);
        else if (mimic.leader_axis >= degrees_of(*leader) || mimic.follower_axis >= degrees_of(*follower) ||
                 leader == follower.get() || !couple(*follower, *leader, mimic))
            refuse(model, follower->name, "it cannot follow joint '" + mimic.leader + "'");
    }
    model.waiting = still;
}

}  // namespace epode::gazebo
