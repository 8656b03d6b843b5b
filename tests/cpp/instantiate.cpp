// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Only compiled (compile.sh: two compilers, three language versions, both precisions): every member of every
// template, over both holders of the headers, and the promises that a compiler can check.
#ifdef TEST_SIMPLE_HOLDERS
#define dODECPP_WORLD_TEMPLATE_BASE dWorldSimpleIDContainer
#define dODECPP_BODY_TEMPLATE_BASE dBodySimpleIDContainer
#define dODECPP_JOINTGROUP_TEMPLATE_BASE dJointGroupSimpleIDContainer
#define dODECPP_JOINT_TEMPLATE_BASE dJointSimpleIDContainer
#endif
#include <ode/odecpp_ext.h>

#define INSTANTIATE(World, Body, Group, Joint)                  \
    template class dWorldTemplate<World>;                       \
    template class dBodyTemplate<Body, World>;                  \
    template class dJointGroupTemplate<Group>;                  \
    template class dJointTemplate<Joint, World, Body>;          \
    template class dBallJointTemplate<Joint, World, Body>;      \
    template class dHingeJointTemplate<Joint, World, Body>;     \
    template class dSliderJointTemplate<Joint, World, Body>;    \
    template class dUniversalJointTemplate<Joint, World, Body>; \
    template class dHinge2JointTemplate<Joint, World, Body>;    \
    template class dPRJointTemplate<Joint, World, Body>;        \
    template class dPUJointTemplate<Joint, World, Body>;        \
    template class dPistonJointTemplate<Joint, World, Body>;    \
    template class dFixedJointTemplate<Joint, World, Body>;     \
    template class dContactJointTemplate<Joint, World, Body>;   \
    template class dNullJointTemplate<Joint, World, Body>;      \
    template class dAMotorJointTemplate<Joint, World, Body>;    \
    template class dLMotorJointTemplate<Joint, World, Body>;

INSTANTIATE(dODECPP_WORLD_TEMPLATE_BASE, dODECPP_BODY_TEMPLATE_BASE, dODECPP_JOINTGROUP_TEMPLATE_BASE,
            dODECPP_JOINT_TEMPLATE_BASE)

template class dJointExt<dHingeJoint>;
template class dJointExt<dAMotorJoint>;
template class dGeomExt<dSphere>;
template class dGeomExt<dPlane>;
template class dGeomExt<dConvexHull>;
template class dSpaceExt<dSimpleSpace>;
template class dSpaceExt<dHashSpace>;

/* A negative size of an array is an error in every version of the language. */
#define PROMISE(name, condition) typedef char name[(condition) ? 1 : -1]

#ifdef TEST_SIMPLE_HOLDERS
PROMISE(world_is_its_number, sizeof(dWorld) == sizeof(dWorldID));
PROMISE(body_is_its_number, sizeof(dBody) == sizeof(dBodyID));
PROMISE(group_is_its_number, sizeof(dJointGroup) == sizeof(dJointGroupID));
#else
PROMISE(world_is_number_and_table, sizeof(dWorld) == 2 * sizeof(void*));
PROMISE(body_is_number_and_table, sizeof(dBody) == 2 * sizeof(void*));
PROMISE(group_is_number_and_table, sizeof(dJointGroup) == 2 * sizeof(void*));
#endif
PROMISE(joint_is_number_and_table, sizeof(dHingeJoint) == 2 * sizeof(void*));
PROMISE(contact_is_number_and_table, sizeof(dContactJoint) == sizeof(dJoint));
PROMISE(geom_is_its_number, sizeof(dBox) == sizeof(dGeomID));
PROMISE(extended_world_is_a_world, sizeof(dWorldExt) == sizeof(dWorld));
PROMISE(extended_geom_is_its_number, sizeof(dGeomExt<dSphere>) == sizeof(dGeomID));
PROMISE(extended_space_is_its_number, sizeof(dSpaceExt<dHashSpace>) == sizeof(dSpaceID));
PROMISE(extended_joint_is_a_joint, sizeof(dJointExt<dHingeJoint>) == sizeof(dHingeJoint));
PROMISE(drive_is_the_structure, sizeof(dDriveExt) == sizeof(dDrive));
PROMISE(material_is_the_structure, sizeof(dMaterialExt) == sizeof(dMaterial));
PROMISE(space_is_its_number, sizeof(dHashSpace) == sizeof(dSpaceID));

#if __cplusplus >= 201103L
#include <type_traits>
#define NOT_COPYABLE(T)                                                        \
    static_assert(!std::is_copy_constructible<T>::value, #T " can be copied"); \
    static_assert(!std::is_copy_assignable<T>::value, #T " can be assigned");
NOT_COPYABLE(dWorld)
NOT_COPYABLE(dBody)
NOT_COPYABLE(dJointGroup)
NOT_COPYABLE(dHingeJoint)
NOT_COPYABLE(dContactJoint)
NOT_COPYABLE(dSphere)
NOT_COPYABLE(dHashSpace)
static_assert(std::is_convertible<dWorld&, dWorldID>::value, "a world is not its number");
static_assert(std::is_convertible<dBody&, dBodyID>::value, "a body is not its number");
static_assert(std::is_convertible<dJointGroup&, dJointGroupID>::value, "a group is not its number");
static_assert(std::is_convertible<dHingeJoint&, dJointID>::value, "a joint is not its number");
static_assert(std::is_convertible<dSphere&, dGeomID>::value, "a geom is not its number");
static_assert(std::is_convertible<dHashSpace&, dSpaceID>::value, "a space is not its number");
static_assert(std::is_convertible<dHashSpace&, dGeomID>::value, "a space is not a geom");
static_assert(std::is_base_of<dJoint, dAMotorJoint>::value, "a motor is not a joint");
static_assert(std::is_base_of<dGeom, dHashSpace>::value, "a space is not a geom");
static_assert(!std::is_default_constructible<dJoint>::value, "a joint without a type can be made");
static_assert(!std::is_default_constructible<dGeom>::value, "a geom without a class can be made");
#ifndef TEST_SIMPLE_HOLDERS
static_assert(std::has_virtual_destructor<dBody>::value, "a body has no virtual destructor");
static_assert(std::has_virtual_destructor<dHingeJoint>::value, "a joint has no virtual destructor");
#endif
#endif
