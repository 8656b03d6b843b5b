// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Timers.
#ifndef _ODE_TIMER_H_
#define _ODE_TIMER_H_

#include <ode/odeconfig.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct dStopwatch {
  double time;
  unsigned long cc[2];
} dStopwatch;

ODE_API void dStopwatchReset(dStopwatch *);
ODE_API void dStopwatchStart(dStopwatch *);
ODE_API void dStopwatchStop(dStopwatch *);
ODE_API double dStopwatchTime(dStopwatch *);
ODE_API void dTimerEnd(void);
ODE_API void dTimerNow(const char *description);
ODE_API void dTimerReport(FILE *fout, int average);
ODE_API double dTimerResolution(void);
ODE_API void dTimerStart(const char *description);
ODE_API double dTimerTicksPerSecond(void);

#ifdef __cplusplus
}
#endif

#endif
