// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Matrix functions on random positive definite systems of 1 to 20 rows: products, Cholesky, LDL', the
// updating of a factorisation, and removal of a row and column.
#include "case_list.h"

#include <vector>

namespace parity {
namespace {

int padded(int n) { return n <= 1 ? n : (n + 3) & ~3; }

using Matrix = std::vector<dReal>;

std::size_t cells(int rows, int columns)
{
    return static_cast<std::size_t>(rows) * static_cast<std::size_t>(padded(columns));
}

Matrix random_matrix(Random& random, int rows, int columns)
{
    Matrix a(cells(rows, columns), 0.0);
    for (int i = 0; i < rows; ++i) {
        for (int j = 0; j < columns; ++j) {
            a[static_cast<std::size_t>(i * padded(columns) + j)] = random.range(-1, 1);
        }
    }
    return a;
}

// B B' + n/4: symmetric, with eigenvalues well away from zero.
Matrix random_definite(Random& random, int n)
{
    const Matrix b = random_matrix(random, n, n);
    Matrix a(cells(n, n), 0.0);
    const int skip = padded(n);
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
            double sum = i == j ? 0.25 * n : 0.0;
            for (int k = 0; k < n; ++k) {
                sum += b[static_cast<std::size_t>(i * skip + k)] * b[static_cast<std::size_t>(j * skip + k)];
            }
            a[static_cast<std::size_t>(i * skip + j)] = sum;
        }
    }
    return a;
}

void put_lower(Output& out, const std::string& key, const Matrix& a, int n, int skip, bool diagonal)
{
    Matrix values;
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < i + (diagonal ? 1 : 0); ++j) {
            values.push_back(a[static_cast<std::size_t>(i * skip + j)]);
        }
    }
    out.put(key, values.data(), static_cast<int>(values.size()));
}

PARITY_CASE(math_products)
{
    for (int i = 0; i < 40; ++i) {
        out.open_block("t" + std::to_string(i));
        const int p = 1 + rng.below(9), q = 1 + rng.below(9), r = 1 + rng.below(9);
        Matrix a(cells(p, r), 0.0);
        const int count = static_cast<int>(a.size());
        dMultiply0(a.data(), random_matrix(rng, p, q).data(), random_matrix(rng, q, r).data(), p, q, r);
        out.put("multiply0", a.data(), count);
        dMultiply1(a.data(), random_matrix(rng, q, p).data(), random_matrix(rng, q, r).data(), p, q, r);
        out.put("multiply1", a.data(), count);
        dMultiply2(a.data(), random_matrix(rng, p, q).data(), random_matrix(rng, r, q).data(), p, q, r);
        out.put("multiply2", a.data(), count);
        const Matrix x = random_matrix(rng, 1, 17), y = random_matrix(rng, 1, 17);
        out.put("dot", {dDot(x.data(), y.data(), i % 18)});
    }
}

PARITY_CASE(math_cholesky)
{
    for (int n = 1; n <= 20; ++n) {
        out.open_block("n" + std::to_string(n));
        const Matrix a = random_definite(rng, n);
        Matrix l = a, inverse(cells(n, n), 0.0), b = random_matrix(rng, n, 1);
        out.put("ok", {static_cast<double>(dFactorCholesky(l.data(), n))});
        put_lower(out, "factor", l, n, padded(n), true);
        dSolveCholesky(l.data(), b.data(), n);
        out.put("solution", b.data(), n);
        out.put("inverse-ok", {static_cast<double>(dInvertPDMatrix(a.data(), inverse.data(), n))});
        put_lower(out, "inverse", inverse, n, padded(n), true);
        Matrix indefinite = a;
        indefinite[static_cast<std::size_t>((n - 1) * padded(n) + n - 1)] = -1;
        out.put("definite", {static_cast<double>(dIsPositiveDefinite(a.data(), n)),
                             static_cast<double>(dIsPositiveDefinite(indefinite.data(), n))});
    }
}

