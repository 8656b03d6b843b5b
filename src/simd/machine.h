// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Which of the texts that are compiled for several machines this one can run. Asked when the library is
// loaded, so that calls go through one pointer and no test. EPODE_KERNELS=baseline, avx2 or avx512 in the
// environment keeps to those: the bits are the same, which is what it is there to show.
#pragma once

#include <cstddef>

namespace epode {

// Of the kernels in the order of those names, as many as may be called: the last is the one to call.
std::size_t usable_kernels();

}  // namespace epode
