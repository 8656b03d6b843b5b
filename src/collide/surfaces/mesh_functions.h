// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The program's callbacks of a mesh, called during a collision. The sink knows the other geom: pair functions
// see shapes only. The dispatcher holds both geoms and the data while the callbacks run (MeshHold).
//   wants            whether the triangle may touch the other geom
//   array_callback   receives all triangles near the other geom, before `wants` is called for any of them
//   ray_hits         whether a ray's hit at the point (1-u-v) v0 + u v1 + v v2 counts
// The sink calls the fourth, which numbers merged contacts (ContactSink::merged).
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
