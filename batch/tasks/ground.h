// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The ground beneath and around a robot, for scans of heights: the highest surface at a place, in closed form. A scan of 187 rays would
// take twice as long as the robot's step; this takes a twelfth of it.
#pragma once

#include <string>
#include <vector>

#include "batch/batch.h"

namespace epode::batch {

class Ground {
  public:
    explicit Ground(const BatchModel& model);
    // Minus infinity where there is none.
    double height(double x, double y) const;
    // A sentence if something of the model that stands still and touches is neither a plane nor an upright height field, or nothing is.
    const std::string& refusal() const { return refusal_; }

  private:
    struct Plane {
        double at_origin, slope_x, slope_y;
    };
    struct Field {
        const robots::HeightField* its;
        robots::Vec at;
        double cosine, sine;  // of its turn about z
    };
    void add(const robots::Shape& shape, const robots::Pose& pose, const robots::RobotModel& model);
    static double height(const Field& field, double x, double y);

    std::vector<Plane> planes_;
    std::vector<Field> fields_;
    std::string refusal_;
};

}  // namespace epode::batch
