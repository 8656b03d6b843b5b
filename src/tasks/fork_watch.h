// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Objects with locks and threads of their own survive a fork: before it every lock is taken, so that none is
// held by a thread that the child lacks; after it the parent gives them back, and the child also forgets the
// threads. Such an object has a ForkWatch as its last member, so that it is whole while it is watched.
#pragma once

namespace epode {

enum class ForkStage { kBefore, kInParent, kInChild };

// Objects of a later rank are locked later: they may be locked from inside those of an earlier one.
enum class ForkRank { kCallQueue, kServingPool };

class ForkWatch {
  public:
    using Act = void (*)(void* object, ForkStage stage);

    ForkWatch(ForkRank rank, void* object, Act act);
    ForkWatch(const ForkWatch&) = delete;
    ForkWatch& operator=(const ForkWatch&) = delete;
    ~ForkWatch();

  private:
    friend struct ForkList;
    ForkRank rank_;
    void* object_;
    Act act_;
    ForkWatch *previous_ = nullptr, *next_ = nullptr;
};

}  // namespace epode
