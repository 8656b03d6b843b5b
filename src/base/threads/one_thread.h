// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Those of POSIX threads' names that the library uses, for a system with one thread. No thread can be
// created, which callers expect of any system. Mutexes still know whether they are locked: one that checks
// errors refuses its owner a second time. A wait that has no time limit would never end: it traps, so that the
// host reports it and does not hang. Rejected: functions of our own for all systems, because POSIX's are what
// readers know.
#pragma once

#include <time.h>

#include <cerrno>
#include <cstddef>

namespace epode {  // the C library declares some of these types, without the functions

enum { PTHREAD_MUTEX_NORMAL, PTHREAD_MUTEX_RECURSIVE, PTHREAD_MUTEX_ERRORCHECK };

struct pthread_mutexattr_t {
    int kind;
};
struct pthread_mutex_t {
    int kind, held;
};
struct pthread_cond_t {};
struct pthread_condattr_t {};
struct pthread_attr_t {};
struct pthread_t {};

inline int pthread_mutexattr_init(pthread_mutexattr_t* a) { return a->kind = PTHREAD_MUTEX_NORMAL, 0; }
inline int pthread_mutexattr_settype(pthread_mutexattr_t* a, int kind) { return a->kind = kind, 0; }
inline int pthread_mutexattr_destroy(pthread_mutexattr_t*) { return 0; }

inline int pthread_mutex_init(pthread_mutex_t* m, const pthread_mutexattr_t* a)
{
    *m = {a ? a->kind : int(PTHREAD_MUTEX_NORMAL), 0};
    return 0;
}
inline int pthread_mutex_destroy(pthread_mutex_t*) { return 0; }
inline int pthread_mutex_lock(pthread_mutex_t* m)
{
    if (m->held && m->kind == PTHREAD_MUTEX_ERRORCHECK) return EDEADLK;
    if (m->held && m->kind == PTHREAD_MUTEX_NORMAL) __builtin_trap();
    ++m->held;
    return 0;
}
inline int pthread_mutex_trylock(pthread_mutex_t* m)
{
    if (m->held && m->kind != PTHREAD_MUTEX_RECURSIVE) return EBUSY;
    ++m->held;
    return 0;
}
inline int pthread_mutex_unlock(pthread_mutex_t* m)
{
    if (!m->held) return EPERM;
    --m->held;
    return 0;
}

inline int pthread_condattr_init(pthread_condattr_t*) { return 0; }
inline int pthread_condattr_setclock(pthread_condattr_t*, clockid_t) { return 0; }
inline int pthread_condattr_destroy(pthread_condattr_t*) { return 0; }
inline int pthread_cond_init(pthread_cond_t*, const pthread_condattr_t*) { return 0; }
inline int pthread_cond_destroy(pthread_cond_t*) { return 0; }
inline int pthread_cond_signal(pthread_cond_t*) { return 0; }
inline int pthread_cond_broadcast(pthread_cond_t*) { return 0; }
[[noreturn]] inline int pthread_cond_wait(pthread_cond_t*, pthread_mutex_t*) { __builtin_trap(); }
// Wakes at once, as every wait may: the caller looks at the time and waits again.
inline int pthread_cond_timedwait(pthread_cond_t*, pthread_mutex_t*, const timespec*) { return 0; }

inline int pthread_attr_init(pthread_attr_t*) { return 0; }
inline int pthread_attr_setstacksize(pthread_attr_t*, std::size_t) { return 0; }
inline int pthread_attr_destroy(pthread_attr_t*) { return 0; }
inline int pthread_create(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*) { return EAGAIN; }
inline int pthread_join(pthread_t, void**) { return ESRCH; }

}  // namespace epode
