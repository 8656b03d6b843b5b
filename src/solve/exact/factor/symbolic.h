// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Symbolic factorisation: the structure of the factor L of H = L L^T, found from the body graph alone, and
// what a numeric factorisation has to do where. Columns (bodies) with nearly equal structure are joined into
// a front: `width` columns and, below them, `below` rows that at least one of the columns has,
//
//   front s:   [ D ]  width   rows        D lower triangular
//              [ B ]  below   rows
//
// stored as one dense array of 6x6 blocks, row of blocks after row of blocks. When s is done, B B^T is
// subtracted from the fronts that own its rows. The places of these blocks are stored here once, so that the
// numeric part neither searches nor compares.
#pragma once

#include "solve/exact/factor/body_graph.h"

namespace epode {

struct Front {
    int first;                  // its columns are first .. first + width - 1 in elimination order
    int width, below;           // in bodies
    int rows;                   // its rows below begin here in SymbolicFactor::rows
    int block;                  // its blocks begin here; block (i, c) is i * width + c further on
    int updates, update_count;  // in SymbolicFactor::updates
};

// Rows begin .. begin + columns - 1 (counted below the columns) of a front are columns of `target`; row
// begin + k of it is row places[place + k] of the target.
struct FrontUpdate {
    int target;
    int begin, columns;
    int place;
};

// A subtree of the tree of fronts, which can be factored in parallel with others. What it subtracts from
// fronts outside is collected in a front of its own, the border, whose `width` columns are the rows of the
// subtree's root. The border is never factored; when all subtrees are done it is added to the fronts that own
// its columns. Whether there are subtrees depends on the structure alone, so the sums are the same on any
// number of threads.
struct Subtree {
    int fronts, count;  // in SymbolicFactor::subtree_fronts, ascending
    int root;           // the last of them
    int border;         // index of the border
};

struct SymbolicFactor {
    int bodies = 0;
    int columns = 0;          // the bodies', then those of the borders
    int blocks = 0;           // 6x6 blocks of all fronts
    int top = 0, end = 0;     // fronts of subtrees, then from `top` those above them, from `end` borders
    std::span<int> position;  // body -> column
    std::span<int> front_of;  // column -> front
    std::span<Front> fronts;  // children before their parents
    std::span<int> rows;      // columns, ascending within a front
    std::span<int> entries;   // the same, but of the border where the border takes the row's sums
    std::span<FrontUpdate> updates;
    std::span<int> places;
    std::span<Subtree> subtrees;
    std::span<int> subtree_fronts;

    // The block of two columns, row >= column, if the structure has it.
    int block_at(int row, int column) const;
};

// The symbolic factor for a given order of elimination. False: out of memory.
bool factor_symbolically(const BodyGraph& graph, std::span<const int> order, Arena& arena,
                         SymbolicFactor& out);

}  // namespace epode
