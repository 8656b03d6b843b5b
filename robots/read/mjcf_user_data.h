// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The numbers that elements of MJCF have for their user's own purposes, which nothing here uses: <size> may say how many there are at
// most of each kind, and more, or what is no number, is an error.
#pragma once

#include <map>
#include <string>

#include "robots/read/reading.h"

namespace epode::robots {

class MjcfUserData {
  public:
    void note(const Element& element, const std::string& path, Reading& reading);
    // After all of the file.
    void judge(Reading& reading) const;

  private:
    struct Largest {
        Element element;
        size_t count = 0;
    };

    std::map<std::string, Largest> largest_;  // by the attribute of <size>
    std::map<std::string, double> limits_;    // -1: none
};

}  // namespace epode::robots
