// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Golden hashes: 64-bit hashes of results that must have the same bits with every compiler, processor and number of
// threads. All of them are in the .inc files here, one a family, compiled in because emulated tests have no files.
// `scripts/golden` prints those that have moved, `scripts/golden --update` writes them; CONTRIBUTING.md ("Golden
// hashes") says when that is honest. Entries of frozen.inc never move.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <string>
#include <string_view>

namespace epode::golden {

struct Entry {
    std::string_view name;  // family/scene/variant
    std::uint64_t hash;
};

inline constexpr Entry kEntries[] = {
#include "batch.inc"
#include "frozen.inc"
#include "physics.inc"
#include "state.inc"
#include "unit.inc"
};

// Whether `hash` is the entry `name`. Where EPODE_PRINT_HASHES is set, prints both for scripts/golden.
inline testing::AssertionResult is_golden(const std::string& name, std::uint64_t hash)
{
    char now[24];
    std::snprintf(now, sizeof now, "0x%016llx", static_cast<unsigned long long>(hash));
    if (std::getenv("EPODE_PRINT_HASHES")) std::printf("golden %s %s\n", name.c_str(), now);
    const Entry* const entry = std::find_if(std::begin(kEntries), std::end(kEntries),
                                            [&](const Entry& e) { return e.name == name; });
    if (entry == std::end(kEntries))
        return testing::AssertionFailure() << "tests/golden has no " << name << ", which is " << now;
    if (entry->hash != hash)
        return testing::AssertionFailure() << name << " is " << now << " now (scripts/golden)";
    return testing::AssertionSuccess();
}

}  // namespace epode::golden
