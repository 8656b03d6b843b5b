// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The walk down the trees, the geoms that wait for its end, and the API functions.
#include "query/ray_query.h"

#include <algorithm>
#include <atomic>

#include "base/float_environment.h"
#include "ode/ext.h"
#include "tasks/tasks.h"

namespace epode {
namespace {

// Slightly more than the distance: no hit can lie between the two.
Real just_beyond(Real distance)
{
    return distance + 4 * kEpsilon * distance + (kSingle ? Real(1e-36) : Real(1e-300));
}

// How far from its origin a ray may meet, by rounding, the surface that it starts on.
Real start_of(const RayQuery& query)
{
    const Vec3 at = abs(query.origin);
    return 64 * kEpsilon * (1 + std::max({at.x, at.y, at.z}));
}

// The surface that the ray starts on, and leaves outward.
bool leaves(const RayQuery& query, const dContactGeom& hit)
{
    return hit.depth <= start_of(query) && dot(load(hit.normal), query.direction) > 0;
}

}  // namespace

RayProbe::RayProbe() : ShapeGeom<Ray>(kRayType)
{
    shape.closest_hit = true;
    users = 1;
}

RayProbe::~RayProbe()
{
    if (space) remove_geom(*space, *this);
    while (holders) set_transform_geom(*holders, nullptr);
    unlink_body(*this);
}

void RayProbe::aim(const RayQuery& query, Real length)
{
    shape.length = length;
    store(own_position, query.origin);
    for (int i = 0; i < 3; ++i) own_rotation[4 * i + 2] = query.direction[i];
    box_stale = true;
}

bool RayCaster::needs_program()
{
    return !each_candidate(space_, [&](Geom& m) { return direct(m) || !may_call_program(probe_, m); });
}

static_assert(kGeomClasses <= 32, "asked_ has a bit for each class");

// For solids and planes, which never call the program.
PairFunction RayCaster::direct(const Geom& geom)
{
    const int number = geom.type->number;
    if (number > dConvexClass && !geom.type->solid) return nullptr;
    if (!(asked_ >> number & 1)) {
        asked_ |= 1u << number;
        direct_[number] = number == dRayClass ? nullptr : own_pair(dRayClass, number);
    }
    return direct_[number];
}

bool RayCaster::hit(const RayQuery& query, Geom& geom, Real length, RayAnswer& out)
{
    probe_.aim(query, length);
    if (geom.type->may_touch && !geom.type->may_touch(geom, probe_)) return false;
    ContactArray one{&out.contact, int(sizeof(dContactGeom)), 1, false};
    collide(probe_, geom, one);
    out.candidate = &geom;
    if (one.count == 0 || !leaves(query, out.contact)) return one.count > 0;
    return hit_beyond(query, geom, length, out);
}

// What the ray may meet of a mesh or a field after it has left it.
bool RayCaster::hit_beyond(const RayQuery& query, Geom& geom, Real length, RayAnswer& out)
{
    const Real start = 2 * start_of(query);
    RayQuery later = query;
    later.origin += start * query.direction;
    if (!(length > start)) return false;
    probe_.aim(later, length - start);
    ContactArray one{&out.contact, int(sizeof(dContactGeom)), 1, false};
    collide(probe_, geom, one);
    out.contact.depth += start;
    return one.count > 0 && !leaves(query, out.contact);
}

// Calls found(answer) for every geom that is hit within `reach`, which found() may shorten. Collects the
// geoms that must wait.
template <typename Found>
void RayCaster::walk(Space& space, const RayQuery& query, Real& reach, Found&& found)
{
    if (!ready_) clean(space);  // does nothing while the space is being collided
    const bool calls_back = query.filter.callback != nullptr;
    const auto visit = [&](int slot) {
        Geom& m = *space.geoms.data()[slot];
        if (!m.enabled || !query.filter.admits(m)) return reach;
        if (is_space(m)) {
            walk(static_cast<Space&>(m), query, reach, found);
            return reach;
        }
        RayAnswer answer;
        if (const PairFunction pair = calls_back ? nullptr : direct(m)) {
            probe_.shape.length = reach;
            ContactSink sink(&answer.contact, int(sizeof(dContactGeom)), 1, false);
            pair(probe_, pose_, m, pose_of(m), sink);
            if (sink.count() == 0 || leaves(query, answer.contact)) return reach;
            answer.candidate = &m;
            answer.contact.g2 = to_handle(&m);
            found(answer);
            return reach;
        }
        const bool waits = calls_back || m.type->number == dHeightfieldClass || may_call_program(probe_, m);
        if (waits && waiting_.push(&m)) return reach;
        if (hit(query, m, reach, answer)) found(answer);
        return reach;
    };
    const bool by_tree = ready_ ? space.broadphase.ready() : space.broadphase.prepare(1);
    const SpaceLock lock(space, !ready_ && space.helped > 0);  // cleaning a nested space may call the program
    // A ray reads only the first cache lines of most geoms, and they are seldom in the cache.
    const auto prefetch_candidate = [&](int slot) {
        const Geom* m = space.geoms.data()[slot];
        prefetch<1>(&m->type), prefetch<1>(m->own_rotation), prefetch<1>(m->own_position);
    };
    if (by_tree) {
        space.broadphase.cast(query.origin, query.direction, reach, visit, prefetch_candidate);
    } else {
        for (int slot = space.geoms.size(); slot-- > 0;)
            if (space.geoms.data()[slot] && space.broadphase.present(slot)) visit(slot);
    }
}

template <typename Found>
void RayCaster::ask_waiting(const RayQuery& query, const Real& reach, Found&& found)
{
    if (waiting_.empty()) return;
    std::sort(waiting_.begin(), waiting_.end(), [](Geom* a, Geom* b) { return is_newer(*a, *b); });
    const bool called = !ready_ && may_call_program(waiting_.span(), query.filter);
    const CandidateLock lock(called ? &space_ : nullptr, waiting_);
    const Real until = reach;
    for (Geom* m : waiting_) {
        RayAnswer answer;
        const Aabb& box = box_of(*m);
        const bool near =
            !bounded(box) || TreeRay(query.origin, query.direction, box).enters(box, until) < kInf;
        if (near && hit(query, *m, reach, answer)) found(answer);
    }
}

void RayCaster::aim(const RayQuery& query)
{
    const Vec3 d = query.direction;
    waiting_.clear();
    pose_.p = query.origin;
    pose_.R = {{0, 0, d.x}, {0, 0, d.y}, {0, 0, d.z}};
}

RayAnswer RayCaster::closest(const RayQuery& query)
{
    RayAnswer best;
    Real reach = query.length;
    aim(query);
    const auto found = [&](const RayAnswer& answer) {
        if (best.candidate && !precedes(answer, best)) return;
        if (!query.filter.keeps(answer.contact.g2)) return;
        best = answer;
        reach = std::min(reach, just_beyond(answer.contact.depth));
    };
    walk(space_, query, reach, found);
    ask_waiting(query, reach, found);
    return best;
}

bool RayCaster::all(const RayQuery& query, Array<RayAnswer>& out)
{
    Real reach = query.length;
    bool complete = true;
    aim(query);
    const auto found = [&](const RayAnswer& answer) {
        if (query.filter.keeps(answer.contact.g2)) complete = out.push(answer) && complete;
    };
    walk(space_, query, reach, found);
    ask_waiting(query, reach, found);
    std::sort(out.begin(), out.end(), precedes);
    return complete;
}

}  // namespace epode