PARITY_CASE(math_ldlt)
{
    for (int n = 1; n <= 20; ++n) {
        out.open_block("n" + std::to_string(n));
        const int skip = padded(n);
        Matrix l = random_definite(rng, n), d(static_cast<std::size_t>(skip), 0.0),
               b = random_matrix(rng, n, 1);
        dFactorLDLT(l.data(), d.data(), n, skip);
        put_lower(out, "factor", l, n, skip, false);
        out.put("diagonal", d.data(), n);
        Matrix x = b;
        dSolveL1(l.data(), x.data(), n, skip);
        out.put("l1", x.data(), n);
        x = b;
        dSolveL1T(l.data(), x.data(), n, skip);
        out.put("l1t", x.data(), n);
        x = b;
        dSolveLDLT(l.data(), d.data(), x.data(), n, skip);
        out.put("solution", x.data(), n);
        dScaleVector(x.data(), d.data(), n);
        out.put("scaled", x.data(), n);
    }
}

// Row and column r of a permuted factorisation removed; the factor that remains is compared where defined.
PARITY_CASE(math_ldlt_remove)
{
    for (int n = 2; n <= 16; ++n) {
        out.open_block("n" + std::to_string(n));
        const int rows = n + 2, skip = padded(rows), r = rng.below(n);
        Matrix a = random_definite(rng, rows);
        std::vector<dReal*> row_pointers;
        std::vector<int> p;
        for (int i = 0; i < rows; ++i) { row_pointers.push_back(a.data() + i * padded(rows)); }
        for (int i = 0; i < n; ++i) { p.push_back((i + 1) % rows); }
        Matrix l(cells(rows, rows), 0.0), d(static_cast<std::size_t>(skip), 0.0);
        for (int i = 0; i < n; ++i) {
            for (int j = 0; j <= i; ++j) {
                const std::size_t pi = static_cast<std::size_t>(p[static_cast<std::size_t>(i)]);
                const std::size_t pj = static_cast<std::size_t>(p[static_cast<std::size_t>(j)]);
                l[static_cast<std::size_t>(i * skip + j)] = row_pointers[pi][pj];
            }
        }
        dFactorLDLT(l.data(), d.data(), n, skip);
        dLDLTRemove(row_pointers.data(), p.data(), l.data(), d.data(), rows, n, r, skip);
        put_lower(out, "factor", l, n - 1, skip, false);
        out.put("diagonal", d.data(), n - 1);
    }
}

PARITY_CASE(math_ldlt_add)
{
    for (int n = 2; n <= 12; ++n) {
        out.open_block("n" + std::to_string(n));
        const int skip = padded(n);
        Matrix l = random_definite(rng, n), d(static_cast<std::size_t>(skip), 0.0);
        const Matrix a = random_matrix(rng, 1, n);
        Matrix change = a;
        for (dReal& value : change) { value *= 0.1; }
        dFactorLDLT(l.data(), d.data(), n, skip);
        dLDLTAddTL(l.data(), d.data(), change.data(), n, skip);
        Matrix inner;  // row and column 0 are left stale by definition
        for (int i = 1; i < n; ++i) {
            for (int j = 1; j < i; ++j) { inner.push_back(l[static_cast<std::size_t>(i * skip + j)]); }
            inner.push_back(d[static_cast<std::size_t>(i)]);
        }
        out.put("factor", inner.data(), static_cast<int>(inner.size()));
    }
}

PARITY_CASE(math_remove_row)
{
    for (int n = 2; n <= 9; ++n) {
        Matrix a = random_definite(rng, n);
        dRemoveRowCol(a.data(), n, padded(n), rng.below(n));
        put_lower(out, "n" + std::to_string(n), a, n - 1, padded(n), true);
        Matrix full = random_matrix(rng, n, n);
        dClearUpperTriangle(full.data(), n);
        out.put("cleared" + std::to_string(n), full.data(), n * padded(n));
        const Matrix b = random_definite(rng, n), c = random_definite(rng, n);
        out.put("difference" + std::to_string(n), {dMaxDifference(b.data(), c.data(), n, n),
                                                   dMaxDifferenceLowerTriangle(b.data(), c.data(), n)});
    }
}

}  // namespace
}  // namespace parity
