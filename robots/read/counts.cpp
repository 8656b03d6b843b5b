// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See counts.h.
#include "robots/read/counts.h"

#include <sstream>

namespace epode::robots {

namespace {

// Of an element (empty: of any other one), how many numbers attributes take, and these.
struct Counted {
    const char* element;
    size_t limit;
    const char* attributes;
};

// clang-format off
constexpr Counted kMjcf[] = {
#include "robots/read/mjcf_counts.inc"
};
constexpr Counted kUrdf[] = {
{"origin", 3, "xyz rpy"},
{"axis", 3, "xyz"},
{"box", 3, "size"},
{"mesh", 3, "scale"},
{"color", 4, "rgba"},
{"sphere", 1, "radius"},
{"cylinder", 1, "radius length"},
{"capsule", 1, "radius length"},
{"mass", 1, "value"},
{"inertia", 1, "ixx ixy ixz iyy iyz izz"},
{"limit", 1, "lower upper effort velocity"},
{"dynamics", 1, "damping friction"},
{"mimic", 1, "multiplier offset"},
{"safety_controller", 1, "soft_lower_limit soft_upper_limit k_position k_velocity"},
{"calibration", 1, "reference_position rising falling"},
// What PyBullet reads of a link's <contact>.
{"", 1, "value"},
};
// clang-format on

// By element and attribute.
using Counts = std::map<std::string, std::map<std::string, size_t>>;

template <size_t N>
Counts counts_of(const Counted (&rows)[N])
{
    Counts out;
    for (const Counted& row : rows) {
        std::istringstream words(row.attributes);
        for (std::string word; words >> word;) out[row.element][word] = row.limit;
    }
    return out;
}

// 0: as many as there are.
size_t limit_of_attribute(const Counts& table, const std::string& element, const std::string& attribute)
{
    for (const std::string& its : {element, std::string()})
        if (const auto row = table.find(its); row != table.end())
            if (const auto found = row->second.find(attribute); found != row->second.end())
                return found->second;
    return 0;
}

void check_counts_of(const Counts& table, const Element& element, Reading& reading)
{
    for (const pugi::xml_attribute& attribute : element.node.attributes())
        if (const size_t limit = limit_of_attribute(table, element.name(), attribute.name()))
            reading.check_count(element, attribute.name(), attribute.value(), limit);
}

}  // namespace

void check_mjcf_counts(const Element& element, Reading& reading)
{
    static const Counts table = counts_of(kMjcf);
    check_counts_of(table, element, reading);
    for (const pugi::xml_attribute& attribute : element.node.attributes())
        if (limit_of_attribute(table, element.name(), attribute.name()))
            reading.check_numbers(element, attribute.name(), attribute.value());
}

void check_urdf_counts(const Element& robot, Reading& reading)
{
    static const Counts table = counts_of(kUrdf);
    std::vector<Element> open{robot};
    while (!open.empty()) {
        const Element element = open.back();
        open.pop_back();
        if (element.name() == "gazebo") continue;
        check_counts_of(table, element, reading);
        const std::vector<Element> children = element.children();
        open.insert(open.end(), children.rbegin(), children.rend());
    }
}

}  // namespace epode::robots
