/** @chapter FILE NAME joints: 3 rows

    Holds a point of body 1 to a point of body 2. Parameters: dParamERP, dParamCFM. Refused: as for ball. */

/** Makes a joint of this type in world, in group (0: alone), attached to nothing; 0 if memory is exhausted or
    world or group is destroyed. [ours] */
ODE_API dJointID dJointCreateNAME(dWorldID world, dJointGroupID group);

/** Sets the point that both bodies have in common. Default: the origin of each body. [ours] */
ODE_API void dJointSetNAMEAnchor(dJointID joint, dReal x, dReal y, dReal z);

/** Writes the anchor as body 1 has it now to result, m, world frame. [ours] */
ODE_API void dJointGetNAMEAnchor(dJointID joint, dVector3 result);

/** - dJointSetNAMEParam: Sets a parameter of the joint to value: dParamERP or dParamCFM, at first those of
      the world.
    - dJointGetNAMEParam: Returns a parameter of the joint: dParamERP or dParamCFM. [ours] */
ODE_API void dJointSetNAMEParam(dJointID joint, int parameter, dReal value);
ODE_API dReal dJointGetNAMEParam(dJointID joint, int parameter);

