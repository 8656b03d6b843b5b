// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Contacts of one pair sorted into manifolds by their normals, at most four points each, where these points
// are as the two move, and the impulses that they inherit from those that were near them a step before.
#pragma once

#include <span>

#include "contacts/contact_pair.h"

namespace epode {

// Fills the manifolds of `parts`: count and normal.
class ManifoldMaker {
  public:
    explicit ManifoldMaker(std::span<CachedManifold> parts);

    // The normal must lead into g1, as dCollide gives it. Contacts of several kinds are not in one manifold, as far as there
    // are enough.
    void add(const dContactGeom& contact, int kind = 0);
    // Leaves the best four of each manifold that has more.
    void finish();
    int used() const { return used_; }
    int count(int part) const { return counts_[part]; }  // of its points
    bool at_border(int part) const;                      // all of them
    const dContactGeom& source(int part, int point) const { return *chosen_[part][point]; }

  private:
    static constexpr int kMaxPoints = 16;

    int part_for(Vec3 normal, int kind);
    void keep_four(int part);

    std::span<CachedManifold> parts_;
    const dContactGeom* chosen_[kSurfaceManifolds][kMaxPoints];
    int counts_[kSurfaceManifolds] = {}, kinds_[kSurfaceManifolds] = {};
    int used_ = 0;
};

// Where points of what stands are fixed: in the frame of a lattice point near x1, which is its own place unless that is far
// away. Anchors are floats: on a plane, or in a landscape, they would know a place a thousand kilometres off to 6 cm.
Pose frame_of_anchors(const Pose& own, Vec3 x1, bool stands);

// Fixes the points of a manifold in both geoms, which were at A and B when they were found: one place in both, or, of
// contacts that lie on the surface of g1, in each the place on its own surface.
enum class Anchors { kTogether, kOnSurfaces };
void fix_points(const ManifoldMaker& maker, int part, const Pose& A, const Pose& B, Anchors how,
                ContactAnchors& anchors);

// The square of how far from the geom's place one of the points is: what a turn moves it by.
Real largest_reach2(const float (&at)[3][kManifoldPoints]);

// The normal and where the points of a manifold are now, seen from the bodies at x1 and *x2 (null: none), and
// their gaps along the normal beyond the layer. True if one of them touches. `manifold` is a copy of
// was.manifold, or it.
bool place_points(const Pose& pose1, const Pose& pose2, Vec3 x1, const Vec3* x2, Real layer,
                  const CachedManifold& was, ContactManifold& manifold);

// The arms of points that have just been found at the present poses. Anchors know them to a float of how far they are from their geom's
// place: a ball that rests far out on a plane would roll off.
void place_found(const ManifoldMaker& maker, int part, Vec3 x1, const Vec3* x2, ContactManifold& manifold);

// Points of `part` take the impulses of the nearest points of `was`, within a tenth of `size` in the frame of
// either body; so does the manifold its couple.
void inherit_impulses(const CachedManifold& was, Real size, CachedManifold& part);

}  // namespace epode
