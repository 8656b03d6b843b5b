// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The open list of cases: a file of cases registers its functions by itself and no other file changes.
//
// PARITY_CASE(name) { ... } defines a function with the parameters (Output& out, Random& rng) and puts it
// on the list. The list is sorted by name before use, so link order does not show in the records. A table
// in one file was rejected: every new theme would edit it.
#pragma once

#include "output.h"
#include "random.h"

#include <vector>

namespace parity {

struct Case {
    const char* name;
    void (*run)(Output& out, Random& rng);
};

std::vector<Case>& case_list();

// How many random poses every ordered pair of geom classes is tried in.
int& poses_of_a_pair();

struct CaseEntry {
    CaseEntry(const char* name, void (*run)(Output&, Random&)) { case_list().push_back({name, run}); }
};

}  // namespace parity

#define PARITY_CASE(name)                                                                                \
    static void case_##name([[maybe_unused]] parity::Output& out, [[maybe_unused]] parity::Random& rng); \
    static const parity::CaseEntry case_entry_##name(#name, &case_##name);                               \
    static void case_##name([[maybe_unused]] parity::Output& out, [[maybe_unused]] parity::Random& rng)
