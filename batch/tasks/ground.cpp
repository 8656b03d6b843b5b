// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See ground.h.
#include "batch/tasks/ground.h"

#include <algorithm>
#include <cmath>

namespace epode::batch {

using namespace robots;

Ground::Ground(const BatchModel& model)
{
    const RobotModel& robot = model.asked.prepared->model();
    std::vector<Pose> poses(robot.links.size());
    for (std::size_t i = 0; i < robot.links.size(); ++i) {
        const Link& link = robot.links[i];
        if (model.links[i].last_dof >= 0) continue;
        poses[i] = link.parent < 0 ? link.pose : poses[std::size_t(link.parent)] * link.pose;
        for (const Shape& shape : link.shapes)
            if ((shape.category | shape.collide) != 0) add(shape, poses[i] * shape.pose, robot);
    }
    if (planes_.empty() && fields_.empty() && refusal_.empty())
        refusal_ = "the model has no ground whose height could be scanned";
}

void Ground::add(const Shape& shape, const Pose& pose, const RobotModel& model)
{
    const Vec x = rotate(pose.q, {1, 0, 0}), up = rotate(pose.q, {0, 0, 1});
    if (shape.kind == ShapeKind::kPlane && up.z > 1e-6)
        planes_.push_back({dot(up, pose.p) / up.z, -up.x / up.z, -up.y / up.z});
    else if (shape.kind == ShapeKind::kHeights && up.z > 1 - 1e-12)
        fields_.push_back({&model.fields[std::size_t(shape.field)], pose.p, x.x, x.y});
    else
        refusal_ = "a scan of heights is of planes and upright height fields, and '" + shape.name +
                   "' is another shape: epode.Batch.rays sees all of them";
}

double Ground::height(double x, double y) const
{
    double highest = -kInfinity;
    for (const Plane& plane : planes_)
        highest = std::max(highest, plane.at_origin + plane.slope_x * x + plane.slope_y * y);
    for (const Field& field : fields_) highest = std::max(highest, height(field, x, y));
    return highest;
}

// In the triangle of the cell that has the place: both have the corners of the least and of the largest x and y.
double Ground::height(const Field& field, double x, double y)
{
    const HeightField& its = *field.its;
    const double dx = x - field.at.x, dy = y - field.at.y;
    const double u = (field.cosine * dx + field.sine * dy + its.half_x) / (2 * its.half_x) *
                     (its.columns - 1),
                 v = (field.cosine * dy - field.sine * dx + its.half_y) / (2 * its.half_y) * (its.rows - 1);
    if (!(u >= 0 && u <= its.columns - 1 && v >= 0 && v <= its.rows - 1)) return -kInfinity;
    const int i = std::min(int(u), its.columns - 2), j = std::min(int(v), its.rows - 2);
    const double *low = &its.samples[std::size_t(j) * std::size_t(its.columns) + std::size_t(i)],
                 *high = low + its.columns;
    const double a = u - i, b = v - j;
    const double share = a > b ? low[0] + a * (low[1] - low[0]) + b * (high[1] - low[1])
                               : low[0] + b * (high[0] - low[0]) + a * (high[1] - high[0]);
    return field.at.z + its.top * share;
}

}  // namespace epode::batch
