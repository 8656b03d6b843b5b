// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See describe.h.
#include "collide/describe.h"

#include "collide/character.h"
#include "collide/collide.h"

namespace epode {

void describe(DifWriter& out, const Geom& geom)
{
    if (geom.category != ~0ul) out.bits("category_bits", geom.category);
    if (geom.collide != ~0ul) out.bits("collide_bits", geom.collide);
    if (!geom.enabled) out.integer("disabled", 1);
    if (geom.type->describe) geom.type->describe(geom, out);
}

std::uint64_t shape_hash(Geom& geom)
{
    const std::uint32_t changes = changes_of(geom);
    if (geom.hashed_changes == changes) return geom.shape_hash;
    ContentHash hash;
    hash.add(std::uint64_t(geom.type->number));
    DifWriter out(hash);
    if (geom.character)
        add_shape_of_character(geom, hash);
    else if (geom.type->describe)
        geom.type->describe(geom, out);
    if (geom.type->fingerprint) geom.type->fingerprint(geom, hash);
    geom.hashed_changes = changes;
    return geom.shape_hash = hash.value();
}

}  // namespace epode
