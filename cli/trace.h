// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The trace of a run: a CSV file, one line per step under one line of names, so that any plotting program
// reads it.
#pragma once

#include <cstdio>
#include <string>

#include "scenes/measure.h"

namespace epode::cli {

class Trace {
  public:
    Trace() = default;
    ~Trace();
    Trace(const Trace&) = delete;
    Trace& operator=(const Trace&) = delete;

    // A trace that was not opened takes rows and does nothing.
    bool open(const std::string& path, const scenes::Scene& scene);
    void add(const scenes::Scene& scene, const scenes::Quality& quality, const scenes::RunRecord& record);
    // False when anything could not be written.
    bool close();
    const std::string& problem() const { return problem_; }

  private:
    void put_line(const std::string& line);
    std::FILE* file_ = nullptr;
    std::string problem_;
};

}  // namespace epode::cli
