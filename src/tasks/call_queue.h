// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Calls as ODE's threading interface defines them (ode/threading.h): posted to be run by some thread, each
// with a number of other calls that must be done before it starts. A call is done when its function has
// returned and it depends on nothing any more, since a running call may add dependencies to itself. Then its
// fault is written, its wait is signalled, and the call that depends on it loses one dependency and receives
// the fault.
//
// The serving threads run calls first in, first out. Where no thread serves, and inside a call, the thread
// that waits runs them itself, so a wait cannot starve. This one rule makes the self-threaded implementation
// (no thread ever serves) and the multi-threaded one the same class.
#pragma once

#include <atomic>
#include <cstddef>

#include "base/objects/handle.h"
#include "ode/threading.h"
#include "tasks/fork_watch.h"
#include "tasks/lock.h"

namespace epode {

class CallQueue;
struct Call;

// An object to wait on: all calls posted with it since it was reset.
struct CallWait : Tagged {
    explicit CallWait(CallQueue& q) : Tagged(Tag::kCallWait), queue(&q) {}
    CallQueue* queue;
    int pending = 0;  // calls that are not done
    int waiters = 0;  // threads inside wait()
    bool posted = false;
    std::atomic<bool> over{false};  // posted, and none pending
    CallWait *previous = nullptr, *next = nullptr;
};
template <>
struct HandleOf<CallWait> {
    using Id = dCallWaitID;
    static constexpr Tag kTag = Tag::kCallWait;
};

struct CallRequest {
    dThreadedCallFunction* function;
    void* context;
    dcallindex_t index;
    std::size_t dependencies;
    dCallReleaseeID dependent;
    dCallWaitID wait;
    int* fault;
    dCallReleaseeID* releasee;
};

// Callbacks of serve(): after the thread has registered, and before it unregisters, with the queue's lock
// held.
struct ServeHooks {
    void (*ready)(void* context);
    void (*leaving)(void* context);
    void* context;
};

class CallQueue {
  public:
    enum class Posted { kYes, kRefused, kNoMemory };
    enum class Waited { kDone, kTimedOut, kUnknown, kForEver };

    // `served`: threads may serve. Otherwise a wait that nothing can end is refused instead of lasting for
    // ever.
    explicit CallQueue(bool served);
    CallQueue(const CallQueue&) = delete;
    CallQueue& operator=(const CallQueue&) = delete;
    ~CallQueue();  // after may_end()

    // Allocates memory for so many calls at a time.
    bool reserve(std::size_t calls);
    Posted post(const CallRequest& request);
    // Changes the number of dependencies. False: no such call, or the number would fall below zero or below
    // those already posted.
    bool alter(dCallReleaseeID call, std::ptrdiff_t change);

    CallWait* make_wait();
    bool free_wait(dCallWaitID wait);   // false: not ours, or in use
    bool reset_wait(dCallWaitID wait);  // likewise
    // Refused if it would last for ever: no time limit, and either nothing was posted with the wait, or it
    // belongs to a call that this thread is running, or nothing can end it. Unknown: not a wait of this
    // queue.
    Waited wait(dCallWaitID wait, const Deadline& until);

    // Runs calls until close(). False: the calling thread is in a call of this queue.
    bool serve(const ServeHooks& hooks);
    unsigned serving() const { return serving_.load(std::memory_order_relaxed); }
    // Releases the serving threads; they finish the calls that they are running.
    void close();
    bool closed() const { return closed_.load(std::memory_order_acquire); }
    // After close(): threads may serve again. False while some have not left yet.
    bool reopen();
    // Waits for threads that are leaving. False: a thread serves, waits or runs a call.
    bool may_end();

  private:
    bool make_slot();
    Call* take_slot();
    void give_back(Call& call);
    Call* expecting(dCallReleaseeID id);
    CallWait* known(dCallWaitID id);
    Posted post_without_slot(const CallRequest& request, Call* dependent, CallWait* wait);
    void fill(Call& call, const CallRequest& request, Call* dependent, CallWait* wait);
    Posted drop(const CallRequest& request, Call* dependent, CallWait* wait);
    void make_ready(Call& call);
    Call* take_ready();
    bool settle(Call& call);
    bool release_one(Call& call, bool failed);
    void run(Call& call);
    void finish(Call& first);
    void count_down(CallWait& wait);
    int depth() const;
    bool helps() const { return serving() == 0 || depth() > 0; }
    bool awaits_itself(const CallWait& wait) const;
    bool hopeless() const;
    Waited work_until(const CallWait& wait, const Deadline& until);
    void rest(const CallWait& wait, const Deadline& until);
    void idle();
    void rouse();
    void act(ForkStage stage);

    const bool served_;
    Lock lock_;
    Condition work_, change_;  // for serving threads; for waiting threads
    int idle_servers_ = 0, idle_waiters_ = 0;
    std::atomic<unsigned> serving_{0};
    std::atomic<bool> closed_{false};
    int running_ = 0;
    Call *first_ready_ = nullptr, *last_ready_ = nullptr;
    std::atomic<int> ready_{0};
    Call* slots_ = nullptr;  // free ones
    Call* all_ = nullptr;    // free or not
    std::size_t slot_count_ = 0;
    CallWait* waits_ = nullptr;
    ForkWatch watch_;
};

}  // namespace epode
