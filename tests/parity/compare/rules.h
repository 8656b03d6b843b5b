// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The tolerance table: which records must agree how closely.
//
// tolerances.tsv, one rule a line, the first that matches a record holds:
//   case-glob  key-glob  kind  tolerance  floor  fraction  difference
// kind exact    the texts are equal
//      scaled   |a - b| <= tolerance * max(|value| over the block's records under this rule, floor)
//      least    ours is at most the reference, by the same measure
//      pair     contacts of a pose: depths within the tolerance, a hit or miss may differ for depths up to
//      floor shallower  as pair, but a smaller depth that also separates the two is right as well
// key-glob is matched against "block/key". fraction is the share of a case's blocks that may be out of
// tolerance; it is 0, or the rule names the intended difference (a row of differences.tsv) that it comes
// from.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace parity {

enum class RuleKind { kExact, kScaled, kLeast, kPair, kContacts, kShallower };

struct Rule {
    std::string case_glob;
    std::string key_glob;
    RuleKind kind = RuleKind::kExact;
    double tolerance = 0;
    double floor = 0;
    double fraction = 0;
    std::string difference;
};

struct RuleTable {
    std::vector<Rule> rules;
    std::map<std::string, std::string> differences;  // id to reason

    const Rule* find(const std::string& case_name, const std::string& key) const;
};

// Reads both tables; writes what is wrong with them into error.
bool read_rules(const std::string& rules_path, const std::string& differences_path, RuleTable& table,
                std::string& error);

bool glob_match(const char* pattern, const char* text);

}  // namespace parity
