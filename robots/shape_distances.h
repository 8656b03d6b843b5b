// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// How far shapes of a model are from each other, those that are only looked at too, of which worlds have no geoms: geoms of its own, in no
// space, made when they are first asked for.
#pragma once

#include <ode/ode.h>

#include <map>
#include <memory>
#include <vector>

#include "robots/model.h"

namespace epode::robots {

class Prepared;

struct PlacedShape {
    int link = 0;
    const Shape* shape = nullptr;
};

// The geom of that name, or, of any other type, all of the body of that name: of a link its own, not those of bodies that have become part
// of it.
std::vector<PlacedShape> shapes_of(const RobotModel& model, const std::string& type, const std::string& name);

struct ShapeDistance {
    double distance = 0;  // below 0: they overlap
    Vec from,
        to;  // on the first and on the second, in the world; both 0 where none is nearer than the cutoff
};

class ShapeDistances {
  public:
    explicit ShapeDistances(std::shared_ptr<const Prepared> prepared) : prepared_(std::move(prepared)) {}
    ~ShapeDistances();
    ShapeDistances(const ShapeDistances&) = delete;
    ShapeDistances& operator=(const ShapeDistances&) = delete;

    // The least of all pairs, or the cutoff if that is less; poses: of links, in the world.
    ShapeDistance find(const std::vector<Pose>& poses, const std::vector<PlacedShape>& one,
                       const std::vector<PlacedShape>& two, double cutoff);

  private:
    const std::vector<dGeomID>& geoms_of(const std::vector<Pose>& poses, const PlacedShape& its);

    std::shared_ptr<const Prepared> prepared_;
    std::map<const Shape*, std::vector<dGeomID>> geoms_;
};

}  // namespace epode::robots
