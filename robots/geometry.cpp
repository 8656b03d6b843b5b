// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See geometry.h. Principal moments by Jacobi's rotations, which need no trigonometry: t = tan of the angle is the
// smaller root of t^2 + 2 t theta - 1 = 0 with theta = (a_qq - a_pp) / (2 a_pq).
#include "robots/geometry.h"

#include <algorithm>

namespace epode::robots {

namespace {

constexpr double kTurn = 6.283185307179586476925;

// Makes the element (p, q) of a zero, unless it is at most `tiny`; axes, if any, turn with it.
void jacobi_rotate(Matrix& a, size_t p, size_t q, double tiny = 0, Matrix* axes = nullptr)
{
    if (std::fabs(a[p][q]) <= tiny) return;
    const double theta = (a[q][q] - a[p][p]) / (2 * a[p][q]);
    const double t = (theta >= 0 ? 1 : -1) / (std::fabs(theta) + std::sqrt(theta * theta + 1));
    const double c = 1 / std::sqrt(t * t + 1), s = t * c;
    for (size_t k = 0; k < 3; ++k) {
        const double kp = a[k][p], kq = a[k][q];
        a[k][p] = c * kp - s * kq, a[k][q] = s * kp + c * kq;
    }
    for (size_t k = 0; k < 3; ++k) {
        const double pk = a[p][k], qk = a[q][k];
        a[p][k] = c * pk - s * qk, a[q][k] = s * pk + c * qk;
    }
    for (size_t k = 0; axes && k < 3; ++k) {
        const double kp = (*axes)[k][p], kq = (*axes)[k][q];
        (*axes)[k][p] = c * kp - s * kq, (*axes)[k][q] = s * kp + c * kq;
    }
}

// By the series of an eighth of the angle, doubled three times: s' = 2 s c, c' = 1 - 2 s^2.
void sine_and_cosine(double angle, double& s, double& c)
{
    const double x = std::remainder(angle, kTurn) / 8, x2 = x * x;
    double term = x;
    s = 0, c = 1;
    for (int k = 2; k <= 16; k += 2) {
        s += term;
        term *= -x2 / (k * (k + 1));
    }
    for (int i = 0; i < 3; ++i) {
        const double half = s, cosine = i == 0 ? std::sqrt(1 - half * half) : c;
        s = 2 * half * cosine, c = 1 - 2 * half * half;
    }
}

}  // namespace

Quat normalised(Quat q)
{
    const double n = norm(q);
    if (!(n > 1e-300) || !std::isfinite(n)) return {};
    return {q.w / n, q.x / n, q.y / n, q.z / n};
}

Vec rotate(Quat q, Vec v)
{
    const Vec u{q.x, q.y, q.z}, t = 2 * cross(u, v);
    return v + q.w * t + cross(u, t);
}

Quat turn(Vec axis, double angle)
{
    const double n = length(axis);
    if (!(n > 0) || !std::isfinite(n) || !std::isfinite(angle)) return {};
    double s, c;
    sine_and_cosine(angle / 2, s, c);
    return normalised({c, s * axis.x / n, s * axis.y / n, s * axis.z / n});
}

// Halved until asin's series is short: cos(a/2) = sqrt((1 + cos a) / 2), sin(a/2) = sin a / (2 cos(a/2)).
double angle_of(Quat q)
{
    double c = std::fabs(q.w), s = length({q.x, q.y, q.z});
    double scale = 2;
    for (int i = 0; i < 6; ++i) {
        c = std::sqrt((1 + c) / 2);
        s /= 2 * c, scale *= 2;
    }
    const double x2 = s * s;
    return scale * s * (1 + x2 * (1.0 / 6 + x2 * (3.0 / 40 + x2 * (15.0 / 336 + x2 * 105.0 / 3456))));
}

Quat turn_of_rpy(Vec rpy) { return turn({0, 0, 1}, rpy.z) * turn({0, 1, 0}, rpy.y) * turn({1, 0, 0}, rpy.x); }

// With u the unit direction, q = (1 + u_z, z x u) normalised; opposite to z it is half a turn about x.
Quat turn_of_z(Vec direction)
{
    const double n = length(direction);
    if (!(n > 0)) return {};
    const Vec u = (1 / n) * direction;
    if (u.z < -1 + 1e-14) return {0, 1, 0, 0};
    return normalised({1 + u.z, -u.y, u.x, 0});
}

Quat turn_of(const Matrix& r)
{
    const double trace = r[0][0] + r[1][1] + r[2][2];
    if (trace > 0) return normalised({1 + trace, r[2][1] - r[1][2], r[0][2] - r[2][0], r[1][0] - r[0][1]});
    if (r[0][0] >= r[1][1] && r[0][0] >= r[2][2])
        return normalised({r[2][1] - r[1][2], 1 + 2 * r[0][0] - trace, r[0][1] + r[1][0], r[0][2] + r[2][0]});
    if (r[1][1] >= r[2][2])
        return normalised({r[0][2] - r[2][0], r[0][1] + r[1][0], 1 + 2 * r[1][1] - trace, r[1][2] + r[2][1]});
    return normalised({r[1][0] - r[0][1], r[0][2] + r[2][0], r[1][2] + r[2][1], 1 + 2 * r[2][2] - trace});
}

Matrix matrix_of(Quat q)
{
    const Vec x = rotate(q, {1, 0, 0}), y = rotate(q, {0, 1, 0}), z = rotate(q, {0, 0, 1});
    return {{{x.x, y.x, z.x}, {x.y, y.y, z.y}, {x.z, y.z, z.z}}};
}

Matrix operator*(const Matrix& a, const Matrix& b)
{
    Matrix c{};
    for (size_t i = 0; i < 3; ++i)
        for (size_t j = 0; j < 3; ++j)
            for (size_t k = 0; k < 3; ++k) c[i][j] += a[i][k] * b[k][j];
    return c;
}

Matrix transposed(const Matrix& a)
{
    Matrix c{};
    for (size_t i = 0; i < 3; ++i)
        for (size_t j = 0; j < 3; ++j) c[i][j] = a[j][i];
    return c;
}

Matrix operator+(const Matrix& a, const Matrix& b)
{
    Matrix c = a;
    for (size_t i = 0; i < 3; ++i)
        for (size_t j = 0; j < 3; ++j) c[i][j] += b[i][j];
    return c;
}

Vec apply(const Matrix& m, Vec v)
{
    return {m[0][0] * v.x + m[0][1] * v.y + m[0][2] * v.z, m[1][0] * v.x + m[1][1] * v.y + m[1][2] * v.z,
            m[2][0] * v.x + m[2][1] * v.y + m[2][2] * v.z};
}

Matrix rotated(const Matrix& inertia, Quat q)
{
    const Matrix r = matrix_of(q);
    return r * inertia * transposed(r);
}

Matrix point_inertia(double mass, Vec r)
{
    Matrix c{};
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) c[size_t(i)][size_t(j)] = mass * ((i == j ? dot(r, r) : 0) - r[i] * r[j]);
    return c;
}

