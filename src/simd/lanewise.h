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
