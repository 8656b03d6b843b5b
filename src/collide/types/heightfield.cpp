// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Height field: the geom and its data object. Data are checked when they are built, all samples of them: a
// number that is none is refused there, and what a callback or an array that is not copied gives later counts
// as 0.
#include <type_traits>

#include "base/float_environment.h"
#include "base/memory.h"
#include "collide/describe.h"
#include "collide/surfaces/height_function.h"
#include "collide/surfaces/height_samples.h"
#include "collide/types/registry.h"

namespace epode {
namespace {

using HeightfieldGeom = ShapeGeom<Heightfield>;

// The field's box turned into the world. Every coordinate is a sum of products of which some may be infinite,
// of one sign for each bound.
Aabb aabb(Geom& geom)
{
    const Pose pose = load_pose(geom.position, geom.rotation);
    const HeightfieldData* d = static_cast<const HeightfieldGeom&>(geom).shape.field();
    if (!d) return {pose.p, pose.p};
    const Real x = d->wrap ? kInf : d->width / 2, z = d->wrap ? kInf : d->depth / 2;
    const Vec3 lo{-x, d->lowest, -z}, hi{x, d->highest, z};
    Aabb box{pose.p, pose.p};
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k) {
            const Real r = pose.R.row(i)[k];
            if (r == 0) continue;
            box.lo.set(i, box.lo[i] + (r > 0 ? r * lo[k] : r * hi[k]));
            box.hi.set(i, box.hi[i] + (r > 0 ? r * hi[k] : r * lo[k]));
        }
    return box;
}

void describe_heightfield(const Geom&, DifWriter& out) { out.text("type", "heightfield"); }

// Includes heights that the program stores, as they are now; not those of a callback, which a file has.
void fingerprint(const Geom& geom, ContentHash& hash)
{
    const HeightfieldData* d = static_cast<const HeightfieldGeom&>(geom).shape.field();
    if (!d) return;
    hash.add({d->width, d->depth, d->scale, d->offset, d->thickness});
    for (const int number : {d->nx, d->nz, int(d->wrap)}) hash.add(std::uint64_t(number));
    for (const unsigned char hole : d->holes) hash.add(std::uint64_t(hole));
    if (d->source == HeightfieldData::Source::kCallback || d->sampled) return;
    for (int j = 0; j < d->nz; ++j)
        for (int i = 0; i < d->nx; ++i) hash.add(d->sample(i, j));
}

// ---- files ----

constexpr const char* kNoField = "a height field in it has a size or height that it cannot have";
constexpr std::int64_t kMaxSamples = std::int64_t(1) << 27;

void layout_in_file(HeightfieldData& d, StructureStream& stream)
{
    stream.sizes(&d.width, 1), stream.sizes(&d.depth, 1), stream.sizes(&d.thickness, 1);
    stream.real(d.scale), stream.real(d.offset);
    stream.real(d.lowest, StructureStream::kInfinite), stream.real(d.highest, StructureStream::kInfinite);
    stream.number(d.nx), stream.number(d.nz);
    bool sampled = d.sampled || d.source == HeightfieldData::Source::kCallback;
    bool foreign = d.foreign || !d.copy;
    stream.flag(d.wrap), stream.flag(sampled), stream.flag(foreign);
    if (stream.loads()) d.sampled = sampled, d.foreign = foreign;
}

bool is_sound(const HeightfieldData& d)
{
    return d.width > 0 && d.depth > 0 && d.nx >= 2 && d.nz >= 2 && std::int64_t(d.nx) * d.nz <= kMaxSamples &&
           usable(d.scale) && usable(d.offset) && usable_or_infinite(d.lowest) &&
           usable_or_infinite(d.highest);
}

// As numbers of the library's precision, whatever they come from: a copy of their own.
void load_samples(HeightfieldData& d, StructureStream& stream)
{
    const int samples = stream.count(0, sizeof(Real), "heights of a field");
    if (!stream.demand(samples == d.nx * d.nz, kNoField)) return;
    Real* const block = static_cast<Real*>(allocate(sizeof(Real) * std::size_t(samples)));
    if (!stream.demand(block, kOutOfMemory)) return;
    d.copy = block, d.copy_size = sizeof(Real) * std::size_t(samples), d.samples = block;
    d.source = kSingle ? HeightfieldData::Source::kFloats : HeightfieldData::Source::kDoubles;
    stream.reals(block, samples);
    for (int k = 0; k < samples; ++k)
        if (!stream.demand(usable(block[k]) && usable(block[k] * d.scale + d.offset), kNoField)) return;
}

// What is given by a function has been sampled before.
void save_samples(const HeightfieldData& d, ShapeStream& stream)
{
    const bool by_function = d.source == HeightfieldData::Source::kCallback;
    const std::span<const Real> known =
        by_function && stream.heights() ? stream.heights()->of(d) : std::span<const Real>();
    const int count = d.nx * d.nz;
    if (by_function && known.size() != std::size_t(count))
        return stream.fail("a height function has added a height field while the world was saved");
    (void)stream.count(count, sizeof(Real), "");
    for (int k = 0; k < count && !stream.failed(); ++k) {
        Real height = by_function ? known[std::size_t(k)] : d.sample(k % d.nx, k / d.nx);
        stream.real(height);
    }
}

void holes_in_file(HeightfieldData& d, StructureStream& stream)
{
    const int cells = stream.count(d.hole_count > 0 ? d.holes.size() : 0, 1, "cells of a field");
    if (stream.loads()) {
        const bool fits = cells == 0 || cells == (d.nx - 1) * (d.nz - 1);
        if (!stream.demand(fits, kNoField) || !stream.demand(d.holes.resize(cells), kOutOfMemory)) return;
    }
    stream.bytes(d.holes.data(), std::size_t(cells));
    if (stream.saves()) return;
    for (unsigned char& hole : d.holes) hole = hole != 0, d.hole_count += hole;
}

void field_in_file(HeightfieldData& d, ShapeStream& stream)
{
    bool built = d.source != HeightfieldData::Source::kNone;
    stream.flag(built);
    if (!built) return;
    layout_in_file(d, stream);
    if (stream.failed() || !stream.demand(is_sound(d), kNoField)) return;
    if (stream.loads()) {
        load_samples(d, stream);
    } else {
        save_samples(d, stream);
    }
    if (!stream.failed()) holes_in_file(d, stream);
}

HeightfieldData* visit_field(HeightfieldData* data, ShapeStream& stream)
{
    HeightfieldData* const d = data ? data : Pool<HeightfieldData>::create();
    if (!stream.demand(d, kOutOfMemory)) return nullptr;
    field_in_file(*d, stream);
    if (stream.saves() || !stream.failed()) return d;
    Pool<HeightfieldData>::destroy(d);
    return nullptr;
}

void structure(Geom& geom, ShapeStream& stream);

constexpr GeomType heightfield_type(bool placeable)
{
    return {.number = dHeightfieldClass,
            .placeable = placeable,
            .aabb = aabb,
            .destroy = destroy_pooled<HeightfieldGeom>,
            .describe = describe_heightfield,
            .fingerprint = fingerprint,
            .create = create_pooled<HeightfieldGeom>,
            .structure = structure};
}

const GeomType kFixedHeightfieldType = heightfield_type(false);

void structure(Geom& geom, ShapeStream& stream)
{
    Heightfield& shape = static_cast<HeightfieldGeom&>(geom).shape;
    bool placeable = geom.type->placeable;
    stream.flag(placeable);
    if (!placeable) geom.type = &kFixedHeightfieldType;
    HeightfieldData* const data = stream.shared<HeightfieldData>(const_cast<HeightfieldData*>(shape.living()),
                                                                 Pool<HeightfieldData>::destroy, visit_field);
    if (stream.loads()) shape = {data, data ? data->serial : 0};
}

// ---- building ----

struct Layout {
    Real width, depth;
    int nx, nz;
    Real scale, offset, thickness;
    int wrap;
};

bool fits(const Layout& l)
{
    return usable(l.width) && usable(l.depth) && l.width > 0 && l.depth > 0 && l.nx >= 2 && l.nz >= 2 &&
           usable(l.scale) && usable(l.offset) && usable(l.thickness) && l.thickness >= 0;
}

void take(const Layout& l, HeightfieldData& d)
{
    d.width = l.width, d.depth = l.depth;
    d.nx = l.nx, d.nz = l.nz;
    d.scale = l.scale, d.offset = l.offset, d.thickness = l.thickness;
    d.wrap = l.wrap != 0;
}

struct Range {
    Real low, high;
};

// False when a sample is not a usable number.
template <typename Sample>
bool range_of(const Sample* samples, std::size_t count, Range& out)
{
    Sample low = samples[0], high = samples[0];
    for (std::size_t k = 0; k < count; ++k) {
        if constexpr (std::is_floating_point_v<Sample>)
            if (!usable(Real(samples[k])) || !(samples[k] >= -std::numeric_limits<Sample>::max()) ||
                !(samples[k] <= std::numeric_limits<Sample>::max()))
                return false;
        low = samples[k] < low ? samples[k] : low;
        high = samples[k] > high ? samples[k] : high;
    }
    out = {Real(low), Real(high)};
    return true;
}

// The reason of a refusal, or null.
template <typename Sample>
const char* build(dHeightfieldDataID id, const Sample* samples, int copy, const Layout& layout,
                  HeightfieldData::Source source)
{
    const FloatEnvironment floats;
    HeightfieldData* d = from_handle<HeightfieldData>(id);
    Range range;
    if (InHeightFunction::now()) return EPODE_HEIGHT_FUNCTION_TEXT;
    if (!d || !samples || !fits(layout)) return "Bad argument(s)";
    const std::size_t count = std::size_t(layout.nx) * std::size_t(layout.nz);
    if (!range_of(samples, count, range)) return "height is not a usable number";
    if (!usable(range.low * layout.scale + layout.offset) ||
        !usable(range.high * layout.scale + layout.offset))
        return "height is not a usable number";
    void* block = nullptr;
    if (copy) {
        block = allocate(count * sizeof(Sample));
        if (!block) return kOutOfMemory;
        std::memcpy(block, samples, count * sizeof(Sample));
    }
    d->drop_samples();
    take(layout, *d);
    d->copy = block;
    d->copy_size = block ? count * sizeof(Sample) : 0;
    d->samples = block ? block : samples;
    d->source = source;
    d->set_bounds(range.low, range.high);
    return nullptr;
}

}  // namespace

