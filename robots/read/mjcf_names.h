// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Whether what a file says is MJCF: elements and attributes that there are, and names that stand once. A word that is none is an
// error with the nearest word that is one, and so are values (mjcf_values.h), references (mjcf_references.h) and numbers of the user's
// (mjcf_user_data.h) that MuJoCo would not take; what only older versions of the format had is ignored, with a line in the report.
#pragma once

#include <map>
#include <string>

#include "robots/read/mjcf_references.h"
#include "robots/read/mjcf_user_data.h"
#include "robots/read/reading.h"

namespace epode::robots {

class MjcfNames {
  public:
    explicit MjcfNames(Reading& reading) : reading_(reading) {}

    // The element's attributes, and all that is in it. `path`: where it stands; body for what is in bodies, however deep.
    // Documents that it includes are left to the one who reads them, with path_of their <include>.
    void check(const Element& element, const std::string& path);
    // After all of the file: what its elements refer to. Names that begin with one of these are not judged.
    void judge(const std::vector<std::string>& begins);
    // Of the children of an element that stands there.
    static std::string path_of(const std::string& parent, const std::string& element);

  private:
    void check_attributes(const Element& element, const std::string& path);
    void check_name(const Element& element, const std::string& path);

    Reading& reading_;
    MjcfReferences references_;
    MjcfUserData user_data_;
    std::map<std::string, std::map<std::string, int>> lines_;  // by kind and name, where it stands
};

}  // namespace epode::robots
