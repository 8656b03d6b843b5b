// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Structures of the interface that may grow. They begin with `unsigned struct_size`, which the program sets
// to the sizeof that it was compiled with; new fields are added at the end only. So a size tells which fields
// the program knows: from kSmallestSize, which has the first field, to the library's own. Larger ones are
// refused, not cut off: the program would ask for something that this library does not do. A new field must
// not begin in the padding at the end of what was there, else the old and the new structure have the same
// size.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <type_traits>

#include "base/check.h"

namespace epode {

// Each structure specialises this: the end of its first field after struct_size.
template <typename T>
inline constexpr std::size_t kSmallestSize = 0;

template <typename T>
constexpr bool accepts_size(unsigned size)
{
    static_assert(kSmallestSize<T> > 0 && offsetof(T, struct_size) == 0);
    return size >= kSmallestSize<T> && size <= sizeof(T) && size % alignof(T) == 0;
}

// The text that reports a refused size.
template <typename T>
class SizeRefusal {
  public:
    explicit SizeRefusal(unsigned size)
    {
        std::snprintf(text_, sizeof text_, "struct_size %u (accepted: multiples of %zu from %zu to %zu)",
                      size, alignof(T), kSmallestSize<T>, sizeof(T));
    }
    const char* text() const { return text_; }

  private:
    char text_[120];
};

// The program's structure; fields that it does not have are those of `defaults`. (Bounded here too, for
// builds without checks.)
template <typename T>
T completed(const T& given, T defaults)
{
    std::memcpy(&defaults, &given, std::min<std::size_t>(given.struct_size, sizeof(T)));
    defaults.struct_size = sizeof(T);
    return defaults;
}

// As much of it as the program's structure has.
template <typename T>
void copy_sized(const T& from, T* to, unsigned size)
{
    std::memcpy(to, &from, std::min<std::size_t>(size, sizeof(T)));
    to->struct_size = size;
}

}  // namespace epode

// Refuses a null pointer, and a structure of a size that is not accepted: its own, or one that is given.
#define EPODE_SIZED(pointer, ...)                   \
    EPODE_USER(pointer __VA_OPT__(, ) __VA_ARGS__); \
    EPODE_SIZED_AS(pointer, (pointer)->struct_size __VA_OPT__(, ) __VA_ARGS__)
#define EPODE_SIZED_AS(pointer, size, ...)                                \
    EPODE_USER(pointer __VA_OPT__(, ) __VA_ARGS__);                       \
    EPODE_USER_SAY(::epode::accepts_size<EPODE_STRUCT_OF(pointer)>(size), \
                   ::epode::SizeRefusal<EPODE_STRUCT_OF(pointer)>(size).text() __VA_OPT__(, ) __VA_ARGS__)
#define EPODE_STRUCT_OF(pointer) std::remove_cv_t<std::remove_pointer_t<decltype(pointer)>>
