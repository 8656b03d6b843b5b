// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Classes that a program makes at run time: numbers dFirstUserClass and up, at most four, forgotten by the
// last dCloseODE. A geom keeps a copy of its class, so it can still be boxed and destroyed when the class is
// forgotten before it; it collides with nothing then, for its number may be another class's.
#pragma once

#include "collide/geom.h"

namespace epode {

struct UserGeom : Geom {
    UserGeom(const GeomType& geom_type, const dGeomClass& description)
        : Geom(geom_type), functions(description)
    {}
    dGeomClass functions;
    void* memory = nullptr;  // functions.bytes of the client's
    int generation = 0;      // how often classes had been forgotten when it was made
};

constexpr bool is_user_class(int number) { return number >= dFirstUserClass && number <= dLastUserClass; }

bool is_forgotten(const Geom& geom);             // of a class that is no more
const GeomType* user_type(int number);           // null: no such class now
const dGeomClass* user_description(int number);  // null: no such class now

}  // namespace epode
