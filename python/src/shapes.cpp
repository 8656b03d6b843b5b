// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Polyhedra, height fields and meshes from arrays, and arrays of what they are made of.
#include <nanobind/stl/vector.h>

#include <algorithm>

#include "filter.h"
#include "written_texts.h"

namespace {

void check_faces(const Array<const double>& planes, const Array<const double>& points,
                 const Array<const unsigned>& polygons)
{
    size_t at = 0;
    for (size_t i = 0; i < planes.size / 4; ++i)
        at = at < polygons.size ? at + 1 + polygons.data[at] : polygons.size + 1;
    if (planes.size % 4 || points.size % 3 || at != polygons.size)
        throw nb::value_error(
            "planes of 4 numbers, points of 3, and for each plane a count and as many corners expected");
}

nb::object create_convex(const SpaceHandle* space, nb::object planes, nb::object points, nb::object polygons)
{
    auto n = array_in<double>(planes), p = array_in<double>(points);
    auto f = array_in<unsigned>(polygons);
    check_faces(n, p, f);
    Call call;
    call.uses(space_of(space));
    dGeomID geom =
        dCreateConvex(space_of(space), n.data, unsigned(n.size / 4), p.data, unsigned(p.size / 3), f.data);
    call.done();
    return wrapped(geom);
}

void set_convex(const GeomHandle* convex, nb::object planes, nb::object points, nb::object polygons)
{
    auto n = array_in<double>(planes), p = array_in<double>(points);
    auto f = array_in<unsigned>(polygons);
    check_faces(n, p, f);
    Call call;
    call.uses(get(convex));
    dGeomSetConvex(get(convex), n.data, unsigned(n.size / 4), p.data, unsigned(p.size / 3), f.data);
    call.done();
}

nb::object create_hull(const SpaceHandle* space, nb::object points, unsigned max_vertices)
{
    auto p = array_in<double>(points);
    Call call;
    call.uses(space_of(space));
    dGeomID geom = dCreateConvexHull(space_of(space), p.data, unsigned(p.size / 3), max_vertices);
    call.done();
    return wrapped(geom);
}

void set_hull(const GeomHandle* convex, nb::object points, unsigned max_vertices)
{
    auto p = array_in<double>(points);
    Call call;
    call.uses(get(convex));
    dGeomSetConvexHull(get(convex), p.data, unsigned(p.size / 3), max_vertices);
    call.done();
}

template <auto F, int Width>
nb::object convex_array(const GeomHandle* geom)
{
    Call call;
    call.uses(get(geom));
    int count = std::max(F(get(geom), nullptr, 0), 0);
    dReal* data;
    nb::object result = real_array(size_t(count), Width, &data);
    if (count) F(get(geom), data, count);
    call.done();
    return result;
}

void set_face_numbers(const GeomHandle* geom, nb::object numbers)
{
    const auto all = array_in<std::uint8_t>(numbers);
    if (all.size > (1u << 30)) throw nb::value_error("at most 2^30 faces are possible");
    Call call;
    call.uses(get(geom));
    dGeomSetFaceMaterialNumbers(get(geom), all.data, int(all.size));
    call.done();
}

nb::object get_face_numbers(const GeomHandle* geom)
{
    Call call;
    call.uses(get(geom));
    const int count = std::max(dGeomGetFaceMaterialNumbers(get(geom), nullptr, 0), 0);
    std::vector<std::uint8_t> numbers(static_cast<size_t>(count));
    if (count) dGeomGetFaceMaterialNumbers(get(geom), numbers.data(), count);
    call.done();
    nb::object bytes = nb::bytes(reinterpret_cast<const char*>(numbers.data()), numbers.size());
    return nb::module_::import_("numpy").attr("fromiter")(bytes, "u1");
}

nb::object triangles(const GeomHandle* geom, int segments)
{
    Call call;
    call.uses(get(geom));
    int count = std::max(dGeomGetTriangles(get(geom), segments, nullptr, 0), 0);
    dReal* data;
    nb::object result = real_array(size_t(count), 9, &data);
    if (count) dGeomGetTriangles(get(geom), segments, data, count);
    call.done();
    return result.attr("reshape")(nb::make_tuple(count, 3, 3));
}

template <auto Build, typename T>
void build_heights(const HeightsHandle* d, nb::object heights, double width, double depth, double scale,
                   double offset, double thickness, bool wrap)
{
    auto h = array_in<T>(heights);
    if (h.shape.size() != 2 || h.size > (1u << 30))
        throw nb::value_error("heights: an array of two dimensions expected, [j, i] with i along the width");
    Call call;
    Build(get(d), h.data, 1, width, depth, int(h.shape[1]), int(h.shape[0]), scale, offset, thickness, wrap);
    call.done();
}

void set_holes(const HeightsHandle* d, nb::object holes)
{
    auto h = array_in<unsigned char>(holes);
    if (h.shape.size() != 2)
        throw nb::value_error("holes: an array of two dimensions expected, [j, i] with i along the width");
    Call call;
    dGeomHeightfieldDataSetHoles(get(d), h.data, int(h.shape[1]), int(h.shape[0]));
    call.done();
}

nb::object create_mesh(const SpaceHandle* space, const MeshHandle* data)
{
    Call call;
    call.uses(space_of(space));
    dGeomID geom = dCreateTriMesh(space_of(space), get(data), nullptr, nullptr, nullptr);
    call.done();
    return wrapped(geom);
}

nb::object triangle(const GeomHandle* geom, int index)
{
    dVector3 v[3] = {};
    Call call;
    call.uses(get(geom));
    dGeomTriMeshGetTriangle(get(geom), index, &v[0], &v[1], &v[2]);
    call.done();
    return nb::make_tuple(array_of(v[0], 3), array_of(v[1], 3), array_of(v[2], 3));
}

}  // namespace

