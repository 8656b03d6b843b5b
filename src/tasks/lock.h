// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A mutex, a condition variable and a deadline over plain pthreads. std::mutex and std::condition_variable
// report failures by exceptions, which src/ is compiled without, and cannot be recreated in the child of a
// fork. Time is that of the monotonic clock: setting the machine's clock neither ends nor prolongs a wait.
#pragma once

#include <time.h>

#include <new>

#include "base/threads/system_threads.h"

namespace epode {

class Lock {
  public:
    Lock() { pthread_mutex_init(&mutex_, nullptr); }
    Lock(const Lock&) = delete;
    Lock& operator=(const Lock&) = delete;
    ~Lock() { pthread_mutex_destroy(&mutex_); }

    void lock() { pthread_mutex_lock(&mutex_); }
    void unlock() { pthread_mutex_unlock(&mutex_); }

  private:
    friend class Condition;
    pthread_mutex_t mutex_;
};

class Guard {
  public:
    explicit Guard(Lock& lock) : lock_(lock) { lock_.lock(); }
    Guard(const Guard&) = delete;
    Guard& operator=(const Guard&) = delete;
    ~Guard() { lock_.unlock(); }

  private:
    Lock& lock_;
};

// When a wait ends: never, at once, or at a time.
class Deadline {
  public:
    static Deadline never() { return {}; }
    // `seconds` from now; a time that is past or now is `at_once`, one beyond 30 years is `never`.
    static Deadline after(time_t seconds, unsigned long nanoseconds)
    {
        constexpr long kSecond = 1000000000, kEver = 30L * 365 * 86400;
        Deadline d;
        if (nanoseconds / kSecond > (unsigned long)kEver || seconds > kEver) return d;
        seconds += time_t(nanoseconds / kSecond);
        nanoseconds %= kSecond;
        if (seconds > kEver) return d;
        d.limited_ = true;
        d.at_once_ = seconds < 0 || (seconds == 0 && nanoseconds == 0);
        if (d.at_once_) return d;
        clock_gettime(CLOCK_MONOTONIC, &d.at_);
        d.at_.tv_sec += seconds;
        d.at_.tv_nsec += long(nanoseconds);
        if (d.at_.tv_nsec >= kSecond) ++d.at_.tv_sec, d.at_.tv_nsec -= kSecond;
        return d;
    }

    bool limited() const { return limited_; }
    bool at_once() const { return at_once_; }
    bool passed() const
    {
        if (!limited_ || at_once_) return at_once_;
        timespec now;
        clock_gettime(CLOCK_MONOTONIC, &now);
        return now.tv_sec > at_.tv_sec || (now.tv_sec == at_.tv_sec && now.tv_nsec >= at_.tv_nsec);
    }

  private:
    friend class Condition;
    bool limited_ = false, at_once_ = false;
    timespec at_{};
};

class Condition {
  public:
    Condition()
    {
        pthread_condattr_t attributes;
        pthread_condattr_init(&attributes);
        pthread_condattr_setclock(&attributes, CLOCK_MONOTONIC);
        pthread_cond_init(&condition_, &attributes);
        pthread_condattr_destroy(&attributes);
    }
    Condition(const Condition&) = delete;
    Condition& operator=(const Condition&) = delete;
    ~Condition() { pthread_cond_destroy(&condition_); }

    // The lock is held on entry and on return. May wake without a reason: callers check their condition
    // again.
    void wait(Lock& lock) { pthread_cond_wait(&condition_, &lock.mutex_); }
    void wait(Lock& lock, const Deadline& until)
    {
        if (until.limited_)
            pthread_cond_timedwait(&condition_, &lock.mutex_, &until.at_);
        else
            wait(lock);
    }
    void wake_one() { pthread_cond_signal(&condition_); }
    void wake_all() { pthread_cond_broadcast(&condition_); }

    // For the child of a fork, where the waiting threads do not exist.
    void renew() { new (this) Condition; }

  private:
    pthread_cond_t condition_;
};

}  // namespace epode
