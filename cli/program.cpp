// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// epode: the program.
#include "cli/command.h"

int main(int argc, char** argv) { return epode::cli::run_command(argc, argv); }
