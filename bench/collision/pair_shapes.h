// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The solids of bench/collide, about half a metre in size, made with ode/*.h alone. Each kind says how high
// it stands over its origin when it rests upright, so that pairs can be laid on each other without asking a
// library for a depth. A new kind of geom is a new line of kPairShapes and a case of PairShape.
//   cube, hull20, hull100   polyhedra with 8, 20 and 100 vertices; the latter are rings of points on an
//                           ellipsoid (planar quadrangles, flat above and below), so that no hull need be
//                           computed here
//   mesh                    the ellipsoid of 100 points as a triangle mesh
//   ground, field           the terrain of bench/collision/ground.h as a mesh and as a height field; the height is that
//   at a place ray, ray-first ...      2 m long; all hits, or those that FirstContact, ClosestHit and
//   BackfaceCull leave
#pragma once

#include <ode/ode.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "bench/collision/ground.h"

namespace epode::bench {

class PairDice {
  public:
    explicit PairDice(std::uint64_t seed) : state_(seed) {}
    double in(double lo, double hi)
    {
        state_ = state_ * 6364136223846793005ull + 1442695040888963407ull;
        return lo + (hi - lo) * double(state_ >> 11) * 0x1p-53;
    }

  private:
    std::uint64_t state_;
};

inline constexpr const char* kPairShapes[] = {"sphere", "box",     "capsule",   "cylinder",    "cube",
                                              "hull20", "hull100", "plane",     "ray",         "mesh",
                                              "ground", "field",   "ray-first", "ray-closest", "ray-cull"};

// Points, planes and polygons as dCreateConvex reads them: they must outlive the geom.
struct RingHull {
    std::vector<dReal> points, planes;
    std::vector<unsigned> polygons;
    double top = 0;    // height of the uppermost ring
    double reach = 0;  // of the farthest point
    RingHull(int rings, int sides, double radius, double height);

  private:
    void add_face(const std::vector<int>& corners);
};

class PairShape {
  public:
    explicit PairShape(const std::string& kind);
    PairShape(const PairShape&) = delete;
    PairShape& operator=(const PairShape&) = delete;
    ~PairShape();

    dGeomID geom() const { return geom_; }
    double top() const { return top_; }  // of the upright solid
    double height(double x, double y) const { return is_ground() ? ground_height(x, y) : top_; }
    double reach() const { return reach_; }  // of any pose
    bool is_plane() const { return kind_ == "plane"; }
    bool is_ray() const { return kind_.starts_with("ray"); }
    bool is_ground() const { return kind_ == "ground" || kind_ == "field"; }
    bool is_fixed() const { return is_plane() || is_ground(); }  // stays where it is made

  private:
    void make_mesh();
    void make_ray();

    std::string kind_;
    RingHull hull_;
    std::unique_ptr<MeshGround> ground_;
    std::unique_ptr<FieldGround> field_;
    dGeomID geom_ = nullptr;
    dTriMeshDataID data_ = nullptr;
    std::vector<dTriIndex> triangles_;
    double top_ = 0, reach_ = 0;
};

}  // namespace epode::bench