using namespace epode;

namespace {

void put(const RayAnswer& answer, dQueryHit& out)
{
    out = dQueryHit{};
    out.side = -1;
    if (!answer.candidate) return;
    const dContactGeom& c = answer.contact;
    out.geom = c.g2;
    store(out.pos, load(c.pos));
    store(out.normal, load(c.normal));
    out.distance = c.depth;
    out.side = c.side2;
}

bool usable_ray(const dReal* origin, const dReal* direction, dReal length)
{
    return usable(origin, 3) && usable(direction, 3) && (usable(length) || length == kInf) && length >= 0;
}

// False if the direction is zero.
bool query_of(const dReal* origin, const dReal* direction, dReal length, const QueryFilter& filter,
              RayQuery& out)
{
    out = {load(origin), load(direction), std::min(length, kMaxMagnitude), filter};
    return normalize(out.direction);
}

}  // namespace

extern "C" int dSpaceRayClosest(dSpaceID id, const dVector3 origin, const dVector3 direction, dReal length,
                                const dQueryFilter* given, dQueryHit* hit)
{
    const FloatEnvironment floats;
    EPODE_SPACE(space, id, 0);
    EPODE_USER(origin && direction && hit && usable_ray(origin, direction, length), 0);
    QueryFilter filter;
    if (!read_filter(given, __func__, filter)) return 0;
    RayQuery query;
    EPODE_USER(query_of(origin, direction, length, filter, query), 0);
    RayCaster caster(*space, false);
    const RayAnswer answer = caster.closest(query);
    put(answer, *hit);
    return answer.candidate != nullptr;
}

