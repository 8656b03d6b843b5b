/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * Wall-clock timing: stopwatches that add up, and one process-wide list of timed events. */
#ifndef _ODE_TIMER_H_
#define _ODE_TIMER_H_

#include <ode/odeconfig.h>

#ifdef __cplusplus
extern "C" {
#endif

/** @chapter timers Timers

    Refused: [dStopwatch] a null stopwatch; [dTimerStart, dTimerNow] a null description; [dTimerReport] a
    null file. Nothing changes then, and the answer is 0. */

/** A stopwatch. The members are the library's business; set it up with dStopwatchReset. */
typedef struct dStopwatch {
    double time;         /**< the library's */
    unsigned long cc[2]; /**< the library's */
} dStopwatch;

/** - dStopwatchReset: Set the stopwatch s back to zero.
    - dStopwatchStart: Start the stopwatch s.
    - dStopwatchStop: Stop the stopwatch s and add the time since its start.
    - dStopwatchTime: The total time of the stopwatch s, in seconds. [0.16] */
ODE_API void dStopwatchReset(dStopwatch* s);
ODE_API void dStopwatchStart(dStopwatch* s);
ODE_API void dStopwatchStop(dStopwatch* s);
ODE_API double dStopwatchTime(dStopwatch* s);

/** - dTimerStart: Begin a new list of events with one of this description, which is not copied and must live
      until the report.
    - dTimerNow: Begin the next event, of this description, which is not copied and must live until the
      report. At most 100 events count.
    - dTimerEnd: End the list of events. [0.16] */
ODE_API void dTimerStart(const char* description);
ODE_API void dTimerNow(const char* description);
ODE_API void dTimerEnd(void);

/** Print the time and share of each event to fout. average != 0: also the means over all lists so far whose
    events were the same. [0.16] */
ODE_API void dTimerReport(FILE* fout, int average);

/** - dTimerTicksPerSecond: Ticks of the clock per second.
    - dTimerResolution: The smallest step of the clock that can be seen, in seconds. [0.16] */
ODE_API double dTimerTicksPerSecond(void);
ODE_API double dTimerResolution(void);

#ifdef __cplusplus
}
#endif

#endif
