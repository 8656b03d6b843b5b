// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Compiles only if a C program sees the layouts, constants and types of layouts.inc in our headers.
// Built in both precisions whatever the library's own is: layouts are a matter of the headers alone.
#include <ode/ode.h>

#ifdef dSINGLE
#define PICK(dbl, sgl) (sgl)
#else
#define PICK(dbl, sgl) (dbl)
#endif

#define SIZE(type, dbl, sgl) _Static_assert(sizeof(type) == PICK(dbl, sgl), "size of " #type);
#define ALIGN(type, dbl, sgl) _Static_assert(_Alignof(type) == PICK(dbl, sgl), "alignment of " #type);
#define FIELD(type, member, at_dbl, dbl, at_sgl, sgl)                                               \
    _Static_assert(offsetof(type, member) == PICK(at_dbl, at_sgl), "offset of " #type "." #member); \
    _Static_assert(sizeof(((type*)0)->member) == PICK(dbl, sgl), "size of " #type "." #member);
#define VALUE(constant, value) _Static_assert((constant) == (value), #constant);
#define FUNCTION(type, result, parameters) \
    _Static_assert(_Generic((type*)0, result(*) parameters : 1, default : 0), "type " #type);
#define ALIAS(type, same) _Static_assert(_Generic((type)0, same : 1, default : 0), "type " #type);

#include "layouts.inc"

_Static_assert(_Generic((dReal)0, float : sizeof(float), double : sizeof(double)) == PICK(8, 4), "dReal");
_Static_assert(_Generic(dInfinity, float : 4, double : 8) == PICK(8, 4), "type of dInfinity");
_Static_assert(_Generic(REAL(0.5), float : 4, double : 8) == PICK(8, 4), "type of REAL");
_Static_assert(sizeof(dODE_VERSION) == sizeof("0.16.2"), "dODE_VERSION");
