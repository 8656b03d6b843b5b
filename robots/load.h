// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// From a file to a model: URDF or MJCF, told by the root element. What is read, changed, approximated or left out is
// in the model's report; so are errors, and a model with errors is not to be built.
#pragma once

#include <string>
#include <vector>

#include "robots/model.h"
#include "robots/parts/settings.h"

namespace epode::robots {

struct LoadOptions {
    std::vector<std::string> roots;    // more folders that may be read; packages are looked for here first
    bool strict = false;               // what is approximated or ignored is an error
    bool keep_fixed = false;           // links that are fixed to their parents stay links of their own
    bool fixed_base = false;           // URDF: the root link is fixed to the world
    bool repair = false;               // inertias that no body has are mended
    bool inertia_from_shapes = false;  // URDF: of moving links without an inertial, at 1000 kg/m^3
    double missing_mass = 0;           // kg; else their mass, as a ball of 5 cm radius; 0: an error
    bool meshes_as_triangles = false;  // else the convex hull of each, or several
    bool meshes_as_parts = false;      // several hulls of each mesh that is not convex
    PartSettings parts;
};

RobotModel load_robot(const std::string& path, const LoadOptions& options = {});
// The same of a text; references count from the path's folder.
RobotModel load_robot_text(const std::string& path, const std::string& text, const LoadOptions& options = {});

}  // namespace epode::robots
