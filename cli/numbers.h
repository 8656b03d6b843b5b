// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What an option takes that wants a number: the whole text must be one, finite and within bounds. (CLI11's
// own Range lets NaN through, since NaN is neither below nor above anything.)
#pragma once

#include <CLI/CLI.hpp>

namespace epode::cli {

CLI::Validator number_within(double low, double high);
CLI::Validator whole_number_within(long low, long high);

}  // namespace epode::cli
