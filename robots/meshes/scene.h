// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What the scenes of COLLADA and glTF share: parts that nodes instance, each with an affine map  x -> linear x + shift.
#pragma once

#include "robots/model.h"

namespace epode::robots {

constexpr size_t kMaxInstances = 100'000;  // of nodes in a scene

struct Affine {
    Matrix linear{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    Vec shift;
};

inline Vec operator*(const Matrix& m, Vec v)
{
    return {m[0][0] * v.x + m[0][1] * v.y + m[0][2] * v.z, m[1][0] * v.x + m[1][1] * v.y + m[1][2] * v.z,
            m[2][0] * v.x + m[2][1] * v.y + m[2][2] * v.z};
}

inline Vec operator*(const Affine& a, Vec v) { return a.linear * v + a.shift; }
inline Affine operator*(const Affine& a, const Affine& b) { return {a.linear * b.linear, a * b.shift}; }

struct Part {
    std::vector<Vec> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

// Appends the part where a node puts it; mirrors turn its triangles round. False: too large, or not finite there.
bool add_part(const Part& part, const Affine& where, Mesh& mesh);

}  // namespace epode::robots
