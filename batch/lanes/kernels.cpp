// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See kernels.h.
#include "batch/lanes/kernels.h"

#include <algorithm>

#include "simd/machine.h"

namespace epode::batch {

extern const Kernels<float> kBaselineFloatKernels, kAvx2FloatKernels, kAvx512FloatKernels;
extern const Kernels<double> kBaselineDoubleKernels, kAvx2DoubleKernels, kAvx512DoubleKernels;

namespace {

template <typename T>
const Kernels<T>& chosen(std::initializer_list<const Kernels<T>*> all)
{
    return **(all.begin() + std::min(all.size(), usable_kernels()) - 1);
}

}  // namespace

#if defined(__x86_64__) && !defined(EPODE_BASELINE)
template <>
const Kernels<float>& best_kernels<float>()
{
    return chosen<float>({&kBaselineFloatKernels, &kAvx2FloatKernels, &kAvx512FloatKernels});
}

template <>
const Kernels<double>& best_kernels<double>()
{
    return chosen<double>({&kBaselineDoubleKernels, &kAvx2DoubleKernels, &kAvx512DoubleKernels});
}
#else
template <>
const Kernels<float>& best_kernels<float>()
{
    return kBaselineFloatKernels;
}

template <>
const Kernels<double>& best_kernels<double>()
{
    return kBaselineDoubleKernels;
}
#endif

}  // namespace epode::batch
