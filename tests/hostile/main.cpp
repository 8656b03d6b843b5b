// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// hostile_calls [--calls N] [--seed S] [--part I/N] [--only NAME] [--each]
// hostile_calls --list
// About N calls, evenly over all functions of the interface; a tenth of them from inside functions of the
// program. --part takes every N-th function only, --only those whose names begin so; --each gives every
// function a process of its own, so that one that dies does not hide the others. Fails on any fault, and on
// memory that is left at the end. --list prints the functions that it calls, and those that it does not, with
// the reason.
#include <sys/wait.h>
#include <unistd.h>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "last_words.h"
#include "runner.h"

using namespace hostile;

namespace {

struct Options {
    long calls = 60000;
    std::uint64_t seed = 1;
    int part = 0, parts = 1;
    const char* only = nullptr;
    bool each = false, list = false;

    bool wants(const Function& f) const
    {
        return !only || std::strncmp(f.name, only, std::strlen(only)) == 0;
    }
};

Options parse(int argc, char** argv)
{
    Options o;
    for (int i = 1; i < argc; ++i) {
        const auto next = [&] { return i + 1 < argc ? argv[++i] : "0"; };
        if (!std::strcmp(argv[i], "--calls"))
            o.calls = std::atol(next());
        else if (!std::strcmp(argv[i], "--seed"))
            o.seed = std::strtoull(next(), nullptr, 10);
        else if (!std::strcmp(argv[i], "--part"))
            std::sscanf(next(), "%d/%d", &o.part, &o.parts);
        else if (!std::strcmp(argv[i], "--only"))
            o.only = next();
        else if (!std::strcmp(argv[i], "--each"))
            o.each = true;
        else if (!std::strcmp(argv[i], "--list"))
            o.list = true;
        else {
            std::fprintf(stderr, "unknown option %s\n", argv[i]);
            std::exit(2);
        }
    }
    return o;
}

// Every n-th function, beginning with `first`.
int run(const Options& o, std::size_t first, std::size_t step)
{
    const auto all = functions();
    const long budget = o.calls / long(all.size()) + 1;
    bool clean = true;
    {
        Runner runner(o.seed);
        for (std::size_t i = first; i < all.size(); i += step) {
            if (!o.wants(all[i])) continue;
            runner.run(all[i], budget * 9 / 10);
            for (const Phase& phase : phases()) runner.run_inside(all[i], phase, runner.share(budget, 120));
        }
        // Functions with few combinations have left something over.
        while (!o.each && !o.only && runner.tally().calls < o.calls / o.parts) runner.run_any(100);
        if (!o.each || !runner.clean()) runner.report();
        clean = runner.clean();
    }
    reset_process();
    dCloseODE();
    if (blocks_held() != 0)
        std::printf("FAULT %ld blocks of memory are left after %s\n", blocks_held(),
                    o.each ? all[first].name : "all calls");
    return clean && blocks_held() == 0 ? 0 : 1;
}

int run_each(const Options& o)
{
    const auto all = functions();
    int failed = 0;
    for (std::size_t i = std::size_t(o.part); i < all.size(); i += std::size_t(o.parts)) {
        if (!o.wants(all[i])) continue;
        std::fflush(nullptr);
        const pid_t child = fork();
        if (child == 0) {
            const int code = run(o, i, all.size());
            std::fflush(nullptr);
            _exit(code);
        }
        int status = 0;
        waitpid(child, &status, 0);
        if (!WIFEXITED(status) || WEXITSTATUS(status) > 1)
            std::printf("FAULT %s: the process died\n", all[i].name);
        failed += status != 0;
    }
    std::printf("%d functions with faults\n", failed);
    return failed != 0;
}

void list()
{
    for (const Function& f : functions()) std::printf("%s called\n", f.name);
    for (const Absent& f : absent_functions())
        std::printf("%s %s: %s\n", f.name, f.excused ? "excused" : "not called", f.reason);
}

}  // namespace

int main(int argc, char** argv)
{
    const Options o = parse(argc, argv);
    if (o.list) return list(), 0;
    listen_for_death();
    return o.each ? run_each(o) : run(o, std::size_t(o.part), std::size_t(o.parts));
}
