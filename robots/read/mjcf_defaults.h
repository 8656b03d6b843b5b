// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// MJCF's classes of defaults. A class has all that its parent has, with its own in place; an element asks its own
// attributes first, then those of its class. Actuators share one set, whatever their element is called.
#pragma once

#include "robots/read/reading.h"

namespace epode::robots {

using Values = std::map<std::string, std::string>;

// An element's attributes with those of its class behind them.
class Attributes {
  public:
    Attributes(const Element& element, const Values* defaults) : element_(element), defaults_(defaults) {}
    std::string text(const char* name) const;
    bool has(const char* name) const { return !text(name).empty(); }
    const Element& element() const { return element_; }

  private:
    Element element_;
    const Values* defaults_;
};

class Defaults {
  public:
    // A <default> of the document's root: of the class main, whatever it is called.
    void read(const Element& element, Reading& reading);
    // The class is that of the element, else `inherited`, else main. An error where there is none of that name.
    Attributes of(const Element& element, const std::string& inherited, Reading& reading) const;

  private:
    using Class = std::map<std::string, Values>;  // by element
    void read_class(const Element& element, const std::string& name, const std::string& parent,
                    Reading& reading);
    std::map<std::string, Class> classes_{{"main", {}}};
};

}  // namespace epode::robots
