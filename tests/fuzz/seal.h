// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Fuzzed bytes get the right sizes and checksum, since few would be looked at without; the library is silent
// about what it refuses; and valid inputs to begin with.
#pragma once

#include <ode/ext.h>
#include <ode/ode.h>

#include <cstdarg>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "../state/checksum.h"

namespace epode::fuzz {

using Bytes = std::vector<unsigned char>;

inline void ignore(int, const char*, va_list) {}

inline void be_silent() { dSetDebugHandler(ignore), dSetMessageHandler(ignore), dSetErrorHandler(ignore); }

template <typename T>
void put(Bytes& bytes, std::size_t at, T value)
{
    std::memcpy(&bytes[at], &value, sizeof value);
}

// A valid input, for the corpus: into the folder EPODE_FUZZ_SEEDS, if the environment has it.
inline void keep_seed(const char* name, int number, const Bytes& bytes)
{
    const char* const folder = std::getenv("EPODE_FUZZ_SEEDS");
    if (!folder) return;
    const std::string path = std::string(folder) + '/' + name + '_' + std::to_string(number);
    if (std::FILE* const file = std::fopen(path.c_str(), "wb")) {
        std::fwrite(bytes.data(), 1, bytes.size(), file);
        std::fclose(file);
    }
}

}  // namespace epode::fuzz
