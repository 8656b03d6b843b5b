// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "fluid/water_level.h"

#include "base/check.h"
#include "base/float_environment.h"

namespace epode {
namespace {

Real surface_height(const Fluid& fluid, Vec3 place)
{
    dVector3 at = {};
    store(at, place);
    Real height;
    {
        const CallerFloatEnvironment program;
        height = fluid.surface(fluid.surface_data, at, fluid.time);
    }
    return usable(height) ? height : Real(0);
}

Real reach(const FloatingGeom& geom, Vec3 direction)
{
    return dot(abs(transposed_times(geom.pose().R, direction)), geom.half_extent());
}

}  // namespace

WaterPlane level_at(const Fluid& fluid, const FloatingGeom& geom)
{
    const WaterPlane flat{fluid.normal, fluid.offset};
    if (!fluid.surface) return flat;
    constexpr Real kPlace = Real(0.57735026918962576451);  // 1 / sqrt(3)
    Vec3 t[2];
    plane_space(flat.normal, t[0], t[1]);
    const Vec3 foot = geom.place() - flat.height(geom.place()) * flat.normal;
    const Real e[2] = {kPlace * reach(geom, t[0]), kPlace * reach(geom, t[1])};
    Real height = 0, slope[2] = {};
    for (const Real i : {Real(-1), Real(1)})
        for (const Real j : {Real(-1), Real(1)}) {
            const Real z = surface_height(fluid, foot + i * e[0] * t[0] + j * e[1] * t[1]) / 4;
            height += z, slope[0] += i * z, slope[1] += j * z;
        }
    Vec3 normal = flat.normal;
    for (int k = 0; k < 2; ++k)
        if (e[k] > 0) normal += (-slope[k] / e[k]) * t[k];
    normal = normalized_or(normal, flat.normal);
    return {normal, dot(normal, foot + height * flat.normal)};
}

bool holds(const Fluid& fluid, Vec3 place)
{
    if (!fluid.volume) return true;
    Geom* const volume = from_handle<Geom>(fluid.volume);
    return volume && contains(*volume, place);
}

Vec3 current_at(const Fluid& fluid, Vec3 place)
{
    const Vec3 usual = load(fluid.settings.current);
    if (!fluid.current) return usual;
    dVector3 at = {}, velocity = {};
    store(at, place), store(velocity, usual);
    {
        const CallerFloatEnvironment program;
        fluid.current(fluid.current_data, at, fluid.time, velocity);
    }
    return usable(velocity, 3) ? load(velocity) : Vec3{};
}

}  // namespace epode
