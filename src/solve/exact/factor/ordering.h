// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Chooses the order in which to eliminate the bodies of an island, so that the factor of H stays sparse.
#pragma once

#include "solve/exact/factor/body_graph.h"

namespace epode {

// order[k] = the body to eliminate k-th. Scratch comes from the arena and is given back. False: out of
// memory.
bool order_minimum_degree(const BodyGraph& graph, Arena& arena, std::span<int> order);

}  // namespace epode
