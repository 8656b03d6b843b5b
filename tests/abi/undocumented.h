// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Faults that tools/check_docs.py must find, one of each kind, and a function without one. Not compiled.

/** @chapter faulty Faults

    Arguments:
    - body: a body.

    Refused: everything. */

/** This one is as it should be, with a number n. [0.16] */
ODE_API void dBodyIsInOrder(dBodyID body, int n);

ODE_API int dBodyHasNone(dBodyID body);

/** Says what it does, but not with what. [0.16] */
ODE_API void dBodyForgets(dBodyID body, int forgotten);

/** Takes something. [0.16] */
ODE_API void dBodyAnonymous(dBodyID);

/** Does something. */
ODE_API void dBodyFromNowhere(dBodyID body);

/** The guide has this function: of *mass. [0.16] */
ODE_API void dBodyGetMass(dBodyID body, dMass* mass);

/** A common text. [0.16]
 */
ODE_API void dBodySetNothing(dBodyID body, int n);
ODE_API int dBodyGetNothing(dBodyID body);

/** - dBodySetTwin: Whether the body has a number n.
    - dBodyGetTwin: Whether the body has a number n. [0.16] */
ODE_API void dBodySetTwin(dBodyID body, int n);
ODE_API int dBodyGetTwin(dBodyID body, int n);

/** The first two functions forget forgotten. [0.16] */
ODE_API void dBodyPoints(dBodyID body);

/** Does something. Refused: a joint that is 0. [0.16] */
ODE_API void dBodyRefuses(dBodyID body);

/** @chapter planted A chapter whose functions cannot refuse what it says

    Arguments:
    - body: a body.

    Refused: a body that is 0; a space that is 0; [dBodyNowhere] all else. */

/** Does what it can. [0.16] */
ODE_API void dBodyCan(dBodyID body);
