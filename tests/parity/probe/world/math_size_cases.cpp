// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The matrix functions at sizes 0, 1 and up to 100, at row lengths other than the padded one, and what they
// leave in the padding. Matrices are set in frames of a number that shows where something else was written.
#include "case_list.h"

#include <vector>

namespace parity {
namespace {

constexpr dReal mark = 77;

int padded(int n) { return n <= 1 ? n : (n + 3) & ~3; }
std::size_t at(int i) { return static_cast<std::size_t>(i); }

struct Framed {
    Framed(int rows, int columns, int stride) : m(columns), skip(stride), cells(at(rows * stride + 8), mark)
    {}
    Framed(int rows, int columns) : Framed(rows, columns, padded(columns)) {}
    static Framed random(Random& random, int rows, int columns)
    {
        Framed a(rows, columns);
        for (int i = 0; i < rows; ++i) {
            for (int j = 0; j < columns; ++j) { a(i, j) = random.range(-1, 1); }
        }
        return a;
    }
    // G G' / n + 1: eigenvalues from 1 on.
    static Framed definite(Random& random, int n, int stride)
    {
        const Framed g = Framed::random(random, n, n);
        Framed a(n, n, stride);
        for (int i = 0; i < n; ++i) {
            for (int j = 0; j < n; ++j) {
                double sum = i == j ? n : 0;
                for (int k = 0; k < n; ++k) { sum += g(i, k) * g(j, k); }
                a(i, j) = sum / n;
            }
        }
        return a;
    }
    dReal& operator()(int i, int j) { return cells[at(i * skip + j)]; }
    dReal operator()(int i, int j) const { return cells[at(i * skip + j)]; }
    dReal* data() { return cells.data(); }
    // The elements, and what is next to them and behind them.
    void put(Output& out, const std::string& key) const
    {
        std::vector<dReal> elements, frame;
        for (std::size_t i = 0; i < cells.size(); ++i) {
            const bool inside = i + 8 < cells.size() && static_cast<int>(i) % skip < m;
            (inside ? elements : frame).push_back(cells[i]);
        }
        out.put(key, elements.data(), static_cast<int>(elements.size()));
        out.put(key + "-frame", frame.data(), static_cast<int>(frame.size()));
    }
    void put_strict_lower(Output& out, const std::string& key, int n) const
    {
        std::vector<dReal> values;
        for (int i = 0; i < n; ++i) {
            for (int j = 0; j < i; ++j) { values.push_back((*this)(i, j)); }
        }
        out.put(key, values.data(), static_cast<int>(values.size()));
    }
    // The frame behind the last row.
    void put_end(Output& out, const std::string& key) const
    {
        out.put(key, cells.data() + cells.size() - 8, 8);
    }

