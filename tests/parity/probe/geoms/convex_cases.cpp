// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Convex geoms beyond the random pairs: rays at right angles to a face, from outside, inside and too short,
// which the original gets right (differences.tsv, C29); and another shape given by dGeomSetConvex, of which
// the geom is moved afterwards, since the original does not look at its bounding box again before that.
#include "geoms.h"

namespace parity {
namespace {

void put_contacts(Output& out, const std::string& key, dGeomID a, dGeomID b)
{
    std::array<dContactGeom, 8> contacts = {};
    const int count = dCollide(a, b, 8, contacts.data(), sizeof(dContactGeom));
    const dContactGeom c = count > 0 ? contacts[0] : dContactGeom{};
    out.put(key + ".count", {static_cast<double>(count)});
    out.put(key, {c.pos[0], c.pos[1], c.pos[2], c.normal[0], c.normal[1], c.normal[2], c.depth});
}

PARITY_CASE(geom_convex_rays)
{
    for (int i = 0; i < 60; ++i) {
        out.open_block("t" + std::to_string(i));
        const Placed solid = make_geom(Kind::kConvex, nullptr, rng);
        const Vec3 at = rng.in_cube(2), aside = rng.in_cube(0.1);
        dGeomSetPosition(solid.geom, at.x, at.y, at.z);
        // The sides of a frustum lean, its ends do not; from inside the original meets the sides as well.
        const auto& points = convex_arrays(solid.geom).points;
        const int starts_tried = points[3 * 7] < points[3 * 3] ? 1 : 3;
        const double way = i % 2 == 0 ? 1 : -1, half = points[3 * 7 + 2];
        const double starts[] = {1.5 + half, 0.5 * half, 0.25 * half};
        for (int k = 0; k < starts_tried; ++k) {
            const dGeomID ray = dCreateRay(nullptr, i % 3 == 0 ? 0.05 : 5);
            dGeomRaySet(ray, at.x + aside.x, at.y + aside.y, at.z + way * starts[k], 0, 0, -way);
            put_contacts(out, "ray" + std::to_string(k), ray, solid.geom);
            put_contacts(out, "turned" + std::to_string(k), solid.geom, ray);
            dGeomDestroy(ray);
        }
        dGeomDestroy(solid.geom);
    }
}

PARITY_CASE(geom_convex_set)
{
    for (int i = 0; i < 20; ++i) {
        out.open_block("t" + std::to_string(i));
        const Placed solid = make_geom(Kind::kConvex, nullptr, rng);
        const Placed other = make_geom(Kind::kConvex, nullptr, rng);
        const ConvexArrays& arrays = convex_arrays(other.geom);
        dGeomSetConvex(solid.geom, arrays.planes.data(), 6, arrays.points.data(), 8, convex_polygons());
        place_geom(solid, Kind::kConvex, rng.in_cube(2), rng);
        dReal box[6] = {0};
        dGeomGetAABB(solid.geom, box);
        out.put("aabb", box, 6);
        const dReal* p = dGeomGetPosition(solid.geom);
        const dGeomID plane = dCreatePlane(nullptr, 0, 0, 1, p[2]);
        put_contacts(out, "plane", solid.geom, plane);
        const dGeomID ball = dCreateSphere(nullptr, 0.4);
        const Vec3 v = rng.direction();
        dGeomSetPosition(ball, p[0] + 0.6 * v.x, p[1] + 0.6 * v.y, p[2] + 0.6 * v.z);
        std::array<dContactGeom, 2> contacts = {};
        const int hit = dCollide(ball, solid.geom, 2, contacts.data(), sizeof(dContactGeom));
        out.put("sphere", {static_cast<double>(hit)});
        for (const dGeomID g : {plane, ball, solid.geom, other.geom}) { dGeomDestroy(g); }
    }
}

}  // namespace
}  // namespace parity
