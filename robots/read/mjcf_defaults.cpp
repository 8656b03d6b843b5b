// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See mjcf_defaults.h.
#include "robots/read/mjcf_defaults.h"

namespace epode::robots {

namespace {

constexpr size_t kMaxClasses = 10'000;

// Under which name an element's defaults are kept.
std::string family_of(const std::string& element)
{
    static const std::set<std::string> actuators{"motor",  "position", "velocity", "general",  "intvelocity",
                                                 "damper", "cylinder", "muscle",   "adhesion", "plugin"};
    if (element == "fixed" || element == "spatial") return "tendon";
    return actuators.count(element) ? "actuator" : element;
}

}  // namespace

std::string Attributes::text(const char* name) const
{
    if (element_.has(name)) return element_.text(name);
    if (!defaults_) return {};
    const auto it = defaults_->find(name);
    return it == defaults_->end() ? std::string() : it->second;
}

void Defaults::read(const Element& element, Reading& reading)
{
    read_class(element, "main", "main", reading);
}

void Defaults::read_class(const Element& element, const std::string& name, const std::string& parent,
                          Reading& reading)
{
    if (classes_.size() > kMaxClasses) return;
    if (name != parent) classes_[name] = classes_[parent];
    Class& its = classes_[name];
    for (const Element& child : element.children()) {
        if (child.name() == "default") continue;
        Values& values = its[family_of(child.name())];
        for (const pugi::xml_attribute& attribute : child.node.attributes())
            values[attribute.name()] = attribute.value();
    }
    for (const Element& child : element.children("default")) {
        const std::string inner = child.text("class");
        if (inner.empty())
            reading.error(child, "a <default> within another one has no class");
        else
            read_class(child, inner, name, reading);
    }
}

Attributes Defaults::of(const Element& element, const std::string& inherited, Reading& reading) const
{
    std::string name = element.text("class");
    if (name.empty()) name = inherited.empty() ? "main" : inherited;
    const auto found = classes_.find(name);
    if (found == classes_.end()) {
        if (name != "main") reading.error(element, "there is no default class '" + name + "'");
        return {element, nullptr};
    }
    const auto values = found->second.find(family_of(element.name()));
    return {element, values == found->second.end() ? nullptr : &values->second};
}

}  // namespace epode::robots
