// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See records.h. strtod reads "inf" and "nan" as printf writes them; stream extraction would not.
#include "records.h"

#include <cstdlib>

namespace parity {
namespace {

void parse_values(Record& record)
{
    record.values.clear();
    const char* at = record.text.c_str();
    for (;;) {
        char* end = nullptr;
        const double value = std::strtod(at, &end);
        if (end == at) { break; }
        record.values.push_back(value);
        at = end;
    }
    while (*at == ' ') { ++at; }
    record.numeric = *at == '\0';
}

bool parse_line(const std::string& line, Record& record)
{
    const std::size_t first = line.find(' ');
    if (first == std::string::npos) { return false; }
    std::size_t second = line.find(' ', first + 1);
    if (second == std::string::npos) { second = line.size(); }
    const std::size_t slash = line.rfind('/', second - 1);
    if (slash == std::string::npos || slash < first) { return false; }
    record.case_name = line.substr(0, first);
    record.block = line.substr(first + 1, slash - first - 1);
    record.key = line.substr(slash + 1, second - slash - 1);
    record.text = second < line.size() ? line.substr(second + 1) : std::string();
    parse_values(record);
    return true;
}

}  // namespace

RecordFile::RecordFile(const std::string& path) : input_(path) { has_ahead_ = read_record(); }

bool RecordFile::read_record()
{
    static const std::string kLibrary = "#library ";
    for (std::string line; std::getline(input_, line);) {
        if (line.starts_with(kLibrary)) {
            library_ = line.substr(kLibrary.size());
        } else if (parse_line(line, ahead_)) {
            return true;
        }
    }
    return false;
}

bool RecordFile::next(Block& block)
{
    if (!has_ahead_) { return false; }
    block.case_name = ahead_.case_name;
    block.name = ahead_.block;
    block.records.clear();
    while (has_ahead_ && ahead_.case_name == block.case_name && ahead_.block == block.name) {
        block.records.push_back(ahead_);
        has_ahead_ = read_record();
    }
    return true;
}

}  // namespace parity
