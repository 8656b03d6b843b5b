// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// MJCF's classes of defaults. A class has all that its parent has, with its own in place; an element asks its own
// attributes first, then those of its class.
//
// Actuators share one set, whatever their element is called, but for their gains: those of a class are of one kind, the last
// that it names, and another kind has its parent's. A <general> element takes gains of any kind, in its own terms, and those
// of a <general> default serve all kinds but motors (as MuJoCo 4.0 compiles them).
#pragma once

#include "robots/read/reading.h"

namespace epode::robots {

using Values = std::map<std::string, std::string>;

// An element's attributes with those of its class behind them.
class Attributes {
  public:
    // `gains`: of an actuator's kind.
    Attributes(const Element& element, const Values* defaults, const Values* gains = nullptr)
        : element_(element), defaults_(defaults), gains_(gains)
    {}
    std::string text(const char* name) const;
    bool has(const char* name) const { return !text(name).empty(); }
    const Element& element() const { return element_; }

  private:
    std::string text_of_class(const char* name) const;

    Element element_;
    const Values *defaults_, *gains_;
};

class Defaults {
  public:
    // A <default> of the document's root: of the class main, whatever it is called.
    void read(const Element& element, Reading& reading);
    // The class is that of the element, else `inherited`, else main. An error where there is none of that name.
    Attributes of(const Element& element, const std::string& inherited, Reading& reading) const;

  private:
    using Class = std::map<std::string, Values>;  // by element
    static void read_actuator(const Element& element, const Class& parent, std::string& kind, Class& its);
    void read_class(const Element& element, const std::string& name, const std::string& parent,
                    Reading& reading);
    std::map<std::string, Class> classes_{{"main", {}}};
};

}  // namespace epode::robots
