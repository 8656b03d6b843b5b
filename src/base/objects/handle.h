// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// From ODE's opaque handles (dBodyID = dxBody*) to our objects and back; the only reinterpret_casts of the
// tree are here. Every object begins with a Tag, which is overwritten when the object dies. Pools keep the
// memory readable, so a null, stale or mistyped handle is recognised and not followed. Objects are aligned to
// 64 bytes, and the six low bits of a handle count the objects that have used the slot: a stale handle is
// recognised even when a new object lives there, until the 64th successor. Leaving freed slots unused for a
// while would promise less, and a slot that is reused at once is still in the cache. (A pointer that never
// came from the library cannot be recognised.)
#pragma once

#include <cstdint>

#include "base/config.h"

namespace epode {

enum class Tag : std::uint32_t {
    kDead = 0xdeadb0d7,
    kWorld = 0x0de00001,
    kBody = 0x0de00002,
    kJoint = 0x0de00003,
    kJointGroup = 0x0de00004,
    kGeom = 0x0de00005,
    kHeightfieldData = 0x0de00006,
    kTrimeshData = 0x0de00007,
    kThreading = 0x0de00011,
    kThreadPool = 0x0de00012,
    kMutexGroup = 0x0de00013,
    kCall = 0x0de00014,
    kCallWait = 0x0de00015,
    kCooperative = 0x0de00016,
    kResourceRequirements = 0x0de00017,
    kResourceContainer = 0x0de00018,
    kPostedJob = 0x0de00019,
    kFluid = 0x0de0001c,
};

// What every object behind a handle starts with.
struct alignas(kCacheLine) Tagged {
    explicit Tagged(Tag t) : tag(t) {}
    ~Tagged() { *const_cast<volatile Tag*>(&tag) = Tag::kDead; }  // volatile: the store must survive
    Tag tag;
    std::uint32_t generation = 0;  // of the slot's objects, 0 ... 63; the pool counts
};

// `serial` tells objects of one kind apart (bodies: within their world) and is never reused.
struct Numbered : Tagged {
    using Tagged::Tagged;
    std::uint64_t serial = 0;
};

inline constexpr std::uint32_t kGenerations = kCacheLine;
inline constexpr std::intptr_t kFirstPage = 4096;  // no object lies below

// Each object type O specialises this: its C handle and its tag.
template <typename O>
struct HandleOf;

template <typename O>
auto to_handle(const O* object)
{
    using Id = typename HandleOf<O>::Id;
    if (!object) return Id(nullptr);
    return reinterpret_cast<Id>(reinterpret_cast<std::uintptr_t>(object) | object->generation);
}

// Of a handle that from_handle has judged: without a second look at the object.
template <typename O>
O* from_judged_handle(typename HandleOf<O>::Id id)
{
    return reinterpret_cast<O*>(reinterpret_cast<std::uintptr_t>(id) & ~std::uintptr_t(kGenerations - 1));
}

// Null unless the handle names a live object of this kind.
template <typename O>
O* from_handle(typename HandleOf<O>::Id id)
{
    const auto bits = reinterpret_cast<std::uintptr_t>(id);
    auto* object = from_judged_handle<O>(id);
    if constexpr (!kChecked) return object;
    // Signed: addresses in the first page and values such as (dBodyID)-1 are never dereferenced.
    const bool alive = std::intptr_t(bits) >= kFirstPage && object->tag == HandleOf<O>::kTag &&
                       object->generation == std::uint32_t(bits & (kGenerations - 1));
    return alive ? object : nullptr;
}

}  // namespace epode
