// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What the tests of spaces share: recording callbacks and the brute-force answer to "which pairs".
#pragma once

#include <ode/ode.h>

#include <utility>
#include <vector>

using PairList = std::vector<std::pair<dGeomID, dGeomID>>;

inline void record_pair(void* list, dGeomID a, dGeomID b) { static_cast<PairList*>(list)->push_back({a, b}); }

inline PairList pairs_in(dSpaceID space)
{
    PairList list;
    dSpaceCollide(space, &list, record_pair);
    return list;
}

inline PairList pairs_across(dGeomID a, dGeomID b)
{
    PairList list;
    dSpaceCollide2(a, b, &list, record_pair);
    return list;
}

inline dGeomID as_geom(dSpaceID space) { return reinterpret_cast<dGeomID>(space); }

inline std::vector<dGeomID> members_of(dSpaceID space)
{
    std::vector<dGeomID> all;
    for (int i = 0; i < dSpaceGetNumGeoms(space); ++i) all.push_back(dSpaceGetGeom(space, i));
    return all;
}

inline bool boxes_overlap(dGeomID a, dGeomID b)
{
    dReal x[6], y[6];
    dGeomGetAABB(a, x);
    dGeomGetAABB(b, y);
    for (int i = 0; i < 6; i += 2)
        if (!(x[i] <= y[i + 1] && y[i] <= x[i + 1])) return false;
    return true;
}

inline bool zero_sized(dGeomID g)
{
    dVector3 l;
    dReal r, h;
    switch (dGeomGetClass(g)) {
        case dSphereClass:
            return dGeomSphereGetRadius(g) == 0;
        case dBoxClass:
            dGeomBoxGetLengths(g, l);
            return l[0] == 0 || l[1] == 0 || l[2] == 0;
        case dCapsuleClass:
            dGeomCapsuleGetParams(g, &r, &h);
            return r == 0;
        default:
            return false;
    }
}

inline bool should_meet(dGeomID a, dGeomID b)
{
    if (zero_sized(a) || zero_sized(b) || a == b) return false;
    if (dGeomGetBody(a) && dGeomGetBody(a) == dGeomGetBody(b)) return false;
    if (!(dGeomGetCategoryBits(a) & dGeomGetCollideBits(b)) &&
        !(dGeomGetCategoryBits(b) & dGeomGetCollideBits(a)))
        return false;
    return boxes_overlap(a, b);
}

// Newest first, the newer one of each pair in front.
inline PairList brute_force(dSpaceID space)
{
    const std::vector<dGeomID> all = members_of(space);
    PairList list;
    for (std::size_t i = 0; i < all.size(); ++i)
        for (std::size_t j = i + 1; j < all.size(); ++j)
            if (dGeomIsEnabled(all[i]) && dGeomIsEnabled(all[j]) && should_meet(all[i], all[j]))
                list.push_back({all[i], all[j]});
    return list;
}
