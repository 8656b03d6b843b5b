// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The attribute of every operation on short vectors: it must be inlined, because a call would cost more than
// the operation. Sanitizer builds do not force it: kernels that are one function each would take ten times as
// long to compile. How vectors are passed depends on the machine that the caller is compiled for, so
// operations that are compiled for several machines are in unnamed namespaces.
#pragma once

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define EPODE_LANEWISE inline
#define EPODE_INLINE_LAMBDA
#else
#define EPODE_LANEWISE [[gnu::always_inline]] inline
// Stands behind the arguments of a lambda.
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
