// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See write.h.
#include <fstream>

#include "robots/files/files.h"
#include "robots/write/write.h"

namespace epode::robots {

bool save_robot(const RobotModel& model, const std::string& path, std::vector<std::string>& lost,
                std::string& problem)
{
    const std::string ending = ending_of(path);
    const bool is_mjcf = ending == "xml" || ending == "mjcf";
    if (model.has_errors()) return problem = "a model with errors is not written", false;
    if (!is_mjcf && ending != "urdf")
        return problem = "'" + path + "': robots are written to .urdf, .xml and .mjcf", false;
    WrittenRobot written = is_mjcf ? write_mjcf(model, folder_of(path)) : write_urdf(model, folder_of(path));
    std::ofstream file(path, std::ios::binary);
    file << written.text;
    file.close();
    if (!file) return problem = "'" + path + "' cannot be written", false;
    lost = std::move(written.lost);
    return true;
}

}  // namespace epode::robots
