// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Reads what dWorldExportDIF writes into records, one per field: the path to it as the key, its numbers or
// its words as the value. Forgiving where Debian's text is no Lua: a comma may be missing, and a bare word
// without a value is passed over.
#pragma once

#include "output.h"

#include <string>

namespace parity {

// What dWorldExportDIF writes of a world.
std::string exported(dWorldID world, const char* prefix);

void put_dif(Output& out, const std::string& text);

}  // namespace parity
