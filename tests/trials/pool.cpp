// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "pool.h"

#include <ode/ode.h>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdarg>
#include <cstdio>
#include <stdexcept>
#include <thread>

namespace epode::trials {

namespace {

void ignore_message(int, const char*, va_list) {}

// In the child: the figures go to the pipe, one a line.
[[noreturn]] void run_here(const Cell& cell, int seconds, int pipe)
{
    const rlimit limit = {rlim_t(seconds), rlim_t(seconds) + 1};
    setrlimit(RLIMIT_CPU, &limit);
    dInitODE2(0);
    dSetMessageHandler(&ignore_message);
    dSetDebugHandler(&ignore_message);
    dSetErrorHandler(&ignore_message);
    Run run(*cell.scene, cell.setting);
    try {
        cell.scene->run(run);
    } catch (const std::exception& failure) {
        std::fprintf(stderr, "trials: %s\n", failure.what());
        _exit(1);
    }
    FILE* out = fdopen(pipe, "w");
    for (const auto& [law, value] : run.figures()) std::fprintf(out, "%s %.17g\n", law.c_str(), value);
    std::fclose(out);
    _exit(0);
}

struct Child {
    pid_t process;
    int pipe;
    size_t cell;
};

Child start(const Cell& cell, size_t number, int seconds)
{
    int ends[2];
    if (pipe(ends) != 0) throw std::runtime_error("trials: no pipe");
    std::fflush(nullptr);
    const pid_t process = fork();
    if (process < 0) throw std::runtime_error("trials: no process");
    if (process == 0) {
        close(ends[0]);
        run_here(cell, seconds, ends[1]);
    }
    close(ends[1]);
    return {process, ends[0], number};
}

// What a child wrote, which is less than a pipe holds.
void collect(const Child& child, int status, const rusage& used, Result& result)
{
    FILE* in = fdopen(child.pipe, "r");
    char law[64];
    for (double value; std::fscanf(in, "%63s %lf", law, &value) == 2;) result.figures[law] = value;
    std::fclose(in);
    result.seconds = double(used.ru_utime.tv_sec) + 1e-6 * double(used.ru_utime.tv_usec);
    const bool late = WIFSIGNALED(status) && (WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL);
    if (late)
        result.ending = Ending::kTime;
    else if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
        result.ending = Ending::kCrash;
}

}  // namespace

std::vector<Result> run_cells(const std::vector<Cell>& cells, const PoolOptions& options)
{
    std::vector<Result> results;
    for (const Cell& cell : cells) results.push_back({cell});
    const size_t jobs =
        size_t(options.jobs > 0 ? options.jobs : std::max(1, int(std::thread::hardware_concurrency())));
    std::vector<Child> children;
    for (size_t next = 0; next < cells.size() || !children.empty();) {
        while (next < cells.size() && children.size() < jobs) {
            children.push_back(start(cells[next], next, options.seconds));
            ++next;
        }
        int status = 0;
        rusage used{};
        const pid_t ended = wait4(-1, &status, 0, &used);
        const auto child = std::find_if(children.begin(), children.end(),
                                        [&](const Child& c) { return c.process == ended; });
        if (child == children.end()) continue;
        collect(*child, status, used, results[child->cell]);
        options.done(results[child->cell]);
        children.erase(child);
    }
    return results;
}

}  // namespace epode::trials
