// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// One line on stderr that says how far a long run is. It appears only where a person looks (a terminal) and
// only after a second, so short runs stay clean; where stderr is a file or a pipe, a run of more than two
// seconds writes a plain line every ten.
#pragma once

#include <chrono>
#include <string>

namespace epode::cli {

class Progress {
  public:
    Progress(std::string name, int steps, bool wanted);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    void show(int done, size_t contacts);

  private:
    std::string name_;
    int steps_;
    bool wanted_, terminal_, drawn_ = false;
    std::chrono::steady_clock::time_point start_, next_;
};

}  // namespace epode::cli
