// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Stopwatches and the one list of named events that dTimerStart, dTimerNow and dTimerEnd fill. Ticks are
// nanoseconds of the monotonic clock: ODE reads the wall clock in microseconds, which jumps when it is set.
// A slot lasts from its event to the next one; the closing event stands for the whole. Averages run over the
// lists that dTimerEnd has closed, slot by slot.
#include <time.h>
#include <cstdio>
#include <cstring>
#include <mutex>

#include "ode/timer.h"

#include "base/check.h"
#include "base/objects/pool.h"

using namespace epode;

namespace {

using Ticks = std::uint64_t;
constexpr double kTicksPerSecond = 1e9;

Ticks now()
{
    timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return Ticks(t.tv_sec) * 1000000000u + Ticks(t.tv_nsec);
}

// dStopwatch::cc keeps the start in two words, each of which has 32 bits on some machines.
void split(Ticks t, unsigned long cc[2])
{
    cc[0] = static_cast<unsigned long>(t & 0xffffffffu);
    cc[1] = static_cast<unsigned long>(t >> 32);
}

Ticks joined(const unsigned long cc[2]) { return Ticks(cc[0]) | Ticks(cc[1]) << 32; }

constexpr int kMaxSlots = 100;

struct Slot {
    const char* name;
    Ticks start;
    double total_ticks;  // over all closed lists
    int lists;
};

struct EventList {
    SpinLock lock;
    int count = 0;
    Slot slots[kMaxSlots] = {};
};

EventList g_events;

// The last slot is kept free for the closing event.
void append(const char* name, bool closing)
{
    if (g_events.count >= (closing ? kMaxSlots : kMaxSlots - 1)) return;
    Slot& slot = g_events.slots[g_events.count++];
    slot.name = name;
    slot.start = now();
}

// Slot i lasts until slot i + 1 begins, the last one from the beginning to its event.
Ticks duration(int i)
{
    const Slot* s = g_events.slots;
    const int last = g_events.count - 1;
    return i == last ? s[last].start - s[0].start : s[i + 1].start - s[i].start;
}

void print_share(FILE* out, double ticks, double whole)
{
    const double share = whole > 0 ? ticks / whole : 1;
    std::fprintf(out, "%7.2fms %6.2f%%", ticks / kTicksPerSecond * 1e3, share * 100);
}

void print_slot(FILE* out, int i, int width, bool average)
{
    const Slot& slot = g_events.slots[i];
    const Slot& last = g_events.slots[g_events.count - 1];
    std::fprintf(out, "%-*s ", width, slot.name);
    print_share(out, double(duration(i)), double(duration(g_events.count - 1)));
    if (average && slot.lists && last.lists) {
        std::fprintf(out, "  (avg ");
        print_share(out, slot.total_ticks / slot.lists, last.total_ticks / last.lists);
        std::fprintf(out, ")");
    }
    std::fputc('\n', out);
}

void print_heading(FILE* out)
{
    double resolution = dTimerResolution();
    const char* unit = "ns";
    if (resolution >= 1e-3) {
        resolution *= 1e3, unit = "ms";
    } else if (resolution >= 1e-6) {
        resolution *= 1e6, unit = "us";
    } else {
        resolution *= 1e9;
    }
    std::fprintf(out, "\nTimer Report (%.2f %s resolution)\n------------\n", resolution, unit);
}

}  // namespace

extern "C" void dStopwatchReset(dStopwatch* s)
{
    EPODE_USER(s);
    s->time = 0;
    split(0, s->cc);
}

extern "C" void dStopwatchStart(dStopwatch* s)
{
    EPODE_USER(s);
    split(now(), s->cc);
}

extern "C" void dStopwatchStop(dStopwatch* s)
{
    EPODE_USER(s);
    s->time += double(now() - joined(s->cc));
}

extern "C" double dStopwatchTime(dStopwatch* s)
{
    EPODE_USER(s, 0);
    return s->time / kTicksPerSecond;
}

extern "C" void dTimerStart(const char* description)
{
    EPODE_USER(description);
    std::lock_guard guard(g_events.lock);
    g_events.count = 0;
    append(description, false);
}

extern "C" void dTimerNow(const char* description)
{
    EPODE_USER(description);
    std::lock_guard guard(g_events.lock);
    append(description, false);
}

extern "C" void dTimerEnd(void)
{
    std::lock_guard guard(g_events.lock);
    append("TOTAL", true);
    for (int i = 0; i < g_events.count; ++i) {
        g_events.slots[i].total_ticks += double(duration(i));
        ++g_events.slots[i].lists;
    }
}

extern "C" void dTimerReport(FILE* fout, int average)
{
    EPODE_USER(fout);
    std::lock_guard guard(g_events.lock);
    print_heading(fout);
    int width = 0;
    for (int i = 0; i < g_events.count; ++i) {
        const int length = int(std::strlen(g_events.slots[i].name));
        width = length > width ? length : width;
    }
    for (int i = 0; i < g_events.count; ++i) print_slot(fout, i, width, average != 0);
    std::fputc('\n', fout);
}

extern "C" double dTimerTicksPerSecond(void) { return kTicksPerSecond; }

extern "C" double dTimerResolution(void)
{
    timespec t;
    clock_getres(CLOCK_MONOTONIC, &t);
    return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
}
