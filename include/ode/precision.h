// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Chooses the real type of the whole interface: dSINGLE (float) or dDOUBLE (double).
// A client may ask with -DdIDESINGLE or -DdIDEDOUBLE; without either it gets double, which is
// what libode.so.8 is built with. The choice must match the library that is linked: the symbol
// names are the same in both builds, so a mismatch is not noticed by the linker.
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
