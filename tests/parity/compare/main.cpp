// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// parity_compare OURS.txt REFERENCE.txt TOLERANCES.tsv DIFFERENCES.tsv
//
// Compares two record files of parity_probe and prints the parity table: per case the records, the worst
// relative difference and what is allowed, and for contacts the poses and how they agree. Exit status 0 if
// all is within tolerance, 1 if not, 2 if the files cannot be compared (among that: the same library twice).
#include "tally.h"

#include <algorithm>
#include <cstdio>

namespace parity {
namespace {

using Tallies = std::map<std::string, CaseTally>;

bool compare_files(RecordFile& ours, RecordFile& reference, const RuleTable& table, Tallies& tallies)
{
    Block a, b;
    for (;;) {
        const bool more_a = ours.next(a), more_b = reference.next(b);
        if (!more_a || !more_b) { return more_a == more_b; }
        if (a.case_name != b.case_name || a.name != b.name) {
            std::printf("the files part at %s %s and %s %s\n", a.case_name.c_str(), a.name.c_str(),
                        b.case_name.c_str(), b.name.c_str());
            return false;
        }
        compare_blocks(a, b, table, tallies[a.case_name]);
    }
}

const char* verdict(const CaseTally& tally) { return tally.passes() ? "ok" : "FAILS"; }

void print_values(const Tallies& tallies)
{
    std::printf("\n%-36s %8s %8s %12s %9s %7s  %s\n", "case", "blocks", "records", "worst", "allowed",
                "beyond", "verdict (worst at)");
    for (const auto& [name, tally] : tallies) {
        if (!tally.is_pair) {
            std::printf("%-36s %8ld %8ld %12.3g %9.1g %7ld  %s  %s\n", name.c_str(), tally.blocks,
                        tally.records, tally.worst, tally.allowed, tally.failed_blocks(), verdict(tally),
                        tally.worst_at.c_str());
        }
    }
}

struct GroupTally {
    long cases = 0, records = 0;
    double worst = 0;
};

// The theme of a case: the first word of its name.
std::string group_of(const std::string& case_name) { return case_name.substr(0, case_name.find('_')); }

// Worst difference per theme, without the rules that let an intended difference pass.
void print_groups(const Tallies& tallies)
{
    std::map<std::string, GroupTally> groups;
    for (const auto& [name, tally] : tallies) {
        GroupTally& group = groups[group_of(name)];
        ++group.cases;
        group.records += tally.records;
        for (const auto& [rule, rule_tally] : tally.rules) {
            if (rule->difference.empty()) { group.worst = std::max(group.worst, rule_tally.worst); }
        }
    }
    std::printf("\n%-12s %6s %9s %12s\n", "theme", "cases", "records", "worst");
    for (const auto& [name, group] : groups) {
        std::printf("%-12s %6ld %9ld %12.3g\n", name.c_str(), group.cases, group.records, group.worst);
    }
}

void print_pairs(const Tallies& tallies)
{
    std::printf("\n%-26s %6s %6s %6s %8s %8s %8s %7s %9s %7s %6s %6s %11s  %s\n", "pair", "poses", "hits",
                "misses", "touching", "disagree", "refmiss", "depth", "shallower", "normal", "count", "stuck",
                "worst depth", "verdict");
    for (const auto& [name, tally] : tallies) {
        if (tally.is_pair) {
            const PairTally& p = tally.pairs;
            std::printf("%-26s %6ld %6ld %6ld %8ld %8ld %8ld %7ld %9ld %7ld %6ld %6ld %11.3g  %s\n",
                        name.c_str(), p.poses, p.both_hit, p.both_miss, p.touching_disagree, p.disagree,
                        p.reference_misses, p.other_depth, p.shallower, p.other_normal, p.other_count,
                        p.inseparable, p.worst_depth, verdict(tally));
        }
    }
}

// The states that disagree most, by number of blocks.
void print_families(const CaseTally& tally)
{
    std::vector<std::pair<long, std::string>> worst;
    for (const auto& [family, count] : tally.failed_families) worst.emplace_back(-count, family);
    std::sort(worst.begin(), worst.end());
    const std::size_t shown = std::min<std::size_t>(worst.size(), 12);
    for (std::size_t i = 0; i < shown; ++i)
        std::printf("  %-40s %ld beyond\n", worst[i].second.c_str(), -worst[i].first);
    if (shown < worst.size()) std::printf("  and %zu more states\n", worst.size() - shown);
}

void print_failures(const Tallies& tallies)
{
    for (const auto& [name, tally] : tallies) {
        if (tally.passes()) { continue; }
        std::printf("\n%s\n", name.c_str());
        for (const std::string& error : tally.structure_errors) { std::printf("  %s\n", error.c_str()); }
        print_families(tally);
        for (const auto& [rule, rule_tally] : tally.rules) {
            if (!rule_tally.failed_blocks.empty()) {
                std::printf("  rule %s %s: %zu beyond, worst %.3g at %s, first %s\n", rule->case_glob.c_str(),
                            rule->key_glob.c_str(), rule_tally.failed_blocks.size(), rule_tally.worst,
                            rule_tally.worst_at.c_str(), rule_tally.failed_blocks.begin()->c_str());
            }
        }
    }
}

void print_differences(const RuleTable& table, const Tallies& tallies)
{
    std::set<std::string> used;
    for (const auto& [name, tally] : tallies) {
        for (const auto& [rule, rule_tally] : tally.rules) {
            if (!rule->difference.empty()) { used.insert(rule->difference); }
        }
    }
    std::printf("\nintended differences met by these rules:\n");
    for (const std::string& id : used) {
        std::printf("  %s  %s\n", id.c_str(), table.differences.at(id).c_str());
    }
}

int count_failures(const Tallies& tallies)
{
    int failures = 0;
    for (const auto& [name, tally] : tallies) { failures += tally.passes() ? 0 : 1; }
    return failures;
}

int run(char** paths)
{
    RecordFile ours(paths[0]), reference(paths[1]);
    RuleTable table;
    std::string error;
    if (!ours.is_open() || !reference.is_open() || !read_rules(paths[2], paths[3], table, error)) {
        std::fprintf(stderr, "parity_compare: %s\n",
                     error.empty() ? "cannot read the records" : error.c_str());
        return 2;
    }
    std::printf("ours      %s\nreference %s\n", ours.library().c_str(), reference.library().c_str());
    if (ours.library() == reference.library()) {
        std::fprintf(stderr, "parity_compare: both files come from the same library\n");
        return 2;
    }
    Tallies tallies;
    const bool complete = compare_files(ours, reference, table, tallies);
    print_values(tallies);
    print_pairs(tallies);
    print_groups(tallies);
    print_failures(tallies);
    print_differences(table, tallies);
    const int failures = count_failures(tallies);
    std::printf("\n%zu cases, %d beyond tolerance%s\n", tallies.size(), failures,
                complete ? "" : ", files INCOMPLETE");
    return failures == 0 && complete && !tallies.empty() ? 0 : 1;
}

}  // namespace
}  // namespace parity

int main(int argc, char** argv)
{
    if (argc != 5) {
        std::fprintf(stderr, "usage: parity_compare OURS.txt REFERENCE.txt TOLERANCES.tsv DIFFERENCES.tsv\n");
        return 2;
    }
    return parity::run(argv + 1);
}
