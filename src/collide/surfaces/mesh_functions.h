// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The program's functions of a mesh, asked during a collision. Which geom meets the mesh is known by the
// sink: pair functions see shapes only. The dispatcher holds both geoms and the data while they run
// (MeshHold).
//   wants      may the triangle touch the other geom?
//   told       all triangles near the other geom, before any of them is asked about
//   ray_hits   does a ray's hit at the point (1-u-v) v0 + u v1 + v v2 count?
// The fourth, which numbers contacts that have become one, is known by the sink (ContactSink::merged).
#pragma once

#include <span>

#include "base/float_environment.h"
#include "collide/contact_sink.h"
#include "collide/surfaces/trimesh.h"

namespace epode {

class MeshFunctions {
  public:
    // The mesh is the first or the second geom of the pair.
    MeshFunctions(const Trimesh& mesh, const ContactSink& sink, bool mesh_first)
        : mesh_(mesh),
          geom_(mesh_first ? sink.first_geom() : sink.second_geom()),
          other_(mesh_first ? sink.second_geom() : sink.first_geom())
    {}

    bool wants(int triangle) const
    {
        if (!mesh_.wants) return true;
        const CallerFloatEnvironment program;
        return mesh_.wants(geom_, other_, triangle) != 0;
    }
    void report(std::span<const int> triangles) const
    {
        if (!mesh_.array_callback || triangles.empty()) return;
        const CallerFloatEnvironment program;
        mesh_.array_callback(geom_, other_, triangles.data(), int(triangles.size()));
    }
    bool ray_hits(int triangle, Real u, Real v) const
    {
        if (!mesh_.ray_hits) return true;
        const CallerFloatEnvironment program;
        return mesh_.ray_hits(geom_, other_, triangle, u, v) != 0;
    }

  private:
    const Trimesh& mesh_;
    dGeomID geom_, other_;
};

}  // namespace epode
