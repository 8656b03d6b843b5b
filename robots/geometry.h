// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Vectors, turns and poses of a robot's tree, in double precision whatever the library's. A pose (p, q) takes a
// point x of its frame to q x q* + p. Sines are series of our own, so a model has the same bits on every machine.
#pragma once

#include <array>
#include <cmath>

namespace epode::robots {

constexpr double kPi = 3.14159265358979323846;

struct Vec {
    double x = 0, y = 0, z = 0;
    double& operator[](int i) { return i == 0 ? x : i == 1 ? y : z; }
    double operator[](int i) const { return i == 0 ? x : i == 1 ? y : z; }
};

inline Vec operator+(Vec a, Vec b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vec operator-(Vec a, Vec b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vec operator-(Vec a) { return {-a.x, -a.y, -a.z}; }
inline Vec operator*(double s, Vec a) { return {s * a.x, s * a.y, s * a.z}; }
inline double dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec cross(Vec a, Vec b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double length(Vec a) { return std::sqrt(dot(a, a)); }
inline Vec scaled(Vec a, Vec s) { return {a.x * s.x, a.y * s.y, a.z * s.z}; }

using Matrix = std::array<std::array<double, 3>, 3>;

struct Quat {
    double w = 1, x = 0, y = 0, z = 0;
};

inline Quat operator*(Quat a, Quat b)
{
    return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
            a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}
inline Quat conjugate(Quat q) { return {q.w, -q.x, -q.y, -q.z}; }
inline double norm(Quat q) { return std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z); }
// A quaternion of no length becomes no turn.
Quat normalised(Quat q);
Vec rotate(Quat q, Vec v);
// The axis need not be of unit length; one of no length gives no turn.
Quat turn(Vec axis, double angle);
// The angle of a turn, 0 ... pi.
double angle_of(Quat q);
// Fixed axes x, y, z in that order: URDF's rpy.
Quat turn_of_rpy(Vec rpy);
// The shortest turn that takes z to the direction.
Quat turn_of_z(Vec direction);
Quat turn_of(const Matrix& rotation);
Matrix matrix_of(Quat q);

struct Pose {
    Vec p;
    Quat q;
};

inline Vec operator*(const Pose& a, Vec x) { return rotate(a.q, x) + a.p; }
inline Pose operator*(const Pose& a, const Pose& b) { return {a * b.p, a.q * b.q}; }
inline Pose inverse(const Pose& a) { return {-rotate(conjugate(a.q), a.p), conjugate(a.q)}; }

Matrix operator*(const Matrix& a, const Matrix& b);
Vec apply(const Matrix& m, Vec v);
Matrix transposed(const Matrix& a);
Matrix operator+(const Matrix& a, const Matrix& b);
// R I R^T.
Matrix rotated(const Matrix& inertia, Quat q);
// m (r.r 1 - r r^T): what an inertia about the centre gains at a point r away.
Matrix point_inertia(double mass, Vec r);
// Eigenvalues of a symmetric matrix, ascending.
std::array<double, 3> principal_moments(const Matrix& inertia);

// A turn whose axes are principal ones, and the moments about them. Where moments are equal, the axes of the guess.
struct PrincipalAxes {
    Quat q;
    Vec moments;
};
PrincipalAxes principal_axes(const Matrix& inertia, Quat guess);

bool is_finite(Vec v);
bool is_finite(const Matrix& m);

}  // namespace epode::robots
