// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The files of a recording that a run writes on its way: .epr while it goes, .glb and pages when it is over.
#pragma once

#include <memory>

#include "cli/plan.h"
#include "record/file/writer.h"
#include "scenes/causes.h"
#include "view/session/scene_recorder.h"

namespace epode::cli {

class Outputs {
  public:
    // False when a file cannot be written; problem() names it. Nothing was asked for: nothing is recorded.
    bool open(const RunOptions& options, const RunPlan& plan, scenes::Scene& scene);
    void step(const scenes::Quality& quality);
    // What is known about why it went as it did; nothing is added of no causes.
    void diagnosis(const std::vector<scenes::Cause>& causes);
    bool close();
    const std::string& problem() const { return problem_; }

  private:
    // Tells everything to all of its sinks.
    class Fan : public record::Sink {
      public:
        std::vector<record::Sink*> sinks;
        void info(const record::Info& info) override;
        void shape(const record::Shape& shape) override;
        void body(const record::Body& body) override;
        void geom(const record::Geom& geom) override;
        void joint(const record::Joint& joint) override;
        void gone(record::ObjectKind kind, std::uint32_t number) override;
        void moved(std::uint32_t geom, std::int32_t body, const record::Pose& pose) override;
        void calls(const record::CallBlock& block) override;
        void step(const record::Step& step) override;
    };
    bool fail(const std::string& path, const std::string& why);

    Fan fan_;
    std::vector<std::pair<std::string, std::unique_ptr<record::FileWriter>>> files_;
    std::vector<std::string> exports_;  // written from memory at the end
    std::unique_ptr<record::Recording> memory_;
    std::unique_ptr<view::SceneRecorder> recorder_;
    double fps_ = 30, dt_ = 0;
    std::string problem_;
};

}  // namespace epode::cli
