// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What the last step has broken. Let P_k at x_k be the impulses that a body exerted in it, p the normal impulse of the hardest
// blow, along n, and q what stops the approach that is left there: contacts are speculative, and a blow may begin in one step and
// end in the next. If p + q passes the strength S, the body has exerted no more than S there:
//   p > S   all P_k count as (S / p) P_k. What held the body up was exerted because of what hit it.
//   p < S   S - p along n is added, which is less than q.
// Both sides have these impulses at x_k, so momentum and angular momentum stay what they are. Energy is convex in the share,
// least where the blow has stopped the approach, and the blow itself has made none; so this makes none either. Bodies are taken in
// the order of (p + q) / S, for what breaks first spares the others.
#include <algorithm>

#include "assemblies/fracture_body.h"
#include "base/float_environment.h"
#include "collide/types/registry.h"
#include "contacts/contact_world.h"
#include "ode/impulses.h"
#include "ode/ode.h"
#include "step/step.h"

namespace epode {
namespace {

using Fractures = std::span<const dFracture>;

Parts parts_of(const dFracture& f) { return {f.parts, std::size_t(f.count)}; }

int number_in(Parts parts, dGeomID geom)
{
    const auto is_it = [&](const dFracturePart& part) { return part.geom == geom; };
    const auto found = std::find_if(parts.begin(), parts.end(), is_it);
    return found == parts.end() ? -1 : int(found - parts.begin());
}

// A body that has been hit too hard.
struct Overload {
    dBodyID body;
    const dFracture* fracture;
    Real excess;  // (p + q) / S, or infinity
    int order;    // among those that were found, before they are sorted
    Break how;    // known when it breaks
};

Real load_of(const PairImpulse& blow) { return blow.exerted + blow.remaining; }
Real ratio(Real impulse, Real strength) { return strength > 0 ? impulse / strength : kInf; }

class Breakage {
  public:
    Breakage(const World& world, Fractures fractures) : world_(world), fractures_(fractures) {}

    // Null, or what is wrong.
    const char* read(const ContactWorld& contacts)
    {
        if (!list_geoms()) return kOutOfMemory;
        if (std::adjacent_find(geoms_.begin(), geoms_.end()) != geoms_.end()) return kTwice;
        if (!contacts.impulses(geoms_.span(), impulses_)) return kOutOfMemory;
        for (const PairImpulse& blow : impulses_)
            for (const dGeomID geom : {blow.g1, blow.g2})
                if (!note(geom, load_of(blow))) return kOutOfMemory;
        // Without memory of its own, which std::stable_sort takes.
        std::sort(overloads_.begin(), overloads_.end(), [](const Overload& a, const Overload& b) {
            return a.excess != b.excess ? a.excess > b.excess : a.order < b.order;
        });
        return nullptr;
    }

    // Those that break, when what goes beyond their strength has been taken back.
    std::span<const Overload> settle()
    {
        int broken = 0;
        for (Overload& one : overloads_)
            if (settle(one)) overloads_[broken++] = one;
        return overloads_.span().first(std::size_t(broken));
    }

    bool has_strangers() const { return strangers_; }

  private:
    bool list_geoms()
    {
        for (const dFracture& f : fractures_)
            for (const dFracturePart& part : parts_of(f))
                if (!geoms_.push(from_handle<Geom>(part.geom)->serial)) return false;
        std::sort(geoms_.begin(), geoms_.end());
        return true;
    }

    // 0: none, or one of another world in the same space.
    dBodyID body_of(dGeomID geom) const
    {
        const dBodyID body = dGeomGetBody(geom);
        return body && from_handle<Body>(body)->world == &world_ ? body : nullptr;
    }

    bool note(dGeomID geom, Real impulse)
    {
        const dBodyID body = body_of(geom);
        if (!body) return true;
        for (const dFracture& f : fractures_) {
            if (!(impulse > f.strength) || number_in(parts_of(f), geom) < 0) continue;
            for (Overload& one : overloads_)
                if (one.body == body)
                    return one.excess = std::max(one.excess, ratio(impulse, f.strength)), true;
            return overloads_.push({body, &f, ratio(impulse, f.strength), int(overloads_.size()), {}});
        }
        return true;
    }

    bool settle(Overload& one)
    {
        PairImpulse* hardest = nullptr;
        for (PairImpulse& blow : impulses_) {
            const int struck = part_struck(one, blow);
            if (struck < 0 || (hardest && load_of(blow) <= load_of(*hardest))) continue;
            hardest = &blow, one.how = {blow.place, one.fracture->radius, struck};
        }
        const Real strength = one.fracture->strength;
        if (!hardest || !(load_of(*hardest) > strength) || !can_break(one)) return false;
        const Real missing = strength - hardest->exerted;
        if (missing < 0)
            scale_back(one.body, strength / hardest->exerted);
        else
            exert(*hardest, missing * hardest->normal);
        hardest->exerted = strength, hardest->remaining = 0;
        return true;
    }

    int part_struck(const Overload& one, const PairImpulse& blow) const
    {
        for (const dGeomID geom : {blow.g1, blow.g2})
            if (body_of(geom) == one.body) return number_in(parts_of(*one.fracture), geom);
        return -1;
    }

