// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A counter-based generator: the n-th number is a function of (key, n) alone. A solver that shuffles its rows
// therefore depends on no process-wide state, and worlds cannot disturb each other. (ODE's QuickStep draws
// from dRand, which all worlds share.) The mixing function is the finaliser of SplitMix64 (Steele, Lea, Flood
// 2014).
#pragma once

#include <cstdint>

namespace epode {

class CounterRandom {
  public:
    explicit constexpr CounterRandom(std::uint64_t key) : key_(key) {}

    constexpr std::uint64_t next()
    {
        std::uint64_t z = key_ + (++counter_) * 0x9e3779b97f4a7c15u;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }

    // In [0, n); the bias of n / 2^32 does not matter for shuffling.
    constexpr int below(int n) { return int((next() >> 32) * std::uint64_t(n) >> 32); }

  private:
    std::uint64_t key_;
    std::uint64_t counter_ = 0;
};

}  // namespace epode
