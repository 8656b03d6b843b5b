// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Converts the state of a world to bytes and back (ode/state.h). Each part of the engine visits its own
// numbers, in one function for both directions, so that writing and reading cannot disagree:
//   kMeasure  counts the bytes that kWrite would write
//   kWrite    writes them to a buffer of the measured size
//   kCheck    reads and checks, and stores nothing
//   kRead     reads, checks and stores
// A function that takes a value returns the value to use: the same one when a state is saved, the saved one
// when it is loaded. All sizes are multiples of four bytes. Numbers have the layout of memory, little endian.
// The first fault is kept, in words; values read after it are 0.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <limits>

#include "base/check.h"
#include "base/streams/first_fault.h"

namespace epode {

static_assert(std::endian::native == std::endian::little, "states are little endian");

class StateStream : public FirstFault {
  public:
    enum class Mode { kMeasure, kWrite, kCheck, kRead };

    StateStream() = default;  // measures
    // Writes to `to`, whose capacity must be the measured size.
    explicit StateStream(std::byte* to) : mode_(Mode::kWrite), at_(to) {}
    // `checked`: the same bytes have been read with kCheck, for the same objects.
    StateStream(Mode mode, const std::byte* from, std::size_t size, bool checked = false)
        : mode_(mode), checked_(checked), at_(const_cast<std::byte*>(from)), size_(size)
    {}

    bool measures() const { return mode_ == Mode::kMeasure; }
    bool saves() const { return mode_ <= Mode::kWrite; }
    bool stores() const { return mode_ == Mode::kRead; }
    bool is_checked() const { return checked_; }
    // With kRead after kCheck: stores what follows, in objects that nobody uses yet.
    void set_mode(Mode mode) { mode_ = mode; }
    Mode mode() const { return mode_; }

    // Bytes counted, or left to be read.
    std::size_t size() const { return size_; }
    const std::byte* at() const { return at_; }

    std::uint32_t word(std::uint32_t value) { return whole(value); }
    std::uint64_t long_word(std::uint64_t value) { return whole(value); }
    // Must be less than `end`.
    std::uint32_t index(std::uint32_t value, std::uint32_t end, const char* text)
    {
        value = word(value);
        return saves() || demand(value < end, text) ? value : 0;
    }

    // Finite, or with `infinite` any but NaN. Bodies may fly farther than a program may place them.
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
    // Starting values of solvers and keys of contacts: any bits, since steps contain bad results.
    void guesses(Real* values, int count)
    {
        bytes(values, sizeof(Real) * std::size_t(count), [](const std::byte*) { return true; });
    }
    void floats(float* values, int count)
    {
        bytes(values, sizeof(float) * std::size_t(count), [](const std::byte*) { return true; });
    }

    // A run of bytes, padded to a multiple of four, which the caller writes or reads directly. Null if too
    // few bytes are left, or while measuring.
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
        bool infinite = false;  // is allowed
        Real least = -kInf;
    };
    // At most 16 numbers that have their usual value in most objects, and 16 bits, which are returned as
    // saved: only unusual numbers take space.
    std::uint32_t unusual(std::initializer_list<Number> numbers, std::uint32_t bits = 0);

  private:
    void number(const Number& n);
    template <typename T>
    T whole(T value)
    {
        if (saves()) {
            bytes(&value, sizeof value, [](const std::byte*) { return true; });
            return value;
        }
        if (!take(sizeof value)) return T(0);
        std::memcpy(&value, at_, sizeof value);
        at_ += sizeof value, size_ -= sizeof value;
        return value;
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
                if (!checked_ && !judge(at_)) return bad_number();
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
    bool checked_ = false;
    std::byte* at_ = nullptr;
    std::size_t size_ = 0;
};

}  // namespace epode
