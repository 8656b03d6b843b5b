// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Geoms of shapes.
#pragma once

#include "integrations/gazebo/entities.h"
#include "robots/model.h"

namespace epode::gazebo {

// Makes the geoms of a shape whose kind, pose and sizes are set, of its link, in its world's space. False, with a message: sizes that
// are not positive, a plane on a link that can move.
bool make_geoms(Shape& shape);
// The same of a mesh, whose corners and triangles are without scale: of a link that can move convex parts, else the triangles.
bool make_mesh(Shape& shape, robots::Mesh mesh);
// The same of heights, row by row from the least y, over the shape's size.
bool make_heights(Shape& shape, const std::vector<double>& heights, int rows, int columns);
void destroy_geoms(Shape& shape);

// After the shape's pose, or that of a link without a body, has changed.
void put_geoms(Shape& shape);
// After its material has.
void put_material(Shape& shape);
void put_mask(Shape& shape);
// The box around it in its own frame. False of one without an end.
bool box_of(const Shape& shape, Vec& low, Vec& high);
// Sizes of a box, sphere, cylinder, capsule or ellipsoid that has its geom. False, with a message, of sizes that are not positive.
bool resize(Shape& shape, Vec size);

}  // namespace epode::gazebo
