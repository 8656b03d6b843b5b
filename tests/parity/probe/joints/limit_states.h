// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The states of a limited and motorised axis, as variants of a joint bench.
//
// Each variant writes parameters of one group (0, 0x100, 0x200). The bench's disturbance stays within 0.7, so
// stops [0.8,1.2] are violated from below and [-1.2,-0.8] from above: the state does not hang on the
// sign convention of a reversed joint, which is one of the things compared.
#pragma once

#include "rig.h"

namespace parity {

using SetParam = void (*)(dJointID, int parameter, dReal value);
using GetParam = dReal (*)(dJointID, int parameter);

std::vector<JointVariant> limit_variants(SetParam set, int group, const std::string& prefix);
void add_variants(std::vector<JointVariant>& all, std::vector<JointVariant> more);

// Every parameter of a group as read back.
void put_params(Output& out, const std::string& key, dJointID joint, GetParam get, int group);

}  // namespace parity
