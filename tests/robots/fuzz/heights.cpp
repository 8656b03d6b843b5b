// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A reader of height fields on any bytes: what it accepts has as many samples as rows times columns, from 0 to 1.
#include <cstdint>
#include <cstdlib>

#include "limit.h"
#include "robots/heights/heights.h"

using namespace epode::robots;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const epode::fuzz::TimeLimit limit;
    HeightField field;
    std::string problem;
    const std::string bytes(reinterpret_cast<const char*>(data), size);
    if (!read_heights(bytes, std::string(EPODE_ENDING) == "png", field, problem)) {
        if (problem.empty()) std::abort();
        return 0;
    }
    if (field.rows < 2 || field.columns < 2 ||
        field.samples.size() != size_t(field.rows) * size_t(field.columns))
        std::abort();
    for (const double sample : field.samples)
        if (!(sample >= 0 && sample <= 1)) std::abort();
    return 0;
}
