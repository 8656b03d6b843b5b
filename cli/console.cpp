// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See console.h. A full disk shows at the latest when the buffer is flushed, so finish_console() does that
// itself and looks at the result, which exit() would not.
#include "cli/console.h"

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "cli/plan.h"

namespace epode::cli {

namespace {

int failure = 0;  // errno of the first write to standard output that failed

void note_failure()
{
    if (failure == 0) failure = errno ? errno : EIO;
}

}  // namespace

void open_console(bool ignore_broken_pipes)
{
    // The lowest free number is given, so these become 0, 1 and 2; writing to them fails with EBADF.
    for (int file = 0; file < 3; ++file) {
        if (fcntl(file, F_GETFD) < 0 && errno == EBADF && ::open("/dev/null", O_RDONLY) < 0) _exit(kProblem);
    }
    if (ignore_broken_pipes) signal(SIGPIPE, SIG_IGN);
}

void put(const std::string& text)
{
    if (failure != 0) return;
    if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size()) note_failure();
}

void put_error(const std::string& text)
{
    std::fwrite(text.data(), 1, text.size(), stderr);
    std::fflush(stderr);
}

bool can_say() { return failure == 0; }

int finish_console(int code)
{
    if (std::fflush(stdout) != 0) note_failure();
    if (std::ferror(stdout)) note_failure();
    if (failure == EPIPE) {
        signal(SIGPIPE, SIG_DFL);
        raise(SIGPIPE);
    }
    if (failure == 0) return code;
    warn("cannot write to standard output: {}", std::strerror(failure));
    return code == kFine ? kProblem : code;
}

}  // namespace epode::cli
