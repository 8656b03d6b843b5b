/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * Small vector and matrix arithmetic, compiled into the program that uses it. Vectors are 3 reals (4 where
 * said), matrices 3 rows of 4 reals whose padding is neither read nor written.
 * A result may be the same array as an operand unless said otherwise.
 * Suffixes: _331 is (3x3)(3x1), _133 is (1x3)(3x3), _333 is (3x3)(3x3); Multiply0 takes both
 * factors as they are, Multiply1 the first one transposed, Multiply2 the second one transposed.
 * _14, _41, ... are element strides of the operands: 1 reads a row, 4 reads a column. */
#ifndef _ODE_ODEMATH_H_
#define _ODE_ODEMATH_H_

#include <ode/common.h>

/** Element (i,j) of a 3x3 matrix, usable on both sides of an assignment. */
#define dACCESS33(A, i, j) ((A)[(i)*4 + (j)])

/** Non-zero when no element is not-a-number. The matrix forms look at the padding too. */
#define dVALIDVEC3(v) (!(dIsNan((v)[0]) || dIsNan((v)[1]) || dIsNan((v)[2])))
#define dVALIDVEC4(v) (dVALIDVEC3(v) && !dIsNan((v)[3]))
#define dVALIDMAT3(m) (dVALIDVEC4(m) && dVALIDVEC4((m) + 4) && dVALIDVEC4((m) + 8))
#define dVALIDMAT4(m) (dVALIDMAT3(m) && dVALIDVEC4((m) + 12))

/** @chapter vectors Vectors and 3x3 matrices

    Inline functions; matrices have rows of 4 reals. They check nothing: pointers must be good and sizes
    right.

    Arguments:
    - res: where the result is written; a vector (3 reals) or a matrix (12 reals).
    - a, b, c: vectors (3 reals) or matrices (12 reals), by the formula; a matrix is written as a capital
    letter.

    Refused: nothing. */

/** res = (x, y, z) [0.16] */
ODE_PURE_INLINE void dAssignVector3(dVector3 res, dReal x, dReal y, dReal z)
{
    res[dV3E_X] = x;
    res[dV3E_Y] = y;
    res[dV3E_Z] = z;
}

/** - dZeroVector3: Set the 3 reals of the vector res to 0.
    - dZeroMatrix3: Set the 12 reals of the matrix res to 0.
    - dZeroMatrix4: Set the 16 reals of the matrix res to 0. [0.16] */
ODE_PURE_INLINE void dZeroVector3(dVector3 res) { dAssignVector3(res, REAL(0.0), REAL(0.0), REAL(0.0)); }
ODE_PURE_INLINE void dZeroMatrix3(dMatrix3 res)
{
    dZeroVector3(res + dM3E__X_MIN);
    dZeroVector3(res + dM3E__Y_MIN);
    dZeroVector3(res + dM3E__Z_MIN);
}
ODE_PURE_INLINE void dZeroMatrix4(dMatrix4 res)
{
    int i;
    for (i = 0; i < dM4E__MAX; ++i) res[i] = REAL(0.0);
}

/** res = a_scale a + b_scale b + c_scale c [0.16] */
ODE_PURE_INLINE void dAddThreeScaledVectors3(dReal* res, const dReal* a, const dReal* b, const dReal* c,
                                             dReal a_scale, dReal b_scale, dReal c_scale)
{
    int i;
    for (i = 0; i < 3; ++i) res[i] = a_scale * a[i] + b_scale * b[i] + c_scale * c[i];
}

/** res = a_scale a + b_scale b [0.16] */
ODE_PURE_INLINE void dAddScaledVectors3(dReal* res, const dReal* a, const dReal* b, dReal a_scale,
                                        dReal b_scale)
{
    int i;
    for (i = 0; i < 3; ++i) res[i] = a_scale * a[i] + b_scale * b[i];
}

