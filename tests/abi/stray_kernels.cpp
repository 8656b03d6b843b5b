// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What kernels for a better machine must not be: fused, and a function that the linker may give to everybody.
template <typename T>
[[gnu::noinline]] T stray_sum(T a, T b)
{
    return a + b;
}

double stray_kernel(double a, double b, double c) { return stray_sum(__builtin_fma(a, b, c), c); }
