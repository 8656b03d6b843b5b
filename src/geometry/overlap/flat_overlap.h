// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The least overlap where a solid has flat faces, by trying what can be least and nothing else. With C and
// h(n) as in epa.h: the ball about the origin that touches the boundary of C lies within C, so it touches
// where C is flat or curved less than the ball, never at an edge or corner of C. That leaves
//   both flat      a face of either, or an edge of each: n = product of the edges, where their arcs on the
//                  sphere of normals cross (Gottschalk, Lin, Manocha 1996; the arcs as in Gregorius' talk of
//                  2013)
//   one is round   a face of either; an edge and the rim, or an edge and the side: n turns about the edge, a
//                  root in one unknown; a corner and the side: n is radial
//   cylinders      an end of either; the two sides: n = product of the axes; a side and a rim: n turns about
//                  the side's axis; two rims: two unknowns, sought downhill from the best of the others
// Three bounds keep the lists short. A solid that holds a ball of radius rho about c overlaps the far side of
// a plane by at least rho less the height of c over it; edges of which neither face can come below the depth
// so far drop out. So do edges that are farther from the other solid than that depth. And where a point lies
// within one solid by r and within the other by s, no overlap is less than r + s: a contact point often
// proves the face normal right before any edge is looked at.
#pragma once

#include "geometry/hulls/flat_solid.h"
#include "geometry/overlap/epa.h"

namespace epode {

// Faces come before edges by so much of the size.
inline constexpr Real kPreference = kSingle ? Real(1e-5) : Real(1e-9);

// Two boxes or polyhedra.
class FlatPair {
  public:
    FlatPair(const ConvexView& a, const ConvexView& b);
    FlatPair(const FlatPair&) = delete;
    FlatPair& operator=(const FlatPair&) = delete;

    // The least overlap along normals of faces, or less than `enough`, which proves the solids apart.
    void try_faces(Real enough);
    // A point by which no other normal can be better; in the world, or the deepest corner known.
    bool proven_at(Vec3 point) const;
    bool proven() const;
    // All other normals.
    void try_rest(Real enough);

    Overlap best;  // normal in the world

  private:
    void try_faces_of(const FlatSolid& s, const FlatSolid& other, const Pose& place, bool first, Real enough);

    const ConvexView& a_;
    const ConvexView& b_;
    FlatSolid flat_a_, flat_b_;
    Pose b_in_a_, a_in_b_;
    Real handicap_;
    Vec3 normal_;   // in a's frame
    Vec3 deepest_;  // corner of the other solid, in the frame of the one whose face it is
    bool of_first_ = true;
};

// A box or polyhedron and a round core.
class RoundPair {
  public:
    RoundPair(const ConvexView& a, const ConvexView& b);
    RoundPair(const RoundPair&) = delete;
    RoundPair& operator=(const RoundPair&) = delete;

    void try_faces(Real enough);
    bool proven_at(Vec3 point) const;
    bool proven() const;
    void try_rest(Real enough);

    Overlap best;

  private:
    void offer(Vec3 outward, Real depth, Real handicap);  // from the flat solid, in its frame
    void try_end(Vec3 outward);
    Vec3 nearest_to_axis() const;  // of the corners

    const ConvexView& flat_view_;
    const ConvexView& round_view_;
    Real sense_;  // of the normal: 1 when the round one is a
    FlatSolid flat_;
    RoundCore round_;
    Pose round_in_flat_;
    FaceGaps gap_;  // of the core's middle
    Real handicap_;
    Vec3 outward_;
};

// Two cylinders. All in a's frame but `best`.
class CylinderPair {
  public:
    CylinderPair(const ConvexView& a, const ConvexView& b);

    void try_faces(Real enough);
    bool proven_at(Vec3 point) const;
    bool proven() const;
    void try_rest(Real enough);

    Overlap best;

  private:
    Real overlap(Vec3 n, Vec3& point) const;
    Real overlap(Vec3 n) const
    {
        Vec3 point;
        return overlap(n, point);
    }
    void offer(Vec3 n, Real depth, Real handicap);
    void turn_about(bool first, Real enough);
    void descend(Vec3 n);
    void leave_end(Vec3 axis, Real radius);

    const ConvexView& a_;
    const ConvexView& b_;
    RoundCore one_, two_;
    Pose b_in_a_;
    Vec3 axis_;  // of b
    Real handicap_, size_;
    Vec3 normal_;
    bool end_of_a_ = false, end_of_b_ = false;
};

// use(pair) with the one of these that knows both solids; false if none does.
template <class Use>
bool with_pair(const ConvexView& a, const ConvexView& b, const Use& use)
{
    const bool flat_a = FlatSolid::is_flat(a), flat_b = FlatSolid::is_flat(b);
    if (flat_a && flat_b)
        use(FlatPair(a, b));
    else if ((flat_a && RoundCore::is_round(b)) || (flat_b && RoundCore::is_round(a)))
        use(RoundPair(a, b));
    else if (a.kind == SolidKind::kCylinder && b.kind == SolidKind::kCylinder)
        use(CylinderPair(a, b));
    else
        return false;
    return true;
}

}  // namespace epode
