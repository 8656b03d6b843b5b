// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Between a scene and whoever listens, a recording or a stage: hands the recorder what the scene knows of
// each state.
#pragma once

#include "record/watch/recorder.h"
#include "scenes/measure.h"

namespace epode::view {

class SceneRecorder {
  public:
    // Asks the scene for the forces of contacts.
    SceneRecorder(scenes::Scene& scene, record::Sink& sink);

    // The scene's state now, to which a step of dt led. Objects that came since the last one are recorded first.
    void state(const scenes::Quality& quality, double dt);

    // To report what is removed.
    record::Recorder& recorder() { return recorder_; }

  private:
    void add_new();

    const scenes::Scene& scene_;
    record::Recorder recorder_;
    size_t bodies_ = 0, geoms_ = 0, joints_ = 0;
    std::vector<record::ContactSeen> contacts_;
};

}  // namespace epode::view
