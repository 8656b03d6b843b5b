// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Blocks that are not a normal row with none or two tangents are left to others.
// Lanes are filled greedily from a short window of manifolds, in order, so that the packing is a function of
// the island alone and neighbours in memory stay neighbours.
#include "solve/contact_set.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace epode {
namespace {

constexpr int kManifoldPoints = 4;
constexpr int kWindow = 48;         // manifolds looked at for a free lane
constexpr int kFullShuffle = 1536;  // batches, about 3 MB
constexpr int kRun = 32;

bool has_contact_form(const RowSystem& system, const RowBlock& block)
{
    if (!block.contact || (block.count != 1 && block.count != 3)) return false;
    const auto first = std::size_t(block.first);
    const RowNumbers& normal = system.numbers[first];
    if (normal.parent >= 0 || normal.lo != 0 || normal.hi < kInf) return false;
    for (std::size_t k = first + 1; k < first + std::size_t(block.count); ++k) {
        const RowNumbers& n = system.numbers[k];
        if (n.lo != -n.hi || !(n.hi >= 0) || (n.parent >= 0 && n.parent != block.first)) return false;
    }
    return true;
}

Real coupling(const Row& i, const Row& j, const SolverBody& a, const SolverBody* b)
{
    Real s = a.inv_mass * dot(i.lin1, j.lin1) + dot(i.ang1, a.inv_inertia * j.ang1);
    if (b) s += b->inv_mass * dot(i.lin2, j.lin2) + dot(i.ang2, b->inv_inertia * j.ang2);
    return s;
}

void fill_row(const RowNumbers& n, Real mobility, Real w, ContactPoint& point, int k, int lane)
{
    const Real d = mobility + n.C;
    const Real gain = d > 0 ? w / d : 0;
    point.c[k][lane] = n.c;
    point.keep[k][lane] = 1 - gain * n.C;
    point.gain[k][lane] = gain;
    point.p[k][lane] = d > 0 ? n.p : 0;
}

void fill_point(const RowSystem& system, Real w, const RowBlock& block, ContactPoint& point, int lane)
{
    const Row* rows = &system.rows[std::size_t(block.first)];
    const RowNumbers* numbers = &system.numbers[std::size_t(block.first)];
    const SolverBody& a = system.bodies[std::size_t(block.body1)];
    const SolverBody* b = block.body2 >= 0 ? &system.bodies[std::size_t(block.body2)] : nullptr;
    point.r1.set(lane, block.arms.r1);
    point.r2.set(lane, block.arms.r2);
    point.n.set(lane, rows[0].lin1);
    fill_row(numbers[0], row_mobility(rows[0], a, b), w, point, 0, lane);
    point.p[0][lane] = std::max(point.p[0][lane], Real(0));
    if (block.count == 1) return;
    point.t1.set(lane, rows[1].lin1);
    point.t2.set(lane, rows[2].lin1);
    point.k_n1[lane] = coupling(rows[0], rows[1], a, b);
    point.k_n2[lane] = coupling(rows[0], rows[2], a, b);
    point.k_12[lane] = coupling(rows[1], rows[2], a, b);
    for (int k = 1; k < 3; ++k) {
        fill_row(numbers[k], row_mobility(rows[k], a, b), w, point, k, lane);
        const bool share = numbers[k].parent >= 0;
        point.mu[k - 1][lane] = share ? numbers[k].hi : 0;
        point.fixed[k - 1][lane] = share ? 0 : numbers[k].hi;
        const Real limit = share ? numbers[k].hi * point.p[0][lane] : numbers[k].hi;
        if (std::fabs(point.p[k][lane]) > limit) point.p[k][lane] = std::copysign(limit, point.p[k][lane]);
    }
}

// The velocities of the bodies of a batch: one register per component, one lane per manifold.
struct Gathered {
    LaneVec3 v1, w1, v2, w2;
};

LaneVec3 gather(std::span<const Velocity> bodies, const int* index, Vec3 Velocity::*part)
{
    LaneVec3 out;
    for (int lane = 0; lane < kLanes; ++lane) out.set(lane, bodies[std::size_t(index[lane])].*part);
    return out;
}

void scatter(const LaneVec3& a, std::span<Velocity> bodies, const int* index, Vec3 Velocity::*part)
{
    for (int lane = 0; lane < kLanes; ++lane) bodies[std::size_t(index[lane])].*part = a.get(lane);
}

Gathered gather(const ContactBatch& batch, std::span<const Velocity> bodies)
{
    return {gather(bodies, batch.body1, &Velocity::v), gather(bodies, batch.body1, &Velocity::w),
            gather(bodies, batch.body2, &Velocity::v), gather(bodies, batch.body2, &Velocity::w)};
}

void scatter(const ContactBatch& batch, const Gathered& g, std::span<Velocity> bodies)
{
    scatter(g.v1, bodies, batch.body1, &Velocity::v);
    scatter(g.w1, bodies, batch.body1, &Velocity::w);
    scatter(g.v2, bodies, batch.body2, &Velocity::v);
    scatter(g.w2, bodies, batch.body2, &Velocity::w);
}

Lanes friction(ContactPoint& point, int k, Lanes u, Lanes normal)
{
    const Lanes limit = point.mu[k - 1] * normal + point.fixed[k - 1];
    const Lanes wanted = point.keep[k] * point.p[k] + point.gain[k] * (point.c[k] - u);
    return at_least(-limit, at_most(limit, wanted));  // a limit of infinity times zero does not bind
}

// Solves one contact and returns the change of its impulse, a vector of the world.
LaneVec3 visit(ContactPoint& point, const LaneVec3& u)
{
    const Lanes q0 =
        at_least(Lanes{}, point.keep[0] * point.p[0] + point.gain[0] * (point.c[0] - dot(point.n, u)));
    const Lanes d0 = q0 - point.p[0];
    const Lanes q1 = friction(point, 1, dot(point.t1, u) + point.k_n1 * d0, q0);
    const Lanes d1 = q1 - point.p[1];
    const Lanes q2 = friction(point, 2, dot(point.t2, u) + point.k_n2 * d0 + point.k_12 * d1, q0);
    const Lanes d2 = q2 - point.p[2];
    point.p[0] = q0, point.p[1] = q1, point.p[2] = q2;
    return d0 * point.n + d1 * point.t1 + d2 * point.t2;
}

void sweep_batch(const ContactBatch& batch, ContactPoint* points, std::span<Velocity> bodies)
{
    Gathered g = gather(batch, bodies);
    LaneVec3 dv = g.v1 - g.v2;
    LaneVec3 sum{};
    const Lanes inv_mass = batch.inv_mass1 + batch.inv_mass2;
    for (int i = 0; i < batch.count; ++i) {
        ContactPoint& point = points[i];
        const LaneVec3 u = dv + cross(g.w1, point.r1) - cross(g.w2, point.r2);
        const LaneVec3 P = visit(point, u);
        dv = dv + inv_mass * P;
        sum = sum + P;
        g.w1 = g.w1 + batch.inv_inertia1 * cross(point.r1, P);
        g.w2 = g.w2 - batch.inv_inertia2 * cross(point.r2, P);
    }
    g.v1 = g.v1 + batch.inv_mass1 * sum;
    g.v2 = g.v2 - batch.inv_mass2 * sum;
    scatter(batch, g, bodies);
}

bool overlaps(std::span<const SolverBody> bodies, int a, int b)
{
    return a == b && std::size_t(a) < bodies.size() && bodies[std::size_t(a)].inv_mass > 0;
}

}  // namespace

