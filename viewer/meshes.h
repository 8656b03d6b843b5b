// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Two meshes draw every shape. Each shape is a core swept by a ball: sphere = point + ball, capsule = segment
// + ball, box and cylinder = a smaller box or cylinder + a small ball, which rounds their edges so that they
// catch the light. A vertex holds the unit corner k of the core and the unit direction n on the ball; an
// instance holds the core's half sizes h and the ball's radius r:
//     p = h * k + r n   (componentwise),   normal = n.
// So normals are exact at any size, and spheres, capsules and boxes share one mesh; the alternative, scaled
// unit meshes, distorts the caps of capsules and needs the inverse transpose for normals.
#pragma once

#include <cstdint>
#include <vector>

#include "picture.h"

namespace epode::viewer {

struct Vertex {
    float corner[3];
    float normal[3];
};

struct Mesh {
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices;  // triangles, counter-clockwise from outside
};

// `steps`: pieces into which the ball divides 45 degrees.
Mesh rounded_box(int steps);
Mesh rounded_cylinder(int sides, int steps);

// What one shape gives the vertex shader: three rows (rotation | position), (half sizes, radius), colour and
// opacity, texture (0: none).
struct Instance {
    float row[3][4];
    float core[4];
    float color[4];
    float texture;
};

Instance instance_of(const Shape& shape);

}  // namespace epode::viewer
