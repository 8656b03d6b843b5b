// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "diagnose/text.h"

#include <cstdio>
#include <iterator>

#include "base/refusals.h"
#include "diagnose/cause.h"

namespace epode {

const char* text_of(int kind)
{
    const char* const all[] = {
#define CAUSE(name) k_text_of_##name,
#include "diagnose/causes.inc"
#undef CAUSE
    };
    return kind >= 0 && kind < int(std::size(all)) ? all[kind] : nullptr;
}

int write_text(const dDiagnosis& cause, char* text, std::size_t size)
{
    constexpr const char* kSeverity[] = {"note", "warning", "error"};
    if (cause.call)
        return std::snprintf(text, size, "%s: %s() %s (%.3g times before a step; first before step %d)",
                             kSeverity[cause.severity], name_of_call(cause.call), k_text_of_refusal,
                             cause.figure, cause.first_step);
    const bool unphysical = cause.kind == dDiagnosisInertia && cause.threshold == kUnphysical;
    return std::snprintf(text, size, "%s: %s (%.3g, should stay below %.3g; first in step %d, in %d steps)",
                         kSeverity[cause.severity],
                         unphysical ? k_text_of_unphysical_inertia : text_of(cause.kind), cause.figure,
                         cause.threshold, cause.first_step, cause.steps);
}

}  // namespace epode
