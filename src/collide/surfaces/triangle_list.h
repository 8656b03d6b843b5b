// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Numbers of triangles: a list without bound that rarely needs memory.
#pragma once

#include <algorithm>

#include "base/array.h"

namespace epode {

class TriangleList {
  public:
    TriangleList() = default;
    TriangleList(const TriangleList&) = delete;
    TriangleList& operator=(const TriangleList&) = delete;

    bool add(int triangle)  // false without memory
    {
        if (count_ == capacity_ && !grow()) return false;
        data_[count_++] = triangle;
        return true;
    }
    void clear() { count_ = 0; }
    void sort();

    // Keeps those for which keep(triangle) holds.
    template <typename Keep>
    void filter(Keep&& keep)
    {
        int kept = 0;
        for (int i = 0; i < count_; ++i)
            if (keep(data_[i])) data_[kept++] = data_[i];
        count_ = kept;
    }

    const int* begin() const { return data_; }
    const int* end() const { return data_ + count_; }
    int count() const { return count_; }
    bool has(int triangle) const { return std::binary_search(begin(), end(), triangle); }  // of one in order

  private:
    static constexpr int kFew = 128;
    bool grow();

    int few_[kFew];
    Array<int> many_;
    int* data_ = few_;
    int count_ = 0, capacity_ = kFew;
};

}  // namespace epode
