// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Handles of models and robots: odd negative numbers, which are no object's address and which libode refuses as well. None is given
// twice, so one that is null, destroyed or of another object is not in the table, and is never followed. (Libode's own handles are
// addresses, which its pools keep readable; robots are few and large, so a table costs little next to what their functions do.)
#pragma once

#include <atomic>
#include <cstdint>
#include <map>
#include <memory>

#include "robots/table_lock.h"

namespace epode::robots {

// Of models and robots together, so that neither is mistaken for the other.
inline std::uintptr_t next_handle()
{
    static std::atomic<std::uintptr_t> next = ~(~std::uintptr_t(0) >> 1) | 1;
    return next.fetch_add(2);
}

template <class Object>
class Handles {
  public:
    // Never destroyed: programs may destroy robots in destructors of their own statics.
    static Handles& all()
    {
        static Handles* const its = new Handles;
        return *its;
    }

    // Throws std::bad_alloc.
    Object* add(std::unique_ptr<Object> object)
    {
        const WriteLock lock(mutex_);
        const auto handle = reinterpret_cast<Object*>(next_handle());
        objects_.emplace(handle, std::move(object));
        return handle;
    }

    Object* find(const Object* handle) const
    {
        const ReadLock lock(mutex_);
        const auto found = objects_.find(handle);
        return found == objects_.end() ? nullptr : found->second.get();
    }

    // The object dies after the table is free again: its destruction may call the program.
    bool remove(const Object* handle)
    {
        std::unique_ptr<Object> last;
        const WriteLock lock(mutex_);
        const auto found = objects_.find(handle);
        if (found == objects_.end()) return false;
        last = std::move(found->second);
        objects_.erase(found);
        return true;
    }

  private:
    mutable TableMutex mutex_;
    std::map<const Object*, std::unique_ptr<Object>> objects_;
};

}  // namespace epode::robots
