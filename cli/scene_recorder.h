// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Between a scene and a recording: after each step it hands the recorder what the scene knows.
#pragma once

#include "cli/plan.h"
#include "record/recorder.h"
#include "scenes/measure.h"

namespace epode::cli {

class SceneRecorder {
  public:
    // Records the state at once, as step 0.
    SceneRecorder(scenes::Scene& scene, const RunPlan& plan, record::Sink& sink);
    void step(const scenes::Quality& quality);

  private:
    void add_new();
    void sample(const scenes::Quality& quality, double ms);

    scenes::Scene& scene_;
    const RunPlan& plan_;
    record::Recorder recorder_;
    size_t bodies_ = 0, geoms_ = 0, joints_ = 0;
    std::vector<record::ContactSeen> contacts_;
};

// What makes the same run again.
record::Info about(const scenes::Scene& scene, const RunPlan& plan);
// The opposite: false and why where the recording does not come from a scene.
bool options_from(const record::Info& info, RunOptions& options, std::string& problem);

}  // namespace epode::cli
