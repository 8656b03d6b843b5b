// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What the readers of all formats share: the report, attributes with checks, meshes that are read once.
#pragma once

#include <map>
#include <set>
#include <tuple>

#include "robots/files/files.h"
#include "robots/files/xml.h"
#include "robots/load.h"

namespace epode::robots {

// Where a mesh is wanted, and what a missing one is.
struct Place {
    Note missing = Note::kError;
    std::string file;
    int line = 0;
};

struct MeshFile {
    std::string reference, folder;
    Vec scale{1, 1, 1};
    bool counts_folds = false;
};

// Of a robot: more makes worlds that nobody steps.
constexpr size_t kMaxLinks = 10'000;

class Reading {
  public:
    Reading(RobotModel& its_model, const LoadOptions& its_options, Files& its_files)
        : model(its_model), options(its_options), files(its_files)
    {}

    void note(Note kind, const Element& where, const std::string& text)
    {
        note(kind, where.file(), where.line(), text);
    }
    void note(Note kind, const std::string& file, int line, const std::string& text);
    // The first of each text alone: what hundreds of elements of a file have.
    void note_once(Note kind, const Element& where, const std::string& text);
    void error(const Element& where, const std::string& text) { note(Note::kError, where, text); }

    // An attribute's numbers. False where it is missing; false and an error where it is broken or of another count.
    bool numbers(const Element& element, const std::string& text, const char* attribute, size_t least,
                 size_t largest, std::vector<double>& out);
    // An error where there are more numbers; `numbers` says nothing of them again.
    void check_count(const Element& element, const std::string& attribute, const std::string& text,
                     size_t limit);
    // An error where there is anything but numbers; `numbers` says nothing of it again.
    void check_numbers(const Element& element, const std::string& attribute, const std::string& text);
    bool number(const Element& element, const char* attribute, double& out);
    bool vec(const Element& element, const char* attribute, Vec& out);

    int mesh(const Place& where, const MeshFile& file);

    // A motor on a joint with an axis, within its largest force: the control is the force.
    void add_motor(int joint, const std::string& name, int line);
    // One on each joint with an axis that follows no other, in their order, called as the joint.
    void add_motors();

    static std::string too_many_links() { return "more than " + std::to_string(kMaxLinks) + " links"; }

    RobotModel& model;
    const LoadOptions& options;
    Files& files;

  private:
    std::map<std::tuple<std::string, std::array<double, 3>, bool>, int> meshes_;
    std::set<std::string> noted_;  // texts, and attributes of too many numbers with theirs
};

void read_urdf(const Element& robot, Reading& reading);
// What a URDF's <gazebo> elements add to its links and joints.
void read_gazebo(const Element& robot, Reading& reading);
void read_mjcf(const Element& mujoco, Reading& reading);
// libsdformat reads the text again.
void read_sdf(const Element& sdf, const std::string& text, Reading& reading);

}  // namespace epode::robots
