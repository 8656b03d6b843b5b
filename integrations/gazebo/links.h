// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Where links are and how they move, and what of them hangs together.
#pragma once

#include "integrations/gazebo/entities.h"

namespace epode::gazebo {

// Of the link's frame, in the world; velocities are those of its origin, accelerations the differences over the last step.
struct Motion {
    Pose pose;
    Vec linear, angular, linear_acceleration, angular_acceleration;
};
Pose pose_of(const Link& link);
Motion motion_of(const Link& link);
// The motion of a frame that is fixed to the link.
Motion moved_frame(const Motion& link, const Pose& frame);

// Puts the link there. Velocities stay.
void place(Link& link, const Pose& pose);
// Moves links together by a motion of space.
void move_all(const std::vector<Link*>& links, const Pose& by);
// Adds to their velocities those of a body that has this velocity at a point and turns that fast.
void add_velocity(const std::vector<Link*>& links, Vec point, Vec linear, Vec angular);
void wake(const Link& link);

// What joints connect to a link, itself first.
struct Group {
    std::vector<Link*> links;
    bool is_held = false;  // by the world
};
// All of it; `through` null, or a joint that does not count.
Group group_of(Link& link, const Joint* through = nullptr);
// What a joint carries: its child, and on from parents to children.
std::vector<Link*> carried_by(const Joint& joint);
// By its name in the model, with those of models in it and :: before it; null where there is none.
Link* find_link(const Model& model, const std::string& name);
// Of a model and those in it.
std::vector<Link*> links_of(const Model& model);

// The model's frame in the world.
Motion motion_of(const Model& model);

}  // namespace epode::gazebo
