// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Behind dCooperativeID, dResourceRequirementsID and dResourceContainerID. Each holds copies of what it needs
// of the one it was made from, so that none can dangle. The algorithms need no memory that grows with the
// problem; what a container holds is the means to post calls, and the sizes that were promised.
#pragma once

#include <atomic>

#include "base/objects/handle.h"
#include "ode/cooperative.h"
#include "tasks/tasks.h"

namespace epode {

// A threading implementation of the program's or of ours; impl null: none, the calling thread alone.
struct Helpers {
    dThreadingFunctionsInfo functions{};
    dThreadingImplementationID impl = nullptr;
};

struct Cooperative : Tagged {
    explicit Cooperative(const Helpers& h) : Tagged(Tag::kCooperative), helpers(h) {}
    const Helpers helpers;
};

// The largest calls to come. `unlimited` stands above every number of threads.
struct Needs {
    static constexpr unsigned kUnlimited = ~0u;
    unsigned threads = 0, rows = 0, elements = 0;
    void raise(const Needs& other);
};

struct Requirements : Tagged {
    explicit Requirements(const Helpers& h) : Tagged(Tag::kResourceRequirements), helpers(h) {}
    const Helpers helpers;
    Needs needs;
};

struct Container : Tagged {
    explicit Container(const Needs& n) : Tagged(Tag::kResourceContainer), needs(n) {}
    const Needs needs;
    bool helped = false;  // `posting` is open
    Posting posting;
    std::atomic_flag busy = ATOMIC_FLAG_INIT;
};

template <>
struct HandleOf<Cooperative> {
    using Id = dCooperativeID;
    static constexpr Tag kTag = Tag::kCooperative;
};
template <>
struct HandleOf<Requirements> {
    using Id = dResourceRequirementsID;
    static constexpr Tag kTag = Tag::kResourceRequirements;
};
template <>
struct HandleOf<Container> {
    using Id = dResourceContainerID;
    static constexpr Tag kTag = Tag::kResourceContainer;
};

}  // namespace epode
