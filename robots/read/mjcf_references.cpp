// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See mjcf_references.h.
#include "robots/read/mjcf_references.h"

#include <algorithm>

namespace epode::robots {

namespace {

// Ways from the root (or where they begin), attributes, and the kind whose names they are.
struct ReferenceRow {
    const char *path, *attributes, *kind;
};

constexpr ReferenceRow kReferences[] = {
    {"body/geom", "material", "material"},
    {"body/site", "material", "material"},
    {"body/camera", "target", "body"},
    {"body/light", "target", "body"},
    {"asset/material", "texture", "texture"},
    {"contact/", "body1 body2", "body"},
    {"contact/", "geom1 geom2", "geom"},
    {"equality/", "body1 body2", "body"},
    {"equality/", "joint1 joint2", "joint"},
    {"equality/", "site1 site2", "site"},
    {"equality/", "tendon1 tendon2", "tendon"},
    {"tendon/spatial", "material", "material"},
    {"tendon/spatial/", "site sidesite", "site"},
    {"tendon/spatial/geom", "geom", "geom"},
    {"tendon/fixed/joint", "joint", "joint"},
    {"actuator/", "joint jointinparent", "joint"},
    {"actuator/", "site refsite cranksite slidersite", "site"},
    {"actuator/", "tendon", "tendon"},
    {"actuator/", "body", "body"},
    {"sensor/", "joint", "joint"},
    {"sensor/", "site", "site"},
    {"sensor/", "tendon", "tendon"},
    {"sensor/", "actuator", "actuator"},
    {"sensor/", "body body1 body2", "body"},
    {"sensor/", "geom geom1 geom2", "geom"},
    {"sensor/", "camera", "camera"},
};
// Types of objects of sensors and tuples by name, where they are not the kind.
const std::string& kind_of_type(const std::string& type)
{
    static const std::map<std::string, std::string> other{{"xbody", "body"}, {"connect", "equality"}};
    const auto found = other.find(type);
    return found == other.end() ? type : found->second;
}

bool is_at(const std::string& path, const std::string& where)
{
    return where.back() == '/' ? path.starts_with(where) : path == where;
}

bool begins_with_any(const std::string& name, const std::vector<std::string>& begins)
{
    return std::any_of(begins.begin(), begins.end(),
                       [&](const std::string& begin) { return name.starts_with(begin); });
}

// Files and lines of the errors that there are.
std::set<std::pair<std::string, int>> places_of_errors(const Reading& reading)
{
    std::set<std::pair<std::string, int>> out;
    for (const ReportLine& line : reading.model.report)
        if (line.note == Note::kError) out.insert({line.file, line.line});
    return out;
}

}  // namespace

void MjcfReferences::note(const Element& element, const std::string& path)
{
    if (path == "body/attach") prefixes_.push_back(element.text("prefix"));
    const auto add = [&](const std::string& attribute, const std::string& kind) {
        const std::string name = element.text(attribute.c_str());
        if (!name.empty()) all_.push_back({element, attribute, kind, name});
    };
    for (const ReferenceRow& row : kReferences)
        if (is_at(path, row.path))
            for (const std::string& attribute : words_of(row.attributes)) add(attribute, row.kind);
    if (!path.starts_with("sensor/") && path != "custom/tuple/element") return;
    add("objname", kind_of_type(element.text("objtype")));
    add("refname", kind_of_type(element.text("reftype")));
}

// Where an element has an error already, that one is enough; of many wrong names the first get advice.
void MjcfReferences::judge(const std::vector<std::string>& begins, Reading& reading) const
{
    constexpr int kMaxAdvice = 20;
    static const Words none;
    const auto known = places_of_errors(reading);
    int count = 0;
    for (const auto& [element, attribute, kind, name] : all_) {
        const auto found = names_.find(kind);
        const Words& names = found == names_.end() ? none : found->second;
        if (names.count(name) || (kind == "body" && name == "world")) continue;
        if (begins_with_any(name, begins) || begins_with_any(name, prefixes_)) continue;
        if (known.count({element.file(), element.line()})) continue;
        reading.error(element, "<" + element.name() + "> " + attribute + " is '" + name.substr(0, 60) +
                                   "', and no " + kind.substr(0, 40) + " is called so" +
                                   (++count <= kMaxAdvice ? advice(name, names) : ""));
    }
}

}  // namespace epode::robots
