// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Rays against triangle meshes, as bench/rays asks for them.
#pragma once

#include <string>

namespace epode::bench {

struct MeshRayOptions {
    std::string mesh = "terrain";  // terrain, ball, soup
    int triangles = 100'000;       // about
    int rays = 100'000;
    int repeat = 3;
};

// Prints one line: triangles, ms to build, ns a ray for the closest hit, for all hits and for misses, each
// the least of the repetitions, number of hits, sum of their depths. The answer is an exit status.
int bench_mesh_rays(const MeshRayOptions& options);

}  // namespace epode::bench
