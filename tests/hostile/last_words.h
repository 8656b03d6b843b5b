// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// If the process dies, or a call never comes back, the last call is named on stderr.
#pragma once

#include <functional>
#include <string>

namespace hostile {

void last_words(std::function<std::string()> words);  // for the call that begins; null: none does
void listen_for_death();                              // once, at the beginning

}  // namespace hostile
