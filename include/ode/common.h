/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * Types shared by the whole interface: the real number, vectors and matrices, object handles,
 * joint types and joint parameter numbers, joint feedback, and the scalar functions by precision.
 *
 * Conventions of every header: SI units (m, kg, s, N, N m, rad) if the program keeps to them; right-handed
 * frames; a vector argument is 3 reals with one real of padding; a matrix is stored by rows, each row padded
 * to 4 reals; a rotation maps body coordinates to world coordinates, p_world = x + R p_body; a
 * quaternion is (w, x, y, z). "int used as a flag": 0 is no, everything else yes.
 * Handles are opaque pointers; 0 is "none". Results of the form `const dReal *` point into the
 * object: read only, valid until the object is changed or destroyed. */
#ifndef _ODE_COMMON_H_
#define _ODE_COMMON_H_

#include <ode/error.h>
#include <ode/odeconfig.h>

#ifdef __cplusplus
extern "C" {
#endif

#ifndef M_PI
/** pi: <math.h> leaves it out in strict standard modes. */
#define M_PI REAL(3.1415926535897932384626433832795029)
#endif
#ifndef M_PI_2
/** pi / 2: <math.h> leaves it out in strict standard modes. */
#define M_PI_2 REAL(1.5707963267948966192313216916398)
#endif
#ifndef M_SQRT1_2
/** 1 / sqrt(2): <math.h> leaves it out in strict standard modes. */
#define M_SQRT1_2 REAL(0.7071067811865475244008443621048490)
#endif

/** The real number of the interface. */
#if defined(dSINGLE) && defined(dDOUBLE)
#error Both dSINGLE and dDOUBLE are defined: exactly one precision can be in force.
#elif defined(dSINGLE)
typedef float dReal;
#elif defined(dDOUBLE)
typedef double dReal;
#else
#error Neither dSINGLE nor dDOUBLE is defined: include ode/precision.h.
#endif

/** Index of a triangle mesh's vertex. */
#if defined(dTRIMESH_16BIT_INDICES) && dTRIMESH_16BIT_INDICES
typedef duint16 dTriIndex;
#else
typedef duint32 dTriIndex;
#endif

/** Row length in reals of a matrix with `a` columns: 0 and 1 stay, else the next multiple of 4. */
#define dPAD(a) (((a) > 1) ? (((a) + 3) & (int)(~3)) : (a))

/* ---- indices into vectors and matrices ---- */

/** Space axes. */
typedef enum { dSA__MIN, dSA_X = dSA__MIN, dSA_Y, dSA_Z, dSA__MAX } dSpaceAxis;

/** The two parts of a rigid motion. */
typedef enum { dMD__MIN, dMD_LINEAR = dMD__MIN, dMD_ANGULAR, dMD__MAX } dMotionDynamics;

/** The six components of a rigid motion, linear ones first. */
typedef enum {
    dDA__MIN,
    dDA__L_MIN = dDA__MIN,
    dDA_LX = dDA__L_MIN,
    dDA_LY,
    dDA_LZ,
    dDA__L_MAX,
    dDA__A_MIN = dDA__L_MAX,
    dDA_AX = dDA__A_MIN,
    dDA_AY,
    dDA_AZ,
    dDA__A_MAX,
    dDA__MAX = dDA__A_MAX
} dDynamicsAxis;

/** Elements of a dVector3: three axes and the padding. */
typedef enum {
    dV3E__MIN,
    dV3E__AXES_MIN = dV3E__MIN,
    dV3E_X = dV3E__AXES_MIN,
    dV3E_Y,
    dV3E_Z,
    dV3E__AXES_MAX,
    dV3E_PAD = dV3E__AXES_MAX,
    dV3E__MAX,
    dV3E__AXES_COUNT = dV3E__AXES_MAX - dV3E__AXES_MIN
} dVec3Element;

/** Elements of a dVector4. */
typedef enum { dV4E__MIN, dV4E_X = dV4E__MIN, dV4E_Y, dV4E_Z, dV4E_O, dV4E__MAX } dVec4Element;

/** Elements of a dMatrix3: three rows of three and the padding; dM3E_XY is row x, column y. */
typedef enum {
    dM3E__MIN,
    dM3E__X_MIN = dM3E__MIN,
    dM3E__X_AXES_MIN = dM3E__X_MIN,
    dM3E_XX = dM3E__X_AXES_MIN,
    dM3E_XY,
    dM3E_XZ,
    dM3E__X_AXES_MAX,
    dM3E_XPAD = dM3E__X_AXES_MAX,
    dM3E__X_MAX,

    dM3E__Y_MIN = dM3E__X_MAX,
    dM3E__Y_AXES_MIN = dM3E__Y_MIN,
    dM3E_YX = dM3E__Y_AXES_MIN,
    dM3E_YY,
    dM3E_YZ,
    dM3E__Y_AXES_MAX,
    dM3E_YPAD = dM3E__Y_AXES_MAX,
    dM3E__Y_MAX,

    dM3E__Z_MIN = dM3E__Y_MAX,
    dM3E__Z_AXES_MIN = dM3E__Z_MIN,
    dM3E_ZX = dM3E__Z_AXES_MIN,
    dM3E_ZY,
    dM3E_ZZ,
    dM3E__Z_AXES_MAX,
    dM3E_ZPAD = dM3E__Z_AXES_MAX,
    dM3E__Z_MAX,

    dM3E__MAX = dM3E__Z_MAX
} dMat3Element;

/** Elements of a dMatrix4, rows x, y, z, o. */
typedef enum {
    dM4E__MIN,
    dM4E__X_MIN = dM4E__MIN,
    dM4E_XX = dM4E__X_MIN,
    dM4E_XY,
    dM4E_XZ,
    dM4E_XO,
    dM4E__X_MAX,

    dM4E__Y_MIN = dM4E__X_MAX,
    dM4E_YX = dM4E__Y_MIN,
    dM4E_YY,
    dM4E_YZ,
    dM4E_YO,
    dM4E__Y_MAX,

    dM4E__Z_MIN = dM4E__Y_MAX,
    dM4E_ZX = dM4E__Z_MIN,
    dM4E_ZY,
    dM4E_ZZ,
    dM4E_ZO,
    dM4E__Z_MAX,

    dM4E__O_MIN = dM4E__Z_MAX,
    dM4E_OX = dM4E__O_MIN,
    dM4E_OY,
    dM4E_OZ,
    dM4E_OO,
    dM4E__O_MAX,

    dM4E__MAX = dM4E__O_MAX
} dMat4Element;

/** Elements of a quaternion: the real part R first, then the vector part I, J, K. */
typedef enum {
    dQUE__MIN,
    dQUE_R = dQUE__MIN,
    dQUE__AXIS_MIN,
    dQUE_I = dQUE__AXIS_MIN,
    dQUE_J,
    dQUE_K,
    dQUE__AXIS_MAX,
    dQUE__MAX = dQUE__AXIS_MAX
} dQuatElement;

/* ---- vectors and matrices ---- */

typedef dReal dVector3[dV3E__MAX];    /**< x, y, z, padding */
typedef dReal dVector4[dV4E__MAX];    /**< x, y, z, o */
typedef dReal dMatrix3[dM3E__MAX];    /**< 3 rows of 4; element (i,j) at 4 i + j */
typedef dReal dMatrix4[dM4E__MAX];    /**< 4 rows of 4 */
typedef dReal dMatrix6[48];           /**< 6 rows of 8 */
typedef dReal dQuaternion[dQUE__MAX]; /**< w, x, y, z */

#if defined(dSINGLE)
/** Scalar functions of the real type: a literal (REAL(0.5)), 1/x, the square root and 1 over it, sine,
    cosine, absolute value, arcs, remainder, rounding down and up, the sign of b on a, the neighbour of x
    towards y. */
#define REAL(x) (x##f)
#define dRecip(x) ((1.0f / (x)))
#define dSqrt(x) (sqrtf(x))
#define dRecipSqrt(x) ((1.0f / sqrtf(x)))
#define dSin(x) (sinf(x))
#define dCos(x) (cosf(x))
#define dFabs(x) (fabsf(x))
#define dAtan2(y, x) (atan2f(y, x))
#define dAsin(x) (asinf(x))
#define dAcos(x) (acosf(x))
#define dFMod(a, b) (fmodf(a, b))
#define dFloor(x) floorf(x)
#define dCeil(x) ceilf(x)
#define dCopySign(a, b) _ode_copysignf(a, b)
#define dNextAfter(x, y) _ode_nextafterf(x, y)
#else
/** Scalar functions of the real type: a literal (REAL(0.5)), 1/x, the square root and 1 over it, sine,
    cosine, absolute value, arcs, remainder, rounding down and up, the sign of b on a, the neighbour of x
    towards y. */
#define REAL(x) (x)
#define dRecip(x) (1.0 / (x))
#define dSqrt(x) sqrt(x)
#define dRecipSqrt(x) (1.0 / sqrt(x))
#define dSin(x) sin(x)
#define dCos(x) cos(x)
#define dFabs(x) fabs(x)
#define dAtan2(y, x) atan2((y), (x))
#define dAsin(x) asin(x)
#define dAcos(x) acos(x)
#define dFMod(a, b) (fmod((a), (b)))
#define dFloor(x) floor(x)
#define dCeil(x) ceil(x)
#define dCopySign(a, b) _ode_copysign(a, b)
#define dNextAfter(x, y) _ode_nextafter(x, y)
#endif

/** Non-zero for not-a-number. Works in plain client programs, in C and C++. */
#if defined(__GNUC__)
#define dIsNan(x) (__builtin_isnan(x))
#else
#define dIsNan(x) ((x) != (x))
#endif

/** @chapter basics Basics: numbers, vectors, handles

    Refused: as each function says. */

/** Nothing is refused.
    - dMin: The smaller of x and y.
    - dMax: The greater of x and y. [0.16] */
ODE_PURE_INLINE dReal dMin(dReal x, dReal y) { return y < x ? y : x; }
ODE_PURE_INLINE dReal dMax(dReal x, dReal y) { return y > x ? y : x; }

/* ---- handles ---- */

struct dxWorld;
struct dxSpace;
struct dxBody;
struct dxGeom;
struct dxJoint;
struct dxJointGroup;

typedef struct dxWorld* dWorldID;           /**< a dynamics world */
typedef struct dxSpace* dSpaceID;           /**< a collision space; also usable as a dGeomID by cast */
typedef struct dxBody* dBodyID;             /**< a rigid body */
typedef struct dxGeom* dGeomID;             /**< a collision shape */
typedef struct dxJoint* dJointID;           /**< a joint, contacts included */
typedef struct dxJointGroup* dJointGroupID; /**< a set of joints that die together */

/* ---- numbers ---- */

/** Error numbers given to message handlers. */
enum {
    d_ERR_UNKNOWN = 0,
    d_ERR_IASSERT, /**< the library's own assumption failed */
    d_ERR_UASSERT, /**< an argument was refused */
    d_ERR_LCP      /**< trouble in a constraint solver */
};

/** What dJointGetType answers. */
typedef enum {
    dJointTypeNone = 0,
    dJointTypeBall,
    dJointTypeHinge,
    dJointTypeSlider,
    dJointTypeContact,
    dJointTypeUniversal,
    dJointTypeHinge2,
    dJointTypeFixed,
    dJointTypeNull,
    dJointTypeAMotor,
    dJointTypeLMotor,
    dJointTypePlane2D,
    dJointTypePR,
    dJointTypePU,
    dJointTypePiston,
    dJointTypeDBall,
    dJointTypeDHinge,
    dJointTypeTransmission,
    dJointTypeCoupling
} dJointType;

/* clang-format off */
/** Joint parameter numbers: one block of names per joint axis, the blocks dParamGroup apart. The two
    macros only write the enumerators. */
#define D_ALL_PARAM_NAMES(start) \
  dParamLoStop = start,          \
  dParamHiStop,                  \
  dParamVel,                     \
  dParamLoVel,                   \
  dParamHiVel,                   \
  dParamFMax,                    \
  dParamFudgeFactor,             \
  dParamBounce,                  \
  dParamCFM,                     \
  dParamStopERP,                 \
  dParamStopCFM,                 \
  dParamSuspensionERP,           \
  dParamSuspensionCFM,           \
  dParamERP,

/** The same for the block of axis x. */
#define D_ALL_PARAM_NAMES_X(start, x) \
  dParamGroup##x = start,             \
  dParamLoStop##x = start,            \
  dParamHiStop##x,                    \
  dParamVel##x,                       \
  dParamLoVel##x,                     \
  dParamHiVel##x,                     \
  dParamFMax##x,                      \
  dParamFudgeFactor##x,               \
  dParamBounce##x,                    \
  dParamCFM##x,                       \
  dParamStopERP##x,                   \
  dParamStopCFM##x,                   \
  dParamSuspensionERP##x,             \
  dParamSuspensionCFM##x,             \
  dParamERP##x,

/** Joint parameters; names ending in 2 and 3 belong to the joint's second and third axis.
    LoStop, HiStop: range of the angle (rad) or position (m), defaults -/+ infinity; tested only when
      LoStop <= HiStop. Angles with stops count turns (ode/drives.h); with dBehaviour016 a stop works
      within (-pi, pi].
    Vel: wanted rate of a motor (rad/s, m/s), default 0.  FMax: the most force or torque the motor may
      use (N, N m), default 0 = no motor; negative values are ignored.
    LoVel, HiVel: numbers only; no joint uses them.
    FudgeFactor: in [0,1], default 1; scales the force of a motor that pushes away from a stop.
    Bounce: restitution at a stop, default 0.
    CFM: softness of the powered axis off its stops. StopERP, StopCFM: correction rate and softness at
      a stop. SuspensionERP, SuspensionCFM: of the hinge-2 suspension. ERP (with CFM): of ball,
      fixed, double ball, double hinge and transmission joints. All of these start as the world's ERP and
      CFM at the joint's creation. */
enum {
  D_ALL_PARAM_NAMES(0)
  dParamsInGroup, /**< how many there are in a block */
  D_ALL_PARAM_NAMES_X(0x000, 1)
  D_ALL_PARAM_NAMES_X(0x100, 2)
  D_ALL_PARAM_NAMES_X(0x200, 3)
  dParamGroup = 0x100 /**< distance of the blocks */
};
/* clang-format on */

/** Modes of the angular motor. */
enum {
    dAMotorUser = 0, /**< the program sets axes and angles */
    dAMotorEuler = 1 /**< axes and angles follow from the bodies' orientations */
};

/** Modes of the transmission joint. */
enum { dTransmissionParallelAxes = 0, dTransmissionIntersectingAxes = 1, dTransmissionChainDrive = 2 };

/** What a joint did in the last step: force (N) and torque about the body's centre (N m), world
    frame, on the first (f1, t1) and second (f2, t2) body. See dJointSetFeedback. */
typedef struct dJointFeedback {
    dVector3 f1; /**< force on body 1 */
    dVector3 t1; /**< torque on body 1 */
    dVector3 f2; /**< force on body 2 */
    dVector3 t2; /**< torque on body 2 */
} dJointFeedback;

/** Say that the pose of geom changed behind the library's back: its bounding box will be computed
    anew. Functions that move geoms or bodies, and steps, do this themselves. Refused: what is no
    geom. [0.16] */
ODE_API void dGeomMoved(dGeomID geom);

/** The next geom of the same body after geom, or 0: same as dBodyGetNextGeom. A geom that is 0 or destroyed
    is refused. [0.16] */
ODE_API dGeomID dGeomGetBodyNext(dGeomID geom);

/** How this library was built: words separated by single spaces, for example "ODE" and
    "ODE_double_precision"; those of Debian's libode8. It takes nothing and refuses nothing. [0.16] */
ODE_API const char* dGetConfiguration(void);

/** 1 when `token` is one whole word of dGetConfiguration() (case counts), else 0; an empty text and one with
    a space in it give 1. A null token is refused: 0. [0.16] */
ODE_API int dCheckConfiguration(const char* token);

#ifdef __cplusplus
}
#endif

#endif
