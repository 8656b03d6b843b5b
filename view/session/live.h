// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A scene that is stepped while it is watched. Each step's state goes to the stage; going back puts the
// bodies where they were, with their velocities, whether they slept, the scene's time and the seed of dRand;
// to the bit, but for a last bit of a turn now and then, since the library normalises what it is given. Not
// brought back: what steppers and spaces keep from step to step, that is the forces that warm starting begins
// with (on by default: quick and fast steps taken again differ by about what their residuals say), world-managed
// contacts, timers of auto-disabling, the order in which a space reports its pairs. A step taken
// from an earlier state makes a new future: the old one is forgotten.
// Bodies are pulled by a damped spring, force f = k (target - p) - c v on a point p of the body that moves
// with v, with k = m w^2, c = 2 m w; m is the least mass that the point can answer with, 1 / (1/M + r^2 /
// I_min), so the spring stays stable wherever it is hooked in.
#pragma once

#include "scenes/causes.h"
#include "view/session/scene_recorder.h"
#include "view/session/session.h"

namespace epode::view {

struct LiveOptions {
    scenes::Stepper stepper = scenes::Stepper::kQuick;
    bool world_contacts = false;  // not of contact joints, where the scene makes none of its own
    double dt = 0.01;
    int iterations = 0;  // 0: the stepper's own
    int threads = 1;
    bool diagnose = false;  // look for causes of failure
    std::uint32_t seed = 1;
    size_t memory = size_t(256) << 20;  // bytes of states that are kept
};

class Live : public Session {
  public:
    Live(const scenes::Recipe& recipe, const LiveOptions& options);

    std::string title() const override { return scene_->recipe().name; }
    bool step() override;
    bool seek(size_t number) override;
    void restart() override;
    std::optional<Hit> pick(Vec origin, Vec direction) override;
    Live* live() override { return this; }

    // All may change between any two steps.
    LiveOptions options;
    const scenes::Scene& scene() const { return *scene_; }
    bool failed() const { return failed_; }
    // What the steps since it was wanted, or since the last jump in time, have shown.
    std::vector<scenes::Cause> causes() const;

    // Hooks the spring into the body at a point of the world; then the point is pulled to where it is wanted,
    // in every step, until released.
    void grab(std::int32_t body, Vec point);
    void pull_to(Vec target) { target_ = target; }
    void release() { grabbed_ = record::kNobody; }
    std::int32_t grabbed() const { return grabbed_; }
    Vec hook() const;  // where the hooked point is now
    Vec target() const { return target_; }
    // Changes the body's velocity at once, as a blow of `impulse` N s at a point of the world would.
    void push(std::int32_t body, Vec point, Vec impulse);
    // A new ball that flies; it is there from the next step on. Back before that, it waits aside, without a
    // geom that touches; a step taken from there makes a future without it.
    void shoot(Vec from, Vec velocity, double radius, double mass);

  private:
    double next_dt() const override { return failed_ ? 0 : options.dt; }
    void build();
    void sample();
    void pull();
    struct Shot {
        dBodyID body;
        dGeomID geom;
        size_t number;  // of the body
        bool aside = false, forgotten = false;
    };
    void put_aside(Shot& shot, bool aside);
    void forget_shots_aside();
    dBodyID body(std::int32_t number) const { return scene_->bodies()[size_t(number)]; }

    const scenes::Recipe& recipe_;
    std::unique_ptr<scenes::Scene> scene_;
    std::unique_ptr<SceneRecorder> recorder_;
    std::vector<Shot> shots_;
    bool failed_ = false;
    std::int32_t grabbed_ = record::kNobody;
    Vec local_hook_, target_;
};

}  // namespace epode::view
