// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What the C functions of robots share. Each checks its arguments, sends one message for what it refuses, and lets
// nothing that is thrown pass.
#pragma once

#include <algorithm>
#include <cmath>
#include <new>

#include "epode/robots.h"
#include "robots/build.h"
#include "robots/handles.h"
#include "robots/numbers.h"
#include "robots/sensors.h"

struct dxRobotModel {
    epode::robots::RobotModel model;
    std::shared_ptr<const epode::robots::Prepared> prepared;  // made for the first robot
};

struct dxRobot {
    std::unique_ptr<epode::robots::Robot> robot;
    std::unique_ptr<epode::robots::Sensors> sensors;
};

namespace epode::robots {

// What a handle names, or null: then it is null, was destroyed, or is something else's.
inline dxRobotModel* alive(dRobotModelID model) { return Handles<dxRobotModel>::all().find(model); }
inline dxRobot* alive(dRobotID robot) { return Handles<dxRobot>::all().find(robot); }

// False after a message: what was refused and what would be accepted.
inline bool check(bool good, const char* function, const char* wanted)
{
    if (!good) dMessage(d_ERR_UNKNOWN, "%s: refused; wanted: %s", function, wanted);
    return good;
}

#define CHECK(good, wanted)                                           \
    do {                                                              \
        if (!epode::robots::check(good, __func__, wanted)) return {}; \
    } while (false)

#if defined(__cpp_exceptions)
template <class Action>
auto guarded(const char* function, Action&& action) -> decltype(action())
{
    try {
        return action();
    } catch (const std::bad_alloc&) {
        dMessage(d_ERR_UNKNOWN, "%s: out of memory", function);
    } catch (const std::exception& error) {
        dMessage(d_ERR_UNKNOWN, "%s: %s", function, error.what());
    }
    return {};
}
#else  // WebAssembly: what would throw is a trap, which wasm/npm/src/robots makes an error of
template <class Action>
auto guarded(const char*, Action&& action) -> decltype(action())
{
    return action();
}
#endif

inline bool is_usable(dReal value) { return std::fabs(double(value)) <= kMaxNumber; }  // false for NaN

inline bool are_usable(const dReal* values, int count)
{
    return std::all_of(values, values + count, is_usable);
}

inline bool is_distance(dReal distance)
{
    return distance >= 0 && (is_usable(distance) || distance == dReal(dInfinity));
}

// None of length 0.
inline bool are_directions(const dReal* directions, int count)
{
    for (int i = 0; i < count; ++i) {
        const dReal* d = directions + 3 * size_t(i);
        if (!are_usable(d, 3) || (d[0] == 0 && d[1] == 0 && d[2] == 0)) return false;
    }
    return true;
}

// Only libode knows its handles. What is null or none is refused, with a message of libode if it is not null.
inline bool is_world(dWorldID world) { return world && dWorldGetQuickStepNumIterations(world) > 0; }
inline bool is_space(dSpaceID space) { return space && dGeomIsSpace(reinterpret_cast<dGeomID>(space)); }

inline int copy_positions(const std::vector<double>& from, dReal* to, int capacity)
{
    for (int i = 0; i < std::min(capacity, int(from.size())); ++i) to[i] = dReal(from[size_t(i)]);
    return int(from.size());
}

inline std::vector<double> doubles_of(const dReal* values, int count) { return {values, values + count}; }

inline bool can_compute(dRobotModelID model, const dReal* positions)
{
    if (!model || model->model.has_errors()) return false;
    const int count = model->model.coordinates;
    return count == 0 || (positions && are_usable(positions, count));
}

}  // namespace epode::robots
