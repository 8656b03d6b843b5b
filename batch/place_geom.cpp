// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See place_geom.h.
#include "batch/place_geom.h"

namespace epode::batch {

using namespace robots;

// ODE's height fields have y up, and z towards the shape's -y.
void put_geom(dGeomID geom, ShapeKind kind, const AskedPose& pose)
{
    const auto column = [&](int k) -> Vec { return {pose.turn[k], pose.turn[3 + k], pose.turn[6 + k]}; };
    const Vec x = column(0), y = column(1), z = column(2), at{pose.at[0], pose.at[1], pose.at[2]};
    if (kind == ShapeKind::kPlane)
        return dGeomPlaneSetParams(geom, dReal(z.x), dReal(z.y), dReal(z.z), dReal(dot(z, at)));
    const bool lies = kind == ShapeKind::kHeights;
    const Vec second = lies ? z : y, third = lies ? -y : z;
    const dMatrix3 turn = {dReal(x.x), dReal(second.x), dReal(third.x), 0,
                           dReal(x.y), dReal(second.y), dReal(third.y), 0,
                           dReal(x.z), dReal(second.z), dReal(third.z), 0};
    dGeomSetPosition(geom, dReal(at.x), dReal(at.y), dReal(at.z));
    dGeomSetRotation(geom, turn);
}

}  // namespace epode::batch
