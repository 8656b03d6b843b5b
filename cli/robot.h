// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Robots from files: `epode robot check FILE`, `epode robot convert FILE TO`, `epode robot view FILE`, and scenes with the
// robot of a file for run, record and view.
#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

#include "view/view.h"

namespace epode::cli {

struct RobotOptions {
    std::string file, to;  // `to` of convert alone
    std::vector<std::string> roots;
    bool strict = false;
    bool json = false;
    bool decomposes = false;  // meshes into several hulls each
    double tolerance = 0;     // of them, m
    bool is_viewed = false;   // `epode robot view`
};

void add_robot_options(CLI::App& command, RobotOptions& options, view::ViewOptions& viewing);
// check prints links, joints and the report; convert writes the other file and prints what that cannot say. Exit code 1
// for a file with errors.
int run_robot(const RobotOptions& options);
// Makes a scene of what ends in .urdf, .xml, .mjcf or .sdf, under that name. False: the file has errors. Anything else is
// left alone. posed: without gravity, and with a dial for every axis.
bool offer_robot(const std::string& what, bool posed, std::string& problem);

}  // namespace epode::cli
