// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See solid.h. A solid is the sum of the tetrahedra from an inner point o to the triangles (a, b, c): volume
// V = a.(b x c)/6, centre (a + b + c)/4, and second moments  V/20 (sum_i r_i r_i^T + s s^T) with s = a + b + c, from
// which I = tr(M) 1 - M.
#include "robots/meshes/solid.h"

namespace epode::robots {

namespace {

// The mean place of the surface.
Vec middle_of(const Mesh& mesh)
{
    Vec sum;
    double area = 0;
    for (const auto& t : mesh.triangles) {
        const Vec a = mesh.vertices[t[0]], b = mesh.vertices[t[1]], c = mesh.vertices[t[2]];
        const double its = length(cross(b - a, c - a)) / 2;
        sum = sum + (its / 3) * (a + b + c);
        area += its;
    }
    return area > 0 ? (1 / area) * sum : mesh.vertices[0];
}

struct Moments {
    double volume = 0;
    Vec first;
    Matrix second{};
};

Moments moments_about(const Mesh& mesh, Vec inner)
{
    Moments out;
    for (const auto& t : mesh.triangles) {
        const Vec r[3] = {mesh.vertices[t[0]] - inner, mesh.vertices[t[1]] - inner,
                          mesh.vertices[t[2]] - inner};
        const Vec s = r[0] + r[1] + r[2];
        double v = dot(r[0], cross(r[1], r[2])) / 6;
        if (mesh.counts_folds) v = std::fabs(v);
        out.volume += v;
        out.first = out.first + (v / 4) * s;
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                out.second[size_t(i)][size_t(j)] +=
                    v / 20 * (r[0][i] * r[0][j] + r[1][i] * r[1][j] + r[2][i] * r[2][j] + s[i] * s[j]);
    }
    return out;
}

}  // namespace

// Twice: about the middle of the surface for the centre of mass, and about that for mass and inertia.
bool solid_of(const Mesh& mesh, Solid& solid)
{
    if (mesh.vertices.empty()) return false;
    const Vec middle = middle_of(mesh);
    const Moments rough = moments_about(mesh, middle);
    if (rough.volume == 0 || !std::isfinite(rough.volume)) return false;
    solid.centre = middle + (1 / rough.volume) * rough.first;
    const Moments fine = moments_about(mesh, solid.centre);
    const double sign = fine.volume < 0 ? -1 : 1;  // inside out
    const Matrix& m = fine.second;
    const double trace = m[0][0] + m[1][1] + m[2][2];
    for (size_t i = 0; i < 3; ++i)
        for (size_t j = 0; j < 3; ++j) solid.inertia[i][j] = sign * ((i == j ? trace : 0) - m[i][j]);
    solid.volume = sign * fine.volume;
    return solid.volume > 0 && is_finite(solid.inertia);
}

}  // namespace epode::robots
