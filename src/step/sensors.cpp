// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "step/sensors.h"

#include <algorithm>

#include "base/objects/structure_edition.h"
#include "collide/collide.h"
#include "collide/transform.h"
#include "query/candidates.h"
#include "query/distance.h"
#include "step/common/link.h"

namespace epode {
namespace {

bool is_of(const World& world, const Geom& geom)
{
    const Body* body = body_of(geom);
    return !body || body->world == &world;
}

// Is the geom something that the sensor reports, if the two overlap?
bool may_report(const World& world, Geom& sensor, Geom& other)
{
    const bool moves = sensor.body.id || other.body.id || other.character;
    return moves && !other.sensor && !is_ray(other) && is_of(world, other) && can_pair(sensor, other);
}

}  // namespace

bool Sensors::update(const World& world, Space* space, CutShort& cut_short, EventList& out)
{
    if (!find(world, space, cut_short)) return false;
    report_changes(out);
    overlaps_.swap(found_);
    return true;
}

bool Sensors::restart(const World& world, Space* space)
{
    edition_ = ~0ull;
    CutShort unsaid;
    const bool found = find(world, space, unsaid);
    if (found) overlaps_.swap(found_);
    return found;
}

bool Sensors::find(const World& world, Space* space, CutShort& cut_short)
{
    found_.clear();
    if (!space || !any_sensor()) {
        space_ = nullptr;
        return true;
    }
    clean(*space);
    const std::uint64_t structure = structure_edition();
    const bool as_before = space == space_ && structure == structure_;
    if (as_before && edition_ == space->edition && space->helped == 0) {
        if (!found_.resize(overlaps_.size())) return false;
        std::copy(overlaps_.begin(), overlaps_.end(), found_.data());
        return true;
    }
    space_ = nullptr;  // until all has been found
    if (!as_before && !list_sensors(*space)) return false;
    for (Geom* sensor : sensors_)
        if (is_of(world, *sensor) && !look_around(world, *space, *sensor, cut_short)) return false;
    std::sort(found_.begin(), found_.end(), [](const Overlap& a, const Overlap& b) { return a.before(b); });
    space_ = space, structure_ = structure, edition_ = space->edition;
    return true;
}

bool Sensors::list_sensors(Space& space)
{
    sensors_.clear();
    return each_candidate(space, [&](Geom& geom) { return !geom.sensor || sensors_.push(&geom); });
}

bool Sensors::look_around(const World& world, Space& space, Geom& sensor, CutShort& cut_short)
{
    if (!sensor.enabled) return true;
    const QueryFilter filter{sensor.category, sensor.collide};
    near_.clear();
    if (!collect_near(space, filter, box_of(sensor), near_)) return false;
    const bool called = may_call_program(near_.span(), filter) || geom_calls_program(sensor);
    const GeomHold hold(sensor, called);
    const CandidateLock lock(called ? &space : nullptr, near_);
    for (Geom* other : near_) {
        if (other == &sensor || !may_report(world, sensor, *other)) continue;
        bool is_part = false;
        const bool overlaps = overlapping(sensor, *other, is_part);
        if (is_part) cut_short.add(sensor, *other, "a sensor");
        if (!overlaps) continue;
        if (!found_.push({sensor.serial, other->serial, to_handle(&sensor), to_handle(other)})) return false;
    }
    return true;
}

void Sensors::report_changes(EventList& out) const
{
    const auto add = [&](const Overlap& overlap, dEventKind kind) {
        if (!out.wants(kind)) return;
        dEvent event{};
        event.kind = kind, event.g1 = overlap.sensor, event.g2 = overlap.other;
        out.add({event, overlap.sensor_serial, overlap.other_serial});
    };
    const Overlap *was = overlaps_.begin(), *now = found_.begin();
    while (was != overlaps_.end() || now != found_.end()) {
        if (now == found_.end() || (was != overlaps_.end() && was->before(*now)))
            add(*was++, dEventSensorEnd);
        else if (was == overlaps_.end() || now->before(*was))
            add(*now++, dEventSensorBegin);
        else
            ++was, ++now;
    }
}

}  // namespace epode
