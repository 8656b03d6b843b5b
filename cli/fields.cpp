// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A number that is not finite is null: JSON has no other word for it.
#include "cli/fields.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace epode::cli {

namespace {

std::string json_number(double value) { return std::isfinite(value) ? fmt::format("{:.9g}", value) : "null"; }

std::string json_string(const std::string& text)
{
    std::string quoted = "\"";
    for (char c : text) {
        if (c == '"' || c == '\\') quoted += '\\';
        if (static_cast<unsigned char>(c) >= 0x20) quoted += c;
    }
    return quoted + "\"";
}

}  // namespace

void FieldList::number(const char* key, double value, std::string label, std::string text)
{
    fields_.push_back({key, json_number(value), std::move(label), std::move(text)});
}

void FieldList::string(const char* key, const std::string& value, std::string label, std::string text)
{
    fields_.push_back({key, json_string(value), std::move(label), std::move(text)});
}

void FieldList::raw(const char* key, std::string json, std::string label, std::string text)
{
    fields_.push_back({key, std::move(json), std::move(label), std::move(text)});
}

std::string as_table(const std::vector<Field>& fields)
{
    size_t width = 0;
    for (const Field& field : fields) width = std::max(width, field.label.size());
    std::string table;
    for (const Field& field : fields) {
        if (!field.label.empty()) table += fmt::format("{:<{}}  {}\n", field.label, width, field.text);
    }
    return table;
}

std::string as_json(const std::vector<Field>& fields)
{
    std::string object = "{\n";
    for (size_t i = 0; i < fields.size(); ++i) {
        object +=
            fmt::format("  \"{}\": {}{}\n", fields[i].key, fields[i].json, i + 1 < fields.size() ? "," : "");
    }
    return object + "}\n";
}

}  // namespace epode::cli
