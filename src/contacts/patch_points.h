// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Contacts of one pair sorted into patches by their normals, at most four points each, and the impulses that
// points inherit from those that were near them a step before.
#pragma once

#include <span>

#include "contacts/contact_pair.h"

namespace epode {

// Fills the patches of `parts`: count and normal.
class PatchMaker {
  public:
    explicit PatchMaker(std::span<KeptPatch> parts);

    // The normal must lead into g1, as dCollide gives it.
    void add(const dContactGeom& contact);
    // Leaves the best four of each patch that has more.
    void finish();
    int used() const { return used_; }
    const dContactGeom& source(int part, int point) const { return *chosen_[part][point]; }

  private:
    static constexpr int kMost = 16;

    int part_for(Vec3 normal);
    void keep_four(int part);

    std::span<KeptPatch> parts_;
    const dContactGeom* chosen_[kSurfacePatches][kMost];
    int counts_[kSurfacePatches] = {};
    int used_ = 0;
};

// Points of `part` take the impulses of the nearest points of `was`, within a tenth of `size` in the frame of
// either body; so does the patch its couple.
void inherit_impulses(const KeptPatch& was, Real size, KeptPatch& part);

}  // namespace epode
