// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The kinds of sensors that a file names, by MJCF's names, and how many numbers each reads: for readers, which know no worlds, and
// for sensors in worlds.
#pragma once

#include <string>

namespace epode::robots {

// Of a joint, a tendon or an actuator; of a frame; 0 of kinds that are none of them.
int values_of_joint_sensor(const std::string& kind);
int values_of_frame_sensor(const std::string& kind);
int values_of_whole_sensor(const std::string& kind);  // of the whole robot
int values_of_geom_sensor(const std::string& kind);   // between geoms
// Between which values one reads by its cutoff, MJCF's: no negative ones, any, or those of directions and turns, which have none.
enum class SensorRange { kPositive, kAny, kNone };
SensorRange range_of_sensor(const std::string& kind);
// Of any, 0 of kinds that are not computed.
int values_of(const std::string& kind);

}  // namespace epode::robots
