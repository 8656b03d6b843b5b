// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The cooperative functions: a container is taken for the call, asked how many threads there are now, and
// given back. With fewer than two there is nothing to share.
#include <algorithm>
#include <climits>

#include "api/math/cooperative.h"
#include "base/check.h"
#include "base/float_environment.h"
#include "ode/matrix_coop.h"
#include "solve/exact/factor/shared_ldlt.h"

using namespace epode;

namespace {

unsigned as_limit(unsigned threads) { return threads == 0 ? Needs::kUnlimited : threads; }

// The container for the duration of a call.
class Use {
  public:
    Use(Container* container, unsigned allowed) : container_(container)
    {
        if (container_->busy.test_and_set(std::memory_order_acquire)) {
            container_ = nullptr;
        } else if (container_->helped) {
            const unsigned limit = std::min(as_limit(allowed), container_->needs.threads);
            container_->posting.measure(limit == Needs::kUnlimited ? 0 : limit);
            if (container_->posting.width() > 1) tasks_ = Tasks(container_->posting, false);
        }
    }
    Use(const Use&) = delete;
    Use& operator=(const Use&) = delete;
    ~Use()
    {
        if (container_) container_->busy.clear(std::memory_order_release);
    }

    explicit operator bool() const { return container_; }
    const Tasks& tasks() const { return tasks_; }

  private:
    Container* container_;
    Tasks tasks_;
};

bool fits(unsigned rows, unsigned skip) { return skip <= unsigned(INT_MAX) && (skip >= rows || rows == 1); }

}  // namespace

#define REQUIREMENTS_OR()                                             \
    Requirements* const requirements = from_handle<Requirements>(id); \
    EPODE_USER(requirements)

// A container with room for so many rows or elements, or the call is refused.
#define USE_OR(member, count)                                 \
    Container* const container = from_handle<Container>(id);  \
    EPODE_USER(container&& count <= container->needs.member); \
    const Use use(container, threads);                        \
    EPODE_USER_SAY(use, "The container is in use")

extern "C" {

#define ESTIMATE_ROWS(Name)                                                                               \
    void dEstimateCooperatively##Name##ResourceRequirements(dResourceRequirementsID id, unsigned threads, \
                                                            unsigned rows)                                \
    {                                                                                                     \
        REQUIREMENTS_OR();                                                                                \
        EPODE_USER(rows <= unsigned(INT_MAX));                                                            \
        requirements->needs.raise({as_limit(threads), rows, rows});                                       \
    }

ESTIMATE_ROWS(FactorLDLT)
ESTIMATE_ROWS(SolveLDLT)
ESTIMATE_ROWS(SolveL1Straight)
ESTIMATE_ROWS(SolveL1Transposed)

void dEstimateCooperativelyScaleVectorResourceRequirements(dResourceRequirementsID id, unsigned threads,
                                                           unsigned elements)
{
    REQUIREMENTS_OR();
    EPODE_USER(elements <= unsigned(INT_MAX));
    requirements->needs.raise({as_limit(threads), 0, elements});
}

void dCooperativelyFactorLDLT(dResourceContainerID id, unsigned threads, dReal* A, dReal* d, unsigned rows,
                              unsigned skip)
{
    const FloatEnvironment floats;
    USE_OR(rows, rows);
    EPODE_USER(rows == 0 || (A && d && fits(rows, skip)));
    factor_ldlt(A, d, int(rows), int(skip), use.tasks());
}

void dCooperativelySolveLDLT(dResourceContainerID id, unsigned threads, const dReal* L, const dReal* d,
                             dReal* b, unsigned rows, unsigned skip)
{
    const FloatEnvironment floats;
    USE_OR(rows, rows);
    EPODE_USER(rows == 0 || (L && d && b && fits(rows, skip)));
    solve_ldlt(L, d, b, int(rows), int(skip), use.tasks());
}

void dCooperativelySolveL1Straight(dResourceContainerID id, unsigned threads, const dReal* L, dReal* b,
                                   unsigned rows, unsigned skip)
{
    const FloatEnvironment floats;
    USE_OR(rows, rows);
    EPODE_USER(rows == 0 || (L && b && fits(rows, skip)));
    solve_unit_lower(L, b, int(rows), int(skip), use.tasks());
}

void dCooperativelySolveL1Transposed(dResourceContainerID id, unsigned threads, const dReal* L, dReal* b,
                                     unsigned rows, unsigned skip)
{
    const FloatEnvironment floats;
    USE_OR(rows, rows);
    EPODE_USER(rows == 0 || (L && b && fits(rows, skip)));
    solve_unit_lower_transposed(L, b, int(rows), int(skip), use.tasks());
}

void dCooperativelyScaleVector(dResourceContainerID id, unsigned threads, dReal* data, const dReal* scale,
                               unsigned elements)
{
    const FloatEnvironment floats;
    USE_OR(elements, elements);
    EPODE_USER(elements == 0 || (data && scale));
    scale_vector(data, scale, int(elements), use.tasks());
}

}  // extern "C"
