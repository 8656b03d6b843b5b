// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "characters/mover.h"

#include <algorithm>

#include "contacts/material.h"
#include "math/trig.h"
#include "step/common/link.h"

namespace epode {
namespace {

constexpr int kSlides = 8, kFrees = 16, kSlips = 3;
constexpr Real kFoothold = Real(0.2);  // the least n . up of a touch that can bear a character
constexpr Real kLanding = Real(0.1);   // of the skin: ground so much farther away is stood on still
constexpr Real kLeaves = Real(1e-3);   // of the speed: leads away from the ground
constexpr Real kStride =
    Real(0.03);  // of the radius: the least way onto a step, a little over what kFoothold needs
constexpr Real kShifted = Real(1e-3);      // m, of the weight on what it stands on
constexpr Real kNothing = Real(1e-12);     // m
constexpr Real kRounding = 64 * kEpsilon;  // of a motion, how far it may lead into a plane that it follows

Vec3 without(Vec3 v, Vec3 n) { return v - dot(v, n) * n; }

}  // namespace

Mover::Mover(Geom& self, Vec3 velocity, Real h)
    : self_(self),
      character_(*self.character),
      settings_(character_.settings),
      up_(character_.up),
      velocity_(velocity),
      h_(h),
      skin_(settings_.skin),
      slope_cos_(cos(settings_.slope_limit)),
      half_height_(half_height(self)),
      force_left_(settings_.max_force * h),
      around_(self, velocity)
{
    start_ = at_ = load(self.own_position);
    nothing_ = std::max(kNothing, kEpsilon * (length(start_) + half_height_));
    const Real rise = dot(velocity, up_);
    const bool leaves = rise > 0 && dot(velocity, character_.ground_normal) > kLeaves * length(velocity);
    grounded_ = character_.state == dCharacterOnGround && !leaves && !character_.launched;
}

bool Mover::run()
{
    Real rotation[12];
    std::copy_n(self_.own_rotation, 12, rotation);
    character_.turn = 0, character_.carried = {};
    if (character_.state >= dCharacterOnSteep) ride();
    if (!collect()) {
        std::copy_n(rotation, 12, self_.own_rotation);
        return false;
    }
    character_.climbed = 0, character_.hit_wall = character_.hit_ceiling = false;
    free();
    const Vec3 motion = without_advance(h_ * velocity_);
    slide(grounded_ ? along_ground(motion, character_.ground_normal) : motion);
    if (grounded_) stick();
    const dGeomID before = character_.ground;
    settle();
    if (before != character_.ground) unload(before);
    store(self_.own_position, at_);
    character_.velocity = at_ == start_ ? Vec3{} : (at_ - start_) / h_;
    character_.launched = false;
    mark_moved(self_);
    return true;
}

bool Mover::collect()
{
    store(self_.own_position, at_);
    self_.box_stale = true;
    const Real sideways = h_ * length(velocity_) + 4 * skin_ + kStride * settings_.radius;
    const Real vertical = std::max(settings_.step_height, settings_.stick_distance) + skin_;
    const Vec3 reach = Vec3{sideways, sideways, sideways} + vertical * abs(up_);
    const Aabb box = box_of(self_);
    const bool complete = around_.collect(*self_.space, {box.lo - reach, box.hi + reach});
    if (!complete) store(self_.own_position, start_), self_.box_stale = true;
    return complete;
}

// ---- ride ----

void Mover::ride()
{
    Geom* const ground = from_handle<Geom>(character_.ground);
    if (!ground || is_space(*ground)) return;
    at_ += h_ * belt(*ground, character_.ground_pos, character_.ground_normal);
    if (!ground->type->placeable) return;
    const Pose now = pose_of(*ground), &then = character_.ground_pose;
    if (now.p == then.p && now.R.row0 == then.R.row0 && now.R.row1 == then.R.row1 &&
        now.R.row2 == then.R.row2)
        return;
    const Vec3 foot = at_ - (half_height_ + skin_) * up_;
    character_.carried = now.to_world(then.to_local(foot)) - foot;
    at_ += character_.carried;
    turn(now.R * transpose(then.R));
}

// The velocity of a surface that moves while its geom does not.
Vec3 Mover::belt(Geom& ground, Vec3 pos, Vec3 normal) const
{
    if (!ground.material) return {};
    const Vec3 v = load(material_at(ground, pos, normal).surface_velocity);
    if (v == Vec3{}) return {};
    return without(ground.type->placeable ? pose_of(ground).R * v : v, normal);
}

// The part of a rotation that is about up: of its quaternion the real part and the one along up.
void Mover::turn(const Mat3& by)
{
    const Quat q = to_quat(by);
    const Real along = dot(q.vec(), up_);
    Quat twist = {q.w, along * up_.x, along * up_.y, along * up_.z};
    if (along == 0 || !normalize(twist)) return;
    const Real sign = twist.w < 0 ? Real(-1) : Real(1);
    character_.turn = 2 * atan2(sign * dot(twist.vec(), up_), sign * twist.w);
    const Mat3 R = to_matrix(twist);
    store_mat(self_.own_rotation, R * load_mat(self_.own_rotation));
    character_.ground_normal = R * character_.ground_normal;
    character_.inherited = R * character_.inherited;
}

// ---- free ----

// Leads out of all that is closer than the skin, one after the other until all agree.
Vec3 Mover::way_out(Real& deepest)
{
    Array<Touch> close;
    deepest = 0;
    for (int i = 0; i < around_.count(); ++i) {
        const Touch touch = around_.touch(i, at_, 0);
        if (touch.obstacle < 0 || touch.distance > -8 * around_.tolerance()) continue;
        deepest = std::max(deepest, -touch.distance);
        if (!close.push(touch)) break;
    }
    Vec3 out;
    for (int round = 0; round < 8; ++round)
        for (const Touch& touch : close) {
            const Real lacks = -touch.distance - dot(out, touch.normal);
            if (lacks > 0) out += lacks * touch.normal;
        }
    for (const Touch& touch : close) push(touch);
    return out;
}

void Mover::free()
{
    Real deepest = 0;
    for (int i = 0; i < kFrees; ++i) {
        const Vec3 out = way_out(deepest);
        if (deepest == 0) break;
        // What it is too close to already does not stop it.
        const Touch stop =
            around_.cast(at_, out, [&](int o) { return around_.touch(o, at_, 0).distance < 0; });
        const Real far = length(out);
        at_ += stop.obstacle >= 0 && far > 0 ? (stop.distance / far) * out : out;
        if (far < around_.tolerance()) break;
    }
    character_.overlap = deepest > skin_ ? deepest - skin_ : 0;
}

// ---- slide ----

// What climbing has gone in advance it owes along the same way; in another direction that is forgotten.
Vec3 Mover::without_advance(Vec3 motion)
{
    const Vec3 owed = character_.inherited, level = without(motion, up_);
    const Real asked = length(level);
    if (!grounded_ || owed == Vec3{} || asked < nothing_) return motion;
    const Vec3 ahead = level / asked;
    const Real along = std::max(dot(owed, ahead), Real(0)), paid = std::min(along, asked);
    character_.inherited = (along - paid) * ahead;
    return motion - paid * ahead;
}

// The horizontal part stays, the vertical one follows the plane.
Vec3 Mover::along_ground(Vec3 motion, Vec3 n) const
{
    const Vec3 level = without(motion, up_);
    const Real slope = dot(n, up_);
    return slope > kFoothold ? level - (dot(level, n) / slope) * up_ : level;
}

// Steep surfaces are walls where they would lead the motion up, or off the ground.
Vec3 Mover::slide_normal(Vec3 n, Vec3 motion) const
{
    const Real rise = dot(n, up_);
    const bool lifts = rise > 0 && dot(without(motion, n), up_) > std::max(dot(motion, up_), Real(0));
    const Vec3 level = without(n, up_);
    if (!is_steep(n) || !(grounded_ || lifts) || !(length2(level) > Real(1e-6))) return n;
    return level / length(level);
}

// `motion` without what leads into the planes.
Vec3 Mover::bent(Vec3 motion) const
{
    const auto allowed = [&](Vec3 v, int i, int k) {
        const Real into = std::max(kNothing, kRounding * length(v));
        for (int j = 0; j < planes_; ++j)
            if (j != i && j != k && dot(v, plane_[j]) < -into) return false;
        return true;
    };
    for (int i = planes_; i-- > 0;) {
        if (!(dot(motion, plane_[i]) < 0)) continue;
        const bool walks = grounded_ && !is_steep(plane_[i]);
        const Vec3 v = walks ? along_ground(motion, plane_[i]) : without(motion, plane_[i]);
        if (allowed(v, i, i)) return v;
    }
    for (int i = planes_; i-- > 0;)
        for (int k = i; k-- > 0;) {
            Vec3 crease = cross(plane_[i], plane_[k]);
            if (!normalize(crease)) continue;
            const Vec3 v = dot(motion, crease) * crease;
            if (allowed(v, i, k)) return v;
        }
    return allowed(motion, -1, -1) ? motion : Vec3{};
}

void Mover::meet(const Touch& touch, Vec3 motion)
{
    const Real rise = dot(touch.normal, up_);
    if (rise < Real(-0.5)) character_.hit_ceiling = true;
    if (is_steep(touch.normal) && rise >= Real(-0.5)) character_.hit_wall = true;
    if (is_steep(touch.normal)) push(touch);
    const Vec3 n = slide_normal(touch.normal, motion);
    (void)met_.push(n);
    if (planes_ < kMaxPlanes) plane_[planes_++] = n;
}

void Mover::slide(Vec3 motion)
{
    const Vec3 first = motion;
    planes_ = 0;
    for (int i = 0; i < kSlides && length(motion) > nothing_; ++i) {
        const Touch touch = around_.cast(at_, motion);
        if (touch.obstacle < 0) {
            at_ += motion;
            return;
        }
        const Real far = length(motion);
        at_ += (touch.distance / far) * motion;
        motion = (1 - touch.distance / far) * motion;
        if (grounded_ && is_steep(touch.normal) && climb(motion)) {
            planes_ = 0;
            continue;
        }
        meet(touch, motion);
        motion = bent(motion);
        if (dot(motion, first) <= 0 && i > 0) return;  // back and forth in a corner
    }
}

Vec3 Mover::unhindered(Vec3 v) const
{
    for (const Vec3 n : met_) v -= std::min(dot(v, n), Real(0)) * n;
    return v;
}

// ---- climb ----

bool Mover::climb(Vec3& motion)
{
    Vec3 ahead = without(motion, up_);
    const Real asked = length(ahead);
    if (!(settings_.step_height > 0) || asked < nothing_) return false;
    ahead = ahead / asked;
    Vec3 q = at_;
    const Real height = settings_.step_height + Real(0.5) * skin_;
    const Touch above = around_.cast(q, height * up_);
    const Real lifted = above.obstacle < 0 ? height : above.distance;
    if (lifted < skin_) return false;
    q += lifted * up_;
    const Real stride = std::max(asked, kStride * settings_.radius);
    const Touch wall = around_.cast(q, stride * ahead);
    const Real forward = wall.obstacle < 0 ? stride : wall.distance;
    if (forward < Real(0.1) * kStride * settings_.radius) return false;
    q += forward * ahead;
    const Touch landing = around_.cast(q, -(lifted + skin_) * up_);
    if (landing.obstacle < 0) return false;
    q -= landing.distance * up_;
    const Real rise = dot(q - at_, up_);
    const Touch support = support_at(q);
    if (support.obstacle < 0 || rise <= around_.tolerance()) return false;
    if (dot(support.pos, up_) - feet(at_) > settings_.step_height + Real(0.2) * skin_) return false;
    character_.climbed += rise;
    at_ = q;
    motion = std::max(asked - forward, Real(0)) * ahead;
    character_.inherited += std::max(forward - asked, Real(0)) * ahead;
    return true;
}

// ---- ground ----

bool Mover::supports(const Touch& touch, Vec3 face) const
{
    const Real rise = dot(touch.normal, up_);
    return rise >= kFoothold && std::max(rise, dot(face, up_)) >= slope_cos_;
}

// The touch that bears most upright; of those that bear none.
const Touch& Mover::support_at(Vec3 centre)
{
    if (support_.known && support_.centre == centre) return support_.touch;
    support_ = {centre, {}, {}, true};
    Real best = kFoothold;
    for (int i = 0; i < around_.count(); ++i) {
        const Touch touch = around_.touch(i, centre, kLanding * skin_);
        const Real rise = dot(touch.normal, up_);
        if (touch.obstacle < 0 || !(rise >= kFoothold)) continue;
        const Vec3 n = around_.face_normal(touch, up_);
        const Real own = std::max(rise, dot(n, up_));
        if (!supports(touch, n) || own <= best) continue;
        best = own;
        support_.touch = touch, support_.face = dot(n, up_) >= rise ? n : touch.normal;
    }
    return support_.touch;
}

// Past an edge that bears it no more it slips, as far as the edge is in the way.
void Mover::stick()
{
    if (support_at(at_).obstacle >= 0) return;
    Vec3 there = at_, down = -(settings_.stick_distance + skin_) * up_;
    for (int i = 0; i < kSlips; ++i) {
        const Touch below = around_.cast(there, down);
        if (below.obstacle < 0) return;
        there += (below.distance / length(down)) * down;
        if (support_at(there).obstacle >= 0) {
            at_ = there;
            return;
        }
        if (!(dot(below.normal, up_) < kFoothold)) return;
        down = without((1 - below.distance / length(down)) * down, below.normal);
        if (!(length(down) > nothing_)) return;
    }
}

void Mover::stand_on(const Touch& touch, Vec3 face)
{
    const Obstacle& o = around_[touch.obstacle];
    const dGeomID id = to_handle(o.geom);
    const bool same = character_.ground == id;
    const bool elsewhere = !same || length(touch.pos - character_.ground_pos) > kShifted;
    character_.ground = id, character_.ground_side = o.side;
    character_.ground_pos = touch.pos, character_.ground_normal = face;
    character_.ground_pose = o.geom->type->placeable ? pose_of(*o.geom) : Pose{};
    const Body* const body = body_of(*o.geom);
    character_.ground_velocity = body   ? body->point_velocity(touch.pos)
                                 : same ? character_.carried / h_
                                        : Vec3{};
    character_.ground_velocity += belt(*o.geom, touch.pos, face);
    if (character_.state == dCharacterOnGround) weigh(elsewhere);
}

void Mover::settle()
{
    const bool rises = dot(velocity_, up_) > 0 && !grounded_, stood = character_.state == dCharacterOnGround;
    Touch touch = support_at(at_);
    const Vec3 face = support_.face;
    // While it leaves the ground it does not stand.
    if (rises && dot(velocity_, face) > kLeaves * length(velocity_)) touch = {};
    character_.state = dCharacterOnGround;
    if (touch.obstacle >= 0) {
        if (!stood) character_.inherited = {};  // it has landed
        return stand_on(touch, face);
    }
    if (stood) character_.inherited = {};
    character_.state = dCharacterInAir;
    Real rise = Real(0.05);
    for (int i = 0; i < around_.count() && !rises; ++i) {
        const Touch steep = around_.touch(i, at_, kLanding * skin_);
        if (steep.obstacle < 0 || dot(steep.normal, up_) <= rise) continue;
        touch = steep, rise = dot(steep.normal, up_);
    }
    if (touch.obstacle >= 0) {
        character_.state = dCharacterOnSteep;
        return stand_on(touch, touch.normal);
    }
    character_.ground = nullptr, character_.ground_side = -1;
    character_.ground_pos = character_.ground_normal = character_.ground_velocity = {};
    character_.ground_pose = {};
}

}  // namespace epode
