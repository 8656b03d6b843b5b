// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Working memory of a matrix function: 2 KiB of stack for the sizes that clients use, the library's
// allocator beyond. alloca would be simpler, but a large matrix would then overrun a small thread's stack.
#pragma once

#include "base/config.h"
#include "base/memory.h"

namespace epode {

class Scratch {
  public:
    explicit Scratch(std::size_t count) : count_(count)
    {
        data_ = count <= kOnStack ? stack_ : static_cast<Real*>(allocate(count * sizeof(Real)));
    }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;
    ~Scratch()
    {
        if (data_ != stack_) release(data_, count_ * sizeof(Real));
    }

    bool ok() const { return data_; }  // false when memory is exhausted
    Real* data() { return data_; }

  private:
    static constexpr std::size_t kOnStack = 2048 / sizeof(Real);
    std::size_t count_;
    Real* data_;
    Real stack_[kOnStack];
};

}  // namespace epode