std::array<double, 3> principal_moments(const Matrix& inertia)
{
    Matrix a = inertia;
    for (int sweep = 0; sweep < 12; ++sweep) {
        jacobi_rotate(a, 0, 1);
        jacobi_rotate(a, 0, 2);
        jacobi_rotate(a, 1, 2);
    }
    std::array<double, 3> values{a[0][0], a[1][1], a[2][2]};
    std::sort(values.begin(), values.end());
    return values;
}

// What rounding leaves off the diagonal would turn the axes of equal moments anyhow.
PrincipalAxes principal_axes(const Matrix& inertia, Quat guess)
{
    constexpr double kRounding = 1e-13;
    Matrix a = rotated(inertia, conjugate(guess)), axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    const double tiny = kRounding * (std::fabs(a[0][0]) + std::fabs(a[1][1]) + std::fabs(a[2][2]));
    for (int sweep = 0; sweep < 12; ++sweep) {
        jacobi_rotate(a, 0, 1, tiny, &axes);
        jacobi_rotate(a, 0, 2, tiny, &axes);
        jacobi_rotate(a, 1, 2, tiny, &axes);
    }
    return {guess * turn_of(axes), {a[0][0], a[1][1], a[2][2]}};
}

bool is_finite(Vec v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

bool is_finite(const Matrix& m)
{
    for (const auto& row : m)
        for (double value : row)
            if (!std::isfinite(value)) return false;
    return true;
}

}  // namespace epode::robots
