// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What the tests of queries share: a space with every class of geom in it, twice nested, some of them
// disabled, of zero size or with bits of their own, made in an order that a key chooses; and all leaves in the
// order in which they are to be reported, newest first, by a walk over dSpaceGetGeom.
#pragma once

#include <gtest/gtest.h>

#include <ode/ext.h>
#include <ode/ode.h>

#include <vector>

#include "../math/random_numbers.h"

#pragma GCC diagnostic ignored "-Wdeprecated-declarations"  // transforms are part of the interface

namespace epode::test {

inline dGeomID geom_of(dSpaceID space) { return reinterpret_cast<dGeomID>(space); }

inline dQueryFilter bits(unsigned long category, unsigned long collide)
{
    dQueryFilter filter;
    dQueryFilterInit(&filter, sizeof filter);
    filter.category_bits = category, filter.collide_bits = collide;
    return filter;
}

class QueryScene {
  public:
    explicit QueryScene(std::uint64_t key, int count, Real extent = 6) : dice_(key)
    {
        dInitODE();
        space = dHashSpaceCreate(nullptr);
        inner_ = dSimpleSpaceCreate(space);
        innermost_ = dQuadTreeSpaceCreate(inner_, kOrigin, kExtents, 2);
        make_data();
        for (int i = 0; i < count; ++i) add(i, extent);
    }
    ~QueryScene()
    {
        dSpaceDestroy(space);
        dGeomTriMeshDataDestroy(mesh_);
        dGeomHeightfieldDataDestroy(heights_);
        dCloseODE();
    }
    QueryScene(const QueryScene&) = delete;
    QueryScene& operator=(const QueryScene&) = delete;

    // Every geom that is no space, newest first at each level.
    std::vector<dGeomID> leaves() const
    {
        std::vector<dGeomID> out;
        collect(space, out);
        return out;
    }

    // Is it seen by what has these bits?
    static bool seen(dGeomID geom, unsigned long category, unsigned long collide)
    {
        for (dGeomID g = geom; dGeomGetSpace(g); g = geom_of(dGeomGetSpace(g)))
            if (!dGeomIsEnabled(g) ||
                (!(category & dGeomGetCollideBits(g)) && !(dGeomGetCategoryBits(g) & collide)))
                return false;
        return !(dGeomGetClass(geom) == dSphereClass && dGeomSphereGetRadius(geom) == 0);
    }

    dGeomID make(int kind, dSpaceID in)
    {
        const auto size = [&] { return dice_.in(Real(0.2), Real(1.2)); };
        switch (kind) {
            case 0:
                return dCreateSphere(in, dice_.below(12) == 0 ? 0 : size());
            case 1:
                return dCreateBox(in, size(), size(), size());
            case 2:
                return dCreateCapsule(in, size() / 2, size());
            case 3:
                return dCreateCylinder(in, size() / 2, size());
            case 4: {
                dReal points[30];
                for (dReal& p : points) p = dice_.in(Real(-0.8), Real(0.8));
                return dCreateConvexHull(in, points, 10, 0);
            }
            case 5:
                return dCreateTriMesh(in, mesh_, nullptr, nullptr, nullptr);
            case 6:
                return dCreateHeightfield(in, heights_, 1);
            case 7: {
                const dGeomID outer = dCreateGeomTransform(in);
                const dGeomID box = dCreateBox(nullptr, size(), size(), size());
                dGeomSetPosition(box, Real(0.3), 0, Real(0.2));
                dGeomTransformSetGeom(outer, box);
                dGeomTransformSetCleanup(outer, 1);
                return outer;
            }
            default:
                return dCreatePlane(in, dice_.in(-1, 1), dice_.in(-1, 1), Real(1.5), Real(-9));
        }
    }

    void place(dGeomID geom, Real extent)
    {
        if (dGeomGetClass(geom) == dPlaneClass) return;
        const Quat q = dice_.rotation();
        const dQuaternion turned = {q.w, q.x, q.y, q.z};
        dGeomSetQuaternion(geom, turned);
        dGeomSetPosition(geom, dice_.in(-extent, extent), dice_.in(-extent, extent),
                         dice_.in(-extent, extent));
    }

    RandomNumbers& dice() { return dice_; }
    static constexpr int kKinds = 9;
    dSpaceID space;

  private:
    static constexpr dVector3 kOrigin = {0, 0, 0, 0}, kExtents = {10, 10, 10, 0};

    void make_data()
    {
        // A pyramid on a square, and hills.
        static const dReal corners[] = {-1, -1, 0, 0, 1, -1, 0, 0, 1, 1, 0, 0, -1, 1, 0, 0, 0, 0, 1, 0};
        static const dTriIndex triangles[] = {0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4, 0, 2, 1, 0, 3, 2};
        mesh_ = dGeomTriMeshDataCreate();
        dGeomTriMeshDataBuildSimple(mesh_, corners, 5, triangles, 18);
        double hills[25];
        for (double& h : hills) h = double(dice_.in(0, 1));
        heights_ = dGeomHeightfieldDataCreate();
        dGeomHeightfieldDataBuildDouble(heights_, hills, 1, 4, 4, 5, 5, 1, 0, 1, 0);
    }

    void add(int number, Real extent)
    {
        const dSpaceID in = number % 5 == 3 ? inner_ : number % 7 == 5 ? innermost_ : space;
        int kind = dice_.below(kKinds);
        if ((kind == 8 || kind == 6) && dice_.below(4) != 0) kind = dice_.below(6);
        const dGeomID geom = make(kind, in);
        place(geom, extent);
        if (dice_.below(10) == 0) dGeomDisable(geom);
        if (dice_.below(4) == 0) dGeomSetCategoryBits(geom, 2), dGeomSetCollideBits(geom, 4);
    }

    static void collect(dSpaceID from, std::vector<dGeomID>& out)
    {
        for (int i = 0; i < dSpaceGetNumGeoms(from); ++i) {
            const dGeomID g = dSpaceGetGeom(from, i);
            if (dGeomIsSpace(g))
                collect(dSpaceID(g), out);
            else
                out.push_back(g);
        }
    }

    RandomNumbers dice_;
    dSpaceID inner_, innermost_;
    dTriMeshDataID mesh_;
    dHeightfieldDataID heights_;
};

}  // namespace epode::test
