// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Impulses and forces that wake, as C functions. A radial impulse queries the geoms that a ball overlaps; of a body the geom with
// the nearest point counts.
#include <algorithm>
#include <cmath>

#include "api/body_handle.h"
#include "base/float_environment.h"
#include "collide/collide.h"
#include "collide/types/registry.h"
#include "dynamics/impulse.h"
#include "ode/ext.h"
#include "query/distance.h"
#include "query/query_filter.h"
#include "step/common/link.h"

namespace epode {
namespace {

bool usable_vector(const dReal* v) { return v && usable(v, 3); }

Vec3 arm_to(const Body& body, const dReal* pos) { return pos ? load(pos) - body.position() : Vec3{}; }

// False, with nothing changed: a velocity would not be finite.
bool strike(Body& body, Vec3 impulse, Vec3 arm, Vec3 angular = {})
{
    if (body.kinematic()) return true;
    const Vec3 v = body.velocity(), w = body.angular_velocity(), excess = body.spin_excess;
    add_impulse(body, impulse, arm, angular);
    const bool sound = usable(body.lvel, 3) && usable(body.avel, 3);
    if (sound)
        wake(body);
    else
        store(body.lvel, v), store(body.avel, w), body.spin_excess = excess;
    return sound;
}

struct Blast {
    Vec3 centre;
    Real radius, impulse;
    int falloff;
    // What is left of it at the distance r.
    Real at(Real r) const
    {
        const Real left = std::fmax(1 - std::fmax(r, 0) / radius, 0);
        return impulse * (falloff == dFalloffNone ? Real(1) : falloff == dFalloffLinear ? left : left * left);
    }
};

struct Struck {
    Body* body;
    Vec3 point;
    Real distance;
};

// A geom that is in no space, for the time of a call.
class QueryBall {
  public:
    QueryBall(Vec3 centre, Real radius) : id_(dCreateSphere(nullptr, radius))
    {
        if (id_) dGeomSetPosition(id_, centre.x, centre.y, centre.z);
    }
    ~QueryBall()
    {
        if (id_) dGeomDestroy(id_);
    }
    QueryBall(const QueryBall&) = delete;
    QueryBall& operator=(const QueryBall&) = delete;
    dGeomID id() const { return id_; }

  private:
    dGeomID id_;
};

// The geoms within the ball. False: refused, or out of memory.
bool find_geoms(dSpaceID space, const QueryBall& ball, const dQueryFilter& filter, Array<dGeomID>& out)
{
    const int count = dSpaceOverlap(space, ball.id(), &filter, nullptr, 0);
    if (count == 0 || !out.resize(count)) return count == 0;
    // A function of the program may accept others than before.
    out.truncate(std::min(count, dSpaceOverlap(space, ball.id(), &filter, out.data(), count)));
    return true;
}

// The nearest point of each dynamic body.
bool find_bodies(const Array<dGeomID>& geoms, const QueryBall& point, Real radius, Array<Struck>& out)
{
    for (const dGeomID id : geoms) {
        Geom* const geom = from_handle<Geom>(id);
        Body* const body = geom ? body_of(*geom) : nullptr;
        if (!body || body->kinematic()) continue;
        const GeomSeparation s = separation(*from_handle<Geom>(point.id()), *geom, radius);
        if (!s.a) continue;
        Struck* known = nullptr;
        for (Struck& each : out)
            if (each.body == body) known = &each;
        if (known && known->distance <= s.distance) continue;
        const Struck now = {body, s.on_b, s.distance};
        if (known)
            *known = now;
        else if (!out.push(now))
            return false;
    }
    return true;
}

// Is something else between the centre and the point?
bool is_hidden(dSpaceID space, const Blast& blast, const Struck& struck)
{
    // Of the way: what touches the body, or the surface on which the centre lies, is not in its way.
    constexpr Real kBegin = Real(0.001), kEnd = Real(0.999);
    dVector3 from = {}, way = {};
    const Vec3 to = struck.point - blast.centre;
    const Real far = length(to);
    if (!(far > 0)) return false;
    store(from, blast.centre + kBegin * to), store(way, to);
    dQueryFilter filter;
    dQueryFilterInit(&filter, sizeof filter);
    filter.skip_body = to_handle(struck.body);
    dQueryHit hit;
    return dSpaceRayClosest(space, from, way, (kEnd - kBegin) * far, &filter, &hit) != 0;
}

bool strike(const Blast& blast, const Struck& struck)
{
    const Vec3 x = struck.body->position(), away = normalized_or(x - blast.centre, {0, 0, 1});
    return strike(*struck.body, blast.at(struck.distance) * away, struck.point - x);
}

constexpr const char* kTooLarge = "the impulse would make a velocity infinite";

}  // namespace
}  // namespace epode

