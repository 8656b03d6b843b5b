// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// dGeomLowLevelControl of a mesh: what it takes and answers, and what it does to a ball's contacts with
// triangles in one plane. The number of a contact made of several triangles is left out (differences.tsv,
// C39).
#include <algorithm>
#include <string>

#include "case_list.h"

namespace parity {
namespace {

constexpr float kCorners[4][3] = {{-2, -2, 0}, {2, -2, 0}, {-2, 2, 0}, {2, 2, 0}};
constexpr dTriIndex kFaces[2][3] = {{0, 1, 3}, {0, 3, 2}};

struct Sheet {
    dTriMeshDataID data = dGeomTriMeshDataCreate();
    dGeomID geom = nullptr;
    Sheet()
    {
        dGeomTriMeshDataBuildSingle(data, kCorners, sizeof kCorners[0], 4, kFaces, 6, sizeof kFaces[0]);
        geom = dCreateTriMesh(nullptr, data, nullptr, nullptr, nullptr);
    }
    ~Sheet()
    {
        dGeomDestroy(geom);
        dGeomTriMeshDataDestroy(data);
    }
    Sheet(const Sheet&) = delete;
    Sheet& operator=(const Sheet&) = delete;

    int control(int code, int* value, int* size) const
    {
        return dGeomLowLevelControl(geom, dGeomColliderControlClass, code, value, size);
    }
};

PARITY_CASE(trimesh_merge_settings)
{
    const Sheet sheet;
    for (int wanted = -1; wanted <= 3; ++wanted) {
        int value = wanted, size = sizeof(int), got = -5;
        if (wanted >= 0) {
            out.put("set" + std::to_string(wanted), {double(sheet.control(1, &value, &size))});
        }
        size = sizeof(int);
        const int answered = sheet.control(2, &got, &size);
        out.put("get" + std::to_string(wanted), {double(answered), double(got), double(size)});
    }
    int value = 3, size = 2;
    out.put("short", {double(sheet.control(1, &value, &size)), double(size)});
    size = sizeof(int);
    out.put("null", {double(sheet.control(1, nullptr, &size)), double(size)});
    size = 0;
    out.put("any", {double(sheet.control(0, nullptr, &size)), double(size)});
}

PARITY_CASE(trimesh_merged_spheres)
{
    const Sheet sheet;
    const dGeomID ball = dCreateSphere(nullptr, 0.5);
    const double feet[][2] = {{0, 0}, {1, 1}, {0.5, -0.25}, {-1, 0}};
    for (int merging = 1; merging <= 3; ++merging) {
        int size = sizeof(int);
        sheet.control(1, &merging, &size);
        for (const auto& foot : feet) {
            out.open_block(std::to_string(merging) + "/" + std::to_string(foot[0]) + "," +
                           std::to_string(foot[1]));
            dGeomSetPosition(ball, foot[0], foot[1], 0.5 - 0.00390625);
            dContactGeom found[16] = {};
            const int count = dCollide(ball, sheet.geom, 16, found, sizeof(dContactGeom));
            out.put("count", {double(count)});
            for (int i = 0; i < count; ++i) {
                const dContactGeom& c = found[i];
                out.put("contact" + std::to_string(i),
                        {c.depth, c.pos[0], c.pos[1], c.pos[2], c.normal[0], c.normal[1], c.normal[2]});
            }
        }
    }
    dGeomDestroy(ball);
}

}  // namespace
}  // namespace parity
