// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See contact_collector.h. When the collector is full, every manifold is reduced to four points at once. If
// that is not enough, as on a surface of needles, the shallowest manifolds are dropped.
#include "collide/pairs/contact_collector.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "geometry/best_four.h"
#include "simd/quad.h"

namespace epode {

namespace {

constexpr Real kSameNormal = Real(1) - (kSingle ? Real(1e-6) : Real(1e-9));
constexpr Real kLikeNormal = Real(0.998);  // cosine of 3.6 degrees

ContactPoint touching(ContactPoint p)
{
    if (!(p.depth > 0)) p.depth = 0;
    return p;
}

}  // namespace

void ContactCollector::add(const ContactPoint& point)
{
    for (int run = 0; run < runs_; ++run) {
        const int first = run_starts_[run], end = run + 1 < runs_ ? run_starts_[run + 1] : count_;
        if (dot(points_[first].normal, point.normal) < kSameNormal) continue;
        if (const int at = at_same_place(first, end, point.position); at >= 0)
            return merge(points_[at], point);
    }
    add_apart(point);
}

// The first from number `first` on, or -1.
inline int ContactCollector::at_same_place(int first, int end, Vec3 p) const
{
    const Quad px = quad(p.x), py = quad(p.y), pz = quad(p.z), same2 = quad(same2_);
    for (int four = first & ~3; four < end; four += 4) {
        const Quad x = load_quad(places_[0] + four) - px, y = load_quad(places_[1] + four) - py,
                   z = load_quad(places_[2] + four) - pz;
        unsigned some = bits(x * x + y * y + z * z <= same2);
        if (four < first) some &= ~0u << (first - four);
        if (!some) continue;
        const int at = four + std::countr_zero(some);
        return at < end ? at : -1;
    }
    return -1;
}

void ContactCollector::merge(ContactPoint& p, const ContactPoint& point) const
{
    const bool deeper = point.depth > p.depth;
    if (deeper) p.depth = point.depth;
    p.side1 = sink_.merged(0, p.side1, point.side1, deeper ? point.side1 : p.side1);
    p.side2 = sink_.merged(1, p.side2, point.side2, deeper ? point.side2 : p.side2);
}

void ContactCollector::add_apart(const ContactPoint& point)
{
    if (count_ == kCapacity) thin_out();
    points_[count_] = point;
    note(count_++);
}

// Places behind the last are far from everything.
void ContactCollector::note(int i)
{
    const ContactPoint& point = points_[i];
    if (i % 4 == 0)
        for (Real* const axis : places_) store_quad(axis + i, quad(kInf));
    places_[0][i] = point.position.x, places_[1][i] = point.position.y, places_[2][i] = point.position.z;
    if (runs_ == 0 || !(point.normal == points_[i - 1].normal)) run_starts_[runs_++] = (unsigned char)i;
    run_[i] = (unsigned char)(runs_ - 1);
}

// Insertion; stable.
void ContactCollector::sort_by_depth()
{
    Real depths[kCapacity];
    for (int k = 0; k < count_; ++k) {
        const Real depth = points_[k].depth;
        int at = k;
        for (; at > 0 && depths[at - 1] < depth; --at)
            depths[at] = depths[at - 1], order_[at] = order_[at - 1];
        depths[at] = depth, order_[at] = (unsigned char)k;
    }
}

void ContactCollector::sort_out()
{
    sort_by_depth();
    manifolds_ = runs_ > 0 ? 1 : 0;
    starts_[0] = 0, starts_[1] = count_;
    if (runs_ > 1) find_manifolds();
}

// The deepest point that is left starts a manifold; points with similar normals join it in order.
void ContactCollector::find_manifolds()
{
    constexpr unsigned char kNone = 255;
    unsigned char manifold_of[kCapacity], sorted[kCapacity];
    std::memset(manifold_of, kNone, sizeof(manifold_of));
    int counts[kCapacity];
    manifolds_ = 0;
    for (int k = 0; k < count_; ++k) {
        unsigned char& own = manifold_of[run_[order_[k]]];
        if (own == kNone) {
            const Vec3 normal = points_[order_[k]].normal;
            for (int run = 0; run < runs_; ++run)
                if (manifold_of[run] == kNone &&
                    !(dot(points_[run_starts_[run]].normal, normal) < kLikeNormal))
                    manifold_of[run] = (unsigned char)manifolds_;
            own = (unsigned char)manifolds_;
            counts[manifolds_++] = 0;
        }
        ++counts[own];
    }
    for (int m = 0; m < manifolds_; ++m) starts_[m + 1] = starts_[m] + counts[m], counts[m] = starts_[m];
    for (int k = 0; k < count_; ++k) sorted[counts[manifold_of[run_[order_[k]]]]++] = order_[k];
    std::memcpy(order_, sorted, sizeof(order_));
}

// The best of a manifold, at most four.
int ContactCollector::thinned(int manifold, int quota, int* out) const
{
    const int first = starts_[manifold], count = starts_[manifold + 1] - first;
    const int wanted = quota < kPerManifold ? quota : kPerManifold;
    const unsigned char* const those = order_ + first;
    if (count <= wanted) return std::copy_n(those, count, out), count;
    ManifoldPoints lanes;
    for (int k = 0; k < count; ++k) lanes.add(points_[those[k]].position, points_[those[k]].depth);
    const int kept = best_four(lanes, points_[those[0]].normal, wanted, out);
    for (int k = 0; k < kept; ++k) out[k] = those[out[k]];
    return kept;
}

void ContactCollector::thin_out()
{
    constexpr int kKept = kCapacity - kCapacity / 4;
    sort_out();
    ContactPoint kept[kKept];
    int those[kPerManifold], count = 0;
    for (int m = 0; m < manifolds_ && count + kPerManifold <= kKept; ++m) {
        const int n = thinned(m, kPerManifold, those);
        for (int k = 0; k < n; ++k) kept[count++] = touching(points_[those[k]]);
    }
    runs_ = 0;
    for (count_ = 0; count_ < count; ++count_) {
        points_[count_] = kept[count_];
        note(count_);
    }
}

void ContactCollector::deliver(ContactSink& sink)
{
    sort_out();
    for (int m = 0; m < manifolds_ && !sink.full(); ++m) {
        // Each manifold gets an equal share; later manifolds get what earlier ones did not use.
        const int left = sink.capacity() - sink.count(), waiting = manifolds_ - m;
        const int quota = left > waiting ? left / waiting : 1;
        int best[kPerManifold];
        const int n = thinned(m, quota, best);
        const bool all = n == starts_[m + 1] - starts_[m];
        for (int k = 0; k < n; ++k) sink.add(all ? points_[best[k]] : touching(points_[best[k]]));
    }
}

}  // namespace epode
