// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See rules.h. A rule that allows a fraction without naming a known difference is refused: that is what keeps
// "every intended difference stands in a table with its reason" true.
#include "rules.h"

#include <cstdlib>
#include <fstream>
#include <sstream>

namespace parity {
namespace {

std::vector<std::string> split_tabs(const std::string& line)
{
    std::vector<std::string> fields;
    std::istringstream stream(line);
    for (std::string field; std::getline(stream, field, '\t');) { fields.push_back(field); }
    return fields;
}

bool is_content(const std::string& line) { return !line.empty() && line[0] != '#'; }

bool parse_kind(const std::string& word, RuleKind& kind)
{
    const std::pair<const char*, RuleKind> names[] = {
        {"exact", RuleKind::kExact}, {"scaled", RuleKind::kScaled},     {"least", RuleKind::kLeast},
        {"pair", RuleKind::kPair},   {"contacts", RuleKind::kContacts}, {"shallower", RuleKind::kShallower}};
    for (const auto& [name, value] : names) {
        if (word == name) {
            kind = value;
            return true;
        }
    }
    return false;
}

bool parse_rule(const std::string& line, RuleTable& table, std::string& error)
{
    const std::vector<std::string> f = split_tabs(line);
    Rule rule;
    if (f.size() < 6 || !parse_kind(f[2], rule.kind)) {
        error = "not a rule: " + line;
        return false;
    }
    rule.case_glob = f[0];
    rule.key_glob = f[1];
    rule.tolerance = std::atof(f[3].c_str());
    rule.floor = std::atof(f[4].c_str());
    rule.fraction = std::atof(f[5].c_str());
    rule.difference = f.size() > 6 ? f[6] : "";
    const bool named = table.differences.count(rule.difference) > 0;
    if ((rule.fraction > 0 && !named) || (!rule.difference.empty() && !named)) {
        error = "rule without a difference of the table: " + line;
        return false;
    }
    table.rules.push_back(rule);
    return true;
}

bool read_differences(const std::string& path, RuleTable& table, std::string& error)
{
    std::ifstream input(path);
    if (!input) {
        error = "cannot read " + path;
        return false;
    }
    for (std::string line; std::getline(input, line);) {
        const std::vector<std::string> f = split_tabs(line);
        if (is_content(line) && f.size() >= 3) { table.differences[f[0]] = f[1] + ": " + f[2]; }
    }
    return true;
}

}  // namespace

bool glob_match(const char* pattern, const char* text)
{
    if (*pattern == '\0') { return *text == '\0'; }
    if (*pattern == '*') {
        return glob_match(pattern + 1, text) || (*text != '\0' && glob_match(pattern, text + 1));
    }
    return *text != '\0' && (*pattern == '?' || *pattern == *text) && glob_match(pattern + 1, text + 1);
}

const Rule* RuleTable::find(const std::string& case_name, const std::string& key) const
{
    for (const Rule& rule : rules) {
        if (glob_match(rule.case_glob.c_str(), case_name.c_str()) &&
            glob_match(rule.key_glob.c_str(), key.c_str())) {
            return &rule;
        }
    }
    return nullptr;
}

bool read_rules(const std::string& rules_path, const std::string& differences_path, RuleTable& table,
                std::string& error)
{
    if (!read_differences(differences_path, table, error)) { return false; }
    std::ifstream input(rules_path);
    if (!input) {
        error = "cannot read " + rules_path;
        return false;
    }
    for (std::string line; std::getline(input, line);) {
        if (is_content(line) && !parse_rule(line, table, error)) { return false; }
    }
    return true;
}

}  // namespace parity
