// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What a joint reads of its bodies, kept until what it follows from changes: a step reads a position several
// times at one pose, for the stops and for the drive of each axis. `From` has nothing but Reals, and all that
// the value depends on, so that nobody has to say when it is out of date.
#pragma once

#include <cstring>

#include "base/config.h"

namespace epode {

template <typename From, typename Value>
class Reading {
  public:
    // `read`: returns the value that follows from these numbers.
    template <typename Read>
    const Value& of(const From& from, Read read) const
    {
        static_assert(sizeof(From) % sizeof(Real) == 0 && alignof(From) == alignof(Real), "without gaps");
        if (!known_ || std::memcmp(&from, &from_, sizeof from) != 0)
            from_ = from, value_ = read(), known_ = true;
        return value_;
    }

  private:
    mutable From from_;
    mutable Value value_;
    mutable bool known_ = false;
};

}  // namespace epode
