// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Contacts with a terrain that is a mesh or a height field: nanoseconds per dCollide of each class of solid.
#pragma once

#include <string>

namespace epode::bench {

struct TerrainOptions {
    int cells = 256;    // to a side; two triangles each
    int solids = 2000;  // of each class
    int rounds = 5;
    bool field = false;  // a height field of the same heights, not a mesh
    std::string only;    // one class of solids; empty: all
};

int bench_terrain(const TerrainOptions& options);

}  // namespace epode::bench
