// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See text.h.
#include "robots/write/text.h"

#include <cmath>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <sstream>

namespace epode::robots {

std::string list_text(const std::vector<double>& values)
{
    std::string out;
    for (double value : values) out += (out.empty() ? "" : " ") + text_of(value);
    return out;
}

std::string text_of(Vec v) { return list_text({v.x, v.y, v.z}); }
std::string text_of(Quat q) { return list_text({q.w, q.x, q.y, q.z}); }

std::string color_text(const float (&color)[4])
{
    std::string out;
    for (float value : color) {
        char buffer[32];
        const auto end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
        out += (out.empty() ? "" : " ") + std::string(buffer, end);
    }
    return out;
}

void set(pugi::xml_node node, const char* attribute, const std::string& value)
{
    node.append_attribute(attribute).set_value(value.c_str());
}

void set(pugi::xml_node node, const char* attribute, double value) { set(node, attribute, text_of(value)); }

std::string path_from(const std::string& folder, const std::string& path)
{
    namespace fs = std::filesystem;
    std::error_code error;
    const fs::path base = fs::weakly_canonical(fs::absolute(folder.empty() ? "." : folder, error), error);
    const fs::path relative = fs::path(path).lexically_relative(base);
    return relative.empty() ? path : relative.string();
}

std::string text_of(const pugi::xml_document& document)
{
    std::ostringstream out;
    document.save(out, "  ");
    return out.str();
}

std::string Names::unique(const std::string& wanted, const char* word, size_t number)
{
    std::string name = wanted.empty() ? word + std::to_string(number) : wanted;
    while (!taken_.insert(name).second) name += "_";
    return name;
}

void Losses::add(const std::string& sentence)
{
    if (std::find(all.begin(), all.end(), sentence) == all.end()) all.push_back(sentence);
}

// Fixed axes x, y, z. The angle about z is that of the x axis; the others are of what is left after it is undone, so that
// they fit together where the x axis is upright and its angle says little.
Vec rpy_of(Quat q)
{
    const Matrix m = matrix_of(q);
    const double yaw = std::atan2(m[1][0], m[0][0]);
    const Matrix rest = matrix_of(conjugate(turn({0, 0, 1}, yaw)) * q);
    return {std::atan2(-rest[1][2], rest[1][1]), std::atan2(-rest[2][0], rest[0][0]), yaw};
}

bool is_identity(const Pose& pose)
{
    const auto [p, q] = pose;
    return p.x == 0 && p.y == 0 && p.z == 0 && q.x == 0 && q.y == 0 && q.z == 0;
}

}  // namespace epode::robots
