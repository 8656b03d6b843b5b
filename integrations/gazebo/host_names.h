// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What hosts need of Gazebo's libraries next to names.h: to load a plugin and to make an engine of it.
#pragma once

#include "integrations/gazebo/names.h"

// clang-format would put spaces into the paths.
// clang-format off
#include GZ_HEADER(physics/RequestEngine.hh)
#include GZ_HEADER(plugin/Loader.hh)
// clang-format on
