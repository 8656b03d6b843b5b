// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "scenes/terrain.h"

#include <memory>
#include <vector>

#include "scenes/vectors.h"

namespace epode::scenes {

namespace {

// Heights of a field are along its y, and its z is the world's -y after a turn about x.
std::vector<double> sampled(double side, int samples, const std::function<double(double, double)>& height)
{
    std::vector<double> heights;
    for (int row = 0; row <= samples; ++row)
        for (int column = 0; column <= samples; ++column)
            heights.push_back(
                height((double(column) / samples - 0.5) * side, (0.5 - double(row) / samples) * side));
    return heights;
}

}  // namespace

dGeomID add_terrain(Scene& scene, double side, int samples,
                    const std::function<double(double, double)>& height)
{
    const dHeightfieldDataID data = dGeomHeightfieldDataCreate();
    const std::vector<double> heights = sampled(side, samples, height);
    dGeomHeightfieldDataBuildDouble(data, heights.data(), 1, dReal(side), dReal(side), samples + 1,
                                    samples + 1, 1, 0, 1, 0);
    const dGeomID terrain = dCreateHeightfield(scene.space(), data, 1);
    dMatrix3 upright;
    dRFromAxisAndAngle(upright, 1, 0, 0, dReal(kPi / 2));
    dGeomSetRotation(terrain, upright);
    scene.add_geom(terrain);
    // The heights live as long as the scene's hooks, and that is longer than its geoms.
    const std::shared_ptr<dxHeightfieldData> kept(data, dGeomHeightfieldDataDestroy);
    scene.before_step([kept](double, double) {});
    return terrain;
}

}  // namespace epode::scenes