Lanes normal_velocity(const ContactBatch& batch, const ContactPoint& point, std::span<const Velocity> bodies)
{
    const Gathered g = gather(batch, bodies);
    return dot(point.n, g.v1 - g.v2 + cross(g.w1, point.r1) - cross(g.w2, point.r2));
}

bool ContactSet::pack(const RowSystem& system, Real w, std::span<bool> packed, Arena& arena)
{
    std::fill(packed.begin(), packed.end(), false);
    int contacts = 0;
    for (const RowBlock& block : system.blocks) contacts += block.contact;
    if (contacts == 0) return true;
    manifolds_ = arena.take<Manifold>(contacts);
    if (arena.failed()) return false;
    find_manifolds(system, packed);
    batches_ = arena.take<ContactBatch>(manifold_count_);
    chosen_ = arena.take<int>(manifold_count_ * kLanes);
    auto used = arena.take_zeroed<bool>(manifold_count_);
    if (arena.failed()) return false;
    batch_manifolds(system, used);
    const int count = batches_.empty() ? 0 : batches_.back().first + batches_.back().count;
    points_ = arena.take_zeroed<ContactPoint>(count);
    sources_ = arena.take<ContactSource>(count);
    order_ = arena.take<int>(int(batches_.size()));
    if (arena.failed()) return false;
    for (std::size_t i = 0; i < order_.size(); ++i) order_[i] = int(i);
    fill(system, w);
    return true;
}

