// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The diagnosis of steps, as C functions.
#include "ode/diagnosis.h"

#include "base/check.h"
#include "base/float_environment.h"
#include "base/refusals.h"
#include "diagnose/text.h"
#include "diagnose/watch.h"

using namespace epode;

extern "C" {

void dWorldSetDiagnosisMode(dWorldID w, int mode)
{
    World* const world = from_handle<World>(w);
    EPODE_USER(world && (mode == 0 || mode == 1));
    EPODE_USER_SAY(!in_step(*world), busy_text(*world));
    EPODE_USER_SAY(set_diagnosis(*world, mode != 0), kOutOfMemory);
}

int dWorldGetDiagnosisMode(dWorldID w)
{
    const World* const world = from_handle<World>(w);
    EPODE_USER(world, 0);
    return findings_of(*world) != nullptr;
}

int dWorldDiagnose(dWorldID w, dDiagnosis* causes, int capacity)
{
    const World* const world = from_handle<World>(w);
    EPODE_USER(world && capacity >= 0 && (causes || capacity == 0), 0);
    EPODE_USER_SAY(!in_step(*world), busy_text(*world), 0);
    const Findings* const findings = findings_of(*world);
    return findings ? findings->ranked(causes, capacity) : 0;
}

int dDiagnosisText(const dDiagnosis* cause, char* text, int size)
{
    const FloatEnvironment floats;
    EPODE_USER(cause && text && size >= 0, 0);
    EPODE_USER_SAY(text_of(cause->kind), "a kind that is no dDiagnosisKind", 0);
    EPODE_USER_SAY(cause->severity >= dSeverityNote && cause->severity <= dSeverityError,
                   "a severity that is no dSeverity", 0);
    EPODE_USER_SAY(cause->call == 0 || name_of_call(cause->call), "a call that is none", 0);
    return write_text(*cause, text, std::size_t(size));
}

}  // extern "C"
