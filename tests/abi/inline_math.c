// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The vector and matrix functions that live in the public headers, against plain loops over the
// definitions, on seeded random operands; also with the result in place of an operand where the header
// allows it.
#include <stdio.h>

#include <ode/ode.h>

static const double kTolerance = sizeof(dReal) == 8 ? 1e-13 : 1e-5;
static int g_checks, g_wrong;

static void expect(double got, double wanted, const char* what)
{
    ++g_checks;
    if (fabs(got - wanted) <= kTolerance * (1 + fabs(wanted))) return;
    ++g_wrong;
    fprintf(stderr, "%s: %.17g, wanted %.17g\n", what, got, wanted);
}

static void expect3(const dReal* got, int stride, const double* wanted, const char* what)
{
    for (int i = 0; i < 3; ++i) expect((double)got[i * stride], wanted[i], what);
}

static void randomize(dReal* a, int n) { dMakeRandomVector(a, n, 2); }

static double element(const dReal* A, int i, int j, int transposed)
{
    return (double)(transposed ? A[4 * j + i] : A[4 * i + j]);
}

static void cross(double* c, const dReal* a, int sa, const dReal* b, int sb)
{
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        c[i] = (double)a[j * sa] * (double)b[k * sb] - (double)a[k * sa] * (double)b[j * sb];
    }
}

static void check_sums(void)
{
    dReal a[4], b[4], c[4], r[4];
    randomize(a, 4), randomize(b, 4), randomize(c, 4);
    dAddThreeScaledVectors3(r, a, b, c, 2, 3, 4);
    for (int i = 0; i < 3; ++i) expect(r[i], 2 * a[i] + 3 * b[i] + 4 * c[i], "three scaled");
    dAddScaledVectors3(r, a, b, 2, 3);
    for (int i = 0; i < 3; ++i) expect(r[i], 2 * a[i] + 3 * b[i], "two scaled");
    dAddVectorScaledVector3(r, a, b, 3);
    for (int i = 0; i < 3; ++i) expect(r[i], a[i] + 3 * b[i], "one scaled");
    dSubtractVectors3(r, a, b);
    dNegateVector3(r);
    for (int i = 0; i < 3; ++i) expect(r[i], b[i] - a[i], "negated difference");
    dCopyScaledVector3(r, a, 5);
    dScaleVector3(r, REAL(0.5));
    for (int i = 0; i < 3; ++i) expect(r[i], 2.5 * a[i], "scaled copy");
    dCopyNegatedVector3(r, a);
    dAddVectors3(r, r, a);
    for (int i = 0; i < 3; ++i) expect(r[i], 0, "sum with the negative");
    double square = 0, depth = 0;
    for (int i = 0; i < 3; ++i) square += (a[i] - b[i]) * (a[i] - b[i]), depth += (b[i] - a[i]) * c[i];
    expect(dCalcPointsDistance3(a, b), sqrt(square), "distance");
    expect(dDISTANCE(a, b) * dDISTANCE(a, b), square, "squared distance");
    expect(dCalcPointDepth3(a, b, c), depth, "depth");
}

static void check_products(void)
{
    dReal A[12], B[12], r[12];
    double wanted[3];
    randomize(A, 12), randomize(B, 12);
    expect(dCalcVectorDot3_14(A, B), A[0] * B[0] + A[1] * B[4] + A[2] * B[8], "dot 14");
    expect(dCalcVectorDot3_41(A, B), A[0] * B[0] + A[4] * B[1] + A[8] * B[2], "dot 41");
    expect(dDOT44(A, B), A[0] * B[0] + A[4] * B[4] + A[8] * B[8], "dot 44");
    expect(dDOT13(A, B), A[0] * B[0] + A[1] * B[3] + A[2] * B[6], "dot 13");
    cross(wanted, A, 1, B, 1);
    dCalcVectorCross3(r, A, B);
    expect3(r, 1, wanted, "cross");
    dCROSS(r, -=, A, B);
    expect(dLENGTH(r), 0, "cross by macro");
    dCopyVector3(r, A);
    dCalcVectorCross3(r, r, B);
    expect3(r, 1, wanted, "cross in place");
    cross(wanted, A, 4, B, 1);
    dCalcVectorCross3_441(r, A, B);
    expect3(r, 4, wanted, "cross 441");
    dCROSS441(r, =, A, B);
    expect3(r, 4, wanted, "cross 441 by macro");
    cross(wanted, A, 1, B, 4);
    dCalcVectorCross3_114(r, A, B);
    expect3(r, 1, wanted, "cross 114");
    cross(wanted, A, 1, B, 1);
    dZeroMatrix3(r);
    dSetCrossMatrixPlus(r, A, 4);
    dMultiply0_331(r, r, B);
    expect3(r, 1, wanted, "cross matrix");
    dZeroMatrix3(r);
    dSetCrossMatrixMinus(r, A, 4);
    dMultiply1_331(r, r, B);
    expect3(r, 1, wanted, "transposed cross matrix");
    dZeroMatrix3(r);
    dCROSSMAT(r, A, 4, +, -);
    dMultiply0_331(r, r, B);
    expect3(r, 1, wanted, "cross matrix by macro");
}

