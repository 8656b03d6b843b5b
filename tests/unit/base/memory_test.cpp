// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Memory hooks, and the containers over them, when memory is there and when it is not.
#include "base/memory.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <map>

#include "base/arena.h"
#include "base/array.h"
#include "base/objects/handle.h"
#include "base/objects/pool.h"

namespace epode {
namespace {

// Hooks that keep books: every free must name the size that was asked for.
class Books {
  public:
    Books()
    {
        open().clear();
        mismatches() = 0;
        allowed() = 1000000;
        memory_hooks() = {&take, nullptr, &give};
    }
    ~Books() { memory_hooks() = {}; }
    static std::map<void*, std::size_t>& open()
    {
        static std::map<void*, std::size_t> all;
        return all;
    }
    static int& mismatches()
    {
        static int count;
        return count;
    }
    static int& allowed()  // allocations until memory is exhausted
    {
        static int count;
        return count;
    }

  private:
    static void* take(std::size_t size)
    {
        if (allowed()-- <= 0) return nullptr;
        void* p = std::malloc(size);
        open()[p] = size;
        return p;
    }
    static void give(void* p, std::size_t size)
    {
        const auto found = open().find(p);
        if (found == open().end() || found->second != size) ++mismatches();
        if (found != open().end()) open().erase(found);
        std::free(p);
    }
};

TEST(Memory, blocks_are_aligned_and_freed_with_the_size_that_was_asked_for)
{
    Books books;
    for (std::size_t size : {1u, 63u, 64u, 65u, 1000u, 100000u}) {
        void* p = allocate(size);
        ASSERT_NE(p, nullptr);
        EXPECT_EQ(reinterpret_cast<std::uintptr_t>(p) % kCacheLine, 0u);
        std::memset(p, 0xab, size);
        release(p, size);
    }
    EXPECT_TRUE(Books::open().empty());
    EXPECT_EQ(Books::mismatches(), 0);
}

TEST(Memory, an_impossible_size_is_refused_before_it_overflows)
{
    EXPECT_EQ(allocate(SIZE_MAX), nullptr);
    EXPECT_EQ(allocate(SIZE_MAX - 8), nullptr);
    release(nullptr, 5);
}

TEST(Memory, allocations_are_counted)
{
    const std::size_t before = allocation_count();
    void* p = allocate(10);
    EXPECT_EQ(allocation_count(), before + 1);
    release(p, 10);
    EXPECT_EQ(allocation_count(), before + 1);
}

TEST(Array, grows_keeps_its_elements_and_gives_everything_back)
{
    Books books;
    {
        Array<int> a;
        for (int i = 0; i < 1000; ++i) ASSERT_TRUE(a.push(i));
        ASSERT_TRUE(a.push(a[3]));  // an element of itself, also when the block moves
        for (int i = 0; i < 1000; ++i) EXPECT_EQ(a[i], i);
        EXPECT_EQ(a.back(), 3);
        ASSERT_TRUE(a.resize(1200));
        EXPECT_EQ(a[1199], 0);
        a.remove_swap(0);
        EXPECT_EQ(a.size(), 1199);
        Array<int> b = std::move(a);
        EXPECT_EQ(b.size(), 1199);
        EXPECT_EQ(a.size(), 0);
    }
    EXPECT_TRUE(Books::open().empty());
    EXPECT_EQ(Books::mismatches(), 0);
}

TEST(Array, stays_as_it_is_when_memory_is_exhausted)
{
    Books books;
    Array<int> a;
    for (int i = 0; i < 8; ++i) ASSERT_TRUE(a.push(i));
    Books::allowed() = 0;
    EXPECT_FALSE(a.push(8));
    EXPECT_FALSE(a.resize(100));
    EXPECT_EQ(a.size(), 8);
    for (int i = 0; i < 8; ++i) EXPECT_EQ(a[i], i);
}

TEST(Arena, a_second_round_of_the_same_size_allocates_nothing)
{
    Books books;
    {
        Arena arena;
        const auto round = [&arena] {
            for (int i = 1; i < 40; ++i) {
                auto s = arena.take<double>(i * 500);
                ASSERT_EQ(int(s.size()), i * 500);
                EXPECT_EQ(reinterpret_cast<std::uintptr_t>(s.data()) % kCacheLine, 0u);
                for (double& x : s) x = i;
            }
        };
        round();
        arena.reset();
        const std::size_t warm = allocation_count();
        for (int k = 0; k < 3; ++k) {
            round();
            arena.reset();
        }
        EXPECT_EQ(allocation_count(), warm);
    }
    EXPECT_TRUE(Books::open().empty());
    EXPECT_EQ(Books::mismatches(), 0);
}

TEST(Arena, a_scope_gives_back_what_was_taken_inside_it)
{
    Arena arena;
    auto outer = arena.take<int>(10);
    for (int& x : outer) x = 7;
    void* inside;
    {
        Arena::Scope scope(arena);
        inside = arena.take<int>(10).data();
        for (int k = 0; k < 20; ++k) ASSERT_FALSE(arena.take<double>(20000).empty());
    }
    EXPECT_EQ(arena.take<int>(10).data(), inside);
    for (int x : outer) EXPECT_EQ(x, 7);
    for (int x : arena.take_zeroed<int>(1000)) EXPECT_EQ(x, 0);
}

TEST(Arena, reports_exhausted_memory_until_the_next_reset)
{
    Books books;
    Arena arena;
    Books::allowed() = 1;
    ASSERT_FALSE(arena.take<char>(100).empty());
    EXPECT_TRUE(arena.take<char>(1 << 20).empty());
    EXPECT_TRUE(arena.failed());
    Books::allowed() = 100;
    arena.reset();
    EXPECT_FALSE(arena.failed());
    EXPECT_FALSE(arena.take<char>(1 << 20).empty());
}

TEST(Arena, nothing_is_taken_for_no_or_negative_counts)
{
    Arena arena;
    EXPECT_TRUE(arena.take<int>(0).empty());
    EXPECT_TRUE(arena.take<int>(-3).empty());
    EXPECT_FALSE(arena.failed());
}

struct Item : Tagged {
    explicit Item(int v) : Tagged(Tag::kBody), value(v) {}
    int value;
};

}  // namespace

template <>
struct HandleOf<Item> {
    using Id = struct dxItem*;
    static constexpr Tag kTag = Tag::kBody;
};

namespace {

TEST(Pool, objects_are_aligned_distinct_and_recognised_as_dead_afterwards)
{
    Books books;
    Item* all[200];
    for (int i = 0; i < 200; ++i) {
        all[i] = Pool<Item>::create(i);
        ASSERT_NE(all[i], nullptr);
        EXPECT_EQ(reinterpret_cast<std::uintptr_t>(all[i]) % kCacheLine, 0u);
    }
    for (int i = 0; i < 200; ++i) EXPECT_EQ(all[i]->value, i);
    Pool<Item>::destroy(all[10]);
    EXPECT_EQ(all[10]->tag, Tag::kDead);
    EXPECT_EQ(all[11]->tag, Tag::kBody);
    EXPECT_EQ(Pool<Item>::create(5), all[10]) << "the slot given last is taken first";
    Pool<Item>::slots().trim();
    EXPECT_EQ(all[3]->value, 3) << "trim leaves a pool alone while an object lives";
    for (Item* t : all) Pool<Item>::destroy(t);
    EXPECT_EQ(Pool<Item>::slots().live(), 0u);
    Pool<Item>::slots().trim();
    EXPECT_TRUE(Books::open().empty());
    EXPECT_EQ(Books::mismatches(), 0);
}

HandleOf<Item>::Id handle_of(const Item* item) { return to_handle(item); }

TEST(Pool, a_stale_handle_is_recognised_until_its_slot_has_had_64_more_objects)
{
    Item* item = Pool<Item>::create(0);
    const auto stale = handle_of(item);
    EXPECT_EQ(from_handle<Item>(stale), item);
    for (int k = 1; k < 64; ++k) {
        Pool<Item>::destroy(item);
        EXPECT_EQ(from_handle<Item>(stale), nullptr);
        ASSERT_EQ(Pool<Item>::create(k), item) << "the same slot";
        EXPECT_EQ(from_handle<Item>(stale), nullptr) << "object " << k;
        EXPECT_EQ(from_handle<Item>(handle_of(item)), item);
    }
    Pool<Item>::destroy(item);
    EXPECT_EQ(from_handle<Item>(nullptr), nullptr);
    EXPECT_EQ(handle_of(nullptr), nullptr);
}

TEST(Pool, what_the_program_s_handlers_gave_goes_with_the_last_close_and_the_rest_stays)
{
    Pool<Item>::slots().trim();
    Item* ours = Pool<Item>::create(1);
    Books books;
    Books::allowed() = 10;
    Item* others[70];
    for (Item*& t : others) t = Pool<Item>::create(2);
    EXPECT_FALSE(Books::open().empty());
    SlotPool::trim_all(false);
    EXPECT_FALSE(Books::open().empty()) << "objects live";
    for (Item* t : others) Pool<Item>::destroy(t);
    Pool<Item>::destroy(ours);
    SlotPool::trim_all(false);
    EXPECT_TRUE(Books::open().empty());
    EXPECT_EQ(ours->tag, Tag::kDead) << "still readable";
    EXPECT_EQ(Pool<Item>::create(3), ours);
    Pool<Item>::destroy(ours);
}

TEST(Pool, answers_null_when_memory_is_exhausted_and_recovers)
{
    Pool<Item>::slots().trim();  // no slot is left that the tests before have had
    Books books;
    Books::allowed() = 0;
    EXPECT_EQ(Pool<Item>::create(1), nullptr);
    Books::allowed() = 10;
    Item* t = Pool<Item>::create(1);
    ASSERT_NE(t, nullptr);
    Pool<Item>::destroy(t);
    Pool<Item>::slots().trim();
}

}  // namespace
}  // namespace epode
