// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Names that elements of MJCF refer to. All are collected while elements are checked, for what they name may stand behind them or in
// a file that is included later, and judged at the end: a name that nothing of its kind has is an error, with the nearest one.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "robots/read/reading.h"
#include "robots/read/words.h"

namespace epode::robots {

class MjcfReferences {
  public:
    // An element's name, of a kind: body, joint, geom, actuator ...
    void add_name(const std::string& kind, const std::string& name) { names_[kind].insert(name); }
    // What an element refers to.
    void note(const Element& element, const std::string& path);
    // Names that begin with one of these are those of copies or of attached models: they are not judged.
    void judge(const std::vector<std::string>& begins, Reading& reading) const;

  private:
    struct Reference {
        Element element;
        std::string attribute, kind, name;
    };

    std::map<std::string, Words> names_;
    std::vector<Reference> all_;
    std::vector<std::string> prefixes_;  // of <attach>
};

}  // namespace epode::robots
