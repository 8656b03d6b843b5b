// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What the comparison of one case found: worst differences, blocks out of tolerance, contact statistics.
//
// Differences are given relative to what is allowed as well as plainly, because one case may have several
// rules. Failing blocks are counted per family (the block's name without the number of the pose), which tells
// the state of a joint that disagrees.
#pragma once

#include "records.h"
#include "rules.h"

#include <map>
#include <set>
#include <string>

namespace parity {

struct PairTally {
    long poses = 0, both_hit = 0, both_miss = 0;
    long touching_disagree = 0;  // hit or miss differs, depth within the touch tolerance
    long disagree = 0;           // hit or miss differs by more
    long reference_misses = 0;   // of the rest: the reference misses a proven overlap
    long missed = 0;             // ours misses a proven overlap
    long other_depth = 0;        // both hit, depths differ by more than the tolerance
    long shallower = 0;          // of which ours is smaller and separates
    long other_normal = 0;       // depths agree, normals do not
    long other_count = 0;        // depths agree, number or sum do not
    long inseparable = 0;        // ours does not separate, the reference does
    double worst_depth = 0;
};

struct RuleTally {
    const Rule* rule = nullptr;
    double worst = 0;  // relative difference as the rule defines it
    std::string worst_at;
    std::set<std::string> failed_blocks;
};

struct CaseTally {
    long records = 0;
    long blocks = 0;
    double worst = 0;  // over all rules
    std::string worst_at;
    double allowed = 0;  // tolerance of the rule of the worst difference
    std::map<const Rule*, RuleTally> rules;
    std::map<std::string, long> failed_families;
    std::vector<std::string> structure_errors;
    PairTally pairs;
    bool is_pair = false;

    bool passes() const;
    long failed_blocks() const;
};

void compare_blocks(const Block& ours, const Block& reference, const RuleTable& table, CaseTally& tally);

// For pair rules; true if the pose is within tolerance.
bool compare_pose(const Rule& rule, const std::vector<double>& ours, const std::vector<double>& reference,
                  PairTally& tally);

}  // namespace parity
