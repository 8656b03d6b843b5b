// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Geoms become shapes, of convex solids without one and of surfaces triangles; one colour per body, static ones in stone;
// joints become lines from anchor to body centres. Corners of triangles are shaded by the mean normal of
// those there that face much the same way. Planes other than the floor z = h are not drawn: they have no end.
#include "cli/picture.h"

#ifdef EPODE_HAVE_VIEWER

#include <array>
#include <cmath>
#include <cstdint>
#include <map>

#include "record/watch/shapes.h"
#include "scenes/extensions.h"
#include "viewer/picture.h"

namespace epode::cli {

namespace {

using viewer::Line;
using viewer::Picture;
using viewer::Shape;
using viewer::ShapeKind;

bool set_size(dGeomID geom, Shape& shape)
{
    dVector3 sides;
    dReal radius = 0, length = 0;
    switch (dGeomGetClass(geom)) {
        case dSphereClass:
            shape.kind = ShapeKind::kSphere;
            shape.size[0] = float(dGeomSphereGetRadius(geom));
            return true;
        case dBoxClass:
            shape.kind = ShapeKind::kBox;
            dGeomBoxGetLengths(geom, sides);
            for (int i = 0; i < 3; ++i) shape.size[i] = float(sides[i]);
            return true;
        case dCapsuleClass:
            shape.kind = ShapeKind::kCapsule;
            dGeomCapsuleGetParams(geom, &radius, &length);
            break;
        case dCylinderClass:
            shape.kind = ShapeKind::kCylinder;
            dGeomCylinderGetParams(geom, &radius, &length);
            break;
        default:
            return false;
    }
    shape.size[0] = float(radius);
    shape.size[1] = float(length);
    return true;
}

using Point = std::array<float, 3>;

bool is_surface(dGeomID geom)
{
    return dGeomGetClass(geom) == dHeightfieldClass || dGeomGetClass(geom) == dTriMeshClass;
}

// Nine numbers for each triangle.
std::vector<dReal> surface_triangles(dGeomID geom)
{
    const record::Shape shape = record::shape_of(geom);
    std::vector<dReal> out;
    for (const auto& triangle : shape.triangles)
        for (const std::uint32_t corner : triangle)
            for (const double x : shape.vertices[corner]) out.push_back(dReal(x));
    return out;
}

// The geom's triangles in its own frame, with their normals.
std::vector<viewer::Triangle> solid_triangles(dGeomID geom)
{
    const std::vector<dReal> reals = is_surface(geom) ? surface_triangles(geom) : scenes::triangles_of(geom);
    std::vector<viewer::Triangle> out(reals.size() / 9);
    std::map<Point, std::vector<Point>> normals_at;
    const auto place = [&](size_t t, size_t k) {
        const dReal* p = &reals[9 * t + 3 * k];
        return Point{float(p[0]), float(p[1]), float(p[2])};
    };
    std::vector<Point> own(out.size());
    for (size_t t = 0; t < out.size(); ++t) {
        const Point a = place(t, 0), b = place(t, 1), c = place(t, 2);
        float u[3], v[3];
        for (size_t i = 0; i < 3; ++i) u[i] = b[i] - a[i], v[i] = c[i] - a[i];
        Point n{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
        const float size = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
        for (float& x : n) x /= size;
        own[t] = n;
        for (size_t k = 0; k < 3; ++k) normals_at[place(t, k)].push_back(n);
    }
    for (size_t t = 0; t < out.size(); ++t)
        for (size_t k = 0; k < 3; ++k) {
            Point mean{};
            for (const Point& n : normals_at[place(t, k)])
                if (n[0] * own[t][0] + n[1] * own[t][1] + n[2] * own[t][2] > 0.8f)
                    for (size_t i = 0; i < 3; ++i) mean[i] += n[i];
            const float size = std::sqrt(mean[0] * mean[0] + mean[1] * mean[1] + mean[2] * mean[2]);
            viewer::Corner& corner = out[t].corners[k];
            for (size_t i = 0; i < 3; ++i) {
                corner.pos[i] = place(t, k)[i];
                corner.normal[i] = mean[i] / size;
            }
        }
    return out;
}

void add_triangles(dGeomID geom, viewer::Color color, Picture& picture)
{
    const dReal *p = dGeomGetPosition(geom), *R = dGeomGetRotation(geom);
    for (viewer::Triangle t : solid_triangles(geom)) {
        t.color = color;
        for (viewer::Corner& corner : t.corners) {
            const viewer::Corner own = corner;
            for (int i = 0; i < 3; ++i) {
                corner.pos[i] = float(p[i]), corner.normal[i] = 0;
                for (int k = 0; k < 3; ++k) {
                    corner.pos[i] += float(R[4 * i + k]) * own.pos[k];
                    corner.normal[i] += float(R[4 * i + k]) * own.normal[k];
                }
            }
        }
        picture.triangles.push_back(t);
    }
}

bool is_convex_beyond_odes(dGeomID geom)
{
    return dGeomGetClass(geom) == dConvexClass || dGeomGetClass(geom) >= dGeomNumClasses;
}

void add_shapes(const scenes::Scene& scene, Picture& picture)
{
    std::map<dBodyID, std::uint32_t> number;
    for (size_t i = 0; i < scene.bodies().size(); ++i) number[scene.bodies()[i]] = std::uint32_t(i);
    picture.ground = false;
    for (dGeomID geom : scene.geoms()) {
        if (dGeomGetClass(geom) == dPlaneClass) {
            dVector4 plane;
            dGeomPlaneGetParams(geom, plane);
            picture.ground = picture.ground || plane[2] > dReal(0.999);
            picture.ground_height = float(plane[3]);
            continue;
        }
        dBodyID body = dGeomGetBody(geom);
        Shape shape;
        shape.color = body ? viewer::body_color(number[body]) : viewer::kStone;
        if (is_convex_beyond_odes(geom) || is_surface(geom)) add_triangles(geom, shape.color, picture);
        if (!set_size(geom, shape)) continue;
        viewer::set_pose(shape, dGeomGetPosition(geom), dGeomGetRotation(geom));
        picture.shapes.push_back(shape);
    }
}

bool anchor_of(dJointID joint, dVector3 anchor)
{
    switch (dJointGetType(joint)) {
        case dJointTypeBall:
            dJointGetBallAnchor(joint, anchor);
            return true;
        case dJointTypeHinge:
            dJointGetHingeAnchor(joint, anchor);
            return true;
        case dJointTypeUniversal:
            dJointGetUniversalAnchor(joint, anchor);
            return true;
        case dJointTypeHinge2:
            dJointGetHinge2Anchor(joint, anchor);
            return true;
        default:
            return false;
    }
}

void add_lines(const scenes::Scene& scene, Picture& picture)
{
    for (const scenes::JointRecord& record : scene.joints()) {
        dVector3 anchor;
        if (!anchor_of(record.joint, anchor)) continue;
        for (int i = 0; i < 2; ++i) {
            dBodyID body = dJointGetBody(record.joint, i);
            if (!body) continue;
            Line line;
            const dReal* pos = dBodyGetPosition(body);
            for (int k = 0; k < 3; ++k) line.a[k] = float(anchor[k]), line.b[k] = float(pos[k]);
            picture.lines.push_back(line);
        }
    }
}

void set_camera(const scenes::Scene& scene, Picture& picture)
{
    const float aspect = float(picture.width) / float(picture.height);
    if (!scene.view.set) {
        picture.camera = viewer::frame_shapes(picture.shapes, aspect);
        return;
    }
    const dReal* follow = scene.view.follow ? dBodyGetPosition(scene.view.follow) : nullptr;
    for (int i = 0; i < 3; ++i) {
        const double shift = follow && i < 2 && std::isfinite(follow[i]) ? follow[i] : 0;
        picture.camera.eye[i] = float(scene.view.eye[i] + shift);
        picture.camera.target[i] = float(scene.view.target[i] + shift);
    }
}

}  // namespace

bool can_draw() { return true; }

void draw_scene(const scenes::Scene& scene, Picture& picture)
{
    add_shapes(scene, picture);
    add_lines(scene, picture);
    set_camera(scene, picture);
}

bool save_picture(const scenes::Scene& scene, const std::string& path, std::string& problem)
{
    Picture picture;
    draw_scene(scene, picture);
    return viewer::write_png(picture, path.c_str(), problem);
}

}  // namespace epode::cli

#else

namespace epode::cli {

bool can_draw() { return false; }

bool save_picture(const scenes::Scene&, const std::string&, std::string& problem)
{
    problem = "this build has no viewer";
    return false;
}

}  // namespace epode::cli

#endif