/** res = a + b_scale b [0.16] */
ODE_PURE_INLINE void dAddVectorScaledVector3(dReal* res, const dReal* a, const dReal* b, dReal b_scale)
{
    int i;
    for (i = 0; i < 3; ++i) res[i] = a[i] + b_scale * b[i];
}

/** res = a + b [0.16] */
ODE_PURE_INLINE void dAddVectors3(dReal* res, const dReal* a, const dReal* b)
{
    int i;
    for (i = 0; i < 3; ++i) res[i] = a[i] + b[i];
}

/** res = a - b [0.16] */
ODE_PURE_INLINE void dSubtractVectors3(dReal* res, const dReal* a, const dReal* b)
{
    int i;
    for (i = 0; i < 3; ++i) res[i] = a[i] - b[i];
}

/** res = nScale res [0.16] */
ODE_PURE_INLINE void dScaleVector3(dReal* res, dReal nScale)
{
    int i;
    for (i = 0; i < 3; ++i) res[i] *= nScale;
}

/** Turn a vector round: res = -res [0.16] */
ODE_PURE_INLINE void dNegateVector3(dReal* res)
{
    int i;
    for (i = 0; i < 3; ++i) res[i] = -res[i];
}

/** res = a, 3 reals [0.16] */
ODE_PURE_INLINE void dCopyVector3(dReal* res, const dReal* a)
{
    int i;
    for (i = 0; i < 3; ++i) res[i] = a[i];
}

/** res = nScale a [0.16] */
ODE_PURE_INLINE void dCopyScaledVector3(dReal* res, const dReal* a, dReal nScale)
{
    int i;
    for (i = 0; i < 3; ++i) res[i] = a[i] * nScale;
}

/** res = -a [0.16] */
ODE_PURE_INLINE void dCopyNegatedVector3(dReal* res, const dReal* a)
{
    int i;
    for (i = 0; i < 3; ++i) res[i] = -a[i];
}

/** res = a, 4 reals [0.16] */
ODE_PURE_INLINE void dCopyVector4(dReal* res, const dReal* a)
{
    int i;
    for (i = 0; i < 4; ++i) res[i] = a[i];
}

/** Copy three rows with their padding: 12 reals. [0.16] */
ODE_PURE_INLINE void dCopyMatrix4x4(dReal* res, const dReal* a)
{
    int i;
    for (i = 0; i < 12; ++i) res[i] = a[i];
}

/** Copy three rows without their padding: 9 reals. [0.16] */
ODE_PURE_INLINE void dCopyMatrix4x3(dReal* res, const dReal* a)
{
    dCopyVector3(res, a);
    dCopyVector3(res + 4, a + 4);
    dCopyVector3(res + 8, a + 8);
}

/** res = column n (0 ... 2) of the matrix a. res must not lie in a. [0.16] */
ODE_PURE_INLINE void dGetMatrixColumn3(dReal* res, const dReal* a, unsigned n)
{
    unsigned i;
    for (i = 0; i < 3; ++i) res[i] = a[4 * i + n];
}

/** The inner product a . b, of elements step_a and step_b reals apart. [0.16] */
ODE_PURE_INLINE dReal _dCalcVectorDot3(const dReal* a, const dReal* b, unsigned step_a, unsigned step_b)
{
    return a[0] * b[0] + a[step_a] * b[step_b] + a[2 * step_a] * b[2 * step_b];
}

/** A column of a matrix of 4 reals a row has its elements 4 apart.
    - dCalcVectorDot3: The inner product of the vectors a and b, 3 reals each.
    - dCalcVectorDot3_13: The inner product of 3 reals of a, 1 apart, and 3 reals of b, 3 apart.
    - dCalcVectorDot3_31: The inner product of 3 reals of a, 3 apart, and 3 reals of b, 1 apart.
    - dCalcVectorDot3_33: The inner product of 3 reals of a, 3 apart, and 3 reals of b, 3 apart.
    - dCalcVectorDot3_14: The inner product of 3 reals of a, 1 apart, and 3 reals of b, 4 apart.
    - dCalcVectorDot3_41: The inner product of 3 reals of a, 4 apart, and 3 reals of b, 1 apart.
    - dCalcVectorDot3_44: The inner product of 3 reals of a, 4 apart, and 3 reals of b, 4 apart. [0.16] */
