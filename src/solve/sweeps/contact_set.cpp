// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Packing decides what each lane holds; the kernels load it and compute for all lanes at once what follows
// from it (effective masses, couplings).
#include "solve/sweeps/contact_set.h"

#include <algorithm>
#include <limits>
#include <type_traits>
#include <utility>

namespace epode {
namespace {

constexpr int kWindow = 6;          // manifolds looked at for each lane
constexpr int kFullShuffle = 1536;  // batches, about 6 MB
constexpr int kRun = 32;

// Fills unused lanes.
constexpr SolverBody kAtRest{};
constexpr JointManifold kNoManifold{{}, {}, {}, {}, {}, {}, {}, {}, -1, -1, 0, 0, false, false};
constexpr JointManifoldPoint kNoPoint{};

// Converts to float within its range: a finite limit stays finite.
template <typename N>
N narrowed(Real x)
{
    constexpr Real limit = Real(std::numeric_limits<float>::max());
    return std::is_same_v<N, Real> || x <= limit || x == kInf ? N(x) : N(limit);
}

// Lanes without a point have the directions of their manifold, but no effect.
template <typename L>
void silence_unused(const ContactSourceOf<L>& source, BatchPointOf<L>& point)
{
    for (int lane = 0; lane < L::kCount; ++lane)
        if (source.point[lane] < 0)
            for (L& effective_mass : point.effective_mass) effective_mass[lane] = 0;
}

BatchForm form_of(const RowSystem& system, const JointManifold& m)
{
    if (m.c[0] != 0 || m.c[1] != 0 || m.fixed[0] != 0 || m.fixed[1] != 0 || m.mu[0] != m.mu[1] ||
        m.C[0] != m.C[1])
        return BatchForm::kAny;
    for (const int body : {m.body1, m.body2})
        if (body >= 0 && !isotropic(system.bodies[std::size_t(body)].inv_inertia)) return BatchForm::kPlain;
    return BatchForm::kEven;
}

// Fills one batch after the other. A body that moves may be in a batch once: its stamp is the last batch that
// contains it.
class Chooser {
  public:
    Chooser(const RowSystem& system, std::span<const JointManifold> manifolds, std::span<int> stamps,
            std::span<bool> used, int lanes)
        : system_(system),
          manifolds_(manifolds),
          stamps_(stamps),
          used_(used),
          lanes_(lanes),
          manifold_friction_(system.manifold_friction)
    {
        std::fill(stamps.begin(), stamps.end(), -1);
    }

    // Chooses the lanes of the batch that manifold `first` begins; the rest is -1.
    void fill(int batch, int first, int* lanes)
    {
        int taken = 0;
        take(batch, first, lanes[taken++]);
        first_ = first;
        const int count = manifolds_[std::size_t(first)].count;
        const int end = std::min(int(manifolds_.size()), first + kWindow * lanes_);
        // First manifolds of the same length, then any.
        for (const bool any : {false, true})
            for (int j = first + 1; j < end && taken < lanes_; ++j)
                if (!used_[std::size_t(j)] && (any || manifolds_[std::size_t(j)].count == count) &&
                    free(batch, j))
                    take(batch, j, lanes[taken++]);
        std::fill(lanes + taken, lanes + lanes_, -1);
    }

    bool used(int manifold) const { return used_[std::size_t(manifold)]; }

  private:
    bool free(int batch, int j) const
    {
        const JointManifold &m = manifolds_[std::size_t(j)], &first = manifolds_[std::size_t(first_)];
        if (m.cone != first.cone) return false;
        if (manifold_friction_ && allows_manifold_friction(m) != allows_manifold_friction(first))
            return false;
        return stamps_[std::size_t(m.body1)] != batch &&
               (m.body2 < 0 || stamps_[std::size_t(m.body2)] != batch);
    }

