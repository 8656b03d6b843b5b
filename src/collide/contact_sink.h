// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Where pair functions put their contacts: the client's array of dContactGeom, with the client's stride and
// never beyond its capacity. A pair function is pure, (shape a, pose A, shape b, pose B, sink); the
// dispatcher names the geoms (collide/pairs/collide.cpp).
//   normal: unit, world, from b into a: moving a by depth * normal separates the two.
//   depth:  >= 0 along that normal; touching counts (but see margin).
#pragma once

#include <span>

#include "base/float_environment.h"
#include "math/vec.h"
#include "ode/collision.h"
#include "ode/contact.h"

namespace epode {

struct NearLeaves;  // bvh/near_leaves.h

// As side1 of a contact that the program does not read: at a border of a surface, which is not in the way where
// another surface continues (contacts/flush_floors.cpp).
inline constexpr int kAtBorder = -2;

struct ContactPoint {
    Vec3 position;
    Vec3 normal;
    Real depth = 0;
    int side1 = -1;
    int side2 = -1;
};

class ContactSink {
  public:
    ContactSink(dContactGeom* first, int stride, int capacity, bool unimportant)
        : first_(first), stride_(stride), capacity_(capacity), unimportant_(unimportant)
    {}

    int count() const { return count_; }
    int capacity() const { return capacity_; }
    bool full() const { return count_ >= capacity_; }
    bool unimportant() const { return unimportant_; }  // the caller takes any contacts that fit

    // The geoms of the pair: contacts name them, and functions of the program receive them.
    void name(dGeomID first, dGeomID second) { geoms_[0] = first, geoms_[1] = second; }
    dGeomID first_geom() const { return geoms_[0]; }
    dGeomID second_geom() const { return geoms_[1]; }

    // Functions of the program that number a contact of a mesh which has become one of two triangles'.
    void number_merged(dTriTriMergeCallback* first, dTriTriMergeCallback* second)
    {
        merge_[0] = first, merge_[1] = second;
    }
    // The number on a side, 0 or 1, when contacts with these become one; without a function that of the
    // deeper one.
    int merged(int side, int one, int other, int deeper) const
    {
        if (one == other || one < 0 || other < 0 || !merge_[side]) return deeper;
        const CallerFloatEnvironment program;
        return merge_[side](geoms_[side], one, other);
    }

    // What the caller keeps of a mesh from call to call, if it does; of the one mesh in the pair.
    void keep(NearLeaves* leaves) { kept_ = leaves; }
    NearLeaves* kept() const { return kept_; }

    // Of two polyhedra that touch, or one and a plane: corners apart by no more than this are contacts too,
    // their depth negative, where fewer than four touch. Other shapes ignore it.
    void reach(Real margin) { margin_ = margin; }
    Real margin() const { return margin_; }

    // Whether the program reads the contacts and expects those of ODE; else they are a manifold of ours.
    void report_to_program(bool yes) { to_program_ = yes; }
    bool to_program() const { return to_program_; }

    // False if the sink was full.
    bool add(const ContactPoint& point)
    {
        if (full()) return false;
        dContactGeom* out = at(count_++);
        store(out->pos, point.position);
        store(out->normal, point.normal);
        out->depth = point.depth > 0 || margin_ > 0 ? point.depth : Real(0);
        out->g1 = geoms_[0];
        out->g2 = geoms_[1];
        out->side1 = point.side1;
        out->side2 = point.side2;
        return true;
    }
    void clear() { count_ = 0; }
    void keep_first(int count) { count_ = count; }  // of those that there are

    // A manifold of one normal: keeps the best `min(4, capacity)` points when there are more, those within
    // the margin only if fewer touch: the deepest, then the one farthest from it, then those that span the
    // largest area; ties by index. Implemented in contact_sink.cpp.
    void add_manifold(std::span<const ContactPoint> points);

    dContactGeom* at(int i) const
    {
        return reinterpret_cast<dContactGeom*>(reinterpret_cast<char*>(first_) + std::ptrdiff_t(i) * stride_);
    }

  private:
    dContactGeom* first_;
    int stride_;
    int capacity_;
    bool unimportant_;
    int count_ = 0;
    dGeomID geoms_[2] = {};
    dTriTriMergeCallback* merge_[2] = {};
    NearLeaves* kept_ = nullptr;
    Real margin_ = 0;
    bool to_program_ = false;
};

}  // namespace epode
