// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Inside the player: a call, and whether the rules and the library agree on it. The three C callbacks.
#pragma once

#include "player.h"

namespace epode::sequences {

template <typename Run>
bool Player::attempt(bool legal, const char* what, Run&& run)
{
    const int before = script.refusals;
    run();
    const bool was_refused = script.refusals != before;
    if (was_refused) ++refused;
    if (!in_callback() && was_refused == legal)
        fail("%s was %s, against the rules", what, was_refused ? "refused" : "accepted");
    return !was_refused;
}

// What the library answers is taken.
template <typename Run>
auto Player::take(Run&& run)
{
    struct Count {
        Player& player;
        const int before = player.script.refusals;
        ~Count() { player.refused += player.last_refused_ = player.script.refusals != before; }
    } count{*this};
    return run();
}

// A call with its name; `legal` decides what is expected.
#define ATTEMPT(legal, function, ...) \
    attempt(legal, #function, [&] { CALL(function __VA_OPT__(, ) __VA_ARGS__); })

#define TRY(function, ...) take([&] { return CALL(function __VA_OPT__(, ) __VA_ARGS__); })

inline void near_c(void* player, dGeomID a, dGeomID b) { static_cast<Player*>(player)->near(a, b); }

}  // namespace epode::sequences
