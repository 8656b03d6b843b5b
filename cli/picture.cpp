// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Geoms become shapes, one colour per body, static ones in stone; joints become lines from anchor to body
// centres. Planes other than the floor z = h are not drawn: they have no end.
#include "cli/picture.h"

#ifdef EPODE_HAVE_VIEWER

#include <cmath>
#include <cstdint>
#include <map>

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
        Shape shape;
        if (!set_size(geom, shape)) continue;
        dBodyID body = dGeomGetBody(geom);
        shape.color = body ? viewer::body_color(number[body]) : viewer::kStone;
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
