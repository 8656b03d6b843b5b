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

// Whether the program has replaced our function by one of its own or by none.
bool overridden(Geom& a, Geom& b);

// Whether the program has replaced any of our functions for rays. The program then decides what a ray means.
bool rays_overridden();

// Whether colliding the two, neither of them a space, may call functions of the program. What a transform
// holds is not examined: yes.
bool may_call_program(Geom& a, Geom& b);

// Whether functions of the program collide the two: they see the geoms where these are, and nowhere else.
bool program_collides(Geom& a, Geom& b);

// A number that changes with every reported change of the shape; and whether the shape may change without a
// report, as heights do that belong to the program.
std::uint32_t changes_of(const Geom& geom);
bool changes_unseen(const Geom& geom);

// The same for one geom, whatever it collides with, except functions that replace ours; and whether the
// program has replaced the function of any two classes since the last close.
bool may_call_program(Geom& geom);
bool any_overridden();
inline bool geom_calls_program(Geom& geom) { return !geom.type->solid && may_call_program(geom); }

// `function` serves (i, j) and, turned round, (j, i); null: the pair does not collide. Until the last close.
void override_collider(int i, int j, dColliderFn* function);

}  // namespace epode
