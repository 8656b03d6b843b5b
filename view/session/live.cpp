// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See live.h. Everything by the public C API.
#include "view/session/live.h"

#include <cmath>
#include <string>

#include "scenes/extensions.h"
#include "view/session/ray.h"

namespace epode::view {

namespace {

constexpr double kSpringRate = 2 * 3.14159265358979 * 2.5;  // w, 1/s

Vec vec_of(const dReal* v) { return {double(v[0]), double(v[1]), double(v[2])}; }

// The setter normalises, which may change last bits of a quaternion that came out of a normalisation already.
// What is looked for is a quaternion that becomes the wanted one: multiples of it, each number a last bit up
// or down; one of the first few nearly always does; for one in some thousands none does, and the nearest is
// taken.
void set_turn_exactly(dBodyID body, const record::Quat& q)
{
    constexpr int kMultiples = 256, kNudges = 81;
    dQuaternion given;
    for (int attempt = 0; attempt < kMultiples * kNudges; ++attempt) {
        // From 1 up to 2, and from 1 down to 1/2.
        const int multiple = attempt % kMultiples;
        const double grown = 1 + multiple / double(kMultiples), factor = multiple % 2 ? 1 / grown : grown;
        int nudges = attempt / kMultiples;
        bool same = true;
        for (size_t i = 0; i < 4; ++i, nudges /= 3) {
            given[i] = dReal(q[i] * factor);
            if (nudges % 3 != 0) given[i] = std::nextafter(given[i], nudges % 3 == 1 ? dReal(2) : dReal(-2));
        }
        dBodySetQuaternion(body, given);
        const dReal* got = dBodyGetQuaternion(body);
        for (size_t i = 0; i < 4; ++i) same = same && got[i] == dReal(q[i]);
        if (same) return;
    }
    for (size_t i = 0; i < 4; ++i) given[i] = dReal(q[i]);
    dBodySetQuaternion(body, given);
}

void put(dBodyID body, const record::BodyState& state, bool asleep)
{
    const auto& [pose, linear, angular] = state;
    dBodySetPosition(body, dReal(pose.pos[0]), dReal(pose.pos[1]), dReal(pose.pos[2]));
    set_turn_exactly(body, pose.turn);
    dBodySetLinearVel(body, dReal(linear[0]), dReal(linear[1]), dReal(linear[2]));
    dBodySetAngularVel(body, dReal(angular[0]), dReal(angular[1]), dReal(angular[2]));
    dBodySetForce(body, 0, 0, 0);
    dBodySetTorque(body, 0, 0, 0);
    asleep ? dBodyDisable(body) : dBodyEnable(body);
}

}  // namespace

Live::Live(const scenes::Recipe& recipe, const LiveOptions& given) : options(given), recipe_(recipe)
{
    build();
}

void Live::build()
{
    recorder_.reset();
    scene_.reset();
    stage_ = std::make_unique<Stage>(options.memory);
    scene_ = std::make_unique<scenes::Scene>(recipe_, options.seed);
    if (std::string problem; options.world_contacts) (void)scene_->manage_contacts(problem);
    scenes::request_step_report(scene_->world(), true);
    recorder_ = std::make_unique<SceneRecorder>(*scene_, *stage_);
    shots_.clear();
    now_ = 0;
    failed_ = false;
    release();
    sample();
}

void Live::restart() { build(); }

std::vector<scenes::Cause> Live::causes() const
{
    constexpr size_t kMax = 8;
    return scenes::causes_of(*scene_, kMax);
}

void Live::sample()
{
    const scenes::Quality quality = scenes::measure(*scene_);
    recorder_->state(quality, options.dt);
    State& state = stage_->at(stage_->last());
    if (const auto report = scenes::step_report(scene_->world())) state.figures.residual = report->residual;
    state.random = dRandGetSeed();
    state.figures.collide_ms = scene_->times().collide_ms;
    state.figures.step_ms = scene_->times().step_ms;
    state.figures.empty_ms = scene_->times().empty_ms;
    failed_ = failed_ || quality.not_finite > 0;
}

bool Live::step()
{
    if (failed_) return false;
    stage_->cut_after(now_);
    forget_shots_aside();
    scene_->set_iterations(options.iterations);
    scenes::set_step_threads(scene_->world(), options.threads);
    scenes::set_diagnosis(scene_->world(), options.diagnose);
    pull();
    failed_ = !scene_->step(options.stepper, options.dt);
    sample();
    now_ = stage_->last();
    return !failed_;
}

bool Live::seek(size_t number)
{
    if (number < stage_->first() || number > stage_->last()) return false;
    const Moment then = stage_->moment(number);
    for (Shot& shot : shots_) {
        if (shot.number < then.bodies.size()) put_aside(shot, !then.bodies[shot.number]);
    }
    for (size_t i = 0; i < then.bodies.size(); ++i) {
        if (then.bodies[i]) put(scene_->bodies()[i], *then.bodies[i], then.asleep[i]);
    }
    scene_->set_time(then.step->time);
    dRandSetSeed(stage_->at(number).random);
    scenes::set_diagnosis(scene_->world(), false);  // a jump looks like overlaps and forces from nowhere
    failed_ = false;
    now_ = number;
    return true;
}

std::optional<Hit> Live::pick(Vec origin, Vec direction)
{
    const auto met = closest_geom(scene_->space(), origin, direction);
    if (!met) return std::nullopt;
    Hit hit;
    hit.point = met->point;
    hit.distance = met->distance;
    const auto& geoms = scene_->geoms();
    for (size_t i = 0; i < geoms.size(); ++i) {
        if (geoms[i] == met->geom) hit.geom = std::uint32_t(i);
    }
    const dBodyID struck = dGeomGetBody(met->geom);
    for (size_t i = 0; struck && i < scene_->bodies().size(); ++i) {
        if (scene_->bodies()[i] == struck) hit.body = std::int32_t(i);
    }
    return hit;
}

void Live::grab(std::int32_t number, Vec point)
{
    if (number < 0 || size_t(number) >= scene_->bodies().size()) return;
    dVector3 local;
    dBodyGetPosRelPoint(body(number), dReal(point.x), dReal(point.y), dReal(point.z), local);
    grabbed_ = number;
    local_hook_ = vec_of(local);
    target_ = point;
}

Vec Live::hook() const
{
    dVector3 point;
    dBodyGetRelPointPos(body(grabbed_), dReal(local_hook_.x), dReal(local_hook_.y), dReal(local_hook_.z),
                        point);
    return vec_of(point);
}

void Live::pull()
{
    if (grabbed_ == record::kNobody) return;
    dBodyID b = body(grabbed_);
    dMass mass;
    dBodyGetMass(b, &mass);
    const double least = std::min({double(mass.I[0]), double(mass.I[5]), double(mass.I[10])});
    const double m = 1 / (1 / double(mass.mass) + scenes::dot(local_hook_, local_hook_) / least);
    const Vec p = hook();
    dVector3 moving;
    dBodyGetPointVel(b, dReal(p.x), dReal(p.y), dReal(p.z), moving);
    // Long steps want a softer spring: w h below 1/4.
    const double w = std::min(kSpringRate, 0.25 / options.dt);
    const Vec f = (m * w * w) * (target_ - p) - (2 * m * w) * vec_of(moving);
    if (!std::isfinite(scenes::length(f))) return;
    dBodyEnable(b);
    dBodyAddForceAtPos(b, dReal(f.x), dReal(f.y), dReal(f.z), dReal(p.x), dReal(p.y), dReal(p.z));
}

void Live::push(std::int32_t number, Vec point, Vec impulse)
{
    if (number < 0 || size_t(number) >= scene_->bodies().size()) return;
    dBodyID b = body(number);
    dVector3 force;
    dWorldImpulseToForce(scene_->world(), dReal(options.dt), dReal(impulse.x), dReal(impulse.y),
                         dReal(impulse.z), force);
    dBodyEnable(b);
    dBodyAddForceAtPos(b, force[0], force[1], force[2], dReal(point.x), dReal(point.y), dReal(point.z));
}

void Live::shoot(Vec from, Vec velocity, double radius, double mass)
{
    dMass m;
    dMassSetSphereTotal(&m, dReal(mass), dReal(radius));
    Shot shot{dBodyCreate(scene_->world()), dCreateSphere(scene_->space(), dReal(radius)),
              scene_->bodies().size()};
    dBodySetMass(shot.body, &m);
    dGeomSetBody(shot.geom, shot.body);
    dBodySetPosition(shot.body, dReal(from.x), dReal(from.y), dReal(from.z));
    dBodySetLinearVel(shot.body, dReal(velocity.x), dReal(velocity.y), dReal(velocity.z));
    scene_->add_body(shot.body);
    scene_->add_geom(shot.geom);
    shots_.push_back(shot);
}

void Live::put_aside(Shot& shot, bool aside)
{
    if (shot.aside == aside || shot.forgotten) return;
    shot.aside = aside;
    aside ? dGeomDisable(shot.geom) : dGeomEnable(shot.geom);
    dBodySetGravityMode(shot.body, aside ? 0 : 1);
    if (!aside) return;
    dBodySetLinearVel(shot.body, 0, 0, 0);
    dBodySetAngularVel(shot.body, 0, 0, 0);
    dBodyDisable(shot.body);
}

void Live::forget_shots_aside()
{
    for (Shot& shot : shots_) {
        if (!shot.aside || shot.forgotten) continue;
        shot.forgotten = true;
        recorder_->recorder().remove(shot.geom);
        recorder_->recorder().remove(shot.body);
    }
}

}  // namespace epode::view
