// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Calls as ODE's threading interface means them (ode/threading.h): posted to be run by some thread, each with
// a number of other calls that must be done before it starts. A call is done when its function has returned
// and nothing is left that it depends on, since a running call may add dependencies to itself. Then its
// fault is written, its wait is told, and the call that depends on it has one dependency less, and the fault.
//
// Calls are run first in, first out, by the threads that serve. Where none serves, and inside a call, the
// thread that waits runs them itself: a wait cannot starve. That one rule makes the self-threaded
// implementation (nobody ever serves) and the multi-threaded one the same class.
#pragma once

#include <atomic>
#include <cstddef>

#include "base/handle.h"
#include "ode/threading.h"
#include "tasks/fork_watch.h"
#include "tasks/lock.h"

namespace epode {

class CallQueue;
struct Call;

// What a thread can wait on: all calls that were posted with it since it was reset.
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

// Told by serve(): registered; about to be unregistered, with the queue's lock held.
struct ServeHooks {
    void (*ready)(void* context);
    void (*leaving)(void* context);
    void* context;
};

class CallQueue {
  public:
    enum class Posted { kYes, kRefused, kNoMemory };
    enum class Waited { kDone, kTimedOut, kUnknown, kForEver };

    // `served`: threads may serve; else a wait that nothing can end is refused instead of being for ever.
    explicit CallQueue(bool served);
    CallQueue(const CallQueue&) = delete;
    CallQueue& operator=(const CallQueue&) = delete;
    ~CallQueue();  // after may_end()

    // Memory for so many calls at a time.
    bool reserve(std::size_t calls);
    Posted post(const CallRequest& request);
    // Dependencies more or less; false: no such call, or fewer than zero or than have been posted for it.
    bool alter(dCallReleaseeID call, std::ptrdiff_t change);

    CallWait* make_wait();
    bool free_wait(dCallWaitID wait);   // false: not ours, or in use
    bool reset_wait(dCallWaitID wait);  // likewise
    // For ever, and therefore not at all: without a limit of time, when nothing was posted with it, it is
    // that of a call which the thread is in, or nothing can end it. Unknown: not one of this queue's.
    Waited wait(dCallWaitID wait, const Deadline& until);

    // Runs calls until close(). False: the calling thread is in a call of this queue.
    bool serve(const ServeHooks& hooks);
    unsigned serving() const { return serving_.load(std::memory_order_relaxed); }
    // Lets the serving threads go; they finish the calls that they are in.
    void close();
    bool closed() const { return closed_.load(std::memory_order_acquire); }
    // After close(): they may come again. False while some are still here.
    bool reopen();
    // Waits for threads on their way out. False: one serves, waits or runs a call.
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
    Condition work_, change_;  // for those who serve; for those who wait
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