ODE_PURE_INLINE dReal dCalcVectorDot3(const dReal* a, const dReal* b) { return _dCalcVectorDot3(a, b, 1, 1); }
ODE_PURE_INLINE dReal dCalcVectorDot3_13(const dReal* a, const dReal* b)
{
    return _dCalcVectorDot3(a, b, 1, 3);
}
ODE_PURE_INLINE dReal dCalcVectorDot3_31(const dReal* a, const dReal* b)
{
    return _dCalcVectorDot3(a, b, 3, 1);
}
ODE_PURE_INLINE dReal dCalcVectorDot3_33(const dReal* a, const dReal* b)
{
    return _dCalcVectorDot3(a, b, 3, 3);
}
ODE_PURE_INLINE dReal dCalcVectorDot3_14(const dReal* a, const dReal* b)
{
    return _dCalcVectorDot3(a, b, 1, 4);
}
ODE_PURE_INLINE dReal dCalcVectorDot3_41(const dReal* a, const dReal* b)
{
    return _dCalcVectorDot3(a, b, 4, 1);
}
ODE_PURE_INLINE dReal dCalcVectorDot3_44(const dReal* a, const dReal* b)
{
    return _dCalcVectorDot3(a, b, 4, 4);
}

/** The square of the length, |a|^2. [0.16] */
ODE_PURE_INLINE dReal dCalcVectorLengthSquare3(const dReal* a) { return dCalcVectorDot3(a, a); }

/** The length of a vector, |a|. [0.16] */
ODE_PURE_INLINE dReal dCalcVectorLength3(const dReal* a) { return dSqrt(dCalcVectorLengthSquare3(a)); }

/** The distance of two points, |a - b|. [0.16] */
ODE_PURE_INLINE dReal dCalcPointsDistance3(const dReal* a, const dReal* b)
{
    dReal d[3];
    dSubtractVectors3(d, a, b);
    return dCalcVectorLength3(d);
}

/** How far test_p lies under the plane through plane_p with unit normal plane_n (negative: above). [0.16] */
ODE_PURE_INLINE dReal dCalcPointDepth3(const dReal* test_p, const dReal* plane_p, const dReal* plane_n)
{
    dReal d[3];
    dSubtractVectors3(d, plane_p, test_p);
    return dCalcVectorDot3(d, plane_n);
}

/** res = a x b, of elements step_res, step_a and step_b reals apart. [0.16] */
ODE_PURE_INLINE void _dCalcVectorCross3(dReal* res, const dReal* a, const dReal* b, unsigned step_res,
                                        unsigned step_a, unsigned step_b)
{
    const dReal ax = a[0], ay = a[step_a], az = a[2 * step_a];
    const dReal bx = b[0], by = b[step_b], bz = b[2 * step_b];
    res[0] = ay * bz - az * by;
    res[step_res] = az * bx - ax * bz;
    res[2 * step_res] = ax * by - ay * bx;
}

/** A column of a matrix of 4 reals a row has its elements 4 apart.
    - dCalcVectorCross3: res = a x b: the cross product of the vectors a and b, 3 reals each.
    - dCalcVectorCross3_114: res = a x b, of 3 reals each: those of res are 1 apart, of a 1, of b 4.
    - dCalcVectorCross3_141: res = a x b, of 3 reals each: those of res are 1 apart, of a 4, of b 1.
    - dCalcVectorCross3_144: res = a x b, of 3 reals each: those of res are 1 apart, of a 4, of b 4.
    - dCalcVectorCross3_411: res = a x b, of 3 reals each: those of res are 4 apart, of a 1, of b 1.
    - dCalcVectorCross3_414: res = a x b, of 3 reals each: those of res are 4 apart, of a 1, of b 4.
    - dCalcVectorCross3_441: res = a x b, of 3 reals each: those of res are 4 apart, of a 4, of b 1.
    - dCalcVectorCross3_444: res = a x b, of 3 reals each: those of res are 4 apart, of a 4, of b 4. [0.16] */
