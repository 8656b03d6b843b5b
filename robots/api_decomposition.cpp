// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The C functions of convex decomposition: see api.h.
#include "epode/decomposition.h"

#include "robots/api.h"
#include "robots/meshes/formats.h"
#include "robots/parts/decompose.h"

using namespace epode::robots;

namespace {

constexpr int kMaxParts = 256;

bool are_good(const dDecompositionOptions* options)
{
    return !options ||
           (options->struct_size == sizeof(dDecompositionOptions) && std::isfinite(options->tolerance) &&
            options->tolerance >= 0 && (options->max_vertices == 0 || options->max_vertices >= 4));
}

Mesh mesh_of(const dReal* vertices, int vertex_count, const unsigned* triangles, int triangle_count)
{
    Mesh mesh;
    for (int i = 0; i < vertex_count; ++i)
        mesh.vertices.push_back(
            {double(vertices[3 * i]), double(vertices[3 * i + 1]), double(vertices[3 * i + 2])});
    for (int i = 0; i < triangle_count; ++i)
        mesh.triangles.push_back({triangles[3 * i], triangles[3 * i + 1], triangles[3 * i + 2]});
    return mesh;
}

// All or none.
int create_geoms(dSpaceID space, const std::vector<Hull>& hulls, dGeomID* geoms)
{
    int made = 0;
    for (const Hull& hull : hulls) {
        geoms[made] =
            dCreateConvex(space, hull.planes.data(), unsigned(hull.planes.size() / 4), hull.points.data(),
                          unsigned(hull.points.size() / 3), hull.polygons.data());
        if (geoms[made])
            ++made;
        else
            while (made > 0) dGeomDestroy(geoms[--made]);
        if (made == 0) return 0;
    }
    return made;
}

void write(const Decomposition& from, dDecompositionReport* report)
{
    if (!report) return;
    report->is_closed = from.is_closed;
    report->tolerance = dReal(from.tolerance), report->surplus = dReal(from.surplus);
    report->uncovered = dReal(from.uncovered), report->cell = dReal(from.cell);
}

}  // namespace

int dDecompositionOptionsInit(dDecompositionOptions* options, unsigned struct_size)
{
    CHECK(options && struct_size == sizeof(dDecompositionOptions),
          "a structure and its size, sizeof(dDecompositionOptions)");
    *options = dDecompositionOptions{struct_size, 64, 0};
    return 1;
}

int dCreateConvexDecomposition(dSpaceID space, const dReal* vertices, int vertex_count,
                               const unsigned* triangles, int triangle_count,
                               const dDecompositionOptions* options, dGeomID* geoms, int capacity,
                               dDecompositionReport* report)
{
    CHECK(vertices && vertex_count > 0 && triangles && triangle_count > 0 &&
              vertex_count <= int(kMaxVertices) && triangle_count <= int(kMaxTriangles),
          "1 to 6 million vertices and triangles");
    CHECK(geoms && capacity >= 1 && capacity <= kMaxParts, "an array of 1 to 256 geoms");
    CHECK(are_good(options),
          "NULL, or options with their size, a tolerance of 0 or more, and 0 or at least 4 vertices");
    CHECK(!report || report->struct_size == sizeof(dDecompositionReport), "NULL, or a report with its size");
    CHECK(!space || is_space(space), "a space or NULL");
    return guarded(__func__, [&] {
        PartSettings settings;
        settings.max_parts = capacity;
        if (options)
            settings.tolerance = double(options->tolerance),
            settings.max_vertices = unsigned(options->max_vertices);
        Decomposition out;
        std::string problem;
        if (!decompose(mesh_of(vertices, vertex_count, triangles, triangle_count), settings, out, problem)) {
            dMessage(d_ERR_UNKNOWN, "dCreateConvexDecomposition: refused: %s", problem.c_str());
            return 0;
        }
        write(out, report);
        return create_geoms(space, out.hulls, geoms);
    });
}
