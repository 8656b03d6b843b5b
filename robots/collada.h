// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Triangles of a COLLADA 1.4 file (.dae): the geometries that its visual scene shows, with the transforms of their
// nodes and the asset's unit and upward axis.
#pragma once

#include "robots/model.h"

namespace epode::robots {

bool read_collada(const std::string& path, const std::string& text, Mesh& mesh, std::string& problem);

}  // namespace epode::robots
