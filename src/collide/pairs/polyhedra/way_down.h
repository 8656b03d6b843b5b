// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The straight way down from a point that is in a placed polyhedron or over it: where it leaves, and by which
// faces. Along `up` a face n . x = d is left or entered at the depth (n . v - d) / (n . up): the way leaves by
// faces that look down, at the least of their depths, and has entered by the others before.
#pragma once

#include "collide/pairs/polyhedra/placed_hull.h"

namespace epode {
namespace {

class WayDown {
  public:
    Real depth = 0;

    // False: it misses the polyhedron, or leaves higher than `slack` over v. `distances`: of v from the faces
    // that are left, where they are known.
    bool find(const PlacedHull& hull, Vec3 v, Vec3 up, Real slack, const Real* distances)
    {
        const Ray ray{QuadPlane(v), QuadPlane(up), distances};
        depth = leaves_at(hull, ray);
        if (!(depth >= -slack) || !enters_before(hull, ray)) return false;
        each_face(hull, ray, [this](int face) {
            if (count_ < kKept) faces_[count_] = face;
            return count_++ == kKept;
        });
        return true;
    }
    // Whether one of the faces by which it leaves has a mark.
    bool leaves_by(const PlacedHull& hull, Vec3 v, Vec3 up, const unsigned char* marks) const
    {
        for (int i = 0; i < count_ && i < kKept; ++i)
            if (marks[faces_[i]]) return true;
        return count_ > kKept && each_face(hull, {QuadPlane(v), QuadPlane(up), nullptr},
                                           [marks](int face) { return marks[face] != 0; });
    }

  private:
    static constexpr int kKept = 4;
    struct Ray {
        QuadPlane at, rise;
        const Real* distances;
        EPODE_LANEWISE Quad out(const Real* four) const { return at.along(four) - load_quad(four + 12); }
        EPODE_LANEWISE Quad out(const PlacedHull& hull, int group) const
        {
            return distances ? load_quad(distances + 4 * group) : out(hull.faces(group));
        }
    };
    // Not zero: what is divided by it counts only where it was not.
    EPODE_LANEWISE static Quad usable(const Quad& way)
    {
        return if_less(quad(0), magnitude(way), way, quad(1));
    }

    // No face that is left out looks down.
    static Real leaves_at(const PlacedHull& hull, const Ray& ray)
    {
        Quad leaves = quad(kInf);
        for (int g = 0; g < hull.face_groups(); ++g) {
            const Quad way = ray.rise.along(hull.faces(g));
            leaves = smaller(if_less(way, quad(0), ray.out(hull, g) / usable(way), quad(kInf)), leaves);
        }
        return -largest_lane(quad(0) - leaves);
    }
    bool enters_before(const PlacedHull& hull, const Ray& ray) const
    {
        const Quad none = quad(0);
        for (int g = 0; g < hull.all_face_groups(); ++g) {
            const Real* const four = hull.all_faces(g);
            const Quad way = ray.rise.along(four);
            const unsigned up_or_aside = bits(none <= way);
            if (!up_or_aside) continue;
            const Quad out = ray.out(four);
            const unsigned later = bits(none < way) & bits(quad(depth) < out / usable(way));
            const unsigned aside = bits(none < out) & bits(way <= none);
            if ((later | aside) & up_or_aside) return false;
        }
        return true;
    }
    // Of those by which it leaves, until look() says yes.
    template <typename Look>
    bool each_face(const PlacedHull& hull, const Ray& ray, const Look& look) const
    {
        for (int g = 0; g < hull.face_groups(); ++g) {
            const Quad way = ray.rise.along(hull.faces(g)), down = ray.out(hull, g) / usable(way);
            for (unsigned by = bits(way < quad(0)) & bits(down <= quad(depth)); by; by &= by - 1)
                if (look(4 * g + __builtin_ctz(by))) return true;
        }
        return false;
    }

    int count_ = 0;
    int faces_[kKept];
};

}  // namespace
}  // namespace epode
