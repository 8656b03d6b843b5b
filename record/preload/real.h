// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What all hooks have in common: the library's own function of a name, and the observer. A call that the
// library makes itself, while it serves one of the program's, is not the program's: only the outermost is
// reported.
#pragma once

#include "record/preload/observer.h"

namespace epode::record {

void* find_real(const char* name);

template <class Function>
Function find(const char* name)
{
    return reinterpret_cast<Function>(find_real(name));
}

// Null: nothing is recorded.
const Observer* observer();

template <class... Arguments, class... Given>
void notify(void (*Observer::*what)(Arguments...), Given... given)
{
    if (const Observer* listening = observer()) (listening->*what)(given...);
}

// Whether this thread is in a moved callback of the program's, and so in the middle of a step
// (callbacks.cpp).
bool in_callback();
// What is changed there cannot be done again between steps: the recording receives its name.
inline void change(const char* in_a_callback)
{
    if (in_callback()) notify(&Observer::called, in_a_callback, static_cast<const Given*>(nullptr), 0);
}

class Outermost {
  public:
    Outermost() { ++depth_; }
    ~Outermost() { --depth_; }
    Outermost(const Outermost&) = delete;
    Outermost& operator=(const Outermost&) = delete;
    explicit operator bool() const { return depth_ == 1; }

  private:
    static thread_local int depth_;
};

}  // namespace epode::record

// The library's own function of that name, whatever is returned where it has none.
#define EPODE_REAL(name)                                                  \
    static const auto real = epode::record::find<decltype(&name)>(#name); \
    if (!real) return                                                     \
        {}
#define EPODE_REAL_VOID(name)                                             \
    static const auto real = epode::record::find<decltype(&name)>(#name); \
    if (!real) return
