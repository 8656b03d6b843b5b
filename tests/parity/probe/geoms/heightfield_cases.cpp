// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Height fields: the five ways of giving samples, bounding boxes, data shared and exchanged, and heights as
// vertical rays find them. What other shapes feel differs on purpose (docs/compat.md, Spaces and geoms), and
// so does the box of a field that can be placed or repeats (differences.tsv, C27).
#include "case_list.h"

#include <vector>

namespace parity {
namespace {

constexpr int kWide = 6, kDeep = 5;
constexpr double kWidth = 5, kDepth = 8;

struct Samples {
    unsigned char bytes[kWide * kDeep];
    short shorts[kWide * kDeep];
    float singles[kWide * kDeep];
    double doubles[kWide * kDeep];
};

Samples random_samples(Random& random)
{
    Samples s;
    for (int i = 0; i < kWide * kDeep; ++i) {
        s.bytes[i] = static_cast<unsigned char>(random.below(200));
        s.shorts[i] = static_cast<short>(random.below(400) - 200);
        s.singles[i] = static_cast<float>(random.below(1000)) / 256.0f;
        s.doubles[i] = random.range(-2, 2);
    }
    return s;
}

dReal height_at(void* data, int x, int z)
{
    return static_cast<const Samples*>(data)->doubles[x + z * kWide];
}

struct Field {
    double scale, offset, thickness;
    int copy, wrap;
};

dHeightfieldDataID build(int way, Samples& s, const Field& f)
{
    const dHeightfieldDataID data = dGeomHeightfieldDataCreate();
    switch (way) {
        case 0:
            dGeomHeightfieldDataBuildByte(data, s.bytes, f.copy, kWidth, kDepth, kWide, kDeep, f.scale,
                                          f.offset, f.thickness, f.wrap);
            break;
        case 1:
            dGeomHeightfieldDataBuildShort(data, s.shorts, f.copy, kWidth, kDepth, kWide, kDeep, f.scale,
                                           f.offset, f.thickness, f.wrap);
            break;
        case 2:
            dGeomHeightfieldDataBuildSingle(data, s.singles, f.copy, kWidth, kDepth, kWide, kDeep, f.scale,
                                            f.offset, f.thickness, f.wrap);
            break;
        case 3:
            dGeomHeightfieldDataBuildDouble(data, s.doubles, f.copy, kWidth, kDepth, kWide, kDeep, f.scale,
                                            f.offset, f.thickness, f.wrap);
            break;
        default:
            dGeomHeightfieldDataBuildCallback(data, &s, &height_at, kWidth, kDepth, kWide, kDeep, f.scale,
                                              f.offset, f.thickness, f.wrap);
            dGeomHeightfieldDataSetBounds(data, -2, 2);
            break;
    }
    return data;
}

void put_box(Output& out, const std::string& key, dGeomID g)
{
    dReal box[6] = {0};
    dGeomGetAABB(g, box);
    out.put(key, box, 6);
}

// The nearest hit of a ray from above (or below): depth and normal.
void put_height(Output& out, const std::string& key, dGeomID field, dGeomID ray, const Vec3& from,
                double down)
{
    dGeomRaySet(ray, from.x, from.y, from.z, 0, down, 0);
    dContactGeom hits[8] = {};
    const int count = dCollide(ray, field, 8, hits, sizeof(dContactGeom));
    const dContactGeom* nearest = nullptr;
    for (int i = 0; i < count; ++i) {
        if (nearest == nullptr || hits[i].depth < nearest->depth) { nearest = &hits[i]; }
    }
    if (nearest == nullptr) { return out.put(key, {-1, 0, 0, 0}); }
    out.put(key, {nearest->depth, nearest->normal[0], nearest->normal[1], nearest->normal[2]});
}

PARITY_CASE(heightfield_rays)
{
    static const char* const ways[] = {"byte", "short", "single", "double", "callback"};
    for (int way = 0; way < 5; ++way) {
        for (int trial = 0; trial < 8; ++trial) {
            out.open_block(std::string(ways[way]) + "/t" + std::to_string(trial));
            Samples samples = random_samples(rng);
            const Field shape{trial % 2 ? 0.01 : 0.5, rng.range(-1, 1), rng.range(0, 2), trial / 2 % 2,
                              trial / 4};
            const dHeightfieldDataID data = build(way, samples, shape);
            if (shape.copy && way < 4) { samples = random_samples(rng); }
            const dGeomID field = dCreateHeightfield(nullptr, data, 1), ray = dCreateRay(nullptr, 500);
            if (!shape.wrap) {
                const dGeomID fixed = dCreateHeightfield(nullptr, data, 0);
                put_box(out, "fixed", fixed);
                dGeomDestroy(fixed);
            }
            put_box(out, "box", field);
            out.put("class", {static_cast<double>(dGeomGetClass(field)),
                              dGeomHeightfieldGetHeightfieldData(field) == data ? 1.0 : 0.0});
            dGeomSetPosition(field, 1, 2, 3);
            put_box(out, "moved", field);
            for (int i = 0; i < 25; ++i) {
                const double reach = shape.wrap ? 2.0 : 0.55;
                const Vec3 at{1 + rng.range(-reach, reach) * kWidth, 250,
                              3 + rng.range(-reach, reach) * kDepth};
                put_height(out, "ray" + std::to_string(i), field, ray, at, -1);
            }
            dGeomDestroy(ray);
            dGeomDestroy(field);
            dGeomHeightfieldDataDestroy(data);
        }
    }
}

PARITY_CASE(heightfield_settings)
{
    Samples samples = random_samples(rng);
    const dHeightfieldDataID low = build(3, samples, {1, 0, 0.5, 1, 0}),
                             high = build(3, samples, {2, 10, 0.5, 1, 0});
    const dGeomID field = dCreateHeightfield(nullptr, low, 0);
    put_box(out, "low", field);
    dGeomHeightfieldSetHeightfieldData(field, high);
    put_box(out, "high", field);
    out.put("data", {dGeomHeightfieldGetHeightfieldData(field) == high ? 1.0 : 0.0});
    dGeomHeightfieldDataSetBounds(high, -3, 4);
    const dGeomID fresh = dCreateHeightfield(nullptr, high, 1);
    put_box(out, "bounds", fresh);
    const dWorldID world = dWorldCreate();
    const dBodyID body = dBodyCreate(world);
    dGeomSetBody(fresh, body);
    dBodySetPosition(body, 5, 6, 7);
    put_box(out, "body", fresh);
    dGeomDestroy(fresh);
    dGeomDestroy(field);
    dGeomHeightfieldDataDestroy(low);
    dGeomHeightfieldDataDestroy(high);
    dWorldDestroy(world);
}

}  // namespace
}  // namespace parity
