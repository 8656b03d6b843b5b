// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// ODE's collision functions on plain numbers instead of geoms, and the low-level control that only meshes
// have.
#include <algorithm>

#include "base/check.h"
#include "base/float_environment.h"
#include "collide/types/registry.h"
#include "geometry/closest.h"
#include "geometry/overlap/box_box.h"

using namespace epode;

namespace {

bool usable_box(const dReal* p, const dReal* R, const dReal* side)
{
    return p && R && side && usable(p, 3) && usable(R, 3) && usable(R + 4, 3) && usable(R + 8, 3) &&
           usable(side, 3);
}

Box box_of_sides(const dReal* side) { return {Real(0.5) * load(side)}; }

// All points, or the `count` deepest ones, the deepest first and ties by index.
void write_contacts(const BoxBox& m, int count, dContactGeom* contact, int skip)
{
    bool written[BoxBox::kMax] = {};
    for (int i = 0; i < count; ++i) {
        int best = -1;
        for (int k = 0; k < m.count; ++k)
            if (!written[k] && (best < 0 || (count < m.count && m.depths[k] > m.depths[best]))) best = k;
        written[best] = true;
        auto* c =
            reinterpret_cast<dContactGeom*>(reinterpret_cast<char*>(contact) + std::ptrdiff_t(i) * skip);
        store(c->pos, m.points[best]);
        c->depth = m.depths[best];
    }
}

}  // namespace

extern "C" {

void dClosestLineSegmentPoints(const dVector3 a1, const dVector3 a2, const dVector3 b1, const dVector3 b2,
                               dVector3 cp1, dVector3 cp2)
{
    const FloatEnvironment floats;
    EPODE_USER(a1 && a2 && b1 && b2 && cp1 && cp2);
    Vec3 p, q;
    closest_segment_points(load(a1), load(a2), load(b1), load(b2), p, q);
    store(cp1, p);
    store(cp2, q);
}

int dBoxTouchesBox(const dVector3 p1, const dMatrix3 R1, const dVector3 side1, const dVector3 p2,
                   const dMatrix3 R2, const dVector3 side2)
{
    const FloatEnvironment floats;
    EPODE_USER(usable_box(p1, R1, side1) && usable_box(p2, R2, side2), 0);
    return boxes_touch(box_of_sides(side1), load_pose(p1, R1), box_of_sides(side2), load_pose(p2, R2));
}

int dBoxBox(const dVector3 p1, const dMatrix3 R1, const dVector3 side1, const dVector3 p2, const dMatrix3 R2,
            const dVector3 side2, dVector3 normal, dReal* depth, int* return_code, int flags,
            dContactGeom* contact, int skip)
{
    const FloatEnvironment floats;
    EPODE_USER(usable_box(p1, R1, side1) && usable_box(p2, R2, side2), 0);
    EPODE_USER(normal && depth && return_code && contact && skip >= int(sizeof(dContactGeom)), 0);
    EPODE_USER_SAY((flags & 0xffff) != 0, "no contacts requested", 0);
    BoxBox m;
    if (!box_box_manifold(box_of_sides(side1), load_pose(p1, R1), box_of_sides(side2), load_pose(p2, R2),
                          m)) {
        *return_code = 0;
        return 0;
    }
    store(normal, m.normal);
    *depth = m.deepest();
    *return_code = m.code;
    const int count = std::min(m.count, flags & 0xffff);
    write_contacts(m, count, contact, skip);
    return count;
}

int dGeomLowLevelControl(dGeomID id, int control_class, int control_code, void* data, int* data_size)
{
    EPODE_GEOM(geom, id, 0);
    EPODE_USER(data_size, 0);
    if (geom->type->control) return geom->type->control(*geom, control_class, control_code, data, data_size);
    *data_size = 0;
    return 0;
}

}  // extern "C"
