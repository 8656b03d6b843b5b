// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See describe.h.
#include "collide/describe.h"

namespace epode {

void describe(DifWriter& out, const Geom& geom)
{
    if (geom.category != ~0ul) out.bits("category_bits", geom.category);
    if (geom.collide != ~0ul) out.bits("collide_bits", geom.collide);
    if (!geom.enabled) out.integer("disabled", 1);
    if (geom.type->describe) geom.type->describe(geom, out);
}

}  // namespace epode
