// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Reading samples, and the neighbourhood of a facet. See heightfield.h.
#include "collide/surfaces/heightfield.h"

#include <algorithm>
#include <atomic>

#include "base/check.h"
#include "base/float_environment.h"
#include "base/memory.h"
#include "base/objects/structure_edition.h"
#include "collide/surfaces/height_function.h"

namespace epode {

namespace {

std::atomic<std::uint64_t> g_fields{0};

constexpr Real kLevel = kSingle ? Real(1e-4) : Real(1e-7);  // sine of an angle that counts as flat

int wrapped(int i, int period)
{
    const int r = i % period;
    return r < 0 ? r + period : r;
}

struct GridStep {
    int i, j;
};

// Across edge k of a facet: the corner of the neighbour that the edge does not touch.
constexpr GridStep kAcross[2][3] = {{{-1, 1}, {1, 1}, {1, -1}}, {{2, 0}, {0, 0}, {0, 2}}};
constexpr GridStep kCorner[2][3] = {{{0, 0}, {0, 1}, {1, 0}}, {{1, 1}, {1, 0}, {0, 1}}};
constexpr GridStep kAround[6] = {{1, 0}, {0, 1}, {-1, 1}, {-1, 0}, {0, -1}, {1, -1}};
// The two cells adjacent to each of these spokes, from the sample's own cell; of a diagonal twice the same.
constexpr GridStep kAdjacent[6][2] = {{{0, 0}, {0, -1}},   {{0, 0}, {-1, 0}},   {{-1, 0}, {-1, 0}},
                                      {{-1, 0}, {-1, -1}}, {{0, -1}, {-1, -1}}, {{0, -1}, {0, -1}}};

}  // namespace

HeightfieldData::HeightfieldData() : Numbered(Tag::kHeightfieldData)
{
    serial = g_fields.fetch_add(1, std::memory_order_relaxed) + 1;
}

HeightfieldData::~HeightfieldData() { drop_samples(); }

void HeightfieldData::drop_samples()
{
    release(copy, copy_size);
    copy = nullptr;
    copy_size = 0;
    samples = nullptr;
    source = Source::kNone;
    sampled = foreign = false;
    drop_holes();
}

void HeightfieldData::drop_holes()
{
    holes.reset();
    hole_count = 0;
    ++changes;
    note_structure_changed();
}

// What is no number (a callback may return it, or the client's array come to hold it) counts as 0.
Real HeightfieldData::sample(int i, int j) const
{
    const std::ptrdiff_t at = i + std::ptrdiff_t(j) * nx;
    Real value = 0;
    switch (source) {
        case Source::kCallback: {
            const InHeightFunction calling;
            const CallerFloatEnvironment program;
            value = callback(user, i, j);
            break;
        }
        case Source::kBytes:
            return Real(static_cast<const unsigned char*>(samples)[at]);
        case Source::kShorts:
            return Real(static_cast<const short*>(samples)[at]);
        case Source::kFloats:
            value = Real(static_cast<const float*>(samples)[at]);
            break;
        case Source::kDoubles:
            value = Real(static_cast<const double*>(samples)[at]);
            break;
        case Source::kNone:
            break;
    }
    return usable(value) ? value : Real(0);
}

void HeightfieldData::heights(int i, int j, int count, Real* out) const
{
    const std::ptrdiff_t at = i + std::ptrdiff_t(j) * nx;
    const auto read = [&](const auto* from) {
        for (int k = 0; k < count; ++k) {
            const Real value = Real(from[k]);
            out[k] = scale * (usable(value) ? value : Real(0)) + offset;
        }
    };
    switch (source) {
        case Source::kFloats:
            return read(static_cast<const float*>(samples) + at);
        case Source::kDoubles:
            return read(static_cast<const double*>(samples) + at);
        default:
            for (int k = 0; k < count; ++k) out[k] = height(i + k, j);
    }
}

void HeightfieldData::set_bounds(Real low_sample, Real high_sample)
{
    const Real a = low_sample * scale + offset, b = high_sample * scale + offset;
    lowest = (a < b ? a : b) - thickness;
    highest = a < b ? b : a;
}

const HeightfieldData* Heightfield::living() const
{
    return data && data->tag == Tag::kHeightfieldData && data->serial == serial ? data : nullptr;
}

const HeightfieldData* Heightfield::field() const
{
    const HeightfieldData* d = living();
    return d && d->source != HeightfieldData::Source::kNone ? d : nullptr;
}

Terrain::Terrain(const HeightfieldData& data)
    : data_(data),
      x0_(-data.width / 2),
      z0_(-data.depth / 2),
      dx_(data.width / Real(data.nx - 1)),
      dz_(data.depth / Real(data.nz - 1))
{}

bool Terrain::has(int i, int j) const
{
    return data_.wrap || (i >= 0 && j >= 0 && i < data_.nx && j < data_.nz);
}

Real Terrain::height(int i, int j) const
{
    if (!data_.wrap) return data_.height(i, j);
    return data_.height(wrapped(i, data_.nx - 1), wrapped(j, data_.nz - 1));
}

void Terrain::heights(int i, int j, int count, Real* out) const
{
    if (!data_.wrap) return data_.heights(i, j, count, out);
    for (int k = 0; k < count; ++k) out[k] = height(i + k, j);
}

Facet Terrain::bare_facet(int i, int j, bool upper) const
{
    Facet f;
    f.i = i, f.j = j, f.upper = upper;
    for (int k = 0; k < 3; ++k) f.v[k] = vertex(i + kCorner[upper][k].i, j + kCorner[upper][k].j);
    return f;
}

Terrain::BareCell Terrain::bare_cell(int i, int j) const
{
    const Vec3 a = vertex(i, j), b = vertex(i + 1, j), c = vertex(i, j + 1), d = vertex(i + 1, j + 1);
    BareCell cell;
    for (const bool upper : {false, true}) {
        Facet& f = cell.facets[upper];
        f.i = i, f.j = j, f.upper = upper;
        f.v[0] = upper ? d : a, f.v[1] = upper ? b : c, f.v[2] = upper ? c : b;
    }
    cell.lowest = std::min(std::min(a.y, b.y), std::min(c.y, d.y));
    cell.highest = std::max(std::max(a.y, b.y), std::max(c.y, d.y));
    return cell;
}

void finish(Facet& f)
{
    if (make_triangle(f.v[0], f.v[1], f.v[2], f)) return;
    f.n = {0, 1, 0};  // heights beyond the range of areas: a level facet
    f.c = f.v[0].y;
}

Facet Terrain::facet(int i, int j, bool upper) const
{
    Facet f = bare_facet(i, j, upper);
    finish(f);
    return f;
}

bool Terrain::hole(int i, int j) const
{
    if (data_.hole_count == 0) return false;
    const int columns = data_.nx - 1, rows = data_.nz - 1;
    if (data_.wrap)
        i = wrapped(i, columns), j = wrapped(j, rows);
    else if (i < 0 || j < 0 || i >= columns || j >= rows)
        return false;
    return data_.holes[i + j * columns] != 0;
}

bool Terrain::hole_beyond(const Facet& f, int k) const
{
    const int step = f.upper ? 1 : -1;
    return k != 1 && hole(f.i + (k == 0 ? step : 0), f.j + (k == 2 ? step : 0));
}

bool Terrain::wall_below(const Facet& f, int k, Triangle (&wall)[2]) const
{
    if (!(data_.thickness > 0)) return false;
    const Vec3 p = f.v[k], q = f.v[(k + 1) % 3], down{0, -data_.thickness, 0};
    wall[0].v[0] = p, wall[0].v[1] = p + down, wall[0].v[2] = q;
    wall[1].v[0] = q + down, wall[1].v[1] = q, wall[1].v[2] = p + down;
    for (Triangle& t : wall) t.n = f.out(k), t.c = f.out_limit(k);
    return true;
}

// Is the edge from a sample to one around it in a hole?
bool Terrain::spoke_gone(int i, int j, int around) const
{
    const GridStep a = kAdjacent[around][0], b = kAdjacent[around][1];
    return hole(i + a.i, j + a.j) && hole(i + b.i, j + b.j);
}

bool Terrain::falls(Vec3 from, Vec3 n, int i, int j, Real level) const
{
    if (!has(i, j)) return true;
    const Vec3 d = vertex(i, j) - from;
    return dot(n, d) <= level * length(d);
}

bool Terrain::falls_around(const Facet& f, int corner, Vec3 n, Real level) const
{
    const int i = f.i + kCorner[f.upper][corner].i, j = f.j + kCorner[f.upper][corner].j;
    for (int around = 0; around < 6; ++around) {
        const GridStep s = kAround[around];
        if (!falls(f.v[corner], n, i + s.i, j + s.j, level) && !spoke_gone(i, j, around)) return false;
    }
    return true;
}

Terrain::Neighbour Terrain::neighbour(const Facet& f, int k) const
{
    const int step = k == 1 ? 0 : f.upper ? 1 : -1;
    Neighbour n{f.i + (k == 0 ? step : 0), f.j + (k == 2 ? step : 0), !f.upper, {}, false};
    const GridStep across = kAcross[f.upper][k];
    n.there = has(f.i + across.i, f.j + across.j) && !hole(n.i, n.j);
    if (n.there) n.apex = vertex(f.i + across.i, f.j + across.j);
    return n;
}

bool Terrain::cell_under(Vec3 p, int& i, int& j) const
{
    constexpr Real kFar = 1e9;
    const Real x = std::floor((p.x - x0_) / dx_), z = std::floor((p.z - z0_) / dz_);
    if (!(std::fabs(x) < kFar && std::fabs(z) < kFar)) return false;
    i = int(x), j = int(z);
    return data_.wrap || (i >= 0 && j >= 0 && i < cells_x() && j < cells_z());
}

bool Terrain::under_slab(Vec3 p, Real lowest, Real slack) const
{
    int i, j;
    Real surface = lowest;
    if (cell_under(p, i, j) && !hole(i, j)) {
        const Real u = (p.x - x0_) / dx_ - Real(i), v = (p.z - z0_) / dz_ - Real(j);
        const Facet f = facet(i, j, u + v > 1);
        surface = p.y - f.height(p) / f.n.y;
    }
    return p.y < surface - data_.thickness - slack;
}

bool Terrain::crests(const Facet& f, Vec3 n) const
{
    const Shows shows = shown_along(f, n, kLevel);
    if (shows.corners == 3) return true;
    if (shows.corners == 2) {
        const GridStep across = kAcross[f.upper][shows.at];
        return hole_beyond(f, shows.at) || falls(f.v[shows.top], n, f.i + across.i, f.j + across.j, kLevel);
    }
    return falls_around(f, shows.top, n, kLevel);
}

bool Terrain::ends_at(const Facet& f, Vec3 n) const
{
    const Shows shows = shown_along(f, n, kLevel);
    if (shows.corners == 3) return false;
    if (shows.corners == 2) {
        const GridStep across = kAcross[f.upper][shows.at];
        return !has(f.i + across.i, f.j + across.j);
    }
    const int i = f.i + kCorner[f.upper][shows.top].i, j = f.j + kCorner[f.upper][shows.top].j;
    return !(has(i - 1, j) && has(i + 1, j) && has(i, j - 1) && has(i, j + 1));
}

unsigned Terrain::ridges(const Facet& f) const
{
    unsigned some = 0;
    for (int k = 0; k < 3; ++k) {
        const GridStep s = kAcross[f.upper][k];
        if (!has(f.i + s.i, f.j + s.j) || hole_beyond(f, k)) {
            some |= 1u << k;
            continue;
        }
        const Vec3 d = vertex(f.i + s.i, f.j + s.j) - f.v[k];
        const Real rise = dot(f.n, d);
        some |= rise < 0 && rise * rise > kLevel * kLevel * length2(d) ? 1u << k : 0;
    }
    return some;
}

}  // namespace epode
