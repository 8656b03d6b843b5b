// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A recording that is played: every state is there, none is computed.
#pragma once

#include "view/session/session.h"

namespace epode::view {

class Playback : public Session {
  public:
    // Null and a problem in words where the file cannot be read or holds no state. One that breaks off is
    // played as far as it goes; the problem is reported too.
    static std::unique_ptr<Playback> open(const std::string& path, std::string& problem);

    std::string title() const override { return title_; }
    bool step() override { return now_ < stage_->last() && seek(now_ + 1); }
    bool seek(size_t number) override;
    void restart() override { now_ = stage_->first(); }
    std::optional<Hit> pick(Vec origin, Vec direction) override;

  private:
    double next_dt() const override;
    std::string title_;
};

}  // namespace epode::view
