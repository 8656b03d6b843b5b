// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A ray against a triangle: Moeller and Trumbore 1997, "Fast, minimum storage ray/triangle intersection". The
// ray is brought into the geom's frame, where the triangles stay.
#include "view/session/ray.h"

#include <cmath>

#include "record/output/tessellate.h"
#include "record/watch/lookup.h"

namespace epode::view {

namespace {

constexpr double kReach = 1e5;
constexpr double kPlaneReach = 1000;

// dQueryHit of ode/queries.h, which the headers of ODE itself do not have.
struct RawHit {
    dGeomID geom;
    dVector3 pos, normal;
    dReal distance;
    int side;
};

using RayClosest = int (*)(dSpaceID, const dReal*, const dReal*, dReal, const void*, RawHit*);

void nearest_of_pair(void* data, dGeomID a, dGeomID b)
{
    if (dGeomIsSpace(a) || dGeomIsSpace(b)) {
        dSpaceCollide2(a, b, data, &nearest_of_pair);
        return;
    }
    dContactGeom contact;
    if (dCollide(a, b, 1, &contact, sizeof contact) < 1) return;
    auto& best = *static_cast<std::optional<Met>*>(data);
    const dGeomID other = dGeomGetClass(a) == dRayClass ? b : a;
    if (!best || double(contact.depth) < best->distance)
        best = Met{other,
                   {double(contact.pos[0]), double(contact.pos[1]), double(contact.pos[2])},
                   double(contact.depth)};
}

std::optional<Met> by_ray_geom(dSpaceID space, Vec origin, Vec direction)
{
    std::optional<Met> best;
    dGeomID ray = dCreateRay(nullptr, dReal(kReach));
    dGeomRaySet(ray, dReal(origin.x), dReal(origin.y), dReal(origin.z), dReal(direction.x),
                dReal(direction.y), dReal(direction.z));
    dSpaceCollide2(ray, dGeomID(space), &best, &nearest_of_pair);
    dGeomDestroy(ray);
    return best;
}

Vec point(const std::array<float, 3>& p) { return {double(p[0]), double(p[1]), double(p[2])}; }

// Distance along the direction; below 0: missed.
double to_triangle(Vec origin, Vec direction, Vec a, Vec b, Vec c)
{
    const Vec ab = b - a, ac = c - a, p = scenes::cross(direction, ac);
    const double det = scenes::dot(ab, p);
    if (std::abs(det) < 1e-300) return -1;
    const Vec t = origin - a;
    const double u = scenes::dot(t, p) / det;
    if (!(u >= 0 && u <= 1)) return -1;
    const Vec q = scenes::cross(t, ab);
    const double v = scenes::dot(direction, q) / det;
    return v >= 0 && u + v <= 1 ? scenes::dot(ac, q) / det : -1;
}

}  // namespace

std::optional<Met> closest_geom(dSpaceID space, Vec origin, Vec direction)
{
    static const auto closest = reinterpret_cast<RayClosest>(record::library_function("dSpaceRayClosest"));
    if (!closest) return by_ray_geom(space, origin, direction);
    const dVector3 from = {dReal(origin.x), dReal(origin.y), dReal(origin.z)};
    const dVector3 along = {dReal(direction.x), dReal(direction.y), dReal(direction.z)};
    RawHit hit{};
    if (!closest(space, from, along, dReal(kReach), nullptr, &hit)) return std::nullopt;
    return Met{hit.geom, {double(hit.pos[0]), double(hit.pos[1]), double(hit.pos[2])}, double(hit.distance)};
}

std::optional<Hit> closest_triangle(const Stage& stage, const Moment& now, Vec origin, Vec direction)
{
    std::optional<Hit> best;
    std::vector<record::Surface> surfaces(stage.shapes().size());
    std::vector<bool> made(stage.shapes().size(), false);
    const Vec unit = (1 / scenes::length(direction)) * direction;
    for (const Moment::PlacedGeom& geom : now.geoms) {
        const std::uint32_t shape = stage.geoms()[geom.number].shape;
        if (!made[shape]) surfaces[shape] = record::tessellate(stage.shapes()[shape], kPlaneReach);
        made[shape] = true;
        const Turn back = scenes::inverse(turn_of(geom.world.turn));
        const Vec from = scenes::rotate(back, origin - vec(geom.world.pos)),
                  along = scenes::rotate(back, unit);
        const record::Surface& surface = surfaces[shape];
        for (size_t i = 0; i + 2 < surface.corners.size(); i += 3) {
            const double d = to_triangle(from, along, point(surface.points[surface.corners[i]]),
                                         point(surface.points[surface.corners[i + 1]]),
                                         point(surface.points[surface.corners[i + 2]]));
            if (d > 0 && (!best || d < best->distance))
                best = Hit{geom.number, geom.body, origin + d * unit, d};
        }
    }
    return best;
}

}  // namespace epode::view
