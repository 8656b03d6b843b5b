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
