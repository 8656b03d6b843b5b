// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// One list per rank, under a lock that a fork holds from before to after.
#include "tasks/fork_watch.h"

#include "tasks/lock.h"
#include "tasks/operating_system.h"

namespace epode {

struct ForkList {
    Lock lock;
    ForkWatch* first[2] = {};

    void notify(ForkStage stage)
    {
        for (ForkWatch* head : first)
            for (ForkWatch* w = head; w; w = w->next_) w->act_(w->object_, stage);
    }

    void add(ForkWatch& w)
    {
        Guard guard(lock);
        ForkWatch*& head = first[int(w.rank_)];
        w.next_ = head;
        if (head) head->previous_ = &w;
        head = &w;
    }

    void remove(ForkWatch& w)
    {
        Guard guard(lock);
        (w.previous_ ? w.previous_->next_ : first[int(w.rank_)]) = w.next_;
        if (w.next_) w.next_->previous_ = w.previous_;
    }
};

namespace {

// Never destroyed: a fork may come while the process ends.
ForkList& fork_list()
{
    alignas(ForkList) static unsigned char memory[sizeof(ForkList)];
    static ForkList* const list = [] {
        auto* made = new (memory) ForkList;
        at_fork(
            [] {
                fork_list().lock.lock();
                fork_list().notify(ForkStage::kBefore);
            },
            [] {
                fork_list().notify(ForkStage::kInParent);
                fork_list().lock.unlock();
            },
            [] {
                fork_list().notify(ForkStage::kInChild);
                fork_list().lock.unlock();
            });
        return made;
    }();
    return *list;
}

}  // namespace

ForkWatch::ForkWatch(ForkRank rank, void* object, Act act) : rank_(rank), object_(object), act_(act)
{
    fork_list().add(*this);
}

ForkWatch::~ForkWatch() { fork_list().remove(*this); }

}  // namespace epode
