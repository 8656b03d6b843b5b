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
    explicit PatchMaker(std::span<ContactPair> parts);

    // The normal must lead into g1, as dCollide gives it.
    void add(const dContactGeom& contact);
    // Leaves the best four of each patch that has more.
    void finish();
    const dContactGeom& source(int part, int point) const { return *chosen_[part][point]; }

  private:
    static constexpr int kMost = 16;

    int part_for(Vec3 normal);
    void keep_four(int part);

    std::span<ContactPair> parts_;
    const dContactGeom* chosen_[kSurfaceParts][kMost];
    int counts_[kSurfaceParts] = {};
    int used_ = 0;
};

// Points of `part` take the impulses of the nearest points of `was`, within a tenth of `size` in the frame of
// either body.
void inherit_impulses(const ContactPair& was, Real size, ContactPair& part);

}  // namespace epode
