// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See sensor_kinds.h.
#include "robots/sensor_kinds.h"

#include <algorithm>
#include <iterator>

namespace epode::robots {

namespace {

struct Kind {
    const char* name;
    int values;
};

constexpr Kind kOfJoints[] = {{"jointpos", 1},      {"jointvel", 1},          {"jointactuatorfrc", 1},
                              {"actuatorfrc", 1},   {"ballquat", 4},          {"ballangvel", 3},
                              {"actuatorpos", 1},   {"actuatorvel", 1},       {"tendonpos", 1},
                              {"tendonvel", 1},     {"tendonactuatorfrc", 1}, {"jointlimitpos", 1},
                              {"jointlimitvel", 1}, {"tendonlimitpos", 1},    {"tendonlimitvel", 1},
                              {"jointlimitfrc", 1}, {"tendonlimitfrc", 1}};
constexpr Kind kOfWhole[] = {{"e_potential", 1}, {"e_kinetic", 1}, {"clock", 1}};
constexpr Kind kOfGeoms[] = {{"distance", 1}, {"normal", 3}, {"fromto", 6}};
constexpr Kind kOfFrames[] = {
    {"accelerometer", 3}, {"gyro", 3},          {"velocimeter", 3}, {"force", 3},       {"torque", 3},
    {"touch", 1},         {"rangefinder", 1},   {"framepos", 3},    {"framequat", 4},   {"framelinvel", 3},
    {"frameangvel", 3},   {"framexaxis", 3},    {"frameyaxis", 3},  {"framezaxis", 3},  {"subtreecom", 3},
    {"subtreelinvel", 3}, {"subtreeangmom", 3}, {"framelinacc", 3}, {"frameangacc", 3}, {"magnetometer", 3},
    {"insidesite", 1}};

template <size_t n>
int find(const Kind (&kinds)[n], const std::string& name)
{
    const auto found = std::find_if(kinds, kinds + n, [&](const Kind& kind) { return name == kind.name; });
    return found == kinds + n ? 0 : found->values;
}

}  // namespace

int values_of_joint_sensor(const std::string& kind) { return find(kOfJoints, kind); }
int values_of_frame_sensor(const std::string& kind) { return find(kOfFrames, kind); }
int values_of_whole_sensor(const std::string& kind) { return find(kOfWhole, kind); }
int values_of_geom_sensor(const std::string& kind) { return find(kOfGeoms, kind); }
int values_of(const std::string& kind)
{
    return values_of_joint_sensor(kind) + values_of_frame_sensor(kind) + values_of_whole_sensor(kind) +
           values_of_geom_sensor(kind);
}

SensorRange range_of_sensor(const std::string& kind)
{
    static constexpr const char* kPositive[] = {"touch", "rangefinder", "insidesite"};
    static constexpr const char* kNone[] = {"framexaxis", "frameyaxis", "framezaxis", "framequat",
                                            "ballquat",   "normal",     "fromto"};
    const auto is = [&](const char* name) { return kind == name; };
    if (std::any_of(std::begin(kPositive), std::end(kPositive), is)) return SensorRange::kPositive;
    return std::any_of(std::begin(kNone), std::end(kNone), is) ? SensorRange::kNone : SensorRange::kAny;
}

}  // namespace epode::robots
