// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A body whose centre went through a geom in one step, and which is out of it on the other side: a ray along
// its motion meets the geom, and so does the ray back, at more than nothing from where the body is now. Of
// meshes, whose surface has no other side, the body must be further than its half thickness behind.
#include "diagnose/cause.h"

#include <algorithm>

#include "collide/space.h"
#include "ode/shapes.h"
#include "query/query_shape.h"
#include "query/ray_query.h"
#include "step/common/link.h"

namespace epode {
namespace {

bool touch_each_other(const StepFacts& facts, const Body& body, const Body* other)
{
    for (const Touch& t : facts.touches)
        if ((t.a == &body && t.b == other) || (t.b == &body && t.a == other)) return true;
    return false;
}

RayAnswer cast(RayCaster& caster, const Geom& geom, Vec3 from, Vec3 to)
{
    RayQuery query{from, {}, length(to - from), {}};
    query.direction = (to - from) / query.length;
    query.filter.category = geom.category, query.filter.collide = geom.collide;
    query.filter.skip_body = geom.body.id;
    return caster.closest(query);
}

}  // namespace

const char* const k_text_of_tunnelling =
    "the body passed through a geom within one step; use dGeomSetContinuous() on its geom, a shorter step "
    "or a thicker obstacle";

void find_tunnelling(const StepFacts& facts)
{
    facts.for_each_body([&](Body& body, const BodyBefore& b) {
        Geom* const geom = from_handle<Geom>(body.first_geom);
        const Vec3 x = body.position();
        if (!geom || geom->continuous == dContinuousOn) return;
        const Real half = extent_of(body).half_thickness, moved = length(x - b.x);
        if (!(moved > half) || !usable(moved)) return;
        Space* const space = outermost_space(*geom);
        if (!space || is_locked(*space)) return;
        RayCaster caster(*space, false);
        if (caster.needs_program()) return;
        const RayAnswer in = cast(caster, *geom, b.x, x);
        Geom* const met = in.candidate ? from_handle<Geom>(in.contact.g2) : nullptr;
        if (!met || !(in.contact.depth > 0) || body_of(*met) == &body) return;
        if (touch_each_other(facts, body, body_of(*met))) return;
        const QueryKind kind = kind_of(query_shape_of(*met));
        Real beyond = moved - in.contact.depth;
        if (kind == QueryKind::kSolid) {
            const RayAnswer back = cast(caster, *geom, x, b.x);
            if (!back.candidate || back.contact.g2 != in.contact.g2 || !(back.contact.depth > 0)) return;
        } else if (kind == QueryKind::kPlane || !(beyond > half)) {
            return;
        }
        facts.findings.add({.kind = dDiagnosisTunnelling,
                            .severity = dSeverityError,
                            .body = to_handle(&body),
                            .other = body_of(*met) ? to_handle(body_of(*met)) : nullptr,
                            .geom = in.contact.g2,
                            .figure = double(moved / half),
                            .threshold = 1});
    });
}

}  // namespace epode
