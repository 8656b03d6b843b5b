// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "collide/shape_stream.h"

#include "base/check.h"

namespace epode {

bool ShapeStream::note(const void* object, const void* of_kind, void (*destroy)(void*))
{
    const bool has_memory = (loads() || numbers_.add(object, objects_.size())) &&
                            objects_.push({const_cast<void*>(object), of_kind, destroy});
    return demand(has_memory, kOutOfMemory);
}

void* ShapeStream::shared_at(int i, const void* of_kind)
{
    const bool fits = objects_[i].kind == of_kind;
    return demand(fits, "a geom in it has the mesh of another class") ? objects_[i].object : nullptr;
}

void ShapeStream::geom(Geom*& one)
{
    std::uint32_t at = saves() && one ? std::uint32_t(find(*one)) + 1 : 0;
    number(at);
    if (saves()) return;
    if (!demand(at <= std::uint32_t(geoms_.size()), "a geom in it names one that comes later")) at = 0;
    one = at > 0 ? geoms_[int(at) - 1] : nullptr;
}

bool ShapeStream::add(Geom& one)
{
    const bool has_memory = (loads() || geom_numbers_.add(&one, geoms_.size())) && geoms_.push(&one);
    return demand(has_memory, kOutOfMemory);
}

void ShapeStream::destroy_shared()
{
    for (const Object& one : objects_)
        if (one.destroy) one.destroy(one.object);
    objects_.clear();
}

}  // namespace epode
