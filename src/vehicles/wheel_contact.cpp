// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "vehicles/wheel_contact.h"

#include <algorithm>

#include "collide/collide.h"
#include "collide/transform.h"
#include "collide/types/registry.h"
#include "math/rotation.h"
#include "math/trig.h"
#include "query/candidates.h"
#include "query/ray_query.h"
#include "query/sweep.h"
#include "step/common/link.h"
#include "step/step.h"

namespace epode {
namespace {

constexpr Real kCamber = Real(0.05);  // rad

// A wheel as a geom outside all spaces, as long as it is looked for.
template <typename Shape>
struct WheelProbe : ShapeGeom<Shape> {
    WheelProbe(const GeomType& geom_type, Vec3 centre, const Mat3& R) : ShapeGeom<Shape>(geom_type)
    {
        this->users = 1;
        store(this->own_position, centre);
        store_mat(this->own_rotation, R);
        this->box_stale = true;
    }
};

// The first that it meets and that is not too steep to stand on.
SweepHit nearest(Geom& solid, const Way& way, const Array<Geom*>& near, Vec3 up)
{
    SweepHit best;
    for (Geom* geom : near) {
        const SweepHit hit = sweep(solid, way, *geom, std::min(best.distance, way.length));
        if (hit.distance < best.distance && dot(hit.normal, up) > kLeastSlope) best = hit;
    }
    return best;
}

Real length_across(Vec3 v, Vec3 axis) { return length(v - dot(v, axis) * axis); }

// Where a cylinder lies along its whole width, the query returns any point of that: the middle is meant. Over kCamber it stands on its
// rim.
Vec3 evened(Vec3 pos, Vec3 centre, Vec3 axle, Vec3 normal)
{
    const Real rim = std::min(std::fabs(dot(normal, axle)) / kCamber, Real(1));
    return pos - (1 - rim) * dot(pos - centre, axle) * axle;
}

bool carries_wheels(const Geom& geom) { return !geom.sensor && !is_space(geom) && !is_ray(geom); }

}  // namespace

Vec3 VehicleFrame::axle_of(Real steer) const { return cos(steer) * left - sin(steer) * forward; }

VehicleFrame frame_of(const Body& body)
{
    const dVehicleSettings& s = body.vehicle->settings;
    const Vec3 up = normalized_or(load(s.up), {0, 0, 1});
    const Vec3 left = normalized_or(cross(up, load(s.forward)), {0, 1, 0});
    const Mat3 R = body.rotation();
    return {R * cross(left, up), R * left, R * up};
}

Space* space_of_wheels(const Body& body)
{
    const StepState* const kept = body.world->step_state;
    if (Space* space = kept ? kept->world_contacts.live_space() : nullptr) return space;
    Space* found = nullptr;
    for_each_geom(body, [&](Geom& geom) {
        if (!found) found = geom.space;
    });
    while (found && found->space) found = found->space;
    return found;
}

Vec3 WheelCaster::start_of(const dVehicleWheel& wheel) const
{
    return body_.pose().to_world(load(wheel.position)) + (wheel.travel + kAbove * wheel.radius) * frame_.up;
}

bool WheelCaster::collect()
{
    Aabb box{{kInf, kInf, kInf}, {-kInf, -kInf, -kInf}};
    for (const VehicleWheel& wheel : body_.vehicle->all_wheels()) {
        const dVehicleWheel& w = wheel.settings;
        const Vec3 from = start_of(w), to = body_.pose().to_world(load(w.position));
        const Real r = w.radius + w.width, reach = std::max(r, w.radius / kLeastSlope);
        box.lo = min(box.lo, min(from - Vec3{r, r, r}, to - reach * frame_.up - Vec3{r, r, r}));
        box.hi = max(box.hi, max(from + Vec3{r, r, r}, to - reach * frame_.up + Vec3{r, r, r}));
    }
    const dVehicleSettings& s = body_.vehicle->settings;
    const QueryFilter filter{s.category_bits, s.collide_bits, to_handle(&body_)};
    near_.clear();
    if (!collect_near(space_, filter, box, near_)) return false;
    int kept = 0;
    for (Geom* geom : near_)
        if (carries_wheels(*geom)) near_[kept++] = geom;
    near_.truncate(kept);
    return true;
}

WheelContact WheelCaster::under(const VehicleWheel& wheel)
{
    const WheelContact contact = wheel.settings.cast == dWheelRay ? WheelContact{} : by_shape(wheel);
    return contact.geom ? contact : by_ray(wheel);
}

WheelContact WheelCaster::by_ray(const VehicleWheel& wheel)
{
    const dVehicleWheel& w = wheel.settings;
    const Vec3 from = start_of(w), axle = frame_.axle_of(wheel.steer);
    const Real way = w.travel + kAbove * w.radius, length = way + w.radius / kLeastSlope;
    RayQuery query;
    query.origin = from, query.direction = -frame_.up, query.length = length;
    RayProbe probe;
    for (int i = 0; i < 3; ++i) probe.own_rotation[4 * i + 2] = query.direction[i];
    WheelContact best;
    Real nearest = kInf;
    for (Geom* geom : near_) {
        probe.aim(query, std::min(nearest, length));
        dContactGeom hit;
        ContactArray one{&hit, int(sizeof hit), 1, false};
        collide(probe, *geom, one);
        if (one.count == 0 || !(hit.depth < nearest)) continue;
        const Vec3 normal = load(hit.normal);
        const Real slope = dot(normal, frame_.up);
        if (!(slope > kLeastSlope)) continue;
        nearest = hit.depth;
        const Real hub = nearest - w.radius * length_across(normal, axle) / slope;
        best = {from_handle<Geom>(hit.g2), hit.side2, load(hit.pos), normal, way - hub};
    }
    if (!best.geom || best.compression <= 0) return {};
    return best;
}

WheelContact WheelCaster::by_shape(const VehicleWheel& wheel)
{
    const dVehicleWheel& w = wheel.settings;
    const Real length = w.travel + kAbove * w.radius;
    const Way way{-frame_.up, length};
    const Vec3 from = start_of(w), axle = frame_.axle_of(wheel.steer);
    SweepHit hit;
    if (w.cast == dWheelSphere) {
        WheelProbe<Sphere> probe(kSphereType, from, Mat3::identity());
        probe.shape.radius = w.radius;
        hit = nearest(probe, way, near_, frame_.up);
    } else {
        Mat3 R = Mat3::identity();
        (void)rotation_from_z_axis(axle, R);
        WheelProbe<Cylinder> probe(kCylinderType, from, R);
        probe.shape.radius = w.radius, probe.shape.half_length = w.width / 2;
        hit = nearest(probe, way, near_, frame_.up);
    }
    if (!(hit.distance < length)) return {};
    const Vec3 centre = from - hit.distance * frame_.up;
    return {hit.named, hit.side, evened(hit.pos, centre, axle, hit.normal), hit.normal,
            length - hit.distance};
}

}  // namespace epode
