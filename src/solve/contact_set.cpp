// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Packing writes what the rows say, one contact at a time; what follows from it (mobilities, couplings) the
// kernels compute for all lanes at once.
#include "solve/contact_set.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace epode {
namespace {

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

void fill_row(const RowNumbers& n, BatchPoint& point, int k, int lane)
{
    point.c[k][lane] = n.c;
    point.keep[k][lane] = n.C;
    point.p[k][lane] = n.p;
}

void fill_point(const RowSystem& system, const RowBlock& block, BatchPoint& point, int lane)
{
    const Row* rows = &system.rows[std::size_t(block.first)];
    const RowNumbers* numbers = &system.numbers[std::size_t(block.first)];
    point.r1.set(lane, block.arms.r1);
    point.r2.set(lane, block.arms.r2);
    point.n.set(lane, rows[0].lin1);
    fill_row(numbers[0], point, 0, lane);
    if (block.count == 1) return;
    point.t1.set(lane, rows[1].lin1);
    point.t2.set(lane, rows[2].lin1);
    for (int k = 1; k < 3; ++k) {
        fill_row(numbers[k], point, k, lane);
        const bool share = numbers[k].parent >= 0;
        point.mu[k - 1][lane] = share ? numbers[k].hi : 0;
        point.fixed[k - 1][lane] = share ? 0 : numbers[k].hi;
    }
}

bool overlaps(std::span<const SolverBody> bodies, int a, int b)
{
    return a == b && std::size_t(a) < bodies.size() && bodies[std::size_t(a)].inv_mass > 0;
}

}  // namespace

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
    points_ = arena.take<BatchPoint>(count);
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

// Will every number of the batch's points be written?
bool ContactSet::is_full(const RowSystem& system, std::size_t b) const
{
    for (const int m : chosen_.subspan(b * kLanes, kLanes)) {
        if (m < 0 || manifolds_[std::size_t(m)].count < batches_[b].count) return false;
        const Manifold& manifold = manifolds_[std::size_t(m)];
        for (int i = 0; i < manifold.count; ++i)
            if (system.blocks[std::size_t(manifold.block + i)].count != 3) return false;
    }
    return true;
}

void ContactSet::fill(const RowSystem& system, Real w)
{
    const Manifold none{0, 0, int(system.bodies.size()), int(system.bodies.size())};
    for (std::size_t b = 0; b < batches_.size(); ++b) {
        ContactBatch& batch = batches_[b];
        if (!is_full(system, b))
            std::memset(static_cast<void*>(&points_[std::size_t(batch.first)]), 0,
                        std::size_t(batch.count) * sizeof(BatchPoint));
        for (int lane = 0; lane < kLanes; ++lane) {
            const int m = chosen_[b * kLanes + std::size_t(lane)];
            fill_lane(system, m >= 0 ? manifolds_[std::size_t(m)] : none, batch, lane);
        }
        kernels_->prepare(batch, &points_[std::size_t(batch.first)], w);
    }
}

void ContactSet::fill_lane(const RowSystem& system, const Manifold& manifold, ContactBatch& batch, int lane)
{
    const SolverBody world{};
    const auto set_body = [&](int index, int& slot, Lanes& inv_mass, LaneSym3& inv_inertia) {
        const bool is_world = std::size_t(index) >= system.bodies.size();
        const SolverBody& body = is_world ? world : system.bodies[std::size_t(index)];
        slot = index;
        inv_mass[lane] = body.inv_mass;
        inv_inertia.set(lane, body.inv_inertia);
    };
    set_body(manifold.body1, batch.body1[lane], batch.inv_mass1, batch.inv_inertia1);
    set_body(manifold.body2, batch.body2[lane], batch.inv_mass2, batch.inv_inertia2);
    for (int i = 0; i < batch.count; ++i) {
        const auto at = std::size_t(batch.first + i);
        if (i >= manifold.count) {
            sources_[at].row[lane] = -1;
            continue;
        }
        const RowBlock& block = system.blocks[std::size_t(manifold.block + i)];
        sources_[at].row[lane] = block.first;
        sources_[at].friction[lane] = block.count == 3;
        fill_point(system, block, points_[at], lane);
    }
}

void ContactSet::apply_impulses(std::span<Velocity> bodies) const
{
    kernels_->apply_impulses(batches_.data(), int(batches_.size()), points_.data(), bodies.data());
}

void ContactSet::normal_velocities(const ContactBatch& batch, std::span<const Velocity> bodies,
                                   std::span<Lanes, kManifoldPoints> out) const
{
    kernels_->normal_velocities(batch, &points_[std::size_t(batch.first)], bodies.data(), out.data());
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
    kernels_->sweep(batches_.data(), order_.data(), int(order_.size()), points_.data(), bodies.data());
}

void ContactSet::relax_by(Real factor)
{
    for (BatchPoint& point : points_)
        for (int lane = 0; lane < kLanes; ++lane) {
            for (int k = 0; k < 3; ++k) {
                point.gain[k][lane] *= factor;
                point.keep[k][lane] = 1 - factor * (1 - point.keep[k][lane]);
            }
            for (Lanes* coupling : {&point.k_n1, &point.k_n2, &point.k_12}) (*coupling)[lane] *= factor;
        }
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
