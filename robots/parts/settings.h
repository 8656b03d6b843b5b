// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// How well the hulls of a decomposed mesh are to fit.
#pragma once

namespace epode::robots {

struct PartSettings {
    double tolerance = 0;  // m; 0: 2.5 % of the longest side of the mesh
    int max_parts = 32;
    unsigned max_vertices = 64;  // of a hull, 0: all; at least 4 otherwise
};

}  // namespace epode::robots
