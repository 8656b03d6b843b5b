// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// From a model to the text of a file. A model with errors is not to be written. Numbers have the shortest text that
// reads back as the same double.
#pragma once

#include <string>
#include <vector>

#include "robots/model.h"

namespace epode::robots {

struct WrittenRobot {
    std::string text;
    std::vector<std::string> lost;  // a sentence for each thing of the model that the format cannot say
};

// The folder is that of the file to be: paths of meshes count from it.
WrittenRobot write_urdf(const RobotModel& model, const std::string& folder);
WrittenRobot write_mjcf(const RobotModel& model, const std::string& folder);

// Writes a file whose ending decides: .urdf, or .xml and .mjcf. False and a problem: another ending, a model with errors,
// a file that cannot be written.
bool save_robot(const RobotModel& model, const std::string& path, std::vector<std::string>& lost,
                std::string& problem);

}  // namespace epode::robots
