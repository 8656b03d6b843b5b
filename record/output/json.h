// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Writing JSON in order, with commas where they belong. Own, since eighty lines cost less than a dependency
// of a library.
#pragma once

#include <cmath>
#include <string>

#include "record/output/digits.h"

namespace epode::record {

class Json {
  public:
    Json& object() { return open('{'); }
    Json& array() { return open('['); }
    Json& end_object() { return close('}'); }
    Json& end_array() { return close(']'); }

    Json& key(const char* name)
    {
        value_begins();
        quote(name);
        text_ += ':';
        fresh_ = true;
        return *this;
    }
    Json& value(const std::string& text)
    {
        value_begins();
        quote(text);
        return *this;
    }
    Json& value(const char* text) { return value(std::string(text)); }
    Json& value(double number) { return raw(std::isfinite(number) ? digits_of(number, 9) : "null"); }
    Json& value(size_t number) { return raw(std::to_string(number)); }
    Json& value(int number) { return raw(std::to_string(number)); }
    Json& value(bool yes) { return raw(yes ? "true" : "false"); }
    template <class Values>
    Json& values(const Values& values)
    {
        array();
        for (const auto& each : values) value(double(each));
        return end_array();
    }
    const std::string& text() const { return text_; }

  private:
    Json& raw(const std::string& text)
    {
        value_begins();
        text_ += text;
        return *this;
    }
    Json& open(char bracket)
    {
        value_begins();
        text_ += bracket;
        fresh_ = true;
        return *this;
    }
    Json& close(char bracket)
    {
        text_ += bracket;
        fresh_ = false;
        return *this;
    }
    void value_begins()
    {
        if (!fresh_) text_ += ',';
        fresh_ = false;
    }
    // "</" is broken up, so that the text may stand inside a page.
    void quote(const std::string& text)
    {
        text_ += '"';
        for (char c : text) {
            if (c == '"' || c == '\\') text_ += '\\';
            if (c == '<') {
                text_ += "\\u003c";
            } else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) {
                char code[8];
                std::snprintf(code, sizeof code, "\\u%04x", unsigned(static_cast<unsigned char>(c)));
                text_ += code;
            } else {
                text_ += c;
            }
        }
        text_ += '"';
    }
    std::string text_;
    bool fresh_ = true;  // nothing stands before what comes next
};

}  // namespace epode::record
