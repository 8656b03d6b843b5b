// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Which pairs a space reports: simple and hash spaces, nested ones, bits, disabled and zero-sized geoms,
// planes, geoms of one body, space against geom and space against space. Pairs are named by the geoms'
// indices and sorted, because their order is not part of the contract.
#include "geoms.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace parity {
namespace {

std::vector<std::string> reported;

int index_of(dGeomID geom) { return static_cast<int>(reinterpret_cast<std::intptr_t>(dGeomGetData(geom))); }

void note_pair(void*, dGeomID a, dGeomID b)
{
    if (a_ray_passes_by(a, b)) { return; }
    const int low = std::min(index_of(a), index_of(b)), high = std::max(index_of(a), index_of(b));
    reported.push_back(std::to_string(low) + "-" + std::to_string(high));
}

// The usual callback of clients: spaces are entered, interior pairs of spaces included.
void note_leaves(void* data, dGeomID a, dGeomID b)
{
    if (dGeomIsSpace(a) || dGeomIsSpace(b)) {
        dSpaceCollide2(a, b, data, &note_leaves);
        return;
    }
    note_pair(data, a, b);
}

std::string sorted_report()
{
    std::sort(reported.begin(), reported.end());
    std::string text = "=";
    for (const std::string& pair : reported) { text += pair + ";"; }
    reported.clear();
    return text;
}

dSpaceID make_space(int type, dSpaceID parent)
{
    if (type == 0) { return dSimpleSpaceCreate(parent); }
    const dSpaceID space = dHashSpaceCreate(parent);
    if (type == 2) { dHashSpaceSetLevels(space, -1, 2); }
    return space;
}

const char* const kTypes[] = {"simple", "hash", "hash-levels"};

constexpr Kind kMembers[] = {Kind::kSphere,   Kind::kBox, Kind::kCapsule,
                             Kind::kCylinder, Kind::kRay, Kind::kTransform};

void set_index(dGeomID geom, int index)
{
    dGeomSetData(geom, reinterpret_cast<void*>(static_cast<std::intptr_t>(index)));
}

dGeomID add_member(dSpaceID space, Random& random, int index)
{
    const Kind kind = index == 0 ? Kind::kPlane : kMembers[random.below(6)];
    const Placed placed = make_geom(kind, space, random);
    place_geom(placed, kind, random.in_cube(3), random);
    set_index(placed.geom, index);
    if (random.unit() < 0.1) { dGeomDisable(placed.geom); }
    if (random.unit() < 0.4) {
        dGeomSetCategoryBits(placed.geom, static_cast<unsigned long>(random.below(8)));
        dGeomSetCollideBits(placed.geom, static_cast<unsigned long>(random.below(8)));
    }
    return placed.geom;
}

PARITY_CASE(space_pairs)
{
    for (int type = 0; type < 3; ++type) {
        for (int trial = 0; trial < 20; ++trial) {
            out.open_block(std::string(kTypes[type]) + "/t" + std::to_string(trial));
            const dSpaceID space = make_space(type, nullptr);
            std::vector<dGeomID> geoms;
            for (int i = 0; i < 25; ++i) { geoms.push_back(add_member(space, rng, i)); }
            dSpaceCollide(space, nullptr, &note_pair);
            out.put_text("pairs", sorted_report());
            for (int i = 1; i < 25; i += 3) {
                const Vec3 p = rng.in_cube(3);
                dGeomSetPosition(geoms[static_cast<std::size_t>(i)], p.x, p.y, p.z);
            }
            dSpaceRemove(space, geoms[5]);
            dSpaceCollide(space, nullptr, &note_pair);
            out.put_text("moved", sorted_report());
            dSpaceCollide2(geoms[5], reinterpret_cast<dGeomID>(space), nullptr, &note_pair);
            out.put_text("geom-space", sorted_report());
            out.put("size", {static_cast<double>(dSpaceGetNumGeoms(space)),
                             static_cast<double>(dSpaceQuery(space, geoms[5])),
                             static_cast<double>(dSpaceQuery(space, geoms[6]))});
            dGeomDestroy(geoms[5]);
            dSpaceDestroy(space);
        }
    }
}

PARITY_CASE(space_nested)
{
    for (int type = 0; type < 3; ++type) {
        for (int trial = 0; trial < 20; ++trial) {
            out.open_block(std::string(kTypes[type]) + "/t" + std::to_string(trial));
            const dSpaceID top = make_space(type, nullptr);
            const dSpaceID left = make_space((type + 1) % 3, top), right = make_space((type + 2) % 3, top);
            set_index(reinterpret_cast<dGeomID>(left), 100);
            set_index(reinterpret_cast<dGeomID>(right), 101);
            for (int i = 0; i < 24; ++i) {
                const dGeomID geom = add_member(i % 3 == 0 ? top : i % 3 == 1 ? left : right, rng, i);
                dGeomEnable(
                    geom);  // the walked side of a space-space query ignores the flag (differences.tsv, C9)
            }
            dSpaceCollide(top, nullptr, &note_pair);
            out.put_text("top", sorted_report());
            dSpaceCollide(top, nullptr, &note_leaves);
            out.put_text("leaves", sorted_report());
            dSpaceCollide2(reinterpret_cast<dGeomID>(left), reinterpret_cast<dGeomID>(right), nullptr,
                           &note_pair);
            out.put_text("left-right", sorted_report());
            dSpaceSetSublevel(left, 1);
            dSpaceCollide2(reinterpret_cast<dGeomID>(left), reinterpret_cast<dGeomID>(right), nullptr,
                           &note_pair);
            out.put_text("sublevel", sorted_report());
            dReal box[6] = {0};
            dGeomGetAABB(reinterpret_cast<dGeomID>(left), box);
            out.put("aabb", box, 6);
            dSpaceDestroy(top);
        }
    }
}

PARITY_CASE(space_rules)
{
    for (int type = 0; type < 3; ++type) {
        out.open_block(kTypes[type]);
        const dWorldID world = dWorldCreate();
        const dBodyID body = dBodyCreate(world);
        const dSpaceID space = make_space(type, nullptr);
        const dGeomID geoms[] = {dCreateSphere(space, 0),         dCreateBox(space, 1, 0, 1),
                                 dCreateCapsule(space, 0, 1),     dCreateCapsule(space, 1, 0),
                                 dCreateSphere(space, 1),         dCreateBox(space, 1, 1, 1),
                                 dCreateSphere(space, 0.5),       dCreateCylinder(space, 1, 0),
                                 dCreatePlane(space, 0, 0, 1, 0), dCreatePlane(space, 1, 0, 0, 0)};
        for (int i = 0; i < 10; ++i) { set_index(geoms[i], i); }
        dGeomSetBody(geoms[4], body);
        dGeomSetBody(geoms[5], body);
        dGeomSetPosition(geoms[6], 1.5, 0, 0);  // touches the box and the unit spheres' boxes exactly
        dSpaceCollide(space, nullptr, &note_pair);
        out.put_text("pairs", sorted_report());
        out.put("enabled",
                {static_cast<double>(dGeomIsEnabled(geoms[0])), static_cast<double>(dSpaceGetCleanup(space)),
                 static_cast<double>(dSpaceGetSublevel(space)), static_cast<double>(dSpaceGetClass(space))});
        dSpaceDestroy(space);
        dWorldDestroy(world);
    }
}

}  // namespace
}  // namespace parity