ODE_PURE_INLINE void dCalcVectorCross3(dReal* res, const dReal* a, const dReal* b)
{
    _dCalcVectorCross3(res, a, b, 1, 1, 1);
}
ODE_PURE_INLINE void dCalcVectorCross3_114(dReal* res, const dReal* a, const dReal* b)
{
    _dCalcVectorCross3(res, a, b, 1, 1, 4);
}
ODE_PURE_INLINE void dCalcVectorCross3_141(dReal* res, const dReal* a, const dReal* b)
{
    _dCalcVectorCross3(res, a, b, 1, 4, 1);
}
ODE_PURE_INLINE void dCalcVectorCross3_144(dReal* res, const dReal* a, const dReal* b)
{
    _dCalcVectorCross3(res, a, b, 1, 4, 4);
}
ODE_PURE_INLINE void dCalcVectorCross3_411(dReal* res, const dReal* a, const dReal* b)
{
    _dCalcVectorCross3(res, a, b, 4, 1, 1);
}
ODE_PURE_INLINE void dCalcVectorCross3_414(dReal* res, const dReal* a, const dReal* b)
{
    _dCalcVectorCross3(res, a, b, 4, 1, 4);
}
ODE_PURE_INLINE void dCalcVectorCross3_441(dReal* res, const dReal* a, const dReal* b)
{
    _dCalcVectorCross3(res, a, b, 4, 4, 1);
}
ODE_PURE_INLINE void dCalcVectorCross3_444(dReal* res, const dReal* a, const dReal* b)
{
    _dCalcVectorCross3(res, a, b, 4, 4, 4);
}

/** res = res + a x b [0.16] */
ODE_PURE_INLINE void dAddVectorCross3(dReal* res, const dReal* a, const dReal* b)
{
    dReal c[3];
    dCalcVectorCross3(c, a, b);
    dAddVectors3(res, res, c);
}

/** res = res - a x b [0.16] */
ODE_PURE_INLINE void dSubtractVectorCross3(dReal* res, const dReal* a, const dReal* b)
{
    dReal c[3];
    dCalcVectorCross3(c, a, b);
    dSubtractVectors3(res, res, c);
}

/** Write the off-diagonal elements of [a], the matrix with [a] v = a x v, into rows of `skip` reals. The
    diagonal is left as it is. [0.16] */
ODE_PURE_INLINE void dSetCrossMatrixPlus(dReal* res, const dReal* a, unsigned skip)
{
    const dReal x = a[0], y = a[1], z = a[2];
    res[1] = -z;
    res[2] = y;
    res[skip] = z;
    res[skip + 2] = -x;
    res[2 * skip] = -y;
    res[2 * skip + 1] = x;
}

/** Write to res the matrix -[a] with -[a] v = v x a, the transpose of that of dSetCrossMatrixPlus: rows of
    `skip` reals, of which the diagonal and the padding are not written. [0.16] */
ODE_PURE_INLINE void dSetCrossMatrixMinus(dReal* res, const dReal* a, unsigned skip)
{
    const dReal x = a[0], y = a[1], z = a[2];
    res[1] = z;
    res[2] = -y;
    res[skip] = -z;
    res[skip + 2] = x;
    res[2 * skip] = y;
    res[2 * skip + 1] = -x;
}

/** res = A b [0.16] */
ODE_PURE_INLINE void dMultiplyHelper0_331(dReal* res, const dReal* a, const dReal* b)
{
    const dReal x = dCalcVectorDot3(a, b);
    const dReal y = dCalcVectorDot3(a + 4, b);
    const dReal z = dCalcVectorDot3(a + 8, b);
    dAssignVector3(res, x, y, z);
}

