// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What tests ask of a system and WebAssembly lacks, so that their files compile: every test file includes it
// there. A test that uses one of these ends the program with an error; tests/wasm/skipped lists those that
// would.
#pragma once

#if defined(__cplusplus)
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <string>

#include <unistd.h>

[[noreturn]] inline void absent(const char* what)
{
    std::fprintf(stderr, "WebAssembly has no %s: this test belongs in tests/wasm/skipped\n", what);
    std::abort();
}

extern "C" inline FILE* tmpfile()
{
    char path[] = "/tmp/epode_wasm_test";
    std::FILE* const file = std::fopen(path, "w+");
    if (file) unlink(path);
    return file;
}

namespace std {

class mutex {
  public:
    void lock() {}
    void unlock() {}
    bool try_lock() { return true; }
};

class thread {
  public:
    struct id {
        bool operator==(const id&) const = default;
        auto operator<=>(const id&) const = default;
    };
    thread() = default;
    template <typename Function, typename... Arguments>
    explicit thread(Function&&, Arguments&&...)
    {
        absent("threads");
    }
    void join() {}
    static unsigned hardware_concurrency() { return 1; }
};

namespace this_thread {
inline thread::id get_id() { return {}; }
inline void yield() {}
template <typename Duration>
void sleep_for(const Duration& time)
{
    for (const auto end = chrono::steady_clock::now() + time; chrono::steady_clock::now() < end;) {}
}
}  // namespace this_thread

}  // namespace std

// GoogleTest's: they exchange descriptors and start processes.
namespace testing::internal {
inline void CaptureStderr() { absent("dup"); }
inline void CaptureStdout() { absent("dup"); }
inline std::string GetCapturedStderr() { absent("dup"); }
inline std::string GetCapturedStdout() { absent("dup"); }
}  // namespace testing::internal
#define EXPECT_EXIT(...) absent("processes")
#define EXPECT_DEATH(...) absent("processes")
#endif
