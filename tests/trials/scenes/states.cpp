// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A world that is given a state back goes on with the same bits: itself, another one of the same structure, one from a file, with
// other threads.
#include "measure.h"

#include <cstdint>
#include <cstring>
#include <memory>

namespace epode::trials {

namespace {

constexpr int kFrames = 160, kSnapshot = 90;

// Stacks that touch, and a kinematic box that shoves them to and fro.
struct Shove {
    Stage stage;
    dBodyID driver = nullptr;

    explicit Shove(const Run& run, bool filled = true) : stage(run)
    {
        if (!filled) return;
        stage.surface.friction = 0.5;
        stage.floor();
        driver = stage.box({0.5, 3, 1}, 1, {-0.55, 1, 0.55});
        dBodySetKinematic(driver);
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 4; ++j)
                for (int k = 0; k < 3; ++k) stage.box({0.5, 0.5, 0.5}, 1, {0.5 * i, 0.5 * j, 0.25 + 0.5 * k});
    }
    void step(int frame)
    {
        dBodySetLinearVel(driver, 1.5 * std::sin(0.05 * frame), 0, 0);
        stage.step();
    }
    std::uint64_t hash() const
    {
        std::uint64_t hash = 14695981039346656037u;
        const auto add = [&](const dReal* numbers, int count) {
            unsigned char bytes[4 * sizeof(dReal)];
            std::memcpy(bytes, numbers, size_t(count) * sizeof(dReal));
            for (size_t i = 0; i < size_t(count) * sizeof(dReal); ++i)
                hash = (hash ^ bytes[i]) * 1099511628211u;
        };
        for (dBodyID body : bodies_of(stage.world)) {
            add(dBodyGetPosition(body), 3);
            add(dBodyGetQuaternion(body), 4);
            add(dBodyGetLinearVel(body), 3);
            add(dBodyGetAngularVel(body), 3);
        }
        return hash;
    }
    std::vector<char> state() const
    {
        std::vector<char> bytes(dWorldGetStateSize(stage.world));
        dWorldGetState(stage.world, bytes.data(), bytes.size());
        return bytes;
    }
    bool restore(const std::vector<char>& bytes)
    {
        return dWorldSetState(stage.world, bytes.data(), bytes.size());
    }
};

class Continuation {
  public:
    explicit Continuation(Run& run) : run_(run), first_(run)
    {
        for (int frame = 0; frame < kFrames; ++frame) {
            if (frame == kSnapshot) {
                state_ = first_.state();
                file_.resize(dWorldSaveToBuffer(first_.stage.world, first_.stage.space, nullptr, 0));
                dWorldSaveToBuffer(first_.stage.world, first_.stage.space, file_.data(), file_.size());
            }
            first_.step(frame);
            hashes_.push_back(first_.hash());
        }
    }
    void again()
    {
        for (int more : {0, 7}) {
            judge(first_, first_.restore(state_), kSnapshot + (more ? more : kFrames - kSnapshot));
        }
        judge(first_, first_.restore(state_), kFrames);
    }
    void elsewhere(int threads)
    {
        Shove other(run_);
        dWorldSetStepThreads(other.stage.world, threads);
        judge(other, other.restore(state_), kFrames);
    }
    // A crate comes and goes between two restorations.
    void with_a_guest()
    {
        bool fine = first_.restore(state_);
        const dBodyID guest = first_.stage.box({0.5, 0.5, 0.5}, 1, {5, 5, 0.25});
        for (int frame = kSnapshot; frame < kSnapshot + 5; ++frame) first_.step(frame);
        dGeomDestroy(dBodyGetFirstGeom(guest));
        dBodyDestroy(guest);
        fine = fine && first_.restore(state_);
        judge(first_, fine, kFrames);
    }
    void from_file()
    {
        Shove other(run_, false);
        dSpaceID space = nullptr;
        const dWorldID world = dWorldLoadFromBuffer(file_.data(), file_.size(), &space);
        if (!world) return run_.record("differ", kFrames);
        other.stage.adopt(world, space);
        other.driver = bodies_of(world).front();
        judge(other, true, kFrames);
    }

  private:
    void judge(Shove& world, bool restored, int until)
    {
        int differ = restored ? 0 : kFrames;
        for (int frame = kSnapshot; restored && frame < until; ++frame) {
            world.step(frame);
            differ += world.hash() != hashes_[size_t(frame)];
        }
        run_.record("differ", differ);
    }

    Run& run_;
    Shove first_;
    std::vector<std::uint64_t> hashes_;
    std::vector<char> state_, file_;
};

void restore_all(Run& run)
{
    Continuation continuation(run);
    continuation.again();
    continuation.with_a_guest();
    continuation.from_file();
    for (int threads : {1, 4}) continuation.elsewhere(threads);
}

}  // namespace

extern const Scene kSnapshots{
    "States and events",
    "snapshots",
    "36 crates are shoved by a kinematic box; the state of step 90 is restored in six ways (C6)",
    {{"differ", "steps with other bits than those of the first run", "1", 0}},
    &restore_all,
    false,
    true};

}  // namespace epode::trials
