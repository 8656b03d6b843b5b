// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See links.h.
#include "integrations/gazebo/links.h"

#include <set>

#include "integrations/gazebo/convert.h"
#include "integrations/gazebo/shapes.h"

namespace epode::gazebo {

namespace {

void set_velocity(dBodyID body, Vec linear, Vec angular)
{
    dBodySetLinearVel(body, linear.x, linear.y, linear.z);
    dBodySetAngularVel(body, angular.x, angular.y, angular.z);
}

void collect(const Model& model, std::vector<Link*>& links)
{
    for (const auto& link : model.links) links.push_back(link.get());
    for (const auto& inner : model.models) collect(*inner, links);
}

bool is_held_by_world(const Joint& joint)
{
    return !joint.parent || !joint.parent->body || !joint.child->body;
}

}  // namespace

Pose pose_of(const Link& link)
{
    if (!link.body) return link.static_pose;
    const Pose body{vec_of(dBodyGetPosition(link.body)), quat_of(dBodyGetQuaternion(link.body))};
    return {body * -link.centre, body.q};
}

Motion motion_of(const Link& link)
{
    Motion motion;
    motion.pose = pose_of(link);
    if (!link.body) return motion;
    const Vec arm = rotate(motion.pose.q, -link.centre);
    motion.angular = vec_of(dBodyGetAngularVel(link.body));
    motion.linear = vec_of(dBodyGetLinearVel(link.body)) + cross(motion.angular, arm);
    motion.angular_acceleration = link.angular_acceleration;
    motion.linear_acceleration = link.linear_acceleration + cross(link.angular_acceleration, arm) +
                                 cross(motion.angular, cross(motion.angular, arm));
    return motion;
}

Motion moved_frame(const Motion& link, const Pose& frame)
{
    Motion motion = link;
    const Vec arm = rotate(link.pose.q, frame.p);
    motion.pose = link.pose * frame;
    motion.linear = link.linear + cross(link.angular, arm);
    motion.linear_acceleration = link.linear_acceleration + cross(link.angular_acceleration, arm) +
                                 cross(link.angular, cross(link.angular, arm));
    return motion;
}

Motion motion_of(const Model& model)
{
    if (model.root) return moved_frame(motion_of(*model.root), model.in_root);
    Motion motion;
    motion.pose = model.pose;
    return motion;
}

void place(Link& link, const Pose& pose)
{
    link.static_pose = pose;
    if (link.body) {
        const Vec at = pose * link.centre;
        const dReal q[4] = {pose.q.w, pose.q.x, pose.q.y, pose.q.z};
        dBodySetPosition(link.body, at.x, at.y, at.z);
        dBodySetQuaternion(link.body, q);
        dBodyEnable(link.body);
    } else {
        for (const auto& shape : link.shapes) put_geoms(*shape);
    }
}

void move_all(const std::vector<Link*>& links, const Pose& by)
{
    for (Link* link : links) place(*link, by * pose_of(*link));
}

void add_velocity(const std::vector<Link*>& links, Vec point, Vec linear, Vec angular)
{
    for (Link* link : links) {
        if (!link->body) continue;
        const Vec arm = vec_of(dBodyGetPosition(link->body)) - point;
        dBodyEnable(link->body);
        set_velocity(link->body, vec_of(dBodyGetLinearVel(link->body)) + linear + cross(angular, arm),
                     vec_of(dBodyGetAngularVel(link->body)) + angular);
    }
}

void wake(const Link& link)
{
    if (link.body) dBodyEnable(link.body);
}

Group group_of(Link& link, const Joint* through)
{
    Group group;
    std::set<Link*> known{&link};
    group.links.push_back(&link);
    group.is_held = !link.body;
    for (size_t i = 0; i < group.links.size(); ++i)
        for (const Joint* joint : group.links[i]->joints) {
            if (joint == through) continue;
            if (is_held_by_world(*joint)) group.is_held = true;
            for (Link* end : {joint->parent, joint->child})
                if (end && end->body && known.insert(end).second) group.links.push_back(end);
        }
    return group;
}

std::vector<Link*> carried_by(const Joint& joint)
{
    std::vector<Link*> links{joint.child};
    std::set<Link*> known{joint.child, joint.parent};
    for (size_t i = 0; i < links.size(); ++i)
        for (const Joint* next : links[i]->joints)
            if (next != &joint && next->parent == links[i] && next->child->body &&
                known.insert(next->child).second)
                links.push_back(next->child);
    return links;
}

Link* find_link(const Model& model, const std::string& name)
{
    const std::size_t end = name.find("::");
    if (end == std::string::npos) {
        for (const auto& link : model.links)
            if (link->name == name) return link.get();
        return nullptr;
    }
    for (const auto& inner : model.models)
        if (inner->name == name.substr(0, end)) return find_link(*inner, name.substr(end + 2));
    return nullptr;
}

std::vector<Link*> links_of(const Model& model)
{
    std::vector<Link*> links;
    collect(model, links);
    return links;
}

}  // namespace epode::gazebo
