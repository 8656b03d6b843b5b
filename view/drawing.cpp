// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Simple shapes go to the renderer as what they are, the others as triangles. A plane that lies flat is the
// floor; others are shown as a square.
#include "view/drawing.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "view/overlays.h"
#include "view/session/islands.h"
#include "view/session/live.h"

namespace epode::view {

namespace {

using record::ShapeKind;
using viewer::Color;

constexpr double kPlaneReach = 20;

Color mixed(Color a, Color b, float part)
{
    return {a.r + part * (b.r - a.r), a.g + part * (b.g - a.g), a.b + part * (b.b - a.b)};
}

void rotation(const Turn& q, double (&r)[3][3])
{
    const Vec columns[3] = {scenes::rotate(q, scenes::kX), scenes::rotate(q, scenes::kY),
                            scenes::rotate(q, scenes::kZ)};
    for (int k = 0; k < 3; ++k) {
        r[0][k] = columns[k].x;
        r[1][k] = columns[k].y;
        r[2][k] = columns[k].z;
    }
}

void set_pose(viewer::Shape& shape, const record::Pose& pose)
{
    double r[3][3];
    rotation(turn_of(pose.turn), r);
    for (int i = 0; i < 3; ++i) {
        shape.pos[i] = float(pose.pos[size_t(i)]);
        for (int k = 0; k < 3; ++k) shape.rot[4 * i + k] = float(r[i][k]);
    }
}

bool simple(const record::Shape& from, viewer::Shape& to)
{
    for (int i = 0; i < 3; ++i) to.size[i] = float(from.size[size_t(i)]);
    switch (from.kind) {
        case ShapeKind::kSphere:
            to.kind = viewer::ShapeKind::kSphere;
            return true;
        case ShapeKind::kBox:
            to.kind = viewer::ShapeKind::kBox;
            return true;
        case ShapeKind::kCapsule:
            to.kind = viewer::ShapeKind::kCapsule;
            return true;
        case ShapeKind::kCylinder:
            to.kind = viewer::ShapeKind::kCylinder;
            return true;
        default:
            return false;
    }
}

class Painter {
  public:
    Painter(const Session& session, const Moment& now, const Switches& switches, std::int32_t picked)
        : now_(now), switches_(switches), picked_(picked)
    {
        if (switches.paint == Paint::kIsland) islands_ = islands(session.stage(), now);
    }

    Color color(std::int32_t body) const
    {
        if (body == record::kNobody) return viewer::kStone;
        const auto i = size_t(body);
        Color color = base(i);
        if (switches_.pale_sleepers && switches_.paint != Paint::kSleep && now_.asleep[i])
            color = mixed(color, {0.80f, 0.80f, 0.80f}, 0.65f);
        return body == picked_ ? mixed(color, {1, 0.95f, 0.35f}, 0.75f) : color;
    }

  private:
    Color base(size_t i) const
    {
        switch (switches_.paint) {
            case Paint::kIsland:
                return viewer::body_color(islands_[i]);
            case Paint::kSleep:
                return now_.asleep[i] ? Color{0.42f, 0.50f, 0.68f} : Color{0.90f, 0.52f, 0.20f};
            case Paint::kSpeed: {
                const double v = scenes::length(vec(now_.bodies[i]->linear));
                return mixed({0.20f, 0.35f, 0.75f}, {0.92f, 0.25f, 0.12f}, float(1 - std::exp(-v / 3)));
            }
            case Paint::kBody:
                break;
        }
        return viewer::body_color(std::uint32_t(i));
    }