    void take(int batch, int j, int& lane)
    {
        const JointManifold& m = manifolds_[std::size_t(j)];
        for (const int body : {m.body1, m.body2})
            if (body >= 0 && system_.bodies[std::size_t(body)].inv_mass > 0)
                stamps_[std::size_t(body)] = batch;
        used_[std::size_t(j)] = true;
        lane = j;
    }

    const RowSystem& system_;
    std::span<const JointManifold> manifolds_;
    std::span<int> stamps_;
    std::span<bool> used_;
    int lanes_;
    bool manifold_friction_;  // manifolds that allow manifold friction stay by themselves
    int first_ = 0;           // of the batch
};

}  // namespace

template <typename L>
bool ContactSetOf<L>::pack(const RowSystem& system, const JointManifoldList& list, Real w, Arena& arena)
{
    manifold_friction_ = system.manifold_friction, manifolds_ = int(list.manifolds.size());
    if (list.manifolds.empty()) return true;
    if (!choose(system, list.manifolds, arena)) return false;
    const int count = chosen_.back().first + chosen_.back().count;
    batches_ = arena.take<Batch>(int(chosen_.size()));
    points_ = arena.take<Point>(count);
    sources_ = arena.take<Source>(count);
    order_ = arena.take<int>(int(batches_.size()));
    if (arena.failed() || !place_frictions(list.manifolds, arena)) return false;
    for (std::size_t i = 0; i < order_.size(); ++i) order_[i] = int(i);
    for (std::size_t b = 0; b < batches_.size(); ++b) {
        Batch& batch = batches_[b];
        fill_batch(system, list, chosen_[b], batch);
        if (batch.friction) fill_friction(list, b);
        kernels_->prepare(batch, &points_[std::size_t(batch.first)], Number(w));
        for (int i = batch.first; i < batch.first + batch.count; ++i)
            silence_unused(sources_[std::size_t(i)], points_[std::size_t(i)]);
    }
    return true;
}

template <typename L>
bool ContactSetOf<L>::choose(const RowSystem& system, std::span<const JointManifold> manifolds, Arena& arena)
{
    const int n = int(manifolds.size());
    chosen_ = arena.take<Choice>(n);
    auto stamps = arena.take<int>(int(system.bodies.size()));
    auto used = arena.take_zeroed<bool>(n);
    if (arena.failed()) return false;
    Chooser chooser(system, manifolds, stamps, used, kCount);
    int count = 0, points = 0;
    for (int i = 0; i < n; ++i) {
        if (chooser.used(i)) continue;
        Choice& choice = chosen_[std::size_t(count)];
        chooser.fill(count, i, choice.manifold);
        choice.first = points, choice.count = 0;
        for (int lane = 0; lane < kCount && choice.manifold[lane] >= 0; ++lane)
            choice.count = std::max(choice.count, manifolds[std::size_t(choice.manifold[lane])].count);
        points += choice.count;
        ++count;
    }
    chosen_ = chosen_.first(std::size_t(count));
    return true;
}

template <typename L>
void ContactSetOf<L>::fill_batch(const RowSystem& system, const JointManifoldList& list, const Choice& choice,
                                 Batch& batch)
{
    batch.first = choice.first, batch.count = choice.count;
    batch.form = BatchForm::kEven;
    batch.cone = list.manifolds[std::size_t(choice.manifold[0])].cone;
    ContactSourcesOf<L> from;
    for (int lane = 0; lane < kCount; ++lane) {
        const int manifold = choice.manifold[lane];
        choose_lane(system, list, manifold, batch, lane, from);
        if (manifold >= 0)
            batch.form = std::min(batch.form, form_of(system, list.manifolds[std::size_t(manifold)]));
    }
    kernels_->gather(batch, &points_[std::size_t(batch.first)], from);
}

template <typename L>
void ContactSetOf<L>::choose_lane(const RowSystem& system, const JointManifoldList& list, int index,
                                  Batch& batch, int lane, ContactSourcesOf<L>& from)
{
    const JointManifold& manifold = index >= 0 ? list.manifolds[std::size_t(index)] : kNoManifold;
    const auto choose = [&](int body, std::uint32_t& at) {
        at = std::uint32_t(std::size_t(second_slot(system, body)) * sizeof(Bodies));
        return body >= 0 ? &system.bodies[std::size_t(body)] : &kAtRest;
    };
    from.manifold[lane] = &manifold;
    from.body1[lane] = choose(manifold.body1, batch.at1[lane]);
    from.body2[lane] = choose(manifold.body2, batch.at2[lane]);
    for (int k = 0; k < 2; ++k) {
        batch.mu[k][lane] = narrowed<Number>(manifold.mu[k]);
        batch.fixed[k][lane] = narrowed<Number>(manifold.fixed[k]);
    }
    for (int i = 0; i < batch.count; ++i) {
        const int point = i < manifold.count ? manifold.first + i : -1;
        sources_[std::size_t(batch.first + i)].point[lane] = point;
        from.point[i][lane] = point >= 0 ? &list.points[std::size_t(point)] : &kNoPoint;
    }
}

template <typename L>
bool ContactSetOf<L>::place_frictions(std::span<const JointManifold> manifolds, Arena& arena)
{
    const auto wants = [&](std::size_t b) {
        return manifold_friction_ && allows_manifold_friction(manifolds[std::size_t(chosen_[b].manifold[0])]);
    };
    int count = 0;
    for (std::size_t b = 0; b < batches_.size(); ++b) count += wants(b);
    const auto frictions = arena.take_zeroed<ManifoldFrictionLanesOf<L>>(count);
    if (arena.failed()) return false;
    std::size_t next = 0;
    for (std::size_t b = 0; b < batches_.size(); ++b)
        batches_[b].friction = wants(b) ? &frictions[next++] : nullptr;
    return true;
}

// The anchors of a batch and the positions of its points, in Reals before they become lanes.
template <typename L>
void ContactSetOf<L>::fill_friction(const JointManifoldList& list, std::size_t b)
{
    ManifoldFrictionLanesOf<L>& to = *batches_[b].friction;
    for (int lane = 0; lane < kCount && chosen_[b].manifold[lane] >= 0; ++lane) {
        const JointManifold& m = list.manifolds[std::size_t(chosen_[b].manifold[lane])];
        const auto points = list.points.subspan(std::size_t(m.first), std::size_t(m.count));
        const Real share = 1 / Real(m.count);
        Vec3 anchor;
        Real size = 0;
        for (const JointManifoldPoint& point : points) anchor += share * point.r1;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Vec3 d = points[i].r1 - anchor;
            const Real x = dot(d, m.t1), y = dot(d, m.t2);
            to.x[i][lane] = Number(x), to.y[i][lane] = Number(y);
            size += std::sqrt(x * x + y * y);
        }
        to.r1.set(lane, anchor);
        to.min_radius[lane] = Number(kMinRadius * size);
        to.C[lane] = Number(share * m.C[0]);
    }
}

