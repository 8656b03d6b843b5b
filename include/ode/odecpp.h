/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * The C++ classes of worlds, bodies and joints. They come with ode.h in C++; those of geoms and spaces are in
 * odecpp_collision.h. The classes themselves are templates (odecpp_dynamics.h, odecpp_joints.h) over the
 * class that holds an object's number; here they get their names.
 *
 * A program that wants another holder, for example to count references, defines all four of
 *   dODECPP_WORLD_TEMPLATE_BASE, dODECPP_BODY_TEMPLATE_BASE,
 *   dODECPP_JOINTGROUP_TEMPLATE_BASE, dODECPP_JOINT_TEMPLATE_BASE
 * before it includes this file. A holder has a protected member _id that starts as 0, a protected function
 * destroy(), and destroys its object with itself. d...SimpleIDContainer are such classes without a virtual
 * destructor, so without the cost of one pointer per body. */
#ifndef _ODE_ODECPP_H_
#define _ODE_ODECPP_H_

#ifdef __cplusplus

#include <ode/odecpp_joints.h>

#if !defined(dODECPP_WORLD_TEMPLATE_BASE) && !defined(dODECPP_BODY_TEMPLATE_BASE) && \
    !defined(dODECPP_JOINTGROUP_TEMPLATE_BASE) && !defined(dODECPP_JOINT_TEMPLATE_BASE)
/** The class that holds an object's number. */
#define dODECPP_WORLD_TEMPLATE_BASE dWorldDynamicIDContainer
#define dODECPP_BODY_TEMPLATE_BASE dBodyDynamicIDContainer
#define dODECPP_JOINTGROUP_TEMPLATE_BASE dJointGroupDynamicIDContainer
#define dODECPP_JOINT_TEMPLATE_BASE dJointDynamicIDContainer
#elif !defined(dODECPP_WORLD_TEMPLATE_BASE) || !defined(dODECPP_BODY_TEMPLATE_BASE) || \
    !defined(dODECPP_JOINTGROUP_TEMPLATE_BASE) || !defined(dODECPP_JOINT_TEMPLATE_BASE)
#error Define all four of the dODECPP_..._TEMPLATE_BASE macros, or none.
#endif

typedef dWorldTemplate<dODECPP_WORLD_TEMPLATE_BASE> dWorld;                           /**< a world */
typedef dBodyTemplate<dODECPP_BODY_TEMPLATE_BASE, dODECPP_WORLD_TEMPLATE_BASE> dBody; /**< a rigid body */
typedef dJointGroupTemplate<dODECPP_JOINTGROUP_TEMPLATE_BASE> dJointGroup; /**< a group of joints */

/** A joint of any type, and the joints type by type. */
typedef dJointTemplate<dODECPP_JOINT_TEMPLATE_BASE, dODECPP_WORLD_TEMPLATE_BASE, dODECPP_BODY_TEMPLATE_BASE>
    dJoint;
typedef dBallJointTemplate<dODECPP_JOINT_TEMPLATE_BASE, dODECPP_WORLD_TEMPLATE_BASE,
                           dODECPP_BODY_TEMPLATE_BASE>
    dBallJoint;
typedef dHingeJointTemplate<dODECPP_JOINT_TEMPLATE_BASE, dODECPP_WORLD_TEMPLATE_BASE,
                            dODECPP_BODY_TEMPLATE_BASE>
    dHingeJoint;
typedef dSliderJointTemplate<dODECPP_JOINT_TEMPLATE_BASE, dODECPP_WORLD_TEMPLATE_BASE,
                             dODECPP_BODY_TEMPLATE_BASE>
    dSliderJoint;
typedef dUniversalJointTemplate<dODECPP_JOINT_TEMPLATE_BASE, dODECPP_WORLD_TEMPLATE_BASE,
                                dODECPP_BODY_TEMPLATE_BASE>
    dUniversalJoint;
typedef dHinge2JointTemplate<dODECPP_JOINT_TEMPLATE_BASE, dODECPP_WORLD_TEMPLATE_BASE,
                             dODECPP_BODY_TEMPLATE_BASE>
    dHinge2Joint;
typedef dPRJointTemplate<dODECPP_JOINT_TEMPLATE_BASE, dODECPP_WORLD_TEMPLATE_BASE, dODECPP_BODY_TEMPLATE_BASE>
    dPRJoint;
typedef dPUJointTemplate<dODECPP_JOINT_TEMPLATE_BASE, dODECPP_WORLD_TEMPLATE_BASE, dODECPP_BODY_TEMPLATE_BASE>
    dPUJoint;
typedef dPistonJointTemplate<dODECPP_JOINT_TEMPLATE_BASE, dODECPP_WORLD_TEMPLATE_BASE,
                             dODECPP_BODY_TEMPLATE_BASE>
    dPistonJoint;
typedef dFixedJointTemplate<dODECPP_JOINT_TEMPLATE_BASE, dODECPP_WORLD_TEMPLATE_BASE,
                            dODECPP_BODY_TEMPLATE_BASE>
    dFixedJoint;
typedef dContactJointTemplate<dODECPP_JOINT_TEMPLATE_BASE, dODECPP_WORLD_TEMPLATE_BASE,
                              dODECPP_BODY_TEMPLATE_BASE>
    dContactJoint;
typedef dNullJointTemplate<dODECPP_JOINT_TEMPLATE_BASE, dODECPP_WORLD_TEMPLATE_BASE,
                           dODECPP_BODY_TEMPLATE_BASE>
    dNullJoint;
typedef dAMotorJointTemplate<dODECPP_JOINT_TEMPLATE_BASE, dODECPP_WORLD_TEMPLATE_BASE,
                             dODECPP_BODY_TEMPLATE_BASE>
    dAMotorJoint;
typedef dLMotorJointTemplate<dODECPP_JOINT_TEMPLATE_BASE, dODECPP_WORLD_TEMPLATE_BASE,
                             dODECPP_BODY_TEMPLATE_BASE>
    dLMotorJoint;

#endif
#endif