using namespace epode;

extern "C" void dBodyApplyImpulse(dBodyID b, const dVector3 impulse, const dVector3 pos)
{
    BODY_OR();
    EPODE_USER(fits(*body, usable_vector(impulse) && (!pos || usable(pos, 3))));
    EPODE_USER_SAY(strike(*body, load(impulse), arm_to(*body, pos)), kTooLarge);
}

extern "C" void dBodyApplyAngularImpulse(dBodyID b, const dVector3 impulse)
{
    BODY_OR();
    EPODE_USER(fits(*body, usable_vector(impulse)));
    EPODE_USER_SAY(strike(*body, {}, {}, load(impulse)), kTooLarge);
}

extern "C" void dBodyApplyForce(dBodyID b, const dVector3 force, const dVector3 pos)
{
    BODY_OR();
    EPODE_USER(fits(*body, usable_vector(force) && (!pos || usable(pos, 3))));
    const Vec3 at = pos ? load(pos) : body->position();
    wake(*body);
    dBodyAddForceAtPos(b, force[0], force[1], force[2], at.x, at.y, at.z);
}

extern "C" void dBodyApplyTorque(dBodyID b, const dVector3 torque)
{
    BODY_OR();
    EPODE_USER(fits(*body, usable_vector(torque)));
    wake(*body);
    dBodyAddTorque(b, torque[0], torque[1], torque[2]);
}

extern "C" void dBodySetVelocities(dBodyID b, const dVector3 linear, const dVector3 angular, int wakes)
{
    BODY_OR();
    EPODE_USER(fits(*body, (!linear || usable(linear, 3)) && (!angular || usable(angular, 3))));
    EPODE_USER(fits(*body, wakes == 0 || wakes == 1));
    if (wakes) wake(*body);
    if (linear) dBodySetLinearVel(b, linear[0], linear[1], linear[2]);
    if (angular) dBodySetAngularVel(b, angular[0], angular[1], angular[2]);
}

extern "C" int dSpaceApplyRadialImpulse(dSpaceID id, const dVector3 center, dReal radius, dReal impulse,
                                        int falloff, int occlusion, const dQueryFilter* given)
{
    const FloatEnvironment floats;
    EPODE_SPACE(space, id, 0);
    EPODE_USER(usable_vector(center) && usable(radius) && radius > 0 && usable(impulse), 0);
    EPODE_USER(falloff >= dFalloffNone && falloff <= dFalloffQuadratic, 0);
    EPODE_USER(occlusion == 0 || occlusion == 1, 0);
    QueryFilter checked;
    if (!read_filter(given, __func__, checked)) return 0;
    dQueryFilter filter;
    dQueryFilterInit(&filter, sizeof filter);
    const Blast blast = {load(center), radius, impulse, falloff};
    const QueryBall ball(blast.centre, radius), point(blast.centre, 0);
    Array<dGeomID> geoms;
    Array<Struck> struck;
    EPODE_USER_SAY(ball.id() && point.id() && find_geoms(id, ball, given ? *given : filter, geoms) &&
                       find_bodies(geoms, point, radius, struck),
                   kOutOfMemory, 0);
    int count = 0;
    for (const Struck& each : struck) {
        if (occlusion && is_hidden(id, blast, each)) continue;
        count += strike(blast, each);
    }
    return count;
}