template <typename L>
ManifoldFriction ContactSetOf<L>::friction_of(const Batch& batch, int lane) const
{
    const ManifoldFrictionLanesOf<L>& all = *batch.friction;
    const auto vector = [&](const LaneVec3Of<L>& a) {
        return Vec3{Real(a.x[lane]), Real(a.y[lane]), Real(a.z[lane])};
    };
    const Vec3 n = vector(batch.n), t1 = vector(batch.t1), t2 = vector(batch.t2);
    const auto normal = [&](int i) { return Real(points_[std::size_t(batch.first + i)].p[0][lane]); };
    Real sum = 0, x = 0, y = 0, radius = 0;
    for (int i = 0; i < batch.count; ++i) sum += normal(i);
    for (int i = 0; i < batch.count && sum > 0; ++i)
        x += normal(i) / sum * Real(all.x[i][lane]), y += normal(i) / sum * Real(all.y[i][lane]);
    for (int i = 0; i < batch.count && sum > 0; ++i)
        radius += normal(i) / sum * length(Vec3{Real(all.x[i][lane]) - x, Real(all.y[i][lane]) - y, 0});
    const Vec3 r1 = vector(all.r1) + x * t1 + y * t2, r2 = r1 + vector(batch.offset);
    const Real p1 = Real(all.p[0][lane]), p2 = Real(all.p[1][lane]);
    const Real couple = Real(all.p[2][lane]) - (x * p2 - y * p1);
    return {{{t1, cross(r1, t1), -t1, -cross(r2, t1)},
             {t2, cross(r1, t2), -t2, -cross(r2, t2)},
             {{}, radius * n, {}, -radius * n}},
            {p1, p2, radius > Real(all.min_radius[lane]) ? couple / radius : 0},
            {Real(batch.c[0][lane]), Real(batch.c[1][lane]), 0},
            Real(all.C[lane]),
            Real(batch.mu[0][lane]) * sum,
            batch.body1(lane),
            batch.body2(lane)};
}

