// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Comparison of the contacts of one pose: "count depth nx ny nz sum separated shared".
//
// Near touching, hit or miss is decided by rounding; there a disagreement is counted apart. A depth is the
// least distance that separates the two, or an upper bound of it: under the rule "shallower" ours may be
// smaller, if moving by it does separate. Normals are compared only where depths agree, and then a different
// normal is a tie between two directions of (nearly) the same depth; it is counted, and fails no pose.
#include "tally.h"

#include <algorithm>
#include <cmath>

namespace parity {
namespace {

double cosine(const std::vector<double>& a, const std::vector<double>& b)
{
    return a[2] * b[2] + a[3] * b[3] + a[4] * b[4];
}

bool compare_hit_and_miss(const Rule& rule, const std::vector<double>& ours,
                          const std::vector<double>& reference, PairTally& tally)
{
    const bool ours_hits = ours[0] > 0;
    if ((ours_hits ? ours[1] : reference[1]) <= rule.floor) {
        ++tally.touching_disagree;
        return true;
    }
    if (rule.kind == RuleKind::kShallower && ours_hits && ours[7] == 1 && ours[6] == 1) {
        ++tally.reference_misses;
        return true;
    }
    ++tally.disagree;
    return false;
}

}  // namespace

bool compare_pose(const Rule& rule, const std::vector<double>& ours, const std::vector<double>& reference,
                  PairTally& tally)
{
    ++tally.poses;
    tally.missed += ours[0] == 0 && ours[7] == 1 ? 1 : 0;
    const bool ours_hits = ours[0] > 0, reference_hits = reference[0] > 0;
    if (!ours_hits && !reference_hits) {
        ++tally.both_miss;
        return ours[7] == 0;
    }
    if (ours_hits != reference_hits) { return compare_hit_and_miss(rule, ours, reference, tally); }
    ++tally.both_hit;
    const double change = ours[1] - reference[1];
    if (ours[6] < reference[6]) {
        ++tally.inseparable;
        return false;
    }
    if (!(std::fabs(change) <= rule.tolerance)) {
        ++tally.other_depth;
        const bool valid = ours[6] == 1 && (change < 0 || reference[6] == 0);
        if (rule.kind == RuleKind::kShallower && valid) {
            ++tally.shallower;
            return true;
        }
        tally.worst_depth = std::max(tally.worst_depth, std::isfinite(change) ? std::fabs(change) : INFINITY);
        return false;
    }
    tally.worst_depth = std::max(tally.worst_depth, std::fabs(change));
    tally.other_normal += cosine(ours, reference) < 1 - 1e-6 ? 1 : 0;
    const bool same_set = ours[0] == reference[0] && std::fabs(ours[5] - reference[5]) <= 8 * rule.tolerance;
    tally.other_count += same_set ? 0 : 1;
    return same_set || rule.kind != RuleKind::kContacts;
}

}  // namespace parity
