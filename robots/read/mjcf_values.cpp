// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See mjcf_values.h.
#include "robots/read/mjcf_values.h"

#include <cstring>

namespace epode::robots {

namespace {

struct Keywords {
    const char *element, *words, *attributes;
};
struct Required {
    const char *attributes, *paths;
};

// clang-format off
constexpr Keywords kKeywords[] = {
#include "robots/read/mjcf_keywords.inc"
};
constexpr Required kRequired[] = {
#include "robots/read/mjcf_required.inc"
};
// clang-format on

// Attributes that stand together or not at all.
constexpr const char* kPairs[][3] = {{"sensor/", "reftype", "refname"},
                                     {"sensor/user", "objtype", "objname"},
                                     {"custom/", "objtype", "objname"}};
// Of which at most one may stand in an element.
const Words& orientations()
{
    static const Words words{"quat", "axisangle", "xyaxes", "zaxis", "euler"};
    return words;
}

using Table = std::map<std::string, std::map<std::string, Words>>;  // by element and attribute

Table keyword_table()
{
    Table out;
    for (const Keywords& row : kKeywords)
        for (const std::string& attribute : words_of(row.attributes))
            out[row.element][attribute] = words_of(row.words);
    return out;
}

std::map<std::string, Words> required_table()
{
    std::map<std::string, Words> out;
    for (const Required& row : kRequired)
        for (const std::string& path : words_of(row.paths)) out[path] = words_of(row.attributes);
    return out;
}

std::string tag_of(const Element& element) { return "<" + element.name().substr(0, 40) + ">"; }

std::string listed(const Words& words)
{
    std::string out;
    for (const std::string& word : words) out += (out.empty() ? "" : " ") + word;
    return out;
}

void check_keywords(const Element& element, Reading& reading)
{
    for (const pugi::xml_attribute& attribute : element.node.attributes()) {
        const Words* const words = keywords_of(element.name(), attribute.name());
        const std::string value = attribute.value();
        if (words && !words->count(value))
            reading.error(element, tag_of(element) + " " + attribute.name() + " is '" + value.substr(0, 60) +
                                       "', and there are " + listed(*words) + advice(value, *words));
    }
}

void check_required(const Element& element, const std::string& path, Reading& reading)
{
    static const std::map<std::string, Words> table = required_table();
    if (const auto found = table.find(path); found != table.end())
        for (const std::string& attribute : found->second)
            if (!element.has(attribute.c_str()))
                reading.error(element, tag_of(element) + " has no '" + attribute + "', and needs one");
    for (const auto& [where, one, other] : kPairs)
        if (path.starts_with(where) && element.has(one) != element.has(other))
            reading.error(element, tag_of(element) + " has only one of '" + one + "' and '" + other + "'");
}

void check_orientation(const Element& element, Reading& reading)
{
    std::string before;
    for (const pugi::xml_attribute& attribute : element.node.attributes()) {
        if (!orientations().count(attribute.name())) continue;
        if (!before.empty())
            reading.error(element, tag_of(element) + " has '" + before + "' and '" + attribute.name() +
                                       "': one of them");
        before = attribute.name();
    }
    std::vector<double> q;
    if (element.has("quat") && parse_numbers(element.text("quat"), q) && q == std::vector<double>(4, 0.0))
        reading.error(element, tag_of(element) + " quat is 0 0 0 0, which is no orientation");
}

// A <numeric> has its size, or as many numbers as stand there; a <text> and a <tuple> have something.
void check_custom(const Element& element, const std::string& path, Reading& reading)
{
    if (path == "custom/numeric") {
        std::vector<double> numbers, size;
        const bool has_size = reading.numbers(element, element.text("size"), "size", 1, 1, size);
        const size_t limit = has_size && size[0] >= 0 && size[0] <= 1e6 ? size_t(size[0]) : 1'000'000;
        reading.numbers(element, element.text("data"), "data", 0, limit, numbers);
        if (has_size ? !(size[0] >= 1) : !element.has("size") && element.text("data").empty())
            reading.error(element, "<numeric> '" + element.text("name").substr(0, 60) + "' has no numbers");
    }
    if (path == "custom/text" && element.text("data").empty())
        reading.error(element, "<text> '" + element.text("name").substr(0, 60) + "' has no data");
    if (path == "custom/tuple" && element.children("element").empty())
        reading.error(element, "<tuple> '" + element.text("name").substr(0, 60) + "' has no element");
}

// Counts of <size>: -1 is "as many as there are".
void check_sizes(const Element& element, Reading& reading)
{
    for (const pugi::xml_attribute& attribute : element.node.attributes()) {
        double count = 0;
        if (std::strncmp(attribute.name(), "nuser_", 6) == 0 &&
            reading.number(element, attribute.name(), count) && count < -1)
            reading.error(element, std::string("<size> ") + attribute.name() + " is below -1");
    }
}

}  // namespace

const Words* keywords_of(const std::string& element, const std::string& attribute)
{
    static const Table table = keyword_table();
    for (const std::string& its : {element, std::string()})
        if (const auto row = table.find(its); row != table.end())
            if (const auto found = row->second.find(attribute); found != row->second.end())
                return found->second.empty() ? nullptr : &found->second;
    return nullptr;
}

void check_mjcf_values(const Element& element, const std::string& path, Reading& reading)
{
    check_keywords(element, reading);
    if (path.starts_with("default")) return;
    check_required(element, path, reading);
    check_orientation(element, reading);
    check_custom(element, path, reading);
    if (path == "size") check_sizes(element, reading);
}

}  // namespace epode::robots
