// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Cells of a height field that are missing: one byte each, kept with the data and gone with the layout that
// they belong to. No array means none, so that fields without holes pay for one look at a number.
#include "base/memory.h"
#include "collide/surfaces/height_function.h"
#include "collide/types/registry.h"
#include "ode/ext.h"

namespace epode {
namespace {

bool built(const HeightfieldData* d) { return d && d->source != HeightfieldData::Source::kNone; }

bool has_cell(const HeightfieldData& d, int i, int j)
{
    return i >= 0 && j >= 0 && i < d.nx - 1 && j < d.nz - 1;
}

// In whole numbers: a field by a callback may have more cells than an array can hold.
bool countable(const HeightfieldData& d)
{
    return std::int64_t(d.nx - 1) * (d.nz - 1) <= std::numeric_limits<int>::max();
}

}  // namespace
}  // namespace epode

using namespace epode;

extern "C" {

void dGeomHeightfieldDataSetHoles(dHeightfieldDataID d, const unsigned char* holes, int widthCells,
                                  int depthCells)
{
    HeightfieldData* data = from_handle<HeightfieldData>(d);
    EPODE_USER(built(data) && widthCells == data->nx - 1 && depthCells == data->nz - 1 && countable(*data));
    EPODE_OUTSIDE_HEIGHT_FUNCTION();
    const int cells = widthCells * depthCells;
    int count = 0;
    for (int k = 0; holes && k < cells; ++k) count += holes[k] != 0;
    if (count == 0) return data->drop_holes();
    EPODE_USER_SAY(data->holes.resize(cells), kOutOfMemory);
    for (int k = 0; k < cells; ++k) data->holes[k] = holes[k] != 0;
    data->hole_count = count;
    ++data->changes;
}

void dGeomHeightfieldDataSetHole(dHeightfieldDataID d, int i, int j, int hole)
{
    HeightfieldData* data = from_handle<HeightfieldData>(d);
    EPODE_USER(built(data) && has_cell(*data, i, j) && (hole == 0 || hole == 1) && countable(*data));
    EPODE_OUTSIDE_HEIGHT_FUNCTION();
    if (hole == 0 && data->hole_count == 0) return;
    const int cells = (data->nx - 1) * (data->nz - 1);
    EPODE_USER_SAY(data->holes.resize(cells), kOutOfMemory);
    unsigned char& cell = data->holes[i + j * (data->nx - 1)];
    data->hole_count += hole - int(cell);
    cell = static_cast<unsigned char>(hole);
    ++data->changes;
}

int dGeomHeightfieldDataGetHole(dHeightfieldDataID d, int i, int j)
{
    const HeightfieldData* data = from_handle<HeightfieldData>(d);
    EPODE_USER(built(data) && has_cell(*data, i, j), 0);
    return data->hole_count > 0 && data->holes[i + j * (data->nx - 1)];
}

}  // extern "C"
