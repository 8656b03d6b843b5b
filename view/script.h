// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What a user would do, as text, for runs without a window: one line a frame.
//   key NAME          as in actions.h               frames N     nothing, N frames long
//   move X Y          the mouse, in pixels          wheel N      notches, forward is positive
//   down BUTTON, up BUTTON   left, right, middle    ctrl on|off
//   double X Y        a double click there          picture FILE what this frame shows
//   print             a line about the state, to standard output
// Empty lines and those that begin with # are passed over.
#pragma once

#include <string>
#include <vector>

#include "view/app.h"

namespace epode::view {

class Script {
  public:
    // False: problem has the line and what is wrong.
    bool load(const std::string& path, std::string& problem);
    bool parse(const std::string& text, std::string& problem);
    bool ended() const { return next_ >= lines_.size(); }
    // Before a frame. The file to which the frame is to be saved, mostly none.
    std::string play(App& app);

  private:
    struct Line {
        std::string verb, word;
        double x = 0, y = 0;
    };
    bool add(const std::string& text, std::string& problem);
    std::vector<Line> lines_;
    size_t next_ = 0;
    int waits_ = 0;
};

}  // namespace epode::view
