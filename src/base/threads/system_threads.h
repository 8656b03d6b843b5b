// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// POSIX threads, and on WebAssembly, which has one thread, what is left of them.
#pragma once

#if defined(__wasm__)
#include "base/threads/one_thread.h"
#else
#include <pthread.h>
#endif
