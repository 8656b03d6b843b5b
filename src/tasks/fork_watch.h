// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Objects with locks and threads of their own survive a fork. Before it every lock is taken, so that none is
// held by a thread that the child lacks. Afterwards the parent releases them; the child does too and forgets
// the threads. Such an object has a ForkWatch as its last member, so that it is fully constructed while it is
// watched.
#pragma once

namespace epode {

enum class ForkStage { kBefore, kInParent, kInChild };

// Objects of a later rank are locked later: an object of an earlier rank may lock them while it is locked.
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
