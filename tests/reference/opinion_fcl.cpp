// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// libfcl's opinion, by its own GJK and expanding polytope, or its closed forms where it has some (its other
// solver is libccd, asked by opinion_ccd). It is given shapes, read back from the geoms: a fault in how the
// library keeps their sizes would show.
#include <ode/ext.h>

#include <fcl/fcl.h>
#include <cmath>
#include <exception>
#include <memory>

#include "opinion.h"

namespace epode::reference {
namespace {

using Shape = std::shared_ptr<fcl::CollisionGeometryd>;

Shape convex_shape(dGeomID geom)
{
    std::vector<dReal> points(std::size_t(3 * dGeomConvexGetPoints(geom, nullptr, 0)));
    std::vector<unsigned> polygons(std::size_t(dGeomConvexGetPolygons(geom, nullptr, 0)));
    dGeomConvexGetPoints(geom, points.data(), int(points.size() / 3));
    dGeomConvexGetPolygons(geom, polygons.data(), int(polygons.size()));
    auto vertices = std::make_shared<std::vector<Eigen::Vector3d>>();
    for (std::size_t i = 0; i < points.size(); i += 3)
        vertices->push_back({double(points[i]), double(points[i + 1]), double(points[i + 2])});
    auto faces = std::make_shared<std::vector<int>>(polygons.begin(), polygons.end());
    return std::make_shared<fcl::Convexd>(vertices, dGeomConvexGetPlanes(geom, nullptr, 0), faces);
}

Shape shape_of(dGeomID geom)
{
    dVector3 sides;
    dReal radius, length;
    if (dGeomGetClass(geom) == dConeClass) {
        dGeomConeGetParams(geom, &radius, &length);
        return std::make_shared<fcl::Coned>(double(radius), double(length));
    }
    if (dGeomGetClass(geom) == dEllipsoidClass) {
        dGeomEllipsoidGetRadii(geom, sides);
        return std::make_shared<fcl::Ellipsoidd>(double(sides[0]), double(sides[1]), double(sides[2]));
    }
    switch (dGeomGetClass(geom)) {
        case dSphereClass:
            return std::make_shared<fcl::Sphered>(double(dGeomSphereGetRadius(geom)));
        case dBoxClass:
            dGeomBoxGetLengths(geom, sides);
            return std::make_shared<fcl::Boxd>(double(sides[0]), double(sides[1]), double(sides[2]));
        case dCapsuleClass:
            dGeomCapsuleGetParams(geom, &radius, &length);
            return std::make_shared<fcl::Capsuled>(double(radius), double(length));
        case dCylinderClass:
            dGeomCylinderGetParams(geom, &radius, &length);
            return std::make_shared<fcl::Cylinderd>(double(radius), double(length));
        default:
            return convex_shape(geom);
    }
}

// The origin of libfcl's cone is half way up, ours in its centre of mass, a quarter of the way.
double origin_above(dGeomID geom)
{
    if (dGeomGetClass(geom) != dConeClass) return 0;
    dReal radius, length;
    dGeomConeGetParams(geom, &radius, &length);
    return double(length) / 4;
}

fcl::CollisionObjectd object_of(const Solid& solid)
{
    const dReal *p = dGeomGetPosition(solid.geom()), *r = dGeomGetRotation(solid.geom());
    const double above = origin_above(solid.geom());
    fcl::Transform3d pose = fcl::Transform3d::Identity();
    for (int i = 0; i < 3; ++i) {
        pose.translation()[i] = double(p[i]) + above * double(r[4 * i + 2]);
        for (int j = 0; j < 3; ++j) pose.linear()(i, j) = double(r[4 * i + j]);
    }
    return {shape_of(solid.geom()), pose};
}

}  // namespace

Verdict fcl_opinion(const Solid& a, const Solid& b)
{
    fcl::CollisionRequestd request(8, true);
    request.gjk_solver_type = fcl::GST_INDEP;
    request.gjk_tolerance = 1e-6;
    fcl::CollisionResultd result;
    const fcl::CollisionObjectd first = object_of(a), second = object_of(b);
    try {
        fcl::collide(&first, &second, request, result);
    } catch (const std::exception&) {
        return {.meet = true, .silent = true};
    }
    Verdict verdict{.meet = result.isCollision()};
    verdict.silent = verdict.meet;
    for (std::size_t i = 0; i < result.numContacts(); ++i) {
        const fcl::Contactd& contact = result.getContact(i);
        const double depth = std::fabs(contact.penetration_depth);  // its polytope says it below zero
        if (!std::isfinite(depth) || depth < verdict.depth) continue;
        verdict.silent = false;
        verdict.depth = depth;
        verdict.way = {contact.normal[0], contact.normal[1], contact.normal[2]};
    }
    return verdict;
}

}  // namespace epode::reference
