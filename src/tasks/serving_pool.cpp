// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A served queue lives at least until its last thread has been counted off here: `leaving` comes before the
// queue forgets the thread, and a queue with threads inside is not freed. Therefore `queue_` may be read
// while `busy_` is not 0. The queue's lock is taken before the pool's.
#include "tasks/serving_pool.h"

#include "base/objects/pool.h"
#include "tasks/operating_system.h"

namespace epode {
namespace {

constexpr std::size_t kMinStack = 64 * 1024;  // a step of a large island needs less

thread_local const ServingPool* t_pool = nullptr;

}  // namespace

ServingPool::ServingPool(const PoolSettings& settings)
    : Tagged(Tag::kThreadPool),
      settings_(settings),
      watch_(ForkRank::kServingPool, this,
             [](void* self, ForkStage stage) { static_cast<ServingPool*>(self)->act(stage); })
{}

ServingPool::~ServingPool() { release(threads_, sizeof(pthread_t) * settings_.threads); }

ServingPool* ServingPool::create(const PoolSettings& settings)
{
    ServingPool* const pool = Pool<ServingPool>::create(settings);
    if (!pool || pool->start()) return pool;
    pool->stop();
    Pool<ServingPool>::destroy(pool);
    return nullptr;
}

bool ServingPool::destroy(ServingPool* pool)
{
    if (!pool->wait_until_idle()) return false;
    pool->stop();
    Pool<ServingPool>::destroy(pool);
    return true;
}

// ---- threads

bool ServingPool::start()
{
    threads_ = static_cast<pthread_t*>(allocate(sizeof(pthread_t) * settings_.threads));
    if (!threads_ || !spawn()) return false;
    Guard guard(lock_);
    while (started_ + failed_ < count_) news_.wait(lock_);
    return failed_ == 0;
}

bool ServingPool::spawn()
{
    pthread_attr_t attributes;
    if (pthread_attr_init(&attributes) != 0) return false;
    bool good = settings_.stack == 0 || (settings_.stack >= kLeastStack && settings_.stack <= kMostStack);
    if (good && settings_.stack) {
        const std::size_t stack = settings_.stack < kMinStack ? kMinStack : settings_.stack;
        good = pthread_attr_setstacksize(&attributes, stack) == 0;
    }
    const BlockedSignals blocked;
    while (good && count_ < settings_.threads) {
        good = pthread_create(threads_ + count_, &attributes, main_of, this) == 0;
        if (good) ++count_;
    }
    pthread_attr_destroy(&attributes);
    return good;
}

void* ServingPool::main_of(void* pool)
{
    static_cast<ServingPool*>(pool)->live();
    return nullptr;
}

void ServingPool::live()
{
    t_pool = this;
    const bool good = settings_.start(settings_.flags) != 0;
    Guard guard(lock_);
    ++(good ? started_ : failed_);
    news_.wake_all();
    unsigned seen = 0;
    while (!ending_) {
        if (order_ == seen) {
            orders_.wait(lock_);
            continue;
        }
        seen = order_;
        CallQueue& queue = *queue_;
        lock_.unlock();
        work(queue);
        lock_.lock();
    }
}

void ServingPool::work(CallQueue& queue)
{
    const auto ready = [](void* self) {
        ServingPool& pool = *static_cast<ServingPool*>(self);
        Guard guard(pool.lock_);
        ++pool.ready_;
        pool.news_.wake_all();
    };
    const auto leaving = [](void* self) {
        ServingPool& pool = *static_cast<ServingPool*>(self);
        Guard guard(pool.lock_);
        --pool.busy_;
        pool.news_.wake_all();
    };
    queue.serve({ready, leaving, this});
}

void ServingPool::stop()
{
    {
        Guard guard(lock_);
        ending_ = true;
        orders_.wake_all();
    }
    for (unsigned i = 0; i < count_; ++i) pthread_join(threads_[i], nullptr);
    count_ = 0;
}

// ---- orders

// With the lock held. Threads of a closed queue leave it when they have finished their calls.
bool ServingPool::wait_until_left()
{
    while (busy_ > 0) {
        if (!queue_->closed() || t_pool == this) return false;
        news_.wait(lock_);
    }
    return true;
}

bool ServingPool::wait_until_idle()
{
    Guard guard(lock_);
    return wait_until_left() && t_pool != this;
}

bool ServingPool::serve(CallQueue& queue)
{
    Guard guard(lock_);
    if (!wait_until_left() || t_pool == this) return false;
    queue_ = &queue;
    busy_ = count_;
    ready_ = 0;
    ++order_;
    orders_.wake_all();
    while (ready_ < count_) news_.wait(lock_);
    return true;
}

// The child of a fork has none of the threads.
void ServingPool::act(ForkStage stage)
{
    if (stage == ForkStage::kBefore) return lock_.lock();
    if (stage == ForkStage::kInChild) {
        count_ = ready_ = busy_ = 0;
        orders_.renew();
        news_.renew();
    }
    lock_.unlock();
}

}  // namespace epode
