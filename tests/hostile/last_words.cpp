// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// An alarm rings when the processor has worked for two minutes and no call has begun, or nothing has happened
// for twenty. The handler formats a text, which a signal handler should not: the process is lost anyway, and
// mostly it works.
#include "last_words.h"

#include <sys/time.h>
#include <csignal>
#include <cstdio>

#if defined(HOSTILE_UNDER_ASAN)
#include <sanitizer/common_interface_defs.h>
// A size that no machine has is answered by null, as malloc does.
extern "C" const char* __asan_default_options() { return "allocator_may_return_null=1"; }
#endif

namespace hostile {
namespace {

std::function<std::string()> g_words;
constexpr long kWork = 120, kPatience = 1200;  // seconds

void say()
{
    if (g_words) std::fprintf(stderr, "\nthe last call was %s\n", g_words().c_str());
    std::fflush(stderr);
}

void dying(int signal_number)
{
    std::signal(signal_number, SIG_DFL);
    std::fprintf(stderr, "\nsignal %d\n", signal_number);
    say();
    std::raise(signal_number);
}

}  // namespace

void last_words(std::function<std::string()> words)
{
    g_words = std::move(words);
    const itimerval work = {{}, {kWork, 0}}, patience = {{}, {kPatience, 0}};
    setitimer(ITIMER_PROF, &work, nullptr);
    setitimer(ITIMER_REAL, &patience, nullptr);
}

void listen_for_death()
{
    for (int s : {SIGALRM, SIGPROF}) std::signal(s, dying);
#if defined(HOSTILE_UNDER_ASAN)
    __sanitizer_set_death_callback(say);
    std::signal(SIGABRT, dying);
#else
    for (int s : {SIGSEGV, SIGABRT, SIGFPE, SIGBUS, SIGILL}) std::signal(s, dying);
#endif
}

}  // namespace hostile
