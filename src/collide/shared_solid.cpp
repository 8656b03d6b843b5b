// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// All solids of geoms are in a list, the most recently requested in front. Only the first few are compared,
// so creating geoms of new points is always cheap. Several threads may create geoms: a lock guards the list
// and the counts. A solid is never written while it has users.
#include "collide/shared_solid.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <mutex>
#include <new>
#include <utility>

#include "base/hash.h"
#include "base/memory.h"
#include "base/objects/pool.h"

namespace epode {
namespace {

constexpr int kCompared = 64;

std::uint64_t bits_of(Real x)
{
    if constexpr (kSingle)
        return std::bit_cast<std::uint32_t>(float(x));
    else
        return std::bit_cast<std::uint64_t>(double(x));
}

std::size_t fingerprint(const Polyhedron& solid)
{
    std::size_t hash = std::size_t(solid.corners().size());
    for (const Vec3& v : solid.vertices())
        for (int i = 0; i < 3; ++i) hash = hash_of(hash, bits_of(v[i]));
    return hash;
}

template <typename T>
bool same(std::span<const T> a, std::span<const T> b)
{
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size_bytes()) == 0;
}

// All else follows from these.
bool same(const Polyhedron& a, const Polyhedron& b)
{
    static_assert(sizeof(PolyhedronFace) == 4 * sizeof(Real) + 2 * sizeof(int));
    const Vec3 middle[] = {a.centre(), b.centre()};
    return std::memcmp(&middle[0], &middle[1], sizeof(Vec3)) == 0 && same(a.vertices(), b.vertices()) &&
           same(a.corners(), b.corners()) && same(a.faces(), b.faces());
}

}  // namespace

struct SharedSolid::Entry {
    Polyhedron solid;  // the first, see of()
    std::size_t fingerprint = 0;
    int users = 1;
    Entry *next = nullptr, *prev = nullptr;
};

struct SharedSolid::Cache {
    SpinLock lock;
    Entry* front = nullptr;

    void put(Entry& e)
    {
        e.prev = nullptr, e.next = front;
        if (front) front->prev = &e;
        front = &e;
    }
    void remove(Entry& e)
    {
        (e.prev ? e.prev->next : front) = e.next;
        if (e.next) e.next->prev = e.prev;
    }
    Entry* find(const Polyhedron& solid, std::size_t fingerprint) const
    {
        Entry* e = front;
        for (int i = 0; e && i < kCompared; ++i, e = e->next)
            if (e->fingerprint == fingerprint && same(e->solid, solid)) return e;
        return nullptr;
    }
};

SharedSolid::Cache& SharedSolid::cache()
{
    static constinit Cache cache;
    return cache;
}

bool SharedSolid::take(Polyhedron& made)
{
    Cache& all = cache();
    const std::size_t print = fingerprint(made);
    SharedSolid taken;
    {
        std::lock_guard guard(all.lock);
        if ((taken.entry_ = all.find(made, print))) {
            ++taken.entry_->users;
            all.remove(*taken.entry_);
            all.put(*taken.entry_);
        }
    }
    if (!taken.entry_) {
        void* const memory = allocate(sizeof(Entry));
        if (!memory) return false;
        taken.entry_ = new (memory) Entry;
        taken.entry_->solid.swap(made);
        taken.entry_->fingerprint = print;
        std::lock_guard guard(all.lock);
        all.put(*taken.entry_);
    }
    swap(taken);
    return true;
}

SharedSolid::~SharedSolid()
{
    if (!entry_) return;
    {
        Cache& all = cache();
        std::lock_guard guard(all.lock);
        if (--entry_->users > 0) return;
        all.remove(*entry_);
    }
    entry_->~Entry();
    release(entry_, sizeof(Entry));
}

const Polyhedron* SharedSolid::get() const { return entry_ ? &entry_->solid : nullptr; }

SharedSolid SharedSolid::of(const Polyhedron& shared)
{
    static_assert(offsetof(Entry, solid) == 0);
    SharedSolid another;
    another.entry_ = reinterpret_cast<Entry*>(const_cast<Polyhedron*>(&shared));
    std::lock_guard guard(cache().lock);
    ++another.entry_->users;
    return another;
}

void SharedSolid::swap(SharedSolid& other) noexcept { std::swap(entry_, other.entry_); }

}  // namespace epode
