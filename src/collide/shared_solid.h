// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Polyhedra that geoms share. A pile of a thousand rocks has a few shapes, and geoms made of the same points
// share one solid: one of each stays in the processor's cache, a thousand do not. Programs do not see the
// sharing: a geom that gets other points leaves the solid to the others.
#pragma once

#include "geometry/hulls/polyhedron.h"

namespace epode {

class SharedSolid {
  public:
    SharedSolid() = default;
    SharedSolid(SharedSolid&& other) noexcept { swap(other); }
    SharedSolid& operator=(SharedSolid&& other) noexcept
    {
        swap(other);
        return *this;
    }
    ~SharedSolid();

    // Takes what is in `made`, unless a solid with the same bits is among the most recently requested.
    // False when memory is exhausted.
    [[nodiscard]] bool take(Polyhedron& made);

    const Polyhedron* get() const;                    // null: none
    static SharedSolid of(const Polyhedron& shared);  // another hold of what get() has returned

  private:
    struct Entry;
    struct Cache;
    static Cache& cache();
    void swap(SharedSolid& other) noexcept;

    Entry* entry_ = nullptr;
};

}  // namespace epode
