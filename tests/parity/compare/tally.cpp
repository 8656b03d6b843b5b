// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See tally.h and rules.h for the definitions.
#include "tally.h"

#include <algorithm>
#include <cmath>

namespace parity {
namespace {

struct Match {
    const Record* ours;
    const Record* reference;
    const Rule* rule;
};

std::string family_of(const std::string& block)
{
    const std::size_t slash = block.rfind('/');
    return slash == std::string::npos ? std::string("-") : block.substr(0, slash);
}

std::string full_key(const Record& record) { return record.block + "/" + record.key; }

void fail(CaseTally& tally, RuleTally& rule, const std::string& block)
{
    if (rule.failed_blocks.insert(block).second) { ++tally.failed_families[family_of(block)]; }
}

double finite_size(const std::vector<double>& values)
{
    double size = 0;
    for (const double value : values) {
        if (std::isfinite(value)) { size = std::max(size, std::fabs(value)); }
    }
    return size;
}

// Infinity for values of which one is not a number or only one infinite.
double difference(const std::vector<double>& a, const std::vector<double>& b, bool one_sided)
{
    double worst = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (a[i] == b[i] || (one_sided && a[i] < b[i])) { continue; }
        const double distance = std::fabs(a[i] - b[i]);
        worst = std::max(worst, std::isfinite(distance) ? distance : INFINITY);
    }
    return worst;
}

void note_worst(CaseTally& tally, RuleTally& rule_tally, double relative, const Record& record)
{
    if (relative > rule_tally.worst) {
        rule_tally.worst = relative;
        rule_tally.worst_at = full_key(record);
    }
    if (relative > tally.worst) {
        tally.worst = relative;
        tally.worst_at = full_key(record);
        tally.allowed = rule_tally.rule->tolerance;
    }
}

void compare_scaled(const std::vector<Match>& matches, const Rule& rule, CaseTally& tally)
{
    double scale = rule.floor;
    for (const Match& match : matches) {
        if (match.rule == &rule) {
            scale = std::max({scale, finite_size(match.ours->values), finite_size(match.reference->values)});
        }
    }
    RuleTally& rule_tally = tally.rules[&rule];
    for (const Match& match : matches) {
        if (match.rule != &rule) { continue; }
        const bool comparable = match.ours->numeric && match.reference->numeric &&
                                match.ours->values.size() == match.reference->values.size();
        const double distance = comparable ? difference(match.ours->values, match.reference->values,
                                                        rule.kind == RuleKind::kLeast)
                                           : INFINITY;
        const double relative = distance == 0 ? 0 : distance / scale;
        note_worst(tally, rule_tally, relative, *match.ours);
        if (!(relative <= rule.tolerance)) { fail(tally, rule_tally, match.ours->block); }
    }
}

void compare_exact(const Match& match, CaseTally& tally)
{
    RuleTally& rule_tally = tally.rules[match.rule];
    if (match.ours->text != match.reference->text) {
        note_worst(tally, rule_tally, 1, *match.ours);
        fail(tally, rule_tally, match.ours->block);
    }
}

void compare_pair(const Match& match, CaseTally& tally)
{
    tally.is_pair = true;
    RuleTally& rule_tally = tally.rules[match.rule];
    if (match.ours->values.size() != 8 || match.reference->values.size() != 8 ||
        !compare_pose(*match.rule, match.ours->values, match.reference->values, tally.pairs)) {
        rule_tally.failed_blocks.insert(full_key(*match.ours));
    }
}

std::vector<Match> match_records(const Block& ours, const Block& reference, const RuleTable& table,
                                 CaseTally& tally)
{
    std::vector<Match> matches;
    std::size_t i = 0, j = 0;
    while (i < ours.records.size() || j < reference.records.size()) {
        const bool both = i < ours.records.size() && j < reference.records.size();
        if (!both || ours.records[i].key != reference.records[j].key) {
            tally.structure_errors.push_back("records differ in " + ours.case_name + " " + ours.name);
            return matches;
        }
        const Rule* rule = table.find(ours.case_name, full_key(ours.records[i]));
        if (rule == nullptr) {
            tally.structure_errors.push_back("no rule for " + ours.case_name + " " +
                                             full_key(ours.records[i]));
            return matches;
        }
        matches.push_back({&ours.records[i++], &reference.records[j++], rule});
    }
    return matches;
}

}  // namespace

void compare_blocks(const Block& ours, const Block& reference, const RuleTable& table, CaseTally& tally)
{
    const std::vector<Match> matches = match_records(ours, reference, table, tally);
    std::vector<const Rule*> scaled;
    for (const Match& match : matches) {
        tally.rules[match.rule].rule = match.rule;
        if (match.rule->kind == RuleKind::kExact) {
            compare_exact(match, tally);
        } else if (match.rule->kind == RuleKind::kScaled || match.rule->kind == RuleKind::kLeast) {
            if (std::find(scaled.begin(), scaled.end(), match.rule) == scaled.end()) {
                scaled.push_back(match.rule);
            }
        } else {
            compare_pair(match, tally);
        }
    }
    for (const Rule* rule : scaled) { compare_scaled(matches, *rule, tally); }
    tally.records += static_cast<long>(matches.size());
    ++tally.blocks;
}

long CaseTally::failed_blocks() const
{
    long count = 0;
    for (const auto& [rule, rule_tally] : rules) {
        count += static_cast<long>(rule_tally.failed_blocks.size());
    }
    return count;
}

bool CaseTally::passes() const
{
    const double total = static_cast<double>(is_pair ? records : blocks);
    const auto within = [&](const auto& entry) {
        return static_cast<double>(entry.second.failed_blocks.size()) <= entry.first->fraction * total;
    };
    return structure_errors.empty() && std::all_of(rules.begin(), rules.end(), within);
}

}  // namespace parity
