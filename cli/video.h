// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A video of a run: pictures at a fixed rate of simulated time, drawn by one renderer that keeps what it has.
#pragma once

#include <memory>
#include <string>

#include "cli/plan.h"

namespace epode::cli {

class Video {
  public:
    Video();
    ~Video();
    Video(const Video&) = delete;
    Video& operator=(const Video&) = delete;

    static bool possible();
    // A video that was not opened takes steps and does nothing.
    bool open(const std::string& path, double fps, const scenes::Scene& scene);
    bool step(const scenes::Scene& scene);
    bool close();
    const std::string& problem() const { return problem_; }
    // What there is to say about a video that came out otherwise than asked for; "" for nothing.
    std::string remark() const;

  private:
    struct Studio;
    std::unique_ptr<Studio> studio_;
    std::string problem_;
};

}  // namespace epode::cli
