// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Rays from a link of one copy against all shapes of the model: height scans, rangefinders, lidars. Geoms of a thread's own stand where
// the copy's shapes are, in a space of their own.
#pragma once

#include <ode/ode.h>

#include "batch/model/batch_model.h"

namespace epode::batch {

// In whose axes rays are given: their link's; the world's; upright ones, z up and x where the link's x heads.
enum class RayAxes { kLink, kWorld, kUpright };

// Origins and directions, of any length, three numbers a ray, from the link's origin. Shapes of the link are not hit, but for the world's.
struct Rays {
    int link = 0, count = 0;
    RayAxes axes = RayAxes::kLink;
    const double *origins = nullptr, *directions = nullptr;
    double reach = robots::kInfinity;
};

struct RayHit {
    double range = robots::kInfinity;
    int shape = -1;  // among the model's
};

class RayCaster {
  public:
    explicit RayCaster(const BatchModel& model);
    ~RayCaster();
    RayCaster(const RayCaster&) = delete;
    RayCaster& operator=(const RayCaster&) = delete;

    // Puts the shapes of all links; pose_of(link): in the world.
    template <typename PoseOf>
    void put(const PoseOf& pose_of)
    {
        for (std::size_t i = 0; i < poses_.size(); ++i) poses_[i] = pose_of(int(i));
        put_solids();
    }
    // Of the copy that has been put; hit(ray, RayHit).
    template <typename Hit>
    void cast(const Rays& rays, const Hit& hit)
    {
        choose(rays);
        for (int i = 0; i < rays.count; ++i) hit(i, cast_one(rays, i));
    }

  private:
    struct Solid {
        AskedShape shape;
        int link;
        dGeomID geom;
    };
    void put_solids();
    void choose(const Rays& rays);
    RayHit cast_one(const Rays& rays, int number) const;
    int number_of(dGeomID geom) const;

    dSpaceID space_;
    std::vector<Solid> solids_;
    std::vector<robots::Pose> poses_;  // of links
    robots::Pose from_;
};

}  // namespace epode::batch
