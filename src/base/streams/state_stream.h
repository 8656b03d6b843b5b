// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Converts the state of a world to bytes and back (ode/state.h). Each part of the engine visits its own
// numbers, in one function for both directions, so that writing and reading cannot disagree:
//   kWrite    appends them to a block of bytes, which grows
//   kCheck    reads and checks, and stores nothing
//   kRead     reads, checks and stores
// A function that takes a value returns the value to use: the same one when a state is saved, the saved one
// when it is loaded. All sizes are multiples of four bytes. Numbers are little endian (base/streams/little_endian.h).
// The first fault is kept, in words; values read after it are 0.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <limits>

#include "base/check.h"
#include "base/streams/first_fault.h"
#include "base/streams/little_endian.h"
#include "base/streams/state_bytes.h"

namespace epode {

class StateStream : public FirstFault {
  public:
    static constexpr const char* kBadNumber = "a number of the state is not finite, or one that it cannot be";

    enum class Mode { kWrite, kCheck, kRead };

    // Appends to `out`. Whoever has written calls close().
    explicit StateStream(StateBytes& out)
        : out_(&out), at_(out.data + out.size), end_(out.data + out.capacity)
    {}
    // `checked`: the same bytes have been read with kCheck, for the same objects.
    StateStream(Mode mode, const std::byte* from, std::size_t size, bool checked = false)
        : mode_(mode), checked_(checked), at_(const_cast<std::byte*>(from)), end_(at_ + size)
    {}

    bool saves() const { return mode_ == Mode::kWrite; }
    bool stores() const { return mode_ == Mode::kRead; }
    bool is_checked() const { return checked_; }
    // With kRead after kCheck: stores what follows, in objects that nobody uses yet.
    void set_mode(Mode mode) { mode_ = mode; }
    Mode mode() const { return mode_; }
    // The version of the format that is read or written (state/state_header.h).
    int format() const { return format_; }
    void set_format(int format) { format_ = format; }

    // Bytes that are left to be read.
    std::size_t left() const { return std::size_t(end_ - at_); }
    const std::byte* at() const { return at_; }

    // While writing: how many bytes the block has, and bytes written so far, to be overwritten.
    std::size_t written() const { return std::size_t(at_ - out_->data); }
    std::byte* written_at(std::size_t place) { return out_->data + place; }
    // False: out of memory.
    [[nodiscard]] bool close()
    {
        if (failed()) return false;
        out_->size = written();
        return true;
    }

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
        numbers(values, count, [&](const std::byte* from) {
            bool good = true;
            for (int i = 0; i < count; ++i) {
                const Real x = get_little<Real>(from, std::size_t(i));
                good = good & within(x, infinite ? kInf : std::numeric_limits<Real>::max());
            }
            return good;
        });
    }
    // Starting values of solvers and keys of contacts: any bits, since steps contain bad results.
    void guesses(Real* values, int count)
    {
        numbers(values, count, [](const std::byte*) { return true; });
    }
    void floats(float* values, int count)
    {
        numbers(values, count, [](const std::byte*) { return true; });
    }

    // A run of bytes, padded to a multiple of four, which the caller writes or reads directly, before it writes
    // more. Null if too few bytes are left, or memory is exhausted.
    std::byte* block(std::size_t count)
    {
        const std::size_t whole = (count + 3) / 4 * 4;
        if (!take(whole)) return nullptr;
        std::byte* const begin = at_;
        at_ += whole;
        if (saves() && whole != count) std::memset(begin + count, 0, whole - count);
        return begin;
    }
    // Writes no more than `count` bytes of a block: the others are taken back.
    void end_block(std::byte* end) { at_ = end; }

    struct Number {
        Real* value;
        Real usual;
        bool infinite = false;  // is allowed
        Real least = -kInf;
        bool computed = false;  // by steps, which may go beyond what a program may set
    };
    // What steps have computed: any finite number, or infinite ones as well.
    static Number computed(Real& value, Real usual, bool infinite = false)
    {
        return {&value, usual, infinite, -kInf, true};
    }
    // At most 16 numbers that have their usual value in most objects, and 16 bits, which are returned as
    // saved: only unusual numbers take space.
    std::uint32_t unusual(std::initializer_list<Number> numbers, std::uint32_t bits = 0);

    // While it lives, what is checked is stored, too: the values are copies, to be judged as a whole.
    class IntoCopies {
      public:
        explicit IntoCopies(StateStream& stream) : stream_(stream), mode_(stream.mode_)
        {
            if (!stream.saves()) stream.mode_ = Mode::kRead;
        }
        ~IntoCopies() { stream_.mode_ = mode_; }
        IntoCopies(const IntoCopies&) = delete;
        IntoCopies& operator=(const IntoCopies&) = delete;

      private:
        StateStream& stream_;
        const Mode mode_;
    };

  private:
    void number(const Number& n);
    template <typename T>
    T whole(T value)
    {
        if (!take(sizeof value)) return saves() ? value : T(0);
        if (saves())
            copy_little<sizeof value>(at_, &value, 1);
        else
            value = get_little<T>(at_);
        at_ += sizeof value;
        return value;
    }
    template <typename T, typename Judge>
    void numbers(T* values, int count, Judge&& judge)
    {
        const std::size_t size = sizeof(T) * std::size_t(count);
        if (!take(size)) return;
        if (saves()) {
            copy_little<sizeof(T)>(at_, values, std::size_t(count));
        } else {
            if (!checked_ && !judge(at_)) return bad_number();
            if (mode_ == Mode::kRead) copy_little<sizeof(T)>(values, at_, std::size_t(count));
        }
        at_ += size;
    }
    // So many bytes are there, to be read or written.
    bool take(std::size_t count)
    {
        if (failed()) return false;
        return std::size_t(end_ - at_) >= count || (saves() ? grow(count) : ends_too_early());
    }
    // Rare, but not gnu::cold: GCC 12 then takes what is read and written after it for cold.
    [[gnu::noinline]] bool grow(std::size_t count);
    [[gnu::noinline]] bool ends_too_early()
    {
        fail("the state ends too early");
        return false;
    }
    [[gnu::noinline]] void bad_number() { fail("%s", kBadNumber); }

    Mode mode_ = Mode::kWrite;
    bool checked_ = false;
    int format_ = 0;
    StateBytes* out_ = nullptr;
    std::byte *at_, *end_;
};

}  // namespace epode
