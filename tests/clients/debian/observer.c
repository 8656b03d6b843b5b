/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * Preloaded into a game, on either library: writes a line for each dWorldQuickStep to the file OBSERVE,
 *   step  h  bodies  contacts  then of each body  x y z speed
 * in the order of their creation, "start" when ODE is started and "end of world" when a world is destroyed. At the
 * steps listed in OBSERVE_HOLD the game waits until the file OBSERVE.go.STEP is there, so that keys are pressed at a
 * step and not at a time. The date stands still: games draw their random numbers from it. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <math.h>
#include <ode/ode.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

#define NEXT(name)                 \
    static __typeof__(&name) next; \
    if (!next) next = (__typeof__(&name))dlsym(RTLD_NEXT, #name)

enum { kCapacity = 4096, kReported = 64 };

static dBodyID bodies[kCapacity];
static int count, contacts, steps;

static FILE* out(void)
{
    static FILE* file;
    const char* path = getenv("OBSERVE");
    if (!file && path && (file = fopen(path, "w"))) setvbuf(file, NULL, _IOLBF, 0);
    return file;
}

static void say(const char* what)
{
    if (out()) fprintf(out(), "%s\n", what);
}

void dInitODE(void)
{
    NEXT(dInitODE);
    say("start");
    next();
}

dBodyID dBodyCreate(dWorldID world)
{
    NEXT(dBodyCreate);
    dBodyID body = next(world);
    if (count < kCapacity) bodies[count++] = body;
    return body;
}

void dBodyDestroy(dBodyID body)
{
    NEXT(dBodyDestroy);
    int i = 0;
    while (i < count && bodies[i] != body) ++i;
    if (i < count) --count;
    for (; i < count; ++i) bodies[i] = bodies[i + 1];
    next(body);
}

void dWorldDestroy(dWorldID world)
{
    NEXT(dWorldDestroy);
    count = 0;
    say("end of world");
    next(world);
}

dJointID dJointCreateContact(dWorldID world, dJointGroupID group, const dContact* contact)
{
    NEXT(dJointCreateContact);
    ++contacts;
    return next(world, group, contact);
}

static void hold(void)
{
    char name[1024];
    for (const char* at = getenv("OBSERVE_HOLD"); at && *at;) {
        char* end;
        const long wanted = strtol(at, &end, 10);
        snprintf(name, sizeof name, "%s.go.%ld", getenv("OBSERVE"), wanted);
        while (wanted == steps && access(name, F_OK)) usleep(1000);
        at = *end ? end + 1 : end;
    }
}

static void report(dReal h)
{
    if (!out()) return;
    fprintf(out(), "%d %g %d %d", steps++, h, count, contacts);
    contacts = 0;
    for (int i = 0; i < count && i < kReported; ++i) {
        const dReal *p = dBodyGetPosition(bodies[i]), *v = dBodyGetLinearVel(bodies[i]);
        fprintf(out(), " %.6f %.6f %.6f %.6f", p[0], p[1], p[2],
                sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]));
    }
    fputc('\n', out());
    hold();
}

int dWorldQuickStep(dWorldID world, dReal h)
{
    NEXT(dWorldQuickStep);
    const int done = next(world, h);
    report(h);
    return done;
}

int clock_gettime(clockid_t clock, struct timespec* time)
{
    if (clock != CLOCK_REALTIME) return (int)syscall(SYS_clock_gettime, clock, time);
    time->tv_sec = 1700000000;
    time->tv_nsec = 0;
    return 0;
}
