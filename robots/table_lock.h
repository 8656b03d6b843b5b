// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The lock of the table of handles: many read, one writes. WebAssembly has one thread, and a standard library without locks.
#pragma once

#if defined(__wasm__)
namespace epode::robots {

struct TableMutex {};
struct ReadLock {
    explicit ReadLock(TableMutex&) {}
};
using WriteLock = ReadLock;

}  // namespace epode::robots
#else
#include <mutex>
#include <shared_mutex>

namespace epode::robots {

using TableMutex = std::shared_mutex;
using ReadLock = std::shared_lock<TableMutex>;
using WriteLock = std::unique_lock<TableMutex>;

}  // namespace epode::robots
#endif
