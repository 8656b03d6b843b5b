// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "assemblies/fracture_parts.h"

#include <algorithm>
#include <cmath>

#include "collide/types/registry.h"
#include "ode/ode.h"
#include "ode/queries.h"
#include "ode/shapes.h"
#include "query/distance.h"

namespace epode {
namespace {

constexpr Real kTouching = Real(0.01);  // of the smaller box

bool is_kind_of_solid(int number)
{
    constexpr int kNumbers[] = {dSphereClass,  dBoxClass,  dCapsuleClass,   dCylinderClass,      dConvexClass,
                                dTriMeshClass, dConeClass, dEllipsoidClass, dTaperedCapsuleClass};
    return std::find(std::begin(kNumbers), std::end(kNumbers), number) != std::end(kNumbers);
}

const char* fault_of_part(const dFracturePart& part)
{
    const Geom* const geom = from_handle<Geom>(part.geom);
    if (!geom) return "geom of a part that is 0 or destroyed";
    if (!is_kind_of_solid(geom->type->number)) return "geom of a part that is no solid";
    if (geom->type->zero_sized && geom->type->zero_sized(*geom)) return "geom of a part that has no size";
    if (in_locked_space(*geom)) return EPODE_LOCKED_TEXT;
    if (geom->holders) return "geom of a part that is in a transform";
    return usable(part.density) && part.density >= 0 ? nullptr : "density of a part (accepted: 0 or more)";
}

dMass solid_of(dGeomID geom, dReal density)
{
    dMass m{};
    dReal a = 0, b = 0, c = 0;
    dVector3 sides;
    switch (dGeomGetClass(geom)) {
        case dSphereClass:
            dMassSetSphere(&m, density, dGeomSphereGetRadius(geom));
            break;
        case dBoxClass:
            dGeomBoxGetLengths(geom, sides);
            dMassSetBox(&m, density, sides[0], sides[1], sides[2]);
            break;
        case dCapsuleClass:
            dGeomCapsuleGetParams(geom, &a, &b);
            dMassSetCapsule(&m, density, 3, a, b);
            break;
        case dCylinderClass:
            dGeomCylinderGetParams(geom, &a, &b);
            dMassSetCylinder(&m, density, 3, a, b);
            break;
        case dConeClass:
            dGeomConeGetParams(geom, &a, &b);
            dMassSetCone(&m, density, 3, a, b);
            break;
        case dEllipsoidClass:
            dGeomEllipsoidGetRadii(geom, sides);
            dMassSetEllipsoid(&m, density, sides[0], sides[1], sides[2]);
            break;
        case dTaperedCapsuleClass:
            dGeomTaperedCapsuleGetParams(geom, &a, &b, &c);
            dMassSetTaperedCapsule(&m, density, 3, a, b, c);
            break;
        case dConvexClass:
            dMassSetConvex(&m, density, geom);
            break;
        default:
            dMassSetTrimesh(&m, density, geom);
    }
    return m;
}

Real size_of(dGeomID id)
{
    dReal box[6];
    dGeomGetAABB(id, box);
    return std::hypot(box[1] - box[0], box[3] - box[2], box[5] - box[4]);
}

bool touch(const dFracturePart& a, const dFracturePart& b)
{
    dReal p[6], q[6];
    dGeomGetAABB(a.geom, p), dGeomGetAABB(b.geom, q);
    const Real gap = kTouching * std::fmin(size_of(a.geom), size_of(b.geom));
    for (int k = 0; k < 6; k += 2)
        if (p[k] > q[k + 1] + gap || q[k] > p[k + 1] + gap) return false;
    dQueryDistance found;
    return dGeomGetDistance(a.geom, b.geom, gap, &found) == 1;
}

}  // namespace

const char* fault_of_list(const dFracturePart* parts, int count)
{
    if (!parts) return "parts that are 0";
    if (count < 1 || count > dFractureMaxParts) return "count of parts (accepted: 1 ... 4096)";
    for (int i = 0; i < count; ++i)
        if (const char* fault = fault_of_part(parts[i])) return fault;
    return nullptr;
}

const char* fault_of_parts(Parts parts)
{
    Array<std::uint64_t> serials;
    if (!serials.resize(int(parts.size()))) return kOutOfMemory;
    for (int i = 0; i < serials.size(); ++i)
        serials[i] = from_handle<Geom>(parts[std::size_t(i)].geom)->serial;
    std::sort(serials.begin(), serials.end());
    return std::adjacent_find(serials.begin(), serials.end()) == serials.end() ? nullptr : kTwice;
}

Pose pose_of_part(const dFracturePart& part)
{
    return load_pose(dGeomGetPosition(part.geom), dGeomGetRotation(part.geom));
}

MassProperties mass_of_part(const dFracturePart& part)
{
    const dMass m = solid_of(part.geom, part.density > 0 ? part.density : Real(1000));
    const MassProperties out{m.mass, load(m.c), symmetric_part(load_mat(m.I))};
    return usable(out) && mass_fault(out) == MassFault::kNone ? out : MassProperties{};
}

MassProperties mass_of_group(Parts parts, std::span<const int> group_of, int group, const Pose& frame)
{
    MassProperties sum{};
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (group_of[i] != group) continue;
        const Pose at = pose_of_part(parts[i]);
        const MassProperties part = rotated(mass_of_part(parts[i]), transpose(frame.R) * at.R);
        sum = united(sum, translated(part, frame.to_local(at.p)));
    }
    return sum;
}

bool is_near(const dFracturePart& part, Vec3 place, Real distance, bool& found)
{
    if (!(distance < kInf)) return true;
    const dGeomID ball = dCreateSphere(nullptr, distance);
    found = found && ball;
    if (!ball) return false;
    dGeomSetPosition(ball, place.x, place.y, place.z);
    dQueryDistance result;
    const bool near = dGeomGetDistance(ball, part.geom, 0, &result) == 1;
    dGeomDestroy(ball);
    return near;
}

int group_touching(Parts parts, std::span<int> members, int first, std::span<int> group_of)
{
    // Of `members`, those before `head` have been looked at, those before `tail` have their group.
    int group = first - 1;
    for (std::size_t head = 0, tail = 0; head < members.size(); ++head) {
        if (head == tail) ++tail, ++group;
        const int at = members[head];
        group_of[std::size_t(at)] = group;
        for (std::size_t k = tail; k < members.size(); ++k)
            if (touch(parts[std::size_t(at)], parts[std::size_t(members[k])]))
                std::swap(members[k], members[tail++]);
    }
    return group + 1;
}

}  // namespace epode