void ContactSet::find_manifolds(const RowSystem& system, std::span<bool> packed)
{
    manifold_count_ = 0;
    bool open = false;  // may the next block join the last manifold?
    for (std::size_t i = 0; i < system.blocks.size(); ++i) {
        const RowBlock& block = system.blocks[i];
        packed[i] = has_contact_form(system, block);
        if (!packed[i]) {
            open = false;
            continue;
        }
        const int body2 = second_slot(system, block);
        if (open) {
            Manifold& last = manifolds_[std::size_t(manifold_count_ - 1)];
            if (last.body1 == block.body1 && last.body2 == body2 && last.count < kManifoldPoints) {
                ++last.count;
                continue;
            }
        }
        manifolds_[std::size_t(manifold_count_++)] = {int(i), 1, block.body1, body2};
        open = true;
    }
}

void ContactSet::batch_manifolds(const RowSystem& system, std::span<bool> used)
{
    const auto fits = [&](const Manifold& m, const int* lanes, int taken) {
        for (int lane = 0; lane < taken; ++lane) {
            const Manifold& other = manifolds_[std::size_t(lanes[lane])];
            if (overlaps(system.bodies, m.body1, other.body1) ||
                overlaps(system.bodies, m.body1, other.body2) ||
                overlaps(system.bodies, m.body2, other.body1) ||
                overlaps(system.bodies, m.body2, other.body2))
                return false;
        }
        return true;
    };
    std::size_t batches = 0;
    int points = 0;
    for (int i = 0; i < manifold_count_; ++i) {
        if (used[std::size_t(i)]) continue;
        int* lanes = &chosen_[batches * kLanes];
        int taken = 0;
        const int count = manifolds_[std::size_t(i)].count;
        int largest = count;
        lanes[taken++] = i;
        // First those of the same length, then any.
        for (const bool any : {false, true})
            for (int j = i + 1; j < std::min(manifold_count_, i + kWindow) && taken < kLanes; ++j) {
                const Manifold& m = manifolds_[std::size_t(j)];
                if (used[std::size_t(j)] || (!any && m.count != count) || !fits(m, lanes, taken)) continue;
                used[std::size_t(j)] = true;
                largest = std::max(largest, m.count);
                lanes[taken++] = j;
            }
        std::fill(lanes + taken, lanes + kLanes, -1);
        batches_[batches].first = points;
        batches_[batches].count = largest;
        points += largest;
        ++batches;
    }
    batches_ = batches_.first(batches);
}

void ContactSet::fill(const RowSystem& system, Real w)
{
    for (ContactSource& source : sources_) std::fill(source.row, source.row + kLanes, -1);
    for (std::size_t b = 0; b < batches_.size(); ++b) {
        ContactBatch& batch = batches_[b];
        const ContactBatch range = batch;
        std::memset(static_cast<void*>(&batch), 0, sizeof batch);
        batch.first = range.first, batch.count = range.count;
        std::fill(batch.body1, batch.body1 + kLanes, int(system.bodies.size()));
        std::fill(batch.body2, batch.body2 + kLanes, int(system.bodies.size()));
        for (int lane = 0; lane < kLanes; ++lane) {
            const int m = chosen_[b * kLanes + std::size_t(lane)];
            if (m >= 0) fill_lane(system, w, manifolds_[std::size_t(m)], batch, lane);
        }
    }
}

