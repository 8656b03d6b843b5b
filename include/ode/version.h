/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * The ODE release whose programming interface these headers follow. A string: there is no numeric
 * form and no function that asks the library. */
#ifndef _ODE_VERSION_H_
#define _ODE_VERSION_H_

/** The ODE release, a string. */
#define dODE_VERSION "0.16.2"

#endif
