// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See mjcf_user_data.h.
#include "robots/read/mjcf_user_data.h"

#include <cstring>

namespace epode::robots {

namespace {

// The attribute of <size> that limits the numbers of an element, also of one in a default class; empty: none does.
std::string limit_of(const std::string& path, const std::string& element)
{
    static const std::map<std::string, std::string> kinds{{"joint", "nuser_jnt"},
                                                          {"freejoint", "nuser_jnt"},
                                                          {"geom", "nuser_geom"},
                                                          {"site", "nuser_site"},
                                                          {"camera", "nuser_cam"}};
    if (path == "body") return element == "body" ? "nuser_body" : "";
    for (const char* section : {"actuator", "sensor", "tendon"})
        if (path.starts_with(section) && path.size() > std::strlen(section))
            return std::string("nuser_") + section;
    const auto found = kinds.find(element);
    return found == kinds.end() ? "" : found->second;
}

}  // namespace

void MjcfUserData::note(const Element& element, const std::string& path, Reading& reading)
{
    if (path == "size")
        for (const pugi::xml_attribute& attribute : element.node.attributes())
            if (std::strncmp(attribute.name(), "nuser_", 6) == 0)
                reading.number(element, attribute.name(), limits_[attribute.name()]);
    const std::string limit = limit_of(path, element.name());
    if (limit.empty() || !element.has("user")) return;
    std::vector<double> values;
    reading.numbers(element, element.text("user"), "user", 0, 1'000'000, values);
    Largest& largest = largest_[limit];
    if (values.size() > largest.count) largest = {element, values.size()};
}

void MjcfUserData::judge(Reading& reading) const
{
    for (const auto& [kind, largest] : largest_)
        if (const auto limit = limits_.find(kind);
            limit != limits_.end() && limit->second >= 0 && double(largest.count) > limit->second)
            reading.error(largest.element, "<" + largest.element.name() + "> user has " +
                                               std::to_string(largest.count) + " numbers, and <size> " +
                                               kind + " is " +
                                               std::to_string(int(std::min(limit->second, 1e9))));
}

}  // namespace epode::robots
