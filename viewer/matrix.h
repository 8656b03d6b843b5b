// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The little float algebra a picture needs: Vec, and Mat4 in OpenGL's order (column major, v' = M v). All
// directions in which the camera and the lights look are built by look_along, whose rows are the orthonormal
// right, up, back: p_view = [right; up; back] (p - eye). Own rather than the library's math: outside src/
// only ode/*.h may be seen, and shaders want floats in columns.
#pragma once

#include <cmath>

namespace epode::viewer {

struct Vec {
    float x = 0, y = 0, z = 0;
};

inline Vec vec(const float* p) { return {p[0], p[1], p[2]}; }
inline Vec operator+(Vec a, Vec b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vec operator-(Vec a, Vec b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vec operator*(float s, Vec a) { return {s * a.x, s * a.y, s * a.z}; }
inline float dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec cross(Vec a, Vec b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline float length(Vec a) { return std::sqrt(dot(a, a)); }
inline bool finite(Vec a) { return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z); }

inline Vec normalize(Vec a, Vec otherwise)
{
    const float n = length(a);
    return n > 0 && std::isfinite(n) ? (1 / n) * a : otherwise;
}

struct Basis {
    Vec right, up, back;
};

// back points from what is looked at to the one who looks.
inline Basis look_along(Vec back, Vec up_hint)
{
    Basis basis;
    basis.back = normalize(back, {0, 0, 1});
    const Vec fallback = std::fabs(basis.back.z) < 0.9f ? Vec{0, 0, 1} : Vec{0, 1, 0};
    Vec right = cross(up_hint, basis.back);
    if (!(length(right) > 1e-5f * length(up_hint))) right = cross(fallback, basis.back);
    basis.right = normalize(right, {1, 0, 0});
    basis.up = cross(basis.back, basis.right);
    return basis;
}

struct Mat4 {
    float m[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
};

inline Mat4 operator*(const Mat4& a, const Mat4& b)
{
    Mat4 product;
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) {
            float sum = 0;
            for (int k = 0; k < 4; ++k) sum += a.m[4 * k + row] * b.m[4 * column + k];
            product.m[4 * column + row] = sum;
        }
    }
    return product;
}

inline Mat4 view_matrix(const Basis& basis, Vec eye)
{
    const Vec rows[3] = {basis.right, basis.up, basis.back};
    Mat4 view;
    for (int i = 0; i < 3; ++i) {
        view.m[i] = rows[i].x;
        view.m[4 + i] = rows[i].y;
        view.m[8 + i] = rows[i].z;
        view.m[12 + i] = -dot(rows[i], eye);
    }
    return view;
}

inline Mat4 perspective(float fov_degrees, float aspect, float near, float far)
{
    const float f = 1 / std::tan(fov_degrees * 3.14159265f / 360);
    return {{f / aspect, 0, 0, 0, 0, f, 0, 0, 0, 0, (far + near) / (near - far), -1, 0, 0,
             2 * far * near / (near - far), 0}};
}

// The box [lo, hi] of view space becomes the cube [-1, 1]^3; z is turned round, since a view looks along -z.
inline Mat4 orthographic(Vec lo, Vec hi)
{
    const Vec s = {2 / (hi.x - lo.x), 2 / (hi.y - lo.y), -2 / (hi.z - lo.z)};
    const Vec c = 0.5f * (lo + hi);
    return {{s.x, 0, 0, 0, 0, s.y, 0, 0, 0, 0, s.z, 0, -s.x * c.x, -s.y * c.y, -s.z * c.z, 1}};
}

}  // namespace epode::viewer
