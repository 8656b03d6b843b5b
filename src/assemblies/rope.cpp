// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Lays ropes with the functions that a program has. A rope of length L that is longer by the share e under the load T has
//   the stiffness of each of its k joints  K = T k / (e L),
// for they act one after the other; their dampers hold a link's mass m critically: C = 2 sqrt(K m).
#include <cmath>
#include <cstddef>

#include "assemblies/rope_shape.h"
#include "base/float_environment.h"
#include "base/objects/struct_size.h"
#include "collide/types/registry.h"
#include "dynamics/body.h"
#include "dynamics/world.h"
#include "math/pose.h"
#include "ode/drives.h"
#include "ode/ode.h"
#include "ode/rope.h"

namespace epode {

template <>
inline constexpr std::size_t kSmallestSize<dRopeSettings> = offsetof(dRopeSettings, length);

namespace {

constexpr dRopeSettings kDefaultRope = {.struct_size = sizeof(dRopeSettings),
                                        .links = 20,
                                        .length = 0,
                                        .mass = 1,
                                        .radius = Real(0.02),
                                        .width = 0,
                                        .ends = dRopeBoth,
                                        .stretch = 0,
                                        .load = 1000};

bool between(Real x, Real low, Real high) { return usable(x) && x >= low && x <= high; }

const char* fault_of(const dRopeSettings& s)
{
    if (s.links < 1 || s.links > 10000) return "links (accepted: 1 ... 10000)";
    if (!between(s.length, 0, Real(1e6))) return "length (accepted: 0 ... 1e6 m)";
    if (!(between(s.mass, 0, Real(1e9)) && s.mass > 0)) return "mass (accepted: above 0, at most 1e9 kg)";
    if (!(between(s.radius, 0, Real(1e6)) && s.radius > 0)) return "radius (accepted: above 0)";
    if (!between(s.width, 0, Real(1e6))) return "width (accepted: 0 or more)";
    if (s.ends < dRopeLoose || s.ends > dRopeBoth) return "ends (accepted: a dRopeEnds)";
    if (!between(s.stretch, 0, Real(1e3))) return "stretch (accepted: 0 ... 1000)";
    if (s.stretch > 0 && s.width > 0) return "stretch of planks (accepted: 0)";
    if (!(between(s.load, 0, Real(1e12)) && s.load > 0)) return "load (accepted: above 0 N)";
    return nullptr;
}

const char* fault_of_way(const dRopeSettings& s, Real way)
{
    if (!(way > 2 * s.radius)) return "points that are nearer than the rope is thick";
    if (s.length == 0)
        return 2 * s.radius < way / Real(s.links) ? nullptr : "radius of links that are too short";
    if (s.length < way) return "length below the distance of the points";
    if (s.links == 1 && s.length > way * Real(1.000001))
        return "one link longer than the distance of the points";
    return 2 * s.radius < s.length / Real(s.links) ? nullptr : "radius of links that are too short";
}

Vec3 down_of(dWorldID world)
{
    dVector3 gravity;
    dWorldGetGravity(world, gravity);
    return normalized_or(load(gravity), {0, 0, -1});
}

class RopeMaker {
  public:
    RopeMaker(dWorldID world, dSpaceID space, const dRopeSettings& settings, const RopeShape& shape)
        : world_(world), space_(space), settings_(settings), shape_(shape)
    {
        const Real joints = Real(settings.links - 1 + (settings.ends & 1) + (settings.ends >> 1));
        if (settings.stretch > 0)
            stiffness_ = settings.load * joints / (settings.stretch * Real(settings.links) * shape.link());
    }

    dBodyID link(int i, Vec3 centre)
    {
        const dBodyID body = dBodyCreate(world_);
        const dGeomID geom = body ? create_geom() : nullptr;
        if (!geom) {
            if (body) dBodyDestroy(body);
            return nullptr;
        }
        set_mass(body);
        dGeomSetBody(geom, body);
        dMatrix3 R;
        const Vec3 along = shape_.direction(i), across = shape_.across();
        store_mat(R, is_plank() ? from_columns(along, across, cross(along, across))
                                : from_columns(across, cross(along, across), along));
        dBodySetPosition(body, centre.x, centre.y, centre.z);
        dBodySetRotation(body, R);
        return body;
    }

    dJointID connect(dBodyID a, dBodyID b, Vec3 at)
    {
        const dJointID joint =
            is_plank() ? dJointCreateHinge(world_, nullptr) : dJointCreateBall(world_, nullptr);
        if (!joint) return nullptr;
        dJointAttach(joint, a, b);
        if (!is_plank()) {
            dJointSetBallAnchor(joint, at.x, at.y, at.z);
            const Real mass = settings_.mass / Real(settings_.links);
            if (stiffness_ > 0) dJointSetSpring(joint, stiffness_, 2 * std::sqrt(stiffness_ * mass));
            return joint;
        }
        const Vec3 axis = shape_.across();
        dJointSetHingeAnchor(joint, at.x, at.y, at.z);
        dJointSetHingeAxis(joint, axis.x, axis.y, axis.z);
        return joint;
    }

