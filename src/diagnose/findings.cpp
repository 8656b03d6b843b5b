// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Ranking: a cause comes before its effects, so of two that are equally severe the one that was seen first is
// the likelier cause. Energy that came from nowhere is an effect of all others, and never precedes one that
// is at least a warning.
#include "diagnose/findings.h"

#include <algorithm>

namespace epode {
namespace {

bool is_same(const dDiagnosis& a, const dDiagnosis& b)
{
    return a.kind == b.kind && a.body == b.body && a.joint == b.joint && a.call == b.call;
}

bool precedes(const dDiagnosis& a, const dDiagnosis& b)
{
    const bool effect_a = a.kind == dDiagnosisEnergy, effect_b = b.kind == dDiagnosisEnergy;
    const bool warns = a.severity >= dSeverityWarning && b.severity >= dSeverityWarning;
    if (warns && effect_a != effect_b) return effect_b;
    if (a.severity != b.severity) return a.severity > b.severity;
    if (a.first_step != b.first_step) return a.first_step < b.first_step;
    if (a.kind != b.kind) return a.kind < b.kind;
    return a.figure > b.figure;
}

// By insertion: few, in a stable order, without memory.
void insert_sorted(dDiagnosis* all, int count)
{
    for (int i = 1; i < count; ++i)
        for (int k = i; k > 0 && precedes(all[k], all[k - 1]); --k) std::swap(all[k], all[k - 1]);
}

}  // namespace

void Findings::add(const Finding& seen)
{
    const dDiagnosis one{seen.kind,   seen.severity,  seen.body, seen.other, seen.joint, seen.geom,
                         seen.figure, seen.threshold, step_,     1,          seen.call};
    for (int i = 0; i < count_; ++i) {
        dDiagnosis& known = all_[i];
        if (!is_same(known, one)) continue;
        known.steps += seen_[i] != step_;
        seen_[i] = step_;
        known.severity = std::max(known.severity, one.severity);
        if (one.figure > known.figure) known.figure = one.figure, known.threshold = one.threshold;
        return;
    }
    const int at = count_ < kCapacity ? count_++ : place_for(one);
    if (at < 0) return;
    seen_[at] = step_;
    all_[at] = one;
}

// Of a full list: the place of the last in rank, if the new one precedes it; else -1.
int Findings::place_for(const dDiagnosis& one) const
{
    int last = 0;
    for (int i = 1; i < count_; ++i)
        if (precedes(all_[last], all_[i])) last = i;
    return precedes(one, all_[last]) ? last : -1;
}

int Findings::ranked(dDiagnosis* out, int capacity) const
{
    dDiagnosis sorted[kCapacity];
    std::copy_n(all_, count_, sorted);
    insert_sorted(sorted, count_);
    std::copy_n(sorted, std::min(count_, capacity), out);
    return count_;
}

}  // namespace epode
