// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Functions that break one rule each, in front of the library's own: shown to the hostile calls, every one of
// them must be found out (the test hostile_finds_planted_faults). The program's definition of a name comes
// before that of a shared library, and RTLD_NEXT is the library's.
#include <dlfcn.h>
#include <cstdarg>
#include <limits>

#include <ode/ode.h>

namespace {

#define LIBRARY(function) reinterpret_cast<decltype(&function)>(dlsym(RTLD_NEXT, #function))

void complain(int number, const char* text, ...)
{
    va_list arguments;
    va_start(arguments, text);
    if (dMessageFunction* const handler = dGetDebugHandler()) handler(number, text, arguments);
    va_end(arguments);
}

}  // namespace

extern "C" {

// Refuses with the number of another kind of message.
void dBodyDisable(dBodyID body)
{
    if (!body) return complain(d_ERR_UNKNOWN, "in dBodyDisable()");
    LIBRARY(dBodyDisable)(body);
}

// Answers something when it refuses.
void* dBodyGetData(dBodyID body)
{
    static char something;
    void* const data = LIBRARY(dBodyGetData)(body);
    return data ? data : &something;
}

// Says everything twice.
dReal dBodyGetLinearDamping(dBodyID body)
{
    LIBRARY(dBodyGetLinearDamping)(body);
    return LIBRARY(dBodyGetLinearDamping)(body);
}

// Accepts nothing.
void dBodySetDamping(dBodyID, dReal linear, dReal angular)
{
    LIBRARY(dBodySetDamping)(nullptr, linear, angular);
}

// Accepts null.
void dBodySetData(dBodyID body, void* data)
{
    if (body) LIBRARY(dBodySetData)(body, data);
}

// Keeps memory when it refuses; in a chain, so that finding it is not left to a sanitizer.
void dBodySetForce(dBodyID body, dReal x, dReal y, dReal z)
{
    static void* kept = nullptr;
    if (!body) {
        auto* const block = static_cast<void**>(dAlloc(sizeof(void*)));
        *block = kept;
        kept = block;
    }
    LIBRARY(dBodySetForce)(body, x, y, z);
}

// Leaves NaN: in a force, which no step takes for its own doing when this is called within it.
void dBodySetGravityMode(dBodyID body, int mode)
{
    LIBRARY(dBodySetGravityMode)(body, mode);
    if (dReal* const force = const_cast<dReal*>(dBodyGetForce(body)))
        force[0] = std::numeric_limits<dReal>::quiet_NaN();
}

// Changes a body although it refuses.
void dBodySetLinearVel(dBodyID body, dReal x, dReal y, dReal z)
{
    LIBRARY(dBodySetLinearVel)(body, x, y, z);
    if (x != x) LIBRARY(dBodySetLinearVel)(body, 1, 2, 3);
}

// Speaks in another function's name.
void dBodySetTorque(dBodyID body, dReal x, dReal y, dReal z) { LIBRARY(dBodySetForce)(body, x, y, z); }

// Writes its result although it refuses.
void dBodyVectorToWorld(dBodyID body, dReal x, dReal y, dReal z, dVector3 result)
{
    if (result) result[0] = 7;
    LIBRARY(dBodyVectorToWorld)(body, x, y, z, result);
}

}  // extern "C"
