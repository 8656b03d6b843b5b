// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// From ODE's opaque handles (dBodyID = dxBody*) to our objects and back: the only reinterpret_casts of the
// tree live here. Every object begins with a Tag, overwritten when it dies; pools keep the memory readable,
// so a null, stale or mistyped handle is recognised instead of followed. (A pointer that never came from us
// cannot be recognised by anyone.)
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
};

// What every object behind a handle starts with; `serial` tells objects of one kind apart
// (bodies: within their world) and is never reused.
struct Tagged {
    explicit Tagged(Tag t) : tag(t) {}
    ~Tagged() { *const_cast<volatile Tag*>(&tag) = Tag::kDead; }  // volatile: the store must survive
    Tag tag;
    std::uint32_t unused = 0;
    std::uint64_t serial = 0;
};

// Each object type O specialises this: its C handle and its tag.
template <typename O>
struct HandleOf;

template <typename O>
auto to_handle(const O* object)
{
    return reinterpret_cast<typename HandleOf<O>::Id>(const_cast<O*>(object));
}

// Null unless the handle names a live object of this kind.
template <typename O>
O* from_handle(typename HandleOf<O>::Id id)
{
    auto* object = reinterpret_cast<O*>(id);
    return object && object->tag == HandleOf<O>::kTag ? object : nullptr;
}

}  // namespace epode
