// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See engine.h.
#include "bench/engines/engine.h"

namespace epode::bench {

#define BENCH_ENGINE(name) extern const EngineEntry name;
#include "bench/engines/engines.inc"
#undef BENCH_ENGINE

const std::vector<const EngineEntry*>& engine_entries()
{
    static const std::vector<const EngineEntry*> entries = {
#define BENCH_ENGINE(name) &name,
#include "bench/engines/engines.inc"
#undef BENCH_ENGINE
    };
    return entries;
}

}  // namespace epode::bench
