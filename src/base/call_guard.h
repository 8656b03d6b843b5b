// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What a call of the library changes for its own time (locks, marks, borrowed lists) and undoes when it ends,
// however it ends. Functions of the program that it calls, message handlers among them, may leave it by longjmp
// or by a C++ exception, which run no destructor here: longjmp never does, and the library is compiled without
// exceptions.
//
// So each guard is also listed, outside the stack, with what undoes it. A guard has been left
// - if the stack has been unwound past it: the function that makes another guard, or asks, lies where it was or
//   further out;
// - if newer calls have overwritten it, or lie where it was (base/stack_frames.h).
// Guards that were left are undone when a guard is made or ends on their thread, when the thread ends, and by
// release_left(), which everything asks that would refuse a call because of a lock. Other stacks than the thread's own (coroutines) are
// never judged: what is left there stays.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>

namespace epode {

class CallGuard {
  public:
    // `list`, `size`: whatever else is needed; it must not lie on the stack.
    using Undo = void(void* object, const void* list, std::size_t size);

    // Null: there is nothing to undo.
    CallGuard(Undo* undo, void* object, const void* list = nullptr, std::size_t size = 0)
        : undo_(undo), object_(object), list_(list), size_(std::uint32_t(size))
    {
        if (undo) begin();
    }
    ~CallGuard()
    {
        if (undo_ && end_listed()) undo_(object_, list_, size_);
    }
    CallGuard(const CallGuard&) = delete;
    CallGuard& operator=(const CallGuard&) = delete;

    // The caller undoes it himself. False: it has been undone.
    bool end() { return std::exchange(undo_, nullptr) && end_listed(); }

    // Whether this thread is inside a call that holds something.
    static bool any();
    [[gnu::cold, gnu::noinline]] static void release_left();
    // Whether the function has been left that has put the object on this thread's stack.
    [[gnu::cold, gnu::noinline]] static bool is_left(const void* object);

  private:
    friend struct GuardList;
    // Its frame begins where the calling function's ends.
    [[gnu::noinline]] void begin();
    bool end_listed();  // false: it has been undone

    // Small: collisions nest spaces, and stacks may be.
    Undo* undo_;
    void* object_;
    const void* list_;
    std::uint32_t size_;
    volatile std::uint32_t mark_;  // differs from one guard to the next; 0: not listed
};

}  // namespace epode
