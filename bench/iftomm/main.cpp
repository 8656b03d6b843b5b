// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// epode_iftomm [PROBLEM ...]: the benchmark problems A01 to A05 with dWorldStep: energy drift, error of the
// motion against reference.h, joint gaps and time, for several step sizes, plain and with the options of
// ode/ext.h. The error is the library's measure (Gonzalez et al. 2006): the root mean square, over 400 output
// steps and all outputs, of |y - reference| / max(|reference|, 1e-3); it asks for 1e-1 (low precision) or
// 1e-3 (high), stated there for A02 and taken for all here.
//   epode_iftomm --four-bars   time of A02 for N = 2 ... 40
//   epode_iftomm --check       exit status 1 where the low precision is missed
#include <ode/ext.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>

#include "problems.h"
#include "reference.h"
#include "squeezer.h"

namespace {

using namespace epode::iftomm;

constexpr int kSamples = 400;
constexpr double kThreshold = 1e-3;

struct Mode {
    const char* name;
    bool exact_rotation = false;
    int projection = 0;
    double cfm = -1;  // negative: the world's own
};

constexpr Mode kModes[] = {
    {.name = "plain"},
    {.name = "cfm 1e-6", .cfm = 1e-6},
    {.name = "exact rotation", .exact_rotation = true},
    {.name = "projected", .projection = 20},
    {.name = "both", .exact_rotation = true, .projection = 20},
};

struct Result {
    double error = 0, worst = 0, drift = 0, gap = 0, seconds = 0, residual = 0;
};

double duration_of(const std::string& name) { return name == "A03" ? 0.05 : 10; }

void set_up(dWorldID world, const Mode& mode)
{
    dWorldSetExactRotation(world, mode.exact_rotation);
    dWorldSetStepProjection(world, mode.projection);
    dWorldSetStepProjectionTolerance(world, dReal(1e-12));
    if (mode.cfm >= 0) dWorldSetCFM(world, dReal(mode.cfm));
}

Result run(const std::string& name, int size, const Motion& reference, double duration, double dt,
           const Mode& mode, bool with_report)
{
    const std::unique_ptr<Problem> p = make_problem(name, size);
    set_up(p->world, mode);
    dWorldSetStepReportMode(p->world, with_report);
    const double E0 = p->energy();
    Result r;
    double sum = 0;
    long terms = 0;
    const int inner = std::max(1, int(std::lround(duration / kSamples / dt)));
    const double h = duration / kSamples / inner;
    for (int i = 1; i <= kSamples; ++i) {
        const auto start = std::chrono::steady_clock::now();
        for (int k = 0; k < inner; ++k) {
            p->apply_forces(h);
            dWorldStep(p->world, dReal(h));
        }
        r.seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        const std::vector<double> y = p->outputs();
        const std::vector<double>& truth = reference[std::size_t(i)];
        for (std::size_t k = 0; k < y.size(); ++k) {
            const double e = (y[k] - truth[k]) / std::max(std::fabs(truth[k]), kThreshold);
            sum += e * e;
            r.worst = std::max(r.worst, std::fabs(y[k] - truth[k]));
            ++terms;
        }
        r.drift = std::max(r.drift, std::fabs(p->energy() - E0));
        r.gap = std::max(r.gap, p->gap());
        if (with_report) {
            dWorldStepReport report{};
            report.struct_size = sizeof report;
            dWorldGetStepReport(p->world, &report);
            r.residual = std::max(r.residual, report.residual);
        }
    }
    r.error = std::sqrt(sum / double(terms));
    return r;
}

Motion reference_of(const std::string& name, int size, double duration, int samples)
{
    if (name == "A01") return pendulum_reference(1e-3, duration, samples);
    if (name == "A02") return four_bars_reference(size, duration, samples);
    if (name == "A03") return squeezer_reference(duration, samples, 5e-6);
    if (name == "A04") return bricard_reference(duration, samples);
    return governor_reference(duration, samples, 1e-5);
}

void table(const std::string& name, int size)
{
    const double duration = duration_of(name), unit = name == "A03" ? 1e-2 : 1;
    const Motion reference = reference_of(name, size, duration, kSamples);
    std::printf("%s%s, %g s\n", name.c_str(), name == "A02" ? " N = 2" : "", duration);
    std::printf("  %-15s %8s %10s %12s %10s %9s %9s  %s\n", "mode", "dt", "error", "drift J", "gap m",
                "residual", "time s", "motion");
    for (const Mode& mode : kModes)
        for (double dt : {1e-2, 1e-3, 1e-4}) {
            const Result r = run(name, size, reference, duration, dt * unit, mode, true);
            std::printf("  %-15s %8.0e %10.2e %10.2e %12.2e %10.1e %9.1e %9.3f  %s\n", mode.name, dt * unit,
                        r.error, r.worst, r.drift, r.gap, r.residual, r.seconds,
                        r.error <= 1e-3   ? "high"
                        : r.error <= 1e-1 ? "low"
                                          : "missed");
        }
}

double check_squeezer()
{
    const std::vector<double> now = squeezer_angles(0.03, 5e-6);
    double worst = 0;
    for (std::size_t i = 0; i < now.size(); ++i)
        worst = std::max(worst, std::fabs(now[i] - squeezer::kAt003[i]));
    std::printf("A03's reference at 0.03 s: within %.1e rad of the published angles\n", worst);
    return worst;
}

// What ctest holds fast: the low precision at a step size that reaches it, A04 (which no step size of a
// first-order method reaches in ten seconds) for two.
int check()
{
    bool good = check_squeezer() < 1e-7;
    struct Goal {
        const char* name;
        double duration, dt, error;
    };
    for (const Goal& goal :
         {Goal{"A01", 10, 1e-3, 0.1}, Goal{"A02", 10, 5e-4, 0.1}, Goal{"A03", 0.05, 1e-5, 0.1},
          Goal{"A04", 2, 1e-4, 0.1}, Goal{"A05", 10, 1e-3, 0.1}}) {
        const std::string name = goal.name;
        const Mode& mode = kModes[name == "A04" ? 1 : 0];
        const Motion reference = reference_of(name, 2, goal.duration, kSamples);
        const Result r = run(name, 2, reference, goal.duration, goal.dt, mode, true);
        const bool reached = r.error <= goal.error && r.residual <= 1e-9;
        std::printf("%s at dt %g: error %.2e, residual %.1e%s\n", goal.name, goal.dt, r.error, r.residual,
                    reached ? "" : " MISSED");
        good = good && reached;
    }
    return good ? 0 : 1;
}

int four_bars()
{
    std::printf("A02, 10 s at dt 1e-3, plain: time over the number of windows\n");
    for (int n : {2, 5, 10, 20, 40}) {
        const Motion reference = four_bars_reference(n, 10, kSamples);
        const Result r = run("A02", n, reference, 10, 1e-3, kModes[0], false);
        std::printf("  N %3d: %7.3f s, %6.2f us per step and window, error %.2e, drift %.2e J, gap %.1e\n", n,
                    r.seconds, r.seconds / 10000 / n * 1e6, r.error, r.drift, r.gap);
    }
    return 0;
}

}  // namespace

int main(int argc, char** argv)
{
    dInitODE2(0);
    if (argc > 1 && !std::strcmp(argv[1], "--four-bars")) return four_bars();
    if (argc > 1 && !std::strcmp(argv[1], "--check")) return check();
    const std::vector<std::string> all = {"A01", "A02", "A03", "A04", "A05"};
    const std::vector<std::string> wanted = argc > 1 ? std::vector<std::string>(argv + 1, argv + argc) : all;
    for (const std::string& name : wanted) {
        if (std::find(all.begin(), all.end(), name) == all.end()) {
            std::fprintf(stderr, "epode_iftomm: unknown problem '%s'\n", name.c_str());
            return 2;
        }
        if (name == "A03") check_squeezer();
        table(name, 2);
    }
    dCloseODE();
    return 0;
}
