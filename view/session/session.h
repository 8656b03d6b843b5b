// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A run that is being looked at: a scene that is stepped (live.h) or a recording that is played
// (playback.h). Time passes as the clock does, times a factor; it can be stopped, taken step by step, turned
// back and begun again. No window, no OpenGL: all that a key or a panel can do is done here and tested
// without them.
#pragma once

#include <algorithm>
#include <memory>
#include <optional>
#include <string>

#include "view/session/stage.h"

namespace epode::view {

struct Hit {
    std::uint32_t geom = record::kNoGeom;
    std::int32_t body = record::kNobody;  // of the geom; kNobody: it is static
    Vec point;
    double distance = 0;
};

class Live;

class Session {
  public:
    virtual ~Session() = default;

    const Stage& stage() const { return *stage_; }
    // The number of the state that is shown.
    size_t now() const { return now_; }
    const State& state() const { return stage_->at(now_); }
    Moment moment() const { return stage_->moment(now_); }
    virtual std::string title() const = 0;

    bool paused = false;
    double speed = 1;
    static constexpr double kSlowest = 1.0 / 64, kFastest = 64;
    void faster() { speed = std::min(speed * 2, kFastest); }
    void slower() { speed = std::max(speed / 2, kSlowest); }

    // As many steps as `seconds` of the clock are worth, unless paused; no longer than about
    // `max_seconds` of computing: a scene that is too heavy falls behind rather than freezing the window.
    void pass(double seconds, double max_seconds = 0.05);

    // To the next state; false where there is none (the recording ends, the step failed).
    virtual bool step() = 0;
    // To the state before, as far as states are kept.
    bool step_back() { return now_ > stage_->first() && seek(now_ - 1); }
    virtual bool seek(size_t number) = 0;
    virtual void restart() = 0;

    // What a ray from `origin` meets first.
    virtual std::optional<Hit> pick(Vec origin, Vec direction) = 0;
    // Of a joint, by its number.
    std::vector<record::Limit> limits(std::uint32_t joint) const;
    // Null: a recording, which cannot be touched.
    virtual Live* live() { return nullptr; }

  protected:
    std::unique_ptr<Stage> stage_;
    size_t now_ = 0;

  private:
    // Length of the step that comes next, s; 0: none comes.
    virtual double next_dt() const = 0;
    double owed_ = 0;  // seconds of the run that are due
};

}  // namespace epode::view
