// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The last refused calls, for whoever wants to know why a simulation goes wrong: which function, and the body or
// joint that was to be changed, if it is known. Nothing is kept while nobody watches. Objects are handles, since
// they may be gone when the refusal is looked at.
#pragma once

#include <cstdint>

#include "ode/common.h"

namespace epode {

struct Refusal {
    int call = 0;  // name_of_call() knows it
    const void* world = nullptr;
    dBodyID body = nullptr;
    dJointID joint = nullptr;
};

inline constexpr int kRefusalsKept = 16;

void watch_refusals(bool on);  // counts
// Of the call that this thread is about to refuse.
void concern(const Refusal& objects);
[[gnu::cold]] void remember_refusal(const char* function);
// How many there have been; of them the last kRefusalsKept can be read, by number from 0.
std::uint64_t refusal_count();
Refusal refusal(std::uint64_t number);
// Null: there is none.
const char* name_of_call(int call);

}  // namespace epode
