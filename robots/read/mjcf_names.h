// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Whether what a file says is MJCF: elements and attributes that there are, and names that stand once. A word that is none is an
// error with the nearest word that is one, and so is a value that none of an attribute's keywords is; what only older versions of the format had is ignored, with a line in the report.
#pragma once

#include <map>
#include <string>

#include "robots/read/reading.h"

namespace epode::robots {

class MjcfNames {
  public:
    explicit MjcfNames(Reading& reading) : reading_(reading) {}

    // The element's attributes, and all that is in it. `path`: where it stands; body for what is in bodies, however deep.
    // Documents that it includes are left to the one who reads them, with path_of their <include>.
    void check(const Element& element, const std::string& path);
    // Of the children of an element that stands there.
    static std::string path_of(const std::string& parent, const std::string& element);

  private:
    void check_attributes(const Element& element, const std::string& path);
    void check_keywords(const Element& element);
    void check_name(const Element& element, const std::string& path);

    Reading& reading_;
    std::map<std::string, std::map<std::string, int>> lines_;  // by kind and name, where it stands
};

}  // namespace epode::robots
