// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The tests by name, and one line per run: "test stepper dt variant size error seconds details".
#include "bench/truth/accuracy.h"

#include <fmt/format.h>

#include "scenes/messages.h"

namespace epode::bench {

namespace {

struct Test {
    const char* name;
    AccuracyResult (*run)(const AccuracyOptions&);
};

constexpr Test kTests[] = {
    {"rolling", run_rolling},         {"bouncing", run_bouncing}, {"666", run_666},
    {"elastic-666", run_elastic_666}, {"grasp", run_grasp},       {"whip", run_whip},
};

}  // namespace

int bench_accuracy(const AccuracyOptions& options)
{
    for (const Test& test : kTests) {
        if (options.test != test.name) continue;
        const scenes::MessageCounter messages;
        const AccuracyResult result = test.run(options);
        if (!result.available) return 3;
        fmt::print("{} {} {:.9g} {} {:.9g} {:.6e} {:.4f} messages {}{}\n", test.name,
                   scenes::name_of(options.stepper), options.dt,
                   options.variant.empty() ? "-" : options.variant, options.size, result.error,
                   result.seconds, messages.count(), result.details);
        return result.ok ? 0 : 1;
    }
    std::string names;
    for (const Test& test : kTests) names += fmt::format(" {}", test.name);
    fmt::print(stderr, "epode_bench: there is no test '{}'. Tests:{}\n", options.test, names);
    return 2;
}

}  // namespace epode::bench
