// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// docs/quality.md: the results as tables, a row for each law and step size, a column for each method.
#pragma once

#include "known.h"

namespace epode::trials {

std::string quality_page(const std::vector<Result>& results, const Known& known);
// Failing cells of presets first, then the others, the worst first: a line each.
std::string ranking(const std::vector<Result>& results, const Known& known);

}  // namespace epode::trials
