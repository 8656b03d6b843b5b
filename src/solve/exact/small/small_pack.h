// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The number types of the small-island solver. One island: an entry is a double, and two rows of a column are
// processed together. The order of sums is part of the definition: even rows, odd rows, then both, on every
// machine.
#pragma once

#include <type_traits>

#include "simd/lanewise.h"
#include "solve/exact/factor/block_cholesky.h"

namespace epode {
namespace {

struct OneIsland {
    using Number = double;
    using Lane = DoubleLane;
    static constexpr int kRows = 2;   // of a column in one lane
    static constexpr int kParts = 1;  // lanes that together hold an even and an odd row

    static constexpr int lanes(int rows) { return (rows + 1) / 2; }
    // As whole lanes: reading a lane of which halves were stored waits for the stores.
    template <int Size>
    static void store(Lane* to, const double* x)
    {
        for (int q = 0; q < lanes(Size); ++q) to[q] = Lane{x[2 * q], 2 * q + 1 < Size ? x[2 * q + 1] : 0.0};
    }
    static Lane magnitude(Lane x)
    {
        typedef long long Bits __attribute__((vector_size(16)));
        const Bits all_but_sign = Bits{} + 0x7fffffffffffffffLL;
        return Lane(Bits(x) & all_but_sign);
    }
    static double fold(const Lane* sum) { return sum[0][0] + sum[0][1]; }
};

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
template <class Pack, int Lanes>
EPODE_LANEWISE void subtract(typename Pack::Lane* out, int out_height, int columns,
                             const typename Pack::Lane* x, int x_height, const typename Pack::Number* y,
                             int y_height, int terms)
{
    for (int c = 0; c < columns; ++c, out += out_height) {
        typename Pack::Lane s[Lanes];
        for (int q = 0; q < Lanes; ++q) s[q] = out[q];
        for (int t = 0; t < terms; ++t) {
            const typename Pack::Number k = y[t * y_height + c];
            for (int q = 0; q < Lanes; ++q) s[q] -= x[t * x_height + q] * k;
        }
        for (int q = 0; q < Lanes; ++q) out[q] = s[q];
    }
}

template <class Pack>
inline void subtract_product(typename Pack::Lane* out, int out_height, int columns,
                             const typename Pack::Lane* x, int x_height, const typename Pack::Number* y,
                             int y_height, int lanes, int terms)
{
    switch (lanes) {
        case 1:
            return subtract<Pack, 1>(out, out_height, columns, x, x_height, y, y_height, terms);
        case 2:
            return subtract<Pack, 2>(out, out_height, columns, x, x_height, y, y_height, terms);
        default:
            return subtract<Pack, 3>(out, out_height, columns, x, x_height, y, y_height, terms);
    }
}

}  // namespace
}  // namespace epode
