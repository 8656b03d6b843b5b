// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// dTestDataStructures: the containers that the library stands on, each against the plainest thing that could
// do its work (a C array, a list of all boxes), on a few thousand random operations. For programs that want
// to check an installed library; the tests of the project go further.
#include <algorithm>
#include <cstdio>
#include <cstring>

#include "base/arena.h"
#include "base/array.h"
#include "base/objects/pool.h"
#include "base/random.h"
#include "bvh/dynamic_tree.h"
#include "ode/misc.h"

using namespace epode;

namespace {

bool same(const Array<int>& a, const int* model, int size)
{
    return a.size() == size &&
           (size == 0 || std::memcmp(a.data(), model, sizeof(int) * std::size_t(size)) == 0);
}

bool check_array()
{
    constexpr int kMaxSize = 300;
    int model[kMaxSize], size = 0;
    Array<int> array;
    CounterRandom random(1);
    for (int turn = 0; turn < 4000; ++turn) {
        const int value = random.below(1000), what = random.below(8);
        if (what < 4 && size < kMaxSize) {
            if (!array.push(value)) return false;
            model[size++] = value;
        } else if (what < 6 && size > 0) {
            const int i = random.below(size);
            array.remove_swap(i);
            model[i] = model[--size];
        } else if (what == 6 && size > 0) {
            array.pop();
            --size;
        } else if (value < 50) {
            const int wanted = random.below(kMaxSize);
            if (!array.resize(wanted)) return false;
            for (; size < wanted; ++size) model[size] = 0;
            size = wanted;
        }
        if (!same(array, model, size)) return false;
    }
    return true;
}

// Three nested scopes; what was taken before one must outlive it.
bool fill_arena(Arena& arena, CounterRandom& random, int depth)
{
    const int count = 1 + random.below(5000);
    const auto mine = arena.take<int>(count);
    const auto zeros = arena.take_zeroed<int>(count);
    if (int(mine.size()) != count || int(zeros.size()) != count) return false;
    if (reinterpret_cast<std::uintptr_t>(mine.data()) % kCacheLine != 0) return false;
    for (int& x : mine) x = count + depth;
    for (int i = 0; i < 3 && depth > 0; ++i) {
        const Arena::Scope scope(arena);
        if (!fill_arena(arena, random, depth - 1)) return false;
    }
    for (int x : mine)
        if (x != count + depth) return false;
    for (int x : zeros)
        if (x != 0) return false;
    return true;
}

[[gnu::cold]] bool check_arena()
{
    Arena arena;
    for (int turn = 0; turn < 3; ++turn) {
        CounterRandom random(2);
        if (!fill_arena(arena, random, 3)) return false;
        arena.reset();
    }
    return !arena.failed();
}

struct Probe : Tagged {
    explicit Probe(int n) : Tagged(Tag::kBody) { std::fill_n(numbers, kNumbers, n); }
    static constexpr int kNumbers = 30;
    int numbers[kNumbers];
};

bool keeps(const Probe& probe, int n)
{
    return probe.tag == Tag::kBody &&
           std::count(probe.numbers, probe.numbers + Probe::kNumbers, n) == Probe::kNumbers;
}

// Objects come and go in random order; those alive keep their contents, the dead are marked as such.
bool check_pool()
{
    constexpr int kCount = 200;
    Probe* probes[kCount] = {};
    CounterRandom random(4);
    bool good = true;
    for (int turn = 0; turn < 3000 && good; ++turn) {
        const int i = random.below(kCount);
        Probe*& probe = probes[i];
        if (!probe) {
            probe = Pool<Probe>::create(i);
            good = probe && reinterpret_cast<std::uintptr_t>(probe) % kCacheLine == 0;
        } else {
            good = keeps(*probe, i);
            const Probe* const dead = probe;
            Pool<Probe>::destroy(probe);
            good = good && dead->tag == Tag::kDead;
            probe = nullptr;
        }
    }
    for (int i = 0; i < kCount; ++i) {
        if (!probes[i]) continue;
        good = good && keeps(*probes[i], i);
        Pool<Probe>::destroy(probes[i]);
    }
    Pool<Probe>::slots().trim();
    return good;
}

Aabb random_box(CounterRandom& random)
{
    Aabb box;
    for (int i = 0; i < 3; ++i) {
        box.lo.set(i, Real(random.below(1000)));
        box.hi.set(i, box.lo[i] + Real(random.below(200)));
    }
    return box;
}

struct Boxes {
    static constexpr int kCount = 150;
    DynamicTree tree;
    Aabb box[kCount];
    int leaf[kCount];

    bool answers(const Aabb& asked) const
    {
        int found[kCount] = {};
        tree.query(asked, [&found](int item) { ++found[item]; });
        for (int i = 0; i < kCount; ++i)
            if (found[i] != (leaf[i] >= 0 && overlap(box[i], asked) ? 1 : 0)) return false;
        return true;
    }
};

bool check_tree()
{
    Boxes boxes;
    CounterRandom random(3);
    for (int i = 0; i < Boxes::kCount; ++i) boxes.leaf[i] = -1;
    for (int turn = 0; turn < 1500; ++turn) {
        const int i = random.below(Boxes::kCount);
        int& leaf = boxes.leaf[i];
        if (leaf < 0) {
            boxes.box[i] = random_box(random);
            leaf = boxes.tree.insert(boxes.box[i], i);
            if (leaf < 0) return false;
        } else if (random.below(3) == 0) {
            boxes.tree.remove(leaf);
            leaf = -1;
        } else {
            boxes.box[i] = random_box(random);
            boxes.tree.move(leaf, boxes.box[i]);
        }
        if (!boxes.tree.sound() && !boxes.tree.rebuild()) return false;
        if (!boxes.answers(random_box(random))) return false;
    }
    return true;
}

}  // namespace

extern "C" void dTestDataStructures(void)
{
    static constexpr struct {
        const char* name;
        bool (*check)();
    } kTests[] = {{"array", check_array}, {"arena", check_arena}, {"pool", check_pool}, {"tree", check_tree}};
    std::printf("dTestDataStructures()\n");
    for (const auto& test : kTests) std::printf("%s: %s\n", test.name, test.check() ? "passed" : "FAILED");
}
