// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What a command has to say: one list of named fields, printed as a table for people or as one JSON object
// for programs. Both come from the same list, so they cannot disagree.
#pragma once

#include <string>
#include <vector>

namespace epode::cli {

struct Field {
    std::string key;    // of the JSON object
    std::string json;   // ready to print: a number, a quoted string, null, a bool
    std::string label;  // of the table; empty: this field is for programs only
    std::string text;
};

class FieldList {
  public:
    void number(const char* key, double value, std::string label = {}, std::string text = {});
    void string(const char* key, const std::string& value, std::string label = {}, std::string text = {});
    // json is ready to print: null, true, false.
    void raw(const char* key, std::string json, std::string label = {}, std::string text = {});
    std::vector<Field> take() { return std::move(fields_); }

  private:
    std::vector<Field> fields_;
};

std::string as_table(const std::vector<Field>& fields);
std::string as_json(const std::vector<Field>& fields);

}  // namespace epode::cli
