// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// How hard the long sweeps try. A sanitizer makes every access several times slower and looks for wrong
// accesses, which a part of the poses reaches as well as all of them; the figures themselves are judged by
// the builds without one. Constants of the build and no environment variable: a test does the same work
// wherever it runs.
#pragma once

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define EPODE_TESTS_SANITIZED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define EPODE_TESTS_SANITIZED 1
#endif
#endif
#ifndef EPODE_TESTS_SANITIZED
#define EPODE_TESTS_SANITIZED 0
#endif

namespace epode::tests {

inline constexpr bool kSanitized = EPODE_TESTS_SANITIZED;

// The part of a sweep that this build makes.
constexpr int effort(int full) { return kSanitized ? (full + 4) / 5 : full; }

}  // namespace epode::tests
