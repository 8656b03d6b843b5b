// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What <gazebo> elements add to a URDF, as robots/read/gazebo.cpp reads them: one friction of a link, gravity, links that touch no
// other, springs of joints, sensors. A sensor's frame is its own and not written again.
#pragma once

#include <string>
#include <vector>

#include "robots/write/text.h"

namespace epode::robots {

class GazeboWriter {
  public:
    // `links`: their names in the file; `shifts`: where its frame of a link begins in the link's frame.
    GazeboWriter(const RobotModel& model, const std::vector<std::string>& links,
                 const std::vector<Vec>& shifts, pugi::xml_node robot, Losses& losses);

    // Has the frame a sensor that is written with it?
    bool has_sensor(const Frame& frame) const;
    void write_link(size_t link);
    void write_joint(const Joint& joint, const std::string& name);
    void write_sensors();
    void note_losses();

  private:
    // A sensor of the file: what it is there, in which frame.
    struct Sensed {
        std::string type, name;
        const Frame* frame;
        bool looks_along_z = false;  // as MJCF's rangefinder does
        bool is_on_child = false;
    };
    void gather_sensors();
    void gather_apart();
    bool pair_of_sensors(size_t first, const Frame& frame);
    bool takes_all_apart(int link) const;
    bool is_apart(int a, int b) const;
    pugi::xml_node element_of(const std::string& reference);
    void write_friction(const Link& link, pugi::xml_node& element, const std::string& name);

    const RobotModel& model_;
    const std::vector<std::string>& links_;
    const std::vector<Vec>& shifts_;
    pugi::xml_node robot_;
    Losses& losses_;
    std::vector<Sensed> sensors_;
    std::vector<int> alone_;  // links that touch no other
};

}  // namespace epode::robots
