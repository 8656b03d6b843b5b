// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The interpreter's lock, let go while the engine works and taken where it calls back.
//
// An interpreter that ends never gives the lock to a daemon thread again: before CPython 3.14 it ends such a thread by
// pthread_exit() within the call that asks for the lock. glibc unwinds the thread's stack for that, and where functions must not
// throw, as destructors and much of the engine, std::terminate() ends the whole program with SIGABRT. Here such a thread
// waits until the process ends, which is what 3.14 does.
#pragma once

#include <Python.h>

#if defined(__GLIBC__)
#include <cxxabi.h>
#include <unistd.h>
#endif

template <typename F>
auto or_wait_for_the_end(F take)
{
#if defined(__GLIBC__)
    try {
        return take();
    } catch (abi::__forced_unwind&) {
        for (;;) pause();
    }
#else
    return take();
#endif
}

class WithoutGil {
  public:
    WithoutGil() : state_(PyEval_SaveThread()) {}
    ~WithoutGil()
    {
        or_wait_for_the_end([this] { PyEval_RestoreThread(state_); });
    }
    WithoutGil(const WithoutGil&) = delete;

  private:
    PyThreadState* const state_;
};

class WithGil {
  public:
    WithGil() : state_(or_wait_for_the_end(PyGILState_Ensure)) {}
    ~WithGil() { PyGILState_Release(state_); }
    WithGil(const WithGil&) = delete;

  private:
    const PyGILState_STATE state_;
};
