// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A scene runs in a setting and measures how far it is off its laws: each law has a figure, one number with a
// unit, and a bound that the figure must not exceed. Where the guide says that a method cannot keep a bound, the
// law names the weaker one that it does keep and the page that says so.
#pragma once

#include "setting.h"

#include <cmath>
#include <map>
#include <string>
#include <vector>

namespace epode::trials {

// A number, or a function of the setting where the law is one of the step size.
class Bound {
  public:
    Bound(double value) : value_(value) {}
    Bound(int value) : value_(value) {}
    Bound(double (*function)(const Setting&)) : function_(function) {}
    double operator()(const Setting& setting) const { return function_ ? function_(setting) : value_; }

  private:
    double value_ = 0;
    double (*function_)(const Setting&) = nullptr;
};

struct Weaker {
    unsigned methods;
    Bound bound;
    const char* reason;  // what the guide says, and where
};

struct Law {
    const char* name;
    const char* text;  // what is measured, and the right value
    const char* unit;
    Bound bound;
    std::vector<Weaker> weaker = {};

    double kept(const Setting& setting) const;         // the bound that the method keeps
    const char* reason(const Setting& setting) const;  // of a weaker bound, or null
};

class Run;

struct Scene {
    const char* subject;  // scenes of a subject stand together in the table
    const char* name;
    const char* title;
    std::vector<Law> laws;
    void (*run)(Run&);
    // What no setting changes: queries, refusals. Runs once.
    bool one_setting = false;
    bool takes_long = false;  // ctest leaves it to scripts/nightly

    const Law* law(const std::string& name) const;
};

const std::vector<const Scene*>& all_scenes();
const Scene* scene_named(const std::string& name);
// The cells that ctest checks.
bool is_quick(const Scene& scene, const Setting& setting);

// One scene in one setting. A figure that is recorded twice is the worse of both; what is not a number is
// infinite.
class Run {
  public:
    Run(const Scene& scene, const Setting& where) : setting(where), scene_(scene) {}
    void record(const char* law, double value);
    const std::map<std::string, double>& figures() const { return figures_; }

    const Setting setting;

  private:
    const Scene& scene_;
    std::map<std::string, double> figures_;
};

}  // namespace epode::trials
