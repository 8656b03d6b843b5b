// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See numbers.h.
#include "cli/numbers.h"

#include <fmt/format.h>

#include <charconv>

namespace epode::cli {

namespace {

// from_chars takes no white space, no sign + and nothing that depends on the locale.
template <class Number>
bool parse(const std::string& text, Number& value)
{
    const char* end = text.data() + text.size();
    const auto [at, error] = std::from_chars(text.data(), end, value);
    return error == std::errc() && at == end;
}

template <class Number>
CLI::Validator within(Number low, Number high, const char* kind)
{
    const std::string wanted = fmt::format("{} from {} to {}", kind, low, high);
    return CLI::Validator(
        [=](std::string& text) {
            Number value{};
            // In this order: a NaN is not above anything.
            const bool fits = parse(text, value) && value >= low && value <= high;
            return fits ? std::string() : fmt::format("'{}' is not {}", text, wanted);
        },
        std::string());
}

}  // namespace

CLI::Validator number_within(double low, double high) { return within(low, high, "a number"); }

CLI::Validator whole_number_within(long low, long high) { return within(low, high, "a whole number"); }

}  // namespace epode::cli
