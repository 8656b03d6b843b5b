// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A recording as binary glTF 2.0, which Blender, three.js and every browser's viewer open. A mesh for each
// shape and colour, a node for each body with its animation (linear, translation and rotation), under it a
// node for each of its geoms; the root turns z up into glTF's y up. Things that come or go are scaled to
// nothing while they are not there, since glTF 2.0 cannot hide a node over time.
#pragma once

#include "record/file/recording.h"

namespace epode::record {

bool write_glb(const Recording& recording, const std::string& path, double fps, std::string& problem);

}  // namespace epode::record
