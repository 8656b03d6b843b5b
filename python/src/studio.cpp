// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See studio.h.
#ifdef EPODE_HAVE_DRAWING

#include "studio.h"

#include <algorithm>
#include <cmath>

using namespace epode;
using record::Pose;
using record::ShapeKind;

namespace {

constexpr double kPlaneReach = 20;

// v turned by q = w x y z: v + 2 w (u x v) + 2 u x (u x v).
record::Vec3 turned(const record::Quat& q, const record::Vec3& v)
{
    const auto cross = [](const record::Vec3& a, const record::Vec3& b) {
        return record::Vec3{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    };
    const record::Vec3 u{q[1], q[2], q[3]}, once = cross(u, v), twice = cross(u, once);
    record::Vec3 result;
    for (size_t i = 0; i < 3; ++i) result[i] = v[i] + 2 * q[0] * once[i] + 2 * twice[i];
    return result;
}
record::Vec3 placed(const Pose& pose, const record::Vec3& v)
{
    record::Vec3 p = turned(pose.turn, v);
    for (size_t i = 0; i < 3; ++i) p[i] += pose.pos[i];
    return p;
}

viewer::Shape posed(viewer::Shape shape, const Pose& pose)
{
    const record::Vec3 columns[3] = {turned(pose.turn, {1, 0, 0}), turned(pose.turn, {0, 1, 0}),
                                     turned(pose.turn, {0, 0, 1})};
    for (size_t i = 0; i < 3; ++i) {
        shape.pos[i] = float(pose.pos[i]);
        for (size_t k = 0; k < 3; ++k) shape.rot[4 * i + k] = float(columns[k][i]);
    }
    return shape;
}

bool is_simple(const record::Shape& from, viewer::Shape& to)
{
    static const std::pair<ShapeKind, viewer::ShapeKind> kinds[] = {
        {ShapeKind::kSphere, viewer::ShapeKind::kSphere},
        {ShapeKind::kBox, viewer::ShapeKind::kBox},
        {ShapeKind::kCapsule, viewer::ShapeKind::kCapsule},
        {ShapeKind::kCylinder, viewer::ShapeKind::kCylinder}};
    std::copy_n(from.size.begin(), 3, to.size);
    for (const auto& [kind, drawn] : kinds)
        if (from.kind == kind) {
            to.kind = drawn;
            return true;
        }
    return false;
}

}  // namespace

Studio::Studio(const record::Recording& recording, size_t state) : recording_(recording), state_(state)
{
    const auto living = recording.living(state);
    poses_.resize(recording.bodies.size());
    for (size_t i = 0; i < living.size(); ++i) poses_[living[i]] = recording.steps[state].bodies[i].pose;
    picture.ground = false;
    for (std::uint32_t g = 0; g < recording.geoms.size(); ++g)
        if (recording.geom_lives[g].at(state)) add_geom(g);
    for (std::uint32_t j = 0; j < recording.joints.size(); ++j)
        if (recording.joint_lives[j].at(state)) add_joint(recording.joints[j]);
}

void Studio::add_geom(std::uint32_t number)
{
    record::Geom geom = recording_.geoms[number];
    for (const record::Move& move : recording_.moves)
        if (move.geom == number && move.step <= state_) geom.body = move.body, geom.pose = move.pose;
    const record::Shape& shape = recording_.shapes[geom.shape];
    if (shape.kind == ShapeKind::kPlane && shape.size[2] > 0.999) {
        picture.ground = true;
        picture.ground_height = float(shape.size[3]);
        return;
    }
    const bool still = geom.body == record::kNobody;
    const Pose pose = still ? geom.pose : record::compose(poses_[size_t(geom.body)], geom.pose);
    viewer::Shape drawn;
    drawn.color = still ? viewer::kStone : viewer::body_color(std::uint32_t(geom.body));
    if (is_simple(shape, drawn)) {
        picture.shapes.push_back(posed(drawn, pose));
        extents.push_back(picture.shapes.back());
    } else {
        add_triangles(record::tessellate(shape, kPlaneReach), pose, drawn.color);
    }
}

void Studio::add_triangles(const record::Surface& surface, const Pose& pose, viewer::Color color)
{
    record::Vec3 low{1e30, 1e30, 1e30}, high{-1e30, -1e30, -1e30};
    for (size_t i = 0; i + 2 < surface.corners.size(); i += 3) {
        viewer::Triangle triangle;
        triangle.color = color;
        for (size_t k = 0; k < 3; ++k) {
            const auto &p = surface.points[surface.corners[i + k]],
                       &n = surface.normals[surface.corners[i + k]];
            const record::Vec3 at = placed(pose, {p[0], p[1], p[2]}),
                               normal = turned(pose.turn, {n[0], n[1], n[2]});
            for (size_t j = 0; j < 3; ++j) {
                triangle.corners[k].pos[j] = float(at[j]);
                triangle.corners[k].normal[j] = float(normal[j]);
                low[j] = std::min(low[j], at[j]);
                high[j] = std::max(high[j], at[j]);
            }
        }
        picture.triangles.push_back(triangle);
    }
    if (surface.corners.empty()) return;
    viewer::Shape box;
    for (size_t j = 0; j < 3; ++j) {
        box.pos[j] = float((low[j] + high[j]) / 2);
        box.size[j] = std::max(float(high[j] - low[j]), 1e-3f);
    }
    extents.push_back(box);
}

void Studio::add_joint(const record::Joint& joint)
{
    for (size_t i = 0; i < 2; ++i) {
        if (!joint.has_anchor[i] || joint.body[i] == record::kNobody) continue;
        const Pose& pose = poses_[size_t(joint.body[i])];
        const record::Vec3 anchor = placed(pose, joint.anchor[i]);
        viewer::Line line;
        for (size_t k = 0; k < 3; ++k) line.a[k] = float(anchor[k]), line.b[k] = float(pose.pos[k]);
        picture.lines.push_back(line);
    }
}

#endif