    bool can_break(const Overload& one)
    {
        int parts = 0, geoms = 0;
        for (const dFracturePart& part : parts_of(*one.fracture))
            parts += dGeomGetBody(part.geom) == one.body;
        for (dGeomID geom = dBodyGetFirstGeom(one.body); geom; geom = dBodyGetNextGeom(geom)) ++geoms;
        strangers_ = strangers_ || geoms != parts;
        return parts > 1 && geoms == parts;
    }

    void scale_back(dBodyID body, Real share)
    {
        for (PairImpulse& blow : impulses_) {
            if (body_of(blow.g1) != body && body_of(blow.g2) != body) continue;
            exert(blow, (share - 1) * blow.on_first);
            blow.exerted *= share;
        }
    }

    // On g1, and the opposite on g2.
    void exert(PairImpulse& blow, Vec3 impulse)
    {
        dVector3 on_first, on_second, at;
        store(on_first, impulse), store(on_second, -impulse), store(at, blow.place);
        if (const dBodyID first = body_of(blow.g1)) dBodyApplyImpulse(first, on_first, at);
        if (const dBodyID second = body_of(blow.g2)) dBodyApplyImpulse(second, on_second, at);
        blow.on_first += impulse;
    }

    const World& world_;
    const Fractures fractures_;
    Array<std::uint64_t> geoms_;
    Array<PairImpulse> impulses_;
    Array<Overload> overloads_;
    bool strangers_ = false;  // geoms that are no parts, on a body that would break
};

const char* fault_of_fracture(const dFracture& f)
{
    if (const char* fault = fault_of_list(f.parts, f.count)) return fault;
    if (!(usable_or_infinite(f.strength) && f.strength >= 0)) return "strength (accepted: 0 or more)";
    return usable_or_infinite(f.radius) && f.radius >= 0 ? nullptr : "radius (accepted: 0 or more)";
}

const char* fault_of_fractures(Fractures fractures)
{
    for (const dFracture& f : fractures)
        if (const char* fault = fault_of_fracture(f)) return fault;
    return nullptr;
}

// Null, or what is wrong.
const char* fault_of_break(Parts parts, dBodyID id)
{
    const Body* const body = from_handle<Body>(id);
    if (!body) return "body that is 0 or destroyed";
    if (is_busy(*body->world)) return busy_text(*body->world);
    return fault_of_parts(parts);
}

}  // namespace
}  // namespace epode

using namespace epode;

extern "C" dBodyID dFractureCreate(dWorldID world_id, const dFracturePart* parts, int count)
{
    const FloatEnvironment floats;
    World* const world = from_handle<World>(world_id);
    EPODE_USER(world, nullptr);
    EPODE_USER_SAY(!is_busy(*world), busy_text(*world), nullptr);
    const char* fault = fault_of_list(parts, count);
    EPODE_USER_SAY(!fault, fault, nullptr);
    const Parts list{parts, std::size_t(count)};
    for (const dFracturePart& part : list)
        EPODE_USER_SAY(!dGeomGetBody(part.geom), "geom of a part that is on a body", nullptr);
    fault = fault_of_parts(list);
    const dBodyID body = fault ? nullptr : unite_parts(world_id, list, &fault);
    EPODE_USER_SAY(!fault, fault, nullptr);
    return body;
}

extern "C" int dFractureBreak(const dFracturePart* parts, int count, dBodyID body, const dVector3 center,
                              dReal radius)
{
    const FloatEnvironment floats;
    const char* fault = fault_of_list(parts, count);
    EPODE_USER_SAY(!fault, fault, 0);
    EPODE_USER(!center || usable(center, 3), 0);
    EPODE_USER_SAY(usable_or_infinite(radius) && radius >= 0, "radius (accepted: 0 or more)", 0);
    const Parts list{parts, std::size_t(count)};
    fault = fault_of_break(list, body);
    EPODE_USER_SAY(!fault, fault, 0);
    const Break how{center ? load(center) : Vec3{}, center ? radius : kInf, -1};
    const int pieces = break_body(list, body, how, &fault);
    EPODE_USER_SAY(!fault, fault, 0);
    return pieces;
}

extern "C" int dFractureUpdate(dWorldID world_id, const dFracture* fractures, int count)
{
    const FloatEnvironment floats;
    World* const world = from_handle<World>(world_id);
    EPODE_USER(world, 0);
    EPODE_USER_SAY(!is_busy(*world), busy_text(*world), 0);
    EPODE_USER(count >= 0 && fractures, 0);
    const Fractures all{fractures, std::size_t(count)};
    const char* fault = fault_of_fractures(all);
    EPODE_USER_SAY(!fault, fault, 0);
    const ContactWorld* const contacts = world->step_state ? &world->step_state->world_contacts : nullptr;
    if (!contacts) return 0;
    Breakage blows(*world, all);
    fault = blows.read(*contacts);
    EPODE_USER_SAY(!fault, fault, 0);
    int broken = 0;
    for (const Overload& one : blows.settle()) {
        broken += break_body(parts_of(*one.fracture), one.body, one.how, &fault) > 0;
        EPODE_USER_SAY(!fault, fault, broken);
    }
    EPODE_USER_SAY(!blows.has_strangers(), kStrangers, broken);
    return broken;
}
