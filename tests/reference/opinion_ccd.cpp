// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// libccd's opinion: GJK for whether two solids meet, its expanding polytope for how deep. It sees them by
// their farthest points only, as tests/reference has them, and works to 1e-6 here.
#include <ccd/ccd.h>

#include "opinion.h"

namespace epode::reference {
namespace {

void farthest(const void* solid, const ccd_vec3_t* direction, ccd_vec3_t* out)
{
    const Point p = static_cast<const Solid*>(solid)->support(
        {double(direction->v[0]), double(direction->v[1]), double(direction->v[2])});
    ccdVec3Set(out, ccd_real_t(p[0]), ccd_real_t(p[1]), ccd_real_t(p[2]));
}

void middle(const void* solid, ccd_vec3_t* out)
{
    const Point p = static_cast<const Solid*>(solid)->position();
    ccdVec3Set(out, ccd_real_t(p[0]), ccd_real_t(p[1]), ccd_real_t(p[2]));
}

ccd_t settings()
{
    ccd_t ccd;
    CCD_INIT(&ccd);
    ccd.support1 = ccd.support2 = farthest;
    ccd.center1 = ccd.center2 = middle;
    ccd.max_iterations = 500;
    ccd.epa_tolerance = ccd_real_t(1e-6);
    return ccd;
}

}  // namespace

Verdict ccd_opinion(const Solid& a, const Solid& b)
{
    const ccd_t ccd = settings();
    Verdict verdict{.meet = ccdGJKIntersect(&a, &b, &ccd) != 0};
    if (!verdict.meet) return verdict;
    ccd_real_t depth = 0;
    ccd_vec3_t way, place;
    verdict.silent = ccdGJKPenetration(&a, &b, &ccd, &depth, &way, &place) != 0;
    if (verdict.silent) return verdict;
    verdict.depth = double(depth);
    verdict.way = {double(way.v[0]), double(way.v[1]), double(way.v[2])};
    return verdict;
}

}  // namespace epode::reference
