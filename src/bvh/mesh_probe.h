// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A convex solid as the leaves of a mesh's tree turn it away, four triangles at a time in floats, in the
// solid's own frame: v the first corner from its middle, e its edges, n their cross product. Directions
// tried:
//   ball      n; each corner as seen from the middle, each edge's nearest point
//   box       its faces; n; its edges x the triangle's
//   rod       capsules and cylinders: their axis z; n; o = e x n across each edge; and what of the ball is
//             left when all is seen along z: circle and triangle in the plane
// Any direction may part the two, so how well it is known does not matter: only that corners are off by
// some 2^-22 of their distances, which kMeshMargin, put around the solid, is eight times. But where one
// corner stands for all, along n and o, the others may be off by 2^-22 E^3 and 2^-22 E^4 with edges of length
// E (sum of components), which `blur` covers as often.
#pragma once

#include "bvh/mesh_packet.h"

namespace epode {

enum class ProbeKind : unsigned char { kBall, kBox, kCapsule, kCylinder };

// In the frame of the mesh.
struct SolidProbe {
    ProbeKind kind = ProbeKind::kBall;
    Vec3 centre;
    Mat3 R;          // its axes are the columns; of a ball not used
    Vec3 half;       // of a box; of a rod z is
    Real round = 0;  // radius of a ball or rod
    Real slack = 0;  // what is apart by less is met
};

// The same in floats, in the tree's frame.
class MeshProbe {
  public:
    MeshProbe(const SolidProbe& solid, Vec3 centre_in_frame, Real scale);
    // Bits of the lanes that may be met, of those that are asked for.
    unsigned meets(const MeshPacket& packet, unsigned asked) const
    {
        return kind_ == ProbeKind::kBall  ? ball_meets(packet, asked)
               : kind_ == ProbeKind::kBox ? box_meets(packet, asked)
                                          : rod_meets(packet, asked);
    }

  private:
    unsigned ball_meets(const MeshPacket& packet, unsigned asked) const;
    unsigned box_meets(const MeshPacket& packet, unsigned asked) const;
    unsigned rod_meets(const MeshPacket& packet, unsigned asked) const;

    ProbeKind kind_;
    float centre_[3];
    float axis_[3][3];  // rows: coordinates in the solid's frame
    float half_[3];     // with slack and margin
    float round_;       // the same
    float slack_, size_;
};

}  // namespace epode