extern "C" int dSpaceRayAll(dSpaceID id, const dVector3 origin, const dVector3 direction, dReal length,
                            const dQueryFilter* given, dQueryHit* hits, int capacity)
{
    const FloatEnvironment floats;
    EPODE_SPACE(space, id, 0);
    EPODE_USER(origin && direction && usable_ray(origin, direction, length), 0);
    EPODE_USER(capacity >= 0 && (hits || capacity == 0), 0);
    QueryFilter filter;
    if (!read_filter(given, __func__, filter)) return 0;
    RayQuery query;
    EPODE_USER(query_of(origin, direction, length, filter, query), 0);
    RayCaster caster(*space, false);
    Array<RayAnswer> answers;
    EPODE_USER_SAY(caster.all(query, answers), kOutOfMemory, 0);
    for (int i = 0; i < std::min(capacity, answers.size()); ++i) put(answers[i], hits[i]);
    return answers.size();
}

extern "C" int dSpaceRayBatch(dSpaceID id, int count, const dReal* origins, const dReal* directions,
                              const dReal* lengths, const dQueryFilter* given, dQueryHit* hits, int threads)
{
    const FloatEnvironment floats;
    EPODE_SPACE(space, id, 0);
    EPODE_USER(count >= 0 && threads >= 0, 0);
    EPODE_USER(count == 0 || (origins && directions && lengths && hits), 0);
    for (std::size_t i = 0; i < std::size_t(count); ++i) {
        RayQuery query;
        EPODE_USER(usable_ray(origins + 3 * i, directions + 3 * i, lengths[i]), 0);
        EPODE_USER(query_of(origins + 3 * i, directions + 3 * i, lengths[i], {}, query), 0);
    }
    QueryFilter filter;
    if (!read_filter(given, __func__, filter)) return 0;
    constexpr int kParcel = 64;
    (void)make_ready(*space, count);
    const bool alone = filter.callback || RayCaster(*space, true).needs_program();
    const SpaceLock lock(*space);
    const Tasks tasks(alone ? 1 : threads == 0 ? processor_count() : threads);
    std::atomic<int> met{0};
    tasks.for_each((count + kParcel - 1) / kParcel, [&](int parcel, int) {
        RayCaster caster(*space, !alone);
        int here = 0;
        const std::size_t first = std::size_t(parcel) * kParcel;
        for (std::size_t i = first; i < std::min(first + kParcel, std::size_t(count)); ++i) {
            RayQuery query;
            (void)query_of(origins + 3 * i, directions + 3 * i, lengths[i], filter, query);
            const RayAnswer answer = caster.closest(query);
            put(answer, hits[i]);
            here += answer.candidate != nullptr;
        }
        met.fetch_add(here, std::memory_order_relaxed);
    });
    return met.load();
}
