// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The functions of a program that the library calls, one entry for each kind in the table of docs/errors.md: how a
// scene makes the library call it, and where a test's call is hooked in.
#pragma once

#include <span>

#include "scene.h"

namespace hostile {

struct Phase {
    const char* name;  // " inside a near callback"
    Hook Hooks::*hook;
    // `other`: in another way, where there are two.
    void (*enter)(Scene& scene, bool other);
};

std::span<const Phase> phases();

}  // namespace hostile
