// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See rays.h.
#include "batch/rays.h"

#include <ode/ext.h>

#include <cmath>
#include <new>

#include "batch/place_geom.h"
#include "robots/shape_geom.h"

namespace epode::batch {

using namespace robots;

namespace {

AskedPose asked_pose(const Pose& pose)
{
    AskedPose out;
    for (int k = 0; k < 3; ++k) {
        Vec unit;
        unit[k] = 1;
        const Vec column = rotate(pose.q, unit);
        out.at[k] = pose.p[k];
        for (int row = 0; row < 3; ++row) out.turn[3 * row + k] = column[row];
    }
    return out;
}

// A turn about z that takes x to where q's x heads; none where that is straight up or down.
Quat heading_of(Quat q)
{
    const Vec x = rotate(q, {1, 0, 0});
    const double flat = std::sqrt(x.x * x.x + x.y * x.y);
    if (!(flat > 1e-9)) return {1, 0, 0, 0};
    // Half the angle, from its cosine: of the two halves the one whose square root loses nothing.
    const double cosine = x.x / flat, sine = x.y / flat;
    if (cosine > 0) {
        const double w = std::sqrt((1 + cosine) / 2);
        return {w, 0, 0, sine / (2 * w)};
    }
    const double z = std::sqrt((1 - cosine) / 2);
    return {sine / (2 * z), 0, 0, z};
}

Vec vec_at(const double* from, int number)
{
    return {from[3 * number], from[3 * number + 1], from[3 * number + 2]};
}

}  // namespace

RayCaster::RayCaster(const BatchModel& model) : space_(dSimpleSpaceCreate(nullptr))
{
    if (!space_) throw std::bad_alloc();
    const Prepared& prepared = *model.asked.prepared;
    poses_.resize(prepared.model().links.size());
    int number = 0;
    for (size_t link = 0; link < prepared.model().links.size(); ++link)
        for (const Shape& shape : prepared.model().links[link].shapes) {
            for (int part = 0; part < parts_of(prepared, shape); ++part) {
                const AskedShape its{number, &shape, part};
                if (const dGeomID geom = make_geom(space_, prepared, shape, part)) {
                    solids_.push_back({its, int(link), geom});
                }
            }
            ++number;
        }
}

RayCaster::~RayCaster() { dSpaceDestroy(space_); }

void RayCaster::put_solids()
{
    for (const Solid& solid : solids_) {
        const Pose at = poses_[size_t(solid.link)] * solid.shape.shape->pose;
        put_geom(solid.geom, solid.shape.shape->kind, asked_pose(at));
    }
}

void RayCaster::choose(const Rays& rays)
{
    for (const Solid& solid : solids_)
        solid.link == rays.link&& rays.link != 0 ? dGeomDisable(solid.geom) : dGeomEnable(solid.geom);
    from_ = poses_[size_t(rays.link)];
    if (rays.axes == RayAxes::kWorld) from_.q = {1, 0, 0, 0};
    if (rays.axes == RayAxes::kUpright) from_.q = heading_of(from_.q);
}

RayHit RayCaster::cast_one(const Rays& rays, int number) const
{
    const Vec from = from_ * vec_at(rays.origins, number),
              along = rotate(from_.q, vec_at(rays.directions, number));
    const dVector3 origin = {dReal(from.x), dReal(from.y), dReal(from.z)},
                   direction = {dReal(along.x), dReal(along.y), dReal(along.z)};
    dQueryHit hit;
    if (!dSpaceRayClosest(space_, origin, direction, dReal(rays.reach), nullptr, &hit)) return {};
    return {double(hit.distance), number_of(hit.geom)};
}

int RayCaster::number_of(dGeomID geom) const
{
    for (const Solid& solid : solids_)
        if (solid.geom == geom) return solid.shape.number;
    return -1;
}

}  // namespace epode::batch
