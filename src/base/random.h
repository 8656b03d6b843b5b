// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A counter-based generator: the n-th number is a function of (key, n) alone. A solver that shuffles its rows
// therefore depends on no process-wide state, and worlds cannot disturb each other. The mixing function is the
// finaliser of SplitMix64 (Steele, Lea, Flood 2014).
//
// And ODE's public generator, s' = 1664525 s + 1013904223 mod 2^32 (Knuth & Lewis, in Press et al., "Numerical
// Recipes"), kept because programs rely on the very sequence. It has one state for the process, here an
// atomic, so that threads that draw at once get different numbers. Only dWorldQuickStep in a world with the
// behaviour of ODE 0.16 draws from it.
#pragma once

#include <atomic>
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

class ProcessRandom {
  public:
    static constexpr std::uint32_t following(std::uint32_t s) { return 1664525u * s + 1013904223u; }

    static std::uint32_t state() { return state_.load(std::memory_order_relaxed); }
    static void set_state(std::uint32_t s) { state_.store(s, std::memory_order_relaxed); }

    static std::uint32_t next()
    {
        std::uint32_t s = state();
        while (!state_.compare_exchange_weak(s, following(s), std::memory_order_relaxed)) {}
        return following(s);
    }

    // In [0, n), and 0 for n < 1, which draws a number too, as in ODE.
    static int below(int n)
    {
        const std::uint32_t r = next();
        return n > 0 ? int(fold(r, std::uint32_t(n))) : 0;
    }

  private:
    // The poor low bits of the generator are folded into the high ones until as many bits are left as n
    // needs; ODE's programs see this exact choice.
    static constexpr std::uint32_t fold(std::uint32_t r, std::uint32_t n)
    {
        if (n > 0x10000) return std::uint32_t(std::uint64_t(r) * n >> 32);
        r ^= r >> 16;
        if (n > 0x100) return (r & 0xffff) * n >> 16;
        r ^= r >> 8;
        if (n > 0x10) return (r & 0xff) * n >> 8;
        r ^= r >> 4;
        if (n > 4) return (r & 0xf) * n >> 4;
        r ^= r >> 2;
        if (n > 2) return (r & 3) * n >> 2;
        r ^= r >> 1;
        return r & (n >> 1);
    }

    static inline std::atomic<std::uint32_t> state_{0};
};

}  // namespace epode
