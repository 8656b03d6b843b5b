// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What every operation on short vectors is marked with: it must vanish into its caller, for a call would cost
// more than the operation, and passing vectors depends on the machine that the caller is compiled for.
#pragma once

#define EPODE_LANEWISE [[gnu::always_inline]] inline
// Behind the arguments of a lambda.
#define EPODE_INLINE_LAMBDA __attribute__((always_inline))
