// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Contact reduction: collects the contacts with a surface of many facets one by one and then reduces them.
// Their number is bounded and nothing is allocated. Contacts with similar normals form a manifold. Each
// manifold keeps at most four points, chosen as for any manifold (contact_sink.h), and the manifolds share
// the client's capacity, the deepest first. All ties are broken by the order of arrival.
#pragma once

#include "collide/contact_sink.h"

namespace epode {

class ContactCollector {
  public:
    // Positions closer than `same` with equal normals are one contact; the sink decides its sides.
    ContactCollector(Real same, const ContactSink& sink) : same2_(same * same), sink_(sink) {}

    void add(const ContactPoint& point);
    void add(Vec3 position, Vec3 normal, Real depth, int side2 = -1)
    {
        add({position, normal, depth, -1, side2});
    }
    void add_at_border(Vec3 position, Vec3 normal, Real depth, int side2 = -1)
    {
        add({position, normal, depth, sink_.to_program() ? -1 : kAtBorder, side2});
    }
    // Never merges the contact with another.
    void add_apart(const ContactPoint& point);
    bool empty() const { return count_ == 0; }
    void deliver(ContactSink& sink);

  private:
    static constexpr int kCapacity = 64;
    static constexpr int kPerManifold = 4;

    int at_same_place(int first, int end, Vec3 p) const;
    void merge(ContactPoint& into, const ContactPoint& point) const;
    void note(int i);
    void sort_out();  // by manifold, the deepest manifold first; fills order_ and starts_
    void sort_by_depth();
    void find_manifolds();
    int thinned(int manifold, int quota, int* out) const;  // numbers of points
    void thin_out();

    union {
        ContactPoint points_[kCapacity];  // in a union: left unwritten until added
    };
    union {
        Real places_[3][kCapacity];  // of the points, x y z; the same
    };
    int count_ = 0;
    // A facet gives points with one normal one after the other: a run. Manifolds are made of runs.
    union {
        unsigned char run_[kCapacity];  // of each point
    };
    union {
        unsigned char run_starts_[kCapacity];
    };
    int runs_ = 0;
    union {
        unsigned char order_[kCapacity];
    };
    int starts_[kCapacity + 1];
    int manifolds_ = 0;
    Real same2_;
    const ContactSink& sink_;
};

}  // namespace epode
