// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What a world keeps from step to step on its way into bytes and back (ode/state.h). Each part of the engine
// visits its own numbers, in one function for both directions, so that writing and reading cannot disagree:
//   kMeasure  counts the bytes that kWrite would write
//   kWrite    puts them into a buffer that has been measured
//   kCheck    reads and judges, and stores nothing
//   kRead     reads, judges and stores
// A value that is no object of its own is handed in and comes back: the present one when a state is saved,
// the saved one when it is loaded. All sizes are multiples of four bytes. Numbers are written as they lie in
// memory, little endian. The first thing that is wrong is remembered, in words; what is read after it is 0.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <limits>

#include "base/check.h"

namespace epode {

static_assert(std::endian::native == std::endian::little, "states are little endian");

class StateStream {
  public:
    enum class Mode { kMeasure, kWrite, kCheck, kRead };

    StateStream() = default;  // measures
    // Writes from here on; there is enough room.
    explicit StateStream(std::byte* to) : mode_(Mode::kWrite), at_(to) {}
    StateStream(Mode mode, const std::byte* from, std::size_t size)
        : mode_(mode), at_(const_cast<std::byte*>(from)), size_(size)
    {}

    bool measures() const { return mode_ == Mode::kMeasure; }
    bool saves() const { return mode_ <= Mode::kWrite; }
    bool stores() const { return mode_ == Mode::kRead; }
    // From now on what is checked is stored, too: in objects that nobody uses yet.
    void set_mode(Mode mode) { mode_ = mode; }
    Mode mode() const { return mode_; }

    bool failed() const { return text_[0] != 0; }
    const char* text() const { return text_; }
    // Of the first thing that is wrong.
    [[gnu::format(printf, 2, 3), gnu::cold]] void fail(const char* format, ...);
    // False, and this is what is wrong, unless the condition holds.
    bool demand(bool condition, const char* text)
    {
        if (!condition) [[unlikely]]
            fail("%s", text);
        return condition;
    }

    // Bytes counted, or left to be read.
    std::size_t size() const { return size_; }
    const std::byte* at() const { return at_; }

    std::uint32_t word(std::uint32_t value) { return whole(value); }
    std::uint64_t long_word(std::uint64_t value) { return whole(value); }
    // Below `end`.
    std::uint32_t index(std::uint32_t value, std::uint32_t end, const char* text)
    {
        value = word(value);
        return saves() || demand(value < end, text) ? value : 0;
    }

    // Finite numbers; `infinite`: or infinite. What flies away may be farther than a program may put it.
    void reals(Real* values, int count, bool infinite = false)
    {
        bytes(values, sizeof(Real) * std::size_t(count), [&](const std::byte* from) {
            bool good = true;
            for (int i = 0; i < count; ++i) {
                Real x;
                std::memcpy(&x, from + sizeof x * std::size_t(i), sizeof x);
                good = good & within(x, infinite ? kInf : std::numeric_limits<Real>::max());
            }
            return good;
        });
    }
    // What a solver starts from and contacts are found by: any bits, since steps contain what comes of them.
    void guesses(Real* values, int count)
    {
        bytes(values, sizeof(Real) * std::size_t(count), [](const std::byte*) { return true; });
    }
    void floats(float* values, int count)
    {
        bytes(values, sizeof(float) * std::size_t(count), [](const std::byte*) { return true; });
    }

    // A run of bytes, filled up to a multiple of four: to be written or read at the caller's pace. Null when
    // there are not enough of them, or while they are only measured.
    std::byte* block(std::size_t count)
    {
        const std::size_t whole = (count + 3) / 4 * 4;
        if (measures()) {
            size_ += whole;
            return nullptr;
        }
        if (!saves() && !take(whole)) return nullptr;
        std::byte* const begin = at_;
        if (!saves())
            size_ -= whole;
        else if (whole != count)
            std::memset(begin + count, 0, whole - count);
        at_ += whole;
        return begin;
    }

    struct Number {
        Real* value;
        Real usual;
        bool infinite = false;  // may be
        Real least = -kInf;
    };
    // Numbers of which most are what they are in most objects, at most 16, and 16 bits more, which come back:
    // only unusual numbers take space.
    std::uint32_t unusual(std::initializer_list<Number> numbers, std::uint32_t bits = 0);

  private:
    void number(const Number& n);
    template <typename T>
    T whole(T value)
    {
        bytes(&value, sizeof value, [&](const std::byte* from) {
            std::memcpy(&value, from, sizeof value);
            return true;
        });
        return !saves() && failed() ? T(0) : value;
    }
    template <typename Judge>
    void bytes(void* values, std::size_t count, Judge&& judge)
    {
        switch (mode_) {
            case Mode::kMeasure:
                size_ += count;
                return;
            case Mode::kWrite:
                std::memcpy(at_, values, count);
                at_ += count;
                return;
            default:
                if (!take(count)) return;
                if (!judge(at_)) return bad_number();
                if (mode_ == Mode::kRead) std::memcpy(values, at_, count);
                at_ += count, size_ -= count;
        }
    }
    bool take(std::size_t count)
    {
        if (failed()) return false;
        if (size_ < count) [[unlikely]]
            fail("the state ends too early");
        return size_ >= count;
    }
    [[gnu::cold]] void bad_number() { fail("a number of the state is not finite, or one that it cannot be"); }

    Mode mode_ = Mode::kMeasure;
    std::byte* at_ = nullptr;
    std::size_t size_ = 0;
    char text_[160] = {};
};

}  // namespace epode
