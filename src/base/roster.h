// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Objects in the order in which they have joined, each of which knows its `place`; walked from the newest on.
// Who leaves makes a hole. Holes at the end go at once, the others when they are more than half: so joining
// and leaving cost nothing to speak of, touch nobody else, and never change the order. A list through the
// objects would need no memory of its own, but a walk along it waits for each object to learn where the next
// one is; here they are fetched ahead, kLines lines of the cache of each.
#pragma once

#include "base/ahead.h"
#include "base/array.h"

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
        all_[one.place] = nullptr;
        one.place = -1;
        --count_;
        while (!all_.empty() && !all_.back()) all_.pop();
        if (all_.size() > 2 * count_ + kFew) close_up();
    }

    int count() const { return count_; }
    // Places are below this, and who joins later has none of them, until somebody leaves.
    int places() const { return all_.size(); }

    T& newest() const { return *all_.data()[all_.size() - 1]; }  // of those that there are: not of none

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

    void close_up()
    {
        int place = 0;
        for (T* one : all_) {
            if (!one) continue;
            one->place = place;
            all_[place++] = one;
        }
        all_.truncate(place);
    }

    Array<T*> all_;
    int count_ = 0;
};

}  // namespace epode
