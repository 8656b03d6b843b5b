// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// How much of two geoms one query looks at. The triangles of a mesh are in memory, but those of a height field
// that repeats, or whose heights a function gives, have no end: under a geom of 1e9 m lie 1e18 cells of a metre. So a
// pair of geoms has a number of units,
//     E = 2^22 + 2^12 for each triangle of its meshes,
// and a cell that is looked at costs one, a distance between two convex shapes sixteen. Work is counted and never
// timed, or the same calls would not give the same bits. Cells are looked at from the middle of a box outwards; when
// nothing is left, the answer is the best so far, and whoever asked says so.
// Rejected: a limit of cells in one box, as contacts have it. A ball far above a fine field has more cells in its box
// than any such number, and all boxes of a query together are what costs time.
#pragma once

#include <cstdint>

namespace epode {

class Effort {
  public:
    static constexpr std::int64_t kCells = 1 << 22, kPerTriangle = 1 << 12, kDistance = 16;

    // `triangles`: of the meshes.
    explicit Effort(std::int64_t triangles) : left_(kCells + kPerTriangle * triangles) {}

    // False: so much is not left, and something is not looked at.
    bool spend(std::int64_t units)
    {
        if (left_ < units) return left_ = 0, cut_short_ = true, false;
        left_ -= units;
        return true;
    }
    bool is_cut_short() const { return cut_short_; }

    // For the next one of so many: eight equal shares, since few need one. What it leaves is for those after it.
    Effort share_of(int many) const
    {
        Effort share(*this);
        share.left_ = left_ / ((many + 7) / 8), share.cut_short_ = false;
        return share;
    }
    void spend(const Effort& before, const Effort& after)
    {
        left_ -= before.left_ - after.left_;
        cut_short_ = cut_short_ || after.cut_short_;
    }

  private:
    std::int64_t left_;
    bool cut_short_ = false;
};

// Calls look(share) for each of `count`.
template <typename Look>
void look_at_each(int count, Effort& effort, Look&& look)
{
    for (int i = 0; i < count; ++i) {
        const Effort share = effort.share_of(count - i);
        Effort spent = share;
        look(i, spent);
        effort.spend(share, spent);
    }
}

// One message: the answer of this function is of a part.
void report_cut_short(const char* function);

}  // namespace epode
