// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Compiles only if a C++ program sees the layouts, constants and types of layouts.inc in our headers;
// dMass has member functions there and must still be laid out as in C. Built in both precisions.
#include <type_traits>

#include <ode/ode.h>

#ifdef dSINGLE
#define PICK(dbl, sgl) (sgl)
#else
#define PICK(dbl, sgl) (dbl)
#endif

#define SIZE(type, dbl, sgl) static_assert(sizeof(type) == PICK(dbl, sgl));
#define ALIGN(type, dbl, sgl) static_assert(alignof(type) == PICK(dbl, sgl));
#define FIELD(type, member, at_dbl, dbl, at_sgl, sgl)              \
    static_assert(offsetof(type, member) == PICK(at_dbl, at_sgl)); \
    static_assert(sizeof(type::member) == PICK(dbl, sgl));
#define VALUE(constant, value) static_assert((constant) == (value));
#define FUNCTION(type, result, parameters) static_assert(std::is_same_v<type*, result(*) parameters>);
#define ALIAS(type, same) static_assert(std::is_same_v<type, same>);

#include "layouts.inc"

static_assert(std::is_same_v<dReal, std::conditional_t<PICK(8, 4) == 8, double, float>>);
static_assert(std::is_same_v<decltype(dInfinity), dReal>);
static_assert(std::is_same_v<decltype(REAL(0.5)), dReal>);
static_assert(std::is_same_v<dVector3, dReal[4]> && std::is_same_v<dMatrix3, dReal[12]>);
static_assert(std::is_standard_layout_v<dMass> && std::is_trivially_copyable_v<dMass>);
static_assert(sizeof(dODE_VERSION) == sizeof("0.16.2"));

// The wrapper classes hold an id, and all but those of geoms and spaces a table of virtual functions: a
// program may pass them between files that were compiled with other headers of ODE.
template <class... Classes>
constexpr bool all_have_size(unsigned size, bool polymorphic)
{
    return ((sizeof(Classes) == size && std::is_polymorphic_v<Classes> == polymorphic) && ...);
}
static_assert(all_have_size<dBody, dJointGroup, dJoint, dBallJoint, dHingeJoint, dSliderJoint,
                            dUniversalJoint, dHinge2Joint, dPRJoint, dPUJoint, dPistonJoint, dFixedJoint,
                            dContactJoint, dNullJoint, dAMotorJoint, dLMotorJoint, dWorld>(16, true));
static_assert(all_have_size<dGeom, dSpace, dSimpleSpace, dHashSpace, dQuadTreeSpace, dSphere, dBox, dPlane,
                            dCapsule, dCylinder, dRay, dGeomTransform>(8, false));
