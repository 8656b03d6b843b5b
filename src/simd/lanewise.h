// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What every operation on short vectors is marked with: it must vanish into its caller, for a call would cost
// more than the operation. Where sanitizers watch, that is not asked: kernels of one function each take them
// ten times as long to compile. Passing vectors depends on the machine that the caller is compiled for, so
// operations that several machines compile are in anonymous namespaces.
#pragma once

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define EPODE_LANEWISE inline
#define EPODE_INLINE_LAMBDA
#else
#define EPODE_LANEWISE [[gnu::always_inline]] inline
// Behind the arguments of a lambda.
#define EPODE_INLINE_LAMBDA __attribute__((always_inline))
#endif

namespace epode {
namespace {

// Returns p, of which the compiler no longer knows that it is p. What lies there is then loaded a second time
// where it is needed, instead of being kept from the first load on: in a kernel whose registers are all in
// use, compilers keep such numbers on the stack, which takes more instructions than to load them again.
template <typename T>
EPODE_LANEWISE const T* reload(const T* p)
{
    asm("" : "+r"(p));
    return p;
}

}  // namespace
}  // namespace epode
