// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A cause as a sentence.
#pragma once

#include <cstddef>

#include "ode/diagnosis.h"

namespace epode {

// Null: no such kind.
const char* text_of(int kind);

extern const char* const k_text_of_refusal;             // after the name of a function
extern const char* const k_text_of_unphysical_inertia;  // instead of that of the kind
inline constexpr double kUnphysical = 1;                // threshold of such an inertia

// As snprintf: the length of the whole text.
int write_text(const dDiagnosis& cause, char* text, std::size_t size);

}  // namespace epode