/** res = A^T b [0.16] */
ODE_PURE_INLINE void dMultiplyHelper1_331(dReal* res, const dReal* a, const dReal* b)
{
    const dReal x = dCalcVectorDot3_41(a, b);
    const dReal y = dCalcVectorDot3_41(a + 1, b);
    const dReal z = dCalcVectorDot3_41(a + 2, b);
    dAssignVector3(res, x, y, z);
}

/** res = a B, a row times a matrix [0.16] */
ODE_PURE_INLINE void dMultiplyHelper0_133(dReal* res, const dReal* a, const dReal* b)
{
    dMultiplyHelper1_331(res, b, a);
}

/** res = A^T b with b a column (stride 4) of a matrix [0.16] */
ODE_PURE_INLINE void dMultiplyHelper1_133(dReal* res, const dReal* a, const dReal* b)
{
    const dReal x = dCalcVectorDot3_44(a, b);
    const dReal y = dCalcVectorDot3_44(a + 1, b);
    const dReal z = dCalcVectorDot3_44(a + 2, b);
    dAssignVector3(res, x, y, z);
}

/** res must not share storage with a or b.
    - dMultiply0_331: res = a b for a 3 x 3 matrix a and a vector b.
    - dMultiply1_331: res = a^T b for a 3 x 3 matrix a and a vector b.
    - dMultiply0_133: res = a b for a row vector a and a 3 x 3 matrix b. [0.16] */
ODE_PURE_INLINE void dMultiply0_331(dReal* res, const dReal* a, const dReal* b)
{
    dMultiplyHelper0_331(res, a, b);
}
ODE_PURE_INLINE void dMultiply1_331(dReal* res, const dReal* a, const dReal* b)
{
    dMultiplyHelper1_331(res, a, b);
}
ODE_PURE_INLINE void dMultiply0_133(dReal* res, const dReal* a, const dReal* b)
{
    dMultiplyHelper0_133(res, a, b);
}

/** res = A B. res must not be B. [0.16] */
ODE_PURE_INLINE void dMultiply0_333(dReal* res, const dReal* a, const dReal* b)
{
    unsigned i;
    for (i = 0; i < 12; i += 4) dMultiplyHelper0_133(res + i, a + i, b);
}

/** res = A^T B. res must be neither A nor B. [0.16] */
ODE_PURE_INLINE void dMultiply1_333(dReal* res, const dReal* a, const dReal* b)
{
    unsigned i;
    for (i = 0; i < 3; ++i) dMultiplyHelper1_133(res + 4 * i, b, a + i);
}

/** res = A B^T. res must not be B. [0.16] */
ODE_PURE_INLINE void dMultiply2_333(dReal* res, const dReal* a, const dReal* b)
{
    unsigned i;
    for (i = 0; i < 12; i += 4) dMultiplyHelper0_331(res + i, b, a + i);
}

/** res must not share storage with a or b.
    - dMultiplyAdd0_331: res += a b for a 3 x 3 matrix a and a vector b.
    - dMultiplyAdd1_331: res += a^T b for a 3 x 3 matrix a and a vector b.
    - dMultiplyAdd0_133: res += a b for a row vector a and a 3 x 3 matrix b.
    - dMultiplyAdd0_333: res += a b for 3 x 3 matrices.
    - dMultiplyAdd1_333: res += a^T b for 3 x 3 matrices.
    - dMultiplyAdd2_333: res += a b^T for 3 x 3 matrices. [0.16] */
