// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Whether a function that has put an object on the calling thread's stack is still running: what unwinding shows.
#pragma once

#include <cstdint>

namespace epode {

// `bottom`: where the stack ended when the function called another one; 0: not known. True also where stacks cannot be
// unwound, or not as far as that.
[[gnu::cold]] bool may_be_running(const void* object, std::uintptr_t bottom);

}  // namespace epode
