// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Blocks of at most six rows, for solvers that unroll them: those of driven joints are cut in pieces, which
// are then blocks of the same two bodies. For methods that solve all blocks together it makes no difference
// where the cuts are.
#pragma once

#include <algorithm>

#include "base/arena.h"
#include "rows/row_system.h"

namespace epode {

inline constexpr int kPieceRows = 6;

inline int pieces_of(const RowBlock& block) { return (block.count + kPieceRows - 1) / kPieceRows; }

// f(piece) for each piece of the block, which is itself if it is small enough.
template <typename F>
void for_each_piece(const RowBlock& block, F&& f)
{
    for (int from = 0; from < block.count; from += kPieceRows) {
        RowBlock piece = block;
        piece.first = block.first + from, piece.count = std::min(kPieceRows, block.count - from);
        piece.point = block.point && from == 0;
        f(piece);
    }
}

// Nothing is copied where no block is cut. False: out of memory.
inline bool cut_blocks(RowSystem& system, Arena& arena)
{
    const auto large = [](const RowBlock& block) { return block.count > kPieceRows; };
    if (std::none_of(system.blocks.begin(), system.blocks.end(), large)) return true;
    int pieces = 0;
    for (const RowBlock& block : system.blocks) pieces += pieces_of(block);
    const std::span<RowBlock> cut = arena.take<RowBlock>(pieces);
    if (arena.failed()) return false;
    std::size_t next = 0;
    for (const RowBlock& block : system.blocks)
        for_each_piece(block, [&](const RowBlock& piece) { cut[next++] = piece; });
    system.blocks = cut;
    return true;
}

}  // namespace epode
