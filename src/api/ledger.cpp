// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The energy ledger of the last step, as C functions.
#include "base/objects/struct_size.h"
#include "ode/report.h"
#include "step/island/energy_ledger.h"
#include "step/step.h"

namespace epode {

template <>
inline constexpr std::size_t kSmallestSize<dEnergyLedger> = offsetof(dEnergyLedger, body);

}  // namespace epode

using namespace epode;

namespace {

// The ledgers of the last step's islands; null: there are none.
const Array<dEnergyLedger>* ledgers_of(const World& world)
{
    const StepState* const state = world.step_state;
    return state && state->ledger_wanted && state->ledger_made ? &state->ledgers : nullptr;
}

}  // namespace

extern "C" {

int dWorldSetEnergyLedgerMode(dWorldID w, int mode)
{
    EPODE_WORLD_OR(0);
    EPODE_USER(mode == 0 || mode == 1, 0);
    EPODE_USER_SAY(!in_step(*world), busy_text(*world), 0);
    StepState* const state = step_state(*world);
    EPODE_USER_SAY(state, kOutOfMemory, 0);
    if (mode && !state->ledger_wanted) state->ledger_made = false;
    state->ledger_wanted = mode != 0;
    return 1;
}

int dWorldGetEnergyLedgerMode(dWorldID w)
{
    EPODE_WORLD_OR(0);
    return world->step_state && world->step_state->ledger_wanted;
}

int dWorldGetEnergyLedger(dWorldID w, dEnergyLedger* ledger)
{
    EPODE_WORLD_OR(0);
    EPODE_SIZED(ledger, 0);
    const Array<dEnergyLedger>* const islands = ledgers_of(*world);
    if (!islands) return 0;
    copy_sized(sum_of(islands->span()), ledger, ledger->struct_size);
    return 1;
}

int dWorldGetIslandEnergyLedger(dWorldID w, int island, dEnergyLedger* ledger)
{
    EPODE_WORLD_OR(0);
    EPODE_SIZED(ledger, 0);
    const Array<dEnergyLedger>* const islands = ledgers_of(*world);
    if (!islands) return 0;
    EPODE_USER(island >= 0 && island < islands->size(), 0);
    copy_sized((*islands)[island], ledger, ledger->struct_size);
    return 1;
}

}  // extern "C"
