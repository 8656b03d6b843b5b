// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Causes need the step's report and energy ledger, so they are made although the program has not asked for
// them; what the program sees of both stays what it would be. Without memory for a step's notes that step is not diagnosed.
#include "diagnose/watch.h"

#include <algorithm>
#include <new>
#include <utility>

#include "base/memory.h"
#include "collide/geom.h"
#include "diagnose/cause.h"
#include "joints/joint_manifolds.h"
#include "query/candidates.h"
#include "query/impact.h"
#include "query/triangle_set.h"
#include "step/common/link.h"
#include "step/island/energy_ledger.h"

namespace epode {
namespace {

struct Watch : StepObserver {
    Findings findings;
    Array<BodyBefore> before, last, after;
    Array<Touch> touches;
    Array<dWorldContact> of_world;
    Array<JointError> joint_errors;
    Array<GraphNode> graph;
    Array<Neighbours> neighbours;
    Array<Real> swings;
    std::uint64_t refusals = refusal_count();  // that have been looked at
    dWorldStepReport report{};
    dWorldStepReport programs_report{};
    bool programs_wanted = false, programs_made = false;
    dEnergyLedger ledger{};
    bool programs_ledger = false;
};

Watch& watch_of(StepObserver& observer) { return static_cast<Watch&>(observer); }

BodyBefore note_of(const Body& body)
{
    return {to_handle(&body),        body.position(), body.velocity(),
            body.angular_velocity(), load(body.facc), load(body.tacc)};
}

bool note_bodies(const World& world, Array<BodyBefore>& list)
{
    list.clear();
    if (!list.resize(world.bodies.places())) return false;
    for (const Body& body : world.bodies)
        if (!body.disabled) list[body.place] = note_of(body);
    return true;
}

void begin(StepObserver& observer, World& world, Real)
{
    Watch& watch = watch_of(observer);
    watch.before.swap(watch.last);
    if (!note_bodies(world, watch.before)) watch.before.clear();
    watch.programs_wanted = std::exchange(world.report_wanted, true);
    watch.programs_made = world.report_made;
    watch.programs_report = world.report;
    watch.programs_ledger = std::exchange(world.step_state->ledger_wanted, true);
}

bool add_joint_contacts(const World& world, Array<Touch>& touches)
{
    for (const Joint& joint : world.joints) {
        if (!is_contact(joint) || !acting(joint)) continue;
        const ContactPlace at = place_of_contact(joint);
        if (!touches.push({joint.body1(), joint.body2(), at.position, at.normal, at.depth})) return false;
    }
    return true;
}

bool add_world_contacts(const World& world, Watch& watch)
{
    const ContactWorld& contacts = world.step_state->world_contacts;
    if (!contacts.live_space()) return true;
    if (!watch.of_world.resize(contacts.contacts(nullptr, 0))) return false;
    (void)contacts.contacts(watch.of_world.data(), watch.of_world.size());
    for (const dWorldContact& c : watch.of_world.span()) {
        const Geom *g1 = from_handle<Geom>(c.g1), *g2 = from_handle<Geom>(c.g2);
        if (!g1 || !g2 || !body_of(*g1)) continue;
        if (!watch.touches.push({body_of(*g1), body_of(*g2), load(c.pos), load(c.normal), c.depth}))
            return false;
    }
    return true;
}

// Those that concern the world, or nothing that is in one.
std::span<const Refusal> new_refusals(Watch& watch, const World& world, std::span<Refusal> out)
{
    const std::uint64_t end = refusal_count();
    std::size_t count = 0;
    for (std::uint64_t i = std::max(watch.refusals + out.size(), end) - out.size(); i < end; ++i) {
        const Refusal one = refusal(i);
        if (!one.world || one.world == &world) out[count++] = one;
    }
    watch.refusals = end;
    return out.first(count);
}

void look(Watch& watch, World& world, Real h)
{
    watch.findings.begin_step();
    watch.touches.clear();
    if (!add_joint_contacts(world, watch.touches) || !add_world_contacts(world, watch)) return;
    if (!watch.joint_errors.resize(world.joints.places()) || !watch.graph.resize(world.bodies.places() + 1) ||
        !watch.neighbours.resize(world.bodies.places()) || !watch.swings.resize(world.bodies.places()))
        return;
    Refusal refusals[kRefusalsKept];
    const StepFacts facts{world,
                          h,
                          watch.before.span(),
                          watch.last.span(),
                          watch.after.span(),
                          watch.touches.span(),
                          watch.joint_errors.span(),
                          watch.graph.span(),
                          watch.neighbours.span(),
                          watch.swings.span(),
                          world.step_state->reports.span(),
                          new_refusals(watch, world, refusals),
                          watch.report,
                          watch.ledger,
                          watch.findings};
#define CAUSE(name) find_##name(facts);
#include "diagnose/causes.inc"
#undef CAUSE
}

void end(StepObserver& observer, World& world, Real h, bool made)
{
    Watch& watch = watch_of(observer);
    watch.report = world.report;
    world.report_wanted = watch.programs_wanted;
    if (!world.report_wanted) world.report = watch.programs_report, world.report_made = watch.programs_made;
    StepState& state = *world.step_state;
    watch.ledger = sum_of(state.ledgers.span());
    state.ledger_wanted = watch.programs_ledger;
    if (made) look(watch, world, h);
    if (!note_bodies(world, watch.after)) watch.after.clear();
}

void destroy(StepObserver& observer)
{
    Watch& watch = watch_of(observer);
    watch.~Watch();
    watch_refusals(false);
    release(&watch, sizeof watch);
}

}  // namespace

bool set_diagnosis(World& world, bool on)
{
    if (!on && !world.step_state) return true;
    StepState* const state = step_state(world);
    if (!state) return false;
    if (on == (state->watch != nullptr)) return true;
    if (!on) {
        state->watch->destroy(*state->watch);
        state->watch = nullptr;
        return true;
    }
    void* const memory = allocate(sizeof(Watch));
    if (!memory) return false;
    watch_refusals(true);
    Watch* const watch = new (memory) Watch;
    watch->begin = begin, watch->end = end, watch->destroy = destroy;
    state->watch = watch;
    return true;
}

const Findings* findings_of(const World& world)
{
    StepObserver* const watch = world.step_state ? world.step_state->watch : nullptr;
    return watch ? &watch_of(*watch).findings : nullptr;
}

Extent extent_of(const Body& body)
{
    Extent extent;
    bool endless = false;
    for_each_geom(body, [&](Geom& geom) {
        const QueryShape shape = query_shape_of(geom);
        if (!shape.geom || kind_of(shape) != QueryKind::kSolid || shape.number() == dRayClass) return;
        extent.half_thickness = std::min(extent.half_thickness, half_thickness(shape));
        const Aabb& box = box_of(geom);
        endless = endless || !bounded(box);
        const Vec3 x = body.position();
        extent.reach = std::max(extent.reach, length(max(abs(box.lo - x), abs(box.hi - x))));
    });
    if (endless || !usable(extent.reach)) extent.reach = 0;
    return extent;
}

Real approach_of(const StepFacts& facts, const Touch& touch)
{
    const auto velocity = [&](const Body* body) {
        const BodyBefore* b = body ? StepFacts::of(facts.before, *body) : nullptr;
        return b ? b->v + cross(b->w, touch.position - b->x) : Vec3{};
    };
    return dot(touch.normal, velocity(touch.b) - velocity(touch.a));
}

}  // namespace epode
