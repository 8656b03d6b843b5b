// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Memory for one step: bump allocation, and scopes that return what was taken inside them. Once the arena has
// seen its largest step it allocates nothing. While it is too small it chains further blocks; `reset` then
// replaces them by one block of the size that was needed plus the reserve of its supply. A request that
// cannot be met returns an empty span and sets `failed`; the step then refuses to run and changes nothing.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <type_traits>

#include "base/config.h"
#include "base/memory.h"
#include "base/poison.h"

namespace epode {

// Where an arena's blocks come from, and how large they are.
struct ArenaSupply {
    dAllocFunction* alloc = nullptr;  // both null: the library's own memory
    dFreeFunction* free = nullptr;
    double factor = 1.2;              // a replacing block has this times the size needed
    std::size_t minimum = 64 * 1024;  // no block is smaller than this, bytes
};

struct ArenaBlock {
    ArenaBlock* next;
    std::size_t size;     // bytes behind the header
    dFreeFunction* free;  // the function that matches the allocator of this block; null: the library's
};

class Arena {
  public:
    Arena() = default;
    Arena(const Arena&) = delete;
    Arena& operator=(const Arena&) = delete;
    ~Arena() { free_all(); }

    // `count` uninitialised objects, cache-line aligned.
    template <typename T>
    [[nodiscard]] std::span<T> take(int count)
    {
        static_assert(std::is_trivially_destructible_v<T>);
        if (count <= 0) return {};
        void* p = take_bytes(sizeof(T) * std::size_t(count));
        if (!p) return {};
        return {static_cast<T*>(p), std::size_t(count)};
    }

    // The same, every byte zero.
    template <typename T>
    [[nodiscard]] std::span<T> take_zeroed(int count)
    {
        auto s = take<T>(count);
        if (!s.empty()) __builtin_memset(static_cast<void*>(s.data()), 0, s.size_bytes());
        return s;
    }

    bool failed() const { return failed_; }

    // Forgets everything taken; merges chained blocks into one.
    void reset()
    {
        note_high_water();
        if (first_ && first_->next) {
            free_all();
            // Failing to allocate the reserve is not an error.
            if (!add_block(reserve())) (void)add_block(high_water_);
        }
        poison_since(first_, 0);
        current_ = first_;
        used_ = 0;
        total_ = 0;
        failed_ = false;
    }

    // Allocates the first block early, if there is memory for it.
    void open()
    {
        if (!first_) (void)add_block(std::max(supply_.minimum, kCacheLine));
    }

    // Takes effect with the next block.
    void set_supply(const ArenaSupply& supply) { supply_ = supply; }

    // Frees all blocks; the next step starts from nothing.
    void free_blocks()
    {
        free_all();
        used_ = total_ = high_water_ = 0;
        failed_ = false;
    }

    // Everything taken during the lifetime of a Scope is returned at its end.
    class Scope {
      public:
        explicit Scope(Arena& arena)
            : arena_(arena), block_(arena.current_), used_(arena.used_), total_(arena.total_)
        {}
        Scope(const Scope&) = delete;
        Scope& operator=(const Scope&) = delete;
        ~Scope()
        {
            arena_.note_high_water();
            // Blocks chained inside the scope stay for reuse by the rest of the step.
            arena_.poison_since(block_ ? block_ : arena_.first_, used_);
            arena_.current_ = block_ ? block_ : arena_.first_;
            arena_.used_ = used_;
            arena_.total_ = total_;
        }

      private:
        Arena& arena_;
        ArenaBlock* block_;
        std::size_t used_, total_;
    };

  private:
    friend class Scope;
    void* take_bytes(std::size_t bytes)
    {
        const std::size_t size = (bytes + kCacheLine - 1) & ~(kCacheLine - 1);
        if (!current_ || used_ + size > current_->size) [[unlikely]] {
            if (!advance(size)) {
                failed_ = true;
                return nullptr;
            }
        }
        void* p = memory_of(current_) + used_;
        unpoison(p, bytes);
        used_ += size;
        total_ += size;
        return p;
    }

    // Continues in a block with space for `size`, an existing one if possible.
    bool advance(std::size_t size)
    {
        while (current_ && current_->next) {
            current_ = current_->next;
            used_ = 0;
            if (size <= current_->size) return true;
        }
        return add_block(std::max(size, std::max(supply_.minimum, total_)));
    }

    // Before `total_` becomes less.
    void note_high_water() { high_water_ = std::max(high_water_, total_); }

    std::size_t reserve() const
    {
        const double wanted = double(high_water_) * supply_.factor;
        const std::size_t bytes = wanted < 1e15 ? std::size_t(wanted) : high_water_;
        return std::max((bytes + kCacheLine - 1) & ~(kCacheLine - 1), supply_.minimum);
    }

    bool add_block(std::size_t size);
    void free_all();
    void poison_since(ArenaBlock* block, std::size_t used);
    static char* memory_of(ArenaBlock* block) { return reinterpret_cast<char*>(block) + kHeader; }

    static constexpr std::size_t kHeader = kCacheLine;
    ArenaBlock* first_ = nullptr;
    ArenaBlock* current_ = nullptr;
    std::size_t used_ = 0;        // bytes of the current block
    std::size_t total_ = 0;       // bytes taken now
    std::size_t high_water_ = 0;  // most bytes ever taken at once
    bool failed_ = false;
    ArenaSupply supply_;
};

// Marks everything taken since `used` bytes of `block` as unused.
inline void Arena::poison_since(ArenaBlock* block, std::size_t used)
{
    for (ArenaBlock* b = block; b; b = b->next) {
        const std::size_t from = b == block ? used : 0, to = b == current_ ? used_ : b->size;
        if (to > from) poison(memory_of(b) + from, to - from);
        if (b == current_) return;
    }
}

}  // namespace epode
