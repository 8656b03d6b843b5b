/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * What every other header needs first: the system headers that ODE programs rely on getting, the
 * linkage macros, integers of known width, infinity and not-a-number.
 * The integer types keep ODE's exact underlying types (`long`, not `long long`, on 64-bit Linux),
 * because C++ name mangling and printf formats of client programs depend on them. */
#ifndef _ODE_ODECONFIG_H_
#define _ODE_ODECONFIG_H_

#include <float.h>
#include <limits.h>
#include <math.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <ode/precision.h>

/* ---- linkage ---- */

/* ODE_API marks what the library exports. It is compiled with hidden visibility, so a function
    without this mark cannot be reached from outside. */
#if !defined(ODE_API)
#if defined(_MSC_VER) && defined(ODE_DLL)
#define ODE_API __declspec(dllexport)
#elif defined(__GNUC__) && !defined(_WIN32)
#define ODE_API __attribute__((visibility("default")))
#else
#define ODE_API
#endif
#endif

/** Still there and working, but a newer name should be used. */
#if defined(_MSC_VER)
#define ODE_API_DEPRECATED __declspec(deprecated)
#elif defined(__GNUC__)
#define ODE_API_DEPRECATED __attribute__((__deprecated__))
#else
#define ODE_API_DEPRECATED
#endif

/** A function compiled into every file that uses it; no library symbol stands behind it. */
#define ODE_PURE_INLINE static __inline
#define ODE_INLINE __inline

/** C linkage. */
#if defined(__cplusplus)
#define ODE_EXTERN_C extern "C"
#else
#define ODE_EXTERN_C
#endif

/** The function does not come back to its caller. */
#if defined(__GNUC__)
#define ODE_NORETURN __attribute__((noreturn))
#elif defined(_MSC_VER)
#define ODE_NORETURN __declspec(noreturn)
#else
#define ODE_NORETURN
#endif

/* ---- integers ---- */

#if defined(__x86_64__) && defined(__LP64__)

/** An x86-64 system with 64-bit pointers. */
#define X86_64_SYSTEM 1
/** Integers by their width in bits. */
typedef long dint64;
typedef unsigned long duint64;
typedef int dint32;
typedef unsigned int duint32;
typedef short dint16;
typedef unsigned short duint16;
typedef signed char dint8;
typedef unsigned char duint8;

typedef dint64 dintptr;   /**< holds a pointer, signed */
typedef duint64 duintptr; /**< holds a pointer, unsigned */
typedef dint64 ddiffint;  /**< difference of two sizes */
typedef duint64 dsizeint; /**< size of an object in bytes, count of elements */

#else

#include <stdint.h>
typedef int64_t dint64;
typedef uint64_t duint64;
typedef int32_t dint32;
typedef uint32_t duint32;
typedef int16_t dint16;
typedef uint16_t duint16;
typedef int8_t dint8;
typedef uint8_t duint8;

typedef intptr_t dintptr;
typedef uintptr_t duintptr;
typedef ptrdiff_t ddiffint;
typedef size_t dsizeint;

#endif

/* ---- special reals ---- */

/** Positive infinity of the real type: "no limit" wherever a limit is asked for. */
#ifdef dSINGLE
#define dInfinity ((float)INFINITY)
#else
#define dInfinity ((double)INFINITY)
#endif

/** A quiet not-a-number (of type float, as NAN is). */
#define dNaN NAN

/** What dCopySign and dNextAfter (common.h) stand for. */
#define _ode_copysignf(x, y) copysignf(x, y)
#define _ode_copysign(x, y) copysign(x, y)
#define _ode_nextafterf(x, y) nextafterf(x, y)
#define _ode_nextafter(x, y) nextafter(x, y)

/* ---- the precision of a program and of its library ---- */

/* A program for float that is linked with a library for double is refused, since only libode_single has the
    first of these two names. A program for double that is linked with libode_single is refused, since that
    library asks for the second name, which only programs for float bring along. The names are the linker's
    message. Programs for double are not touched at all. */
#if defined(dSINGLE) && defined(__ELF__) && defined(__GNUC__)
#ifdef __cplusplus
extern "C" {
#endif
ODE_API extern const char dSinglePrecisionProgram_LinkWith_ode_single;
extern __attribute__((visibility("default"))) char dDoublePrecisionProgram_CompileWith_dIDESINGLE;
#if !defined(EPODE_BUILDS_LIBRARY)
#if defined(__has_attribute)
#if __has_attribute(retain)
__attribute__((retain))
#endif
#endif
__attribute__((used)) static const char* const ode_wanted_library =
    &dSinglePrecisionProgram_LinkWith_ode_single;
__attribute__((weak)) char dDoublePrecisionProgram_CompileWith_dIDESINGLE = 1;
#endif
#ifdef __cplusplus
}
#endif
#endif

#endif
