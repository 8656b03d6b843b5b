// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Vectors and quaternions whose components are machine vectors V of Reals or floats, one lane per object. In
// an unnamed namespace for the reason given in simd/vectors.h.
#pragma once

namespace epode {
namespace {

template <typename V>
struct Vector3Of {
    V x, y, z;
};

template <typename V>
struct Vector4Of {
    V w, x, y, z;
};

}  // namespace
}  // namespace epode
