// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The generated table.
#include "table.h"

namespace hostile {
namespace {

#include "calls.inc"

}  // namespace

std::span<const Function> functions() { return kTable; }
std::span<const Absent> absent_functions() { return kAbsent; }
std::span<const CreateJoint> joint_makers() { return kJoints; }

}  // namespace hostile
