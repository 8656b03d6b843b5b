// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A geom as a table of dWorldExportDIF: flags and filter bits where they are not the default, then what its
// type adds. Its pose is left out, as in ODE: it is that of the body, or an offset that the format has no
// field for. And a fingerprint that distinguishes its shape from others, the class included.
#pragma once

#include "base/streams/dif_writer.h"
#include "collide/geom.h"

namespace epode {

// The fields, inside a table that the caller opens.
void describe(DifWriter& out, const Geom& geom);

// Equal for geoms of equal class and shape, whatever their place, body, bits and functions of the program.
// Kept in the geom until its shape changes.
std::uint64_t shape_hash(Geom& geom);

}  // namespace epode
