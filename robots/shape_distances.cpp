// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See shape_distances.h.
#include "robots/shape_distances.h"

#include <ode/ext.h>

#include <algorithm>

#include "robots/body_poses.h"
#include "robots/shape_geom.h"

namespace epode::robots {

namespace {

void put_geom(dGeomID geom, const Shape& shape, const Pose& at)
{
    if (shape.kind == ShapeKind::kPlane) return put_plane(geom, at);
    const dQuaternion q = {dReal(at.q.w), dReal(at.q.x), dReal(at.q.y), dReal(at.q.z)};
    dGeomSetPosition(geom, dReal(at.p.x), dReal(at.p.y), dReal(at.p.z));
    dGeomSetQuaternion(geom, q);
}

}  // namespace

std::vector<PlacedShape> shapes_of(const RobotModel& model, const std::string& type, const std::string& name)
{
    int link = 0;
    if (type == "geom") {
        const Shape* const its = model.any_shape_named(name, link);
        return its ? std::vector<PlacedShape>{{link, its}} : std::vector<PlacedShape>{};
    }
    std::vector<PlacedShape> out;
    link = model.link_named(name);
    if (link < 0) return out;
    const Link& on = model.links[size_t(link)];
    const std::string own = on.name == name ? "" : name;
    for (const auto* shapes : {&on.shapes, &on.visuals})
        for (const Shape& shape : *shapes)
            if (shape.body == own) out.push_back({link, &shape});
    return out;
}

ShapeDistances::~ShapeDistances()
{
    for (const auto& [shape, geoms] : geoms_)
        for (dGeomID geom : geoms) dGeomDestroy(geom);
}

const std::vector<dGeomID>& ShapeDistances::geoms_of(const std::vector<Pose>& poses, const PlacedShape& its)
{
    const Shape& shape = *its.shape;
    const auto [found, is_new] = geoms_.try_emplace(its.shape);
    for (int part = 0; is_new && part < parts_of(*prepared_, shape); ++part)
        if (const dGeomID geom = make_geom(nullptr, *prepared_, shape, part)) found->second.push_back(geom);
    for (dGeomID geom : found->second) put_geom(geom, shape, poses[size_t(its.link)] * geom_pose(shape));
    return found->second;
}

ShapeDistance ShapeDistances::find(const std::vector<Pose>& poses, const std::vector<PlacedShape>& one,
                                   const std::vector<PlacedShape>& two, double cutoff)
{
    ShapeDistance out{cutoff, {}, {}};
    const auto compare = [&](dGeomID a, dGeomID b) {
        dQueryDistance its;
        if (a == b || !dGeomGetDistance(a, b, dReal(std::max(0.0, out.distance)), &its)) return;
        if (double(its.distance) < out.distance)
            out = {double(its.distance), vec_of(its.pos1), vec_of(its.pos2)};
    };
    for (const PlacedShape& first : one)
        for (const PlacedShape& second : two)
            for (dGeomID a : geoms_of(poses, first))
                for (dGeomID b : geoms_of(poses, second)) compare(a, b);
    return out;
}

}  // namespace epode::robots