void ContactSet::fill_lane(const RowSystem& system, Real w, const Manifold& manifold, ContactBatch& batch,
                           int lane)
{
    const auto set_body = [&](int body, int& index, Lanes& inv_mass, LaneSym3& inv_inertia) {
        index = body;
        if (std::size_t(body) >= system.bodies.size()) return;
        inv_mass[lane] = system.bodies[std::size_t(body)].inv_mass;
        inv_inertia.set(lane, system.bodies[std::size_t(body)].inv_inertia);
    };
    set_body(manifold.body1, batch.body1[lane], batch.inv_mass1, batch.inv_inertia1);
    set_body(manifold.body2, batch.body2[lane], batch.inv_mass2, batch.inv_inertia2);
    for (int i = 0; i < manifold.count; ++i) {
        const RowBlock& block = system.blocks[std::size_t(manifold.block + i)];
        const auto at = std::size_t(batch.first + i);
        sources_[at].row[lane] = block.first;
        sources_[at].friction[lane] = block.count == 3;
        fill_point(system, w, block, points_[at], lane);
    }
}

void ContactSet::apply_impulses(std::span<Velocity> bodies) const
{
    for (const ContactBatch& batch : batches_) {
        Gathered g = gather(batch, bodies);
        for (int i = 0; i < batch.count; ++i) {
            const ContactPoint& point = points_[std::size_t(batch.first + i)];
            const LaneVec3 P = point.p[0] * point.n + point.p[1] * point.t1 + point.p[2] * point.t2;
            g.v1 = g.v1 + batch.inv_mass1 * P;
            g.v2 = g.v2 - batch.inv_mass2 * P;
            g.w1 = g.w1 + batch.inv_inertia1 * cross(point.r1, P);
            g.w2 = g.w2 - batch.inv_inertia2 * cross(point.r2, P);
        }
        scatter(batch, g, bodies);
    }
}

// Islands that no longer fit the caches keep neighbours together: runs are shuffled, then what is in each
// run.
void ContactSet::shuffle(CounterRandom& random)
{
    const int n = int(order_.size());
    const int run = n > kFullShuffle ? kRun : n;
    int* order = order_.data();
    for (int i = 1; i < n / std::max(run, 1); ++i) {
        const int j = random.below(i + 1);
        if (j != i) std::swap_ranges(order + i * run, order + (i + 1) * run, order + j * run);
    }
    for (int first = 0; first < n; first += run)
        for (int i = 1; i < std::min(run, n - first); ++i)
            std::swap(order[first + i], order[first + random.below(i + 1)]);
}

void ContactSet::sweep(std::span<Velocity> bodies)
{
    const std::size_t n = order_.size();
    for (std::size_t i = 0; i < n; ++i) {
        if (i + 2 < n) prefetch(batches_[std::size_t(order_[i + 2])]);
        const ContactBatch& batch = batches_[std::size_t(order_[i])];
        sweep_batch(batch, &points_[std::size_t(batch.first)], bodies);
    }
}

// The order is random, but known: the lines are on their way while another batch is computed.
void ContactSet::prefetch(const ContactBatch& batch) const
{
    const char* from = reinterpret_cast<const char*>(&points_[std::size_t(batch.first)]);
    const std::size_t bytes = std::size_t(batch.count) * sizeof(ContactPoint);
    for (std::size_t at = 0; at < bytes; at += kCacheLine) __builtin_prefetch(from + at, 1);
}

void ContactSet::store_impulses(std::span<RowNumbers> numbers) const
{
    for (std::size_t i = 0; i < sources_.size(); ++i)
        for (int lane = 0; lane < kLanes; ++lane) {
            const int row = sources_[i].row[lane];
            if (row < 0) continue;
            for (int k = 0; k < (sources_[i].friction[lane] ? 3 : 1); ++k)
                numbers[std::size_t(row + k)].p = points_[i].p[k][lane];
        }
}

}  // namespace epode
