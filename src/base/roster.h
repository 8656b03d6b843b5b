// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Objects in the order in which they have joined, each of which knows its `place`; walked from the newest on.
// Who leaves makes a hole. Holes at the end go at once, the others when they are more than half: so joining
// and leaving cost nothing to speak of, touch nobody else, and never change the order. A list through the
// objects would need no memory of its own, but a walk along it waits for each object to learn where the next
// one is; here they are fetched ahead, kLines lines of the cache of each.
// Some members may be active, one bit each: a walk over those passes 64 others at a glance.
#pragma once

#include <bit>
#include <cstdint>

#include "base/ahead.h"
#include "base/array.h"

namespace epode {

template <typename T, int kLines>
class Roster {
  public:
    [[nodiscard]] bool join(T& one)  // false: no memory, nothing done
    {
        if (all_.size() >= 64 * bits_.size() && !bits_.push(0)) return false;
        if (!all_.push(&one)) return false;
        one.place = all_.size() - 1;
        ++count_;
        return true;
    }

    void leave(T& one)
    {
        deactivate(one);
        all_[one.place] = nullptr;
        one.place = -1;
        --count_;
        while (!all_.empty() && !all_.back()) all_.pop();
        if (all_.size() > 2 * count_ + kFew) close_up();
    }

    int count() const { return count_; }
    // Places are below this, and who joins later has none of them, until somebody leaves.
    int places() const { return all_.size(); }

    // Who joins is not active.
    void activate(T& one)
    {
        active_ += !is_active(one);
        word_of(one.place) |= bit_of(one.place);
    }
    void deactivate(T& one)
    {
        active_ -= is_active(one);
        word_of(one.place) &= ~bit_of(one.place);
    }
    bool is_active(const T& one) const { return bits_.data()[one.place >> 6] & bit_of(one.place); }
    int active_count() const { return active_; }

    T& newest() const { return *all_.data()[all_.size() - 1]; }  // of those that there are: not of none

    // f(one) for the active ones below `place`, the newest first. Nobody may join, leave or change activity
    // meanwhile.
    template <typename F>
    void for_each_active_before(int place, F&& f) const
    {
        Bits ahead(bits_.data(), place), at = ahead;
        for (int i = 0; i < kAhead; ++i) fetch_next(ahead);
        for (int i = at.next(); i >= 0; i = at.next()) {
            fetch_next(ahead);
            f(*all_.data()[i]);
        }
    }
    template <typename F>
    void for_each_active(F&& f) const
    {
        for_each_active_before(places(), f);
    }

    // Nobody may join or leave during a walk.
    class Walk {
      public:
        Walk(T* const* first, T* const* behind) : first_(first), behind_(behind)
        {
            for (T* const* one = behind; one != first && behind - one < kAhead;) fetch<kLines>(*--one);
            pass_holes();
        }
        Walk begin() const { return *this; }
        Walk end() const { return {first_, first_}; }
        bool operator!=(const Walk& other) const { return behind_ != other.behind_; }
        T& operator*() const { return *behind_[-1]; }
        Walk& operator++()
        {
            step();
            pass_holes();
            return *this;
        }

      private:
        void step()
        {
            --behind_;
            if (behind_ - first_ >= kAhead) fetch<kLines>(behind_[-kAhead]);
        }
        void pass_holes()
        {
            while (behind_ != first_ && !behind_[-1]) step();
        }
        T* const* first_;
        T* const* behind_;
    };
    Walk begin() const { return before(places()); }
    Walk end() const { return before(0); }
    Walk before(int place) const { return {all_.data(), all_.data() + place}; }

  private:
    static constexpr int kFew = 64, kAhead = 16;

    // The places below a limit whose bits are set, from the highest on.
    class Bits {
      public:
        Bits(const std::uint64_t* words, int limit) : words_(words), word_((limit + 63) / 64)
        {
            if (limit % 64) left_ = words_[--word_] & (bit_of(limit) - 1);
        }
        int next()  // -1: none
        {
            while (!left_) {
                if (word_ == 0) return -1;
                left_ = words_[--word_];
            }
            const int bit = 63 - std::countl_zero(left_);
            left_ &= ~bit_of(bit);
            return 64 * word_ + bit;
        }

      private:
        const std::uint64_t* words_;
        int word_;
        std::uint64_t left_ = 0;
    };

    static std::uint64_t bit_of(int place) { return std::uint64_t(1) << (place & 63); }
    std::uint64_t& word_of(int place) { return bits_.data()[place >> 6]; }
    void fetch_next(Bits& ahead) const
    {
        if (const int i = ahead.next(); i >= 0) fetch<kLines>(all_.data()[i]);
    }

    void close_up()
    {
        int place = 0;
        for (T* one : all_) {
            if (!one) continue;
            const bool active = is_active(*one);
            one->place = place;
            all_[place++] = one;
            // No bit that is read later has been written yet.
            word_of(one->place) &= ~bit_of(one->place);
            if (active) word_of(one->place) |= bit_of(one->place);
        }
        all_.truncate(place);
        forget_bits_behind(place);
    }

    // Places that nobody has are not active.
    void forget_bits_behind(int place)
    {
        if (place % 64) word_of(place) &= bit_of(place) - 1;
        for (int i = (place + 63) / 64; i < bits_.size(); ++i) bits_[i] = 0;
    }

    Array<T*> all_;
    Array<std::uint64_t> bits_;  // of places, 64 in a word
    int count_ = 0, active_ = 0;
};

}  // namespace epode
