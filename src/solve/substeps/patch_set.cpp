// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// First-fit colours among moving bodies (solve/common/colours.h), and a count of their own for patches
// against what cannot move.
#include "solve/substeps/patch_set.h"

#include <algorithm>

#include "base/ahead.h"
#include "base/check.h"
#include "solve/common/colours.h"
#include "tasks/stages.h"

namespace epode {
namespace {

// Less than contact joints have, 10: what is deep comes out faster, and a tall wall leans less. With 4 the
// top of a pile that falls into place is thrown up by what its rows push one another apart.
constexpr Real kDampingRatio = 7;
constexpr int kBatchPiece = 2, kBodyPiece = 64;   // of parallel work in a sweep, at least
constexpr int kBatchRange = 8, kBodyRange = 256;  // and before and behind all of them

bool dynamic(std::span<const SolverBody> bodies, int index)
{
    return index >= 0 && bodies[std::size_t(index)].inv_mass > 0;
}

struct PatchPalette : Palette {
    int fixed = 0;  // the first free colour against what cannot move
};

PatchSprings springs_of(const Substep& step)
{
    PatchSprings out;
    for (const bool fixed : {false, true}) {
        const RowAim aim = default_contact(step, 1, fixed, kDampingRatio);
        out.rate[fixed] = float(aim.rate), out.soft[fixed] = float(1 / (1 + aim.C));  // 1 - C/(1 + C)
    }
    return out;
}

// Of a point: its push, and friction along the tangents.
void store_point(const PatchBatch& batch, int lane, const BroadLanes& push, const BroadLanes& along1,
                 const BroadLanes& along2, PatchPoint& to)
{
    const float a = along1[lane], c = along2[lane];
    to.push = push[lane];
    to.friction = {a * batch.t1.x[lane] + c * batch.t2.x[lane], a * batch.t1.y[lane] + c * batch.t2.y[lane],
                   a * batch.t1.z[lane] + c * batch.t2.z[lane]};
}

void store_couple(const PatchExtra& extra, int lane, Patch& to)
{
    to.roll = {extra.roll_sum.x[lane], extra.roll_sum.y[lane], extra.roll_sum.z[lane]};
}

void set(BroadLaneVec3& to, int lane, Float3 a) { to.x[lane] = a.x, to.y[lane] = a.y, to.z[lane] = a.z; }

}  // namespace

bool PatchSet::prepare(const RowSystem& system, const Substep& step, const Tasks& tasks, Arena& arena)
{
    tasks_ = tasks;
    const int count = int(system.patches.size());
    if (count == 0) return true;
    hs_ = step.hs;
    sweep_.per_step = float(1 / step.hs);
    sweep_.push_out = float(default_contact(step, 1, false).push);
    const int bodies = int(system.bodies.size());
    motions_ = arena.take_zeroed<FloatMotion>(bodies + 1);
    kicks_ = arena.take<Velocity>(bodies);
    order_ = arena.take<int>(count);
    const auto colours = arena.take<int>(count);
    if (arena.failed()) return false;
    colour(system.patches, system.bodies, colours, arena);
    if (arena.failed()) return false;
    const auto starts = arena.take_zeroed<int>(colours_ * kPatchPoints + 1);
    first_of_colour_ = arena.take<int>(colours_ + 1);
    stages_ = arena.take<Stage>(kMostVisits * (colours_ + 1));
    if (arena.failed()) return false;
    sort(system.patches, colours, starts);
    const int batches = count_batches(system.patches, starts);
    batches_ = arena.take<PatchBatch>(batches);
    chosen_ = arena.take<int>(batches * kBroadLanes);
    if (arena.failed()) return false;
    const int points = cut(system.patches, starts);
    whole_ = system.manifold_friction;
    if (whole_)
        frictions_ = arena.take<PatchFriction>(int(batches_.size()));
    else
        points_ = arena.take<PatchLanes>(points);
    if (arena.failed() || !place_extras(system.patches, arena)) return false;
    fill(system, step);
    return true;
}

void PatchSet::colour(std::span<Patch* const> patches, std::span<const SolverBody> bodies,
                      std::span<int> colours, Arena& arena)
{
    const auto palettes = arena.take_zeroed<PatchPalette>(int(bodies.size()));
    if (arena.failed()) return;
    int moving = 0, fixed = 0;
    for (std::size_t i = 0; i < patches.size(); ++i) {
        const Patch& p = *patches[i];
        const bool one = dynamic(bodies, p.body1), two = dynamic(bodies, p.body2);
        if (one && two) {
            colours[i] = first_free(palettes[std::size_t(p.body1)], palettes[std::size_t(p.body2)]);
            moving = std::max(moving, colours[i] + 1);
        } else {
            // ~c: counted from behind the last colour of the others.
            const int c = one || two ? palettes[std::size_t(one ? p.body1 : p.body2)].fixed++ : 0;
            colours[i] = ~c;
            fixed = std::max(fixed, c + 1);
        }
    }
    for (int& c : colours)
        if (c < 0) c = moving + ~c;
    colours_ = moving + fixed;
    [[maybe_unused]] const auto moved = [&](std::size_t i, int side) {
        const int body = side == 0 ? patches[i]->body1 : patches[i]->body2;
        return dynamic(bodies, body) ? body : -1;
    };
    EPODE_ASSERT(disjoint(colours, moved, arena));
}

// Counting sort by colour, then by number of points, the longest first. Behind it, starts[k] is where the
// next key begins.
void PatchSet::sort(std::span<Patch* const> patches, std::span<const int> colours, std::span<int> starts)
{
    const auto key = [&](std::size_t i) {
        return std::size_t(colours[i] * kPatchPoints + kPatchPoints - patches[i]->count);
    };
    for (std::size_t i = 0; i < patches.size(); ++i) {
        ++starts[key(i) + 1];
        any_special_ = any_special_ || patches[i]->special();
    }
    for (std::size_t k = 1; k < starts.size(); ++k) starts[k] += starts[k - 1];
    for (std::size_t i = 0; i < patches.size(); ++i) order_[std::size_t(starts[key(i)]++)] = int(i);
}

// f(colour, first, patches) for each batch: eight of the order, or sixteen if the second eight begins with as
// many points, so that no lane goes along with longer ones for the sake of company.
template <typename F>
void PatchSet::for_each_batch(std::span<Patch* const> patches, std::span<const int> starts, F&& f) const
{
    const auto points = [&](int i) { return patches[std::size_t(order_[std::size_t(i)])]->count; };
    int from = 0;
    for (int c = 0; c < colours_; ++c) {
        const int to = starts[std::size_t(c * kPatchPoints + kPatchPoints - 1)];
        while (from < to) {
            const int left = to - from;
            const bool all = left > kFloatLanes && points(from) == points(from + kFloatLanes);
            const int taken = std::min(left, all ? kBroadLanes : kFloatLanes);
            f(c, from, taken);
            from += taken;
        }
    }
}

int PatchSet::count_batches(std::span<Patch* const> patches, std::span<const int> starts) const
{
    int count = 0;
    for_each_batch(patches, starts, [&](int, int, int) { ++count; });
    return count;
}

// The number of points.
int PatchSet::cut(std::span<Patch* const> patches, std::span<const int> starts)
{
    first_of_colour_[0] = 0;  // and each colour has patches
    int batches = 0, points = 0;
    for_each_batch(patches, starts, [&](int colour, int from, int taken) {
        int* lanes = &chosen_[std::size_t(batches * kBroadLanes)];
        std::copy_n(&order_[std::size_t(from)], taken, lanes);
        std::fill(lanes + taken, lanes + kBroadLanes, -1);
        PatchBatch& batch = batches_[std::size_t(batches++)];
        batch.first = points;
        batch.count = patches[std::size_t(lanes[0])]->count;
        batch.lanes = taken > kFloatLanes ? kBroadLanes : kFloatLanes;
        points += batch.count;
        first_of_colour_[std::size_t(colour) + 1] = batches;
    });
    return points;
}

// False: out of memory.
bool PatchSet::place_extras(std::span<Patch* const> patches, Arena& arena)
{
    const auto wants = [&](std::size_t b) {
        const auto lanes = chosen_.subspan(b * kBroadLanes, kBroadLanes);
        return std::any_of(lanes.begin(), lanes.end(),
                           [&](int i) { return i >= 0 && patches[std::size_t(i)]->special(); });
    };
    for (std::size_t b = 0; b < batches_.size(); ++b) {
        batches_[b].extra = nullptr;
        batches_[b].friction = whole_ ? &frictions_[b] : nullptr;
    }
    if (!any_special_) return true;
    int count = 0;
    for (std::size_t b = 0; b < batches_.size(); ++b) count += wants(b) ? 1 : 0;
    const auto extras = arena.take_zeroed<PatchExtra>(count);
    if (arena.failed()) return false;
    std::size_t next = 0;
    for (std::size_t b = 0; b < batches_.size(); ++b)
        if (wants(b)) batches_[b].extra = &extras[next++];
    return true;
}

void PatchSet::fill(const RowSystem& system, const Substep& step)
{
    const auto each_body = [&](auto&& f) { tasks_.each_of(int(kicks_.size()), kBodyRange, f); };
    each_body([&](std::size_t i) {
        const SolverBody& b = system.bodies[i];
        motions_[i] = {
            {float(b.v.x), float(b.v.y), float(b.v.z), 0, float(b.w.x), float(b.w.y), float(b.w.z), 0}, {}};
    });
    const PatchSprings springs = springs_of(step);
    tasks_.each_of(int(batches_.size()), kBatchRange,
                   [&](std::size_t b) { fill_batch(system, step, springs, b); });
    // What the first small step begins with.
    each_body([&](std::size_t i) { motions_[i] = {}; });
    motions_.back() = {};
    perform({Visit::kPush}, 1, {});
    each_body([&](std::size_t i) {
        for (int k = 0; k < kTwistNumbers; ++k) numbers(kicks_[i])[k] = motions_[i].speed[k];
    });
}

// The bodies of this batch, and the patches of the next: neighbours in a batch are none in memory.
void PatchSet::fetch_lanes(const RowSystem& system, std::size_t b) const
{
    for (int lane = 0; lane < kBroadLanes; ++lane) {
        const std::size_t at = b * kBroadLanes + std::size_t(lane), next = at + kBroadLanes;
        if (const int i = chosen_[at]; i >= 0) {
            const Patch& p = *system.patches[std::size_t(i)];
            fetch<3>(system.bodies.data() + p.body1);
            if (p.body2 >= 0) fetch<3>(system.bodies.data() + p.body2);
        }
        if (b + 1 < batches_.size() && chosen_[next] >= 0)
            fetch<4>(system.patches[std::size_t(chosen_[next])]);
    }
}

void PatchSet::fill_batch(const RowSystem& system, const Substep& step, const PatchSprings& springs,
                          std::size_t b)
{
    fetch_lanes(system, b);
    PatchBatch& batch = batches_[b];
    PatchLanes passing[kPatchPoints];  // on their way into the friction of the whole
    PatchLanes* points = whole_ ? passing : &points_[std::size_t(batch.first)];
    PatchSources from;
    for (int lane = 0; lane < batch.lanes; ++lane) choose_lane(system, b, lane, from);
    kernels_->gather(batch, points, from, springs);
    if (batch.extra)
        for (int lane = 0; lane < batch.lanes; ++lane) fill_extra(*from.patches[lane], *batch.extra, lane);
    kernels_->prepare(batch, points, motions_.data(), float(1) / float(step.n));
}

void PatchSet::choose_lane(const RowSystem& system, std::size_t b, int lane, PatchSources& from)
{
    static const Patch none{};
    static const SolverBody world{};
    PatchBatch& batch = batches_[b];
    const int patch = chosen_[b * kBroadLanes + std::size_t(lane)];
    const Patch& p = patch >= 0 ? *system.patches[std::size_t(patch)] : none;
    const auto choose = [&](int index, int& slot) {
        const bool moves = patch >= 0 && dynamic(system.bodies, index);
        const int at = patch >= 0 && index >= 0 ? index : int(system.bodies.size());
        slot = moves ? at : ~at;
        return moves ? &system.bodies[std::size_t(index)] : &world;
    };
    from.patches[lane] = &p;
    from.body1[lane] = choose(p.body1, batch.body1[lane]);
    from.body2[lane] = choose(p.body2, batch.body2[lane]);
    batch.share[lane] = p.count ? 1 / float(p.count) : 0;
}

void PatchSet::fill_extra(const Patch& p, PatchExtra& extra, int lane) const
{
    extra.rolling[lane] = p.rolling;
    if (p.rolling > 0) set(extra.roll, lane, p.roll);
    if (!(p.softness > 0)) return;
    const Real rate = 1 / (hs_ + Real(p.damping_time));
    extra.rate[lane] = float(rate), extra.soft[lane] = float(rate * Real(p.softness) / hs_);
}

PatchBodies PatchSet::view(std::span<Velocity> bodies)
{
    return {bodies.data(), kicks_.data(), nullptr, nullptr, motions_.data(), float(hs_)};
}

void PatchSet::visit(Visit what, const PatchBodies& bodies, int first, int last) const
{
    const PatchBatch* batches = batches_.data();
    PatchLanes* points = points_.data();
    FloatMotion* motions = motions_.data();
    switch (what) {
        case Visit::kLoad:
            return kernels_->load_speeds(bodies, first, last);
        case Visit::kAccelerate:
            return kernels_->accelerate(bodies, first, last);
        case Visit::kMove:
            return kernels_->move(bodies, first, last);
        case Visit::kTake:
            return kernels_->take_changes(bodies, first, last);
        case Visit::kPush:
            return kernels_->apply_impulses(batches, first, last, points, motions);
        case Visit::kCorrect:
            return kernels_->correct(batches, first, last, points, motions, sweep_);
        case Visit::kRelax:
            return kernels_->relax(batches, first, last, points, motions);
        case Visit::kRebound:
            return kernels_->rebound(batches, first, last, points, motions);
    }
}

// A few pieces for each worker, and as many for each: who is late should leave something to the others.
PatchSet::Stage PatchSet::stage(Visit visit, int first, int last) const
{
    const int count = last - first, workers = tasks_.workers();
    const int least = is_of_bodies(visit) ? kBodyPiece : kBatchPiece;
    const int turns = std::min(4, count / (least * workers));
    return {visit, first, last, turns > 0 ? turns * workers : std::min(workers, (count + 1) / 2)};
}

int PatchSet::list_stages(std::initializer_list<Visit> round)
{
    std::size_t count = 0;
    for (const Visit v : round) {
        if (is_of_bodies(v)) stages_[count++] = stage(v, 0, int(kicks_.size()));
        for (std::size_t c = 0; !is_of_bodies(v) && c < std::size_t(colours_); ++c)
            stages_[count++] = stage(v, first_of_colour_[c], first_of_colour_[c + 1]);
    }
    return int(count);
}

// One alone has no need of colours: batches lie in their order. Nor of stages: those that nobody
// shares cost a short step 3 % more.
void PatchSet::perform(std::initializer_list<Visit> round, int times, const PatchBodies& bodies)
{
    if (tasks_.alone()) {
        for (int i = 0; i < times; ++i)
            for (const Visit v : round)
                visit(v, bodies, 0, is_of_bodies(v) ? int(kicks_.size()) : int(batches_.size()));
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

void PatchSet::correct(std::span<Velocity> bodies)
{
    if (!empty()) perform({Visit::kLoad, Visit::kCorrect, Visit::kTake}, 1, view(bodies));
}

void PatchSet::relax(std::span<Velocity> bodies)
{
    if (!empty()) perform({Visit::kLoad, Visit::kRelax, Visit::kTake}, 1, view(bodies));
}

void PatchSet::small_steps(int n, std::span<Velocity> bodies, std::span<const Velocity> gain,
                           std::span<Velocity> mean)
{
    if (empty()) {
        for (int i = 0; i < n; ++i) add(bodies, gain), add(mean, bodies.first(mean.size()));
        return;
    }
    PatchBodies of = view(bodies);
    of.gain = gain.data(), of.mean = mean.data();
    perform({Visit::kAccelerate, Visit::kCorrect, Visit::kMove, Visit::kRelax, Visit::kTake}, n, of);
}

void PatchSet::rebound(std::span<Velocity> bodies)
{
    bool any = false;
    for (const PatchBatch& batch : batches_)
        for (int lane = 0; lane < batch.lanes; ++lane) any = any || batch.bounce[lane] > 0;
    if (any) perform({Visit::kLoad, Visit::kRebound, Visit::kTake}, 1, view(bodies));
}

void PatchSet::apply_impulses(std::span<Velocity> bodies) const { add(bodies, kicks_); }

void PatchSet::follow_motion(std::span<const Velocity> bodies)
{
    const float hs = float(hs_);
    for (std::size_t i = 0; i < kicks_.size(); ++i) {
        float* to = motions_[i].way;
        for (int k = 0; k < kTwistNumbers; ++k) to[k] += hs * float(numbers(bodies[i])[k]);
    }
}

void PatchSet::store_impulses(std::span<Patch* const> patches) const
{
    tasks_.each_of(int(batches_.size()), kBatchRange, [&](std::size_t b) {
        BroadLanes along1[kPatchPoints], along2[kPatchPoints];
        const PatchBatch& batch = batches_[b];
        if (batch.friction) kernels_->share_friction(batch, along1, along2);
        for (int lane = 0; lane < batch.lanes; ++lane) {
            const int index = chosen_[b * kBroadLanes + std::size_t(lane)];
            if (index < 0) continue;
            Patch& patch = *patches[std::size_t(index)];
            if (batch.extra) store_couple(*batch.extra, lane, patch);
            for (int i = 0; i < patch.count; ++i) {
                const std::size_t at = std::size_t(batch.first + i);
                if (batch.friction)
                    store_point(batch, lane, batch.friction->points[i].sum, along1[i], along2[i],
                                patch.points[i]);
                else
                    store_point(batch, lane, points_[at].sum[0], points_[at].sum[1], points_[at].sum[2],
                                patch.points[i]);
            }
        }
    });
}

}  // namespace epode
