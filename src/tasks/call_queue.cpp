// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// One lock guards everything: a call takes microseconds at least and few threads post calls. The lock is
// never held while a function of the client runs, memory handlers included. A thread without work spins for
// some microseconds before it sleeps, because a step posts its stages in quick succession. A call lives in a
// slot that its queue owns, so posting allocates nothing after `reserve`. The tag of a free slot is dead,
// which reveals a releasee that was kept for too long.
#include "tasks/call_queue.h"

#include "base/objects/pool.h"
#include "base/threads/spin.h"

namespace epode {

struct Call : Tagged {
    enum class State { kWaiting, kReady, kRunning, kReturned };

    explicit Call(CallQueue& q) : Tagged(Tag::kCall), queue(&q) {}
    CallQueue* queue;
    Call* all = nullptr;   // of its queue
    Call* next = nullptr;  // in the list of ready calls or of free slots
    dThreadedCallFunction* function = nullptr;
    void* context = nullptr;
    dcallindex_t index = 0;
    std::size_t dependencies = 0;  // calls it waits for that are not done
    std::size_t posted = 0;        // how many of these have been posted
    Call* dependent = nullptr;
    CallWait* wait = nullptr;
    int* fault = nullptr;
    bool failed = false;
    bool kept = true;  // false: on the stack of a post that found no memory
    bool done = false;
    State state = State::kWaiting;
};
template <>
struct HandleOf<Call> {
    using Id = dCallReleaseeID;
    static constexpr Tag kTag = Tag::kCall;
};

namespace {

constexpr int kSpins = 4000;  // some ten microseconds
constexpr std::size_t kMaxReserved = 1 << 16;

// The calls that a thread is running, the innermost first.
struct Frame {
    const CallQueue* queue;
    const Call* call;
    const Frame* outer;
};
thread_local const Frame* t_frame = nullptr;

}  // namespace

CallQueue::CallQueue(bool served)
    : served_(served), watch_(ForkRank::kCallQueue, this, [](void* self, ForkStage stage) {
          static_cast<CallQueue*>(self)->act(stage);
      })
{}

CallQueue::~CallQueue()
{
    while (Call* call = all_) {
        all_ = call->all;
        Pool<Call>::destroy(call);
    }
    while (CallWait* wait = waits_) {
        waits_ = wait->next;
        Pool<CallWait>::destroy(wait);
    }
}

// ---- slots

// The caller holds the lock; it is released while memory is allocated.
bool CallQueue::make_slot()
{
    lock_.unlock();
    Call* const call = Pool<Call>::create(*this);
    lock_.lock();
    if (!call) return false;
    call->all = all_;
    all_ = call;
    ++slot_count_;
    give_back(*call);
    return true;
}

Call* CallQueue::take_slot()
{
    if (!slots_ && !make_slot()) return nullptr;
    Call* const call = slots_;
    slots_ = call->next;
    return call;
}

void CallQueue::give_back(Call& call)
{
    if (!call.kept) {
        call.done = true;
        return;
    }
    call.tag = Tag::kDead;
    call.generation = (call.generation + 1) % kGenerations;
    call.next = slots_;
    slots_ = &call;
}

bool CallQueue::reserve(std::size_t calls)
{
    if (calls > kMaxReserved) return false;
    Guard guard(lock_);
    while (slot_count_ < calls)
        if (!make_slot()) return false;
    return true;
}

// ---- posting

CallWait* CallQueue::known(dCallWaitID id)
{
    CallWait* const wait = from_handle<CallWait>(id);
    return wait && wait->queue == this ? wait : nullptr;
}

// The call that the releasee names, if it expects more dependencies than have been posted.
Call* CallQueue::expecting(dCallReleaseeID id)
{
    Call* const call = from_handle<Call>(id);
    return call && call->queue == this && call->posted < call->dependencies ? call : nullptr;
}

CallQueue::Posted CallQueue::post(const CallRequest& request)
{
    Guard guard(lock_);
    Call* const slot = take_slot();
    Call* const dependent = request.dependent ? expecting(request.dependent) : nullptr;
    CallWait* const wait = request.wait ? known(request.wait) : nullptr;
    if ((request.dependent && !dependent) || (request.wait && !wait)) {
        if (slot) give_back(*slot);
        return Posted::kRefused;
    }
    if (!slot) return post_without_slot(request, dependent, wait);
    fill(*slot, request, dependent, wait);
    if (slot->dependencies == 0) make_ready(*slot);
    return Posted::kYes;
}

void CallQueue::fill(Call& call, const CallRequest& request, Call* dependent, CallWait* wait)
{
    call.tag = Tag::kCall;
    call.function = request.function;
    call.context = request.context;
    call.index = request.index;
    call.dependencies = request.dependencies;
    call.posted = 0;
    call.dependent = dependent;
    call.wait = wait;
    call.fault = request.fault;
    call.failed = call.done = false;
    call.state = Call::State::kWaiting;
    if (dependent) ++dependent->posted;
    if (wait) {
        ++wait->pending;
        wait->posted = true;
        wait->over.store(false, std::memory_order_relaxed);
    }
    if (request.releasee) *request.releasee = to_handle(&call);
}

// Without memory, a call that may start at once is run here; one that would have to be stored is not.
CallQueue::Posted CallQueue::post_without_slot(const CallRequest& request, Call* dependent, CallWait* wait)
{
    if (request.dependencies > 0) return drop(request, dependent, wait);
    Call call(*this);
    call.kept = false;
    fill(call, request, dependent, wait);
    run(call);
    while (!call.done) {
        Call* const other = take_ready();
        if (other) {
            run(*other);
        } else {
            ++idle_waiters_;
            change_.wait(lock_);
            --idle_waiters_;
        }
    }
    return Posted::kYes;
}

// Treated as a call that ran and failed.
CallQueue::Posted CallQueue::drop(const CallRequest& request, Call* dependent, CallWait* wait)
{
    if (request.fault) *request.fault = 1;
    if (wait) {
        ++wait->pending;
        wait->posted = true;
        count_down(*wait);
    }
    if (dependent) {
        ++dependent->posted;
        if (release_one(*dependent, true)) finish(*dependent);
    }
    return Posted::kNoMemory;
}

bool CallQueue::alter(dCallReleaseeID id, std::ptrdiff_t change)
{
    Guard guard(lock_);
    Call* const call = from_handle<Call>(id);
    if (!call || call->queue != this) return false;
    const std::size_t free = call->dependencies - call->posted;
    if (change < 0 ? free < std::size_t(0) - std::size_t(change) : std::size_t(change) > kMaxReserved)
        return false;
    call->dependencies += std::size_t(change);
    if (settle(*call)) finish(*call);
    return true;
}

// ---- running

void CallQueue::make_ready(Call& call)
{
    call.state = Call::State::kReady;
    const bool last_first = !served_ || !first_ready_;  // as ODE's self-threaded implementation does
    call.next = last_first ? first_ready_ : nullptr;
    if (!last_first) last_ready_->next = &call;
    if (!call.next) last_ready_ = &call;
    if (last_first) first_ready_ = &call;
    ready_.fetch_add(1, std::memory_order_release);
    rouse();
}

void CallQueue::rouse()
{
    if (idle_servers_)
        work_.wake_one();
    else if (idle_waiters_)
        change_.wake_all();
}

Call* CallQueue::take_ready()
{
    Call* const call = first_ready_;
    if (!call) return nullptr;
    first_ready_ = call->next;
    ready_.fetch_sub(1, std::memory_order_relaxed);
    return call;
}

// After its dependencies have changed. True: the call is done.
bool CallQueue::settle(Call& call)
{
    if (call.dependencies > 0) return false;
    if (call.state == Call::State::kWaiting) make_ready(call);
    return call.state == Call::State::kReturned;
}

bool CallQueue::release_one(Call& call, bool failed)
{
    call.failed |= failed;
    --call.posted;
    --call.dependencies;
    return settle(call);
}

// The lock is held on entry and on return, not meanwhile.
void CallQueue::run(Call& call)
{
    call.state = Call::State::kRunning;
    ++running_;
    lock_.unlock();
    const Frame frame{this, &call, t_frame};
    t_frame = &frame;
    const bool good = call.function(call.context, call.index, to_handle(&call)) != 0;
    t_frame = frame.outer;
    lock_.lock();
    --running_;
    call.state = Call::State::kReturned;
    call.failed |= !good;
    if (settle(call)) finish(call);
}

// A loop and not recursion, so that long chains of dependents need no stack.
void CallQueue::finish(Call& first)
{
    for (Call* call = &first; call;) {
        Call* const dependent = call->dependent;
        const bool failed = call->failed;
        if (call->fault) *call->fault = failed;
        if (call->wait) count_down(*call->wait);
        give_back(*call);
        call = dependent && release_one(*dependent, failed) ? dependent : nullptr;
    }
    if (idle_waiters_) change_.wake_all();
}

// ---- waiting

CallWait* CallQueue::make_wait()
{
    CallWait* const wait = Pool<CallWait>::create(*this);
    if (!wait) return nullptr;
    Guard guard(lock_);
    wait->next = waits_;
    if (waits_) waits_->previous = wait;
    waits_ = wait;
    return wait;
}

bool CallQueue::free_wait(dCallWaitID id)
{
    Guard guard(lock_);
    CallWait* const wait = known(id);
    if (!wait || wait->pending > 0 || wait->waiters > 0) return false;
    (wait->previous ? wait->previous->next : waits_) = wait->next;
    if (wait->next) wait->next->previous = wait->previous;
    Pool<CallWait>::destroy(wait);
    return true;
}

bool CallQueue::reset_wait(dCallWaitID id)
{
    Guard guard(lock_);
    CallWait* const wait = known(id);
    if (!wait || wait->pending > 0 || wait->waiters > 0) return false;
    wait->posted = false;
    wait->over.store(false, std::memory_order_relaxed);
    return true;
}

void CallQueue::count_down(CallWait& wait)
{
    if (--wait.pending == 0) wait.over.store(true, std::memory_order_release);
}

// The number of calls of this queue that the thread is running.
int CallQueue::depth() const
{
    int count = 0;
    for (const Frame* f = t_frame; f; f = f->outer) count += f->queue == this;
    return count;
}

bool CallQueue::awaits_itself(const CallWait& wait) const
{
    for (const Frame* f = t_frame; f; f = f->outer)
        for (const Call* call = f->call; call; call = call->dependent)
            if (call->wait == &wait) return true;
    return false;
}

// True if no other thread runs a call or will.
bool CallQueue::hopeless() const { return !served_ && running_ == depth(); }

CallQueue::Waited CallQueue::wait(dCallWaitID id, const Deadline& until)
{
    Guard guard(lock_);
    CallWait* const wait = known(id);
    if (!wait) return Waited::kUnknown;
    if (!until.limited() && (!wait->posted || awaits_itself(*wait))) return Waited::kForEver;
    ++wait->waiters;
    const Waited result = work_until(*wait, until);
    if (wait->waiters > 0) --wait->waiters;  // a fork in between has set it to 0
    return result;
}

CallQueue::Waited CallQueue::work_until(const CallWait& wait, const Deadline& until)
{
    while (!wait.over.load(std::memory_order_relaxed)) {
        if (first_ready_ && helps() && (until.at_once() || !until.passed()))
            run(*take_ready());
        else if (until.passed())
            return Waited::kTimedOut;
        else if (!until.limited() && hopeless())
            return Waited::kForEver;
        else
            rest(wait, until);
    }
    return Waited::kDone;
}

void CallQueue::rest(const CallWait& wait, const Deadline& until)
{
    const auto something = [&] {
        return wait.over.load(std::memory_order_acquire) ||
               (ready_.load(std::memory_order_relaxed) > 0 && helps());
    };
    lock_.unlock();
    for (int spins = 0; spins < kSpins && !something(); ++spins) spin_once();
    lock_.lock();
    if (something()) return;
    ++idle_waiters_;
    change_.wait(lock_, until);
    --idle_waiters_;
}

// ---- serving

bool CallQueue::serve(const ServeHooks& hooks)
{
    if (depth() > 0) return false;
    Guard guard(lock_);
    serving_.fetch_add(1, std::memory_order_relaxed);
    lock_.unlock();
    if (hooks.ready) hooks.ready(hooks.context);
    lock_.lock();
    while (!closed()) {
        if (Call* call = take_ready())
            run(*call);
        else
            idle();
    }
    if (hooks.leaving) hooks.leaving(hooks.context);
    serving_.fetch_sub(1, std::memory_order_relaxed);
    change_.wake_all();
    return true;
}

void CallQueue::idle()
{
    const auto something = [this] { return ready_.load(std::memory_order_acquire) > 0 || closed(); };
    lock_.unlock();
    for (int spins = 0; spins < kSpins && !something(); ++spins) spin_once();
    lock_.lock();
    if (something()) return;
    ++idle_servers_;
    work_.wait(lock_);
    --idle_servers_;
}

void CallQueue::close()
{
    Guard guard(lock_);
    closed_.store(true, std::memory_order_release);
    work_.wake_all();
}

bool CallQueue::reopen()
{
    Guard guard(lock_);
    if (serving() > 0) return !closed();
    closed_.store(false, std::memory_order_release);
    return true;
}

bool CallQueue::may_end()
{
    Guard guard(lock_);
    if (serving() > 0 && (!closed() || depth() > 0)) return false;
    while (serving() > 0) {
        ++idle_waiters_;
        change_.wait(lock_);
        --idle_waiters_;
    }
    for (const CallWait* wait = waits_; wait; wait = wait->next)
        if (wait->waiters > 0) return false;
    return running_ == 0;
}

// The child of a fork does not continue what other threads were doing: the calls that they were running never
// end.
void CallQueue::act(ForkStage stage)
{
    if (stage == ForkStage::kBefore) return lock_.lock();
    if (stage == ForkStage::kInChild) {
        serving_.store(0, std::memory_order_relaxed);
        idle_servers_ = idle_waiters_ = 0;
        running_ = depth();
        for (CallWait* wait = waits_; wait; wait = wait->next) wait->waiters = 0;
        work_.renew();
        change_.renew();
    }
    lock_.unlock();
}

}  // namespace epode
