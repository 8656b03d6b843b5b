// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Many vectors side by side, for their dot products with one: groups of four, each x x x x y y y y z z z z
// and, of planes, their four offsets. What fills up the last group is the last vector again. The products
// have the bits of dot().
#pragma once

#include <bit>
#include <cstdint>
#include <span>
#include <utility>

#include "base/array.h"
#include "math/vec.h"
#include "simd/quad.h"

namespace epode {

class DotLanes {
  public:
    static constexpr int kWide = 4;

    [[nodiscard]] bool take(std::span<const Vec3> vectors)
    {
        if (!reserve(int(vectors.size()), 3)) return false;
        for (int k = 0; k < 3; ++k) fill(k, [&](std::size_t i) { return vectors[i][k]; });
        return true;
    }
    // Normals and offsets of planes or faces.
    template <typename Plane>
    [[nodiscard]] bool take_planes(std::span<const Plane> planes)
    {
        if (!reserve(int(planes.size()), 4)) return false;
        for (int k = 0; k < 3; ++k) fill(k, [&](std::size_t i) { return planes[i].normal[k]; });
        fill(3, [&](std::size_t i) { return planes[i].offset; });
        return true;
    }
    void swap(DotLanes& other)
    {
        numbers_.swap(other.numbers_);
        std::swap(count_, other.count_), std::swap(rows_, other.rows_);
    }
    int groups() const { return (count_ + kWide - 1) / kWide; }
    const Real* group(int i) const { return numbers_.data() + i * rows_ * kWide; }

  private:
    bool reserve(int count, int rows)
    {
        count_ = count, rows_ = rows;
        return numbers_.resize(groups() * rows * kWide);
    }
    template <typename Get>
    void fill(int row, const Get& get)
    {
        for (int i = 0; i < groups() * kWide; ++i)
            numbers_.data()[(i / kWide * rows_ + row) * kWide + i % kWide] =
                get(std::size_t(i < count_ ? i : count_ - 1));
    }

    Array<Real> numbers_;
    int count_ = 0, rows_ = 0;
};

namespace {

struct QuadVec {
    Quad x, y, z;
};
EPODE_LANEWISE QuadVec quad_vec(Vec3 v) { return {quad(v.x), quad(v.y), quad(v.z)}; }

EPODE_LANEWISE Quad dots(const Real* group, const QuadVec& d)
{
    constexpr int kWide = DotLanes::kWide;
    return load_quad(group) * d.x + load_quad(group + kWide) * d.y + load_quad(group + 2 * kWide) * d.z;
}
EPODE_LANEWISE Quad offsets(const Real* group) { return load_quad(group + 3 * DotLanes::kWide); }

// Which of values[0 ... 4 groups), at most 16 groups, are as large as `bound`, without a branch that depends
// on them.
EPODE_LANEWISE std::uint64_t as_large(const Real* values, int groups, Real bound)
{
    const Quad m = quad(bound);
    std::uint64_t there = 0;
    for (const Real* end = values + groups * DotLanes::kWide; end != values;)
        there = there << DotLanes::kWide | bits(m <= load_quad(end -= DotLanes::kWide));
    return there;
}

// The first of them, of any number of groups; 0 if there is none.
EPODE_LANEWISE int first_as_large(const Real* values, int groups, Real bound)
{
    constexpr int kAtOnce = 16;
    for (int begin = 0; begin < groups; begin += kAtOnce) {
        const int some = groups - begin < kAtOnce ? groups - begin : kAtOnce;
        const Real* const from = values + begin * DotLanes::kWide;
        if (const std::uint64_t there = as_large(from, some, bound))
            return begin * DotLanes::kWide + std::countr_zero(there);
    }
    return 0;
}

}  // namespace
}  // namespace epode
