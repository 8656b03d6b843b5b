// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Numbers of objects, found by address: a hash table with linear probing, at most half full. It is searched
// and never walked through, so addresses decide about no order.
#pragma once

#include <bit>

#include "base/array.h"
#include "base/hash.h"

namespace epode {

class PointerNumbers {
  public:
    // Not negative, or -1: it has none.
    int find(const void* object) const
    {
        if (slots_.empty()) return -1;
        for (std::size_t i = start(object);; i = (i + 1) & mask()) {
            const Slot& slot = slots_.data()[i];
            if (!slot.object) return -1;
            if (slot.object == object) return slot.number;
        }
    }

    // For an object that has no number yet. False: out of memory.
    [[nodiscard]] bool add(const void* object, int number)
    {
        if (2 * (count_ + 1) > slots_.size() && !grow()) return false;
        put({object, number});
        ++count_;
        return true;
    }

    void clear() { slots_.clear(), count_ = 0; }

  private:
    struct Slot {
        const void* object;
        int number;
    };

    std::size_t mask() const { return std::size_t(slots_.size() - 1); }
    std::size_t start(const void* object) const
    {
        return hash_of(0, std::uint64_t(reinterpret_cast<std::uintptr_t>(object))) & mask();
    }
    void put(const Slot& slot)
    {
        std::size_t i = start(slot.object);
        while (slots_.data()[i].object) i = (i + 1) & mask();
        slots_.data()[i] = slot;
    }
    bool grow()
    {
        Array<Slot> old;
        if (!old.resize(slots_.empty() ? 64 : 2 * slots_.size())) return false;
        old.swap(slots_);
        for (const Slot& slot : old)
            if (slot.object) put(slot);
        return true;
    }

    Array<Slot> slots_;
    int count_ = 0;
};

}  // namespace epode