const GeomType kHeightfieldType = heightfield_type(true);

}  // namespace epode

using namespace epode;

#define EPODE_BUILD_HEIGHTFIELD(source)                                                             \
    const Layout layout{width, depth, widthSamples, depthSamples, scale, offset, thickness, bWrap}; \
    const char* const refusal =                                                                     \
        build(d, pHeightData, bCopyHeightData, layout, HeightfieldData::Source::source);            \
    EPODE_USER_SAY(!refusal, refusal)

extern "C" {

dHeightfieldDataID dGeomHeightfieldDataCreate(void)
{
    const HeightfieldData* data = Pool<HeightfieldData>::create();
    EPODE_USER_SAY(data, kOutOfMemory, nullptr);
    return to_handle(data);
}

void dGeomHeightfieldDataDestroy(dHeightfieldDataID d)
{
    HeightfieldData* data = from_handle<HeightfieldData>(d);
    EPODE_USER(data);
    EPODE_OUTSIDE_HEIGHT_FUNCTION();
    Pool<HeightfieldData>::destroy(data);
}

void dGeomHeightfieldDataBuildCallback(dHeightfieldDataID d, void* pUserData,
                                       dHeightfieldGetHeight* pCallback, dReal width, dReal depth,
                                       int widthSamples, int depthSamples, dReal scale, dReal offset,
                                       dReal thickness, int bWrap)
{
    HeightfieldData* data = from_handle<HeightfieldData>(d);
    const Layout layout{width, depth, widthSamples, depthSamples, scale, offset, thickness, bWrap};
    EPODE_USER(data && pCallback && fits(layout));
    EPODE_OUTSIDE_HEIGHT_FUNCTION();
    data->drop_samples();
    take(layout, *data);
    data->callback = pCallback;
    data->user = pUserData;
    data->source = HeightfieldData::Source::kCallback;
    data->lowest = -kInf;
    data->highest = kInf;
}

void dGeomHeightfieldDataBuildByte(dHeightfieldDataID d, const unsigned char* pHeightData,
                                   int bCopyHeightData, dReal width, dReal depth, int widthSamples,
                                   int depthSamples, dReal scale, dReal offset, dReal thickness, int bWrap)
{
    EPODE_BUILD_HEIGHTFIELD(kBytes);
}

void dGeomHeightfieldDataBuildShort(dHeightfieldDataID d, const short* pHeightData, int bCopyHeightData,
                                    dReal width, dReal depth, int widthSamples, int depthSamples, dReal scale,
                                    dReal offset, dReal thickness, int bWrap)
{
    EPODE_BUILD_HEIGHTFIELD(kShorts);
}

void dGeomHeightfieldDataBuildSingle(dHeightfieldDataID d, const float* pHeightData, int bCopyHeightData,
                                     dReal width, dReal depth, int widthSamples, int depthSamples,
                                     dReal scale, dReal offset, dReal thickness, int bWrap)
{
    EPODE_BUILD_HEIGHTFIELD(kFloats);
}

void dGeomHeightfieldDataBuildDouble(dHeightfieldDataID d, const double* pHeightData, int bCopyHeightData,
                                     dReal width, dReal depth, int widthSamples, int depthSamples,
                                     dReal scale, dReal offset, dReal thickness, int bWrap)
{
    EPODE_BUILD_HEIGHTFIELD(kDoubles);
}

void dGeomHeightfieldDataSetBounds(dHeightfieldDataID d, dReal minHeight, dReal maxHeight)
{
    const FloatEnvironment floats;
    HeightfieldData* data = from_handle<HeightfieldData>(d);
    EPODE_USER(data && data->source != HeightfieldData::Source::kNone);
    const Real low = minHeight * data->scale + data->offset, high = maxHeight * data->scale + data->offset;
    EPODE_USER(usable_or_infinite(low) && usable_or_infinite(high));
    data->set_bounds(minHeight, maxHeight);
}

dGeomID dCreateHeightfield(dSpaceID space, dHeightfieldDataID data, int bPlaceable)
{
    EPODE_USER(!data || from_handle<HeightfieldData>(data), nullptr);
    EPODE_PARENT_SPACE(space, nullptr);
    HeightfieldGeom* geom = create_geom<Heightfield>(space);
    if (!geom) return nullptr;
    if (!bPlaceable) geom->type = &kFixedHeightfieldType;
    if (data) dGeomHeightfieldSetHeightfieldData(to_handle<Geom>(geom), data);
    return to_handle<Geom>(geom);
}

void dGeomHeightfieldSetHeightfieldData(dGeomID g, dHeightfieldDataID d)
{
    EPODE_GEOM_AS(Heightfield, geom, g);
    const HeightfieldData* data = from_handle<HeightfieldData>(d);
    EPODE_USER(data || !d);
    EPODE_UNLOCKED(geom);
    geom->shape = {data, data ? data->serial : 0};
    mark_changed(*geom);
}

dHeightfieldDataID dGeomHeightfieldGetHeightfieldData(dGeomID g)
{
    EPODE_GEOM_AS(Heightfield, geom, g, nullptr);
    return to_handle(geom->shape.living());
}

}  // extern "C"
