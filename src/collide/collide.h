// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// From two geoms to contacts: the table of pair functions by class, with reversed entries, overrides and the
// functions of user classes; transforms and spaces are opened on the way.
#pragma once

#include "collide/contact_sink.h"
#include "collide/geom.h"

namespace epode {

// The client's array, walked with the client's stride.
struct ContactArray {
    dContactGeom* first;
    int stride;
    int capacity;
    bool unimportant;  // any contacts will do
    int count = 0;
    Real margin = 0;             // see ContactSink
    bool to_program = false;     // see ContactSink
    NearLeaves* kept = nullptr;  // of the caller, for a solid and a mesh that it collides again and again

    bool full() const { return count >= capacity; }
    dContactGeom* at(int i) const
    {
        return reinterpret_cast<dContactGeom*>(reinterpret_cast<char*>(first) + std::ptrdiff_t(i) * stride);
    }
};

// The function that serves two geoms of these classes in this order, if it is one of ours and nothing of the
// program is in its place; else null.
using PairFunction = void (*)(const Geom& a, const Pose& A, const Geom& b, const Pose& B, ContactSink& sink);
PairFunction own_pair(int first, int second);
// The same, whatever the program has put in its place.
PairFunction built_in_pair(int first, int second);

// Appends the contacts of a and b; g1 belongs to a.
void collide(Geom& a, Geom& b, ContactArray& out);

// The same if they were at A and B.
void collide_at(Geom& a, const Pose& A, Geom& b, const Pose& B, ContactArray& out);

// Has the program put a function of its own, or none, in place of ours?
bool overridden(const Geom& a, const Geom& b);

// Has the program put a function of its own in place of ours anywhere against rays? What a ray means is its
// own business then.
bool rays_overridden();

// May functions of the program be called when the two, neither of them a space, are collided? Of what a
// transform holds this is not asked: yes.
bool may_call_program(Geom& a, Geom& b);

// Another number after every change of the shape that the library is told of; and may it change without a
// word, as heights do that are the program's?
std::uint32_t changes_of(const Geom& geom);
bool changes_unseen(const Geom& geom);

// The same of one geom, whatever it meets, but for functions that the program has put in place of ours; and
// whether it has done so for any two classes since the last close.
bool may_call_program(Geom& geom);
bool any_overridden();

// `function` serves (i, j) and, turned round, (j, i); null: the pair does not collide. Until the last close.
void override_collider(int i, int j, dColliderFn* function);

}  // namespace epode
