// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// By which one remembers where a geom stood. 0 stands for nowhere.
#pragma once

#include "base/streams/content_hash.h"
#include "collide/geom.h"

namespace epode {

inline std::uint64_t pose_hash(Geom& geom)
{
    const Pose pose = pose_of(geom);
    ContentHash hash;
    hash.add(&pose.p.x, 3);
    for (int row = 0; row < 3; ++row) hash.add({pose.R.row(row).x, pose.R.row(row).y, pose.R.row(row).z});
    return hash.value();
}

}  // namespace epode
