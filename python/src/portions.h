// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// How many steps of a long call to make before signals are looked at: about a twentieth of a second of them, whatever a step takes.
#pragma once

#include <algorithm>
#include <chrono>

class Portions {
  public:
    explicit Portions(int steps) : left_(steps) {}

    int left() const { return left_; }

    // The next portion; 0: none is left. The time since the last call is what its portion took.
    int next()
    {
        const auto now = std::chrono::steady_clock::now();
        const double took = std::chrono::duration<double>(now - begin_).count();
        if (portion_ > 0)
            size_ = std::clamp(double(portion_) * kSeconds / std::max(took, 1e-9), 1.0, kGrowth * size_);
        begin_ = now;
        portion_ = std::min(left_, int(std::min(size_, 1e9)));
        left_ -= portion_;
        return portion_;
    }

  private:
    static constexpr double kSeconds = 0.05, kGrowth = 8;
    int left_, portion_ = 0;
    double size_ = 1;
    std::chrono::steady_clock::time_point begin_;
};
