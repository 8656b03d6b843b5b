// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What the bindings of models and of robots in worlds share: what a handle of each holds, and arrays from and to Python.
#pragma once

#include "calls.h"

#ifdef EPODE_HAVE_ROBOTS

#include <algorithm>
#include <cmath>

#include "robots/build.h"
#include "robots/sensors.h"

namespace bound {

using namespace epode::robots;

using Reals = std::vector<double>;

struct Model {
    RobotModel model;
    std::shared_ptr<const Prepared> prepared;  // made for the first robot
};

// A robot in a world and its sensors.
struct Built {
    std::unique_ptr<Robot> robot;
    std::unique_ptr<Sensors> sensors;
    const RobotModel& model() const { return robot->model(); }
    void release() { sensors->release(), robot->release(); }
};

inline nb::object row(const Reals& values)
{
    dReal* data;
    nb::object out = real_array(values.size(), 0, &data);
    std::copy(values.begin(), values.end(), data);
    return out;
}
inline nb::object row(Vec v) { return row(Reals{v.x, v.y, v.z}); }
inline nb::object row(const Pose& p) { return row(Reals{p.p.x, p.p.y, p.p.z, p.q.w, p.q.x, p.q.y, p.q.z}); }

inline nb::object table(const Reals& values, size_t rows, size_t columns)
{
    dReal* data;
    nb::object out = real_table(rows, columns, &data);
    std::copy(values.begin(), values.end(), data);
    return out;
}

// Finite numbers, as many as wanted.
inline Reals read(nb::handle from, size_t count, const char* what)
{
    const auto array = array_in<double>(from);
    Reals out(array.data, array.data + array.size);
    for (double value : out)
        if (!std::isfinite(value)) throw nb::value_error((std::string(what) + " must be finite").c_str());
    if (out.size() == count) return out;
    const std::string text = std::string(what) + ": " + std::to_string(count) + " numbers expected, not " +
                             std::to_string(out.size());
    throw nb::value_error(text.c_str());
}

inline Reals read_or_nothing(nb::handle from, size_t count, const char* what)
{
    return from.is_none() ? Reals() : read(from, count, what);
}

inline Pose read_pose(nb::handle from)
{
    const Reals v = read(from, 7, "pose");
    return {{v[0], v[1], v[2]}, normalised({v[3], v[4], v[5], v[6]})};
}

inline size_t speeds(const RobotModel& model) { return size_t(number_of_velocities(model)); }

Built* build(Model& m, const WorldHandle& world, const SpaceHandle& space, nb::object pose);

}  // namespace bound

void bind_robot_models(nb::module_& m);

#endif
