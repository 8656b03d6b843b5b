// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Objects in the order in which they joined. Each knows its `place`, and walks go from the newest to the
// oldest. An object that leaves makes a hole. Holes at the end disappear at once, the others when they are
// more than half of all places; so joining and leaving cost almost nothing, touch no other object and keep
// the order. A linked list through the objects would need no memory of its own, but a walk along it waits for
// each object to learn where the next one is. Here a walk prefetches kLines cache lines of each object.
// Members may be active, one bit each: a walk over active members skips 64 others at a time.
#pragma once

#include <bit>
#include <cstdint>

#include "base/array.h"
#include "base/prefetch.h"

namespace epode {

template <typename T, int kLines>
class Roster {
  public:
    [[nodiscard]] bool join(T& one)  // false: no memory, nothing done
    {
        if (!all_.push(&one)) return false;
        one.place = all_.size() - 1;
        ++count_;
        return true;
    }

    void leave(T& one)
    {
        if (idle_count_ > 0) [[unlikely]]
            clear_bit(one);
        all_[one.place] = nullptr;
        one.place = -1;
        --count_;
        while (!all_.empty() && !all_.back()) all_.pop();
        if (all_.size() > 2 * count_ + kFew) close_up();
    }

    int count() const { return count_; }
    // All places are below this number, and objects that join later get none of them until some object
    // leaves.
    int places() const { return all_.size(); }

    // Objects are active when they join.
    void activate(T& one)
    {
        if (idle_count_ > 0) [[unlikely]]
            clear_bit(one);
    }
    void deactivate(T& one)  // has no effect without memory
    {
        if (!is_active(one) || !has_bit(one.place)) return;
        ++idle_count_;
        word_of(one.place) |= bit_of(one.place);
    }
    bool is_active(const T& one) const
    {
        return idle_count_ == 0 || !(idle_word(one.place >> 6) & bit_of(one.place));
    }
    int active_count() const { return count_ - idle_count_; }

    T& newest() const { return *all_.data()[all_.size() - 1]; }  // must not be empty

    // Calls f(one) for the active members below `place`, the newest first. No member may join, leave or
    // become active meanwhile.
    template <typename F>
    void for_each_active_before(int place, F&& f) const
    {
        if (idle_count_ == 0) {
            for (T& one : before(place)) f(one);
            return;
        }
        Active at(*this, place), ahead = at;
        for (int i = 0; i < kAhead; ++i) ahead.prefetch_next();
        while (T* one = at.next()) {
            ahead.prefetch_next();
            f(*one);
        }
    }
    template <typename F>
    void for_each_active(F&& f) const
    {
        for_each_active_before(places(), f);
    }

    // No member may join or leave during a walk.
    class Walk {
      public:
        Walk(T* const* first, T* const* behind) : first_(first), behind_(behind)
        {
            for (T* const* one = behind; one != first && behind - one < kAhead;) prefetch<kLines>(*--one);
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
            if (behind_ - first_ >= kAhead) prefetch<kLines>(behind_[-kAhead]);
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

    // A walk over the active ones alone.
    class Active {
      public:
        Active(const Roster& in, int limit) : in_(in), word_((limit + 63) / 64)
        {
            if (limit % 64) left_ = ~in.idle_word(--word_) & (bit_of(limit) - 1);
        }
        T* next()  // null: that was all
        {
            while (left_ || word_ > 0) {
                if (!left_) {
                    left_ = ~in_.idle_word(--word_);
                    continue;
                }
                const int bit = 63 - std::countl_zero(left_);
                left_ &= ~bit_of(bit);
                if (T* one = in_.all_.data()[64 * word_ + bit]) return one;
            }
            return nullptr;
        }
        void prefetch_next()
        {
            if (const T* one = next()) prefetch<kLines>(one);
        }

      private:
        const Roster& in_;
        int word_;
        std::uint64_t left_ = 0;
    };

    static std::uint64_t bit_of(int place) { return std::uint64_t(1) << (place & 63); }
    // Kept out of line: members join and leave by the thousand.
    [[gnu::noinline]] void clear_bit(const T& one)
    {
        if (is_active(one)) return;
        --idle_count_;
        word_of(one.place) &= ~bit_of(one.place);
    }
    bool has_bit(int place) { return place < 64 * idle_.size() || idle_.resize((all_.capacity() + 63) / 64); }
    std::uint64_t idle_word(int i) const { return i < idle_.size() ? idle_.data()[i] : 0; }
    std::uint64_t& word_of(int place) { return idle_.data()[place >> 6]; }

    void close_up()
    {
        int place = 0;
        for (T* one : all_) {
            if (!one) continue;
            const bool idle = !is_active(*one);
            activate(*one);
            one->place = place;
            all_[place++] = one;
            if (idle) deactivate(*one);
        }
        all_.truncate(place);
    }

    Array<T*> all_;
    Array<std::uint64_t> idle_;  // bits of places, 64 in a word: taken, and not active; 0 behind the end
    int count_ = 0, idle_count_ = 0;
};

}  // namespace epode
