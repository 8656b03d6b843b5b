// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The contract of dCollide apart from geometry: which geom a contact names first, sides, capacity for contacts,
// geoms of one body, a geom with itself, disabled geoms, spaces as arguments, and the info mode of
// transforms.
#include <algorithm>

#include "geoms.h"

namespace parity {
namespace {

constexpr std::size_t kCapacity = 32;

// Two geoms whose centres are close together, so that every pair that can touch does.
void put_fields(Output& out, Random& random, Kind first, Kind second)
{
    const Placed a = make_geom(first, nullptr, random), b = make_geom(second, nullptr, random);
    place_geom(a, first, {0, 0, 0}, random);
    place_geom(b, second, {0.15, 0.1, -0.12}, random);
    std::array<dContactGeom, kCapacity> contacts = {};
    for (const int capacity : {1, 2, 5}) {
        const int count = dCollide(a.geom, b.geom, capacity, contacts.data(), sizeof(dContactGeom));
        const dContactGeom& c = contacts[0];
        const bool hit = count > 0;
        const double in_capacity = count <= capacity ? 1 : 0;
        const auto owner = [&](dGeomID geom, const Placed& placed, Kind kind) {
            const bool inner = kind == Kind::kTransform && geom == dGeomTransformGetGeom(placed.geom);
            return !hit ? 0.0 : geom == placed.geom ? 1.0 : inner ? 2.0 : -1.0;
        };
        out.put(std::string(kind_name(first)) + "-" + kind_name(second) + "-" + std::to_string(capacity),
                {hit ? 1.0 : 0.0, in_capacity, owner(c.g1, a, first), owner(c.g2, b, second),
                 hit ? static_cast<double>(c.side1) : 0.0, hit ? static_cast<double>(c.side2) : 0.0});
    }
    dGeomDestroy(a.geom);
    dGeomDestroy(b.geom);
}

PARITY_CASE(geom_contact_fields)
{
    for (const Kind first : kKinds) {
        for (const Kind second : kKinds) { put_fields(out, rng, first, second); }
    }
}

double count_of(dGeomID a, dGeomID b, int flags)
{
    std::array<dContactGeom, kCapacity> contacts = {};
    return dCollide(a, b, flags, contacts.data(), sizeof(dContactGeom));
}

PARITY_CASE(geom_collide_rules)
{
    const dWorldID world = dWorldCreate();
    const dBodyID body = dBodyCreate(world);
    const dSpaceID space = dSimpleSpaceCreate(nullptr), other = dHashSpaceCreate(nullptr);
    const dGeomID a = dCreateSphere(space, 1), b = dCreateSphere(space, 1), c = dCreateSphere(other, 1);
    dGeomSetPosition(b, 0.5, 0, 0);
    dGeomSetPosition(c, 0, 0.5, 0);
    const int unimportant = static_cast<int>(CONTACTS_UNIMPORTANT | 4u);
    out.put("same-geom", {count_of(a, a, 4)});
    out.put("pair", {count_of(a, b, 4), count_of(a, b, unimportant)});
    dGeomDisable(a);
    out.put("disabled", {count_of(a, b, 4)});
    dGeomEnable(a);
    dGeomSetCollideBits(a, 0);
    dGeomSetCategoryBits(a, 0);
    out.put("bits", {count_of(a, b, 4)});
    dGeomSetCollideBits(a, ~0ul);
    dGeomSetCategoryBits(a, ~0ul);
    const dGeomID first = reinterpret_cast<dGeomID>(space), second = reinterpret_cast<dGeomID>(other);
    out.put("spaces", {count_of(first, second, 8), count_of(second, first, 8), count_of(first, second, 1),
                       count_of(first, c, 8), count_of(c, first, 8), count_of(first, first, 8)});
    dGeomSetBody(a, body);
    dGeomSetBody(b, body);
    dGeomSetOffsetPosition(b, 0.5, 0, 0);
    out.put("same-body", {count_of(a, b, 4)});
    dSpaceDestroy(space);
    dSpaceDestroy(other);
    dWorldDestroy(world);
}

PARITY_CASE(geom_transform_info)
{
    const dGeomID transform = dCreateGeomTransform(nullptr), inner = dCreateSphere(nullptr, 0.5);
    const dGeomID plane = dCreatePlane(nullptr, 0, 0, 1, 0);
    std::array<dContactGeom, kCapacity> contacts = {};
    dGeomTransformSetCleanup(transform, 1);
    out.put("empty", {count_of(transform, plane, 4)});
    dGeomSetPosition(inner, 1, 0, 0);
    dGeomTransformSetGeom(transform, inner);
    dGeomSetPosition(transform, 0, 0, 0.4);
    for (int info = 0; info < 2; ++info) {
        dGeomTransformSetInfo(transform, info);
        const int count = dCollide(transform, plane, 4, contacts.data(), sizeof(dContactGeom));
        const dContactGeom& c = contacts[0];
        out.put("info" + std::to_string(info),
                {static_cast<double>(count), c.pos[0], c.pos[1], c.pos[2], c.normal[2], c.depth,
                 c.g1 == transform ? 1.0
                 : c.g1 == inner   ? 2.0
                                   : 0.0});
    }
    out.put("modes", {static_cast<double>(dGeomTransformGetInfo(transform)),
                      static_cast<double>(dGeomTransformGetCleanup(transform))});
    dGeomDestroy(transform);
    dGeomDestroy(plane);
}

}  // namespace
}  // namespace parity
