// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See mjcf_defaults.h.
#include "robots/read/mjcf_defaults.h"

#include <sstream>

#include "robots/numbers.h"

namespace epode::robots {

namespace {

constexpr size_t kMaxClasses = 10'000;

bool is_actuator(const std::string& element)
{
    static const std::set<std::string> actuators{"motor",  "position", "velocity", "general",  "intvelocity",
                                                 "damper", "cylinder", "muscle",   "adhesion", "plugin"};
    return actuators.count(element) > 0;
}

// Under which name an element's defaults are kept, and the gains of a kind of actuator.
std::string family_of(const std::string& element)
{
    if (element == "fixed" || element == "spatial") return "tendon";
    return is_actuator(element) ? "actuator" : element;
}
std::string gains_of(const std::string& kind) { return "gains of " + kind; }

bool is_gain(const std::string& attribute)
{
    static const std::set<std::string> gains{"kp",       "kv",      "dampratio", "timeconst", "area",
                                             "diameter", "bias",    "gainprm",   "biasprm",   "gaintype",
                                             "biastype", "dyntype", "dynprm"};
    return gains.count(attribute) > 0;
}

double number_at(const Values& values, const char* name, size_t i, double otherwise)
{
    std::vector<double> numbers;
    const auto it = values.find(name);
    return it != values.end() && parse_numbers(it->second, numbers) && i < numbers.size() ? numbers[i]
                                                                                          : otherwise;
}

// What a <general> element would say.
Values in_general(const std::string& kind, const Values& gains)
{
    Values out;
    const double kp = number_at(gains, "kp", 0, 1), kv = number_at(gains, "kv", 0, kind == "velocity");
    if (kind == "velocity")
        out = {{"gainprm", text_of(kv)}, {"biastype", "affine"}, {"biasprm", "0 0 " + text_of(-kv)}};
    else if (kind == "position" || kind == "intvelocity")
        out = {{"gainprm", text_of(kp)},
               {"biastype", "affine"},
               {"biasprm", "0 " + text_of(-kp) + " " + text_of(-kv)}};
    if (kind == "intvelocity") out["dyntype"] = "integrator";
    if (const auto time = gains.find("timeconst"); kind == "position" && time != gains.end())
        out["dyntype"] = "filterexact", out["dynprm"] = time->second;
    return out;
}

// And what another kind takes from a <general> default.
Values from_general(const std::string& kind, const Values& general)
{
    if (kind == "velocity") return {{"kv", text_of(number_at(general, "gainprm", 0, 1))}};
    Values out{{"kp", text_of(number_at(general, "gainprm", 0, 1))}};
    const double damping = number_at(general, "biasprm", 2, 0);
    if (damping < 0) out["kv"] = text_of(-damping);
    if (damping > 0) out["dampratio"] = text_of(damping);
    return out;
}

// Lists that may be shorter than they could be.
bool may_be_short(const std::string& name)
{
    static const std::set<std::string> lists{"solref",         "solimp",         "solreflimit", "solimplimit",
                                             "solreffriction", "solimpfriction", "friction",    "gainprm",
                                             "biasprm",        "dynprm",         "gear",        "size",
                                             "polycoef",       "stiffness",      "damping"};
    return lists.count(name) > 0;
}

// A list that is shorter than the class's goes on with the class's numbers.
std::string completed(const std::string& name, const std::string& text, const std::string& behind)
{
    if (behind.empty() || !may_be_short(name)) return text;
    std::istringstream its(text), others(behind);
    std::string number, out = text;
    while (its >> number) others >> number;
    while (others >> number) out += " " + number;
    return out;
}

}  // namespace

std::string Attributes::text(const char* name) const
{
    if (!element_.has(name)) return text_of_class(name);
    const std::string its = element_.text(name);
    return may_be_short(name) ? completed(name, its, text_of_class(name)) : its;
}

std::string Attributes::text_of_class(const char* name) const
{
    for (const Values* values : {gains_, defaults_})
        if (values)
            if (const auto it = values->find(name); it != values->end()) return it->second;
    return {};
}

static void set(Values& values, const pugi::xml_attribute& attribute)
{
    std::string& its = values[attribute.name()];
    its = completed(attribute.name(), attribute.value(), its);
}

void Defaults::read(const Element& element, Reading& reading)
{
    read_class(element, "main", "main", reading);
}

// `kind`: that of the gains which the class has so far, or empty.
void Defaults::read_actuator(const Element& element, const Class& parent, std::string& kind, Class& its)
{
    const std::string now = element.name(), general = gains_of("general");
    if (!kind.empty() && kind != now) {
        const auto old = parent.find(gains_of(kind));
        its[gains_of(kind)] = old == parent.end() ? Values{} : old->second;
    }
    kind = now;
    for (const pugi::xml_attribute& attribute : element.node.attributes())
        set(its[is_gain(attribute.name()) ? gains_of(now) : "actuator"], attribute);
    if (now != "general") {
        its[general] = in_general(now, its[gains_of(now)]);
        return;
    }
    for (const char* other : {"position", "intvelocity", "velocity"})
        its[gains_of(other)] = from_general(other, its[general]);
}

void Defaults::read_class(const Element& element, const std::string& name, const std::string& parent,
                          Reading& reading)
{
    if (classes_.size() > kMaxClasses) return;
    if (name != parent) classes_[name] = classes_[parent];
    Class& its = classes_[name];
    const Class before = its;
    std::string kind;
    for (const Element& child : element.children()) {
        if (child.name() == "default") continue;
        if (is_actuator(child.name())) {
            read_actuator(child, before, kind, its);
            continue;
        }
        Values& values = its[family_of(child.name())];
        for (const pugi::xml_attribute& attribute : child.node.attributes()) set(values, attribute);
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
    const auto values = [&](const std::string& of) {
        const auto it = found->second.find(of);
        return it == found->second.end() ? nullptr : &it->second;
    };
    const std::string family = family_of(element.name());
    return {element, values(family), family == "actuator" ? values(gains_of(element.name())) : nullptr};
}

}  // namespace epode::robots
