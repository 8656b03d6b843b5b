// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A recorded state as a picture to draw: geoms that the renderer does not have are triangles; joints are lines from their
// anchors to the bodies' centres.
#pragma once

#include <vector>

#include "record/file/recording.h"
#include "record/output/animation.h"
#include "record/output/tessellate.h"
#include "viewer/picture.h"

class Studio {
  public:
    Studio(const epode::record::Recording& recording, size_t state);

    epode::viewer::Picture picture;
    std::vector<epode::viewer::Shape> extents;  // what the camera should see

  private:
    void add_geom(std::uint32_t number);
    void add_triangles(const epode::record::Surface& surface, const epode::record::Pose& pose,
                       epode::viewer::Color color);
    void add_joint(const epode::record::Joint& joint);

    const epode::record::Recording& recording_;
    size_t state_;
    std::vector<epode::record::Pose> poses_;  // by the numbers of bodies
};
