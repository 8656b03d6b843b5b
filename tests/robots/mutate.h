// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Texts of files, damaged: bytes changed, pieces cut out, copied and put elsewhere, numbers made absurd.
#pragma once

#include <algorithm>
#include <iterator>
#include <random>
#include <string>
#include <utility>

namespace epode::robots {

inline const char* const kAbsurd[] = {"1e308",  "-1e308",       "nan", "inf", "0",  "-1",
                                      "1e-320", "999999999999", "\"",  "<",   "--", ""};

// One damage, of a text that is not empty.
inline void damage(std::string& text, std::mt19937& random)
{
    const auto below = [&](size_t n) { return n ? random() % n : 0; };
    const size_t at = below(text.size()), size = 1 + below(std::min<size_t>(200, text.size() - at));
    switch (below(5)) {
        case 0:
            text[at] = char(random());
            return;
        case 1:
            text.erase(at, size);
            return;
        case 2:
            text.insert(below(text.size()), text.substr(at, size));
            return;
        case 3:
            text.replace(at, std::min<size_t>(size, 4), kAbsurd[below(std::size(kAbsurd))]);
            return;
        default: {
            const size_t digit = text.find_first_of("0123456789", at);
            if (digit != std::string::npos) text.replace(digit, 1, kAbsurd[below(std::size(kAbsurd))]);
        }
    }
}

// The place after the quotation mark that begins a value, from somewhere on, and the value's size; a text without one: its end, 0.
inline std::pair<size_t, size_t> value_of(const std::string& text, std::mt19937& random)
{
    const size_t from = text.empty() ? 0 : random() % text.size(), equals = text.find('=', from);
    if (equals == std::string::npos || equals + 1 >= text.size()) return {text.size(), 0};
    const size_t begin = equals + 2, end = text.find(text[equals + 1], begin);
    return end == std::string::npos ? std::pair(text.size(), size_t(0)) : std::pair(begin, end - begin);
}

// A value becomes another one of the file, or one of its numbers an absurd one: the text stays well formed.
inline void damage_value(std::string& text, std::mt19937& random)
{
    static const char* const numbers[] = {"1e308", "-1e308", "nan",  "inf", "0",   "-1",  "1e-320",
                                          "1e9",   "1e-9",   "1e30", "1",   "0.5", "100", ""};
    const auto [at, size] = value_of(text, random);
    if (random() % 4 == 0) {
        const auto [from, length] = value_of(text, random);
        text.replace(std::min(at, text.size()), size, std::string(text, std::min(from, text.size()), length));
        return;
    }
    const size_t digit = text.find_first_of("-0123456789", at);
    if (digit == std::string::npos || digit >= at + size) return;
    const size_t end = std::min(text.find_first_not_of("-.e0123456789", digit), at + size);
    text.replace(digit, end - digit, numbers[random() % std::size(numbers)]);
}

// An element without others inside is left out, or stands elsewhere too.
inline void damage_element(std::string& text, std::mt19937& random)
{
    const size_t end = text.find("/>", text.empty() ? 0 : random() % text.size());
    const size_t begin = end == std::string::npos ? end : text.rfind('<', end);
    if (begin == std::string::npos) return;
    const std::string element = text.substr(begin, end + 2 - begin);
    if (random() % 2) text.erase(begin, element.size());
    const size_t to = text.find('>', text.empty() ? 0 : random() % text.size());
    if (random() % 2 && to != std::string::npos) text.insert(to + 1, element);
}

// One to four of them, in half of the texts of those that leave them well formed.
inline std::string mutated(std::string text, std::mt19937& random)
{
    const bool is_text = random() % 2;
    for (size_t i = 0, count = 1 + random() % 4; i < count && !text.empty(); ++i) {
        if (!is_text)
            random() % 3 ? damage_value(text, random) : damage_element(text, random);
        else
            damage(text, random);
    }
    return text;
}

}  // namespace epode::robots
