// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Height fields. The data object holds samples over a rectangle of the field's own frame, y up:
//   x_i = -width/2 + i width/(nx-1),  z_j = -depth/2 + j depth/(nz-1),  y_ij = scale sample_ij + offset
// or, wrapped, the same rectangle repeated without end (the last column and row stand for the first).
// Cell (i, j) has the corners A(i,j) B(i+1,j) C(i,j+1) D(i+1,j+1) and two facets, A C B and D B C.
// Cells may be missing: holes. Terrain with holes is a slab, `thickness` deep below each facet, and has
// upright walls at the holes; without holes it is solid to any depth. Many geoms may share one data object
// and none owns it; each remembers its serial, so that a destroyed one is recognised. Reading is free of side
// effects: fields may be collided on several threads.
#pragma once

#include "base/array.h"
#include "base/objects/handle.h"
#include "geometry/triangle.h"
#include "ode/collision.h"

namespace epode {

struct HeightfieldData : Numbered {
    HeightfieldData();
    ~HeightfieldData();
    HeightfieldData(const HeightfieldData&) = delete;
    HeightfieldData& operator=(const HeightfieldData&) = delete;

    enum class Source : unsigned char { kNone, kCallback, kBytes, kShorts, kFloats, kDoubles };

    Source source = Source::kNone;  // kNone: not built yet, collides with nothing
    bool wrap = false;
    // In a file that has been loaded, heights were those of a function, or of an array of the program that
    // may change at any time. They are treated as if they still were, since steps then have the same bits.
    bool sampled = false, foreign = false;
    const void* samples = nullptr;  // the client's or the copy
    void* copy = nullptr;
    std::size_t copy_size = 0;
    dHeightfieldGetHeight* callback = nullptr;
    void* user = nullptr;
    Real width = 1, depth = 1;
    int nx = 2, nz = 2;
    Real scale = 1, offset = 0, thickness = 0;
    Real lowest = 0, highest = 0;  // for the bounding box; `lowest` includes the thickness
    Array<unsigned char> holes;    // of each cell, i + j (nx - 1); empty when there are none
    int hole_count = 0;
    std::uint32_t changes = 0;  // reported changes of heights and holes

    Real sample(int i, int j) const;  // inside the rectangle
    Real height(int i, int j) const { return scale * sample(i, j) + offset; }
    void heights(int i, int j, int count, Real* out) const;  // of neighbours in a row
    void set_bounds(Real low_sample, Real high_sample);
    void drop_samples();
    void drop_holes();
};

template <>
struct HandleOf<HeightfieldData> {
    using Id = dHeightfieldDataID;
    static constexpr Tag kTag = Tag::kHeightfieldData;
};

// The shape of a height field geom.
struct Heightfield {
    const HeightfieldData* data = nullptr;
    std::uint64_t serial = 0;
    const HeightfieldData* living() const;  // null when there is none or it is gone
    const HeightfieldData* field() const;   // or is not built
};

// One triangle of a field, and where it lies in the grid.
struct Facet : Triangle {
    int i, j;
    bool upper;  // D B C, else A C B

    // Of edge 0 or 2, the sides of the cell: which way is out.
    int out_axis(int k) const { return k == 0 ? 0 : 2; }
    Real out_sign() const { return upper ? Real(1) : Real(-1); }
    Vec3 out(int k) const { return k == 0 ? Vec3{out_sign(), 0, 0} : Vec3{0, 0, out_sign()}; }
    Real out_limit(int k) const { return out_sign() * v[k][out_axis(k)]; }  // of the wall's plane
};

void finish(Facet& facet);  // of which place and corners are known

// The surface as a set of facets.
class Terrain {
  public:
    explicit Terrain(const HeightfieldData& data);

    bool endless() const { return data_.wrap; }
    Vec3 low_corner() const { return {x0_, 0, z0_}; }
    Vec3 cell() const { return {dx_, 0, dz_}; }
    int cells_x() const { return data_.nx - 1; }
    int cells_z() const { return data_.nz - 1; }
    bool has(int i, int j) const;  // is there such a sample?
    Vec3 vertex(int i, int j) const { return vertex(i, j, height(i, j)); }
    Vec3 vertex(int i, int j, Real y) const { return {x0_ + Real(i) * dx_, y, z0_ + Real(j) * dz_}; }
    Real height(int i, int j) const;
    void heights(int i, int j, int count, Real* out) const;  // from (i, j) along x
    Facet facet(int i, int j, bool upper) const;
    // Place and corners only: of one, and of both of a cell.
    Facet bare_facet(int i, int j, bool upper) const;
    struct BareCell {
        Facet facets[2];
        Real lowest, highest;
    };
    BareCell bare_cell(int i, int j) const;
    // Of which the heights of the corners are known.
    void set_corners(Facet& f, int i, int j, bool upper, Real y0, Real y1, Real y2) const
    {
        const int far = upper ? 1 : 0, near = 1 - far;
        f.i = i, f.j = j, f.upper = upper;
        f.v[0] = vertex(i + far, j + far, y0), f.v[1] = vertex(i + far, j + near, y1),
        f.v[2] = vertex(i + near, j + far, y2);
    }

    bool holed() const { return data_.hole_count > 0; }
    Real thickness() const { return data_.thickness; }
    bool hole(int i, int j) const;  // is cell (i, j) missing? Beyond the field's border none is
    bool hole_beyond(const Facet& facet, int k) const;  // behind edge k
    // The upright wall under such an edge, down to the slab's bottom: two triangles that look into the hole.
    // False where the slab has no thickness.
    bool wall_below(const Facet& facet, int k, Triangle (&wall)[2]) const;

    // Is what the facet shows along n (unit, upwards) a place where the surface stays below the plane across
    // n? Only there can a solid that touches the facet have a contact along n: at flat and hollow edges n
    // must be that of a face.
    bool crests(const Facet& facet, Vec3 n) const;
    // Is that place at a border of the field?
    bool ends_at(const Facet& facet, Vec3 n) const;

    // The edges of the facet behind which the surface falls away, a bit for each.
    unsigned ridges(const Facet& facet) const;

    // Does the surface fall away from the plane across n along all edges at a corner of the facet?
    bool falls_around(const Facet& facet, int corner, Vec3 n, Real level) const;

    // The cell under a point; false: the point is beyond the field.
    bool cell_under(Vec3 p, int& i, int& j) const;
    // Of a field that has holes: is the point below the slab? `lowest`: of the terrain near, for a point over
    // a hole.
    bool under_slab(Vec3 p, Real lowest, Real slack) const;

    // Over edge k: the facet's place, whether it is there or not, and the corner that the edge does not
    // touch.
    struct Neighbour {
        int i, j;
        bool upper;
        Vec3 apex;
        bool there;
    };
    Neighbour neighbour(const Facet& facet, int k) const;

  private:
    bool falls(Vec3 from, Vec3 n, int i, int j, Real level) const;
    bool spoke_gone(int i, int j, int around) const;

    const HeightfieldData& data_;
    Real x0_, z0_, dx_, dz_;
};

}  // namespace epode
