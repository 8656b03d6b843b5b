// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The library's own books, looked into after every hostile call.
#include "runner.h"
#include "step/validate.h"

namespace hostile {

const char* hostile_broken_invariant(const Scene& scene)
{
    const char* found = nullptr;
    for (void* p : scene.live[std::size_t(Kind::kWorld)])
        if (const auto* world = epode::from_handle<epode::World>(static_cast<dWorldID>(p)); world && !found)
            found = epode::fault_of(*world);
    for (void* p : scene.live[std::size_t(Kind::kSpace)])
        if (const auto* space = epode::space_from(static_cast<dSpaceID>(p)); space && !found)
            found = epode::fault_of(*space);
    return found;
}

}  // namespace hostile
