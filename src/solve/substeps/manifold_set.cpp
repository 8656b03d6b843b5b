// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// First-fit graph colouring among moving bodies (solve/common/colours.h), and separate colours for manifolds
// against static bodies.
#include "solve/substeps/manifold_set.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "base/prefetch.h"
#include "solve/common/colours.h"
#include "tasks/stages.h"

namespace epode {
namespace {

// Contact joints have 10. With less, penetration is removed faster and a tall wall leans less. With 4 the top
// of a pile that falls into place is thrown up by the velocity that its rows of contacts add to each other.
constexpr Real kDampingRatio = 7;
constexpr int kBatchPiece = 2, kBodyPiece = 64;   // least pieces of parallel work in a sweep
constexpr int kBatchRange = 8, kBodyRange = 256;  // the same before and after all sweeps

bool dynamic(std::span<const SolverBody> bodies, int index)
{
    return index >= 0 && bodies[std::size_t(index)].inv_mass > 0;
}

struct ManifoldPalette : Palette {
    int fixed = 0;  // the first free colour against what cannot move
};

// Times a substep: approaches above it are landings, those of what rests are of the order of what gravity
// adds and takes.
constexpr Real kSwift = Real(2.5);  // m/s^2

ManifoldSprings springs_of(const Substep& step)
{
    ManifoldSprings out;
    for (const bool fixed : {false, true}) {
        const RowAim aim = default_contact(step, 1, fixed, kContactFrequency, kDampingRatio);
        out.bias_rate[fixed] = float(aim.rate), out.softness[fixed] = float(aim.C);
    }
    return out;
}

// Springs of small bodies.
void stiffen(const ManifoldSources& from, const Substep& step, ManifoldBatch& batch)
{
    for (int lane = 0; lane < batch.lanes; ++lane) {
        const SolverBody &a = *from.body1[lane], &b = *from.body2[lane];
        const Real frequency = contact_frequency(a, &b);
        if (!(frequency > kContactFrequency)) continue;
        const bool fixed = !(a.inv_mass > 0) || !(b.inv_mass > 0);
        const RowAim aim = default_contact(step, 1, fixed, frequency, kDampingRatio);
        batch.bias_rate[lane] = float(aim.rate), batch.softness[lane] = float(aim.C);
        batch.mass_scale[lane] = 1 / (1 + batch.softness[lane]);
    }
}

// Stores the normal impulse of a point, and friction as a vector.
void store_point(const ManifoldBatch& batch, int lane, const BroadLanes& normal, const BroadLanes& along1,
                 const BroadLanes& along2, ManifoldPoint& to)
{
    const float a = along1[lane], c = along2[lane];
    to.normal_impulse = normal[lane];
    to.friction_impulse = {a * batch.t1.x[lane] + c * batch.t2.x[lane],
                           a * batch.t1.y[lane] + c * batch.t2.y[lane],
                           a * batch.t1.z[lane] + c * batch.t2.z[lane]};
}

void store_couple(const ManifoldExtra& extra, int lane, ContactManifold& to)
{
    to.rolling_impulse = {extra.rolling_sum.x[lane], extra.rolling_sum.y[lane], extra.rolling_sum.z[lane]};
}

void set(BroadLaneVec3& to, int lane, Float3 a) { to.x[lane] = a.x, to.y[lane] = a.y, to.z[lane] = a.z; }

}  // namespace

bool ManifoldSet::prepare(const RowSystem& system, const Substep& step, const Tasks& tasks, Arena& arena)
{
    tasks_ = tasks;
    const int count = int(system.contact_manifolds.size());
    if (count == 0) return true;
    hs_ = step.hs;
    sweep_.per_hs = float(1 / step.hs);
    sweep_.swift = float(kSwift * step.hs), sweep_.just_closed = 1e-6f + float(step.hs) * sweep_.swift;
    sweep_.max_bias_velocity = float(default_contact(step, 1, false).max_bias_velocity);
    const int bodies = int(system.bodies.size());
    motions_ = arena.take_zeroed<FloatMotion>(bodies + 1);
    impulse_velocity_ = arena.take<Velocity>(bodies);
    order_ = arena.take<int>(count);
    const auto colours = arena.take<int>(count);
    if (arena.failed()) return false;
    colour(system.contact_manifolds, system.bodies, colours, arena);
    if (arena.failed()) return false;
    const auto starts = arena.take_zeroed<int>(colours_ * kManifoldPoints + 1);
    first_of_colour_ = arena.take<int>(colours_ + 1);
    stages_ = arena.take<Stage>(kMaxVisits * (colours_ + 1));
    if (arena.failed()) return false;
    sort(system.contact_manifolds, colours, starts);
    const int batches = count_batches(system.contact_manifolds, starts);
    batches_ = arena.take<ManifoldBatch>(batches);
    chosen_ = arena.take<int>(batches * kBroadLanes);
    if (arena.failed()) return false;
    const int points = cut(system.contact_manifolds, starts);
    manifold_friction_ = system.manifold_friction;
    if (manifold_friction_)
        frictions_ = arena.take<ManifoldFrictionLanes>(int(batches_.size()));
    else
        points_ = arena.take<ManifoldLanes>(points);
    if (arena.failed() || !place_extras(system.contact_manifolds, arena)) return false;
    fill(system, step);
    return true;
}

void ManifoldSet::colour(std::span<ContactManifold* const> manifolds, std::span<const SolverBody> bodies,
                         std::span<int> colours, Arena& arena)
{
    const auto palettes = arena.take_zeroed<ManifoldPalette>(int(bodies.size()));
    if (arena.failed()) return;
    int moving = 0, fixed = 0;
    for (std::size_t i = 0; i < manifolds.size(); ++i) {
        const ContactManifold& p = *manifolds[i];
        const bool one = dynamic(bodies, p.body1), two = dynamic(bodies, p.body2);
        if (one && two) {
            colours[i] = first_free(palettes[std::size_t(p.body1)], palettes[std::size_t(p.body2)]);
            moving = std::max(moving, colours[i] + 1);
        } else {
            // ~c: counted from the last colour of the others.
            const int c = one || two ? palettes[std::size_t(one ? p.body1 : p.body2)].fixed++ : 0;
            colours[i] = ~c;
            fixed = std::max(fixed, c + 1);
        }
    }
    for (int& c : colours)
        if (c < 0) c = moving + ~c;
    colours_ = moving + fixed;
    [[maybe_unused]] const auto moved = [&](std::size_t i, int side) {
        const int body = side == 0 ? manifolds[i]->body1 : manifolds[i]->body2;
        return dynamic(bodies, body) ? body : -1;
    };
    EPODE_ASSERT(disjoint(colours, moved, arena));
}

// Counting sort by colour, then by number of points, the longest first. Afterwards starts[k] is where key k +
// 1 begins.
void ManifoldSet::sort(std::span<ContactManifold* const> manifolds, std::span<const int> colours,
                       std::span<int> starts)
{
    const auto key = [&](std::size_t i) {
        return std::size_t(colours[i] * kManifoldPoints + kManifoldPoints - manifolds[i]->count);
    };
    for (std::size_t i = 0; i < manifolds.size(); ++i) {
        ++starts[key(i) + 1];
        any_special_ = any_special_ || manifolds[i]->special();
        any_elastic_ = any_elastic_ || manifolds[i]->restitution > 0;
    }
    for (std::size_t k = 1; k < starts.size(); ++k) starts[k] += starts[k - 1];
    for (std::size_t i = 0; i < manifolds.size(); ++i) order_[std::size_t(starts[key(i)]++)] = int(i);
}

// Calls f(colour, first, manifolds) for each batch: eight of the order, or sixteen if the second eight begins
// with as many points, so that no lane must wait for longer ones. Manifolds of one point are visited in their
// own way and are never among others: which they meet may not change their bits.
template <typename F>
void ManifoldSet::for_each_batch(std::span<ContactManifold* const> manifolds, std::span<const int> starts,
                                 F&& f) const
{
    const auto points = [&](int i) { return manifolds[std::size_t(order_[std::size_t(i)])]->count; };
    int from = 0;
    for (int c = 0; c < colours_; ++c)
        for (const int key : {kManifoldPoints - 2, kManifoldPoints - 1}) {
            const int to = starts[std::size_t(c * kManifoldPoints + key)];
            while (from < to) {
                const int left = to - from;
                const bool all = left > kFloatLanes && points(from) == points(from + kFloatLanes);
                const int taken = std::min(left, all ? kBroadLanes : kFloatLanes);
                f(c, from, taken);
                from += taken;
            }
        }
}

int ManifoldSet::count_batches(std::span<ContactManifold* const> manifolds, std::span<const int> starts) const
{
    int count = 0;
    for_each_batch(manifolds, starts, [&](int, int, int) { ++count; });
    return count;
}

// The number of points.
int ManifoldSet::cut(std::span<ContactManifold* const> manifolds, std::span<const int> starts)
{
    first_of_colour_[0] = 0;  // and each colour has manifolds
    int batches = 0, points = 0;
    for_each_batch(manifolds, starts, [&](int colour, int from, int taken) {
        int* lanes = &chosen_[std::size_t(batches * kBroadLanes)];
        std::copy_n(&order_[std::size_t(from)], taken, lanes);
        std::fill(lanes + taken, lanes + kBroadLanes, -1);
        ManifoldBatch& batch = batches_[std::size_t(batches++)];
        batch.first = points;
        batch.count = manifolds[std::size_t(lanes[0])]->count;
        batch.lanes = taken > kFloatLanes ? kBroadLanes : kFloatLanes;
        points += batch.count;
        first_of_colour_[std::size_t(colour) + 1] = batches;
    });
    return points;
}

// False: out of memory.
bool ManifoldSet::place_extras(std::span<ContactManifold* const> manifolds, Arena& arena)
{
    const auto wants = [&](std::size_t b) {
        const auto lanes = chosen_.subspan(b * kBroadLanes, kBroadLanes);
        return std::any_of(lanes.begin(), lanes.end(),
                           [&](int i) { return i >= 0 && manifolds[std::size_t(i)]->special(); });
    };
    for (std::size_t b = 0; b < batches_.size(); ++b) {
        batches_[b].extra = nullptr;
        batches_[b].friction = manifold_friction_ ? &frictions_[b] : nullptr;
    }
    if (!any_special_) return true;
    int count = 0;
    for (std::size_t b = 0; b < batches_.size(); ++b) count += wants(b) ? 1 : 0;
    const auto extras = arena.take_zeroed<ManifoldExtra>(count);
    if (arena.failed()) return false;
    std::size_t next = 0;
    for (std::size_t b = 0; b < batches_.size(); ++b)
        if (wants(b)) batches_[b].extra = &extras[next++];
    return true;
}

void ManifoldSet::fill(const RowSystem& system, const Substep& step)
{
    const auto each_body = [&](auto&& f) { tasks_.each_of(int(impulse_velocity_.size()), kBodyRange, f); };
    each_body([&](std::size_t i) {
        const SolverBody& b = system.bodies[i];
        motions_[i] = {
            {float(b.v.x), float(b.v.y), float(b.v.z), 0, float(b.w.x), float(b.w.y), float(b.w.z), 0}, {}};
    });
    const ManifoldSprings springs = springs_of(step);
    tasks_.each_of(int(batches_.size()), kBatchRange,
                   [&](std::size_t b) { fill_batch(system, step, springs, b); });
    // The state that the first substep begins with.
    each_body([&](std::size_t i) { motions_[i] = {}; });
    motions_.back() = {};
    perform({Visit::kApplyImpulses}, 1, {});
    each_body([&](std::size_t i) {
        for (int k = 0; k < kTwistNumbers; ++k) numbers(impulse_velocity_[i])[k] = motions_[i].velocity[k];
    });
}

// Prefetches the bodies of this batch and the manifolds of the next: neighbours in a batch are not neighbours
// in memory.
void ManifoldSet::prefetch_lanes(const RowSystem& system, std::size_t b) const
{
    for (int lane = 0; lane < kBroadLanes; ++lane) {
        const std::size_t at = b * kBroadLanes + std::size_t(lane), next = at + kBroadLanes;
        if (const int i = chosen_[at]; i >= 0) {
            const ContactManifold& p = *system.contact_manifolds[std::size_t(i)];
            prefetch<3>(system.bodies.data() + p.body1);
            if (p.body2 >= 0) prefetch<3>(system.bodies.data() + p.body2);
        }
        if (b + 1 < batches_.size() && chosen_[next] >= 0)
            prefetch<4>(system.contact_manifolds[std::size_t(chosen_[next])]);
    }
}

void ManifoldSet::fill_batch(const RowSystem& system, const Substep& step, const ManifoldSprings& springs,
                             std::size_t b)
{
    prefetch_lanes(system, b);
    ManifoldBatch& batch = batches_[b];
    ManifoldLanes passing[kManifoldPoints];  // only needed to prepare manifold friction
    ManifoldLanes* points = manifold_friction_ ? passing : &points_[std::size_t(batch.first)];
    ManifoldSources from;
    for (int lane = 0; lane < batch.lanes; ++lane) choose_lane(system, b, lane, from);
    kernels_->gather(batch, points, from, springs);
    if (frequency_limit(step) > kContactFrequency) stiffen(from, step, batch);
    if (batch.extra)
        for (int lane = 0; lane < batch.lanes; ++lane) fill_extra(*from.manifolds[lane], step.n, batch, lane);
    kernels_->prepare(batch, points, motions_.data(), float(1) / float(step.n));
}

void ManifoldSet::choose_lane(const RowSystem& system, std::size_t b, int lane, ManifoldSources& from)
{
    static const ContactManifold none{};
    static const SolverBody world{};
    ManifoldBatch& batch = batches_[b];
    const int manifold = chosen_[b * kBroadLanes + std::size_t(lane)];
    const ContactManifold& p = manifold >= 0 ? *system.contact_manifolds[std::size_t(manifold)] : none;
    if (p.struck) clear_impulses(*system.contact_manifolds[std::size_t(manifold)]);
    const auto choose = [&](int index, int& slot) {
        const bool moves = manifold >= 0 && dynamic(system.bodies, index);
        const int at = manifold >= 0 && index >= 0 ? index : int(system.bodies.size());
        slot = moves ? at : ~at;
        return moves ? &system.bodies[std::size_t(index)] : &world;
    };
    from.manifolds[lane] = &p;
    from.body1[lane] = choose(p.body1, batch.body1[lane]);
    from.body2[lane] = choose(p.body2, batch.body2[lane]);
    batch.share[lane] = p.count ? 1 / float(p.count) : 0;
}

void ManifoldSet::fill_extra(const ContactManifold& p, int substeps, ManifoldBatch& batch, int lane) const
{
    constexpr float kUnbounded = 1e30f;
    ManifoldExtra& extra = *batch.extra;
    extra.max_impulse[lane] =
        p.count > 0 && p.is_bounded() ? p.largest_impulse() / float(substeps) : kUnbounded;
    if (p.has_friction_axis()) {
        const FrictionAxes axes(p);
        set(extra.friction_axis, lane, p.friction_axis);
        extra.s1[lane] = float(axes.s[0]), extra.s2[lane] = float(axes.s[1]);
        batch.mu[lane] = float(axes.mu);
    }
    extra.rolling_friction[lane] = p.rolling_friction;
    if (p.rolling_friction > 0) set(extra.rolling, lane, p.rolling_impulse);
    if (!(p.compliance > 0)) return;
    const Real rate = 1 / (hs_ + Real(p.damping_time));
    extra.bias_rate[lane] = float(rate), extra.compliance[lane] = float(rate * Real(p.compliance) / hs_);
}

ManifoldBodies ManifoldSet::view(std::span<Velocity> bodies)
{
    return {bodies.data(), impulse_velocity_.data(), nullptr, nullptr, motions_.data(), float(hs_)};
}

void ManifoldSet::visit(Visit what, const ManifoldBodies& bodies, int first, int last) const
{
    const ManifoldBatch* batches = batches_.data();
    ManifoldLanes* points = points_.data();
    FloatMotion* motions = motions_.data();
    switch (what) {
        case Visit::kLoad:
            return kernels_->load_velocities(bodies, first, last);
        case Visit::kAccelerate:
            return kernels_->accelerate(bodies, first, last);
        case Visit::kMove:
            return kernels_->move(bodies, first, last);
        case Visit::kTake:
            return kernels_->take_changes(bodies, first, last);
        case Visit::kApplyImpulses:
            return kernels_->apply_impulses(batches, first, last, points, motions);
        case Visit::kCorrect:
            return kernels_->correct(batches, first, last, points, motions, sweep_);
        case Visit::kRelax:
            return kernels_->relax(batches, first, last, points, motions, sweep_);
    }
}

// A few pieces for each worker, the same number for each: a worker that is late should leave some to the
// others.
ManifoldSet::Stage ManifoldSet::stage(Visit visit, int first, int last) const
{
    const int count = last - first, workers = tasks_.workers();
    const int least = is_of_bodies(visit) ? kBodyPiece : kBatchPiece;
    const int turns = std::min(4, count / (least * workers));
    return {visit, first, last, turns > 0 ? turns * workers : std::min(workers, (count + 1) / 2)};
}

int ManifoldSet::list_stages(std::initializer_list<Visit> round)
{
    std::size_t count = 0;
    for (const Visit v : round) {
        if (is_of_bodies(v)) stages_[count++] = stage(v, 0, int(impulse_velocity_.size()));
        for (std::size_t c = 0; !is_of_bodies(v) && c < std::size_t(colours_); ++c)
            stages_[count++] = stage(v, first_of_colour_[c], first_of_colour_[c + 1]);
    }
    return int(count);
}

// A single worker needs no colours, because batches lie in their order. It needs no stages either, which cost
// time when no other worker shares them.
void ManifoldSet::perform(std::initializer_list<Visit> round, int times, const ManifoldBodies& bodies)
{
    if (tasks_.alone()) {
        for (int i = 0; i < times; ++i)
            for (const Visit v : round)
                visit(v, bodies, 0, is_of_bodies(v) ? int(impulse_velocity_.size()) : int(batches_.size()));
        return;
    }
    const int length = list_stages(round);
    const auto stage_at = [&](int i) -> const Stage& { return stages_[std::size_t(i % length)]; };
    in_stages(
        tasks_, times * length, [&](int k) { return stage_at(k).pieces; },
        [&](int k, int piece, int) {
            const Stage& s = stage_at(k);
            const auto at = [&](int i) {
                return s.first + int((long long)(s.last - s.first) * i / s.pieces);
            };
            visit(s.visit, bodies, at(piece), at(piece + 1));
        });
}

void ManifoldSet::correct(std::span<Velocity> bodies)
{
    if (!empty()) perform({Visit::kLoad, Visit::kCorrect, Visit::kTake}, 1, view(bodies));
}

void ManifoldSet::relax(std::span<Velocity> bodies)
{
    if (!empty()) perform({Visit::kLoad, Visit::kRelax, Visit::kTake}, 1, view(bodies));
}

void ManifoldSet::run_substeps(int n, std::span<Velocity> bodies, std::span<const Velocity> force_velocity,
                               std::span<Velocity> mean, std::span<Velocity> ends)
{
    if (empty()) {
        for (int i = 0; i < n; ++i) {
            add(bodies, force_velocity), add(mean, bodies.first(mean.size()));
            add(ends, bodies.first(ends.size()));
        }
        return;
    }
    ManifoldBodies of = view(bodies);
    of.force_velocity = force_velocity.data(), of.mean = mean.data();
    const int pieces = ends.empty() ? 1 : n;
    for (int i = 0; i < pieces; ++i) {
        perform({Visit::kAccelerate, Visit::kCorrect, Visit::kMove, Visit::kRelax, Visit::kTake}, n / pieces,
                of);
        add(ends, bodies.first(ends.size()));
    }
}

// With u the approach before the forces of a substep, d = hs a what they add to it and s the separation, a
// substep is u <- u + d, s <- s - hs u, which conserves
//
//   E = u^2/2 + d u/2 + a s
//
// The departure w from s = 0 that has the same energy, and so leads back to where the body came from, is
// w = d/2 + sqrt((u + d/2)^2 + 2 a s).
void ManifoldSet::expect_impacts(const RowSystem& system, std::span<const Velocity> force_velocity)
{
    const auto forced = [&](int body, Vec3 n, Vec3 r) {
        if (body < 0) return Real(0);
        const Velocity& f = force_velocity[std::size_t(body)];
        return dot(n, f.v) + dot(cross(r, n), f.w);
    };
    for (std::size_t b = 0; any_elastic_ && b < batches_.size(); ++b)
        for (int lane = 0; lane < batches_[b].lanes; ++lane) {
            if (!(batches_[b].restitution[lane] > 0)) continue;
            const int index = chosen_[b * kBroadLanes + std::size_t(lane)];
            if (index < 0) continue;
            const ContactManifold& m = *system.contact_manifolds[std::size_t(index)];
            for (int i = 0; i < m.count; ++i) {
                const ManifoldPoint& point = m.points[i];
                BroadLanes& velocity = initial_velocity_of(batches_[b], i);
                const Vec3 n = widen(m.normal);
                const Real u = -Real(velocity[lane]), s = Real(point.separation);
                const Real d = forced(m.body2, n, widen(point.r2)) - forced(m.body1, n, widen(point.r1));
                if (!(u > 0) || !(s > 0) || !(d > 0)) continue;
                const Real middle = u + d / 2;
                velocity[lane] = -float(d / 2 + std::sqrt(middle * middle + 2 * s * d / hs_));
            }
        }
}

BroadLanes& ManifoldSet::initial_velocity_of(const ManifoldBatch& batch, int point) const
{
    return batch.friction ? batch.friction->points[point].initial_velocity
                          : points_[std::size_t(batch.first + point)].initial_velocity;
}

bool ManifoldSet::find_rebounds(std::span<ContactManifold* const> manifolds, Arena& arena,
                                std::span<float>& rebounds) const
{
    if (!any_elastic_) return true;
    rebounds = arena.take_zeroed<float>(int(manifolds.size()) * kManifoldPoints);
    if (arena.failed()) return false;
    for (std::size_t b = 0; b < batches_.size(); ++b)
        for (int lane = 0; lane < batches_[b].lanes; ++lane) {
            const int index = chosen_[b * kBroadLanes + std::size_t(lane)];
            if (index < 0 || !(manifolds[std::size_t(index)]->restitution > 0)) continue;
            const ContactManifold& m = *manifolds[std::size_t(index)];
            for (int i = 0; i < m.count; ++i) {
                const float approach = -initial_velocity_of(batches_[b], i)[lane];
                const bool bounces = m.points[i].normal_impulse > 0 && approach > m.restitution_threshold;
                if (bounces || approach < 0)
                    rebounds[std::size_t(index * kManifoldPoints + i)] = m.restitution * approach;
            }
        }
    return true;
}

void ManifoldSet::apply_impulses(std::span<Velocity> bodies) const { add(bodies, impulse_velocity_); }

void ManifoldSet::apply_impulses(std::span<SolverBody> bodies) const
{
    for (std::size_t i = 0; i < impulse_velocity_.size(); ++i)
        bodies[i].v += impulse_velocity_[i].v, bodies[i].w += impulse_velocity_[i].w;
}

void ManifoldSet::follow_motion(std::span<const Velocity> bodies)
{
    const float hs = float(hs_);
    for (std::size_t i = 0; i < impulse_velocity_.size(); ++i) {
        float* to = motions_[i].displacement;
        for (int k = 0; k < kTwistNumbers; ++k) to[k] += hs * float(numbers(bodies[i])[k]);
    }
}

void ManifoldSet::store_impulses(std::span<ContactManifold* const> manifolds) const
{
    tasks_.each_of(int(batches_.size()), kBatchRange, [&](std::size_t b) {
        BroadLanes along1[kManifoldPoints], along2[kManifoldPoints], struck;
        const ManifoldBatch& batch = batches_[b];
        if (batch.friction) kernels_->share_friction(batch, along1, along2);
        kernels_->find_blows(batch, points_.data() + batch.first, motions_.data(), struck);
        for (int lane = 0; lane < batch.lanes; ++lane) {
            const int index = chosen_[b * kBroadLanes + std::size_t(lane)];
            if (index < 0) continue;
            ContactManifold& manifold = *manifolds[std::size_t(index)];
            if (batch.extra) store_couple(*batch.extra, lane, manifold);
            manifold.struck = struck[lane] > 0;
            for (int i = 0; i < manifold.count; ++i) {
                const std::size_t at = std::size_t(batch.first + i);
                if (batch.friction)
                    store_point(batch, lane, batch.friction->points[i].sum, along1[i], along2[i],
                                manifold.points[i]);
                else
                    store_point(batch, lane, points_[at].sum[0], points_[at].sum[1], points_[at].sum[2],
                                manifold.points[i]);
            }
        }
    });
}

}  // namespace epode
