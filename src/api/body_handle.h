// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// How the C functions of bodies check what they are given. Macros, because a refusal must return from the
// function that was called and name it.
#pragma once

#include "base/check.h"
#include "base/refusals.h"
#include "dynamics/world.h"

// The body behind the handle `b`, or the call is refused with the given result.
#define BODY_OR(...)                                              \
    epode::Body* const body = epode::from_handle<epode::Body>(b); \
    EPODE_USER(body != nullptr __VA_OPT__(, ) __VA_ARGS__)

namespace epode {

// A condition on an argument for this body: if the call is refused, the diagnosis of its world names both.
inline bool fits(const Body& body, bool condition)
{
    if (!condition) concern({0, body.world, to_handle(&body), nullptr});
    return condition;
}

}  // namespace epode

#define USABLE3(x, y, z) \
    EPODE_USER(epode::fits(*body, epode::usable(x) && epode::usable(y) && epode::usable(z)))