    const Moment& now_;
    const Switches& switches_;
    std::int32_t picked_;
    std::vector<std::uint32_t> islands_;
};

void add_triangles(const record::Surface& surface, const record::Pose& pose, Color color, bool wire,
                   viewer::Picture& picture)
{
    const Turn q = turn_of(pose.turn);
    for (size_t i = 0; i + 2 < surface.corners.size(); i += 3) {
        viewer::Triangle triangle;
        triangle.color = color;
        triangle.wire = wire;
        for (size_t k = 0; k < 3; ++k) {
            const std::uint32_t c = surface.corners[i + k];
            const Vec p = place(pose, vec(surface.points[c].data()));
            const Vec n = scenes::rotate(q, vec(surface.normals[c].data()));
            const double at[3] = {p.x, p.y, p.z}, normal[3] = {n.x, n.y, n.z};
            for (int j = 0; j < 3; ++j) {
                triangle.corners[k].pos[j] = float(at[j]);
                triangle.corners[k].normal[j] = float(normal[j]);
                triangle.corners[k].local[j] = surface.points[c][size_t(j)];
            }
        }
        picture.triangles.push_back(triangle);
    }
}

bool is_floor(const record::Shape& shape) { return shape.kind == ShapeKind::kPlane && shape.size[2] > 0.999; }

void draw_spring(const Session& session, double size, Lines& lines)
{
    Live* live = const_cast<Session&>(session).live();
    if (!live || live->grabbed() == record::kNobody) return;
    lines.line(live->hook(), live->target(), kMagenta);
    lines.cross(live->target(), 0.2 * size, kMagenta);
}

}  // namespace

bool box_around(const record::Shape& shape, const record::Pose& pose, Vec& low, Vec& high)
{
    double r[3][3], half[3] = {0, 0, 0};
    rotation(turn_of(pose.turn), r);
    switch (shape.kind) {
        case ShapeKind::kSphere:
            for (double& h : half) h = shape.size[0];
            break;
        case ShapeKind::kBox:
            for (int i = 0; i < 3; ++i) {
                for (int k = 0; k < 3; ++k) half[i] += 0.5 * std::abs(r[i][k]) * shape.size[size_t(k)];
            }
            break;
        case ShapeKind::kCapsule:
            for (int i = 0; i < 3; ++i) half[i] = shape.size[0] + 0.5 * shape.size[1] * std::abs(r[i][2]);
            break;
        case ShapeKind::kCylinder:
            for (int i = 0; i < 3; ++i)
                half[i] = 0.5 * shape.size[1] * std::abs(r[i][2]) +
                          shape.size[0] * std::sqrt(std::max(0.0, 1 - r[i][2] * r[i][2]));
            break;
        default: {
            if (shape.vertices.empty()) return false;
            const double far = std::numeric_limits<double>::infinity();
            low = {far, far, far};
            high = {-far, -far, -far};
            for (const auto& v : shape.vertices) {
                const Vec p = place(pose, vec(v));
                low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
                high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
            }
            return true;
        }
    }
    const Vec center = vec(pose.pos), reach{half[0], half[1], half[2]};
    low = center - reach;
    high = center + reach;
    return true;
}

const record::Surface& Drawing::surface(const Stage& stage, std::uint32_t shape)
{
    const auto found = surfaces_.find(shape);
    if (found != surfaces_.end()) return found->second;
    return surfaces_.emplace(shape, record::tessellate(stage.shapes()[shape], kPlaneReach)).first->second;
}

viewer::Picture Drawing::picture(const Session& session, std::int32_t picked)
{
    const Stage& stage = session.stage();
    const Moment now = session.moment();
    const Painter painter(session, now, switches, picked);
    viewer::Picture picture;
    picture.ground = false;
    picture.shadows = switches.shadows;
    picture.line_width = 2;
    picture.quality = switches.soft_light ? viewer::kFine : viewer::kQuick;
    for (const Moment::PlacedGeom& geom : now.geoms) {
        const std::uint32_t number = stage.geoms()[geom.number].shape;
        const record::Shape& shape = stage.shapes()[number];
        if (is_floor(shape)) {
            picture.ground = true;
            picture.ground_height = float(shape.size[3]);
            continue;
        }
        if (!switches.geoms) continue;
        viewer::Shape drawn;
        drawn.color = painter.color(geom.body);
        drawn.wire = switches.wireframe;
        set_pose(drawn, geom.world);
        if (simple(shape, drawn))
            picture.shapes.push_back(drawn);
        else
            add_triangles(surface(stage, number), geom.world, drawn.color, drawn.wire, picture);
    }
    Lines lines(picture.lines);
    const double size = fitting_size(stage, now);
    if (switches.body_axes) draw_body_axes(stage, now, size, lines);
    if (switches.joints || switches.joint_axes || switches.limits)
        draw_joints(session, now, switches, size, lines);
    if (switches.contacts) draw_contacts(stage, now, switches, size, lines);
    if (switches.boxes) draw_boxes(stage, now, lines);
    draw_spring(session, size, lines);
    return picture;
}

}  // namespace epode::view
