// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See hull.h. Whether points have a hull is decided before the library is asked, which would send a message.
#include "robots/parts/hull.h"

#include <ode/ext.h>

#include <algorithm>

namespace epode::robots {

namespace {

constexpr double kFlat = sizeof(dReal) == 8 ? 4e-6 : 4e-5;  // of the extent

// Not all in one plane: by the farthest point from the first, from their line, and from their plane.
bool is_solid(const std::vector<Vec>& points)
{
    if (points.size() < 4 || !std::all_of(points.begin(), points.end(), [](Vec v) { return is_finite(v); }))
        return false;
    const auto farthest = [&](auto&& distance) {
        return *std::max_element(points.begin(), points.end(),
                                 [&](Vec a, Vec b) { return distance(a) < distance(b); });
    };
    const Vec a = points[0], b = farthest([&](Vec p) { return length(p - a); });
    const double extent = length(b - a);
    if (!(extent > 0)) return false;
    const Vec along = (1 / extent) * (b - a),
              c = farthest([&](Vec p) { return length(cross(along, p - a)); });
    const Vec across = cross(along, c - a);
    if (!(length(across) > kFlat * extent)) return false;
    const Vec normal = (1 / length(across)) * across;
    const Vec d = farthest([&](Vec p) { return std::fabs(dot(normal, p - a)); });
    return std::fabs(dot(normal, d - a)) > kFlat * extent;
}

double volume_of(dGeomID geom)
{
    dMass mass;
    dMassSetConvex(&mass, 1, geom);
    return double(mass.mass);
}

}  // namespace

std::vector<Vec> Hull::corners() const
{
    std::vector<Vec> out(points.size() / 3);
    for (size_t i = 0; i < out.size(); ++i)
        out[i] = {double(points[3 * i]), double(points[3 * i + 1]), double(points[3 * i + 2])};
    return out;
}

double Hull::height(Vec p) const
{
    double out = -HUGE_VAL;
    for (size_t i = 0; i + 4 <= planes.size(); i += 4)
        out = std::max(out, double(planes[i]) * p.x + double(planes[i + 1]) * p.y +
                                double(planes[i + 2]) * p.z - double(planes[i + 3]));
    return out;
}

Hull hull_of(const std::vector<Vec>& points, unsigned max_vertices)
{
    Hull hull;
    if (!is_solid(points)) return hull;
    std::vector<dReal> reals;
    reals.reserve(3 * points.size());
    for (Vec p : points) reals.insert(reals.end(), {dReal(p.x), dReal(p.y), dReal(p.z)});
    const dGeomID geom = dCreateConvexHull(nullptr, reals.data(), unsigned(points.size()), max_vertices);
    if (!geom) return hull;
    hull.points.resize(3 * size_t(dGeomConvexGetPoints(geom, nullptr, 0)));
    hull.planes.resize(4 * size_t(dGeomConvexGetPlanes(geom, nullptr, 0)));
    hull.polygons.resize(size_t(dGeomConvexGetPolygons(geom, nullptr, 0)));
    dGeomConvexGetPoints(geom, hull.points.data(), int(hull.points.size() / 3));
    dGeomConvexGetPlanes(geom, hull.planes.data(), int(hull.planes.size() / 4));
    dGeomConvexGetPolygons(geom, hull.polygons.data(), int(hull.polygons.size()));
    hull.volume = volume_of(geom);
    dGeomDestroy(geom);
    return hull;
}

}  // namespace epode::robots