typedef void Product(dReal*, const dReal*, const dReal*);

/* r = op(A) op(B) and the form that adds, both 3x3 */
static void check_square(Product* plain, Product* adding, int ta, int tb, const char* what)
{
    dReal A[12], B[12], r[12], s[12];
    randomize(A, 12), randomize(B, 12), randomize(s, 12);
    for (int i = 0; i < 12; ++i) r[i] = 77;
    plain(r, A, B);
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            double sum = 0;
            for (int k = 0; k < 3; ++k) sum += element(A, i, k, ta) * element(B, k, j, tb);
            expect(dACCESS33(r, i, j), sum, what);
        }
        expect(r[4 * i + 3], 77, "padding");
    }
    dReal before[12];
    for (int i = 0; i < 12; ++i) before[i] = s[i];
    adding(s, A, B);
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            expect(dACCESS33(s, i, j), (double)dACCESS33(before, i, j) + (double)dACCESS33(r, i, j), what);
}

static void check_vector_products(void)
{
    dReal A[12], b[4], r[4], s[4] = {1, 2, 3, 0};
    randomize(A, 12), randomize(b, 4);
    for (int transposed = 0; transposed < 2; ++transposed) {
        double wanted[3] = {0, 0, 0}, more[3];
        for (int i = 0; i < 3; ++i)
            for (int k = 0; k < 3; ++k) wanted[i] += element(A, i, k, transposed) * (double)b[k];
        for (int i = 0; i < 3; ++i) more[i] = (double)s[i] + wanted[i];
        (transposed ? dMultiply1_331 : dMultiply0_331)(r, A, b);
        expect3(r, 1, wanted, "matrix times vector");
        (transposed ? dMultiplyAdd1_331 : dMultiplyAdd0_331)(s, A, b);
        expect3(s, 1, more, "added matrix times vector");
        if (transposed) dMultiply0_133(r, b, A), expect3(r, 1, wanted, "row times matrix");
    }
}

static void check_inverse(void)
{
    dReal A[12], inverse[12] = {0}, one[12];  /* a singular A would leave the inverse as it is */
    randomize(A, 12);
    for (int i = 0; i < 3; ++i) dACCESS33(A, i, i) += 5;
    const double det = (double)dInvertMatrix3(inverse, A);
    double expanded = 0;
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        expanded +=
            (double)A[i] * ((double)A[4 + j] * (double)A[8 + k] - (double)A[4 + k] * (double)A[8 + j]);
    }
    expect(det, expanded, "determinant");
    dMultiply0_333(one, A, inverse);
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) expect(dACCESS33(one, i, j), i == j, "matrix times its inverse");
    dZeroMatrix3(A);
    for (int i = 0; i < 12; ++i) inverse[i] = 7;
    expect(dInvertMatrix3(inverse, A), 0, "determinant of zero");
    for (int i = 0; i < 12; ++i) expect(inverse[i], 7, "untouched by a singular matrix");
}

static void check_special_numbers(void)
{
    dReal good[4] = {1, 2, 3, 4}, bad[4] = {1, 2, 3, (dReal)dNaN};
    expect(dVALIDVEC4(good) && dVALIDVEC3(bad), 1, "valid vectors");
    expect(dVALIDVEC4(bad), 0, "vector with not-a-number");
    expect(dIsNan(dInfinity), 0, "infinity is a number");
    expect(dMin(2, 3) + 10 * dMax(2, 3), 32, "least and greatest");
    expect(dRecip(REAL(4.0)) + dRecipSqrt(REAL(4.0)), 0.75, "reciprocals");
}

int main(void)
{
    for (int round = 0; round < 100; ++round) {
        check_sums();
        check_products();
        check_square(dMultiply0_333, dMultiplyAdd0_333, 0, 0, "A B");
        check_square(dMultiply1_333, dMultiplyAdd1_333, 1, 0, "A' B");
        check_square(dMultiply2_333, dMultiplyAdd2_333, 0, 1, "A B'");
        check_vector_products();
        check_inverse();
    }
    check_special_numbers();
    printf("%d checks, %d wrong\n", g_checks, g_wrong);
    return g_wrong != 0;
}