void bind_shapes(nb::module_& m)
{
    m.def("dCreateConvex", create_convex, "space"_a.none(), "planes"_a, "points"_a, "polygons"_a,
          TEXT(dCreateConvex));
    m.def("dGeomSetConvex", set_convex, "convex"_a.none(), "planes"_a, "points"_a, "polygons"_a,
          TEXT(dGeomSetConvex));
    m.def("dCreateConvexHull", create_hull, "space"_a.none(), "points"_a, "maxvertices"_a = 0,
          TEXT(dCreateConvexHull));
    m.def("dGeomSetConvexHull", set_hull, "convex"_a.none(), "points"_a, "maxvertices"_a = 0,
          TEXT(dGeomSetConvexHull));
    m.def("dGeomConvexGetPoints", convex_array<dGeomConvexGetPoints, 3>, "convex"_a.none(),
          TEXT(dGeomConvexGetPoints));
    m.def("dGeomConvexGetPlanes", convex_array<dGeomConvexGetPlanes, 4>, "convex"_a.none(),
          TEXT(dGeomConvexGetPlanes));
    m.def(
        "dGeomConvexGetPolygons",
        [](const GeomHandle* geom) {
            Call call;
            auto result = listed<unsigned>(
                [&](unsigned* out, int n) { return dGeomConvexGetPolygons(get(geom), out, n); });
            call.done();
            return result;
        },
        "convex"_a.none(), TEXT(dGeomConvexGetPolygons));
    m.def("dGeomSetFaceMaterialNumbers", set_face_numbers, "geom"_a.none(), "numbers"_a,
          TEXT(dGeomSetFaceMaterialNumbers));
    m.def("dGeomGetFaceMaterialNumbers", get_face_numbers, "geom"_a.none(),
          TEXT(dGeomGetFaceMaterialNumbers));
    m.def("dGeomGetTriangles", triangles, "geom"_a.none(), "segments"_a = 24, TEXT(dGeomGetTriangles));
#define HEIGHTS(name, type)                                                                        \
    m.def("dGeomHeightfieldDataBuild" #name, build_heights<dGeomHeightfieldDataBuild##name, type>, \
          "d"_a.none(), "heights"_a, "width"_a, "depth"_a, "scale"_a = 1.0, "offset"_a = 0.0,      \
          "thickness"_a = 0.0, "bWrap"_a = false, TEXT(dGeomHeightfieldDataBuild##name))
    HEIGHTS(Byte, unsigned char);
    HEIGHTS(Short, short);
    HEIGHTS(Single, float);
    HEIGHTS(Double, double);
    m.def("dGeomHeightfieldDataSetHoles", set_holes, "d"_a.none(), "holes"_a,
          TEXT(dGeomHeightfieldDataSetHoles));
    m.def("dCreateTriMesh", create_mesh, "space"_a.none(), "data"_a.none(), TEXT(dCreateTriMesh));
    m.def("dGeomTriMeshGetTriangle", triangle, "g"_a.none(), "index"_a, TEXT(dGeomTriMeshGetTriangle));
}
