// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "step/finish.h"

#include <atomic>

#include "collide/space.h"
#include "dynamics/integrate.h"
#include "step/link.h"
#include "tasks/fetched.h"

namespace epode {
namespace {

class Finish {
  public:
    Finish(std::span<Body* const> bodies, const Continuous& continuous, Space* managed)
        : bodies_(bodies), continuous_(continuous), managed_(managed)
    {}

    // One after the other.
    void run()
    {
        walk(Tasks(1), [&](std::size_t, Body& body) { one(body); });
    }

    // What needs the caller's thread is left to it: `left` has room for a word on every body, all zero.
    void run(const Tasks& tasks, std::span<unsigned char> left)
    {
        std::atomic<bool> any_left{false};
        walk(tasks, [&](std::size_t i, Body& body) {
            if (!body.moved && (!moves_geoms(body) || mark_members(body, *managed_))) return rest(body);
            left[i] = 1;
            any_left.store(true, std::memory_order_relaxed);
        });
        members_marked(*managed_);
        for (std::size_t i = 0; any_left && i < bodies_.size(); ++i)
            if (left[i]) one(*bodies_[i]);
    }

  private:
    template <typename F>
    void walk(const Tasks& tasks, F&& f) const
    {
        constexpr int kLines = 9;  // with the rule of damping
        for_each_fetched<kLines>(tasks, bodies_, [&](std::size_t i, Body& body) {
            if (i + 3 < bodies_.size()) fetch_geoms(*bodies_[i + 3]);
            f(i, body);
        });
    }

    bool moves_geoms(const Body& body) const { return !continuous_.marked() || continuous_.stopped(body); }

    void one(Body& body) const
    {
        if (moves_geoms(body)) body_moved(body);
        if (body.moved) body.moved(to_handle(&body));
        rest(body);
    }

    static void rest(Body& body)
    {
        damp(body);
        store(body.facc, {});
        store(body.tacc, {});
        body.patched = body.patches != nullptr;
        body.patches = nullptr;
    }

    const std::span<Body* const> bodies_;
    const Continuous& continuous_;
    Space* const managed_;
};

}  // namespace

void finish_bodies(std::span<Body* const> bodies, const Continuous& continuous, Space* managed,
                   const Tasks& tasks, Arena& arena)
{
    Finish finish(bodies, continuous, managed);
    if (!managed || tasks.workers() == 1) return finish.run();
    Arena::Scope scope(arena);
    const auto left = arena.take_zeroed<unsigned char>(int(bodies.size()));
    arena.failed() ? finish.run() : finish.run(tasks, left);
}

}  // namespace epode
