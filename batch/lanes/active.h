// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What kernels and whoever differentiates a step tell one another, as plain numbers. See sensitivity.h for the mathematics.
#pragma once

namespace epode::batch {

// A row of a solved step of one copy. Of a contact three follow one another: normal and tangents.
template <typename T>
struct FoundRow {
    int impulse;  // which, among all
    bool is_contact;
    T value, velocity;        // of the impulse; J v+
    T sign, soft, low, high;  // singles: sign J v+ + soft value >= bias, value within low and high
    T friction, mass;         // mass 0: the constraint is far
    bool has_gap;             // whether the bias is slope times gap, about this state
    T slope;
};

// How a contact's tangents follow: 0 = value + friction n (turn + bend (u - u0)), n the normal impulse, u the sliding velocity.
template <typename T>
struct Slide {
    bool slides;
    T n, u0[2], turn[2], bend[3];  // bend: xx xy yy
};

// The rows that act at a solution, and what v+ loses for a unit error of each.
template <typename T>
struct ActiveSet {
    int rows;
    const int* row;           // of each impulse: which row is its, -1: none
    const T* slope;           // of each impulse: of its bias over its gap
    const bool* follows_gap;  // of each impulse: whether the bias is slope times gap
    const Slide<T>* slide;    // of each contact slot
    const T* gain;            // (dofs, rows)
};

// Two groups of copies, apart along a column each lane: the way from the middle to `plus` is seed, to `minus` -seed.
template <typename T>
struct Apart {
    T *plus, *minus;
    const T *numbers_plus, *numbers_minus;
    bool own;
    const T* seed;  // rows of positions' and velocities' tangents
    const T* rate;  // a row: 1 / the distance between both
    T* errors;      // rows of the active set, of both
    T* out;         // rows: tangents of positions, velocities, activations
};

}  // namespace epode::batch
