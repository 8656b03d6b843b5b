// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Which of the kernel sets that are compiled for several machines this one can run. Queried when the library
// is loaded, so that calls go through one pointer without a test. EPODE_KERNELS=baseline, avx2 or avx512 in
// the environment limits the choice; the bits are the same, which the variable makes it possible to show.
#pragma once

#include <cstddef>

namespace epode {

// How many of the kernels, in the order of those names, this machine can run. The last of them is the one to
// use.
std::size_t usable_kernels();

}  // namespace epode
