/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * The version of drawstuff's interface. */
#ifndef EPODE_DRAWSTUFF_VERSION_H
#define EPODE_DRAWSTUFF_VERSION_H

/** The high byte counts incompatible changes, the low byte additions. */
#define DS_VERSION 0x0002

#endif
