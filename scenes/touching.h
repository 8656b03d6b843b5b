// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Penetration at rest apart from penetration at impact. A body that arrives at speed v is found up to v h
// deep in the other one, whatever the stepper does next: that is the step's size, no fault of the solver.
// What lies still and is deep in something is one. A contact counts as
//     at rest    if its two geoms have touched in each of the last kRestSteps steps, this one included, and
//                their surfaces now move against each other at that point by less than kRestSpeed
//     at impact  otherwise: it has just begun, slides, rolls, or something falls on it.
// Depths and speeds are those with which a step begins, so the speed times the step is what an impact
// explains.
#pragma once

#include <unordered_map>

#include "scenes/scene.h"

namespace epode::scenes {

constexpr int kRestSteps = 10;
constexpr double kRestSpeed = 0.1;  // m/s

struct Impact {
    double depth = 0;  // m
    int step = 0;      // counted from 1
    double speed = 0;  // with which the two geoms came together when they first touched, m/s
};

class Touching {
  public:
    explicit Touching(const Scene& scene) { remember(scene); }
    // After each step.
    void observe(const Scene& scene);

    double at_rest = 0;  // the deepest so far, m
    Impact at_impact;

  private:
    struct Pair {
        dGeomID a, b;
        bool operator==(const Pair&) const = default;
    };
    struct PairHash {
        size_t operator()(const Pair& pair) const
        {
            return std::hash<dGeomID>()(pair.a) * 31 + std::hash<dGeomID>()(pair.b);
        }
    };
    struct Touch {
        int since = 0, last = 0;  // steps
        double speed = 0;         // at the first
    };
    struct Motion {
        double pos[3], linear[3], angular[3];
    };
    void remember(const Scene& scene);
    void velocity_at(dGeomID geom, const double* pos, double* velocity) const;
    void judge(const ContactRecord& contact);

    int step_ = 0;
    std::unordered_map<Pair, Touch, PairHash> touches_;
    std::unordered_map<dBodyID, Motion> motions_;  // at the beginning of the last step
};

}  // namespace epode::scenes
