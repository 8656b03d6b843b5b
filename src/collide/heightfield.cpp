// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Reading samples, and the neighbourhood of a facet. See heightfield.h.
#include "collide/heightfield.h"

#include <atomic>

#include "base/check.h"
#include "base/memory.h"
#include "collide/height_function.h"

namespace epode {

namespace {

std::atomic<std::uint64_t> g_serial{0};

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

}  // namespace

constinit thread_local int InHeightFunction::depth = 0;

HeightfieldData::HeightfieldData() : Tagged(Tag::kHeightfieldData)
{
    serial = g_serial.fetch_add(1, std::memory_order_relaxed) + 1;
}

HeightfieldData::~HeightfieldData() { drop_samples(); }

void HeightfieldData::drop_samples()
{
    release(copy, copy_size);
    copy = nullptr;
    copy_size = 0;
    samples = nullptr;
    source = Source::kNone;
}

// What is no number (a callback may return it, or the client's array come to hold it) counts as 0.
Real HeightfieldData::sample(int i, int j) const
{
    const std::ptrdiff_t at = i + std::ptrdiff_t(j) * nx;
    Real value = 0;
    switch (source) {
        case Source::kCallback: {
            const InHeightFunction calling;
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

Vec3 Terrain::vertex(int i, int j) const
{
    const int si = data_.wrap ? wrapped(i, data_.nx - 1) : i, sj = data_.wrap ? wrapped(j, data_.nz - 1) : j;
    return {x0_ + Real(i) * dx_, data_.height(si, sj), z0_ + Real(j) * dz_};
}

Facet Terrain::facet(int i, int j, bool upper) const
{
    Facet f;
    f.i = i, f.j = j, f.upper = upper;
    Vec3 v[3];
    for (int k = 0; k < 3; ++k) v[k] = vertex(i + kCorner[upper][k].i, j + kCorner[upper][k].j);
    if (!make_triangle(v[0], v[1], v[2], f)) {  // heights beyond the range of areas: a level facet
        f.n = {0, 1, 0};
        f.c = v[0].y;
    }
    return f;
}

bool Terrain::falls(Vec3 from, Vec3 n, int i, int j) const
{
    if (!has(i, j)) return true;
    const Vec3 d = vertex(i, j) - from;
    return dot(n, d) <= kLevel * length(d);
}

bool Terrain::crests(const Facet& f, Vec3 n) const
{
    const Shows shows = shown_along(f, n, kLevel);
    if (shows.corners == 3) return true;
    if (shows.corners == 2) {
        const GridStep across = kAcross[f.upper][shows.at];
        return falls(f.v[shows.top], n, f.i + across.i, f.j + across.j);
    }
    const int i = f.i + kCorner[f.upper][shows.top].i, j = f.j + kCorner[f.upper][shows.top].j;
    for (const GridStep s : kAround)
        if (!falls(f.v[shows.top], n, i + s.i, j + s.j)) return false;
    return true;
}

bool Terrain::has_ridge(const Facet& f) const
{
    for (int k = 0; k < 3; ++k) {
        const GridStep s = kAcross[f.upper][k];
        if (!has(f.i + s.i, f.j + s.j)) return true;
        const Vec3 d = vertex(f.i + s.i, f.j + s.j) - f.v[k];
        if (dot(f.n, d) < -kLevel * length(d)) return true;
    }
    return false;
}

}  // namespace epode
