// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Triangles with normals for every shape, in the geom's frame.
#pragma once

#include "record/file/recording.h"

namespace epode::record {

struct Surface {
    std::vector<std::array<float, 3>> points, normals;
    std::vector<std::uint32_t> corners;  // three a triangle, counter-clockwise from outside

    bool empty() const { return corners.empty(); }
};

// plane_reach: half the side of the square by which a plane, which has no end, is shown.
Surface tessellate(const Shape& shape, double plane_reach);

}  // namespace epode::record
