// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// From a session to a picture: what is drawn is a set of switches.
#pragma once

#include <map>

#include "record/output/tessellate.h"
#include "view/session/session.h"
#include "viewer/picture.h"

namespace epode::view {

enum class Paint { kBody, kIsland, kSleep, kSpeed };

struct Switches {
    bool geoms = true, wireframe = false;
    bool body_axes = false, joints = true, joint_axes = false, limits = false;
    bool contacts = false, forces = true;  // forces: of the contacts that are drawn
    bool boxes = false;                    // axis-aligned, of geoms that belong to bodies
    bool shadows = true, soft_light = false;
    Paint paint = Paint::kBody;
    bool pale_sleepers = true;
    float arrows = 1;  // length of the force arrows, times that which suits the scene
};

class Drawing {
  public:
    Switches switches;

    // Everything but camera and size. picked: a body, or record::kNobody.
    viewer::Picture picture(const Session& session, std::int32_t picked);

    // Of another session: surfaces are kept from picture to picture.
    void forget() { surfaces_.clear(); }

  private:
    const record::Surface& surface(const Stage& stage, std::uint32_t shape);
    std::map<std::uint32_t, record::Surface> surfaces_;
};

// The axis-aligned box of a geom; false for what has no end.
bool box_around(const record::Shape& shape, const record::Pose& pose, Vec& low, Vec& high);

}  // namespace epode::view
