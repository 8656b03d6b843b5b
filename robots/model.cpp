// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See model.h.
#include "robots/model.h"

#include <algorithm>

namespace epode::robots {

namespace {

Quat quat_at(const double* q) { return normalised({q[0], q[1], q[2], q[3]}); }

// J(q) of the head of model.h; of a free joint, the pose in the world.
Pose motion_of(const Joint& joint, const double* q)
{
    switch (joint.kind) {
        case JointKind::kHinge: {
            const Quat r = turn(joint.axis, q[0] - joint.reference);
            return {joint.anchor - rotate(r, joint.anchor), r};
        }
        case JointKind::kSlide:
            return {(q[0] - joint.reference) * joint.axis, {}};
        case JointKind::kBall: {
            const Quat r = quat_at(q);
            return {joint.anchor - rotate(r, joint.anchor), r};
        }
        case JointKind::kFree:
            return {{q[0], q[1], q[2]}, quat_at(q + 3)};
    }
    return {};
}

template <class Named>
int index_of(const std::vector<Named>& list, const std::string& name)
{
    const auto found = std::find_if(list.begin(), list.end(), [&](const Named& n) { return n.name == name; });
    return found == list.end() ? -1 : int(found - list.begin());
}

}  // namespace

const char* name_of(ShapeKind kind)
{
    constexpr const char* names[] = {"sphere", "box",  "capsule",   "cylinder",    "ellipsoid",
                                     "plane",  "hull", "triangles", "height field"};
    return names[int(kind)];
}

const char* name_of(JointKind kind)
{
    constexpr const char* names[] = {"hinge", "slide", "ball", "free"};
    return names[int(kind)];
}

const char* name_of(Note note)
{
    constexpr const char* names[] = {"changed", "approximated", "ignored", "error"};
    return names[int(note)];
}

std::vector<int> RobotModel::mocap_links() const
{
    std::vector<int> out;
    for (size_t i = 0; i < links.size(); ++i)
        if (links[i].is_mocap) out.push_back(int(i));
    return out;
}

int RobotModel::link_named(const std::string& wanted) const
{
    const int link = index_of(links, wanted);
    if (link >= 0) return link;
    const int frame = index_of(frames, wanted);
    return frame < 0 ? -1 : frames[size_t(frame)].link;
}

bool RobotModel::frame_named(const std::string& wanted, Frame& frame) const
{
    const int link = index_of(links, wanted), other = index_of(frames, wanted);
    if (link < 0 && other < 0) return false;
    frame = link >= 0 ? Frame{wanted, link, {}} : frames[size_t(other)];
    return true;
}

bool RobotModel::object_named(const std::string& type, const std::string& wanted, Frame& frame) const
{
    const int site = type == "site" ? index_of(frames, wanted) : -1;
    if (site >= 0) return frame = frames[size_t(site)], true;
    if (!frame_named(wanted, frame)) return false;
    if (type == "body" && index_of(links, wanted) >= 0) frame.pose.p = links[size_t(frame.link)].centre;
    return true;
}

const Shape* RobotModel::any_shape_named(const std::string& wanted, int& link) const
{
    for (link = 0; link < int(links.size()); ++link)
        for (const auto* shapes : {&links[size_t(link)].shapes, &links[size_t(link)].visuals})
            for (const Shape& shape : *shapes)
                if (!wanted.empty() && shape.name == wanted) return &shape;
    return nullptr;
}

int RobotModel::joint_named(const std::string& wanted) const { return index_of(joints, wanted); }
int RobotModel::tendon_named(const std::string& wanted) const { return index_of(tendons, wanted); }
int RobotModel::actuator_named(const std::string& wanted) const { return index_of(actuators, wanted); }

bool RobotModel::has_errors() const
{
    return std::any_of(report.begin(), report.end(),
                       [](const ReportLine& line) { return line.note == Note::kError; });
}

void number_coordinates(RobotModel& model)
{
    model.coordinates = 0;
    for (Joint& joint : model.joints) {
        joint.position = model.coordinates;
        model.coordinates += joint.coordinates();
    }
}

std::vector<double> reference_positions(const RobotModel& model)
{
    std::vector<double> q(size_t(model.coordinates), 0);
    std::vector<Pose> poses(model.links.size());
    for (size_t i = 1; i < model.links.size(); ++i) {
        const Link& link = model.links[i];
        poses[i] = poses[size_t(link.parent)] * link.pose;
    }
    for (const Joint& joint : model.joints) {
        double* its = &q[size_t(joint.position)];
        if (joint.is_scalar()) its[0] = joint.reference;
        if (joint.kind == JointKind::kBall) its[0] = 1;
        if (joint.kind != JointKind::kFree) continue;
        const Pose& pose = poses[size_t(joint.link)];
        const double values[7] = {pose.p.x, pose.p.y, pose.p.z, pose.q.w, pose.q.x, pose.q.y, pose.q.z};
        std::copy_n(values, 7, its);
    }
    return q;
}

Pose moved_by(const Joint& joint, const Pose& pose, const std::vector<double>& positions)
{
    const Pose motion = motion_of(joint, &positions[size_t(joint.position)]);
    return joint.kind == JointKind::kFree ? motion : pose * motion;
}

std::vector<Pose> forward_kinematics(const RobotModel& model, const std::vector<double>& positions)
{
    std::vector<Pose> poses(model.links.size());
    for (size_t i = 1; i < model.links.size(); ++i) {
        const Link& link = model.links[i];
        Pose pose = poses[size_t(link.parent)] * link.pose;
        for (int number : link.joints) pose = moved_by(model.joints[size_t(number)], pose, positions);
        pose.q = normalised(pose.q);
        poses[i] = pose;
    }
    return poses;
}

}  // namespace epode::robots
