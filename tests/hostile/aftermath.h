// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What a call leaves behind apart from the state that readers show: settings of the process, settings that
// nothing reads, and new objects that nobody holds. Found by the name of the function.
#pragma once

#include "table.h"

namespace hostile {

// Touches what belongs to the process and not to the scene.
bool is_global(const Function& function);

// Changes something that no reader shows.
bool is_hidden(const Function& function);

// Makes or takes a thread pool, which the scene has on request only.
bool uses_threads(const Function& function);

// Gives back what a call has made that no scene holds.
void give_back(const Function& function, const Value* arguments, const Result& result);

}  // namespace hostile
