// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Rejects triangles that a convex solid cannot touch, four at a time in floats, in the solid's own frame: v
// is the first corner relative to its centre, e the edges, n their cross product. Separating directions that
// are tried:
//
//   ball      n; each corner as seen from the centre; each edge's nearest point
//   box       its faces; n; its edges x the triangle's edges
//   rod       capsules and cylinders: their axis z; n; o = e x n across each edge; and what remains of the
//             ball test when seen along z: circle and triangle in the plane
//
// Any direction may separate the two, so its accuracy does not matter. What matters is that corners are off
// by about 2^-22 of their distances, and kMeshMargin, which is put around the solid, is eight times that.
// Along n and o one corner stands for all of them; the others may be off by 2^-22 E^3 and 2^-22 E^4 with
// edges of length E (sum of components), and `blur` is eight times that.
#pragma once

#include "bvh/mesh_packet.h"

namespace epode {

enum class ProbeKind : unsigned char { kBall, kBox, kCapsule, kCylinder };

// In the frame of the mesh.
struct SolidProbe {
    ProbeKind kind = ProbeKind::kBall;
    Vec3 centre;
    Mat3 R;          // the columns are its axes; unused for a ball
    Vec3 half;       // half sides of a box; for a rod z is half its length
    Real round = 0;  // radius of a ball or rod
    Real slack = 0;  // separations below this count as contact
};

// The same in floats, in the tree's frame.
class MeshProbe {
  public:
    MeshProbe(const SolidProbe& solid, Vec3 centre_in_frame, Real scale);
    // Of the lanes in `candidates`, the bits of those that the solid may touch.
    unsigned meets(const MeshPacket& packet, unsigned candidates) const
    {
        return kind_ == ProbeKind::kBall  ? ball_meets(packet, candidates)
               : kind_ == ProbeKind::kBox ? box_meets(packet, candidates)
                                          : rod_meets(packet, candidates);
    }

  private:
    unsigned ball_meets(const MeshPacket& packet, unsigned candidates) const;
    unsigned box_meets(const MeshPacket& packet, unsigned candidates) const;
    unsigned rod_meets(const MeshPacket& packet, unsigned candidates) const;

    ProbeKind kind_;
    float centre_[3];
    float axis_[3][3];  // rows: coordinates in the solid's frame
    float half_[3];     // with slack and margin
    float round_;       // the same
    float slack_, size_;
};

}  // namespace epode