ODE_PURE_INLINE void dMultiplyAdd0_331(dReal* res, const dReal* a, const dReal* b)
{
    dReal t[3];
    dMultiplyHelper0_331(t, a, b);
    dAddVectors3(res, res, t);
}
ODE_PURE_INLINE void dMultiplyAdd1_331(dReal* res, const dReal* a, const dReal* b)
{
    dReal t[3];
    dMultiplyHelper1_331(t, a, b);
    dAddVectors3(res, res, t);
}
ODE_PURE_INLINE void dMultiplyAdd0_133(dReal* res, const dReal* a, const dReal* b)
{
    dReal t[3];
    dMultiplyHelper0_133(t, a, b);
    dAddVectors3(res, res, t);
}
ODE_PURE_INLINE void dMultiplyAdd0_333(dReal* res, const dReal* a, const dReal* b)
{
    unsigned i;
    for (i = 0; i < 12; i += 4) dMultiplyAdd0_133(res + i, a + i, b);
}
ODE_PURE_INLINE void dMultiplyAdd1_333(dReal* res, const dReal* a, const dReal* b)
{
    unsigned i;
    for (i = 0; i < 3; ++i) {
        dReal t[3];
        dMultiplyHelper1_133(t, b, a + i);
        dAddVectors3(res + 4 * i, res + 4 * i, t);
    }
}
ODE_PURE_INLINE void dMultiplyAdd2_333(dReal* res, const dReal* a, const dReal* b)
{
    unsigned i;
    for (i = 0; i < 12; i += 4) dMultiplyAdd0_331(res + i, b, a + i);
}

/** Determinant of the 3x3 matrix mat: r0 . (r1 x r2). [0.16] */
ODE_PURE_INLINE dReal dCalcMatrix3Det(const dReal* mat)
{
    dReal c[3];
    dCalcVectorCross3(c, mat + 4, mat + 8);
    return dCalcVectorDot3(mat, c);
}

/** dst = ma^-1 by cofactors. Returns the determinant; when that is 0, dst is left as it is. dst must
    not be ma. [0.16] */
ODE_PURE_INLINE dReal dInvertMatrix3(dReal* dst, const dReal* ma)
{
    const dReal det = dCalcMatrix3Det(ma);
    if (det != 0) {
        /* column i of the inverse is the cross product of the other two rows, over the determinant */
        unsigned i;
        _dCalcVectorCross3(dst, ma + 4, ma + 8, 4, 1, 1);
        _dCalcVectorCross3(dst + 1, ma + 8, ma, 4, 1, 1);
        _dCalcVectorCross3(dst + 2, ma, ma + 4, 4, 1, 1);
        for (i = 0; i < 12; i += 4) dScaleVector3(dst + i, dRecip(det));
    }
    return det;
}

#include <ode/odemath_legacy.h>

#ifdef __cplusplus
extern "C" {
#endif

/** @chapter normalising Vectors: normalising

    Refused: a null pointer; what each function names. Nothing is written then, and the answer is 0. */

/** It is safe for very large and very small ones. Returns 1, or 0 with nothing changed if it is zero or not
    finite.
    - dSafeNormalize3: Scale the vector a of 3 reals to length 1.
    - dSafeNormalize4: Scale the vector a of 4 reals to length 1. [0.16] */
ODE_API int dSafeNormalize3(dVector3 a);
ODE_API int dSafeNormalize4(dVector4 a);

/** A zero vector is refused and stays as it is.
    - dNormalize3: Scale the vector a of 3 reals, which must not be zero, to length 1.
    - dNormalize4: Scale the vector a of 4 reals, which must not be zero, to length 1. [0.16] */
ODE_API void dNormalize3(dVector3 a);
ODE_API void dNormalize4(dVector4 a);

/** Two unit vectors p and q that make (n, p, q) a right-handed orthonormal frame. n: unit vector; zero is
    refused. [0.16] */
ODE_API void dPlaneSpace(const dVector3 n, dVector3 p, dVector3 q);

/** Make the rows of m orthonormal (Gram and Schmidt, first row leading, third = first x second, so no
    reflection survives). m: 12 reals; padding becomes 0. Returns 1, or 0 when a row degenerates. [0.16] */
ODE_API int dOrthogonalizeR(dMatrix3 m);

#ifdef __cplusplus
}
#endif

#endif
