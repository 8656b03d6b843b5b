// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Guards end in the reverse order of their making, so the list is a stack. Anything else in it has been left, or belongs
// to another stack of the thread.
#include "base/call_guard.h"

#include <cstring>

#include "base/memory.h"
#include "base/stack_frames.h"

#if defined(_WIN32)
#ifndef NOMINMAX
#define NOMINMAX
#endif
#include <windows.h>
#else
#include "base/threads/system_threads.h"
#endif

namespace epode {

struct GuardList {
    struct Entry {
        const CallGuard* guard;
        CallGuard::Undo* undo;
        void* object;
        const void* list;
        std::uint32_t size, mark;
        std::uintptr_t bottom;  // of the frame that it lies in
    };
    // Stacks grow downwards on every machine that the library is built for.
    struct Stack {
        std::uintptr_t low, high;  // both 0: not known
        bool holds(const void* address) const
        {
            const auto a = reinterpret_cast<std::uintptr_t>(address);
            return a >= low && a < high;
        }
    };
    static constexpr int kFew = 16;  // without memory of their own

    Entry few[kFew];
    Entry* many;  // null: `few`
    int size, capacity;
    bool grows;
    std::uint32_t made;
    Stack known;

    const Stack& own();
    Entry* entries() { return many ? many : few; }
    Entry& last() { return entries()[size - 1]; }
    void begin(CallGuard& guard, std::uintptr_t bottom);
    static std::size_t bytes(int count) { return sizeof(Entry) * std::size_t(count); }
    bool reserve();
    void drop_many();
    void remove(int at);
    void undo(int at);
    static bool is_passed(const Entry& entry, const CallGuard* by, std::uintptr_t bottom);
    void undo_passed(const CallGuard* by, std::uintptr_t bottom);
    void undo_left(const void* here);
    bool end(const CallGuard* guard);
    static bool is_left(const Entry& entry, const void* here);
    static bool intact(const Entry& entry);
};

namespace {

constinit thread_local GuardList t_guards = {};

// Whatever a thread holds when it ends has been left, unless it ends the program inside a call.
struct ThreadEnd {
    ~ThreadEnd() { CallGuard::release_left(); }
};
#if defined(__wasm__)
void watch_thread_end() {}  // its one thread ends with the module
#else
void watch_thread_end() { static thread_local const ThreadEnd end; }
#endif

// The calling thread's own.
GuardList::Stack find_stack()
{
#if defined(_WIN32)
    ULONG_PTR low, high;
    GetCurrentThreadStackLimits(&low, &high);
    return {low, high};
#elif defined(__linux__)
    pthread_attr_t attributes;
    void* low = nullptr;
    std::size_t size = 0;
    if (pthread_getattr_np(pthread_self(), &attributes) != 0) return {};
    pthread_attr_getstack(&attributes, &low, &size);
    pthread_attr_destroy(&attributes);
    const auto first = reinterpret_cast<std::uintptr_t>(low);
    return {first, first + size};
#else
    return {0, ~std::uintptr_t(0)};  // one stack
#endif
}

}  // namespace

// To find it is slow: on Linux's first thread a file is read.
const GuardList::Stack& GuardList::own()
{
    if (known.high == 0) known = find_stack();
    return known;
}

// One more place. The program's function that provides it may call the library: its guards have no place meanwhile.
bool GuardList::reserve()
{
    if (size < (many ? capacity : kFew)) return true;
    if (grows) return false;
    const int wanted = 2 * size;
    grows = true;
    auto* more = static_cast<Entry*>(allocate(bytes(wanted)));
    grows = false;
    if (!more) return false;
    std::memcpy(more, entries(), bytes(size));
    drop_many();
    many = more, capacity = wanted;
    return true;
}

void GuardList::drop_many()
{
    Entry* const old = std::exchange(many, nullptr);
    if (old) release(old, bytes(capacity));
}

void GuardList::remove(int at)
{
    Entry* const all = entries();
    std::memmove(all + at, all + at + 1, sizeof(Entry) * std::size_t(--size - at));
    if (!many || size > kFew / 2) return;
    std::memcpy(few, many, bytes(size));
    drop_many();
}

void GuardList::undo(int at)
{
    const Entry entry = entries()[at];
    remove(at);
    entry.undo(entry.object, entry.list, entry.size);
}

// Does it lie where a new guard lies, or further in than the function that makes that? Guards of one function lie in
// any order.
bool GuardList::is_passed(const Entry& entry, const CallGuard* by, std::uintptr_t bottom)
{
    const auto at = reinterpret_cast<std::uintptr_t>(entry.guard),
               here = reinterpret_cast<std::uintptr_t>(by);
    return at < bottom || at + sizeof *by - here - 1 < 2 * sizeof *by - 1;
}

void GuardList::undo_passed(const CallGuard* by, std::uintptr_t bottom)
{
    if (!own().holds(by)) return;
    for (int i = size; i-- > 0;)
        if (own().holds(entries()[i].guard) && is_passed(entries()[i], by, bottom)) undo(i);
}

// Whether it is listed; then it is not any more, and newer ones of this stack have been left.
[[gnu::noinline]] bool GuardList::end(const CallGuard* guard)
{
    if (size > 0 && last().guard == guard) [[likely]] {
        if (!many)
            --size;
        else
            remove(size - 1);
        return true;
    }
    int at = size;
    while (at-- > 0 && entries()[at].guard != guard) {}
    if (at < 0) return false;
    for (int i = size; i-- > at + 1;)
        if (own().holds(guard) && own().holds(entries()[i].guard)) undo(i);
    remove(at);
    return true;
}

// Only memory of the calling thread's stack that is in use is looked at.
[[gnu::noinline, gnu::no_sanitize_address]] bool GuardList::intact(const Entry& entry)
{
    return entry.guard->mark_ == entry.mark;
}

bool GuardList::is_left(const Entry& entry, const void* here)
{
    return static_cast<const void*>(entry.guard) < here || !intact(entry) ||
           !may_be_running(entry.guard, entry.bottom);
}

void GuardList::undo_left(const void* here)
{
    if (!own().holds(here)) return;
    for (int i = size; i-- > 0;)
        if (own().holds(entries()[i].guard) && is_left(entries()[i], here)) undo(i);
}

// A function of its own, so that the list is looked up once.
[[gnu::noinline]] void GuardList::begin(CallGuard& guard, std::uintptr_t bottom)
{
    if (size > 0 && is_passed(last(), &guard, bottom)) [[unlikely]]
        undo_passed(&guard, bottom);
    if (made == 0) [[unlikely]]
        watch_thread_end();
    // Odd multiples of this number look like nothing else in memory.
    const std::uint32_t mark = (++made << 1 | 1) * 0x9e3779b9u;
    const bool listed = reserve();
    if (listed)
        entries()[size++] = {&guard, guard.undo_, guard.object_, guard.list_, guard.size_, mark, bottom};
    guard.mark_ = listed ? mark : 0;
}

void CallGuard::begin() { t_guards.begin(*this, reinterpret_cast<std::uintptr_t>(__builtin_dwarf_cfa())); }

bool CallGuard::end_listed() { return mark_ == 0 || t_guards.end(this); }

bool CallGuard::any() { return t_guards.size > 0; }

bool CallGuard::is_left(const void* object)
{
    const void* const here = __builtin_frame_address(0);
    const GuardList::Stack& own = t_guards.own();
    return own.holds(here) && own.holds(object) && (object < here || !may_be_running(object, 0));
}

void CallGuard::release_left()
{
    if (any()) t_guards.undo_left(__builtin_frame_address(0));
}

}  // namespace epode