  private:
    bool is_plank() const { return settings_.width > 0; }
    dGeomID create_geom() const
    {
        const Real r = settings_.radius, l = shape_.link();
        return is_plank() ? dCreateBox(space_, l, settings_.width, 2 * r)
                          : dCreateCapsule(space_, r, l - 2 * r);
    }
    void set_mass(dBodyID body) const
    {
        const Real r = settings_.radius, l = shape_.link(), m = settings_.mass / Real(settings_.links);
        dMass mass;
        if (is_plank())
            dMassSetBoxTotal(&mass, m, l, settings_.width, 2 * r);
        else
            dMassSetCapsuleTotal(&mass, m, 3, r, l - 2 * r);
        dBodySetMass(body, &mass);
    }

    dWorldID world_;
    dSpaceID space_;
    const dRopeSettings& settings_;
    const RopeShape& shape_;
    Real stiffness_ = 0;
};

void destroy_links(const dBodyID* bodies, int count)
{
    for (int i = count - 1; i >= 0; --i) {
        while (dBodyGetNumJoints(bodies[i]) > 0) dJointDestroy(dBodyGetJoint(bodies[i], 0));
        while (const dGeomID geom = dBodyGetFirstGeom(bodies[i])) dGeomDestroy(geom);
        dBodyDestroy(bodies[i]);
    }
}

struct RopeEnds {
    dBodyID first, last;
    int ends;
};

// False: out of memory, and nothing is left.
bool lay(RopeMaker& make, const RopeShape& shape, int links, Vec3 at, const RopeEnds& ends, dBodyID* bodies,
         dJointID* joints)
{
    const auto put = [&](int i, bool wanted, dBodyID a, dBodyID b) {
        const dJointID joint = wanted ? make.connect(a, b, at) : nullptr;
        if (joints) joints[i] = joint;
        return joint || !wanted;
    };
    for (int i = 0; i < links; ++i) {
        const Vec3 step = shape.link() * shape.direction(i);
        bodies[i] = make.link(i, at + Real(0.5) * step);
        const bool wanted = i > 0 || ends.ends & dRopeFrom;
        if (!bodies[i] || !put(i, wanted, bodies[i], i > 0 ? bodies[i - 1] : ends.first)) {
            destroy_links(bodies, bodies[i] ? i + 1 : i);
            return false;
        }
        at += step;
    }
    if (put(links, ends.ends & dRopeTo, bodies[links - 1], ends.last)) return true;
    destroy_links(bodies, links);
    return false;
}

bool in_world(dBodyID id, const World& world)
{
    if (!id) return true;
    const Body* const body = from_handle<Body>(id);
    return body && body->world == &world;
}

}  // namespace
}  // namespace epode

using namespace epode;

extern "C" int dRopeSettingsInit(dRopeSettings* settings, unsigned struct_size)
{
    EPODE_SIZED_AS(settings, struct_size, 0);
    copy_sized(kDefaultRope, settings, struct_size);
    return 1;
}

extern "C" int dRopeCreate(dWorldID world_id, dSpaceID space, const dVector3 from, const dVector3 to,
                           dBodyID first, dBodyID last, const dRopeSettings* settings, dBodyID* bodies,
                           dJointID* joints)
{
    const FloatEnvironment floats;
    World* const world = from_handle<World>(world_id);
    EPODE_USER(world, 0);
    EPODE_USER_SAY(!is_busy(*world), busy_text(*world), 0);
    EPODE_PARENT_SPACE(space, 0);
    EPODE_USER(from && usable(from, 3) && to && usable(to, 3) && bodies, 0);
    EPODE_USER_SAY(in_world(first, *world) && in_world(last, *world), "body of another world, or destroyed",
                   0);
    dRopeSettings whole = kDefaultRope;
    if (settings) {
        EPODE_SIZED(settings, 0);
        whole = completed(*settings, kDefaultRope);
    }
    const Real way = length(load(to) - load(from));
    const char* fault = fault_of(whole);
    if (!fault) fault = way <= Real(1e6) ? fault_of_way(whole, way) : "points more than 1e6 m apart";
    EPODE_USER_SAY(!fault, fault, 0);
    const Real length = whole.length > way ? whole.length : way;
    const RopeShape shape(load(from), load(to), whole.links, length, down_of(world_id));
    RopeMaker make(world_id, space, whole, shape);
    const bool laid = lay(make, shape, whole.links, load(from), {first, last, whole.ends}, bodies, joints);
    EPODE_USER_SAY(laid, kOutOfMemory, 0);
    return whole.links;
}
