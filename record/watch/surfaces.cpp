// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See surfaces.h. A height field hands out no heights. Its box in the world, taken back by its rotation
// (right angles only: then |R| is a permutation and the box loses nothing), gives its extent; rays along its
// own -y from above give the heights. Cells with a corner that no ray met (holes) are left out.
#include "record/watch/surfaces.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "record/watch/lookup.h"

namespace epode::record {

namespace {

constexpr int kCells = 64;

// The geom's frame: x = R^T (p - c).
struct Frame {
    const dReal* pos;
    const dReal* rot;
    Vec3 local(const dReal* p) const
    {
        Vec3 out;
        for (size_t i = 0; i < 3; ++i) {
            out[i] = 0;
            for (size_t k = 0; k < 3; ++k) out[i] += double(rot[4 * k + i]) * double(p[k] - pos[k]);
        }
        return out;
    }
    Vec3 world(const Vec3& x) const
    {
        Vec3 out;
        for (size_t i = 0; i < 3; ++i) {
            out[i] = double(pos[i]);
            for (size_t k = 0; k < 3; ++k) out[i] += double(rot[4 * i + k]) * x[k];
        }
        return out;
    }
};

Frame frame_of(dGeomID geom)
{
    static const dReal kOrigin[3] = {0, 0, 0};
    static const dReal kUnturned[12] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
    const dReal* pos = dGeomGetPosition(geom);
    const dReal* rot = dGeomGetRotation(geom);
    return {pos ? pos : kOrigin, rot ? rot : kUnturned};
}

std::uint32_t vertex_number(Shape& shape, std::map<Vec3, std::uint32_t>& known, const Vec3& at)
{
    const auto [place, is_new] = known.emplace(at, std::uint32_t(shape.vertices.size()));
    if (is_new) shape.vertices.push_back(at);
    return place->second;
}

// Which of the world's axes the geom's axis i lies along; false where it lies along none.
bool along(const Frame& frame, size_t i, size_t& axis)
{
    for (axis = 0; axis < 3; ++axis) {
        if (std::abs(std::abs(double(frame.rot[4 * axis + i])) - 1) < 1e-4) return true;
    }
    return false;
}

struct Extent {
    Vec3 low, high;
};

bool extent_of(dGeomID field, const Frame& frame, Extent& extent)
{
    dReal box[6];
    dGeomGetAABB(field, box);
    for (size_t i = 0; i < 3; ++i) {
        size_t axis = 0;
        if (!along(frame, i, axis)) return false;
        const double low = double(box[2 * axis] - frame.pos[axis]),
                     high = double(box[2 * axis + 1] - frame.pos[axis]);
        if (!std::isfinite(low) || !std::isfinite(high) || high - low > 1e6) return false;
        const bool turned = frame.rot[4 * axis + i] < 0;
        extent.low[i] = turned ? -high : low;
        extent.high[i] = turned ? -low : high;
    }
    return true;
}

bool height_at(dGeomID field, dGeomID ray, const Frame& frame, Vec3& point, double top)
{
    const Vec3 from = frame.world({point[0], top, point[2]});
    dGeomRaySet(ray, dReal(from[0]), dReal(from[1]), dReal(from[2]), -frame.rot[1], -frame.rot[5],
                -frame.rot[9]);
    dContactGeom contact;
    if (dCollide(ray, field, 1, &contact, sizeof contact) < 1) return false;
    point[1] = top - double(contact.depth);
    return std::isfinite(point[1]);
}

using GetPoints = int (*)(dGeomID, dReal*, int);
using GetPolygons = int (*)(dGeomID, unsigned int*, int);
using GetTriangles = int (*)(dGeomID, int, dReal*, int);

}  // namespace

Shape mesh_surface(dGeomID mesh)
{
    Shape shape;
    shape.kind = ShapeKind::kMesh;
    const Frame frame = frame_of(mesh);
    std::map<Vec3, std::uint32_t> known;
    const int count = dGeomTriMeshGetTriangleCount(mesh);
    for (int i = 0; i < count; ++i) {
        dVector3 corner[3];
        dGeomTriMeshGetTriangle(mesh, i, &corner[0], &corner[1], &corner[2]);
        std::array<std::uint32_t, 3> triangle;
        for (size_t k = 0; k < 3; ++k) triangle[k] = vertex_number(shape, known, frame.local(corner[k]));
        shape.triangles.push_back(triangle);
    }
    return shape;
}

Shape convex_surface(dGeomID convex)
{
    static const auto get_points = reinterpret_cast<GetPoints>(library_function("dGeomConvexGetPoints"));
    static const auto get_polygons =
        reinterpret_cast<GetPolygons>(library_function("dGeomConvexGetPolygons"));
    Shape shape;
    shape.kind = ShapeKind::kConvex;
    if (!get_points || !get_polygons) return shape;
    std::vector<dReal> points(3 * size_t(std::max(0, get_points(convex, nullptr, 0))));
    get_points(convex, points.data(), int(points.size() / 3));
    for (size_t i = 0; i + 3 <= points.size(); i += 3)
        shape.vertices.push_back({double(points[i]), double(points[i + 1]), double(points[i + 2])});
    std::vector<unsigned int> polygons(size_t(std::max(0, get_polygons(convex, nullptr, 0))));
    get_polygons(convex, polygons.data(), int(polygons.size()));
    for (size_t at = 0; at < polygons.size() && at + polygons[at] < polygons.size(); at += 1 + polygons[at]) {
        const unsigned int* corner = &polygons[at + 1];
        for (unsigned int i = 2; i < polygons[at]; ++i)
            shape.triangles.push_back({corner[0], corner[i - 1], corner[i]});
    }
    return shape;
}

Shape solid_surface(dGeomID solid)
{
    constexpr int kSegments = 32;
    static const auto get = reinterpret_cast<GetTriangles>(library_function("dGeomGetTriangles"));
    Shape shape;
    if (!get || dGeomIsSpace(solid) || dGeomGetClass(solid) < dGeomNumClasses) return shape;
    std::vector<dReal> reals(9 * size_t(std::max(0, get(solid, kSegments, nullptr, 0))));
    get(solid, kSegments, reals.data(), int(reals.size() / 9));
    shape.kind = ShapeKind::kConvex;
    std::map<Vec3, std::uint32_t> known;
    for (size_t at = 0; at + 9 <= reals.size(); at += 9) {
        std::array<std::uint32_t, 3> triangle;
        for (size_t k = 0; k < 3; ++k) {
            const dReal* p = &reals[at + 3 * k];
            triangle[k] = vertex_number(shape, known, {double(p[0]), double(p[1]), double(p[2])});
        }
        shape.triangles.push_back(triangle);
    }
    return shape;
}

Shape height_field_surface(dGeomID field)
{
    Shape shape;
    shape.kind = ShapeKind::kHeightField;
    const Frame frame = frame_of(field);
    Extent extent;
    if (!extent_of(field, frame, extent)) return shape;
    const double top = extent.high[1] + 1, reach = extent.high[1] - extent.low[1] + 2;
    dGeomID ray = dCreateRay(nullptr, dReal(reach));
    dGeomRaySetClosestHit(ray, 1);
    constexpr std::uint32_t kHole = UINT32_MAX;
    std::vector<std::uint32_t> number;
    for (int row = 0; row <= kCells; ++row) {
        for (int column = 0; column <= kCells; ++column) {
            // A ray at the very edge may miss.
            const double u = std::clamp(double(column) / kCells, 1e-6, 1 - 1e-6),
                         v = std::clamp(double(row) / kCells, 1e-6, 1 - 1e-6);
            Vec3 point = {extent.low[0] + u * (extent.high[0] - extent.low[0]), 0,
                          extent.low[2] + v * (extent.high[2] - extent.low[2])};
            const bool met = height_at(field, ray, frame, point, top);
            number.push_back(met ? std::uint32_t(shape.vertices.size()) : kHole);
            if (met) shape.vertices.push_back(point);
        }
    }
    dGeomDestroy(ray);
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        if (a != kHole && b != kHole && c != kHole) shape.triangles.push_back({a, b, c});
    };
    constexpr size_t kRow = kCells + 1;
    for (size_t row = 0; row < kCells; ++row) {
        for (size_t column = 0; column < kCells; ++column) {
            const size_t at = row * kRow + column;
            add(number[at], number[at + kRow], number[at + 1]);
            add(number[at + 1], number[at + kRow], number[at + kRow + 1]);
        }
    }
    return shape;
}

}  // namespace epode::record
