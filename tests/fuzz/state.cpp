// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// dWorldSetState on any bytes, in a world of each kind: refused, or the world steps on: after one in 16 of the inputs, since a step
// takes as long as reading hundreds of them.
#include "meter.h"
#include "world.h"

namespace {

using namespace epode::fuzz;

World make_ready(bool world_contacts)
{
    be_silent(), meter_library();
    const World w = make_world(world_contacts);
    for (int i = 0; i < 120; ++i) {
        w.step();
        if (i % 40 > 1) continue;
        Bytes state(dWorldGetStateSize(w.world));
        dWorldGetState(w.world, state.data(), state.size());
        keep_seed(world_contacts ? "managed" : "joints", i, state);
    }
    return w;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    static const bool ready = (dInitODE2(0), true);
    (void)ready;
    static const World worlds[] = {make_ready(true), make_ready(false)};
    constexpr std::size_t kHeader = 24;
    bool steps = false;
    Bytes state(data, data + size / 4 * 4);
    if (state.size() > kHeader) {
        put(state, 8, std::uint64_t(state.size()));
        const std::uint64_t sum = epode::states::checksum(&state[kHeader], state.size() - kHeader);
        put(state, 16, sum);
        steps = sum % 16 == 0;
    }
    for (const World& w : worlds) {
        const auto set = [&] {
            const Meter meter(size);
            return dWorldSetState(w.world, state.data(), state.size());
        };
        if (set() && steps) w.step();
    }
    return 0;
}
