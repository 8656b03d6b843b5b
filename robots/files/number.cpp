// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See number.h.
#include "robots/files/number.h"

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <string>
#include <system_error>

namespace epode::robots {

#if defined(__cpp_lib_to_chars)

const char* read_number(const char* at, const char* end, double& value)
{
    const auto [next, error] = std::from_chars(at, end, value);
    return error == std::errc() ? next : nullptr;
}

#else  // WebAssembly's standard library reads no doubles so. Its strtod knows no other locale and rounds as from_chars does.

const char* read_number(const char* at, const char* end, double& value)
{
    if (at == end || *at == '+') return nullptr;
    const std::string_view rest(at, size_t(end - at));
    const std::string digits(rest.substr(0, rest.find_first_not_of("0123456789+-.eE")));
    char* stop = nullptr;
    const double found = std::strtod(digits.c_str(), &stop);
    if (stop == digits.c_str() || std::isinf(found)) return nullptr;
    value = found;
    return at + (stop - digits.c_str());
}

#endif

}  // namespace epode::robots
