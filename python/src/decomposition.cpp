// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Convex decomposition of a mesh of arrays, under epode.decompose.
#include "calls.h"

#ifdef EPODE_HAVE_ROBOTS

#include <algorithm>
#include <cmath>

#include "robots/meshes/formats.h"
#include "robots/parts/decompose.h"

using namespace epode::robots;

namespace {

Mesh mesh_of(nb::handle vertices, nb::handle triangles)
{
    const auto points = array_in<double>(vertices);
    const auto corners = array_in<unsigned>(triangles);
    const size_t count = points.size / 3;
    if (points.size % 3 || corners.size % 3 || !count || !corners.size || count > kMaxVertices ||
        corners.size / 3 > kMaxTriangles)
        throw nb::value_error("(n, 3) vertices and (m, 3) triangles are expected, 1 to 6 million of each");
    Mesh mesh;
    for (size_t i = 0; i < count; ++i)
        mesh.vertices.push_back({points.data[3 * i], points.data[3 * i + 1], points.data[3 * i + 2]});
    for (size_t i = 0; i + 2 < corners.size; i += 3)
        mesh.triangles.push_back({corners.data[i], corners.data[i + 1], corners.data[i + 2]});
    for (const auto& triangle : mesh.triangles)
        for (const std::uint32_t corner : triangle)
            if (corner >= count) throw nb::index_error("a triangle has a corner that is no vertex");
    return mesh;
}

// (corners of each hull, closed, tolerance, surplus, uncovered)
nb::object decompose_mesh(nb::object vertices, nb::object triangles, double tolerance, int max_parts,
                          int max_vertices)
{
    if (!std::isfinite(tolerance) || tolerance < 0 || max_parts < 1 || max_parts > 256 ||
        (max_vertices != 0 && max_vertices < 4))
        throw nb::value_error(
            "a tolerance of 0 or more, 1 to 256 parts, and 0 or at least 4 vertices are expected");
    const Mesh mesh = mesh_of(vertices, triangles);
    Decomposition out;
    std::string problem;
    bool done;
    {
        const WithoutGil released;
        done = decompose(mesh, {tolerance, max_parts, unsigned(max_vertices)}, out, problem);
    }
    Call call;
    if (!done) Call::say({true, d_ERR_UASSERT, problem});
    call.done();
    nb::list parts;
    for (const Hull& hull : out.hulls) {
        std::vector<double> corners;
        for (const Vec& p : hull.corners()) corners.insert(corners.end(), {p.x, p.y, p.z});
        dReal* data;
        parts.append(real_array(corners.size() / 3, 3, &data));
        std::copy(corners.begin(), corners.end(), data);
    }
    return nb::make_tuple(parts, out.is_closed, out.tolerance, out.surplus, out.uncovered);
}

}  // namespace

void bind_decomposition(nb::module_& m) { m.def("_decompose", decompose_mesh); }

#else

void bind_decomposition(nb::module_&) {}

#endif
