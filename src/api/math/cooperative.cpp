// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The life of cooperatives, requirements and containers. A container prepares its threading implementation
// for all calls to come, as a step does for itself.
#include "api/math/cooperative.h"

#include <algorithm>

#include "base/check.h"
#include "base/objects/pool.h"
#include "tasks/threading.h"

using namespace epode;

namespace epode {

void Needs::raise(const Needs& other)
{
    threads = std::max(threads, other.threads);
    rows = std::max(rows, other.rows);
    elements = std::max(elements, other.elements);
}

}  // namespace epode

namespace {

// False: the implementation refused to prepare.
bool equip(Container& container, const Helpers& helpers)
{
    if (!helpers.impl) return true;
    const unsigned threads = container.needs.threads;
    container.helped = true;
    return container.posting.open(helpers.functions, helpers.impl,
                                  threads == Needs::kUnlimited ? 0 : threads);
}

}  // namespace

extern "C" {

dCooperativeID dCooperativeCreate(const dThreadingFunctionsInfo* functions, dThreadingImplementationID impl)
{
    EPODE_USER(!functions == !impl, nullptr);
    EPODE_USER_SAY(!functions || complete(*functions), "Bad threading functions info", nullptr);
    const auto* cooperative = Pool<Cooperative>::create(functions ? Helpers{*functions, impl} : Helpers{});
    EPODE_USER_SAY(cooperative, kOutOfMemory, nullptr);
    return to_handle(cooperative);
}

void dCooperativeDestroy(dCooperativeID id)
{
    if (!id) return;
    Cooperative* const cooperative = from_handle<Cooperative>(id);
    EPODE_USER(cooperative);
    Pool<Cooperative>::destroy(cooperative);
}

dResourceRequirementsID dResourceRequirementsCreate(dCooperativeID id)
{
    const Cooperative* const cooperative = from_handle<Cooperative>(id);
    EPODE_USER(cooperative, nullptr);
    const Requirements* const made = Pool<Requirements>::create(cooperative->helpers);
    EPODE_USER_SAY(made, kOutOfMemory, nullptr);
    return to_handle(made);
}

void dResourceRequirementsDestroy(dResourceRequirementsID id)
{
    if (!id) return;
    Requirements* const requirements = from_handle<Requirements>(id);
    EPODE_USER(requirements);
    Pool<Requirements>::destroy(requirements);
}

dResourceRequirementsID dResourceRequirementsClone(dResourceRequirementsID id)
{
    const Requirements* const from = from_handle<Requirements>(id);
    EPODE_USER(from, nullptr);
    Requirements* const clone = Pool<Requirements>::create(from->helpers);
    EPODE_USER_SAY(clone, kOutOfMemory, nullptr);
    clone->needs = from->needs;
    return to_handle(clone);
}

void dResourceRequirementsMergeIn(dResourceRequirementsID summary_id, dResourceRequirementsID extra_id)
{
    Requirements* const summary = from_handle<Requirements>(summary_id);
    const Requirements* const extra = from_handle<Requirements>(extra_id);
    EPODE_USER(summary && extra && summary->helpers.impl == extra->helpers.impl);
    summary->needs.raise(extra->needs);
}

dResourceContainerID dResourceContainerAcquire(dResourceRequirementsID id)
{
    const Requirements* const requirements = from_handle<Requirements>(id);
    EPODE_USER(requirements, nullptr);
    Container* const container = Pool<Container>::create(requirements->needs);
    const bool ready = container && equip(*container, requirements->helpers);
    if (container && !ready) Pool<Container>::destroy(container);
    EPODE_USER_SAY(ready, kOutOfMemory, nullptr);
    return to_handle(container);
}

void dResourceContainerDestroy(dResourceContainerID id)
{
    if (!id) return;
    Container* const container = from_handle<Container>(id);
    EPODE_USER(container && !container->busy.test_and_set());
    Pool<Container>::destroy(container);
}

}  // extern "C"