template <typename L>
std::span<ManifoldFriction> ContactSetOf<L>::manifold_frictions(Arena& arena) const
{
    if (!manifold_friction_) return {};
    auto all = arena.take<ManifoldFriction>(manifolds_);
    if (all.empty()) return {};
    for (ManifoldFriction& f : all) f.body1 = -1;
    for (std::size_t b = 0; b < batches_.size(); ++b)
        for (int lane = 0; batches_[b].friction && lane < kCount; ++lane)
            if (const int at = chosen_[b].manifold[lane]; at >= 0)
                all[std::size_t(at)] = friction_of(batches_[b], lane);
    const auto end =
        std::remove_if(all.begin(), all.end(), [](const ManifoldFriction& f) { return f.body1 < 0; });
    return {all.begin(), end};
}

template <typename L>
void ContactSetOf<L>::apply_impulses(std::span<Bodies> bodies) const
{
    kernels_->apply_impulses(batches_.data(), int(batches_.size()), points_.data(), bodies.data());
}

template <>
void ContactSetOf<Lanes>::normal_velocities(const ContactBatch& batch, std::span<const Velocity> bodies,
                                            std::span<Lanes, kManifoldPoints> out) const
{
    machine_->normal_velocities(batch, &points_[std::size_t(batch.first)], bodies.data(), out.data());
}

// Islands that exceed the caches keep neighbours together: runs are shuffled, then the batches within each
// run.
template <typename L>
void ContactSetOf<L>::shuffle(CounterRandom& random)
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

template <typename L>
void ContactSetOf<L>::sweep(std::span<Bodies> bodies)
{
    kernels_->sweep(batches_.data(), order_.data(), int(order_.size()), points_.data(), bodies.data());
}

template <typename L>
void ContactSetOf<L>::relax_by(Real factor)
{
    for (Point& point : points_)
        for (L* x : {&point.effective_mass[0], &point.effective_mass[1], &point.effective_mass[2],
                     &point.k_n1, &point.k_n2, &point.k_12})
            for (Number& value : x->at) value *= Number(factor);
    for (const Batch& batch : batches_)
        for (int lane = 0; batch.friction && lane < kCount; ++lane) batch.friction->w[lane] *= Number(factor);
}

template <typename L>
void ContactSetOf<L>::store_impulses(std::span<JointManifoldPoint> points) const
{
    for (const Batch& batch : batches_)
        if (batch.friction) kernels_->share_friction(batch, &points_[std::size_t(batch.first)]);
    for (std::size_t i = 0; i < sources_.size(); ++i)
        for (int lane = 0; lane < kCount; ++lane)
            if (const int point = sources_[i].point[lane]; point >= 0)
                for (int k = 0; k < 3; ++k) points[std::size_t(point)].p[k] = Real(points_[i].p[k][lane]);
}

template class ContactSetOf<Lanes>;
template class ContactSetOf<BroadLanes>;

}  // namespace epode
