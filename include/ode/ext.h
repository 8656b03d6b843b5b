/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * What this library adds to ODE's interface, a header for each chapter. ode/ode.h does not include it: a
 * program that includes this file depends on this library and no longer runs on the original one. One more
 * name that only libode_single has, dSinglePrecisionProgram_LinkWith_ode_single, is in ode/odeconfig.h: it
 * keeps programs for float and libraries for double apart. */
#ifndef _ODE_EXT_H_
#define _ODE_EXT_H_

#include <ode/character.h>
#include <ode/contacts.h>
#include <ode/couplings.h>
#include <ode/defaults.h>
#include <ode/diagnosis.h>
#include <ode/drives.h>
#include <ode/events.h>
#include <ode/fluid.h>
#include <ode/fracture.h>
#include <ode/impulses.h>
#include <ode/queries.h>
#include <ode/ragdoll.h>
#include <ode/report.h>
#include <ode/rope.h>
#include <ode/shapes.h>
#include <ode/state.h>
#include <ode/step_options.h>
#include <ode/steppers.h>
#include <ode/vehicle.h>
#include <ode/world_file.h>

#endif
