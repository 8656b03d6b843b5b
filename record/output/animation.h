// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A recording made ready to be shown: at chosen moments, frames that move (carriers) and parts that ride on
// them. A carrier is a body, or a geom that was moved by hand or changed its body; everything else rides or
// stands. Numbers that are not finite are replaced by the last ones that were, quaternions are of unit length
// and each is on the side of the one before it, so that whoever interpolates goes the short way round.
#pragma once

#include "record/file/recording.h"

namespace epode::record {

struct Carrier {
    std::int32_t body = kNobody;  // kNobody: a geom on its own
    std::vector<Pose> poses;      // one for each moment; before and after its life the nearest one of it
    std::vector<std::uint8_t> alive;
    bool moves = false;  // poses differ
    bool always_alive = true;
};

constexpr std::int32_t kNoCarrier = -1;

struct Part {
    std::uint32_t geom = 0, solid = 0;
    Vec3 scale{1, 1, 1};  // of the solid
    std::int32_t carrier = kNoCarrier;
    Pose pose;                    // on the carrier, or of the world
    std::int32_t body = kNobody;  // whose colour it has
};

struct Animation {
    std::vector<size_t> steps;  // the moments, always with the first and the last state
    std::vector<float> times;   // of the moments, s, strictly rising
    std::vector<Carrier> carriers;
    std::vector<Part> parts;
    std::vector<Shape> solids;  // what parts look like: shapes that differ in size alone share one
    double reach = 0;           // how far from the origin bodies go, m
};

// False, and why, where the animation would be out of all proportion to the recording.
bool can_animate(const Recording& recording, double fps, std::string& problem);
// About fps moments a second of simulated time, or every state where there are fewer.
Animation make_animation(const Recording& recording, double fps);

// x -> a(b(x)).
Pose compose(const Pose& a, const Pose& b);

}  // namespace epode::record
