/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * How the library speaks: three channels (error, debug, message), each with a handler that the
 * program may install.
 *
 * What the library itself does with them: an argument that makes no sense (null or wrong object,
 * NaN, zero axis, negative size ...) makes that one call *refused*. A refused call changes nothing,
 * returns 0 / NULL where it returns something, and reports through the debug handler with number
 * d_ERR_UASSERT and a text of the form "what is wrong in function()". If no handler is installed
 * the text goes to stderr once per place in the code. The program always goes on. The
 * original library calls abort() there; that is the one deliberate difference in this interface. */
#ifndef _ODE_ERROR_H_
#define _ODE_ERROR_H_

#include <ode/odeconfig.h>

#ifdef __cplusplus
extern "C" {
#endif

/** @chapter errors Errors and messages

    Refused: [dMessage] a null text. */

/** A handler. errnum: one of the d_ERR_... numbers of common.h, 0 when unknown; msg: printf format;
    ap: its arguments, which the handler may consume once. */
typedef void dMessageFunction(int errnum, const char* msg, va_list ap);

/** Handlers are process-wide; install them before other threads use the library. A handler may leave by
    longjmp or by a C++ exception, also inside callbacks (docs/errors.md says what then becomes of the call around it;
    inside functions for memory or threads it must return). NULL brings the default back, which prints to the standard error stream.
    - dSetErrorHandler: Install the handler fn, which dError calls.
    - dSetDebugHandler: Install the handler fn, which dDebug calls.
    - dSetMessageHandler: Install the handler fn, which dMessage calls. [0.16] */
ODE_API void dSetErrorHandler(dMessageFunction* fn);
ODE_API void dSetDebugHandler(dMessageFunction* fn);
ODE_API void dSetMessageHandler(dMessageFunction* fn);

/** - dGetErrorHandler: The handler that dSetErrorHandler has installed, or NULL if it is the default one.
    - dGetDebugHandler: The handler that dSetDebugHandler has installed, or NULL if it is the default one.
    - dGetMessageHandler: The handler that dSetMessageHandler has installed, or NULL if it is the default
      one. [0.16] */
ODE_API dMessageFunction* dGetErrorHandler(void);
ODE_API dMessageFunction* dGetDebugHandler(void);
ODE_API dMessageFunction* dGetMessageHandler(void);

/** For programs: report a fatal user-level error and leave the process with exit(1), also when a
    handler returns. num: error number, shown unless 0; msg, ...: as for printf. [0.16] */
ODE_API void ODE_NORETURN dError(int num, const char* msg, ...);

/** For programs: report a broken assumption, as dError does (num, msg, ...), and abort(), also when a handler
 * returns. [0.16] */
ODE_API void ODE_NORETURN dDebug(int num, const char* msg, ...);

/** Report something worth knowing (num, msg, ... as for dError) and go on. [0.16] */
ODE_API void dMessage(int num, const char* msg, ...);

#ifdef __cplusplus
}
#endif

#endif
