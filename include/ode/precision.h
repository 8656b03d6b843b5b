/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * Chooses the real type of the whole interface: dSINGLE (float) or dDOUBLE (double).
 * A program asks with -DdIDESINGLE or -DdIDEDOUBLE and links the library of that precision: libode_single or
 * libode. Without either it gets double. Functions have the same names in both, so a mistake would go
 * unnoticed and compute nonsense; ode/odeconfig.h sees to it that the linker refuses. */
#ifndef _ODE_PRECISION_H_
#define _ODE_PRECISION_H_

#if defined(dIDESINGLE)
#define dSINGLE
#elif defined(dIDEDOUBLE)
#define dDOUBLE
#else
#define dDOUBLE
#endif

#endif
