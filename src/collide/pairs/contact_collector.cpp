// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See contact_collector.h. When the collector is full, every manifold is reduced to four points at once. If
// that is not enough, as on a surface of needles, the shallowest manifolds are dropped.
#include "collide/pairs/contact_collector.h"

#include <bit>

#include "simd/quad.h"

namespace epode {

namespace {

constexpr Real kSameNormal = Real(1) - (kSingle ? Real(1e-6) : Real(1e-9));
constexpr Real kLikeNormal = Real(0.998);  // cosine of 3.6 degrees

}  // namespace

void ContactCollector::add(const ContactPoint& point)
{
    for (int first = 0; first < count_; first += 4)
        for (unsigned some = at_same_place(first, point.position); some; some &= some - 1) {
            ContactPoint& p = points_[first + std::countr_zero(some)];
            if (!(dot(p.normal, point.normal) < kSameNormal)) return merge(p, point);
        }
    add_apart(point);
}

// Of four points from `first` on, a bit for each.
unsigned ContactCollector::at_same_place(int first, Vec3 p) const
{
    const Quad x = load_quad(places_[0] + first) - quad(p.x), y = load_quad(places_[1] + first) - quad(p.y),
               z = load_quad(places_[2] + first) - quad(p.z);
    return bits(x * x + y * y + z * z <= quad(same2_));
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
    note_place(count_, point.position);
    points_[count_++] = point;
}

// Places behind the last are far from everything.
void ContactCollector::note_place(int i, Vec3 p)
{
    for (int axis = 0; axis < 3; ++axis) {
        if (i % 4 == 0) store_quad(places_[axis] + i, quad(kInf));
        places_[axis][i] = p[axis];
    }
}

void ContactCollector::sort_out()
{
    // Insertion by depth; stable.
    for (int k = 1; k < count_; ++k) {
        if (!(points_[k - 1].depth < points_[k].depth)) continue;
        const ContactPoint p = points_[k];
        int at = k;
        for (; at > 0 && points_[at - 1].depth < p.depth; --at) points_[at] = points_[at - 1];
        points_[at] = p;
    }
    // The deepest point that is left starts a manifold; points with similar normals join it in order.
    manifolds_ = 0;
    for (int first = 0; first < count_;) {
        starts_[manifolds_++] = first;
        const Vec3 normal = points_[first].normal;
        int end = first + 1;
        for (int k = end; k < count_; ++k) {
            if (dot(points_[k].normal, normal) < kLikeNormal) continue;
            if (k == end) {
                ++end;
                continue;
            }
            const ContactPoint p = points_[k];
            for (int at = k; at > end; --at) points_[at] = points_[at - 1];
            points_[end++] = p;
        }
        first = end;
    }
    starts_[manifolds_] = count_;
}

int ContactCollector::thinned(int manifold, int quota, ContactPoint* out) const
{
    dContactGeom kept[kPerManifold];
    ContactSink choice(kept, sizeof(dContactGeom), quota < kPerManifold ? quota : kPerManifold, false);
    const int first = starts_[manifold], count = starts_[manifold + 1] - first;
    choice.add_manifold({points_ + first, std::size_t(count)});
    for (int k = 0; k < choice.count(); ++k)
        out[k] = {load(kept[k].pos), load(kept[k].normal), kept[k].depth, kept[k].side1, kept[k].side2};
    return choice.count();
}

void ContactCollector::thin_out()
{
    sort_out();
    int kept = 0;
    for (int m = 0; m < manifolds_ && kept + kPerManifold <= kCapacity - kCapacity / 4; ++m) {
        ContactPoint best[kPerManifold];
        const int n = thinned(m, kPerManifold, best);
        for (int k = 0; k < n; ++k) points_[kept++] = best[k];  // never beyond what has been read
    }
    count_ = kept;
    for (int k = 0; k < count_; ++k) note_place(k, points_[k].position);
}

void ContactCollector::deliver(ContactSink& sink)
{
    sort_out();
    for (int m = 0; m < manifolds_ && !sink.full(); ++m) {
        // Each manifold gets an equal share; later manifolds get what earlier ones did not use.
        const int left = sink.capacity() - sink.count(), waiting = manifolds_ - m;
        const int quota = left > waiting ? left / waiting : 1;
        const int first = starts_[m], count = starts_[m + 1] - first;
        if (count <= quota && count <= kPerManifold) {
            for (int k = 0; k < count; ++k) sink.add(points_[first + k]);
            continue;
        }
        ContactPoint best[kPerManifold];
        const int n = thinned(m, quota, best);
        for (int k = 0; k < n; ++k) sink.add(best[k]);
    }
}

}  // namespace epode
