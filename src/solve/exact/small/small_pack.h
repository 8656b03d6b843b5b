// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Columns of the small-island solver: two rows are processed together, in a lane. The order of sums is part of the definition: even rows,
// odd rows, then both, on every machine.
#pragma once

#include <type_traits>

#include "simd/lanewise.h"
#include "solve/exact/factor/block_cholesky.h"

namespace epode {
namespace {

inline constexpr int kLaneRows = 2;
constexpr int lanes_of(int rows) { return (rows + 1) / 2; }

// As whole lanes: reading a lane of which halves were stored waits for the stores.
template <int Size>
void store_column(DoubleLane* to, const double* x)
{
    for (int q = 0; q < lanes_of(Size); ++q)
        to[q] = DoubleLane{x[2 * q], 2 * q + 1 < Size ? x[2 * q + 1] : 0.0};
}
inline DoubleLane magnitude(DoubleLane x)
{
    typedef long long Bits __attribute__((vector_size(16)));
    const Bits all_but_sign = Bits{} + 0x7fffffffffffffffLL;
    return DoubleLane(Bits(x) & all_but_sign);
}

// Calls `work` with the number of rows as a constant: loops this short are worth unrolling.
template <class Work>
EPODE_LANEWISE void by_size(int size, Work work)
{
    switch (size) {
        case 1:
            return work(std::integral_constant<int, 1>{});
        case 2:
            return work(std::integral_constant<int, 2>{});
        case 3:
            return work(std::integral_constant<int, 3>{});
        case 4:
            return work(std::integral_constant<int, 4>{});
        case 5:
            return work(std::integral_constant<int, 5>{});
        default:
            return work(std::integral_constant<int, 6>{});
    }
}

// out[:,c] -= sum_t x[:,t] y[t][c], columns of so many lanes
template <int Lanes>
EPODE_LANEWISE void subtract(DoubleLane* out, int out_height, int columns, const DoubleLane* x, int x_height,
                             const double* y, int y_height, int terms)
{
    for (int c = 0; c < columns; ++c, out += out_height) {
        DoubleLane s[Lanes];
        for (int q = 0; q < Lanes; ++q) s[q] = out[q];
        for (int t = 0; t < terms; ++t) {
            const double k = y[t * y_height + c];
            for (int q = 0; q < Lanes; ++q) s[q] -= x[t * x_height + q] * k;
        }
        for (int q = 0; q < Lanes; ++q) out[q] = s[q];
    }
}

inline void subtract_product(DoubleLane* out, int out_height, int columns, const DoubleLane* x, int x_height,
                             const double* y, int y_height, int lanes, int terms)
{
    switch (lanes) {
        case 1:
            return subtract<1>(out, out_height, columns, x, x_height, y, y_height, terms);
        case 2:
            return subtract<2>(out, out_height, columns, x, x_height, y, y_height, terms);
        default:
            return subtract<3>(out, out_height, columns, x, x_height, y, y_height, terms);
    }
}

}  // namespace
}  // namespace epode
