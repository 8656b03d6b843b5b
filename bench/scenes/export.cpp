// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See export.h. Numbers are written with 9 digits, more than a peer's float holds. Quaternions are w, x, y,
// z.
#include "bench/scenes/export.h"

#include <fmt/format.h>

namespace epode::bench {

namespace {

const char* name_of(ShapeKind kind)
{
    switch (kind) {
        case ShapeKind::kSphere:
            return "sphere";
        case ShapeKind::kBox:
            return "box";
        case ShapeKind::kCapsule:
            return "capsule";
        case ShapeKind::kCylinder:
            return "cylinder";
        case ShapeKind::kHull:
            return "hull";
        case ShapeKind::kMesh:
            break;
    }
    return "mesh";
}

const char* name_of(Motion motion)
{
    return motion == Motion::kFixed ? "static" : motion == Motion::kDynamic ? "dynamic" : "driven";
}

const char* name_of(JointKind kind)
{
    return kind == JointKind::kBall ? "ball" : kind == JointKind::kHinge ? "hinge" : "hinge2";
}

const char* name_of(Task task)
{
    return task == Task::kSimulate ? "simulate" : task == Task::kRays ? "rays" : "broad_phase";
}

std::string text(double x) { return fmt::format("{:.9g}", x); }
std::string text(Vec v) { return fmt::format("[{:.9g},{:.9g},{:.9g}]", v.x, v.y, v.z); }
std::string text(Turn q) { return fmt::format("[{:.9g},{:.9g},{:.9g},{:.9g}]", q.w, q.x, q.y, q.z); }
std::string text(const std::array<int, 3>& t) { return fmt::format("[{},{},{}]", t[0], t[1], t[2]); }

std::string text(const ShapeData& shape);
std::string text(const PartData& part);
std::string text(const BodyData& body);
std::string text(const JointData& joint);
std::string text(const RayData& ray) { return fmt::format("[{},{}]", text(ray.from), text(ray.to)); }

template <class T>
std::string text(const std::vector<T>& list)
{
    std::string all(1, '[');
    for (const T& item : list) {
        if (all.size() > 1) all.push_back(',');
        all.append(text(item));
    }
    all.push_back(']');
    return all;
}

std::string text(const ShapeData& shape)
{
    return fmt::format("{{\"kind\":\"{}\",\"size\":{},\"points\":{},\"triangles\":{}}}", name_of(shape.kind),
                       text(shape.size), text(shape.points), text(shape.triangles));
}

std::string text(const PartData& part)
{
    return fmt::format("{{\"shape\":{},\"offset\":{},\"turn\":{}}}", part.shape, text(part.offset),
                       text(part.turn));
}

std::string text(const BodyData& body)
{
    std::string all = fmt::format(
        "{{\"motion\":\"{}\",\"parts\":{},\"mass\":{},\"inertia\":{},\"pos\":{},\"turn\":{},\"linear\":{},"
        "\"angular\":{},\"collides\":{},\"group\":{}",
        name_of(body.motion), text(body.parts), text(body.mass), text(body.inertia), text(body.pos),
        text(body.turn), text(body.linear), text(body.angular), body.collides, body.group);
    if (body.motion == Motion::kDriven) {
        all += fmt::format(",\"drive\":{{\"spin\":{},\"axis_point\":{},\"orbit\":{}}}", text(body.drive.spin),
                           text(body.drive.axis_point), text(body.drive.orbit));
    }
    all.push_back('}');
    return all;
}

std::string text(const JointData& joint)
{
    return fmt::format(
        "{{\"kind\":\"{}\",\"body1\":{},\"body2\":{},\"anchor\":{},\"axis1\":{},\"axis2\":{},\"low\":{},"
        "\"high\":{},\"stiffness\":{},\"damping\":{},\"speed\":{},\"torque\":{}}}",
        name_of(joint.kind), joint.body1, joint.body2, text(joint.anchor), text(joint.axis1),
        text(joint.axis2), text(joint.low), text(joint.high), text(joint.stiffness), text(joint.damping),
        text(joint.speed), text(joint.torque));
}

}  // namespace

std::string to_json(const SceneData& s)
{
    return fmt::format(
        "{{\"name\":\"{}\",\"size\":{},\"task\":\"{}\",\"steps\":{},\"dt\":{:.17g},\"gravity\":{},"
        "\"friction\":{},"
        "\"cube_side\":{},\n\"shapes\":{},\n\"bodies\":{},\n\"joints\":{},\n\"rays\":{}}}\n",
        s.name, s.size, name_of(s.task), s.steps, s.dt, text(s.gravity), text(s.friction), text(s.cube_side),
        text(s.shapes), text(s.bodies), text(s.joints), text(s.rays));
}

}  // namespace epode::bench