    int m, skip;
    std::vector<dReal> cells;
};

PARITY_CASE(math_size_products)
{
    const int sizes[][3] = {{1, 1, 1},  {1, 5, 1},    {5, 1, 5},    {4, 4, 1},   {1, 2, 4},   {3, 8, 2},
                            {8, 9, 10}, {16, 16, 16}, {33, 20, 17}, {100, 3, 2}, {2, 100, 3}, {64, 50, 41}};
    for (const auto& s : sizes) {
        const int p = s[0], q = s[1], r = s[2];
        out.open_block(std::to_string(p) + "-" + std::to_string(q) + "-" + std::to_string(r));
        Framed a(p, r);
        Framed b = Framed::random(rng, p, q), c = Framed::random(rng, q, r);
        dMultiply0(a.data(), b.data(), c.data(), p, q, r);
        a.put(out, "multiply0");
        Framed bt = Framed::random(rng, q, p), a1(p, r);
        dMultiply1(a1.data(), bt.data(), c.data(), p, q, r);
        a1.put(out, "multiply1");
        Framed ct = Framed::random(rng, r, q), a2(p, r);
        dMultiply2(a2.data(), b.data(), ct.data(), p, q, r);
        a2.put(out, "multiply2");
    }
}

PARITY_CASE(math_size_vectors)
{
    for (int n = 0; n <= 100; n = n < 12 ? n + 1 : n * 3 / 2) {
        out.open_block("n" + std::to_string(n));
        Framed a = Framed::random(rng, 1, 100), d = Framed::random(rng, 1, 100);
        out.put("dot", {dDot(a.data(), d.data(), n)});
        dScaleVector(a.data(), d.data(), n);
        dVectorScale(a.data(), d.data(), n / 2);
        a.put(out, "scaled");
        dSetZero(a.data(), n);
        dSetValue(a.data(), n / 2, 5);
        a.put(out, "set");
    }
}

PARITY_CASE(math_size_cholesky)
{
    for (const int n : {1, 2, 4, 5, 23, 32, 49, 64, 100}) {
        out.open_block("n" + std::to_string(n));
        const Framed a = Framed::definite(rng, n, padded(n));
        Framed l = a, inverse(n, n), b = Framed::random(rng, 1, n);
        out.put("ok", {static_cast<double>(dFactorCholesky(l.data(), n))});
        l.put_strict_lower(out, "factor", n);
        l.put_end(out, "frame");
        dSolveCholesky(l.data(), b.data(), n);
        b.put(out, "solution");
        Framed given = a;
        out.put("ok-inverse", {static_cast<double>(dInvertPDMatrix(given.data(), inverse.data(), n))});
        inverse.put_strict_lower(out, "inverse", n);
        inverse.put_end(out, "frame-inverse");
        out.put("ok-definite", {static_cast<double>(dIsPositiveDefinite(given.data(), n))});
        out.put("ok-kept", {given.cells == a.cells ? 1.0 : 0.0});
        given(n / 2, n / 2) = -1;
        out.put("ok-indefinite", {static_cast<double>(dIsPositiveDefinite(given.data(), n)),
                                  static_cast<double>(dInvertPDMatrix(given.data(), inverse.data(), n)),
                                  static_cast<double>(dFactorCholesky(given.data(), n))});
    }
}

PARITY_CASE(math_size_ldlt)
{
    for (const int n : {1, 2, 3, 4, 5, 8, 23, 32, 49, 64, 77, 100}) {
        out.open_block("n" + std::to_string(n));
        Framed l = Framed::definite(rng, n, padded(n)), d(1, n), b = Framed::random(rng, 1, n), b1 = b,
               b2 = b;
        dFactorLDLT(l.data(), d.data(), n, l.skip);
        l.put_strict_lower(out, "factor", n);
        d.put(out, "diagonal");
        dSolveL1(l.data(), b.data(), n, l.skip);
        b.put(out, "l1");
        dSolveL1T(l.data(), b1.data(), n, l.skip);
        b1.put(out, "l1t");
        dSolveLDLT(l.data(), d.data(), b2.data(), n, l.skip);
        b2.put(out, "solution");
    }
    out.open_block("empty");
    Framed none(1, 4);
    dFactorLDLT(none.data(), none.data(), 0, 4);
    none.put(out, "untouched");
}

PARITY_CASE(math_size_ldlt_updates)
{
    for (const int n : {1, 2, 3, 7, 20, 41, 64}) {
        for (int turn = 0; turn < 4; ++turn) {
            out.open_block("n" + std::to_string(n) + "-" + std::to_string(turn));
            const int skip = padded(n), r = turn == 0 ? 0 : turn == 1 ? n - 1 : rng.below(n);
            Framed a = Framed::definite(rng, n, skip), l = a, d(1, n);
            std::vector<dReal*> rows;
            std::vector<int> p;
            for (int i = 0; i < n; ++i) {
                rows.push_back(a.data() + i * skip);
                p.push_back(i);
            }
            dFactorLDLT(l.data(), d.data(), n, skip);
            Framed l2 = l, d2 = d;
            dLDLTRemove(rows.data(), p.data(), l.data(), d.data(), n, n, r, skip);
            l.put_strict_lower(out, "removed", n - 1);
            out.put("removed-d", d.data(), n - 1);
            Framed change = Framed::random(rng, 1, n);
            for (dReal& x : change.cells) { x *= 0.1 / n; }
            dLDLTAddTL(l2.data(), d2.data(), change.data(), n, skip);
            for (int i = 1; i < n; ++i) { l2(i, 0) = 0; }
            l2.put_strict_lower(out, "added", n);
            out.put("added-d", d2.data() + 1, n - 1);
        }
    }
}

PARITY_CASE(math_size_remove)
{
    for (const int n : {1, 2, 5, 16, 40}) {
        for (const int extra : {0, 1, 3}) {
            for (const int r : {0, n / 2, n - 1}) {
                out.open_block("n" + std::to_string(n) + "-" + std::to_string(extra) + "-" +
                               std::to_string(r));
                Framed a(n, n, n + extra);
                for (int i = 0; i < n; ++i) {
                    for (int j = 0; j < n; ++j) { a(i, j) = 100 * i + j; }
                }
                dRemoveRowCol(a.data(), n, n + extra, r);
                std::vector<dReal> rest;
                for (int i = 0; i < n - 1; ++i) {
                    for (int j = 0; j < n - 1; ++j) { rest.push_back(a(i, j)); }
                }
                out.put("rest", rest.data(), static_cast<int>(rest.size()));
                a.put_end(out, "frame");
            }
        }
    }
}

}  // namespace
}  // namespace parity
