// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Numbers that are too many in a file of SDF (see counts.h): libsdformat passes over them, but in poses, colours and truths. The types
// are those that it has found, by the names of an element and of the one that it stands in. For sdf.cpp alone, the one file that a
// build without libsdformat compiles again.
#pragma once

#include "robots/read/reading.h"

#ifdef EPODE_HAVE_SDF
#include <sdf/sdf.hh>

namespace epode::robots {

namespace sdf_counts {

using Types = std::map<std::string, std::string>;

inline std::string key_of(const std::string& parent, const std::string& element)
{
    return parent + "/" + element;
}

// 0: as many as there are.
inline size_t limit_of_type(const std::string& type)
{
    static const std::map<std::string, size_t> table{
        {"double", 1},   {"float", 1},    {"int", 1},     {"unsigned int", 1}, {"uint64_t", 1},
        {"vector2i", 2}, {"vector2d", 2}, {"vector3", 3}, {"quaternion", 4},   {"time", 2}};
    const auto found = table.find(type);
    return found == table.end() ? 0 : found->second;
}

inline void collect_types(const sdf::ElementPtr& root, Types& types)
{
    std::vector<sdf::ElementPtr> open{root};
    while (!open.empty()) {
        const sdf::ElementPtr element = open.back();
        open.pop_back();
        for (sdf::ElementPtr child = element->GetFirstElement(); child; child = child->GetNextElement()) {
            if (const sdf::ParamPtr value = child->GetValue())
                types[key_of(element->GetName(), child->GetName())] = value->GetTypeName();
            open.push_back(child);
        }
    }
}

inline void check_text(const Element& parent, const Element& element, const Types& types, Reading& reading)
{
    const auto type = types.find(key_of(parent.name(), element.name()));
    if (type == types.end()) return;
    if (const size_t limit = limit_of_type(type->second))
        reading.check_count(element, "", element.node.text().get(), limit);
}

}  // namespace sdf_counts

// `read`: what libsdformat has made of the file.
inline void check_sdf_counts(const sdf::ElementPtr& read, const Element& root, Reading& reading)
{
    sdf_counts::Types types;
    sdf_counts::collect_types(read, types);
    std::vector<Element> open{root};
    while (!open.empty()) {
        const Element element = open.back();
        open.pop_back();
        const std::vector<Element> children = element.children();
        for (const Element& child : children)
            if (child.name() != "plugin") sdf_counts::check_text(element, child, types, reading);
        open.insert(open.end(), children.rbegin(), children.rend());
    }
}

}  // namespace epode::robots

#endif
