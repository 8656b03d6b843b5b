// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Contacts of crossing triangles, found by a number for each side: chained hashing. Each contact is put under the
// numbers of whatever may ask for it, and asked for by one of them. Where a mesh of large triangles lies on a field of
// tiny cells there are a hundred thousand contacts, and comparing each with each took minutes.
#pragma once

#include <algorithm>
#include <bit>

#include "base/array.h"
#include "base/hash.h"

namespace epode {

class CrossingTable {
  public:
    // For so many entries. False: out of memory.
    [[nodiscard]] bool reserve(int entries)
    {
        entries_.clear();
        if (!entries_.reserve(entries) || !heads_.resize(int(std::bit_ceil(unsigned(entries))))) return false;
        std::fill(heads_.begin(), heads_.end(), kEnd);
        return true;
    }
    // No more than were reserved.
    void put(std::uint64_t a, std::uint64_t b, int contact)
    {
        int& head = head_of(a, b);
        (void)entries_.push({a, b, contact, head});
        head = entries_.size() - 1;
    }
    // Is there one under these numbers that `look` says true of?
    template <typename Look>
    bool any(std::uint64_t a, std::uint64_t b, const Look& look)
    {
        for (int i = head_of(a, b); i != kEnd; i = entries_[i].next)
            if (const Entry& e = entries_[i]; e.a == a && e.b == b && look(e.contact)) return true;
        return false;
    }

  private:
    static constexpr int kEnd = -1;
    struct Entry {
        std::uint64_t a, b;
        int contact, next;
    };
    int& head_of(std::uint64_t a, std::uint64_t b)
    {
        return heads_[int(hash_of(a, b) & std::size_t(heads_.size() - 1))];
    }

    Array<Entry> entries_;
    Array<int> heads_;  // a power of two
};

}  // namespace epode
