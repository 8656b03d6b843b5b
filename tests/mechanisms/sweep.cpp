// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// mechanism_sweep [FIRST [COUNT [STEPS]]]: steps random mechanisms with dWorldStep and looks at every step:
// natural residual at most 1e-9, nothing contained, nothing said, everything finite. One line per mechanism
// that fails, then the totals; exit status 1 if any failed. What scripts/nightly runs in full and ctest in
// part (mechanisms_test.cpp).
//
//   mechanism_sweep --reduce NUMBER STEP   leaves parts out of one failing step for as long as it fails
#include <ode/ext.h>

#include <algorithm>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <optional>

#include "mechanism.h"

namespace {

using namespace epode::mechanisms;

constexpr double kTorn = 1e5;     // m/s or rad/s
constexpr double kTearing = 1e3;  // what is so fast may be torn within one step, and run away
constexpr double kPromised = sizeof(dReal) == 8 ? 1e-9 : 1e-4;
constexpr double kNamed = sizeof(dReal) == 8 ? 1e-9 : 1e-2;  // above it a report names joints
constexpr double kPlain = sizeof(dReal) == 8 ? 1e-6 : 1e-2;  // so much is a contradiction, not rounding

int said = 0;
void count_message(int, const char*, va_list) { ++said; }

dWorldStepReport report_of(const Mechanism& m)
{
    dWorldStepReport r{};
    r.struct_size = sizeof r;
    dWorldGetStepReport(m.world, &r);
    return r;
}

struct Totals {
    int failed = 0, steps = 0, steps_failed = 0, fallbacks = 0, contained = 0, said = 0, not_finite = 0;
    long rows = 0, iterations = 0;
    int most_rows = 0;
    int contradicting = 0, unnamed = 0;  // steps; those whose report names no joint
    int torn = 0, torn_steps = 0, torn_steps_failed = 0, torn_contained = 0;
    double worst = 0, torn_worst = 0;
    int decade[20] = {};  // how many steps have a residual of 1e-k
};

int decade_of(double residual)
{
    int k = 0;
    for (double x = 1; k < 19 && residual < x; x *= 0.1) ++k;
    return k;
}

double fastest(const Mechanism& m)
{
    double fastest = 0;
    for (const BodyState& s : m.state())
        for (int i = 0; i < 3; ++i)
            fastest = std::max({fastest, std::fabs(double(s.v[i])), std::fabs(double(s.w[i]))});
    return fastest;
}

// The residual of a step from such a state; cfm: of the world, instead of its own.
double one_step(int number, const std::vector<BodyState>& from, const std::vector<bool>& without,
                std::optional<double> cfm = {})
{
    Mechanism m(number, {}, without);
    m.put(from);
    if (cfm) dWorldSetCFM(m.world, dReal(*cfm));
    dWorldSetStepReportMode(m.world, 1);
    m.collide();
    m.step();
    return report_of(m).residual;
}

// Rows that contradict each other by little have no solution without softness, but one with it.
bool is_solved_softly(int number, const std::vector<BodyState>& from)
{
    return one_step(number, from, {}, 1e-10) <= kPromised;
}

bool is_plain(const dWorldStepReport& r) { return r.residual > kPlain && r.unsolved_joints > 0; }

void count_torn(const dWorldStepReport& r, Totals& t)
{
    ++t.torn_steps;
    t.torn_steps_failed += !(r.residual <= kPromised);
    t.torn_contained += r.contained_islands;
    t.torn_worst = std::max(t.torn_worst, r.residual);
}

void count(const dWorldStepReport& r, Totals& t)
{
    ++t.steps;
    t.rows += r.rows;
    t.most_rows = std::max(t.most_rows, r.rows);
    t.iterations += r.iterations;
    t.fallbacks += r.fallbacks > 0;
    t.contained += r.contained_islands;
    t.worst = std::max(t.worst, r.residual);
    ++t.decade[decade_of(r.residual)];
}

void run(int number, int steps, Totals& totals)
{
    Mechanism m(number);
    dWorldSetStepReportMode(m.world, 1);
    int bad = 0, first = -1;
    double worst = 0;
    const int said_before = said, contained_before = totals.contained;
    int said_whole = said;  // while it was in one piece: of what flies beyond 1e100 m contacts are refused
    bool torn = false;
    for (int i = 0; i < steps; ++i) {
        const std::vector<BodyState> from = m.state();
        m.collide();
        const double speed = fastest(m);
        totals.torn += speed > kTorn && !torn;
        torn = torn || speed > kTorn;
        m.step();
        const dWorldStepReport r = report_of(m);
        if (torn) {
            count_torn(r, totals);
            continue;
        }
        const bool unsolved = !(r.residual <= kPromised) && r.contained_islands == 0;
        if (m.cfm == 0 && unsolved && (is_plain(r) || is_solved_softly(number, from))) {
            ++totals.contradicting;
            totals.unnamed += r.residual > kNamed && r.unsolved_joints == 0;
            continue;
        }
        count(r, totals);
        if (speed < kTearing || fastest(m) < kTorn) said_whole = said;
        worst = std::max(worst, r.residual);
        if (!(r.residual <= kPromised) || r.contained_islands) {
            if (bad++ == 0) first = i;
        }
    }
    const bool finite = m.finite();
    totals.not_finite += !finite;
    totals.steps_failed += bad;
    totals.said += said_whole - said_before;
    if (bad == 0 && finite && said_whole == said_before && totals.contained == contained_before) return;
    ++totals.failed;
    std::printf("%4d: %d steps, first %d, worst %.1e, contained %d, said %d, fastest %.1e | %s\n", number,
                bad, first, worst, totals.contained - contained_before, said_whole - said_before, fastest(m),
                m.summary().c_str());
}

int sweep(int first, int number, int steps)
{
    Totals t;
    for (int i = first; i < first + number; ++i) run(i, steps, t);
    std::printf("%d mechanisms, %d steps, %ld rows (most %d), %ld iterations, %d steps with fallback\n",
                number, t.steps, t.rows, t.most_rows, t.iterations, t.fallbacks);
    std::printf(
        "failed: %d mechanisms, %d steps; worst residual %.2e; contained %d; said %d; not finite %d\n",
        t.failed, t.steps_failed, t.worst, t.contained, t.said, t.not_finite);
    std::printf(
        "torn apart: %d mechanisms, %d steps, of which %d failed; worst residual %.2e; contained %d\n",
        t.torn, t.torn_steps, t.torn_steps_failed, t.torn_worst, t.torn_contained);
    std::printf(
        "contradicting rows with CFM 0, which the report or a softer step says: %d steps, %d without a "
        "joint's name\n",
        t.contradicting, t.unnamed);
    for (int k = 0; k < 20; ++k)
        if (t.decade[k]) std::printf("  residual below 1e-%d: %d steps\n", k - 1, t.decade[k]);
    return t.failed > 0 || t.unnamed > 0;
}

int reduce(int number, int step)
{
    Mechanism whole(number);
    for (int i = 0; i < step; ++i) {
        whole.collide();
        whole.step();
    }
    const std::vector<BodyState> from = whole.state();
    std::vector<bool> without(whole.parts.size(), false);
    std::printf("%s\nstarted afresh: residual %.2e\n", whole.summary().c_str(),
                one_step(number, from, without));
    for (bool changed = true; changed;) {
        changed = false;
        for (std::size_t k = 0; k < without.size(); ++k) {
            if (without[k]) continue;
            without[k] = true;
            if (one_step(number, from, without) > kPromised)
                changed = true;
            else
                without[k] = false;
        }
    }
    std::printf("left: residual %.2e\n", one_step(number, from, without));
    for (std::size_t k = 0; k < without.size(); ++k)
        if (!without[k]) std::printf("  %3zu %s\n", k, whole.parts[k].c_str());
    for (std::size_t i = 0; i < from.size(); ++i)
        std::printf("  body %zu mass %.3g at %.6g %.6g %.6g, v %.3g %.3g %.3g, w %.3g %.3g %.3g\n", i,
                    whole.mass[i], double(from[i].pos[0]), double(from[i].pos[1]), double(from[i].pos[2]),
                    double(from[i].v[0]), double(from[i].v[1]), double(from[i].v[2]), double(from[i].w[0]),
                    double(from[i].w[1]), double(from[i].w[2]));
    return 0;
}

}  // namespace

int main(int argc, char** argv)
{
    dInitODE2(0);
    dSetMessageHandler(&count_message);
    dSetDebugHandler(&count_message);
    dSetErrorHandler(&count_message);
    const auto number = [&](int k, int otherwise) { return argc > k ? std::atoi(argv[k]) : otherwise; };
    const int status = argc > 3 && !std::strcmp(argv[1], "--reduce")
                           ? reduce(number(2, 0), number(3, 0))
                           : sweep(number(1, 0), number(2, 1000), number(3, 200));
    dCloseODE();
    return status;
}
