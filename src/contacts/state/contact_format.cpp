// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Floats as integers: for x >= 0 the bits are in the order of the numbers, and floats that follow each other
// differ by one. Differences are taken of the bits as they are, modulo 2^32, so a change of sign is far.
// Columns of anchors behind the last point are written by nobody, and made again when a manifold is read.
#include "contacts/state/contact_format.h"

#include <algorithm>
#include <bit>

#include "base/streams/little_endian.h"
#include "simd/quad.h"

namespace epode {
namespace {

typedef std::int32_t IntQuad __attribute__((vector_size(16)));

static_assert(kManifoldPoints == 4);
static_assert(offsetof(ManifoldFinding, anchors) - offsetof(ManifoldFinding, offset) == 15 * sizeof(float));
static_assert(offsetof(ManifoldPoint, friction_impulse) - offsetof(ManifoldPoint, normal_impulse) ==
              sizeof(float));

constexpr std::size_t kHead = 15 * sizeof(float), kImpulse = 4 * sizeof(float);

// What the formula makes of a1: a row for each coordinate.
struct Predicted {
    IntQuad row[3];
    Predicted(const ManifoldFinding& f, const float (&a1)[3][kManifoldPoints])
    {
        const auto all = [](float x) { return FloatQuad{x, x, x, x}; };
        const FloatQuad x = load_floats(a1[0]) - all(f.offset.x), y = load_floats(a1[1]) - all(f.offset.y),
                        z = load_floats(a1[2]) - all(f.offset.z);
        const auto along = [&](float a, float b, float c) {
            return std::bit_cast<IntQuad>(all(a) * x + all(b) * y + all(c) * z);
        };
        row[0] = along(f.turn[0].x, f.turn[1].x, f.turn[2].x);
        row[1] = along(f.turn[0].y, f.turn[1].y, f.turn[2].y);
        row[2] = along(f.turn[0].z, f.turn[1].z, f.turn[2].z);
    }
};

IntQuad load_ints(const float* p) { return std::bit_cast<IntQuad>(load_floats(p)); }
void store_ints(float* p, IntQuad a) { store_floats(p, std::bit_cast<FloatQuad>(a)); }

// Of constant size: a call of memcpy() costs as much as many of these. `size` bytes of numbers that have `one` each.
template <std::size_t size, std::size_t one = sizeof(float)>
void put(std::byte*& to, const void* from)
{
    copy_little<one>(to, from, size / one);
    to += size;
}
template <std::size_t size, std::size_t one = sizeof(float)>
void get(void* to, const std::byte*& from)
{
    copy_little<one>(to, from, size / one);
    from += size;
}

// A row of a number for each point. What is behind the last point repeats it.
template <int count>
void get_row(float (&row)[kManifoldPoints], const std::byte*& from)
{
    get<sizeof(float) * count>(row, from);
    for (int i = count; i < kManifoldPoints; ++i) row[i] = row[count - 1];
}

// Bits of numbers as integers that wrap: what is far from its prediction, of another sign for instance, comes back too.
using WordQuad = std::uint32_t __attribute__((vector_size(16)));
IntQuad sum(IntQuad a, IntQuad b) { return IntQuad(WordQuad(a) + WordQuad(b)); }
IntQuad difference(IntQuad a, IntQuad b) { return IntQuad(WordQuad(a) - WordQuad(b)); }

// From what is predicted to what is.
struct Differences {
    IntQuad row[3];
    template <int count>
    std::uint32_t largest() const
    {
        IntQuad any{};
        for (const IntQuad& d : row) any |= d ^ (d >> 31);
        std::uint32_t all = 0;
        for (int i = 0; i < count; ++i) all |= std::uint32_t(any[i]);
        return all;
    }
};

template <typename Small, int count>
void put_small(std::byte*& to, const Differences& differences)
{
    Small small[3][count];
    for (int k = 0; k < 3; ++k)
        for (int i = 0; i < count; ++i) small[k][i] = Small(differences.row[k][i]);
    put<sizeof small, sizeof(Small)>(to, small);
    constexpr std::size_t padding = -sizeof small % 4;
    for (std::size_t i = 0; i < padding; ++i) *to++ = std::byte(0);
}

template <typename Small, int count>
void get_small(const std::byte*& from, ManifoldFinding& found)
{
    const Predicted predicted(found, found.anchors.a1);
    Small small[3][count];
    get<sizeof small, sizeof(Small)>(small, from);
    from += -sizeof small % 4;
    for (int k = 0; k < 3; ++k) {
        const auto own = [&](int i) { return std::int32_t(small[k][i < count ? i : count - 1]); };
        store_ints(found.anchors.a2[k], sum(predicted.row[k], IntQuad{own(0), own(1), own(2), own(3)}));
    }
}

template <int count>
std::uint32_t put_second(const ManifoldFinding& found, std::byte*& to)
{
    const Predicted predicted(found, found.anchors.a1);
    Differences differences;
    for (int k = 0; k < 3; ++k)
        differences.row[k] = difference(load_ints(found.anchors.a2[k]), predicted.row[k]);
    const std::uint32_t largest = differences.largest<count>();
    if (largest < 1u << 7) return put_small<std::int8_t, count>(to, differences), kBytes;
    if (largest < 1u << 15) return put_small<std::int16_t, count>(to, differences), kShorts;
    for (const auto& row : found.anchors.a2) put<sizeof(float) * count>(to, row);
    return 0;
}

template <int count>
void get_second(const std::byte*& from, std::uint32_t bits, ManifoldFinding& found)
{
    if (bits & kBytes) return get_small<std::int8_t, count>(from, found);
    if (bits & kShorts) return get_small<std::int16_t, count>(from, found);
    for (auto& row : found.anchors.a2) get_row<count>(row, from);
}

// To the last bit: -0 is something.
template <int count>
bool is_idle(const ContactManifold& manifold)
{
    std::uint64_t any = 0;
    for (int i = 0; i < count; ++i) {
        std::uint64_t bits[2];
        std::memcpy(bits, &manifold.points[i].normal_impulse, sizeof bits);
        any |= bits[0] | bits[1];
    }
    return any == 0;
}

bool is_zero(Float3 v) { return v.x == 0 && v.y == 0 && v.z == 0; }

void begin_reading(std::uint32_t bits, float layer, CachedManifold& kept)
{
    kept.layer = layer;
    kept.manifold.count = int(bits & kPoints);
    kept.manifold.normal = kept.manifold.surface_velocity = kept.manifold.rolling_impulse = {};
    kept.manifold.struck = kept.manifold.at_border = false;
}

void get_rare(const std::byte*& from, std::uint32_t bits, CachedManifold& kept)
{
    if (bits & kRoll) get<3 * sizeof(float)>(&kept.manifold.rolling_impulse, from);
    if (bits & kLayer) get<sizeof(float)>(&kept.layer, from);
}

template <int count>
void get_impulses(const std::byte*& from, std::uint32_t bits, ContactManifold& manifold)
{
    for (int i = 0; i < count; ++i) {
        ManifoldPoint& point = manifold.points[i];
        if (bits & kIdle)
            point.normal_impulse = 0, point.friction_impulse = {};
        else
            get<kImpulse>(&point.normal_impulse, from);
    }
}

std::size_t rare_size(std::uint32_t bits)
{
    return (bits & kRoll ? 3 * sizeof(float) : 0) + (bits & kLayer ? sizeof(float) : 0);
}

std::size_t whole_words(std::size_t bytes) { return (bytes + 3) / 4 * 4; }

template <int count>
std::uint32_t write(const CachedManifold& kept, float layer, std::byte*& to)
{
    constexpr std::size_t row = sizeof(float) * count;
    const ManifoldFinding& found = kept.found;
    const ContactManifold& manifold = kept.manifold;
    std::uint32_t bits = std::uint32_t(count);
    put<kHead>(to, &found.offset);
    for (const auto& a : found.anchors.a1) put<row>(to, a);
    bits |= put_second<count>(found, to);
    put<row>(to, found.anchors.separation);
    for (int i = 0; i < count; ++i) put<sizeof(float)>(to, &manifold.points[i].separation);
    if (!is_zero(manifold.rolling_impulse))
        bits |= kRoll, put<3 * sizeof(float)>(to, &manifold.rolling_impulse);
    if (kept.layer != layer) bits |= kLayer, put<sizeof(float)>(to, &kept.layer);
    if (is_idle<count>(manifold)) return bits | kIdle;
    for (int i = 0; i < count; ++i) put<kImpulse>(to, &manifold.points[i].normal_impulse);
    return bits;
}

template <int count>
void read(const std::byte* from, std::uint32_t bits, CachedManifold& kept)
{
    ContactAnchors& anchors = kept.found.anchors;
    get<kHead>(&kept.found.offset, from);
    for (auto& row : anchors.a1) get_row<count>(row, from);
    get_second<count>(from, bits, kept.found);
    get_row<count>(anchors.separation, from);
    for (int i = 0; i < count; ++i) get<sizeof(float)>(&kept.manifold.points[i].separation, from);
    get_rare(from, bits, kept);
    get_impulses<count>(from, bits, kept.manifold);
}

template <int count>
void read_3(const std::byte* from, std::uint32_t bits, CachedManifold& kept)
{
    ContactAnchors& anchors = kept.found.anchors;
    get<kHead>(&kept.found.offset, from);
    for (int k = 0; k < 3; ++k) get_row<count>(anchors.a1[k], from), get_row<count>(anchors.a2[k], from);
    get_row<count>(anchors.separation, from);
    get_rare(from, bits, kept);
    for (int i = 0; i < count; ++i) get<sizeof(float)>(&kept.manifold.points[i].separation, from);
    get_impulses<count>(from, bits, kept.manifold);
}

// f.operator()<count>() of a number that is known when the program runs.
template <typename F>
auto with_count(int count, F&& f)
{
    switch (count) {
        case 1:
            return f.template operator()<1>();
        case 2:
            return f.template operator()<2>();
        case 3:
            return f.template operator()<3>();
        default:
            return f.template operator()<4>();
    }
}

}  // namespace

std::uint32_t write_manifold(const CachedManifold& kept, float layer, std::byte*& to)
{
    std::byte* at = to;
    const std::uint32_t bits =
        with_count(kept.manifold.count, [&]<int count>() { return write<count>(kept, layer, at); });
    to = at;
    return bits;
}

std::size_t size_of_manifold(std::uint32_t bits)
{
    const std::size_t count = bits & kPoints;
    const std::size_t second = bits & kBytes ? 1 : bits & kShorts ? 2 : 4;
    const std::size_t rows = bits & kIdle ? 5 : 9;
    return kHead + rows * sizeof(float) * count + whole_words(3 * second * count) + rare_size(bits);
}

void read_manifold(const std::byte* from, std::uint32_t bits, float layer, CachedManifold& kept)
{
    begin_reading(bits, layer, kept);
    with_count(kept.manifold.count, [&]<int count>() { read<count>(from, bits, kept); });
}

std::size_t size_of_manifold_3(std::uint32_t bits)
{
    return kHead + sizeof(float) * (bits & kIdle ? 8 : 12) * std::size_t(bits & kPoints) + rare_size(bits);
}

void read_manifold_3(const std::byte* from, std::uint32_t bits, float layer, CachedManifold& kept)
{
    begin_reading(bits, layer, kept);
    with_count(kept.manifold.count, [&]<int count>() { read_3<count>(from, bits, kept); });
}

}  // namespace epode
